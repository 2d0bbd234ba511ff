// SPDX-License-Identifier: MIT
// What the public headers say and what the tables of parameters hold: every member of a desc has a row, or stands in
// the list of exceptions here; the range and the default in the comment of a member are those of its row.
#include "bolan/scene.h"

#include "support.h"

#include <ctype.h>
#include <string.h>

enum { TEXT_MAX = 400000, MEMBERS_MAX = 64, COMMENT_MAX = 1500 };

static const struct {
    const bolan_param_table *table;
    const char *header;
    bool needs_default; // has a default function, so that each comment says the default
} described[] = {
    {&bolan_sea_params, "waves.h", true},
    {&bolan_sea_state_params, "spectrum.h", false},
    {&bolan_wave_system_params, "spectrum.h", false},
    {&bolan_spectrum_options_params, "formats.h", true},
    {&bolan_technique_params, "technique.h", false},
    {&bolan_look_params, "technique.h", true},
    {&bolan_camera_params, "scene.h", true},
    {&bolan_camera_key_params, "scene.h", false},
    {&bolan_sky_params, "scene.h", true},
    {&bolan_seawater_params, "scene.h", true},
    {&bolan_ground_source_params, "ground.h", true},
    {&bolan_ground_generator_params, "ground.h", true},
    {&bolan_raster_params, "ground.h", true},
    {&bolan_object_params, "scene.h", false},
    {&bolan_scene_params, "scene.h", true},
};
enum { DESCRIBED = sizeof described / sizeof *described };

// Members that no row describes: what is made of other members, other descs, counts, and pointers.
static const char *const exceptions[] = {
    "bolan_sea_desc.sea_state",
    "bolan_sea_state.system_count",
    "bolan_sea_state.systems",
    "bolan_sea_state.measured",
    "bolan_spectrum_options.record",
    "bolan_spectrum_options.time",
    "bolan_spectrum_options.location",
    "bolan_technique.name",
    "bolan_technique.wind_spectrum",
    "bolan_camera_key.camera",
    "bolan_ground_source.generator",
    "bolan_ground_source.raster",
    "bolan_scene.technique",
    "bolan_scene.look",
    "bolan_scene.sea",
    "bolan_scene.spectrum",
    "bolan_scene.camera",
    "bolan_scene.camera_key_count",
    "bolan_scene.camera_keys",
    "bolan_scene.sky",
    "bolan_scene.water",
    "bolan_scene.train_count",
    "bolan_scene.trains",
    "bolan_scene.terrain",
    "bolan_scene.object_count",
    "bolan_scene.objects",
};

// ---- a header -------------------------------------------------------------------------------------------------------

typedef struct member {
    char name[64];
    char comment[COMMENT_MAX];
} member;

static char text[TEXT_MAX];
static member members[MEMBERS_MAX];
static int member_count;

static void read_header(const char *name) {
    char path[1024];
    snprintf(path, sizeof path, "%s/include/bolan/%s", BOLAN_SOURCE_DIR, name);
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    const size_t size = fread(text, 1, sizeof text - 1, file);
    fclose(file);
    assert_true(size > 0 && size < sizeof text - 1);
    text[size] = '\0';
}

static void add_text(char *comment, const char *from, const char *to) {
    const size_t used = strlen(comment), size = (size_t)(to - from);
    assert_true(used + size + 2 < COMMENT_MAX);
    memcpy(comment + used, from, size);
    comment[used + size] = ' ';
    comment[used + size + 1] = '\0';
}

// The names of one declaration, "double latitude, longitude;" or "char path[BOLAN_PATH_MAX];".
static void add_members(const char *declaration, size_t size, const char *comment) {
    const char *at = declaration, *end = declaration + size;
    while (at < end) {
        const char *comma = memchr(at, ',', (size_t)(end - at)), *stop = comma ? comma : end;
        const char *bracket = memchr(at, '[', (size_t)(stop - at)), *last = bracket ? bracket : stop, *first;
        while (last > at && !isalnum((unsigned char)last[-1]) && last[-1] != '_') last--;
        for (first = last; first > at && (isalnum((unsigned char)first[-1]) || first[-1] == '_');) first--;
        assert_true(member_count < MEMBERS_MAX && last > first && last - first < 64);
        snprintf(members[member_count].name, sizeof members->name, "%.*s", (int)(last - first), first);
        snprintf(members[member_count++].comment, COMMENT_MAX, "%s", comment);
        at = stop + 1;
    }
}

// Names of an inner struct get its name in front.
static void close_struct(int first, const char *name, size_t size) {
    for (int i = first; i < member_count; i++) {
        char inner[64];
        snprintf(inner, sizeof inner, "%s", members[i].name);
        snprintf(members[i].name, sizeof members->name, "%.*s.%.40s", (int)size, name, inner);
    }
}

// Fills `members` from "typedef struct TYPE { ... } TYPE;": comments above members, or behind them.
static void read_struct(const char *type) {
    char begin[96], comment[COMMENT_MAX] = "";
    snprintf(begin, sizeof begin, "typedef struct %s {\n", type);
    const char *line = strstr(text, begin);
    assert_non_null(line);
    line += strlen(begin);
    member_count = 0;
    int inner = -1; // the first member of the inner struct
    for (const char *next; *line != '}'; line = next) {
        const char *end = strchr(line, '\n'), *p = line;
        next = end + 1;
        while (*p == ' ') p++;
        const char *slashes = strstr(p, "///"), *semicolon = memchr(p, ';', (size_t)(end - p));
        if (p == end) {
            comment[0] = '\0';
        } else if (strncmp(p, "///<", 4) == 0 && member_count > 0) {
            add_text(members[member_count - 1].comment, p + 4, end);
        } else if (strncmp(p, "//", 2) == 0) {
            add_text(comment, p + 3, end);
        } else if (strncmp(p, "struct {", 8) == 0) {
            inner = member_count, comment[0] = '\0';
        } else if (*p == '}') {
            close_struct(inner, p + 2, (size_t)(semicolon - p - 2));
        } else if (semicolon) {
            const int first = member_count;
            add_members(p, (size_t)(semicolon - p), comment);
            for (int i = first; i < member_count && slashes && slashes < end; i++)
                add_text(members[i].comment, slashes + 4, end);
            comment[0] = '\0';
        }
    }
}

// ---- what a comment says --------------------------------------------------------------------------------------------

// A number or the name of a constant at *p, which is moved behind it.
static bool read_number(const char **p, double *value) {
    static const struct {
        const char *name;
        double value;
    } constants[] = {{"BOLAN_DEEP", BOLAN_DEEP},
                     {"BOLAN_MAX_CASCADES", BOLAN_MAX_CASCADES},
                     {"BOLAN_MAX_LOOP_FRAMES", BOLAN_MAX_LOOP_FRAMES},
                     {"BOLAN_MAX_FREQUENCIES", BOLAN_MAX_FREQUENCIES},
                     {"BOLAN_MAX_DIRECTIONS", BOLAN_MAX_DIRECTIONS},
                     {"BOLAN_MAX_EXP_WAVES", BOLAN_MAX_EXP_WAVES}};
    for (size_t i = 0; i < sizeof constants / sizeof *constants; i++) {
        const size_t length = strlen(constants[i].name);
        if (strncmp(*p, constants[i].name, length) != 0) continue;
        *p += length, *value = constants[i].value;
        return true;
    }
    // Up to a letter or the second point: "0.1..60" and "1e-3..1e3".
    char number[32];
    size_t n = 0;
    const char *q = *p;
    if (*q == '-' || *q == '+') number[n++] = *q++;
    while (n < 30 && (isdigit((unsigned char)*q) || (*q == '.' && isdigit((unsigned char)q[1])) ||
                      (*q == 'e' && n > 0 && (isdigit((unsigned char)q[1]) || q[1] == '-')) ||
                      (*q == '-' && n > 0 && number[n - 1] == 'e')))
        number[n++] = *q++;
    number[n] = '\0';
    if (n == 0 || !isdigit((unsigned char)number[n - 1])) return false;
    *value = strtod(number, NULL);
    *p = q;
    return true;
}

// Some "LOW..HIGH" or "+-HIGH" of the comment is the range of the row.
static bool says_range(const char *comment, const bolan_param *row) {
    for (const char *p = comment; *p; p++) {
        double low, high;
        const char *q = p;
        if (strncmp(p, "+-", 2) == 0) {
            q = p + 2;
            if (read_number(&q, &high) && row->low == -high && row->high == high) return true;
            continue;
        }
        const bool begins = p == comment || (!isalnum((unsigned char)p[-1]) && !strchr(".-_", p[-1]));
        if (begins && read_number(&q, &low) && strncmp(q, "..", 2) == 0 && (q += 2, read_number(&q, &high)) &&
            low == row->low && high == row->high)
            return true;
    }
    return false;
}

// A name in capitals with _ for -, as the end of an enumerator's.
static bool is_enumerator(const char *word, const char *name) {
    char capitals[64];
    size_t n = 0;
    for (; name[n] && n < 63; n++) capitals[n] = name[n] == '-' ? '_' : (char)toupper((unsigned char)name[n]);
    const size_t length = strcspn(word, " .,;:)");
    return length >= n && strncmp(word + length - n, capitals, n) == 0;
}

// The component of a tuple "(0, 0, 3)" that a field "position.z" is.
static const char *component(const char *word, const char *field) {
    const char *dot = strrchr(field, '.');
    if (*word != '(' || !dot) return word;
    word++;
    for (char c = 'x'; c < dot[1]; c++) word = strchr(word, ',') + 2;
    return word;
}

// -1: no default is said; else whether it is the row's.
static int says_default(const char *comment, const bolan_param *row) {
    double value;
    const char *before = strstr(comment, " (default)"), *word = strstr(comment, "efault ");
    if (before) { // "0 (default): no repetition"
        while (before > comment && before[-1] != ' ') before--;
        if (strncmp(before, "NAN", 3) == 0) return isnan(row->fallback);
        return read_number(&before, &value) && value == row->fallback;
    }
    if (!word) return -1;
    word = component(word + strlen("efault "), row->field);
    switch (row->kind) {
    case BOLAN_PARAM_FLAG: return strncmp(word, row->fallback != 0.0 ? "true" : "false", 4) == 0;
    case BOLAN_PARAM_SET: return strncmp(word, "all", 3) == 0 && row->fallback == row->high;
    case BOLAN_PARAM_TEXT: return strncmp(word, "\"\"", 2) == 0;
    case BOLAN_PARAM_NAME:
        if (row->fallback < row->low) return is_enumerator(word, "auto");
        return is_enumerator(word, row->names[(int)(row->fallback - row->low)]);
    default:
        if (strncmp(word, "NAN", 3) == 0) return isnan(row->fallback);
        return read_number(&word, &value) && value == row->fallback;
    }
}

// ---- the comparison -------------------------------------------------------------------------------------------------

// A row describes a member, a component of it ("position.x") or an element ("place[0]").
static bool is_of(const bolan_param *row, const char *name) {
    const size_t length = strlen(name);
    const char *rest = row->field + length;
    return strncmp(row->field, name, length) == 0 && (*rest == '\0' || *rest == '[' || (*rest == '.' && !rest[2]));
}

static unsigned compare(const bolan_param_table *table, bool needs_default, const member *m) {
    unsigned wrong = 0, rows = 0;
    for (uint32_t i = 0; i < table->count; i++) {
        const bolan_param *row = &table->params[i];
        if (!is_of(row, m->name)) continue;
        rows++;
        const bool number = row->kind == BOLAN_PARAM_NUMBER || row->kind == BOLAN_PARAM_WHOLE;
        const int says = says_default(m->comment, row);
        if (number && !isinf(row->low) && row->high < 0x1p64 && !says_range(m->comment, row))
            print_error("%s.%s: no %g..%g in \"%s\"\n", table->type, row->field, row->low, row->high, m->comment),
                wrong++;
        if (says == 0 || (says < 0 && needs_default && row->kind != BOLAN_PARAM_TEXT))
            print_error("%s.%s: no default %g in \"%s\"\n", table->type, row->field, row->fallback, m->comment),
                wrong++;
    }
    if (rows > 0) return wrong;
    char name[128];
    snprintf(name, sizeof name, "%s.%.63s", table->type, m->name);
    for (size_t i = 0; i < sizeof exceptions / sizeof *exceptions; i++)
        if (strcmp(exceptions[i], name) == 0) return 0;
    print_error("%s has no row\n", name);
    return 1;
}

static void headers_say_what_the_tables_hold(void **state) {
    (void)state;
    unsigned wrong = 0, compared = 0;
    for (int d = 0; d < DESCRIBED; d++) {
        const bolan_param_table *table = described[d].table;
        read_header(described[d].header);
        read_struct(table->type);
        assert_true(member_count > 0);
        for (int i = 0; i < member_count; i++) {
            bool other = false; // of the other table of a scene
            for (uint32_t k = 0; k < bolan_wind_sea_params.count && table == &bolan_scene_params; k++)
                other = other || is_of(&bolan_wind_sea_params.params[k], members[i].name);
            wrong += compare(other ? &bolan_wind_sea_params : table, described[d].needs_default, &members[i]);
            compared++;
        }
        // And every row is of a member.
        for (uint32_t k = 0; k < table->count; k++) {
            bool found = false;
            for (int i = 0; i < member_count; i++) found = found || is_of(&table->params[k], members[i].name);
            if (!found) print_error("%s.%s is no member\n", table->type, table->params[k].field), wrong++;
        }
    }
    assert_true(compared > 80);
    assert_int_equal(wrong, 0);
}

// The reader of comments sees what is wrong.
static void a_wrong_comment_is_seen(void **state) {
    (void)state;
    const bolan_param *sharpness = bolan_param_find(&bolan_sea_params, "exp_cosine.sharpness");
    const bolan_param *level = bolan_param_find(&bolan_seawater_params, "level");
    const bolan_param *type = bolan_param_find(&bolan_seawater_params, "type");
    const bolan_param *z = bolan_param_find(&bolan_camera_params, "position.z");
    assert_true(says_range("Sharpness s. 0.01..2; default 0.5.", sharpness));
    assert_false(says_range("Sharpness s. 0.01..3; default 0.5.", sharpness));
    assert_false(says_range("Sharpness s. 0.1..2; default 0.5.", sharpness));
    assert_int_equal(says_default("0.01..2; default 0.5.", sharpness), 1);
    assert_int_equal(says_default("0.01..2; default 0.6.", sharpness), 0);
    assert_int_equal(says_default("0.01..2.", sharpness), -1);
    assert_true(says_range("level [m], -20..20", level) && says_range("level [m], +-20", level));
    assert_false(says_range("level [m], 20..20", level) || says_range("level [m], +-21", level));
    assert_int_equal(says_default("0 (default): none", level), 1);
    assert_int_equal(says_default("1 (default): none", level), 0);
    assert_int_equal(says_default("default IB", type), 1);
    assert_int_equal(says_default("default IA", type), 0);
    assert_int_equal(says_default("default (0, 0, 3).", z), 1);
    assert_int_equal(says_default("default (0, 0, 4).", z), 0);
}

RUN_TESTS(cmocka_unit_test(headers_say_what_the_tables_hold), cmocka_unit_test(a_wrong_comment_is_seen))
