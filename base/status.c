// base/status.c
#include "base/status.h"

#include <stdarg.h>
#include <stdio.h>

static _Thread_local char message[1024];
static _Thread_local int place_line, place_column; // 0: the message has no place

static void keep(int line, int column, const char *format, va_list args)
{
    if (message[0] == '\0') {
        (void)vsnprintf(message, sizeof message, format, args);
        place_line = line;
        place_column = column;
    }
}

status status_fail(status code, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    keep(0, 0, format, args);
    va_end(args);
    return code;
}

status status_fail_at(status code, int line, int column, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    keep(line, column, format, args);
    va_end(args);
    return code;
}

bool status_place(int *line, int *column)
{
    if (place_line > 0) {
        *line = place_line;
        *column = place_column;
    }
    return place_line > 0;
}

const char *status_message(void)
{
    return message;
}

void status_clear(void)
{
    message[0] = '\0';
    place_line = place_column = 0;
}
