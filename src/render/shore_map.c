// SPDX-License-Identifier: MIT
// Four levels, each four times as wide as the one before, twin of shaders/common/shore.glsl. A level lies on multiples
// of 32 of its texels; when the eye has gone on, it is shifted by such a multiple and only the new strip is evaluated,
// so that no texel ever changes its place or value.
#include "shore_map.h"

#include "math/half.h"
#include "memory.h"

#include <stdlib.h>

#define SNAP 32
#define PLANE ((size_t)SHORE_SIZE * SHORE_SIZE)

#define SHORE "the shore map" // in the log

bolan_result bolan_shore_builder_create(shore_builder *b) {
    gl_texture_desc d = {.format = GL_FMT_R16F,
                         .width = SHORE_SIZE,
                         .height = SHORE_SIZE,
                         .depth = SHORE_LEVELS,
                         .array = true,
                         .filter = GL_FILTER_LINEAR,
                         .wrap = GL_WRAP_CLAMP};
    bolan_result r = bolan_gl_texture_create(&d, &b->map.texture);
    if (r != BOLAN_OK) return r;
    bool all = (b->scratch = allocate_for(SHORE, PLANE * sizeof(float))) &&
               (b->halfs = allocate_for(SHORE, PLANE * sizeof(uint16_t)));
    for (int l = 0; l < SHORE_LEVELS && all; l++) {
        b->level[l].elevation = allocate_for(SHORE, PLANE * sizeof(float));
        all = b->level[l].elevation != NULL;
    }
    return all ? BOLAN_OK : BOLAN_ERROR_MEMORY;
}

void bolan_shore_builder_free(shore_builder *b) {
    bolan_gl_texture_free(&b->map.texture);
    bolan_release(b->scratch, PLANE * sizeof(float));
    bolan_release(b->halfs, PLANE * sizeof(uint16_t));
    for (int l = 0; l < SHORE_LEVELS; l++) {
        bolan_release(b->level[l].elevation, PLANE * sizeof(float));
    }
}

// Evaluates texels [i0, i1) x [j0, j1) of a level.
static void evaluate(shore_builder *b, int l, int i0, int j0, int i1, int j1) {
    if (i0 >= i1 || j0 >= j1) {
        return;
    }
    double texel = b->level[l].texel;
    uint32_t nx = (uint32_t)(i1 - i0), ny = (uint32_t)(j1 - j0);
    bolan_ground_elevations(b->terrain, b->level[l].west + (i0 + 0.5) * texel, b->level[l].south + (j0 + 0.5) * texel,
                            texel, nx, ny, b->scratch);
    for (uint32_t j = 0; j < ny; j++) {
        memcpy(b->level[l].elevation + (j0 + (int)j) * SHORE_SIZE + i0, b->scratch + j * nx, nx * sizeof(float));
    }
}

// Moves the content by (di, dj) texels: what was at (i + di, j + dj) comes to (i, j).
static void shift(float *plane, int di, int dj) {
    int width = SHORE_SIZE - abs(di), from = di > 0 ? di : 0, to = di > 0 ? 0 : -di;
    for (int n = 0; n < SHORE_SIZE - abs(dj); n++) {
        int j = dj >= 0 ? n : SHORE_SIZE - 1 - n;
        memmove(plane + j * SHORE_SIZE + to, plane + (j + dj) * SHORE_SIZE + from, (size_t)width * sizeof(float));
    }
}

static void move_level(shore_builder *b, int l, double west, double south, double texel) {
    double x = (west - b->level[l].west) / texel, y = (south - b->level[l].south) / texel;
    bool keep = b->level[l].valid && b->level[l].texel == texel && fabs(x) < SHORE_SIZE && fabs(y) < SHORE_SIZE;
    b->level[l].west = west, b->level[l].south = south, b->level[l].texel = texel;
    b->level[l].valid = true;
    if (!keep) {
        evaluate(b, l, 0, 0, SHORE_SIZE, SHORE_SIZE);
        return;
    }
    int di = (int)lrint(x), dj = (int)lrint(y);
    shift(b->level[l].elevation, di, dj);
    int row0 = dj < 0 ? -dj : 0, row1 = dj > 0 ? SHORE_SIZE - dj : SHORE_SIZE; // rows that were kept
    evaluate(b, l, 0, 0, SHORE_SIZE, row0);
    evaluate(b, l, 0, row1, SHORE_SIZE, SHORE_SIZE);
    evaluate(b, l, di < 0 ? 0 : SHORE_SIZE - di, row0, di < 0 ? -di : SHORE_SIZE, row1);
}

static void upload(shore_builder *b, int l) {
    for (size_t n = 0; n < PLANE; n++) {
        b->halfs[n] =
            half_from_float(fminf(fmaxf(b->level[l].elevation[n] - b->water_level, -HALF_LARGEST), HALF_LARGEST));
    }
    bolan_gl_texture_upload(&b->map.texture, 0, l, b->halfs, true);
}

// The finest texel [m]: two metres near the ground, doubling with the eye's height.
static double finest_texel(double height) {
    double want = 2.0 * fmax(height, 1.0) / 400.0, texel = 2.0;
    while (texel < want) {
        texel *= 2.0;
    }
    return texel;
}

void bolan_shore_builder_update(shore_builder *b, const render_view *v) {
    const bolan_ground *terrain = v->frame->ground;
    float water_level = (float)v->frame->level;
    bool raised = water_level != b->water_level;
    uint64_t id = terrain ? bolan_ground_id(terrain) : 0;
    if (terrain != b->terrain || id != b->terrain_id) {
        for (int l = 0; l < SHORE_LEVELS; l++) {
            b->level[l].valid = false;
        }
    }
    b->terrain = terrain;
    b->terrain_id = id;
    b->water_level = water_level;
    b->map.present = terrain != NULL;
    if (!terrain) {
        return;
    }
    double texel = finest_texel(fabs(v->eye.z - v->frame->level));
    for (int l = 0; l < SHORE_LEVELS; l++, texel *= 4.0) {
        double grain = SNAP * texel, half = 0.5 * SHORE_SIZE * texel;
        double west = floor(v->eye.x / grain + 0.5) * grain - half,
               south = floor(v->eye.y / grain + 0.5) * grain - half;
        bool moved =
            !b->level[l].valid || west != b->level[l].west || south != b->level[l].south || texel != b->level[l].texel;
        if (moved) {
            move_level(b, l, west, south, texel);
        }
        if (moved || raised) {
            upload(b, l);
        }
        float *to = b->map.level[l];
        to[0] = (float)(west - v->eye.x), to[1] = (float)(south - v->eye.y), to[2] = (float)(SHORE_SIZE * texel),
        to[3] = (float)texel;
    }
}

void bolan_shore_map_fill(const shore_map *s, water_block *b) {
    b->shore_present = s->present;
    for (int l = 0; l < SHORE_LEVELS; ++l)
        b->shore_level[l] = (vec4){s->level[l][0], s->level[l][1], s->level[l][2], s->level[l][3]};
}
