// app/main.c
// stiffaxis: from a case file to sections, rods, 3D segments and their comparison. The exit code is
// the status.
#include "app/answer.h"
#include "app/command.h"
#include "app/interrupt.h"

int main(int argc, char **argv)
{
    command cmd = {0};
    interrupt_install();

    status st = command_parse(argc, (const char *const *)argv, &cmd);
    if (st == OK) {
        st = command_run(&cmd);
    }
    return (int)answer_end(&cmd, st);
}
