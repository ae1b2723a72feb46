// io/json.h
// A JSON writer that cannot write an unbalanced or invalid document: exactly one document, numbers
// with 17 digits where needed (shortest that reads back), NaN and infinities as null, UTF-8
// checked.
#pragma once

#include "base/dense.h"
#include "base/status.h"

#include <stdbool.h>
#include <stdio.h>

typedef struct json json;

status json_open(FILE *stream, json **out); // stream stays the caller's
status json_close(json *j); // ends the document with a newline, flushes, frees; first error seen

// key is NULL inside arrays and at the top. Misuse and failed writes are kept and come back from
// json_close. A text of NULL is written as null; bytes that are not UTF-8 become U+FFFD.
void json_object(json *j, const char *key);
void json_object_end(json *j);
void json_array(json *j, const char *key);
void json_array_end(json *j);
void json_real(json *j, const char *key, double value);
void json_integer(json *j, const char *key, long value);
void json_flag(json *j, const char *key, bool value);
void json_null(json *j, const char *key);
void json_text(json *j, const char *key, const char *value);
void json_reals(json *j, const char *key, int n, const double *values); // one line
void json_mat6(json *j, const char *key, mat6 m);
