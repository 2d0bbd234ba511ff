// SPDX-License-Identifier: MIT
// See spray.h.
#include "spray.h"

#include "memory.h"
#include "shared/constants.glsl"
#include "shared/spray.glsl"

#include <math.h>

enum {
    VEILS = SPRAY_SIDE * SPRAY_SIDE * SPRAY_VEILS,
    CORNERS = 4 * VEILS,
    INDICES = 6 * VEILS,
    ALONG = 2 * SPRAY_REACH + 1
};
_Static_assert(ALONG *ALONG *SPRAY_RINGS == SPRAY_BLOCKS, "all blocks have a place");

static const water_shader shader = {.stem = "spray", .reads = WATER_FEATURE_LAND};

static void fill_mesh(float (*corners)[4], uint32_t *indices) {
    static const uint32_t order[6] = {0, 1, 2, 2, 1, 3};
    for (uint32_t i = 0; i < CORNERS; ++i) {
        const uint32_t veil = i / 4;
        corners[i][0] = i & 1 ? 1.0f : -1.0f;
        corners[i][1] = i & 2 ? 1.0f : -1.0f;
        corners[i][2] = (float)(veil / SPRAY_VEILS);
        corners[i][3] = (float)(veil % SPRAY_VEILS);
    }
    for (uint32_t i = 0; i < INDICES; ++i) indices[i] = 4 * (i / 6) + order[i % 6];
}

static bolan_result create_mesh(spray *s, float (*corners)[4], uint32_t *indices) {
    static const uint8_t components[] = {4};
    fill_mesh(corners, indices);
    bolan_result r =
        bolan_gl_buffer_create(GL_BUFFER_VERTEX, GL_USAGE_STATIC, CORNERS * sizeof *corners, corners, &s->vertices);
    if (r == BOLAN_OK)
        r = bolan_gl_buffer_create(GL_BUFFER_INDEX, GL_USAGE_STATIC, INDICES * sizeof *indices, indices, &s->indices);
    if (r == BOLAN_OK) r = bolan_gl_mesh_create(&s->vertices, &s->indices, components, 1, sizeof *corners, &s->mesh);
    return r;
}

bolan_result bolan_spray_create(spray *s) {
    const size_t corner_bytes = CORNERS * sizeof(float[4]), index_bytes = INDICES * sizeof(uint32_t);
    float(*corners)[4] = allocate_for("spray", corner_bytes);
    uint32_t *indices = allocate_for("spray", index_bytes);
    s->blocks = allocate_for("spray", SPRAY_BLOCKS * sizeof *s->blocks);
    const bool all = corners != NULL && indices != NULL && s->blocks != NULL;
    const bolan_result result = all ? create_mesh(s, corners, indices) : BOLAN_ERROR_MEMORY;
    bolan_release(corners, corner_bytes);
    bolan_release(indices, index_bytes);
    return result;
}

void bolan_spray_free(spray *s) {
    bolan_gl_mesh_free(&s->mesh);
    bolan_gl_buffer_free(&s->vertices);
    bolan_gl_buffer_free(&s->indices);
    bolan_release(s->blocks, SPRAY_BLOCKS * sizeof *s->blocks);
    s->blocks = NULL;
}

void bolan_spray_list(const water_setup *s, water_programs *all) {
    if (s->waves == WATER_CASCADES && !s->packed) bolan_water_programs_add(all, s, false, &shader, 0);
}

float bolan_spray_time(double seconds) { return bolan_reduced(seconds / SPRAY_LIFE, SPRAY_LIVES); }

// ---- blocks ---------------------------------------------------------------------------------------------------------

// The block at (x, y) blocks from the eye's, of cells of that side. Its cells are counted from a corner of the wrapped
// plane.
static bool fill_block(const render_view *v, int x, int y, double side, double vertical, float block[4]) {
    const double width = side * SPRAY_SIDE, px = v->block.water_wrapped.x, py = v->block.water_wrapped.y;
    const double bx = floor(px / width) + x, by = floor(py / width) + y, blocks = WORLD_WRAP / width;
    const double left = bx * width - px, lower = by * width - py, reach = sqrt(0.5) * width;
    const float most = (float)(vertical + SPRAY_FLIES), level = -v->block.eye_height;
    const float low[3] = {(float)left - most, (float)lower - most, level - most};
    const float high[3] = {(float)(left + width) + most, (float)(lower + width) + most, level + most};
    if (bolan_outside_frustum(&v->block.view_projection, low, high)) return false;
    // A ring begins where the one inside it fades.
    if (side > SPRAY_CELL && hypot(left + 0.5 * width, lower + 0.5 * width) + reach < 0.75 * SPRAY_SIDE * side)
        return false;
    const double column = (bx - blocks * floor(bx / blocks)) * SPRAY_SIDE;
    const double row = (by - blocks * floor(by / blocks)) * SPRAY_SIDE;
    block[0] = (float)left;
    block[1] = (float)lower;
    block[2] = (float)side;
    block[3] = (float)(column + row * (WORLD_WRAP / SPRAY_CELL)); // below 2^24
    return true;
}

static uint32_t find_blocks(const spray *s, const water_draw *d) {
    uint32_t count = 0;
    double side = SPRAY_CELL;
    for (int ring = 0; ring < SPRAY_RINGS; ++ring, side *= 2.0)
        for (int y = -SPRAY_REACH; y <= SPRAY_REACH; ++y)
            for (int x = -SPRAY_REACH; x <= SPRAY_REACH; ++x)
                count += fill_block(d->view, x, y, side, d->vertical, s->blocks[count]);
    return count;
}

void bolan_spray_draw(const spray *s, const water_draw *d) {
    const frame *f = d->view->frame;
    const bool blows = spindrift_share(f->block.wind_speed) > 0.0f && (f->lighting.look.effects & BOLAN_EFFECT_FOAM);
    if (!blows || d->waves != WATER_CASCADES || d->packed || d->view->block.eye_height > SPRAY_HIGH) return;
    const uint32_t count = find_blocks(s, d);
    const gl_program *g = count > 0 ? bolan_water_program(d, &shader, 0) : NULL;
    if (g == NULL) return;
    bolan_gl_program_vec4_array(g, "spray_block", s->blocks[0], count);
    bolan_gl_set_state(&(gl_state){.depth_test = true, .color_write = true, .blend = GL_BLEND_PREMULTIPLIED});
    bolan_gl_mesh_draw_instances(&s->mesh, INDICES, count);
}
