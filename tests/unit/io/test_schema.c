// tests/unit/io/test_schema.c
#include "io/json.h"
#include "tests/test.h"
#include "tests/unit/io/small_case.h"

#include <string.h>

static char written[256 << 10];

static void write_schema(void)
{
    json *j = NULL;
    FILE *stream = fmemopen(written, sizeof written, "w");
    CHECK_OK(json_open(stream, &j));
    CHECK_OK(schema_write(&small_case_keys, j));
    CHECK_OK(json_close(j));
    (void)fclose(stream);
}

// the text without white space, so that a test does not depend on line breaks
static void squeeze(void)
{
    char *to = written;
    bool inside = false;
    for (const char *p = written; *p; p++) {
        inside = inside != (*p == '"');
        if (inside || (*p != ' ' && *p != '\n')) {
            *to++ = *p;
        }
    }
    *to = '\0';
}

static void says(const char *piece)
{
    if (!strstr(written, piece)) {
        test_failures++;
        printf("the schema does not say %s\n", piece);
    }
}

static int times(const char *piece)
{
    int n = 0;
    for (const char *p = strstr(written, piece); p; p = strstr(p + 1, piece)) {
        n++;
    }
    return n;
}

static void the_schema_says_what_the_tables_say(void)
{
    write_schema();
    squeeze();
    says("\"$schema\":\"https://json-schema.org/draft/2020-12/schema\"");
    says("\"length_mm\":{\"description\":\"of the rod\",\"type\":[\"number\",\"string\"],"
         "\"minimum\":0.001,\"maximum\":10000}");
    says("\"length_m\":{\"description\":\"of the rod\",\"type\":[\"number\",\"string\"],"
         "\"minimum\":1e-06,\"maximum\":10}");
    says("\"points\":{\"description\":\"of the shape\",\"type\":[\"integer\",\"string\"],"
         "\"minimum\":2,\"maximum\":100000,\"default\":101}");
    says("\"pictures\":{\"description\":\"drawn | or not\",\"type\":\"boolean\",\"default\":true}");
    says("\"model\":{\"description\":\"with or without warping\",\"enum\":[\"full\",\"classical\"],"
         "\"default\":\"full\"}");
    says("\"force_N\":{\"description\":\"on the "
         "tip\",\"type\":\"array\",\"items\":{\"type\":[\"number\","
         "\"string\"]},\"minItems\":3,\"maxItems\":3,\"default\":[0,0,0]}");
    says("\"rod\":{\"description\":\"the rod\",\"$ref\":\"#/$defs/rod\"}");
    says("\"materials\":{\"description\":\"by name\",\"type\":\"object\",\"additionalProperties\":"
         "{\"$ref\":\"#/$defs/material\"},\"maxProperties\":10000}");
    says("\"shapes\":{\"description\":\"laid on one another\",\"type\":\"array\",\"items\":"
         "{\"$ref\":\"#/$defs/shape\"},\"maxItems\":1000}");
}

static void the_schema_demands_what_the_reader_demands(void)
{
    write_schema();
    squeeze();
    // one of four spellings
    says("{\"oneOf\":[{\"required\":[\"length_mm\"]},{\"required\":[\"length_m\"]},{\"required\":["
         "\"length_cm\"]},"
         "{\"required\":[\"length_um\"]}]}");
    // a group of which one is given
    says("{\"oneOf\":[{\"required\":[\"annulus\"]},{\"required\":[\"sector\"]}]}");
    // a group of which none need be given
    says("{\"required\":[\"at\"]},{\"not\":{\"anyOf\":[{\"required\":[\"at_mm\"]}");
    says("\"oneOf\":[{\"required\":[\"format\"]}]");
    // one table each and the root
    CHECK(times("\"additionalProperties\":false") == 8);
    CHECK(times("\"properties\":{") == 8);
    CHECK(times("\"$defs\":{") == 1);
}

static void the_reference_lists_every_key(void)
{
    FILE *stream = fmemopen(written, sizeof written, "w");
    CHECK_OK(schema_markdown(&small_case_keys, stream));
    (void)fclose(stream);
    says("## rod\n");
    says("| `length_mm` `length_m` `length_cm` `length_um` | number, 0.001 to 10000 mm | required "
         "| of the rod |\n");
    says("| `pictures` | true or false | true | drawn \\| or not |\n");
    says("| `model` | full\\|classical | full | with or without warping |\n");
    says("| `annulus` | map of [ring](#ring) | one of group 1 | a full ring |\n");
    says("| `tensions_N` `tensions_mN` | rows of numbers, at least 0 N |  | one row for each "
         "solution |\n");
    CHECK(times("\n## ") == 8);
}

int main(void)
{
    the_schema_says_what_the_tables_say();
    the_schema_demands_what_the_reader_demands();
    the_reference_lists_every_key();
    return test_failures != 0;
}
