// app/print_measured.c
// Errors against measured shapes in the layout of the paper's Tables II and III.
#include "app/print.h"
#include "reports/measured_show.h"

#include <stdio.h>
#include <string.h>

enum { COLUMNS = 10 };

static const char *cell(const measured_cells *c, int column)
{
    const char *cells[COLUMNS] = {c->name, c->tendon,  c->tension, c->tip,       c->shape,
                                  c->rms,  c->largest, c->angle,   c->paper_tip, c->paper_shape};
    return cells[column];
}

static void print_line(int ncolumn, const int *width, const char *(*text)(const void *, int),
                       const void *data)
{
    for (int k = 0; k < ncolumn; k++) {
        if (k < 2) {
            printf("%-*s  ", width[k], text(data, k));
        } else {
            printf("%*s%s", width[k], text(data, k), k + 1 < ncolumn ? "  " : "");
        }
    }
    (void)putchar('\n');
}

static const char *head(const void *data, int column)
{
    static const char *const names[2][COLUMNS] = {
        {"", "tendon", "tension", "tip error", "shape error", "rms", "largest", "tangents",
         "paper's tip", "paper's shape"},
        {"", "", "N", "mm (% of L)", "%", "mm", "mm at s mm", "deg", "mm (% of L)", "%"},
    };
    return names[*(const int *)data][column];
}

static const char *row_cell(const void *data, int column)
{
    return cell(data, column);
}

static void print_sentence(const char *words)
{
    if (words[0]) {
        printf("%s.\n", words);
    }
}

static void print_notes(const run_result *r)
{
    char words[MEASURED_NOTES];
    for (int i = 0; i < r->measured.nline; i++) {
        const measured_line *line = &r->measured.line[i];
        measured_line_notes(r, line, words, sizeof words);
        if (words[0]) {
            printf("%s: %s.\n", print_plain(line->name).text, words);
        }
    }
}

void print_measured(const run_result *r)
{
    measured_row rows[MEASURED_ROWS];
    char words[MEASURED_SOURCE + 80];
    int width[COLUMNS] = {0};
    if (!r->has_measured) {
        return;
    }
    const int n = measured_rows(r, rows), ncolumn = measured_has_paper(r) ? COLUMNS : COLUMNS - 2;
    measured_data_words(r, words, sizeof words);
    if (r->measured.nline > 0) {
        printf("%s: the rod's model against them: %s\n", measured_word(r),
               print_plain(r->title).text);
    } else {
        printf("the paper's errors for its own shapes: %s\n", print_plain(r->title).text);
    }
    for (int i = -2; i < n; i++) {
        const int line = i + 2;
        const measured_cells c =
            i < 0 ? (measured_cells){.name = ""} : measured_cells_of(r, &rows[i], " +- ");
        for (int k = 0; k < ncolumn; k++) {
            const int length = (int)strlen(i < 0 ? head(&line, k) : cell(&c, k));
            width[k] = length > width[k] ? length : width[k];
        }
    }
    for (int line = 0; line < 2; line++) {
        print_line(ncolumn, width, head, &line);
    }
    for (int i = 0; i < n; i++) {
        const measured_cells c = measured_cells_of(r, &rows[i], " +- ");
        print_line(ncolumn, width, row_cell, &c);
    }
    print_notes(r);
    print_sentence(words);
    print_sentence(measured_paper_words(r));
}
