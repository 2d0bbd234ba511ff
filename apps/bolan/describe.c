// SPDX-License-Identifier: MIT
// See describe.h.
#include "describe.h"

#include <math.h>
#include <string.h>

// ---- values in words ------------------------------------------------------------------------------------------------

static const char *unit_of(const bolan_param *p) { return p->factor > 0.0 ? p->factor_unit : p->unit; }

static double in_key_units(const bolan_param *p, double value) { return p->factor > 0.0 ? value / p->factor : value; }

// Shortens numbers: 1e6 for 1000000.
static void write_number(double value, char out[32]) {
    bolan_format(out, 32, "%g", value);
    char *exponent = strchr(out, 'e'), *digits = exponent ? exponent + 1 + strspn(exponent + 1, "+0") : NULL;
    if (digits) memmove(exponent + 1, digits, strlen(digits) + 1);
}

static void join(const char *const *names, const char *quote, char *out, size_t capacity) {
    size_t used = strlen(out);
    for (int i = 0; names[i] && used < capacity; i++)
        used += (size_t)snprintf(out + used, capacity - used, "%s%s%s%s", i ? ", " : "", quote, names[i], quote);
}

static void describe_range(double low, double high, const char *unit, char *out, size_t capacity) {
    char from[32], to[32];
    write_number(low, from);
    write_number(high, to);
    snprintf(out, capacity, "%s..%s%s%s", from, to, unit ? " " : "", unit ? unit : "");
}

void describe_values(const bolan_param *p, const char *quote, char *out, size_t capacity) {
    const double low = in_key_units(p, p->low), high = in_key_units(p, p->high);
    out[0] = '\0';
    switch (p->kind) {
    case BOLAN_PARAM_NUMBER:
        if (isinf(low)) {
            snprintf(out, capacity, "a number");
        } else if (p->rules & BOLAN_PARAM_EITHER_SIGN) {
            bolan_format(out, capacity, "%.10g..%.10g, %.10g..%.10g", -high, -low, low, high);
        } else {
            describe_range(low, high, unit_of(p), out, capacity);
        }
        break;
    case BOLAN_PARAM_WHOLE:
        if (p->high >= 0x1p64) {
            snprintf(out, capacity, "0..2^64 - 1");
        } else {
            bolan_format(out, capacity, "%s%.0f..%.0f", p->rules & BOLAN_PARAM_POWER_OF_TWO ? "a power of two, " : "",
                         low, high);
        }
        break;
    case BOLAN_PARAM_FLAG: break;
    case BOLAN_PARAM_NAME: join(p->names, quote, out, capacity); break;
    case BOLAN_PARAM_SET:
        snprintf(out, capacity, "%sall%s, %snone%s, or some of ", quote, quote, quote, quote);
        join(p->names, quote, out, capacity);
        break;
    case BOLAN_PARAM_TEXT: break;
    }
}

void describe_option_values(const option_info *i, const char *quote, char *out, size_t capacity) {
    out[0] = '\0';
    if (i->kind == OPTION_PARAM) {
        const bolan_param row = option_param(i);
        describe_values(&row, quote, out, capacity);
    }
    if (i->kind == OPTION_NAME) join(i->names, quote, out, capacity);
    if (i->kind == OPTION_NUMBER || i->kind == OPTION_WHOLE || i->kind == OPTION_SIZE)
        describe_range(i->low, i->high, i->unit, out, capacity);
}

const char *describe_option_help(const option_info *info) {
    return info->kind == OPTION_PARAM ? option_param(info).help : info->help;
}

void describe_goes_with(const option_info *info, char *out, size_t capacity) {
    static const struct {
        unsigned bits; // ON_...
        const char *name;
    } commands[] = {{ON_VIEW, "view"},
                    {ON_RENDER, "render"},
                    {ON_MEASURE, "measure"},
                    {ON_QUERY, "query"},
                    {ON_INFO, "info"},
                    {ON_BAKE, "bake"},
                    {ON_FARM, "farm"},
                    {ON_EXPORT, "export"}, // before its parts
                    {ON_SPECTRUM, "export spectrum"},
                    {ON_MESH, "export mesh"},
                    {ON_FIELDS, "export fields"},
                    {ON_SKY, "export sky"}};
    size_t used = 0;
    unsigned left = info->commands;
    snprintf(out, capacity, "%s", left == ~0u ? "all" : "");
    for (unsigned k = 0; k < sizeof commands / sizeof *commands && info->commands != ~0u; k++)
        if ((left & commands[k].bits) == commands[k].bits && used < capacity) {
            used += (size_t)snprintf(out + used, capacity - used, "%s%s", used ? ", " : "", commands[k].name);
            left &= ~commands[k].bits;
        }
}

// ---- Markdown -------------------------------------------------------------------------------------------------------

// Prints a table cell; escapes bars, which would end it.
static void print_cell(FILE *file, const char *text) {
    for (const char *p = text; *p; p++) {
        if (*p == '|') fputc('\\', file);
        fputc(*p, file);
    }
    fputs(" | ", file);
}

// The default of a key: its value in the default scene; in an element of a list, the row's.
static void describe_default(const bolan_param_group *group, const bolan_param *p, const void *base, char *out,
                             size_t capacity) {
    const bool in_scene = base && group->capacity == 0;
    const double value = in_scene ? bolan_param_get(p, (const char *)base + group->offset) : p->fallback;
    char number[32];
    const bool absent = (p->rules & BOLAN_PARAM_OR_ZERO && value == 0.0) || isnan(value);
    snprintf(out, capacity, "%s", p->otherwise ? p->otherwise : "");
    if (p->rules & BOLAN_PARAM_REQUIRED) snprintf(out, capacity, "must be given");
    if (p->otherwise || absent || (p->rules & BOLAN_PARAM_REQUIRED)) return;
    switch (p->kind) {
    case BOLAN_PARAM_NUMBER:
    case BOLAN_PARAM_WHOLE: write_number(in_key_units(p, value), number), snprintf(out, capacity, "%s", number); break;
    case BOLAN_PARAM_FLAG: snprintf(out, capacity, "%s", value != 0.0 ? "`true`" : "`false`"); break;
    case BOLAN_PARAM_NAME: snprintf(out, capacity, "`%s`", p->names[(int)(value - p->low)]); break;
    case BOLAN_PARAM_SET: snprintf(out, capacity, "%s", value == p->high ? "`all`" : "`none`"); break;
    case BOLAN_PARAM_TEXT: break;
    }
}

// Rows with one key make one line: the components of a list.
static uint32_t component_count(const bolan_param_table *table, uint32_t first) {
    uint32_t count = 1;
    while (first + count < table->count && table->params[first + count].key &&
           strcmp(table->params[first + count].key, table->params[first].key) == 0)
        count++;
    return count;
}

static const char *component_name(const bolan_param *p) {
    const char *dot = strrchr(p->field, '.');
    return dot ? dot + 1 : p->field;
}

static void print_values_cell(FILE *file, const bolan_param *p, uint32_t count) {
    char text[DESCRIBE_MAX], one[DESCRIBE_MAX];
    size_t used = 0;
    describe_values(p, "`", text, sizeof text);
    if (p->kind == BOLAN_PARAM_FLAG) snprintf(text, sizeof text, "`true`, `false`");
    if (p->kind == BOLAN_PARAM_TEXT)
        snprintf(text, sizeof text, p->rules & BOLAN_PARAM_PATH ? "path" : "text, up to %u characters",
                 (unsigned)p->size - 1);
    for (uint32_t i = 0; i < count && count > 1; i++) {
        describe_values(&p[i], "`", one, sizeof one);
        used += (size_t)snprintf(text + used, sizeof text - used, "%s%s %s%s", i ? ", " : "[", component_name(&p[i]),
                                 one, i + 1 == count ? "]" : "");
    }
    print_cell(file, text);
}

static void print_default_cell(FILE *file, const bolan_param_group *group, const bolan_param *p, uint32_t count,
                               const void *base) {
    char text[DESCRIBE_MAX], one[DESCRIBE_MAX];
    size_t used = 0;
    describe_default(group, p, base, text, sizeof text);
    for (uint32_t i = 0; i < count && count > 1 && !p->otherwise; i++) {
        describe_default(group, &p[i], base, one, sizeof one);
        used +=
            (size_t)snprintf(text + used, sizeof text - used, "%s%s%s", i ? ", " : "[", one, i + 1 == count ? "]" : "");
    }
    print_cell(file, text);
}

// The rest of a dotted path in a section of the documentation; NULL where it belongs to another section. "" is the
// section of the keys of the document itself.
static const char *within(const char *section, const char *path) {
    const size_t length = strlen(section);
    if (length == 0) return strchr(path, '.') ? NULL : path;
    return strncmp(section, path, length) == 0 && path[length] == '.' ? path + length + 1 : NULL;
}

// Lists with a section of their own.
static bool is_list_section(const char *key) { return strcmp(key, "objects") == 0 || strcmp(key, "trains") == 0; }

// The keys of a group that belong to a section. The keys of a path's cameras are left out, since the section of the
// camera has them.
static void print_rows(FILE *file, const char *section, const bolan_param_group *group, const void *base) {
    const bool list = is_list_section(section);
    if ((list || is_list_section(group->key)) && strcmp(section, group->key) != 0) return;
    if (group->capacity && group->table == &bolan_camera_params) return;
    for (uint32_t i = 0; i < group->table->count;) {
        const bolan_param *p = &group->table->params[i];
        const uint32_t count = p->key ? component_count(group->table, i) : 1;
        char path[128];
        i += count;
        if (!p->key) continue;
        snprintf(path, sizeof path, "%s%s%s%s", group->key, group->capacity ? "[]" : "", *group->key ? "." : "",
                 p->key);
        const char *shown = list ? p->key : within(section, path);
        if (!shown) continue;
        fprintf(file, "| `%s` | ", shown);
        print_values_cell(file, p, count);
        print_default_cell(file, group, p, count, base);
        fprintf(file, "%s |\n", p->help);
    }
}

// A map without keys, or the list that the rows behind it describe.
static void print_group(FILE *file, const char *section, const bolan_param_group *group) {
    const char *shown = within(section, group->key);
    if (!group->help || !shown || !*group->key || (!*section && group->capacity)) return;
    fprintf(file, "| `%s` | ", shown);
    if (group->capacity) {
        fprintf(file, "a list, up to %u | none | %s |\n", (unsigned)group->capacity, group->help);
    } else {
        fprintf(file, "no keys | none | %s |\n", group->help);
    }
}

static void print_options(FILE *file) {
    fprintf(file, "# options\n| option | values | goes with | |\n|---|---|---|---|\n");
    for (const option_info *i = option_table; i->name; i++) {
        char values[DESCRIBE_MAX], on[192];
        describe_option_values(i, "`", values, sizeof values);
        describe_goes_with(i, on, sizeof on);
        fprintf(file, "| `--%s%s", i->name, i->argument ? " " : "");
        for (const char *p = i->argument ? i->argument : ""; *p; p++) fprintf(file, *p == '|' ? "\\|" : "%c", *p);
        fprintf(file, "` | ");
        print_cell(file, values);
        print_cell(file, on);
        fprintf(file, "%s |\n", describe_option_help(i));
    }
}

void describe_print_tables(FILE *file) {
    static const char *const sections[] = {"", "sea", "look", "trains", "water", "sky", "terrain", "objects", "camera"};
    const bolan_scene scene = bolan_scene_default();
    for (size_t s = 0; s < sizeof sections / sizeof *sections; s++) {
        fprintf(file, "# %s\n| key | values | default | |\n|---|---|---|---|\n", *sections[s] ? sections[s] : "scene");
        for (int file_keys = 0; file_keys < 2; file_keys++)
            for (const bolan_param_group *g = file_keys ? bolan_scene_file_groups : bolan_scene_groups; g->table; g++) {
                print_group(file, sections[s], g);
                print_rows(file, sections[s], g, file_keys ? NULL : &scene);
            }
    }
    print_options(file);
}

// ---- the JSON schema ------------------------------------------------------------------------------------------------

static void print_json_text(FILE *file, const char *text) {
    fputc('"', file);
    for (const char *p = text; *p; p++) {
        if (*p == '"' || *p == '\\') fputc('\\', file);
        if (*p != '`') fputc(*p, file);
    }
    fputc('"', file);
}

static void print_json_names(FILE *file, const char *const *names) {
    fputc('[', file);
    for (int i = 0; names[i]; i++) {
        if (i) fputs(", ", file);
        print_json_text(file, names[i]);
    }
    fputc(']', file);
}

static void print_json_number(FILE *file, const char *key, double value) {
    char text[64];
    bolan_format(text, sizeof text, value >= 0x1p64 ? "%.0f" : "%.10g", value >= 0x1p64 ? 0x1p64 : value);
    fprintf(file, ", \"%s\": %s", key, value >= 0x1p64 ? "18446744073709551615" : text);
}

static void print_json_range(FILE *file, const bolan_param *p) {
    const double low = in_key_units(p, p->low), high = in_key_units(p, p->high);
    if (isinf(low)) return;
    if (p->rules & BOLAN_PARAM_EITHER_SIGN) {
        print_json_number(file, "minimum", -high);
        print_json_number(file, "maximum", high);
        return;
    }
    print_json_number(file, "minimum", low);
    print_json_number(file, "maximum", high);
}

// The JSON type of a row, without braces.
static void print_json_type(FILE *file, const bolan_param *p) {
    switch (p->kind) {
    case BOLAN_PARAM_NUMBER:
        fputs("\"type\": \"number\"", file);
        print_json_range(file, p);
        break;
    case BOLAN_PARAM_WHOLE:
        if (p->rules & BOLAN_PARAM_POWER_OF_TWO) {
            fputs("\"enum\": [", file);
            for (double n = p->low; n <= p->high; n *= 2.0) fprintf(file, "%s%.0f", n > p->low ? ", " : "", n);
            fputc(']', file);
            break;
        }
        fputs("\"type\": \"integer\"", file);
        print_json_range(file, p);
        break;
    case BOLAN_PARAM_FLAG: fputs("\"type\": \"boolean\"", file); break;
    case BOLAN_PARAM_NAME:
        fputs("\"enum\": ", file);
        print_json_names(file, p->names);
        break;
    case BOLAN_PARAM_SET:
        fputs("\"anyOf\": [{\"type\": \"string\"}, {\"type\": \"array\", \"items\": {\"enum\": ", file);
        print_json_names(file, p->names);
        fputs("}}]", file);
        break;
    case BOLAN_PARAM_TEXT: // a number of a record or location is text here
        fprintf(file, "\"type\": %s, \"minLength\": 1, \"maxLength\": %u",
                p->rules & BOLAN_PARAM_PATH ? "\"string\"" : "[\"string\", \"number\"]", (unsigned)p->size - 1);
        break;
    }
}

// The default of a key that is one field of a scene.
static void print_json_default(FILE *file, const bolan_param_group *group, const bolan_param *p) {
    const bolan_scene scene = bolan_scene_default();
    const double value = bolan_param_get(p, (const char *)&scene + group->offset);
    if (group->capacity || p->otherwise) return;
    if (p->kind == BOLAN_PARAM_NUMBER || p->kind == BOLAN_PARAM_WHOLE)
        print_json_number(file, "default", in_key_units(p, value));
    if (p->kind == BOLAN_PARAM_FLAG) fprintf(file, ", \"default\": %s", value != 0.0 ? "true" : "false");
    if (p->kind == BOLAN_PARAM_NAME) fprintf(file, ", \"default\": \"%s\"", p->names[(int)(value - p->low)]);
}

static void print_json_rows(FILE *file, const bolan_param_group *group, const bolan_param *p, uint32_t count) {
    fputc('{', file);
    if (count == 1) print_json_type(file, p);
    if (count > 1) fprintf(file, "\"type\": \"array\", \"minItems\": %u, \"maxItems\": %u, \"items\": [", count, count);
    for (uint32_t i = 0; i < count && count > 1; i++) {
        fputs(i ? ", {" : "{", file);
        print_json_type(file, &p[i]);
        fputc('}', file);
    }
    if (count > 1) fputc(']', file);
    if (count == 1 && group) print_json_default(file, group, p);
    const char *unit = unit_of(p);
    char sentence[DESCRIBE_MAX];
    snprintf(sentence, sizeof sentence, "%s%s%s%s", p->help, unit ? " [" : "", unit ? unit : "", unit ? "]" : "");
    fputs(", \"description\": ", file);
    print_json_text(file, sentence);
    fputc('}', file);
}

static const bolan_param_group *find_list(const char *path) {
    for (int f = 0; f < 2; f++)
        for (const bolan_param_group *g = f ? bolan_scene_file_groups : bolan_scene_groups; g->table; g++)
            if (g->capacity && strcmp(g->key, path) == 0) return g;
    return NULL;
}

static void print_json_required(FILE *file, const char *map) {
    bool any = false;
    for (int f = 0; f < 2; f++)
        for (const bolan_param_group *g = f ? bolan_scene_file_groups : bolan_scene_groups; g->table; g++)
            for (uint32_t i = 0; i < g->table->count && g->capacity && strcmp(g->key, map) == 0; i++) {
                if (!(g->table->params[i].rules & BOLAN_PARAM_REQUIRED)) continue;
                fputs(any ? ", " : ", \"required\": [", file);
                print_json_text(file, g->table->params[i].key);
                any = true;
            }
    if (any) fputc(']', file);
}

static void print_json_map(FILE *file, const char *map, int depth);

static void print_json_key(FILE *file, const char *path, int depth) {
    uint32_t count = 0;
    const bolan_param_group *group = NULL; // of a scene
    const bolan_param *p = bolan_param_find_key(bolan_scene_groups, path, &group, &count);
    if (!p) p = bolan_param_find_key(bolan_scene_file_groups, path, NULL, &count);
    const bolan_param_group *list = find_list(path);
    if (p) {
        print_json_rows(file, group, p, count);
    } else if (list) {
        fprintf(file, "{\"type\": \"array\", \"maxItems\": %u, \"items\": ", (unsigned)list->capacity);
        print_json_map(file, path, depth);
        fputc('}', file);
    } else {
        print_json_map(file, path, depth);
    }
}

// A map may be empty: "island:" alone has every default.
static void print_json_map(FILE *file, const char *map, int depth) {
    char words[2 * DESCRIBE_MAX] = "", path[128];
    bolan_param_list_keys(bolan_scene_groups, map, words, sizeof words);
    bolan_param_list_keys(bolan_scene_file_groups, map, words, sizeof words);
    fputs("{\"type\": [\"object\", \"null\"], \"additionalProperties\": false", file);
    print_json_required(file, map);
    fputs(", \"properties\": {", file);
    for (const char *w = words; *w; w += strspn(w, ", ")) {
        const int length = (int)strcspn(w, ",");
        snprintf(path, sizeof path, "%s%s%.*s", map, *map ? "." : "", length, w);
        fprintf(file, "%s\n%*s\"%.*s\": ", w == words ? "" : ",", 2 * depth, "", length, w);
        print_json_key(file, path, depth + 1);
        w += length;
    }
    fputs("}}", file);
}

void describe_print_schema(FILE *file) {
    fputs("{\"$schema\": \"http://json-schema.org/draft-07/schema#\", \"title\": \"A scene of Bolan\",\n"
          " \"description\": \"Written by bolan info --schema.\", \"allOf\": [\n",
          file);
    print_json_map(file, "", 1);
    fputs("]}\n", file);
}
