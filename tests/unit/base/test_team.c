// tests/unit/base/test_team.c
#include "base/team.h"
#include "tests/test.h"

#include <errno.h>
#include <signal.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

static const team_options three = {.workers = 3};

static void sleep_ms(int ms)
{
    (void)nanosleep(&(struct timespec){ms / 1000, (ms % 1000) * 1000000L}, NULL);
}

static bool no_child_is_left(void)
{
    return waitpid(-1, NULL, WNOHANG) == -1 && errno == ECHILD;
}

typedef struct square {
    double value;
    pid_t worker;
} square;

static status square_of(void *context, int item, void *result)
{
    square *s = result;
    s->value = *(double *)context * item * item;
    s->worker = getpid();
    sleep_ms(1);
    return OK;
}

static void results_come_in_the_items_order_whatever_the_workers(void)
{
    enum { N = 50 };
    double factor = 3;
    square one[N], many[N];
    int others = 0;
    CHECK_OK(team_map(square_of, &factor, N, sizeof *one, &(team_options){.workers = 1}, one));
    CHECK_OK(team_map(square_of, &factor, N, sizeof *many, &three, many));
    for (int i = 0; i < N; i++) {
        CHECK(one[i].worker == getpid());
        CHECK(many[i].worker != getpid());
        CHECK(one[i].value == 3. * i * i && many[i].value == one[i].value);
        others += many[i].worker != many[0].worker;
    }
    CHECK(others > 0);
    CHECK_OK(team_map(square_of, &factor, N, sizeof *many, NULL, many));
    CHECK_OK(team_map(square_of, &factor, 0, sizeof *many, &three, many));
    CHECK(no_child_is_left());
    CHECK(team_cores() >= 1);
}

// the later one fails first in time
static status fail_twice(void *context, int item, void *result)
{
    (void)context;
    (void)result;
    if (item == 1) {
        sleep_ms(60);
        return status_fail_at(ERR_NUMERIC, 12, 3, "piece %d has no answer", item);
    }
    return item == 2 ? status_fail(ERR_INPUT, "piece %d is wrong", item) : OK;
}

static void the_first_item_that_fails_is_what_fails(void)
{
    for (int workers = 1; workers <= 3; workers++) {
        int line = 0, column = 0;
        char none[100];
        status_clear();
        CHECK(team_map(fail_twice, NULL, 100, 1, &(team_options){.workers = workers}, none) ==
              ERR_NUMERIC);
        CHECK(strcmp(status_message(), "piece 1 has no answer") == 0);
        CHECK(status_place(&line, &column) && line == 12 && column == 3);
        CHECK(no_child_is_left());
    }
    status_clear();
}

static status die(void *context, int item, void *result)
{
    (void)result;
    if (item == 1) {
        (void)signal(*(int *)context, SIG_DFL); // sanitizers catch some
        (void)raise(*(int *)context);
    }
    sleep_ms(item == 0 ? 20000 : 1);
    return OK;
}

static void a_worker_that_dies_is_told_at_once(void)
{
    char none[9];
    const struct {
        int signal;
        status st;
        const char *words;
    } deaths[] = {{SIGSEGV, ERR_BUG, "died at piece 2 of the work, signal 11"},
                  {SIGKILL, ERR_RESOURCE, "killed at piece 2 of the work"},
                  {SIGINT, ERR_INTERRUPTED, "interrupted"}};
    for (size_t i = 0; i < sizeof deaths / sizeof *deaths; i++) {
        int number = deaths[i].signal;
        status_clear();
        const time_t begin = time(NULL);
        CHECK(team_map(die, &number, 9, 1, &three, none) == deaths[i].st);
        CHECK(strstr(status_message(), deaths[i].words));
        CHECK(time(NULL) - begin < 10); // piece 1 would have slept for longer
        CHECK(no_child_is_left());
    }
    status_clear();
}

static status leave(void *context, int item, void *result)
{
    (void)context;
    (void)item;
    (void)result;
    _exit(7);
}

static void a_worker_that_leaves_is_told(void)
{
    char none[2];
    CHECK(team_map(leave, NULL, 2, 1, &three, none) == ERR_BUG);
    CHECK(strstr(status_message(), "exit code 7"));
    CHECK(no_child_is_left());
    status_clear();
}

typedef struct hearing {
    int calls, last, stop_at;
} hearing;

static status hear(void *context, int done, int count)
{
    hearing *h = context;
    CHECK(done >= h->last && done <= count);
    h->last = done;
    h->calls++;
    return h->stop_at > 0 && done >= h->stop_at ? status_fail(ERR_INTERRUPTED, "enough") : OK;
}

static status short_then_long(void *context, int item, void *result)
{
    (void)context;
    (void)result;
    sleep_ms(item < 10 ? 1 : 20000);
    return OK;
}

static void the_first_process_hears_and_may_end_all(void)
{
    double factor = 1;
    square s[20];
    char none[20];
    for (int workers = 1; workers <= 2; workers++) {
        hearing h = {0};
        CHECK_OK(team_map(square_of, &factor, 20, sizeof *s,
                          &(team_options){.workers = workers, .heard = hear, .context = &h}, s));
        CHECK(h.calls > 0 && h.last == 20);
    }
    hearing h = {.stop_at = 5};
    const time_t begin = time(NULL);
    CHECK(team_map(short_then_long, NULL, 20, 1,
                   &(team_options){.workers = 2, .heard = hear, .context = &h},
                   none) == ERR_INTERRUPTED);
    CHECK(time(NULL) - begin < 10);
    CHECK(no_child_is_left());
    status_clear();
}

static status tell_pid(void *context, int item, void *result)
{
    (void)result;
    const pid_t self = getpid();
    const ssize_t n = write(*(int *)context, &self, sizeof self);
    (void)n;
    sleep_ms(item >= 0 ? 20000 : 0);
    return OK;
}

// as Ctrl-C, kill or a crash do: nobody is left to end them
static void workers_go_with_the_first_process(void)
{
    int ends[2];
    char none[2];
    pid_t worker[2] = {0};
    CHECK(pipe(ends) == 0);
    const pid_t first = fork();
    if (first == 0) {
        (void)team_map(tell_pid, &ends[1], 2, 1, &(team_options){.workers = 2}, none);
        _exit(0);
    }
    (void)close(ends[1]);
    for (int i = 0; i < 2; i++) {
        CHECK(read(ends[0], &worker[i], sizeof worker[i]) == sizeof worker[i]);
    }
    CHECK(kill(first, SIGKILL) == 0);
    CHECK(waitpid(first, NULL, 0) == first);
    // the pipe's other end is theirs alone now
    char more;
    CHECK(read(ends[0], &more, 1) == 0);
    (void)close(ends[0]);
}

static status nothing(void *context, int item, void *result)
{
    (void)context;
    (void)item;
    (void)result;
    return OK;
}

static void what_waits_to_be_printed_is_printed_once(void)
{
    int ends[2];
    char none[8], read_back[64];
    CHECK(pipe(ends) == 0);
    FILE *f = fdopen(ends[1], "w");
    CHECK(f && fputs("once", f) >= 0);
    CHECK_OK(team_map(nothing, NULL, 8, 1, &three, none));
    CHECK(f && fclose(f) == 0);
    CHECK(read(ends[0], read_back, sizeof read_back) == 4);
    (void)close(ends[0]);
}

int main(void)
{
    results_come_in_the_items_order_whatever_the_workers();
    the_first_item_that_fails_is_what_fails();
    a_worker_that_dies_is_told_at_once();
    a_worker_that_leaves_is_told();
    the_first_process_hears_and_may_end_all();
    workers_go_with_the_first_process();
    what_waits_to_be_printed_is_printed_once();
    return test_failures != 0;
}
