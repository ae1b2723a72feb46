// reports/page_view.c
// Views in space within the page: what its policy lets run, and the scripts at its end.
#include "reports/page_kit.h"

#include "reports/base64.h"
#include "reports/scripts.h"

#include <string.h>

static const char notice[] =
    "<!--\n"
    "three.js, Copyright © 2010-2019 three.js authors, as Debian ships it.\n"
    "Permission is hereby granted, free of charge, to any person obtaining a copy of this software "
    "and associated documentation files (the \"Software\"), to deal in the Software without "
    "restriction, including without limitation the rights to use, copy, modify, merge, publish, "
    "distribute, sublicense, and/or sell copies of the Software, and to permit persons to whom the "
    "Software is furnished to do so, subject to the following conditions: The above copyright "
    "notice and this permission notice shall be included in all copies or substantial portions of "
    "the Software.\n"
    "THE SOFTWARE IS PROVIDED \"AS IS\", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR IMPLIED, "
    "INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY, FITNESS FOR A PARTICULAR "
    "PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR "
    "ANY CLAIM, DAMAGES OR OTHER LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, "
    "ARISING FROM, OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE "
    "SOFTWARE.\n"
    "-->\n";

static status put_hash(bytes *page, const script *s)
{
    status st = OK;
    PAGE(" 'sha256-");
    TRY(base64_append(page, s->sha256, sizeof s->sha256));
    PAGE("'");

done:
    return st;
}

status page_policy(bytes *page)
{
    status st = OK;
    PAGE("<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src "
         "'unsafe-inline'; img-src data:; base-uri 'none'; form-action 'none'; script-src");
    TRY(put_hash(page, &script_three));
    TRY(put_hash(page, &script_view));
    PAGE("\">\n");

done:
    return st;
}

static status put_script(bytes *page, const script *s)
{
    status st = OK;
    PAGE("<script>");
    TRY(bytes_append(page, s->text, (size_t)(s->end - s->text)));
    PAGE("</script>\n");

done:
    return st;
}

status page_scripts(bytes *page)
{
    status st = OK;
    // no text of a user's has a tag
    if (page->data && strstr(page->data, "<figure class=\"view\">")) {
        TRY(bytes_text(page, notice));
        PAGE("<script type=\"application/gzip\" id=\"three\">");
        TRY(base64_append(page, script_three.text, (size_t)(script_three.end - script_three.text)));
        PAGE("</script>\n");
        TRY(put_script(page, &script_view));
    }

done:
    return st;
}
