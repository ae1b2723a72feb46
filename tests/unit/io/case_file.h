// tests/unit/io/case_file.h
// A case from a text, through a file in a temporary directory.
#pragma once

#include "tests/unit/io/small_case.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

static char case_file_path[64];

static inline void case_file_write(const char *text, size_t length)
{
    // in memory where there is such a place: a fuzzer writes thousands
    (void)snprintf(case_file_path, sizeof case_file_path, "%s/stiffaxis-test-%ld.yaml",
                   access("/dev/shm", W_OK) == 0 ? "/dev/shm" : "/tmp", (long)getpid());
    FILE *file = fopen(case_file_path, "wb");
    if (!file || fwrite(text, 1, length, file) != length || fclose(file) != 0) {
        perror(case_file_path);
        abort();
    }
}

// opens, peeks at the rod's length as the program does, and reads by the small tables
static inline status case_file_read(const char *path, int noverride, const char *const *overrides,
                                    small_case *out, config **cfg)
{
    status st = OK;
    double length = 0;
    bool found = false;
    TRY(config_open(path, noverride, overrides, cfg));
    TRY(config_peek_real(*cfg, "rod.length", &small_rod_list[0], &length, &found));
    if (found) {
        config_set_length(*cfg, length);
    }
    TRY(config_read(*cfg, &small_case_keys, out));

done:
    return st;
}

static inline status case_text_read(const char *text, int noverride, const char *const *overrides,
                                    small_case *out, config **cfg)
{
    case_file_write(text, strlen(text));
    const status st = case_file_read(case_file_path, noverride, overrides, out, cfg);
    (void)remove(case_file_path);
    return st;
}

static inline double cpu_seconds(void)
{
    struct timespec t;
    (void)clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}
