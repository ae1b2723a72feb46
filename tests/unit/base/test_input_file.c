// tests/unit/meshes/test_input_file.c
#include "base/input_file.h"
#include "tests/test.h"

#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static char folder[] = "/tmp/stiffaxis-input-XXXXXX";

static void put(const char *name, const char *bytes, size_t count)
{
    char path[256];
    (void)snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *f = fopen(path, "wb");
    CHECK(f && fwrite(bytes, 1, count, f) == count);
    if (f) {
        (void)fclose(f);
    }
}

static status take(const char *directory, const char *name, size_t most, input_file *out)
{
    const key_text text = {.text = name, .at = {7, 11}};
    status_clear();
    return input_file_read(directory, &text, most, out);
}

static void a_file_is_read_whole_and_ends_in_a_zero(void)
{
    input_file f = {0};
    put("a", "ab\0cd\n", 6);
    CHECK_OK(take(folder, "a", 6, &f));
    CHECK(f.count == 6 && memcmp(f.bytes, "ab\0cd\n", 7) == 0);
    CHECK(input_file_begins(&f, "ab") && !input_file_begins(&f, "b"));
    CHECK(input_file_ends(&f, "cd") && !input_file_ends(&f, "c"));
    input_file_free(&f);

    char path[256];
    (void)snprintf(path, sizeof path, "%s/a", folder);
    CHECK_OK(take("/nowhere", path, 6, &f)); // an absolute name needs no directory
    input_file_free(&f);
    put("empty", "", 0);
    CHECK_OK(take(folder, "empty", 6, &f));
    CHECK(f.count == 0 && f.bytes[0] == 0);
    CHECK(!input_file_begins(&f, "x") && !input_file_ends(&f, "x"));
    input_file_free(&f);
}

static void what_is_no_file_is_refused_at_the_place_of_its_name(void)
{
    input_file f = {0};
    char pipe_path[256];
    int line = 0, column = 0;
    (void)snprintf(pipe_path, sizeof pipe_path, "%s/pipe", folder);
    CHECK(mkfifo(pipe_path, 0600) == 0);
    const char *names[] = {"absent", "pipe", "/dev/zero", "/dev/tty", "."};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        CHECK(take(folder, names[i], 100, &f) == ERR_FILE);
        CHECK(status_place(&line, &column) && line == 7 && column == 11);
        CHECK(!f.path && !f.bytes);
    }
    CHECK(take(folder, "", 100, &f) == ERR_INPUT);
}

static void a_size_is_not_exceeded(void)
{
    input_file f = {0};
    put("b", "123456", 6);
    CHECK(take(folder, "b", 5, &f) == ERR_FILE);
    CHECK(strstr(status_message(), "at most 5") != NULL);
}

static void a_message_is_one_line_whatever_it_quotes(void)
{
    input_file f = {0};
    put("c\nd", "", 0);
    CHECK_OK(take(folder, "c\nd", 5, &f));
    status_clear();
    CHECK(input_file_fail(&f, 12, "unknown '%s'", "x\ny\x1b[0m\xff\xc3\xa4\xc3") == ERR_FILE);
    CHECK(strstr(status_message(), "c?d:12: unknown 'x?y?[0m?\xc3\xa4?'") != NULL);
    input_file_free(&f);
}

int main(void)
{
    if (!mkdtemp(folder)) {
        return 1;
    }
    a_file_is_read_whole_and_ends_in_a_zero();
    what_is_no_file_is_refused_at_the_place_of_its_name();
    a_size_is_not_exceeded();
    a_message_is_one_line_whatever_it_quotes();
    const char *names[] = {"a", "b", "c\nd", "empty", "pipe"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        char path[256];
        (void)snprintf(path, sizeof path, "%s/%s", folder, names[i]);
        (void)remove(path);
    }
    CHECK(rmdir(folder) == 0);
    return test_failures != 0;
}
