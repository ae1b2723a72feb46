// tests/unit/io/test_config_hostile.c
// Files that want to exhaust time or memory get one line, quickly.
#include "io/config.h"
#include "tests/test.h"
#include "tests/unit/io/case_file.h"

// for a release build on a slow machine; sanitizers multiply by some 5
#if defined(__SANITIZE_ADDRESS__)
static const double MAX_SECONDS = 5;
#else
static const double MAX_SECONDS = 1;
#endif

typedef struct text {
    char *a;
    size_t length, room;
} text;

static void add(text *t, const char *piece, int times)
{
    const size_t n = strlen(piece);
    const size_t needed = t->length + n * (size_t)times + 1;
    if (needed > t->room) {
        t->room = 2 * needed;
        t->a = realloc(t->a, t->room);
    }
    if (!t->a) {
        abort();
    }
    for (int i = 0; i < times; i++) {
        memcpy(t->a + t->length, piece, n);
        t->length += n;
    }
    t->a[t->length] = '\0';
}

// the file at `path` is refused with these words behind its name, in little time
static void refused(const char *path, const char *words)
{
    config *cfg = NULL;
    small_case c;
    const double start = cpu_seconds();
    CHECK(case_file_read(path, 0, NULL, &c, &cfg) == ERR_INPUT);
    config_free(cfg);
    const double seconds = cpu_seconds() - start;
    const char *message = status_message();
    CHECK(seconds < MAX_SECONDS);
    CHECK(strncmp(message, path, strlen(path)) == 0 && strchr(message, '\n') == NULL);
    if (strstr(message, words) != message + strlen(path)) {
        test_failures++;
        printf("wanted %s%s\n   got %s\n", path, words, message);
    }
    printf("%-34.34s %6.1f ms  %.70s\n", words, 1e3 * seconds, message + strlen(path));
    status_clear();
}

static void refused_text(text *t, const char *words)
{
    case_file_write(t->a, t->length);
    refused(case_file_path, words);
    (void)remove(case_file_path);
    free(t->a);
    *t = (text){0};
}

static void a_file_of_100_megabytes(void)
{
    case_file_write("format: 1\n", 10);
    CHECK(truncate(case_file_path, 100000000) == 0);
    refused(case_file_path, ": error: the file is larger than 8 MB: not a case");
    (void)remove(case_file_path);
}

static void devices_without_end(void)
{
    refused("/dev/zero", ": error: the file is larger than 8 MB: not a case");
    refused("/dev/null", ":1:1: error: the case is empty");
}

static void nesting_of_10000_levels(void)
{
    text t = {0};
    add(&t, "format: 1\nloads: ", 1);
    add(&t, "[", 10000);
    refused_text(&t, ":2:39: error: nested deeper than 32 levels");
    add(&t, "[", 10000);
    add(&t, "]", 10000);
    refused_text(&t, ":1:33: error: nested deeper than 32 levels");
    add(&t, "{a: ", 10000);
    refused_text(&t, ":1:129: error: nested deeper than 32 levels");
    add(&t, "- ", 10000);
    refused_text(&t, ":1:65: error: nested deeper than 32 levels");
    add(&t, "? ", 10000);
    refused_text(&t, ":1:3: error: a key must be a plain name, not a list or a map");
    for (int i = 0; i < 3000; i++) {
        add(&t, " ", i);
        add(&t, "a:\n", 1);
    }
    refused_text(&t, ":33:33: error: nested deeper than 32 levels");
}

static void many_of_everything(void)
{
    text t = {0};
    char piece[32];
    for (int i = 0; i < 1000000; i++) {
        (void)snprintf(piece, sizeof piece, "%x:\n", (unsigned)i);
        add(&t, piece, 1);
    }
    refused_text(&t, ":100001:1: error: more than 100000 keys in one map: not a case");
    add(&t, "format: 1\nloads: [", 1);
    add(&t, "1,", 2000000);
    refused_text(&t, ":2:2000003: error: more than 1000000 values: not a case");
    add(&t, "format: 1\nloads: [", 1);
    add(&t, "{},", 20000);
    add(&t, "]", 1);
    refused_text(&t, ":2:8: error: 'loads': 20000 entries, at most 10000 are allowed");
    add(&t, "%TAG !a! tag:b\n", 100000);
    refused_text(&t, ":1:1: error: a case has no YAML directives");
    add(&t, "# nothing\n", 700000);
    refused_text(&t, ":1:1: error: the case is empty");
    add(&t, "a: 1\na: 1\n", 500000);
    refused_text(&t, ":2:1: error: key 'a' is given twice, first on line 1");
}

static void billion_laughs(void)
{
    text t = {0};
    add(&t, "a: &a [ha, ha, ha, ha, ha, ha, ha, ha, ha]\n", 1);
    add(&t, "b: [*a, *a, *a, *a, *a, *a, *a, *a, *a]\n", 1);
    refused_text(&t, ":1:4: error: a case has no anchors ('&name')");
}

static void long_texts(void)
{
    text t = {0};
    add(&t, "format: ", 1);
    add(&t, "1+", 4000000);
    refused_text(&t, ":1:9: error: 'format': arithmetic longer than 1000 characters");
    add(&t, "format: ", 1);
    add(&t, "(", 1000);
    refused_text(&t, ":1:1009: error: 'format': ')' is missing");
    add(&t, "x", 8000000);
    refused_text(&t, ":1:1: error: a case is a map of keys");
    add(&t, "\"\\x1b]0;", 1);
    add(&t, "y", 100000);
    add(&t, "\": 1", 1);
    refused_text(&t, ":1:1: error: the control character U+001B in a text");
    add(&t, "title: \"", 1);
    add(&t, "\\u202e\\n", 100000);
    add(&t, "\"\nmodel: 3\n", 1);
    refused_text(&t, ":1:8: error: the control character U+202E in a text");
    add(&t, "title: \"", 1);
    add(&t, "x\\n", 100000);
    add(&t, "\"\nmodel: 3\n", 1);
    refused_text(&t, ":2:1: error: unknown key 'model'; known here are ");
}

// 9000 arithmetics in rows, and 1000 that vary: a strange case, but a case
static void much_arithmetic_is_read_in_time(void)
{
    text t = {0};
    config *cfg = NULL;
    small_case c;
    add(&t, "format: 1\nmaterials: {}\nsection:\n  shapes:\n", 1);
    add(&t, "    - {sector: {outer_radius_mm: 4, inner_radius_mm: 1 + sin(pi*s/L)}, material: a}\n",
        1000);
    add(&t, "rod:\n  length_mm: 120\n  tensions_N:\n", 1);
    add(&t, "    - [1/3, sqrt(2), cos(pi/7)]\n", 3000);
    case_file_write(t.a, t.length);
    const double start = cpu_seconds();
    CHECK_OK(case_file_read(case_file_path, 0, NULL, &c, &cfg));
    const double seconds = cpu_seconds() - start;
    printf("%-34s %6.1f ms\n", "10000 expressions", 1e3 * seconds);
    CHECK(seconds < MAX_SECONDS);
    CHECK(c.rod.tensions.nrow == 3000 && c.section.shapes.count == 1000);
    config_free(cfg);
    (void)remove(case_file_path);
    free(t.a);
}

int main(void)
{
    a_file_of_100_megabytes();
    devices_without_end();
    nesting_of_10000_levels();
    many_of_everything();
    billion_laughs();
    long_texts();
    much_arithmetic_is_read_in_time();
    return test_failures != 0;
}
