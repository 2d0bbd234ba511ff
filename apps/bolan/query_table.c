// SPDX-License-Identifier: MIT
// See query_table.h.
#include "query_table.h"

#include "options.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct column {
    const char *name;
    int digits;
    unsigned asks;
} column;

enum {
    COLUMN_X,
    COLUMN_Y,
    COLUMN_Z,
    COLUMN_HEIGHT,
    COLUMN_NORMAL_X,
    COLUMN_NORMAL_Y,
    COLUMN_NORMAL_Z,
    COLUMN_JACOBIAN,
    COLUMN_RESIDUAL,
    COLUMN_FOAM,
    COLUMN_RISE,
    COLUMN_VELOCITY_X,
    COLUMN_VELOCITY_Y,
    COLUMN_VELOCITY_Z,
    COLUMN_ACCELERATION_X,
    COLUMN_ACCELERATION_Y,
    COLUMN_ACCELERATION_Z,
    COLUMN_PRESSURE,
    COLUMN_WET,
    COLUMNS
};

static const column table[COLUMNS] = {
    [COLUMN_X] = {"x", 12, 0},
    [COLUMN_Y] = {"y", 12, 0},
    [COLUMN_Z] = {"z", 12, 0},
    [COLUMN_HEIGHT] = {"height", 7, ASK_SURFACE},
    [COLUMN_NORMAL_X] = {"normal_x", 7, ASK_SURFACE},
    [COLUMN_NORMAL_Y] = {"normal_y", 7, ASK_SURFACE},
    [COLUMN_NORMAL_Z] = {"normal_z", 7, ASK_SURFACE},
    [COLUMN_JACOBIAN] = {"jacobian", 6, ASK_SURFACE},
    [COLUMN_RESIDUAL] = {"residual", 3, ASK_SURFACE},
    [COLUMN_FOAM] = {"foam", 5, ASK_FOAM},
    [COLUMN_RISE] = {"rise", 6, ASK_MOTION},
    [COLUMN_VELOCITY_X] = {"velocity_x", 6, ASK_BELOW},
    [COLUMN_VELOCITY_Y] = {"velocity_y", 6, ASK_BELOW},
    [COLUMN_VELOCITY_Z] = {"velocity_z", 6, ASK_BELOW},
    [COLUMN_ACCELERATION_X] = {"acceleration_x", 6, ASK_BELOW},
    [COLUMN_ACCELERATION_Y] = {"acceleration_y", 6, ASK_BELOW},
    [COLUMN_ACCELERATION_Z] = {"acceleration_z", 6, ASK_BELOW},
    [COLUMN_PRESSURE] = {"pressure", 7, ASK_BELOW},
    [COLUMN_WET] = {"wet", 1, ASK_BELOW},
};

// Whether a word is the name of a column, or that of a vector whose component it is.
static bool is_named(const column *c, const char *word, size_t length) {
    if (strncmp(c->name, word, length) != 0) return false;
    const char *rest = c->name + length;
    return *rest == '\0' || (length > 1 && rest[0] == '_' && strchr("xyz", rest[1]) && rest[2] == '\0');
}

static bool add_word(const char *word, size_t length, query_columns *out) {
    bool found = false;
    for (int i = 0; i < COLUMNS; i++) {
        if (length == 0 || !is_named(&table[i], word, length)) continue;
        if (out->count == QUERY_MAX_COLUMNS) {
            usage_error("--columns has more than %d columns", QUERY_MAX_COLUMNS);
            return false;
        }
        out->index[out->count++] = i;
        out->asks |= table[i].asks;
        found = true;
    }
    if (found) return true;
    char text[BOLAN_PATH_MAX], shown[SHORT_WORD];
    snprintf(text, sizeof text, "%.*s", (int)length, word);
    usage_error("--columns has %s; expected x, y, z, height, normal, jacobian, residual, foam, rise, velocity, "
                "acceleration, pressure, wet, or a component such as velocity_z",
                length ? shorten(text, shown) : "an empty name");
    return false;
}

bool query_columns_parse(const char *list, query_columns *out) {
    const char *next = list;
    *out = (query_columns){.count = 0};
    for (;;) {
        const size_t length = strcspn(next, ",");
        if (!add_word(next, length, out)) return false;
        if (next[length] == '\0') return true;
        next += length + 1;
    }
}

size_t query_columns_header(const query_columns *columns, char out[QUERY_MAX_COLUMNS * QUERY_CELL]) {
    size_t used = 0;
    for (int i = 0; i < columns->count; i++)
        used += (size_t)snprintf(out + used, QUERY_CELL, "%s%s", i ? "," : "", table[columns->index[i]].name);
    out[used++] = '\n';
    return used;
}

// ---- answers --------------------------------------------------------------------------------------------------------

bool query_batch_create(query_batch *b, uint32_t capacity, unsigned asks) {
    const bool moves = (asks & (ASK_MOTION | ASK_BELOW)) != 0;
    *b = (query_batch){
        .xyz = malloc(capacity * sizeof *b->xyz),
        .xy = malloc(capacity * sizeof *b->xy),
        .surface = malloc(asks & ASK_SURFACE ? capacity * sizeof *b->surface : 1),
        .foam = malloc(asks & ASK_FOAM ? capacity * sizeof *b->foam : 1),
        .motion = malloc(moves ? capacity * sizeof *b->motion : 1),
        .below = malloc(asks & ASK_BELOW ? capacity * sizeof *b->below : 1),
    };
    return b->xyz && b->xy && b->surface && b->foam && b->motion && b->below;
}

void query_batch_free(query_batch *b) {
    free(b->xyz), free(b->xy), free(b->surface), free(b->foam), free(b->motion), free(b->below);
    *b = (query_batch){0};
}

// Points without z are at the surface, where all pressure is 0: the dynamic one takes the hydrostatic one back.
static void move_to_surface(query_batch *b, const bolan_water *water) {
    for (uint32_t i = 0; i < b->count; i++) {
        if (!isnan(b->xyz[i].z)) continue;
        const double over = (double)b->motion[i].height - water->level;
        b->below[i] = (bolan_kinematics){.velocity = b->motion[i].velocity,
                                         .acceleration = b->motion[i].acceleration,
                                         .pressure = (float)(BOLAN_SEA_WATER_DENSITY * BOLAN_GRAVITY * over),
                                         .wet = true};
    }
}

static bool lacks_z(const query_batch *b) {
    for (uint32_t i = 0; i < b->count; i++)
        if (isnan(b->xyz[i].z)) return true;
    return false;
}

void query_batch_answer(query_batch *b, const bolan_water *water, const bolan_question *question, unsigned asks) {
    for (uint32_t i = 0; i < b->count; i++) b->xy[i] = (bolan_dvec2){b->xyz[i].x, b->xyz[i].y};
    if (asks & ASK_SURFACE) bolan_query_surface(water, b->xy, b->count, b->surface);
    if (asks & ASK_FOAM) bolan_query_foam(water, b->xy, b->count, b->foam);
    const bool no_z = (asks & ASK_BELOW) && lacks_z(b);
    if ((asks & ASK_MOTION) || no_z) bolan_query_motion(water, question, b->xy, b->count, b->motion);
    if (asks & ASK_BELOW) bolan_query_below(water, question, b->xyz, b->count, b->below);
    if (no_z) move_to_surface(b, water);
}

// ---- text -----------------------------------------------------------------------------------------------------------

static double component(bolan_vec3 v, int index) { return (double)(index == 0 ? v.x : index == 1 ? v.y : v.z); }

static double cell_of(const query_batch *b, uint32_t i, int index, bool filtered) {
    switch (index) {
    case COLUMN_X: return b->xyz[i].x;
    case COLUMN_Y: return b->xyz[i].y;
    case COLUMN_Z: return b->xyz[i].z;
    case COLUMN_HEIGHT: return (double)(filtered ? b->motion[i].height : b->surface[i].height);
    case COLUMN_NORMAL_X:
    case COLUMN_NORMAL_Y:
    case COLUMN_NORMAL_Z:
        return component(filtered ? b->motion[i].normal : b->surface[i].normal, index - COLUMN_NORMAL_X);
    case COLUMN_JACOBIAN: return (double)b->surface[i].jacobian;
    case COLUMN_RESIDUAL: return (double)b->surface[i].residual;
    case COLUMN_FOAM: return (double)b->foam[i];
    case COLUMN_RISE: return (double)b->motion[i].rise;
    case COLUMN_VELOCITY_X:
    case COLUMN_VELOCITY_Y:
    case COLUMN_VELOCITY_Z: return component(b->below[i].velocity, index - COLUMN_VELOCITY_X);
    case COLUMN_ACCELERATION_X:
    case COLUMN_ACCELERATION_Y:
    case COLUMN_ACCELERATION_Z: return component(b->below[i].acceleration, index - COLUMN_ACCELERATION_X);
    case COLUMN_PRESSURE: return (double)b->below[i].pressure;
    default: return b->below[i].wet;
    }
}

size_t query_batch_print(const query_batch *b, const query_columns *columns, const bolan_question *question,
                         uint32_t first, uint32_t end, char *out) {
    size_t used = 0;
    for (uint32_t i = first; i < end; i++) {
        for (int c = 0; c < columns->count; c++) {
            const double value = cell_of(b, i, columns->index[c], question->least_wavelength > 0.0);
            if (c) out[used++] = ',';
            if (isnan(value)) continue; // a point without z has an empty cell
            used += (size_t)bolan_format_number(out + used, QUERY_CELL, value, table[columns->index[c]].digits);
        }
        out[used++] = '\n';
    }
    return used;
}
