// tests/unit/io/test_csv.c
#include "io/csv.h"

#include "tests/unit/io/scratch.h"

static void check_file(const char *path, const char *wanted)
{
    size_t size = 0;
    char *text = read_whole(path, &size);
    CHECK(text && strcmp(text, wanted) == 0);
    if (text && strcmp(text, wanted) != 0) {
        printf("got:\n%swanted:\n%s", text, wanted);
    }
    free(text);
}

static void numbers_are_the_shortest_that_read_back(const scratch *dir)
{
    const char *names[] = {"length_m", "force_N"};
    csv *c = NULL;
    const scratch_path path = scratch_file(dir, "numbers.csv");
    CHECK_OK(csv_open(path.text, 2, names, &c));
    csv_real(c, 0.1);
    csv_real(c, 1.0 / 3.0);
    csv_real(c, 0.1 + 0.2);
    csv_real(c, -1e-300);
    csv_real(c, NAN);
    csv_real(c, INFINITY);
    CHECK_OK(csv_close(c));
    // 1/3 needs 16 digits and 0.1 + 0.2 needs 17
    check_file(path.text, "length_m,force_N\r\n0.1,0.3333333333333333\r\n"
                          "0.30000000000000004,-1e-300\r\n,\r\n");
}

static void texts_are_quoted_where_rfc_4180_asks_for_it(const scratch *dir)
{
    const char *names[] = {"a", "b"};
    csv *c = NULL;
    const scratch_path path = scratch_file(dir, "texts.csv");
    CHECK_OK(csv_open(path.text, 2, names, &c));
    csv_text(c, "plain");
    csv_text(c, "");
    csv_text(c, "a,b");
    csv_text(c, "says \"so\"");
    csv_text(c, "two\nlines");
    csv_text(c, " led by a blank");
    CHECK_OK(csv_close(c));
    check_file(path.text, "a,b\r\nplain,\r\n\"a,b\",\"says \"\"so\"\"\"\r\n"
                          "\"two\nlines\",\" led by a blank\"\r\n");
}

static void formulas_are_defused(const scratch *dir)
{
    const char *names[] = {"text"};
    csv *c = NULL;
    const scratch_path path = scratch_file(dir, "formulas.csv");
    CHECK_OK(csv_open(path.text, 1, names, &c));
    csv_text(c, "=HYPERLINK(\"x\",\"y\")");
    csv_text(c, "+1");
    csv_text(c, "-1");
    csv_text(c, "@SUM(A1)");
    csv_text(c, "a=b");
    csv_text(c, "-"); // a unit of ours, and no formula
    CHECK_OK(csv_close(c));
    check_file(path.text, "text\r\n\"'=HYPERLINK(\"\"x\"\",\"\"y\"\")\"\r\n'+1\r\n'-1\r\n"
                          "'@SUM(A1)\r\na=b\r\n-\r\n");
}

static void an_unfinished_row_is_a_bug(const scratch *dir)
{
    const char *names[] = {"a", "b"};
    csv *c = NULL;
    CHECK_OK(csv_open(scratch_file(dir, "short.csv").text, 2, names, &c));
    csv_real(c, 1);
    CHECK(csv_close(c) == ERR_BUG);
    status_clear();
}

static void a_full_disk_is_an_error(void)
{
    const char *names[] = {"a"};
    csv *c = NULL;
    CHECK_OK(csv_open("/dev/full", 1, names, &c));
    csv_real(c, 1);
    CHECK(csv_close(c) == ERR_RESOURCE);
    status_clear();
    CHECK(csv_open("/nowhere/at/all.csv", 1, names, &c) == ERR_RESOURCE);
    status_clear();
}

int main(void)
{
    const scratch dir = scratch_make();
    numbers_are_the_shortest_that_read_back(&dir);
    texts_are_quoted_where_rfc_4180_asks_for_it(&dir);
    formulas_are_defused(&dir);
    an_unfinished_row_is_a_bug(&dir);
    a_full_disk_is_an_error();
    scratch_remove(&dir);
    return test_failures != 0;
}
