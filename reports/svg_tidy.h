// reports/svg_tidy.h
// cairo's SVG made fit for us: ids that say whose they are, so that several pictures live in one
// page, and that do not count what the process drew before; a title; properties at their initial
// values left off.
#pragma once

#include "reports/markup.h"

// name: in front of every id. title: of the document, escaped here. unit: how many mm a pixel of
// cairo's is on paper; the document's size is told in mm.
status svg_tidy(const bytes *raw, const char *name, const char *title, double unit, bytes *out);

// Where the <svg> element begins: what a page takes in. NULL when there is none.
const char *svg_element(const char *document);
