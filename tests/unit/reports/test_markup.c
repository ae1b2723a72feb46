// tests/unit/reports/test_markup.c
#include "reports/markup.h"
#include "tests/test.h"

#include <string.h>

static void only_whole_utf8_characters_are_counted(void)
{
    CHECK(utf8_length("a", 1) == 1);
    CHECK(utf8_length("\xC3\xA9", 2) == 2);
    CHECK(utf8_length("\xE2\x80\xA6", 3) == 3);
    CHECK(utf8_length("\xF0\x9F\x98\x80", 4) == 4);
    CHECK(utf8_length("\xC3\xA9", 1) == 0);         // cut in two
    CHECK(utf8_length("\xC0\xAF", 2) == 0);         // a slash in too long a form
    CHECK(utf8_length("\xE0\x80\xAF", 3) == 0);     // likewise
    CHECK(utf8_length("\xED\xA0\x80", 3) == 0);     // half a surrogate pair
    CHECK(utf8_length("\xF4\x90\x80\x80", 4) == 0); // past the last code point
    CHECK(utf8_length("\x80", 1) == 0);
    CHECK(utf8_length("\xFF", 1) == 0);
}

static void cleaning_leaves_text_that_any_terminal_may_see(void)
{
    char out[32];
    CHECK(utf8_clean("a\x1b[31m\xff\xC2\x9B", out, sizeof out) == 8);
    CHECK(strcmp(out, "a [31m? ") == 0);
    // what ends a line, and what turns the direction of writing
    (void)utf8_clean("a\xE2\x80\xA8"
                     "b\xE2\x80\xAE"
                     "c\xC2\x85",
                     out, sizeof out);
    CHECK(strcmp(out, "a b c ") == 0);
    // a text in its own place
    (void)snprintf(out, sizeof out, "x\xE2\x80\xAE\xC3\xA9\x07y");
    CHECK(utf8_clean(out, out, sizeof out) == 5 && strcmp(out, "x \xC3\xA9 y") == 0);
    // no room for the second half of the last character
    CHECK(utf8_clean("ab\xC3\xA9", out, 4) == 2);
    CHECK(strcmp(out, "ab") == 0);
}

static void shortening_counts_characters_not_bytes(void)
{
    char out[64];
    utf8_shorten("\xC3\xA9\xC3\xA9\xC3\xA9\xC3\xA9", 4, out, sizeof out);
    CHECK(strcmp(out, "\xC3\xA9\xC3\xA9\xC3\xA9\xC3\xA9") == 0);
    utf8_shorten("\xC3\xA9\xC3\xA9\xC3\xA9\xC3\xA9", 3, out, sizeof out);
    CHECK(strcmp(out, "\xC3\xA9\xC3\xA9\xE2\x80\xA6") == 0);
}

static void markup_cannot_get_through(void)
{
    static const char text[] = "<b a='1' c=\"2\">&\n\t\x01\xFFz";
    bytes b = {0};
    CHECK_OK(markup_escape(&b, text, sizeof text - 1));
    CHECK(b.data && strcmp(b.data, "&lt;b a=&#39;1&#39; c=&quot;2&quot;&gt;&amp;\n\t ?z") == 0);
    bytes_free(&b);
    // a zero byte in the middle of a case's text is not its end
    CHECK_OK(markup_escape(&b, "a\0b", 3));
    CHECK(b.data && b.length == 3 && strcmp(b.data, "a b") == 0);
    bytes_free(&b);
}

static void bytes_grow_and_keep_their_end(void)
{
    bytes b = {0};
    for (int i = 0; i < 10000; i++) {
        CHECK_OK(bytes_format(&b, "%d,", i % 10));
    }
    CHECK(b.length == 20000 && b.data[20000] == 0 && strncmp(b.data + 18, "9,0,", 4) == 0);
    bytes_free(&b);
    CHECK(b.data == NULL && b.length == 0);
}

int main(void)
{
    only_whole_utf8_characters_are_counted();
    cleaning_leaves_text_that_any_terminal_may_see();
    shortening_counts_characters_not_bytes();
    markup_cannot_get_through();
    bytes_grow_and_keep_their_end();
    return test_failures != 0;
}
