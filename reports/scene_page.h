// reports/scene_page.h
#pragma once

#include "reports/markup.h"

// The page's element of a scene, whose JSON document is `text`.
status scene_figure(const char *name, const char *text, size_t length, const char *caption,
                    bytes *page);
