// SPDX-License-Identifier: MIT
// See schema.h. libyaml parses the tree with the line of every node; the tables define its meaning. yaml_limits.h
// bounds the cost of libyaml before it parses the text; the tables bound the depth here.
#include "io/schema.h"

#include "io/yaml_limits.h"
#include "formats/text.h"

#include <stdio.h>
#include <string.h>
#include <yaml.h>

enum { LIST_MAX_LENGTH = 512 };

typedef struct reader {
    const char *name, *text;
    size_t size;
    yaml_document_t document;
    const schema_target *targets;
    schema_given *given;
} reader;

// A node of the document. `map` is its path as the tables have it; `path` has the index of the list item too.
typedef struct place {
    char map[SCHEMA_PATH], path[SCHEMA_PATH];
    uint32_t item;
} place;

// Rows of the tables: one, or the components of a list of numbers.
typedef struct rows {
    const bolan_param *first;
    uint32_t count;
    void *desc;
} rows;

static unsigned line_of(const yaml_node_t *node) { return (unsigned)node->start_mark.line + 1; }

static yaml_node_t *node_at(reader *r, int index) { return yaml_document_get_node(&r->document, index); }

// The scalar of a node for a message: short.
static void describe(const yaml_node_t *node, char out[48]) {
    if (node->type == YAML_MAPPING_NODE || node->type == YAML_SEQUENCE_NODE) {
        snprintf(out, 48, "%s", node->type == YAML_MAPPING_NODE ? "a map" : "a list");
        return;
    }
    const char *text = (const char *)node->data.scalar.value; // libyaml puts a NUL behind it
    const size_t n = bolan_text_fit(text, 40);
    snprintf(out, 48, "%.*s%s", (int)n, text, n < node->data.scalar.length ? "..." : "");
    if (node->data.scalar.length == 0) snprintf(out, 48, "nothing");
}

static bolan_result refuse(const reader *r, const yaml_node_t *node, const char *path, const char *expected) {
    char found[48];
    describe(node, found);
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SCENE_BAD_VALUE, "%s:%u: %s is %s; expected %s", r->name, line_of(node),
              *path ? path : "the document", found, expected);
    return BOLAN_ERROR_FORMAT;
}

// ---- what is given --------------------------------------------------------------------------------------------------

uint32_t bolan_schema_line(const schema_given *given, const char *path) {
    for (uint32_t i = 0; i < given->count; i++)
        if (strcmp(given->entry[i].path, path) == 0) return given->entry[i].line;
    return 0;
}

static void remember(const reader *r, const char *path, uint32_t line) {
    schema_given *given = r->given;
    BOLAN_ASSERT(given->count < SCHEMA_MAX_GIVEN);
    if (given->count == SCHEMA_MAX_GIVEN) return;
    given->entry[given->count].line = line;
    snprintf(given->entry[given->count++].path, SCHEMA_PATH, "%s", path);
}

// ---- the tables -----------------------------------------------------------------------------------------------------

// The group's place in its struct, of a list in the element of @p item.
static void *desc_of(const schema_target *target, const bolan_param_group *group, uint32_t item) {
    return (char *)target->base + group->offset + item * group->stride;
}

static rows find_rows(const reader *r, const place *at) {
    for (int t = 0; t < SCHEMA_TARGETS; t++) {
        const bolan_param_group *group = NULL;
        rows found = {NULL, 0, NULL};
        found.first = bolan_param_find_key(r->targets[t].groups, at->map, &group, &found.count);
        if (!found.first) continue;
        found.desc = desc_of(&r->targets[t], group, at->item);
        return found;
    }
    return (rows){NULL, 0, NULL};
}

// The first group that is the list at @p map; NULL: it is no list.
static const bolan_param_group *find_list(const reader *r, const char *map) {
    for (int t = 0; t < SCHEMA_TARGETS; t++)
        for (const bolan_param_group *g = r->targets[t].groups; g->table; g++)
            if (g->capacity > 0 && strcmp(g->key, map) == 0) return g;
    return NULL;
}

// Whether @p key is a component of a list of words.
static bool is_child(const char *words, const char *key) {
    const size_t length = strlen(key);
    for (const char *w = words; *w; w += strcspn(w, ","), w += *w ? 2 : 0)
        if (strncmp(w, key, length) == 0 && (w[length] == ',' || w[length] == '\0')) return true;
    return false;
}

// ---- values ---------------------------------------------------------------------------------------------------------

static bolan_result scalar(const reader *r, const yaml_node_t *node, const bolan_param *p, const char *path,
                           void *desc) {
    char expected[LIST_MAX_LENGTH];
    if (node->type == YAML_SCALAR_NODE &&
        bolan_param_parse(p, (const char *)node->data.scalar.value, node->data.scalar.length, desc))
        return BOLAN_OK;
    bolan_param_expected(p, expected, sizeof expected);
    return refuse(r, node, path, expected);
}

static uint32_t list_length(const yaml_node_t *node) {
    if (node->type != YAML_SEQUENCE_NODE) return UINT32_MAX;
    return (uint32_t)(node->data.sequence.items.top - node->data.sequence.items.start);
}

// A list of numbers; a number that is refused is named by its field: "camera.position.z".
static bolan_result vector(reader *r, yaml_node_t *node, const rows *found, const char *path) {
    char text[2 * SCHEMA_PATH];
    if (list_length(node) != found->count) {
        snprintf(text, sizeof text, "a list of %u numbers", (unsigned)found->count);
        return refuse(r, node, path, text);
    }
    for (uint32_t i = 0; i < found->count; i++) {
        const bolan_param *p = &found->first[i];
        const char *dot = strrchr(p->field, '.');
        snprintf(text, sizeof text, "%s.%s", path, dot ? dot + 1 : p->field);
        if (scalar(r, node_at(r, node->data.sequence.items.start[i]), p, text, found->desc)) return BOLAN_ERROR_FORMAT;
    }
    return BOLAN_OK;
}

// A list of names is read as their text with commas.
static bolan_result set(reader *r, yaml_node_t *node, const bolan_param *p, const char *path, void *desc) {
    const uint32_t length = list_length(node);
    char text[LIST_MAX_LENGTH] = "", expected[LIST_MAX_LENGTH];
    if (node->type == YAML_SCALAR_NODE) return scalar(r, node, p, path, desc);
    bool good = node->type == YAML_SEQUENCE_NODE;
    for (uint32_t i = 0; good && i < length; i++) {
        const yaml_node_t *item = node_at(r, node->data.sequence.items.start[i]);
        const size_t used = strlen(text);
        good = item->type == YAML_SCALAR_NODE && used + item->data.scalar.length + 3 < sizeof text;
        if (good) snprintf(text + used, sizeof text - used, "%s%s", i ? ", " : "", (char *)item->data.scalar.value);
    }
    if (good && length == 0) snprintf(text, sizeof text, "none");
    if (good && bolan_param_parse(p, text, strlen(text), desc)) return BOLAN_OK;
    bolan_param_expected(p, expected, sizeof expected);
    return refuse(r, node, path, expected);
}

static bolan_result map(reader *r, yaml_node_t *node, const place *at);

// Each element starts with its defaults.
static void start_item(const reader *r, const place *at) {
    for (int t = 0; t < SCHEMA_TARGETS; t++)
        for (const bolan_param_group *g = r->targets[t].groups; g->table; g++)
            if (g->capacity > 0 && strcmp(g->key, at->map) == 0)
                bolan_params_default(g->table, desc_of(&r->targets[t], g, at->item));
}

static bolan_result check_required(const reader *r, const yaml_node_t *node, const place *at) {
    char path[2 * SCHEMA_PATH], expected[LIST_MAX_LENGTH];
    for (int t = 0; t < SCHEMA_TARGETS; t++)
        for (const bolan_param_group *g = r->targets[t].groups; g->table; g++)
            for (uint32_t i = 0; i < g->table->count && strcmp(g->key, at->map) == 0; i++) {
                const bolan_param *p = &g->table->params[i];
                if (!(p->rules & BOLAN_PARAM_REQUIRED)) continue;
                snprintf(path, sizeof path, "%s.%s", at->path, p->key);
                if (bolan_schema_line(r->given, path)) continue;
                bolan_param_expected(p, expected, sizeof expected);
                bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SCENE_BAD_VALUE, "%s:%u: %s needs %s; expected %s", r->name,
                          line_of(node), at->path, p->key, expected);
                return BOLAN_ERROR_FORMAT;
            }
    return BOLAN_OK;
}

static bolan_result list(reader *r, yaml_node_t *node, const bolan_param_group *group, const place *at) {
    const uint32_t length = list_length(node);
    if (length > group->capacity) {
        char expected[64];
        snprintf(expected, sizeof expected, "a list of at most %u maps", (unsigned)group->capacity);
        return refuse(r, node, at->path, expected);
    }
    for (uint32_t i = 0; i < length; i++) {
        place item = *at;
        item.item = i;
        snprintf(item.path, sizeof item.path, "%.30s[%u]", at->path, (unsigned)i);
        yaml_node_t *element = node_at(r, node->data.sequence.items.start[i]);
        start_item(r, &item);
        if (map(r, element, &item) || check_required(r, element, &item)) return BOLAN_ERROR_FORMAT;
    }
    for (int t = 0; t < SCHEMA_TARGETS; t++)
        for (const bolan_param_group *g = r->targets[t].groups; g->table; g++)
            if (g == group) memcpy((char *)r->targets[t].base + g->count_offset, &length, sizeof length);
    return BOLAN_OK;
}

static bolan_result value(reader *r, yaml_node_t *node, const place *at) {
    const rows found = find_rows(r, at);
    const bolan_param_group *group = find_list(r, at->map);
    if (!found.first) return group ? list(r, node, group, at) : map(r, node, at);
    remember(r, at->path, line_of(node));
    if (found.count > 1) return vector(r, node, &found, at->path);
    if (found.first->kind == BOLAN_PARAM_SET) return set(r, node, found.first, at->path, found.desc);
    return scalar(r, node, found.first, at->path, found.desc);
}

// ---- maps -----------------------------------------------------------------------------------------------------------

static bolan_result unknown_key(const reader *r, const yaml_node_t *node, const char *path, const char *expected) {
    char found[48];
    describe(node, found);
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SCENE_UNKNOWN_KEY, "%s:%u: unknown key %s%s%s; expected %s%s", r->name,
              line_of(node), path, *path ? "." : "", found, *expected ? "one of " : "none", expected);
    return BOLAN_ERROR_FORMAT;
}

static bool is_key(const yaml_node_t *node, const char *expected) {
    if (node->type != YAML_SCALAR_NODE) return false;
    const size_t length = node->data.scalar.length;
    const char *key = (const char *)node->data.scalar.value;
    return length > 0 && length < SCHEMA_PATH / 2 && strlen(key) == length && !strpbrk(key, ".,") &&
           is_child(expected, key);
}

static bolan_result entry(reader *r, const yaml_node_pair_t *pair, const char *expected, const place *at) {
    yaml_node_t *key_node = node_at(r, pair->key);
    if (!is_key(key_node, expected)) return unknown_key(r, key_node, at->path, expected);
    const char *key = (const char *)key_node->data.scalar.value;
    place inner = {.item = at->item};
    snprintf(inner.map, sizeof inner.map, "%.20s%s%.21s", at->map, *at->map ? "." : "", key);
    snprintf(inner.path, sizeof inner.path, "%.20s%s%.21s", at->path, *at->path ? "." : "", key);
    if (bolan_schema_line(r->given, inner.path)) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SCENE_BAD_VALUE, "%s:%u: %s is given twice; expected once", r->name,
                  line_of(key_node), inner.path);
        return BOLAN_ERROR_FORMAT;
    }
    return value(r, node_at(r, pair->value), &inner);
}

static bool is_null(const yaml_node_t *node) { return node->type == YAML_SCALAR_NODE && node->data.scalar.length == 0; }

static bolan_result map(reader *r, yaml_node_t *node, const place *at) {
    char expected[LIST_MAX_LENGTH] = "";
    remember(r, at->path, line_of(node));
    if (is_null(node)) return BOLAN_OK; // "island:" alone: the map is there, with every default
    if (node->type != YAML_MAPPING_NODE) return refuse(r, node, at->path, "a map of keys and values");
    for (int t = 0; t < SCHEMA_TARGETS; t++)
        bolan_param_list_keys(r->targets[t].groups, at->map, expected, sizeof expected);
    for (yaml_node_pair_t *pair = node->data.mapping.pairs.start; pair < node->data.mapping.pairs.top; pair++)
        if (entry(r, pair, expected, at)) return BOLAN_ERROR_FORMAT;
    return BOLAN_OK;
}

// ---- the document ---------------------------------------------------------------------------------------------------

static bolan_result no_memory(const char *name) {
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "%s: no memory for the YAML parser", name);
    return BOLAN_ERROR_MEMORY;
}

// For an error of the reader (bytes that are no UTF-8) libyaml states the offset, not the line.
static unsigned line_at(const char *text, size_t size, size_t offset) {
    unsigned line = 1;
    for (size_t i = 0; i < size && i < offset; i++) line += text[i] == '\n';
    return line;
}

static bolan_result syntax_error(const reader *r, const yaml_parser_t *parser) {
    if (parser->error == YAML_MEMORY_ERROR) return no_memory(r->name);
    const unsigned last = line_at(r->text, r->size, r->size > 0 ? r->size - 1 : 0);
    unsigned line = parser->error == YAML_READER_ERROR ? line_at(r->text, r->size, parser->problem_offset)
                                                       : (unsigned)parser->problem_mark.line + 1;
    if (line > last) line = last; // libyaml puts the end of the text into a line of its own
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SCENE_SYNTAX, "%s:%u: not YAML: %s", r->name, line,
              parser->problem ? parser->problem : "it cannot be understood");
    return BOLAN_ERROR_FORMAT;
}

static bolan_result read_root(reader *r) {
    const place document = {.item = 0};
    yaml_node_t *root = yaml_document_get_root_node(&r->document);
    return root ? map(r, root, &document) : BOLAN_OK;
}

// A second document in the file is refused, because it would be ignored.
static bolan_result expect_end(const reader *r, yaml_parser_t *parser) {
    yaml_document_t next;
    if (!yaml_parser_load(parser, &next)) return syntax_error(r, parser);
    const yaml_node_t *root = yaml_document_get_root_node(&next);
    const bolan_result result = root ? refuse(r, root, "a second document", "one document in the file") : BOLAN_OK;
    yaml_document_delete(&next);
    return result;
}

bolan_result bolan_schema_read(const char *name, const char *text, size_t size,
                               const schema_target targets[SCHEMA_TARGETS], schema_given *given) {
    yaml_parser_t parser;
    if (bolan_yaml_check_limits(name, text, size)) return BOLAN_ERROR_FORMAT;
    if (!yaml_parser_initialize(&parser)) return no_memory(name);
    yaml_parser_set_input_string(&parser, (const unsigned char *)text, size);
    reader r = {.name = name, .text = text, .size = size, .targets = targets, .given = given};
    given->count = 0;
    bolan_result result;
    if (!yaml_parser_load(&parser, &r.document)) {
        result = syntax_error(&r, &parser);
    } else {
        const bool empty = !yaml_document_get_root_node(&r.document);
        result = read_root(&r);
        if (!result && !empty) result = expect_end(&r, &parser);
        yaml_document_delete(&r.document);
    }
    yaml_parser_delete(&parser);
    return result;
}
