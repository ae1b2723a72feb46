#include "io/config_defaults.h"

#include "io/case_tree.h"
#include "io/key_names.h"

#include <string.h>

static bool is_given(const node *map, const key_table *table, const key *k)
{
    for (const node *entry = map->first; entry; entry = entry->next) {
        const unit *u = NULL;
        const key *found = key_find(table, entry->key, &u);
        if (found && strcmp(found->name, k->name) == 0) {
            return true;
        }
    }
    return false;
}

static void tell_part(const node *map, const key_table *table, config_default *tell, void *self)
{
    for (int i = 0; i < table->nkey; i++) {
        const key *k = &table->keys[i];
        if (k->initial && k->initial[0] && !is_given(map, table, k)) {
            tell(self, map->key, k->name, k->initial);
        }
    }
}

void config_defaults(const config *cfg, const key_table *root, config_default *tell, void *self)
{
    for (int i = 0; cfg->root && cfg->root->kind == NODE_MAP && i < root->nkey; i++) {
        for (const node *entry = cfg->root->first; entry; entry = entry->next) {
            if (root->keys[i].kind == KEY_TABLE && entry->kind == NODE_MAP &&
                strcmp(entry->key, root->keys[i].name) == 0) {
                tell_part(entry, root->keys[i].table, tell, self);
            }
        }
    }
}
