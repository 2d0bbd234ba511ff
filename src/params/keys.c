// SPDX-License-Identifier: MIT
// Lookup of the dotted keys of scene files in groups of tables.
#include "bolan/params.h"

#include <stdio.h>
#include <string.h>

// The rest of the dotted @p path below @p map ("" the document); NULL where it does not lie below.
static const char *below(const char *map, const char *path) {
    const size_t length = strlen(map);
    if (length == 0) return path;
    return strncmp(map, path, length) == 0 && path[length] == '.' ? path + length + 1 : NULL;
}

const bolan_param *bolan_param_find_key(const bolan_param_group *groups, const char *path,
                                        const bolan_param_group **group, uint32_t *count) {
    BOLAN_ASSERT(groups && path && count);
    for (const bolan_param_group *g = groups; g->table; g++) {
        const char *key = below(g->key, path);
        const bolan_param *end = g->table->params + g->table->count;
        for (const bolan_param *p = g->table->params; key && p < end; p++) {
            if (!p->key || strcmp(p->key, key) != 0) continue;
            if (group) *group = g;
            for (*count = 1; p + *count < end && p[*count].key && strcmp(p[*count].key, key) == 0;) ++*count;
            return p;
        }
    }
    return NULL;
}

// Adds the component of @p path that follows @p map to the words, once.
static void add_child(const char *map, const char *path, char *words, size_t capacity) {
    const char *child = *path ? below(map, path) : NULL;
    if (!child) return;
    const size_t length = strcspn(child, "."), used = strlen(words);
    for (const char *w = words; *w; w += strcspn(w, ","), w += strspn(w, ", "))
        if (strncmp(w, child, length) == 0 && (w[length] == ',' || w[length] == '\0')) return;
    snprintf(words + used, capacity - used, "%s%.*s", used ? ", " : "", (int)length, child);
}

void bolan_param_list_keys(const bolan_param_group *groups, const char *map, char *words, size_t capacity) {
    BOLAN_ASSERT(groups && map && words && capacity > 0);
    for (const bolan_param_group *g = groups; g->table; g++) {
        char path[128];
        for (uint32_t i = 0; i < g->table->count; i++) {
            if (!g->table->params[i].key) continue;
            snprintf(path, sizeof path, "%s%s%s", g->key, *g->key ? "." : "", g->table->params[i].key);
            add_child(map, path, words, capacity);
        }
        add_child(map, g->key, words, capacity);
    }
}
