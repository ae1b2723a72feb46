// measure/measured_keys.c
#include "measure/measured_keys.h"

#include "measure/line_file.h"

#include <math.h>

#define COUNT(list) ((int)(sizeof(list) / sizeof *(list)))
#define MOST_NEWTONS 1e9

static const key shape_key_list[] = {
    {.name = "name",
     .kind = KEY_TEXT,
     .offset = offsetof(measured_shape, name),
     .about = "for tables and figures"},
    {.name = "csv",
     .kind = KEY_NAME,
     .required = true,
     .offset = offsetof(measured_shape, csv),
     .about = "file with columns s, x, y, z and, where known, sigma (fit_sigma), with their units "
              "(s_mm), in "
              "the frame of the rod's base: what `stiffaxis scan` writes"},
    {.name = "tensions",
     .kind = KEY_ROWS,
     .dimension = DIM_FORCE,
     .min = 0,
     .max = MOST_NEWTONS,
     .one_of = 1,
     .offset = offsetof(measured_shape, tensions),
     .about = "one per tendon: those of the rod's solution that was measured"},
    {.name = "solution",
     .kind = KEY_INTEGER,
     .min = 1,
     .max = 1e6,
     .one_of = 1,
     .offset = offsetof(measured_shape, solution),
     .about = "number of the rod's solution, from 1, instead of its tensions"},
    {.name = "tip",
     .kind = KEY_CHOICE,
     .choices = "by_length|measured|not_measured",
     .initial = "by_length",
     .offset = offsetof(measured_shape, tip),
     .about = "whether the line ends at the rod's tip; by_length: where it is not shorter "
              "than the model by more than 2 % of the length, nor longer by 10 %"},
};

static const key_table shape_keys = {
    .name = "measured_shape",
    .size = sizeof(measured_shape),
    .nkey = COUNT(shape_key_list),
    .keys = shape_key_list,
    .about = "a measured shape of the rod",
};

static const key measured_key_list[] = {
    {.name = "synthetic",
     .kind = KEY_FLAG,
     .initial = "false",
     .offset = offsetof(measured_case, synthetic),
     .about = "the data is made, not from a bench: said in every table, figure and document"},
    {.name = "source",
     .kind = KEY_TEXT,
     .offset = offsetof(measured_case, source),
     .about = "where the data comes from, one line"},
    {.name = "paper",
     .kind = KEY_CHOICE,
     .choices = "none|table_2|table_3",
     .initial = "none",
     .offset = offsetof(measured_case, paper),
     .about = "the table of the paper whose errors stand beside, where tendon and tension are its "
              "own"},
    {.name = "arclength",
     .kind = KEY_CHOICE,
     .choices = "measured|rest",
     .initial = "measured",
     .offset = offsetof(measured_case, arclength),
     .about = "s of the files runs along the line as it lies, or along the unloaded rod"},
    {.name = "sigma",
     .kind = KEY_REAL,
     .dimension = DIM_LENGTH,
     .min = 0,
     .max = 1,
     .offset = offsetof(measured_case, sigma),
     .about = "standard deviation of a place across the line where a file has none; 0: unknown"},
    {.name = "correlation_length",
     .kind = KEY_REAL,
     .dimension = DIM_LENGTH,
     .min = 0,
     .max = 1e3,
     .offset = offsetof(measured_case, correlation),
     .about =
         "along the line, over which measuring errors go together; 0: what the file says (a scan's "
         "does), else every place has its own"},
    {.name = "tolerance",
     .kind = KEY_REAL,
     .min = 0,
     .max = 10,
     .offset = offsetof(measured_case, tolerance),
     .about = "of tip error over length and of the shape error, for a verdict; 0: none is given"},
    {.name = "shapes",
     .kind = KEY_LIST,
     .max_count = MEASURED_SHAPES,
     .offset = offsetof(measured_case, shapes),
     .table = &shape_keys,
     .about = "the measured shapes"},
};

const key_table measured_keys = {
    .name = "measured",
    .size = sizeof(measured_case),
    .nkey = COUNT(measured_key_list),
    .keys = measured_key_list,
    .about = "shapes of the rod that were measured, to hold the model against",
};

status measured_case_read(measured_case *c, const char *directory, double length, mark *where)
{
    status st = OK;
    measured_shape *shape = c->shapes.items;
    for (int i = 0; i < c->shapes.count; i++) {
        centreline *line = &shape[i].line;
        *where = shape[i].csv.at;
        TRY(line_file_read(directory, &shape[i].csv, length, line, &c->synthetic));
        if (c->correlation > 0) {
            line->correlation_length = c->correlation;
        }
        for (int k = 0; k < line->count; k++) {
            line->sigma[k] = isnan(line->sigma[k]) && c->sigma > 0 ? c->sigma : line->sigma[k];
        }
    }

done:
    return st;
}

void measured_case_release(measured_case *c)
{
    measured_shape *shape = c->shapes.items;
    for (int i = 0; i < c->shapes.count; i++) {
        centreline_free(&shape[i].line);
    }
}
