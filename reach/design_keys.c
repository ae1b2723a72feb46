// reach/design_keys.c
#include "reach/reach_case.h"

#define COUNT(list) ((int)(sizeof(list) / sizeof *(list)))
#define MOST_NUMBER 1e30 // of a parameter, whose unit is not known here

#define NUMBER(word, member, text)                                                                 \
    {                                                                                              \
        .name = word, .kind = KEY_REAL, .min = -MOST_NUMBER, .max = MOST_NUMBER, .required = true, \
        .offset = offsetof(design_parameter_case, member), .about = text                           \
    }

static const key parameter_list[] = {
    {.name = "name",
     .kind = KEY_TEXT,
     .required = true,
     .offset = offsetof(design_parameter_case, name),
     .about = "a word that stands in the expressions of `set`"},
    {.name = "unit",
     .kind = KEY_TEXT,
     .initial = "none",
     .offset = offsetof(design_parameter_case, unit),
     .about = "for tables only"},
    NUMBER("lower", lower, "its least value"),
    NUMBER("upper", upper, "its most"),
    NUMBER("start", start, "that of the case as it stands"),
};

static const design_parameter_case parameter_initial = {.unit = ""};

static const key_table parameter_table = {
    .name = "design_parameter",
    .size = sizeof(design_parameter_case),
    .nkey = COUNT(parameter_list),
    .keys = parameter_list,
    .initial = &parameter_initial,
    .about = "a number that the design search chooses",
};

static const key design_list[] = {
    {.name = "scope",
     .kind = KEY_NAME,
     .required = true,
     .offset = offsetof(design_case, scope),
     .about = "the scope whose rod is varied, by its name"},
    {.name = "maximise",
     .kind = KEY_CHOICE,
     .choices = "targets|area",
     .initial = "targets",
     .offset = offsetof(design_case, goal),
     .about = "the targets reached, or the share of the tissue's surface"},
    {.name = "parameters",
     .kind = KEY_LIST,
     .max_count = DESIGN_PARAMETERS,
     .required = true,
     .offset = offsetof(design_case, parameters),
     .table = &parameter_table,
     .about = "what is chosen"},
    {.name = "set",
     .kind = KEY_TEXTS,
     .max_count = 64,
     .required = true,
     .offset = offsetof(design_case, set),
     .about = "keys of the scope's case by the parameters, KEY=EXPRESSION: "
              "\"section.shapes.1.sector.width_rad=width\""},
    {.name = "islands",
     .kind = KEY_INTEGER,
     .min = 1,
     .max = 1000,
     .initial = "4",
     .offset = offsetof(design_case, islands),
     .about = "searches side by side, each from its own seed; how many run at once does not "
              "matter to the answer"},
    {.name = "evaluations",
     .kind = KEY_INTEGER,
     .min = 1,
     .max = 1000000,
     .initial = "200",
     .offset = offsetof(design_case, evaluations),
     .about = "designs that each of them looks at"},
    {.name = "seed",
     .kind = KEY_INTEGER,
     .min = 0,
     .max = 2147483647,
     .initial = "1",
     .offset = offsetof(design_case, seed),
     .about = "of the random numbers: the same seed gives the same design"},
};

const key_table design_keys = {
    .name = "reach_design",
    .size = sizeof(design_case),
    .nkey = COUNT(design_list),
    .keys = design_list,
    .about = "a search for a rod that reaches more (`stiffaxis design`)",
};
