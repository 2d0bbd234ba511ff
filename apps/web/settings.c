// SPDX-License-Identifier: MIT
// See settings.h. Ranges, units and help are those of the parameter tables.
#include "settings.h"

#include "bolan/math.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

// ---- the swell ------------------------------------------------------------------------------------------------------

typedef struct swell {
    double hs, tp, from_deg;
} swell;

#define NO_SWELL_PERIOD 11.0 // [s] of a scene without swell, until somebody raises one
#define SWELL_SPREAD 40.0    // exponent of cos-2s, long crests

static const bolan_param swell_rows[] = {
    {.field = "hs",
     .key = "hs",
     .unit = "m",
     .kind = BOLAN_PARAM_NUMBER,
     .offset = offsetof(swell, hs),
     .size = sizeof(double),
     .low = 0,
     .high = 40,
     .label = "swell height",
     .usual_high = 8,
     .digits = 1,
     .help = "significant height of the waves from elsewhere; 0: none"},
    {.field = "tp",
     .key = "tp",
     .unit = "s",
     .kind = BOLAN_PARAM_NUMBER,
     .offset = offsetof(swell, tp),
     .size = sizeof(double),
     .low = 1,
     .high = 60,
     .label = "swell period",
     .usual_low = 5,
     .usual_high = 22,
     .digits = 1,
     .help = "peak period of the waves from elsewhere"},
    {.field = "from_deg",
     .key = "from",
     .unit = "degrees",
     .kind = BOLAN_PARAM_NUMBER,
     .offset = offsetof(swell, from_deg),
     .size = sizeof(double),
     .low = -360,
     .high = 360,
     .label = "swell from",
     .usual_high = 360,
     .help = "where the waves from elsewhere come from, compass degrees"},
};
static const bolan_param_table swell_table = {"swell", swell_rows, 3};
static const bolan_param_group swell_groups[] = {{.field = "", .key = "sea.swell", .table = &swell_table},
                                                 {.table = NULL}};

// The first system that no wind raised; the number of systems where there is none.
static uint32_t find_swell(const bolan_sea_state *state) {
    uint32_t i = 0;
    while (i < state->system_count && state->systems[i].wind_speed > 0.0) i++;
    return i;
}

static swell read_swell(const bolan_scene *scene) {
    const bolan_sea_state *state = &scene->sea.sea_state;
    const uint32_t i = find_swell(state);
    if (i == state->system_count) return (swell){0.0, NO_SWELL_PERIOD, state->wind_from_deg};
    const bolan_wave_system *s = &state->systems[i];
    return (swell){s->hs, 2.0 * BOLAN_PI / s->peak_omega, s->from_deg};
}

static bool write_swell(const swell *value, bolan_scene *scene) {
    bolan_sea_state *state = &scene->sea.sea_state;
    const uint32_t i = find_swell(state);
    if (i == state->system_count) {
        if (value->hs == 0.0) return true;
        return bolan_sea_state_add_swell(state, value->hs, value->tp, value->from_deg, SWELL_SPREAD) == BOLAN_OK;
    }
    state->systems[i].hs = value->hs;
    state->systems[i].peak_omega = 2.0 * BOLAN_PI / value->tp;
    state->systems[i].from_deg = value->from_deg;
    return true;
}

// ---- one row --------------------------------------------------------------------------------------------------------

// The rows of a key and the struct that they describe.
typedef struct rows {
    const bolan_param *first;
    uint32_t count;
    bool of_swell;
    size_t offset; // of the struct in the scene
} rows;

static bool find_rows(const char *key, rows *out) {
    const bolan_param_group *group = NULL;
    *out = (rows){0};
    out->first = bolan_param_find_key(bolan_scene_groups, key, &group, &out->count);
    if (!out->first) {
        out->first = bolan_param_find_key(swell_groups, key, &group, &out->count);
        out->of_swell = true;
    }
    if (!out->first || group->capacity > 0) return false; // elements of lists have no key here
    out->offset = group->offset;
    return true;
}

static bool refuse(const char *key, const char *text, const char *expected) {
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_BAD_ARGUMENT, "%.64s is \"%.64s\"; expected %s", key, text, expected);
    return false;
}

// The components are separated by commas.
static bool parse_rows(const rows *r, const char *key, const char *text, void *desc) {
    const char *rest = text;
    for (uint32_t i = 0; i < r->count; i++) {
        const bool last = i + 1 == r->count;
        const size_t size = last ? strlen(rest) : strcspn(rest, ",");
        if ((!last && rest[size] != ',') || !bolan_param_parse(&r->first[i], rest, size, desc)) {
            char expected[512];
            bolan_param_expected(&r->first[i], expected, sizeof expected);
            return refuse(key, text, expected);
        }
        rest += size + !last;
    }
    return true;
}

static bool set_technique(bolan_scene *scene, const char *name) {
    const bolan_technique *technique = bolan_technique_find(name);
    if (!technique) return refuse("technique", name, "ocean, two-triangle, exp-cosine, nested-grid or flight-sim");
    bolan_scene_set_technique(scene, technique);
    return true;
}

bool settings_set(bolan_scene *scene, const char *key, const char *text) {
    rows r;
    if (strcmp(key, "technique") == 0) return set_technique(scene, text);
    if (!find_rows(key, &r)) return refuse("the key", key, "one of a scene file");
    if (r.of_swell) {
        swell s = read_swell(scene);
        return parse_rows(&r, key, text, &s) && write_swell(&s, scene);
    }
    bolan_scene copy = *scene;
    if (!parse_rows(&r, key, text, (char *)&copy + r.offset)) return false;
    if (strncmp(key, "sea.wind.", 9) == 0 || strcmp(key, "sea.fetch_km") == 0)
        bolan_scene_set_wind(&copy, copy.sea.sea_state.wind_speed, copy.sea.sea_state.wind_from_deg);
    *scene = copy;
    return true;
}

static int write_value(const bolan_param *p, const void *desc, char *out, size_t capacity) {
    const double value = bolan_param_get(p, desc);
    if (p->kind == BOLAN_PARAM_TEXT) return snprintf(out, capacity, "%s", (const char *)desc + p->offset);
    if (p->kind == BOLAN_PARAM_FLAG) return snprintf(out, capacity, "%s", value != 0.0 ? "true" : "false");
    if (p->kind == BOLAN_PARAM_NAME) return snprintf(out, capacity, "%s", p->names[(int)(value - p->low)]);
    return bolan_format(out, capacity, "%.10g", value / (p->factor > 0.0 ? p->factor : 1.0));
}

void settings_get(const bolan_scene *scene, const char *key, char *out, size_t capacity) {
    const swell s = read_swell(scene);
    rows r;
    out[0] = '\0';
    if (strcmp(key, "technique") == 0) {
        snprintf(out, capacity, "%s", scene->technique.name);
    } else if (find_rows(key, &r)) {
        const void *desc = r.of_swell ? (const char *)&s : (const char *)scene + r.offset;
        size_t used = 0;
        for (uint32_t i = 0; i < r.count && used + 1 < capacity; i++) {
            if (i > 0) out[used++] = ',';
            used += (size_t)write_value(&r.first[i], desc, out + used, capacity - used);
        }
    }
}

// ---- for the panel --------------------------------------------------------------------------------------------------

typedef struct writer {
    char *out;
    size_t capacity, used;
} writer;

static void put(writer *w, const char *text) {
    const size_t length = strlen(text);
    if (w->used + length >= w->capacity) return;
    memcpy(w->out + w->used, text, length + 1);
    w->used += length;
}

static void put_string(writer *w, const char *text) {
    char one[3] = "";
    put(w, "\"");
    for (; *text; text++) {
        snprintf(one, sizeof one, *text == '"' || *text == '\\' ? "\\%c" : "%c", *text);
        put(w, one);
    }
    put(w, "\"");
}

static void put_names(writer *w, const char *const *names) {
    put(w, ",\"names\":[");
    for (uint32_t i = 0; names[i]; i++) {
        if (i > 0) put(w, ",");
        put_string(w, names[i]);
    }
    put(w, "]");
}

void settings_describe(const char *key, char *out, size_t capacity) {
    writer w = {out, capacity, 0};
    rows r;
    out[0] = '\0';
    if (strcmp(key, "technique") == 0) {
        put(&w, "{\"label\":\"technique\",\"help\":\"the way to make water\",\"unit\":\"\"");
        put_names(&w, bolan_technique_names);
    } else if (find_rows(key, &r)) {
        const bolan_param *p = r.first;
        const double factor = p->factor > 0.0 ? p->factor : 1.0;
        const bool usual = p->usual_low != 0.0 || p->usual_high != 0.0;
        const char *unit = p->factor > 0.0 ? p->factor_unit : p->unit, *dot = strrchr(p->field, '.');
        char numbers[160];
        put(&w, "{\"label\":");
        put_string(&w, p->label ? p->label : dot ? dot + 1 : p->field);
        put(&w, ",\"help\":");
        put_string(&w, p->help);
        put(&w, ",\"unit\":");
        put_string(&w, unit ? unit : "");
        bolan_format(numbers, sizeof numbers, ",\"low\":%.10g,\"high\":%.10g,\"digits\":%d,\"logarithmic\":%s",
                     usual ? p->usual_low : p->low / factor, usual ? p->usual_high : p->high / factor, p->digits,
                     p->rules & BOLAN_PARAM_LOGARITHMIC ? "true" : "false");
        put(&w, numbers);
        if (p->kind == BOLAN_PARAM_NAME) put_names(&w, p->names);
    } else {
        put(&w, "null");
        return;
    }
    put(&w, "}");
}
