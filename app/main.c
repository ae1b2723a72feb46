// app/main.c
// stiffaxis: from a case file to sections, rods, 3D segments and their comparison. The exit code is
// the status.
#include "app/answer.h"
#include "app/command.h"
#include "app/interrupt.h"

#include <malloc.h>

// Freed memory stays with the process: the 3D ways take and give large blocks by turns, and fresh
// pages from the system cost a tenth of their time.
static void keep_freed_memory(void)
{
#ifdef __GLIBC__
    enum { LARGEST_BLOCK = 32 << 20, KEPT = 1 << 30 };
    (void)mallopt(M_MMAP_THRESHOLD, LARGEST_BLOCK);
    (void)mallopt(M_TRIM_THRESHOLD, KEPT);
#endif
}

int main(int argc, char **argv)
{
    keep_freed_memory();
    command cmd = {0};
    interrupt_install();

    status st = command_parse(argc, (const char *const *)argv, &cmd);
    if (st == OK) {
        st = command_run(&cmd);
    }
    return (int)answer_end(&cmd, st);
}
