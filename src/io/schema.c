// SPDX-License-Identifier: MIT
// See schema.h. libyaml gives the tree with the line of every node; the tables give it meaning. What libyaml itself may
// cost is bounded before it sees the text (yaml_limits.h); depth here is bounded by the tables.
#include "io/schema.h"

#include "io/yaml_limits.h"
#include "spectrum/text.h"

#include <stdio.h>
#include <string.h>
#include <yaml.h>

enum { PATH_MAX_LENGTH = 96, LIST_MAX_LENGTH = 512 };

typedef struct reader {
    const char *name, *text;
    size_t size;
    yaml_document_t document;
} reader;

static unsigned line_of(const yaml_node_t *node) { return (unsigned)node->start_mark.line + 1; }

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

// ---- scalars --------------------------------------------------------------------------------------------------------

static bool read_number(const yaml_node_t *node, double *value) {
    if (node->type != YAML_SCALAR_NODE) return false;
    return bolan_parse_number((const char *)node->data.scalar.value, node->data.scalar.length, value);
}

static bolan_result number(const reader *r, const yaml_node_t *node, const schema_key *key, const char *path,
                           double *out) {
    double value = 0.0;
    if (read_number(node, &value) && value >= key->low && value <= key->high) {
        *out = value;
        return BOLAN_OK;
    }
    char expected[80];
    bolan_format(expected, sizeof expected, "a number from %g to %g%s%s", key->low, key->high, key->unit ? " " : "",
                 key->unit ? key->unit : "");
    return refuse(r, node, path, expected);
}

// Digits alone, every one counts: a double would change numbers beyond 2^53.
static bool read_digits(const yaml_node_t *node, uint64_t *value) {
    if (node->type != YAML_SCALAR_NODE || node->data.scalar.length == 0) return false;
    *value = 0;
    for (size_t i = 0; i < node->data.scalar.length; i++) {
        const unsigned char c = node->data.scalar.value[i];
        if (c < '0' || c > '9' || *value > (UINT64_MAX - (uint64_t)(c - '0')) / 10) return false;
        *value = 10 * *value + (uint64_t)(c - '0');
    }
    return true;
}

static bolan_result count(const reader *r, const yaml_node_t *node, const schema_key *key, const char *path,
                          uint64_t *out) {
    uint64_t value = 0;
    if (read_digits(node, &value) && (double)value >= key->low && (double)value <= key->high) {
        *out = value;
        return BOLAN_OK;
    }
    char expected[80];
    bolan_format(expected, sizeof expected, "a whole number from %.0f to %llu", key->low,
                 key->high < 0x1p64 ? (unsigned long long)key->high : (unsigned long long)UINT64_MAX);
    return refuse(r, node, path, expected);
}

static void append(char *list, size_t capacity, const char *word) {
    const size_t used = strlen(list);
    snprintf(list + used, capacity - used, "%s%s", used ? ", " : "", word);
}

static bolan_result name(const reader *r, const yaml_node_t *node, const schema_key *key, const char *path, int *out) {
    char expected[LIST_MAX_LENGTH] = "";
    for (int i = 0; key->names[i]; i++) {
        if (node->type == YAML_SCALAR_NODE &&
            bolan_text_equals((text_word){(const char *)node->data.scalar.value, node->data.scalar.length, 0},
                              key->names[i])) {
            *out = i;
            return BOLAN_OK;
        }
        append(expected, sizeof expected, key->names[i]);
    }
    return refuse(r, node, path, expected);
}

static bolan_result flag(const reader *r, const yaml_node_t *node, const char *path, bool *out) {
    static const char *const words[] = {"false", "true", "no", "yes", "off", "on"};
    for (int i = 0; i < 6 && node->type == YAML_SCALAR_NODE; i++) {
        if (!bolan_text_equals((text_word){(const char *)node->data.scalar.value, node->data.scalar.length, 0},
                               words[i]))
            continue;
        *out = i % 2 == 1;
        return BOLAN_OK;
    }
    return refuse(r, node, path, "true or false");
}

static bolan_result text(const reader *r, const yaml_node_t *node, const schema_key *key, const char *path, char *out) {
    const size_t length = node->type == YAML_SCALAR_NODE ? node->data.scalar.length : 0;
    if (length == 0 || length >= key->capacity || memchr(node->data.scalar.value, '\0', length)) {
        char expected[64];
        snprintf(expected, sizeof expected, "a text of 1 to %u characters", (unsigned)key->capacity - 1);
        return refuse(r, node, path, expected);
    }
    memcpy(out, node->data.scalar.value, length);
    out[length] = '\0';
    return BOLAN_OK;
}

// ---- collections ----------------------------------------------------------------------------------------------------

static bolan_result map(reader *r, yaml_node_t *node, const schema_key *keys, const char *path, char *out);

static yaml_node_t *node_at(reader *r, int index) { return yaml_document_get_node(&r->document, index); }

static uint32_t list_length(const yaml_node_t *node) {
    if (node->type != YAML_SEQUENCE_NODE) return UINT32_MAX;
    return (uint32_t)(node->data.sequence.items.top - node->data.sequence.items.start);
}

static bolan_result vector(reader *r, yaml_node_t *node, const schema_key *key, const char *path, double *out) {
    if (list_length(node) != key->capacity) {
        char expected[64];
        snprintf(expected, sizeof expected, "a list of %u numbers", (unsigned)key->capacity);
        return refuse(r, node, path, expected);
    }
    for (uint32_t i = 0; i < key->capacity; i++)
        if (number(r, node_at(r, node->data.sequence.items.start[i]), key, path, &out[i])) return BOLAN_ERROR_FORMAT;
    return BOLAN_OK;
}

// Adds the bit of one name; false when there is none of that name.
static bool add_name(const schema_key *key, text_word word, uint32_t *bits) {
    for (int i = 0; key->names[i]; i++)
        if (bolan_text_equals(word, key->names[i])) return *bits |= 1u << i, true;
    return false;
}

static bool add_words(const schema_key *key, const yaml_node_t *node, uint32_t *bits) {
    const char *at = (const char *)node->data.scalar.value, *end = at + node->data.scalar.length;
    while (at < end) {
        const char *stop = at;
        while (stop < end && *stop != ',' && *stop != ' ') stop++;
        if (stop > at && !add_name(key, (text_word){at, (size_t)(stop - at), 0}, bits)) return false;
        at = stop + 1;
    }
    return true;
}

static bolan_result set(reader *r, yaml_node_t *node, const schema_key *key, const char *path, uint32_t *out) {
    uint32_t bits = 0, all = 0;
    char expected[LIST_MAX_LENGTH] = "all, none, or some of ";
    for (int i = 0; key->names[i]; i++) {
        all |= 1u << i;
        const size_t used = strlen(expected);
        snprintf(expected + used, sizeof expected - used, "%s%s", i ? ", " : "", key->names[i]);
    }
    bool good = node->type == YAML_SEQUENCE_NODE;
    for (uint32_t i = 0; good && i < list_length(node); i++) {
        const yaml_node_t *item = node_at(r, node->data.sequence.items.start[i]);
        good = item->type == YAML_SCALAR_NODE && add_words(key, item, &bits);
    }
    if (node->type == YAML_SCALAR_NODE && node->data.scalar.length > 0) {
        const text_word word = {(const char *)node->data.scalar.value, node->data.scalar.length, 0};
        good = bolan_text_equals(word, "none") || bolan_text_equals(word, "all") || add_words(key, node, &bits);
        if (bolan_text_equals(word, "all")) bits = all;
    }
    if (!good) return refuse(r, node, path, expected);
    *out = bits;
    return BOLAN_OK;
}

static bolan_result list(reader *r, yaml_node_t *node, const schema_key *key, const char *path, char *out) {
    const uint32_t length = list_length(node);
    if (length > key->capacity) {
        char expected[64];
        snprintf(expected, sizeof expected, "a list of at most %u maps", (unsigned)key->capacity);
        return refuse(r, node, path, expected);
    }
    for (uint32_t i = 0; i < length; i++) {
        char item[PATH_MAX_LENGTH];
        snprintf(item, sizeof item, "%.64s[%u]", path, (unsigned)i);
        if (map(r, node_at(r, node->data.sequence.items.start[i]), key->keys, item,
                out + key->offset + i * key->stride))
            return BOLAN_ERROR_FORMAT;
    }
    memcpy(out + key->count_offset, &length, sizeof length);
    return BOLAN_OK;
}

static bolan_result value(reader *r, yaml_node_t *node, const schema_key *key, const char *path, char *out) {
    void *member = out + key->offset;
    switch (key->kind) {
    case SCHEMA_NUMBER: return number(r, node, key, path, member);
    case SCHEMA_COUNT: return count(r, node, key, path, member);
    case SCHEMA_NAME: return name(r, node, key, path, member);
    case SCHEMA_FLAG: return flag(r, node, path, member);
    case SCHEMA_SET: return set(r, node, key, path, member);
    case SCHEMA_TEXT: return text(r, node, key, path, member);
    case SCHEMA_VECTOR: return vector(r, node, key, path, member);
    case SCHEMA_MAP: return map(r, node, key->keys, path, member);
    case SCHEMA_LIST: return list(r, node, key, path, out);
    }
    return BOLAN_ERROR_FORMAT;
}

// ---- maps -----------------------------------------------------------------------------------------------------------

static bolan_result unknown_key(const reader *r, const yaml_node_t *node, const schema_key *keys, const char *path) {
    char found[48], expected[LIST_MAX_LENGTH] = "";
    describe(node, found);
    for (; keys->name; keys++) append(expected, sizeof expected, keys->name);
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SCENE_UNKNOWN_KEY, "%s:%u: unknown key %s%s%s; expected %s%s", r->name,
              line_of(node), path, *path ? "." : "", found, *expected ? "one of " : "none", expected);
    return BOLAN_ERROR_FORMAT;
}

static const schema_key *find_key(const schema_key *keys, const yaml_node_t *node) {
    if (node->type != YAML_SCALAR_NODE) return NULL;
    for (; keys->name; keys++)
        if (strlen(keys->name) == node->data.scalar.length &&
            memcmp(keys->name, node->data.scalar.value, node->data.scalar.length) == 0)
            return keys;
    return NULL;
}

static bolan_result entry(reader *r, const yaml_node_pair_t *pair, const schema_key *keys, uint64_t *seen,
                          const char *path, char *out) {
    yaml_node_t *key_node = node_at(r, pair->key);
    const schema_key *key = find_key(keys, key_node);
    if (!key) return unknown_key(r, key_node, keys, path);
    char inner[PATH_MAX_LENGTH];
    snprintf(inner, sizeof inner, "%s%s%s", path, *path ? "." : "", key->name);
    const uint64_t bit = 1ULL << (key - keys);
    if (*seen & bit) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SCENE_BAD_VALUE, "%s:%u: %s is given twice; expected once", r->name,
                  line_of(key_node), inner);
        return BOLAN_ERROR_FORMAT;
    }
    *seen |= bit;
    return value(r, node_at(r, pair->value), key, inner, out);
}

static bool is_null(const yaml_node_t *node) { return node->type == YAML_SCALAR_NODE && node->data.scalar.length == 0; }

static bolan_result map(reader *r, yaml_node_t *node, const schema_key *keys, const char *path, char *out) {
    const uint32_t line = line_of(node);
    memcpy(out, &line, sizeof line);
    if (is_null(node)) return BOLAN_OK; // "island:" alone: the map is there, with every default
    if (node->type != YAML_MAPPING_NODE) return refuse(r, node, path, "a map of keys and values");
    uint64_t seen = 0;
    for (yaml_node_pair_t *pair = node->data.mapping.pairs.start; pair < node->data.mapping.pairs.top; pair++)
        if (entry(r, pair, keys, &seen, path, out)) return BOLAN_ERROR_FORMAT;
    return BOLAN_OK;
}

// ---- the document ---------------------------------------------------------------------------------------------------

static bolan_result no_memory(const char *name) {
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "%s: no memory for the YAML parser", name);
    return BOLAN_ERROR_MEMORY;
}

// Of an error of the reader (bytes that are no UTF-8) the place is known, not the line.
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

static bolan_result read_root(reader *r, const schema_key *keys, void *out) {
    yaml_node_t *root = yaml_document_get_root_node(&r->document);
    return root ? map(r, root, keys, "", out) : BOLAN_OK;
}

// A second document in the file would be ignored, and somebody would wonder why.
static bolan_result expect_end(const reader *r, yaml_parser_t *parser) {
    yaml_document_t next;
    if (!yaml_parser_load(parser, &next)) return syntax_error(r, parser);
    const yaml_node_t *root = yaml_document_get_root_node(&next);
    const bolan_result result = root ? refuse(r, root, "a second document", "one document in the file") : BOLAN_OK;
    yaml_document_delete(&next);
    return result;
}

bolan_result bolan_schema_read(const char *name, const char *text, size_t size, const schema_key *keys, void *out) {
    yaml_parser_t parser;
    if (bolan_yaml_check_limits(name, text, size)) return BOLAN_ERROR_FORMAT;
    if (!yaml_parser_initialize(&parser)) return no_memory(name);
    yaml_parser_set_input_string(&parser, (const unsigned char *)text, size);
    reader r = {.name = name, .text = text, .size = size};
    bolan_result result;
    if (!yaml_parser_load(&parser, &r.document)) {
        result = syntax_error(&r, &parser);
    } else {
        const bool empty = !yaml_document_get_root_node(&r.document);
        result = read_root(&r, keys, out);
        if (!result && !empty) result = expect_end(&r, &parser);
        yaml_document_delete(&r.document);
    }
    yaml_parser_delete(&parser);
    return result;
}
