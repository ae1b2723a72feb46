// app/complete.h
// What a shell may offer for the word that is being typed, from the lists that the program goes by.
#pragma once

#include <stdio.h>

// words [n]: those behind the program's name; the last one is being typed, "" where nothing is yet.
// One candidate a line, a tab and its meaning behind it where it has one; what ends in '=' or '.'
// goes on. ":files yaml yml" and ":directories" stand for names of files.
void complete(int n, const char *const *words, FILE *stream);
