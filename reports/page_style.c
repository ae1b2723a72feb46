// reports/page_style.c
// The frame of the page: one style sheet for the screen, by day and night, the phone and the
// printer; scripts for its views only, nothing from outside.
#include "reports/page_kit.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const style[] = {
    ":root{--ink:#20262f;--soft:#5b6470;--line:#dfe3e8;--tint:#f5f7f9;--accent:#00588f;--bad:#"
    "b3261e;"
    "--good:#1c6b48;--warn:#7a4b00;--none:#68727d;--paper:#fff}\n",
    "@media screen and (prefers-color-scheme:dark){:root{color-scheme:dark;--ink:#e4e8ed;--soft:#"
    "a3adb8;--line:#39424c;--tint:#1e242b;--accent:#6db3e6;--bad:#ff8a80;--good:#6fd0a4;--none:#"
    "8a949f;--paper:#"
    "14181d}"
    ":root{--warn:#f2c879}figure:not(.view){background:#fff;--soft:#5b6470}html "
    ".warn{background:#3a2c10}}\n",
    "*{box-sizing:border-box}\n"
    "html{-webkit-text-size-adjust:100%}\n"
    "body{margin:0;background:var(--paper);color:var(--ink);font:16px/1.55 "
    "system-ui,-apple-system,'Segoe "
    "UI',"
    "'DejaVu Sans',sans-serif}\n"
    "main,header>div,footer>div{max-width:1180px;margin:0 auto;padding:0 20px}\n",
    "header{background:#16324a;color:#fff;padding:30px 0 26px}\n"
    "header p{margin:6px 0 0;color:#c8d7e4}\n"
    "h1{font-size:1.75rem;line-height:1.2;margin:0;overflow-wrap:anywhere}\n"
    "h2{font-size:1.3rem;margin:2.6rem 0 .5rem;padding-top:.9rem;border-top:2px solid var(--ink)}\n"
    "h3{font-size:1rem;margin:1.6rem 0 .4rem}\n"
    "p{margin:.5rem 0;max-width:46rem}\n",
    "nav{margin-top:14px}nav a{color:#fff;margin-right:16px;white-space:nowrap}\n"
    "dl.key{display:grid;grid-template-columns:repeat(auto-fit,minmax(158px,1fr));gap:12px;margin:"
    "24px 0 0}\n"
    "dl.key div{background:var(--tint);border:1px solid var(--line);border-radius:6px;padding:10px "
    "14px}\n"
    "dl.key dt{color:var(--soft);font-size:.82rem}\n"
    "dl.key dd{margin:2px 0 "
    "0;font-size:1.18rem;font-weight:600;font-variant-numeric:tabular-nums}\n"
    "dl.key small{font-weight:400;font-size:.82rem;color:var(--soft)}dl.key "
    "a{display:block;font-weight:400;font-size:.82rem;color:var(--warn)}\n",
    ".scroll{overflow-x:auto;margin:.8rem 0}\n"
    "table{border-collapse:collapse;font-size:.86rem;font-variant-numeric:tabular-nums;min-width:"
    "100%}\n"
    "caption{caption-side:top;text-align:left;color:var(--soft);padding:0 max(0px,100% - 100vw + "
    "40px) 6px 0}\n"
    "th,td{padding:6px 12px;text-align:right;border-bottom:1px solid "
    "var(--line);vertical-align:top;"
    "white-space:nowrap}\n"
    "th{font-weight:600;border-bottom:1.5px solid var(--ink);white-space:normal}\n"
    "th small,td small{display:block;font-weight:400;color:var(--soft)}\n"
    "tbody th{border-bottom:1px solid var(--line)}\n"
    "th:first-child,td:first-child,.text{text-align:left}\n"
    "td.text{white-space:normal;min-width:11rem}\n"
    "td.zero{color:var(--none)}td.unit{text-align:left}\n",
    "figure{margin:1.2rem 0;overflow-x:auto;border:1px solid "
    "var(--line);border-radius:6px;padding:6px}\n"
    "figure svg,figure img{display:block;width:calc(100%*var(--part,1));height:auto;"
    "min-width:calc(620px*var(--part,1))}\n"
    "figcaption{color:var(--soft);font-size:.86rem;padding:4px 8px 6px;position:sticky;left:0}\n"
    ".good{color:var(--good);font-weight:600}.bad{color:var(--bad);font-weight:600}"
    ".skip{color:var(--soft)}\n"
    ".note{border-left:4px solid var(--accent);background:var(--tint);padding:10px "
    "14px;border-radius:0 6px 6px 0}\n"
    ".warn{border-left-color:#d08a00;background:#fff6e3;color:var(--warn)}\n"
    "pre{background:var(--tint);border:1px solid "
    "var(--line);border-radius:6px;padding:14px;overflow-x:auto;"
    "font:.84rem/1.5 ui-monospace,'DejaVu Sans Mono',monospace}\n"
    "footer{margin-top:3rem;border-top:1px solid "
    "var(--line);color:var(--soft);font-size:.86rem;padding:16px 0 30px}\n",
    ".view{overflow:visible}.view "
    ".stage{position:relative;height:min(70vh,620px,105vw);min-height:300px;"
    "background:var(--tint);overflow:hidden;touch-action:none;cursor:grab;border-radius:4px}\n"
    ".view .stage:focus-visible{outline:3px solid var(--accent)}.view "
    "canvas{display:block;width:100%;"
    "height:100%}\n"
    ".view "
    ".label{position:absolute;left:0;top:0;font-size:.75rem;font-weight:600;pointer-events:none;"
    "white-space:nowrap;text-shadow:0 0 3px var(--paper),0 0 3px var(--paper)}\n"
    ".view .controls,.view .keys{display:flex;flex-wrap:wrap;gap:6px "
    "18px;align-items:center;margin:"
    "8px;padding:0;font-size:.9rem}.view .controls select{max-width:60vw}.view .controls "
    "input,.view .controls select{vertical-align:middle}\n"
    ".view .keys{list-style:none;font-size:.84rem;color:var(--soft)}.view .keys "
    "i{display:inline-block;"
    "width:1em;height:.8em;margin-right:5px;border-radius:2px}.view .keys .ramp{width:6em;margin:0 "
    "4px}\n"
    ".view .words{margin:8px;min-height:3.2em}.view[data-state=live] "
    ".still,.view[data-state=still] .stage{display:none}"
    ".view .label[hidden],.view .controls [hidden],.view[data-state=waiting] .still{display:none}"
    ".view[data-state=waiting]::before{content:'This view is drawn when it comes into sight.';"
    "display:block;padding:8px;color:var(--soft)}\n",
    ".band{display:inline-block;width:6em;height:.7em;border:1px solid var(--soft);border-radius:"
    "2px}.band i{display:block;height:100%;background:var(--good)}.band .out{background:var(--bad)}"
    "@media print{.band,.band i{print-color-adjust:exact}}\n",
    ".over{fill:none;stroke:none;pointer-events:all;cursor:help;outline:none}.over "
    "text{visibility:hidden;fill:#20262f;font:600 12px "
    "system-ui,'DejaVu Sans',sans-serif}.over:hover text,.over:focus text{visibility:visible}"
    ".over:focus .mark,.over:hover .mark{stroke:#00588f;stroke-width:3}\n",
    "@media(max-width:600px){h1{font-size:1.35rem}th,td{padding:5px 8px}}\n"
    "@media print{.view{display:none}}\n",
    "@media "
    "print{body{font-size:10.5pt}header{background:#fff;color:#000;padding:0;border-bottom:2px "
    "solid #000}"
    "header "
    "p{color:#333}nav{display:none}h2{break-after:avoid}figure,tr,dl.key{break-inside:avoid}"
    "caption{break-after:avoid}table{font-size:7.5pt}.band{width:3em}figcaption,.note{break-inside:"
    "avoid}"
    "figure,.scroll{overflow:visible}figure svg,figure "
    "img{min-width:0}pre{white-space:pre-wrap}td.text{min-width:8em}"
    "th,td{padding:2px 4px;white-space:normal}.good,.bad{white-space:nowrap}}\n",
};

status page_escaped(bytes *page, const char *text)
{
    return markup_escape(page, text, strlen(text));
}

status page_open(bytes *page, const char *title)
{
    status st = OK;

    PAGE("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n");
    TRY(page_policy(page));
    PAGE("<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>");
    TRY(page_escaped(page, title));
    PAGE(" – stiffaxis</title>\n<style>\n");
    for (size_t i = 0; i < sizeof style / sizeof *style; i++) {
        TRY(bytes_text(page, style[i]));
    }
    PAGE("</style>\n</head>\n<body>\n");

done:
    return st;
}

status page_close(bytes *page)
{
    status st = OK;
    TRY(page_scripts(page));
    TRY(bytes_text(page, "</body>\n</html>\n"));

done:
    return st;
}
