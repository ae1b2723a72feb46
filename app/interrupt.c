// app/interrupt.c
#include "app/interrupt.h"

#include <signal.h>
#include <stddef.h>
#include <string.h>
#include <unistd.h>

// a handler has nowhere else to look
static volatile sig_atomic_t held, pending;

static void on_signal(int number)
{
    static const char words[] = "error: interrupted\n";
    (void)number;
    pending = 1;
    if (!held) {
        const ssize_t written = write(STDERR_FILENO, words, sizeof words - 1);
        (void)written;
        _exit(ERR_INTERRUPTED);
    }
}

void interrupt_install(void)
{
    const int numbers[] = {SIGINT, SIGTERM, SIGHUP};
    struct sigaction action;
    memset(&action, 0, sizeof action);
    action.sa_handler = on_signal;
    (void)sigemptyset(&action.sa_mask);
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
        struct sigaction before;
        // what the caller ignores (nohup) stays ignored
        if (sigaction(numbers[i], NULL, &before) == 0 && before.sa_handler != SIG_IGN) {
            (void)sigaction(numbers[i], &action, NULL);
        }
    }
    action.sa_handler = SIG_IGN;
    (void)sigaction(SIGPIPE, &action, NULL);
    (void)sigaction(SIGXFSZ, &action, NULL);
}

void interrupt_hold(void)
{
    held = 1;
}

bool interrupt_pending(void)
{
    return pending != 0;
}

status interrupt_release(void)
{
    held = 0;
    return pending ? status_fail(ERR_INTERRUPTED, "interrupted") : OK;
}
