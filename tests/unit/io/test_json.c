// tests/unit/io/test_json.c
#include "io/json.h"
#include "tests/test.h"

#include <locale.h>
#include <string.h>

static char written[4096];

// runs `write` on a stream in memory and keeps the text
static status document(void (*write)(json *))
{
    json *j = NULL;
    FILE *stream = fmemopen(written, sizeof written, "w");
    status st = json_open(stream, &j);
    if (st == OK) {
        write(j);
        st = json_close(j);
    }
    (void)fclose(stream);
    return st;
}

static void some_of_everything(json *j)
{
    json_object(j, NULL);
    json_text(j, "schema", "stiffaxis/test/1");
    json_real(j, "tenth", 0.1);
    json_integer(j, "count", -3);
    json_flag(j, "stable", true);
    json_null(j, "nothing");
    json_text(j, "no text", NULL);
    json_reals(j, "row", 3, (const double[]){1, 2.5, -0.125});
    json_array(j, "empty");
    json_array_end(j);
    json_array(j, "list");
    json_object(j, NULL);
    json_object_end(j);
    json_integer(j, NULL, 7);
    json_array_end(j);
    json_object_end(j);
}

static void a_document_holds_what_was_written(void)
{
    CHECK_OK(document(some_of_everything));
    CHECK(strcmp(written, "{\n"
                          "  \"schema\": \"stiffaxis/test/1\",\n"
                          "  \"tenth\": 0.1,\n"
                          "  \"count\": -3,\n"
                          "  \"stable\": true,\n"
                          "  \"nothing\": null,\n"
                          "  \"no text\": null,\n"
                          "  \"row\": [1, 2.5, -0.125],\n"
                          "  \"empty\": [],\n"
                          "  \"list\": [\n"
                          "    {},\n"
                          "    7\n"
                          "  ]\n"
                          "}\n") == 0);
}

static void texts_of_all_sorts(json *j)
{
    json_array(j, NULL);
    json_text(j, NULL, "quote \" slash \\ line \n tab \t bell \a");
    json_text(j, NULL, "\xC3\xA9 \xE2\x82\xAC \xF0\x9F\x98\x80"); // two, three and four bytes
    json_text(j, NULL, "cut \xE2\x82");                           // a character cut short
    json_text(j, NULL, "bad \xC0\xAF \xED\xA0\x80 \xFF."); // overlong, surrogate, no UTF-8 at all
    json_array_end(j);
}

static void texts_are_escaped_and_always_utf8(void)
{
    CHECK_OK(document(texts_of_all_sorts));
    CHECK(strstr(written, "\"quote \\\" slash \\\\ line \\u000a tab \\u0009 bell \\u0007\"") !=
          NULL);
    CHECK(strstr(written, "\"\xC3\xA9 \xE2\x82\xAC \xF0\x9F\x98\x80\"") != NULL);
    CHECK(strstr(written, "\"cut \xEF\xBF\xBD\xEF\xBF\xBD\"") != NULL);
    CHECK(strchr(written, '\xC0') == NULL && strchr(written, '\xED') == NULL &&
          strchr(written, '\xFF') == NULL);
}

static const double hard[] = {0.1,  1.0 / 3,    1e22,     5e-324, 1.7976931348623157e308,
                              -0.0, 123456789., 2.5e-310, 1e23,   0.30000000000000004,
                              4.35, 1e16 + 2,   3.0};
enum { NHARD = sizeof hard / sizeof *hard };

static void hard_numbers(json *j)
{
    json_reals(j, NULL, NHARD, hard);
}

static void numbers_read_back_bit_for_bit(void)
{
    CHECK_OK(document(hard_numbers));
    const char *p = strchr(written, '[') + 1;
    for (int i = 0; i < NHARD; i++) {
        char *end = NULL;
        const double back = strtod(p, &end);
        CHECK(memcmp(&back, &hard[i], sizeof back) == 0);
        p = end + 2;
    }
    CHECK(strstr(written, "4.35,") != NULL); // and with no more digits than it takes
    CHECK(strstr(written, "3]") != NULL);
}

static void numbers_that_json_cannot_say(json *j)
{
    json_reals(j, NULL, 3, (const double[]){NAN, INFINITY, -INFINITY});
}

static void nan_and_infinity_are_null(void)
{
    CHECK_OK(document(numbers_that_json_cannot_say));
    CHECK(strcmp(written, "[null, null, null]\n") == 0);
}

static void identity(json *j)
{
    json_mat6(j, NULL, mat6_identity());
}

static void a_matrix_is_six_rows(void)
{
    CHECK_OK(document(identity));
    CHECK(strstr(written, "[\n  [1, 0, 0, 0, 0, 0],\n") == written);
    CHECK(strstr(written, "  [0, 0, 0, 0, 0, 1]\n]\n") != NULL);
}

static void nothing(json *j)
{
    (void)j;
}

static void two_documents(json *j)
{
    json_integer(j, NULL, 1);
    json_integer(j, NULL, 2);
}

static void never_ended(json *j)
{
    json_object(j, NULL);
}

static void wrong_end(json *j)
{
    json_object(j, NULL);
    json_array_end(j);
    json_object_end(j);
}

static void end_too_many(json *j)
{
    json_array(j, NULL);
    json_array_end(j);
    json_array_end(j);
}

static void key_in_an_array(json *j)
{
    json_array(j, NULL);
    json_integer(j, "key", 1);
    json_array_end(j);
}

static void no_key_in_an_object(json *j)
{
    json_object(j, NULL);
    json_integer(j, NULL, 1);
    json_object_end(j);
}

static void key_at_the_top(json *j)
{
    json_integer(j, "key", 1);
}

static void too_deep(json *j)
{
    for (int i = 0; i < 1000; i++) {
        json_array(j, NULL);
    }
    for (int i = 0; i < 1000; i++) {
        json_array_end(j);
    }
}

static void misuse_is_told_when_closing(void)
{
    void (*const wrong[])(json *) = {
        nothing,         two_documents,       never_ended,    wrong_end, end_too_many,
        key_in_an_array, no_key_in_an_object, key_at_the_top, too_deep};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        CHECK(document(wrong[i]) == ERR_BUG);
        CHECK(status_message()[0] != '\0');
        status_clear();
    }
}

static void a_full_disk_is_told(void)
{
    json *j = NULL;
    FILE *full = fopen("/dev/full", "w");
    if (!full) {
        return; // not a Linux system
    }
    CHECK_OK(json_open(full, &j));
    json_integer(j, NULL, 1);
    CHECK(json_close(j) == ERR_RESOURCE);
    CHECK(strstr(status_message(), "writing JSON failed") != NULL);
    status_clear();
    (void)fclose(full);
}

// the decimal comma of a German or French desktop must not enter a document
static void the_locale_does_not_matter(void)
{
    static const char *const names[] = {"de_DE.UTF-8", "de_DE", "fr_FR.UTF-8", "fr_FR"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        if (setlocale(LC_ALL, names[i])) {
            CHECK_OK(document(some_of_everything));
            CHECK(strstr(written, "\"tenth\": 0.1,") != NULL);
        }
    }
    (void)setlocale(LC_ALL, "C");
}

int main(void)
{
    a_document_holds_what_was_written();
    texts_are_escaped_and_always_utf8();
    numbers_read_back_bit_for_bit();
    nan_and_infinity_are_null();
    a_matrix_is_six_rows();
    misuse_is_told_when_closing();
    a_full_disk_is_told();
    the_locale_does_not_matter();
    return test_failures != 0;
}
