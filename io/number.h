// io/number.h
// Numbers as text, with a point for the decimals in every locale.
#pragma once

#include <stdbool.h>

enum { NUMBER_TEXT = 32 };

// The shortest of 15, 16 or 17 digits that reads back as `value`; NaN and infinities as "nan",
// "inf", "-inf".
void number_text(double value, char text[NUMBER_TEXT]);

// A decimal number and nothing else: [+-] digits [. digits] [e [+-] digits]; no blanks, no
// hexadecimal, no inf or nan. False where `text` is anything else; a number too large for a double
// is infinite.
bool number_read(const char *text, double *value);

// "s", or "" after a count of one.
const char *plural(int count);
