// measure/cloud_read.h
// Files of scanned points: PLY and PCD in all their forms, and text with three or more columns
// (XYZ, CSV). A file is what its content says, whatever it is called. It is read once, piece by
// piece: beside the points no more than 1 MB is held, and a file's own counts are believed only as
// far as its size bears them out.
#pragma once

#include "measure/point_cloud.h"

#include <stdbool.h>

typedef struct cloud_read_options {
    double unit; // of the file's lengths [m]; NAN: what its names of columns say, else mm
    void (*progress)(void *context, double share); // 0 to 1; may be NULL
    void *context;
} cloud_read_options;

enum { CLOUD_KIND = 48 };

typedef struct cloud_report {
    char kind[CLOUD_KIND]; // "PLY, binary little endian"
    size_t read, dropped;  // dropped: not finite, or farther than 10 km
    double unit;           // of the file [m]
    bool unit_named;       // by its own columns
} cloud_report;

// What a file's first bytes say; CLOUD_NONE: none of these.
typedef enum cloud_format { CLOUD_NONE, CLOUD_PLY, CLOUD_PCD, CLOUD_TEXT } cloud_format;

// ERR_FILE, "FILE:LINE: words" in text and "FILE: at byte N: words" in what is none, where it is no
// such file, is damaged, has no point or more than CLOUD_MOST_POINTS; ERR_INPUT where options->unit
// contradicts the file's own.
status cloud_read(const char *path, const cloud_read_options *options, point_cloud *out,
                  cloud_report *report);
