// reports/csv_kit.c
#include "reports/csv_kit.h"

#include <stdio.h>
#include <string.h>

enum { MAX_PATH = 4096 };

void csv_add(csv_header *h, const char *name)
{
    if (h->n < CSV_MAX_COLUMNS) {
        (void)snprintf(h->text[h->n++], CSV_MAX_NAME, "%s", name);
    }
}

void csv_add_all(csv_header *h, const char *names)
{
    while (*names) {
        char name[CSV_MAX_NAME];
        const size_t length = strcspn(names, " ");
        (void)snprintf(name, sizeof name, "%.*s", (int)length, names);
        csv_add(h, name);
        names += length + (names[length] == ' ');
    }
}

status csv_table(const char *dir, const char *file, const csv_header *h, csv **out)
{
    char path[MAX_PATH];
    const char *names[CSV_MAX_COLUMNS];
    if (snprintf(path, sizeof path, "%s/%s", dir, file) >= (int)sizeof path) {
        return status_fail(ERR_INPUT, "%.60s...: the path is too long", dir);
    }
    for (int i = 0; i < h->n; i++) {
        names[i] = h->text[i];
    }
    return csv_open(path, h->n, names, out);
}

void csv_reals(csv *c, int n, const double *values)
{
    for (int i = 0; i < n; i++) {
        csv_real(c, values[i]);
    }
}
