// reports/scripts.h
// The page's scripts, inside the program (cmake/scripts.cmake).
#pragma once

typedef struct script {
    const char *text, *end;
    unsigned char sha256[32];
} script;

extern const script script_three; // three.js
extern const script script_view;  // reports/view.js
