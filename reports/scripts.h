// reports/scripts.h
// The page's scripts and how to cite it, inside the program (cmake/scripts.cmake).
#pragma once

typedef struct script {
    const char *text, *end;
    unsigned char sha256[32];
} script;

extern const script script_three;    // three.js, packed by gzip; sha256: unpacked
extern const script script_view;     // reports/view*.js, joined
extern const script script_citation; // CITATION.cff
extern const char three_revision[];  // "111"
