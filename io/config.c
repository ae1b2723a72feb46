// io/config.c
#include "io/config.h"

#include "base/memory.h"
#include "io/case_text.h"
#include "io/case_tree.h"
#include "io/override.h"
#include "io/yaml_door.h"

#include <stdio.h>
#include <string.h>

// those of `opened` first
static status copy_overrides(config *cfg, const config *opened, int count,
                             const char *const *overrides)
{
    status st = OK;
    const int before = opened ? opened->noverride : 0;
    TRY(ARENA_TAKE(cfg->memory, cfg->overrides, (size_t)(before + count)));
    cfg->noverride = before + count;
    for (int i = 0; i < before + count; i++) {
        const char *text = i < before ? opened->overrides[i] : overrides[i - before];
        TRY(arena_copy(cfg->memory, text, strlen(text), &cfg->overrides[i]));
    }

done:
    return st;
}

static status read_tree(config *cfg)
{
    status st = OK;
    TRY(case_text_kind(cfg));
    TRY(case_text_check(cfg, cfg->text, cfg->length, -1));
    TRY(yaml_read(cfg, cfg->text, cfg->length, -1, &cfg->root));
    if (!cfg->root) {
        TRY(config_fail(cfg, (mark){1, 1}, "the case is empty"));
    }
    if (cfg->root->kind != NODE_MAP) {
        TRY(config_fail(cfg, cfg->root->at, "a case is a map of keys (`format: 1` ...), not a %s",
                        cfg->root->kind == NODE_LIST ? "list" : "single value"));
    }
    TRY(override_apply(cfg));

done:
    return st;
}

static status copy_text(const config *from, config *cfg)
{
    status st = OK;
    TRY(TAKE(cfg->text, from->length + 1)); // ends with 0
    memcpy(cfg->text, from->text, from->length);
    cfg->length = from->length;

done:
    return st;
}

// opened: where the text comes from; NULL: the file
static status open_config(const char *path, const config *opened, int noverride,
                          const char *const *overrides, config **out)
{
    status st = OK;
    config *cfg = NULL;
    *out = NULL;
    TRY(TAKE(cfg, 1));
    TRY(arena_make(&cfg->memory));
    TRY(calculator_make(&cfg->arithmetic));
    TRY(TAKE(cfg->path, strlen(path) + 1));
    memcpy(cfg->path, path, strlen(path));
    TRY(copy_overrides(cfg, opened, noverride, overrides));
    TRY(opened ? copy_text(opened, cfg) : case_text_load(cfg));
    TRY(read_tree(cfg));
    *out = cfg;
    cfg = NULL;

done:
    config_free(cfg);
    return st;
}

status config_open(const char *path, int noverride, const char *const *overrides, config **out)
{
    return open_config(path, NULL, noverride, overrides, out);
}

status config_open_again(const config *opened, int noverride, const char *const *overrides,
                         config **out)
{
    return open_config(opened->path, opened, noverride, overrides, out);
}

status config_open_text(const char *path, const char *text, int noverride,
                        const char *const *overrides, config **out)
{
    char *same = NULL;
    status st = OK;
    const size_t length = strlen(text);
    if (length > CONFIG_MAX_BYTES) {
        return status_fail(ERR_INPUT, "%s:1:1: error: the text is larger than %d MB: not a case",
                           path, CONFIG_MAX_BYTES >> 20);
    }
    TRY(TAKE(same, length + 1));
    memcpy(same, text, length);
    TRY(open_config(path, &(config){.text = same, .length = length}, noverride, overrides, out));

done:
    free(same);
    return st;
}

void config_free(config *cfg)
{
    if (cfg) {
        calculator_free(cfg->arithmetic);
        arena_free(cfg->memory);
        free(cfg->text);
        free(cfg->path);
    }
    free(cfg);
}

const char *config_path(const config *cfg)
{
    return cfg->path;
}

const char *config_text(const config *cfg, size_t *length)
{
    *length = cfg->length;
    return cfg->text;
}

void config_set_length(config *cfg, double L_m)
{
    cfg->length_m = L_m;
    cfg->has_length = true;
}
