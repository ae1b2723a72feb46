// io/expression_scan.h
// Looks through an expression before muParser sees it: only known names, operators that compute,
// one result.
#pragma once

#include "io/expression.h"

// ERR_INPUT with *error filled.
status expression_scan(const char *text, const expression_scope *scope, expression_error *error);

status expression_refuse(expression_error *error, int position, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
