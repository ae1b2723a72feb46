// reports/scene_page.c
#include "reports/scene_page.h"

#include <string.h>

// what ends a script or begins a comment there cannot stand in a text any more; line ends and the
// spaces after them, of which texts have none, are left off
static status put_data(const char *text, size_t length, bytes *page)
{
    status st = OK;
    for (size_t i = 0; i < length;) {
        const size_t plain = strcspn(text + i, "<\n");
        TRY(bytes_append(page, text + i, plain));
        i += plain;
        TRY(text[i] == '<' ? bytes_text(page, "\\u003c") : OK);
        i += text[i] == '\n' ? 1 + strspn(text + i + 1, " ") : 1;
    }

done:
    return st;
}

status scene_figure(const char *name, const char *text, size_t length, const char *caption,
                    bytes *page)
{
    status st = OK;
    TRY(bytes_text(page, "<figure class=\"view\">\n<p class=\"still\">The view that can be turned "
                         "needs a browser with JavaScript and WebGL. The pictures on this page "
                         "show the same.</p>\n<figcaption>"));
    TRY(bytes_text(page, caption));
    TRY(bytes_text(page, "</figcaption>\n<script type=\"application/json\" data-name=\""));
    TRY(markup_escape(page, name, strlen(name)));
    TRY(bytes_text(page, "\">"));
    TRY(put_data(text, length, page));
    TRY(bytes_text(page, "</script>\n</figure>\n"));

done:
    return st;
}
