// tests/unit/app/test_answer.c
// The one line that tells an error.
#include "app/answer.h"

#include "tests/test.h"

#include <string.h>

static void a_message_without_a_place_gets_its_word(void)
{
    char line[64];
    answer_error_line("no rod", line, sizeof line);
    CHECK(strcmp(line, "error: no rod") == 0);
    answer_error_line("a.yaml:3:4: error: no rod", line, sizeof line);
    CHECK(strcmp(line, "a.yaml:3:4: error: no rod") == 0);
}

static void nothing_in_a_message_reaches_the_terminal_as_control(void)
{
    char line[64];
    answer_error_line("key '\033[2Jx\ny\r'", line, sizeof line);
    CHECK(strcmp(line, "error: key ' [2Jx y '") == 0);
}

static void a_long_message_is_cut_not_overrun(void)
{
    char line[16], message[100];
    memset(message, 'a', sizeof message);
    message[sizeof message - 1] = '\0';
    answer_error_line(message, line, sizeof line);
    CHECK(strlen(line) == sizeof line - 1);
}

int main(void)
{
    a_message_without_a_place_gets_its_word();
    nothing_in_a_message_reaches_the_terminal_as_control();
    a_long_message_is_cut_not_overrun();
    return test_failures != 0;
}
