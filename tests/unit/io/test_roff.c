// tests/unit/io/test_roff.c
// Text in a manual page shows as it is, whatever troff would make of it.
#include "io/roff.h"
#include "tests/test.h"

#include <string.h>

static char written[1024];

typedef void writer(FILE *stream, const char *text);

static const char *by(writer *write, const char *text)
{
    FILE *stream = fmemopen(written, sizeof written, "w");
    write(stream, text);
    (void)fclose(stream);
    return written;
}

static void requests_and_escapes_lose_their_meaning(void)
{
    CHECK(strcmp(by(roff_line, ".so /etc/passwd"), "\\&.so /etc/passwd") == 0);
    CHECK(strcmp(by(roff_line, "'br"), "\\(aqbr") == 0);
    CHECK(strcmp(by(roff_line, "a\\fBb"), "a\\efBb") == 0);
    CHECK(strcmp(by(roff_line, "--set"), "\\-\\-set") == 0);
    CHECK(strcmp(by(roff_line, "x^2 ~ `a` \"b\""), "x\\(ha2 \\(ti \\(gaa\\(ga \\(dqb\\(dq") == 0);
    CHECK(strcmp(by(roff_text, "first\n.second"), "first\n\\&.second") == 0);
    CHECK(strcmp(by(roff_line, "0.5"), "0.5") == 0); // within a line a dot is a dot
}

static void long_text_is_laid_over_lines_and_terms_are_not(void)
{
    const char *text = "a line that is a good deal longer than what an editor of manual pages "
                       "would like .so that it is parted";
    const char *lines = by(roff_text, text);
    for (const char *p = lines; p; p = strchr(p, '\n')) {
        p += *p == '\n';
        CHECK(strcspn(p, "\n") <= 80);
        CHECK(*p != '.');
    }
    CHECK(strchr(by(roff_line, text), '\n') == NULL);
}

int main(void)
{
    requests_and_escapes_lose_their_meaning();
    long_text_is_laid_over_lines_and_terms_are_not();
    return test_failures != 0;
}
