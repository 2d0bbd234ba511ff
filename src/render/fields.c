// SPDX-License-Identifier: MIT
// See fields.h. Twin of shaders/include/bolan_fields.glsl; tests/shaders/test_fields.c binds the two.
#include "fields.h"
#include "waves/sum/exp_cosine.h"

#include "renderer.h"
#include "sea_gpu.h"
#include "shader_source.h"
#include "wave_layers.h"

#include <math.h>
#include <string.h>

enum {
    WAVES_IN_ROW = 32, // two texels each
    WAVE_ROWS = BOLAN_MAX_FREQUENCIES * BOLAN_MAX_DIRECTIONS / WAVES_IN_ROW,
    LIFT_OCTAVES = 13, // from a quarter of a texel up to a tile of 1024
};

#define SUM_SPACING_UNIT 0.5 // [m] the lift of a sum is known for spacings of an eighth of a metre to 512 m

static double fraction(double x) { return x - floor(x); }

// ---- textures -------------------------------------------------------------------------------------------------------

static void free_cascades(host_fields *p) {
    bolan_gl_texture_free(&p->displacement);
    bolan_gl_texture_free(&p->slopes);
    bolan_gl_texture_free(&p->foam);
    p->serial = 0;
}

static bool cascades_fit(const host_fields *p, const bolan_sea *sea) {
    const uint32_t count = bolan_sea_cascade_count(sea);
    if (count == 0) return true;
    return p->displacement.width == bolan_sea_cascade_layout(sea, 0).n && p->displacement.depth == count;
}

static bool create_cascades(host_fields *p, uint32_t n, uint32_t count, bool storage) {
    gl_texture_desc desc = bolan_sea_array_desc(n, count, storage);
    bolan_result result = bolan_gl_texture_create(&desc, &p->displacement);
    if (result == BOLAN_OK) result = bolan_gl_texture_create(&desc, &p->slopes);
    if (!storage) desc.format = GL_FMT_R16F; // ES has no images of one channel
    if (result == BOLAN_OK) result = bolan_gl_texture_create(&desc, &p->foam);
    if (result != BOLAN_OK) free_cascades(p);
    return result == BOLAN_OK;
}

static bool upload_cascades(host_fields *p, const bolan_sea *sea, uint32_t count) {
    if (!cascades_fit(p, sea) && !create_cascades(p, bolan_sea_cascade_layout(sea, 0).n, count, false)) return false;
    for (uint32_t c = 0; c < count; ++c) {
        const bolan_cascade_view v = bolan_sea_cascade(sea, c);
        bolan_gl_texture_upload(&p->displacement, 0, (int)c, v.displacement_half, true);
        bolan_gl_texture_upload(&p->slopes, 0, (int)c, v.slope_half, true);
        bolan_gl_texture_upload(&p->foam, 0, (int)c, v.foam_half, true);
    }
    bolan_gl_texture_generate_mipmaps(&p->displacement);
    bolan_gl_texture_generate_mipmaps(&p->slopes);
    bolan_gl_texture_generate_mipmaps(&p->foam);
    return true;
}

static bool compute_cascades(host_fields *p, const bolan_sea *sea, uint32_t count, sea_compute *compute) {
    const sea_images images = {SEA_LAYOUT_HOST, &p->displacement, &p->slopes, &p->foam};
    if (!cascades_fit(p, sea) && !create_cascades(p, bolan_sea_cascade_layout(sea, 0).n, count, true)) return false;
    return bolan_sea_compute_run(compute, &p->tables, sea, &images, GL_TIMING_OFF);
}

static double exp_scale(double sharpness) { return sharpness > 0.0 ? 2.0 / (1.0 - exp(-2.0 * sharpness)) : 1.0; }

static double sharpness_of(const bolan_sea *sea) {
    return bolan_sea_form(sea) == BOLAN_FORM_EXP_COSINES ? bolan_sea_get_desc(sea)->exp_cosine.sharpness : 0.0;
}

// Phases are those at the origin now, reduced in double, so that the GPU never sees a large coordinate.
static bool upload_waves(host_fields *p, const bolan_sea *sea, uint32_t count, bolan_dvec3 origin) {
    static const gl_texture_desc desc = {
        .format = GL_FMT_RGBA32F, .width = 2 * WAVES_IN_ROW, .height = WAVE_ROWS, .filter = GL_FILTER_NEAREST};
    float texels[WAVES_IN_ROW * WAVE_ROWS][2][4] = {0};
    const double scale = exp_scale(sharpness_of(sea)), time = bolan_sea_time(sea);
    if (p->waves.id == 0 && bolan_gl_texture_create(&desc, &p->waves) != BOLAN_OK) return false;
    for (uint32_t i = 0; i < count; ++i) {
        const bolan_sea_component w = bolan_sea_get_component(sea, i);
        const double turns = (w.kx * origin.x + w.ky * origin.y - w.omega * time + w.phase) / (2.0 * BOLAN_PI);
        texels[i][0][0] = (float)(w.kx / (2.0 * BOLAN_PI));
        texels[i][0][1] = (float)(w.ky / (2.0 * BOLAN_PI));
        texels[i][0][2] = (float)fraction(turns);
        texels[i][0][3] = (float)(w.amplitude * scale);
        texels[i][1][0] = (float)w.drift;
    }
    bolan_gl_texture_upload(&p->waves, 0, -1, texels, false);
    return true;
}

// ---- the block ------------------------------------------------------------------------------------------------------

static void fill_lift(fields_block *b, const bolan_sea *sea, uint32_t cascade, double unit) {
    for (int i = 0; i < LIFT_OCTAVES; ++i)
        (&b->lift[i].x)[cascade] = (float)bolan_sea_lift(sea, cascade, unit * exp2(i - 2.0));
}

static void fill_cascades(fields_block *b, const bolan_sea *sea, bolan_dvec3 origin) {
    const bolan_sea_warp warp = bolan_sea_get_warp(sea);
    double unused[4];
    const bolan_dvec2 place = bolan_sea_place_read(sea, origin.x, origin.y, unused);
    if (b->cascade_count > 0) {
        const bolan_cascade_view first = bolan_sea_cascade_layout(sea, 0);
        const bolan_dvec3 still = {origin.x - first.origin_x, origin.y - first.origin_y, 0.0}; // the water drifts
        b->warp_count = (int32_t)bolan_warp_waves_at(&warp, still, b->warp_wave);
        b->warp_at_origin = (bolan_vec2){(float)(place.x - still.x), (float)(place.y - still.y)};
    }
    for (uint32_t c = 0; c < (uint32_t)b->cascade_count; ++c) {
        const bolan_cascade_view v = bolan_sea_cascade_layout(sea, c);
        const double ca = cos(v.angle) / v.length, sa = sin(v.angle) / v.length, texel = v.length / v.n;
        // sample (0, 0) lies at the tile's corner, a texture's first texel half a texel inside
        b->tile[c] = (bolan_vec4){(float)(fraction(place.x * ca + place.y * sa) + 0.5 / v.n),
                                  (float)(fraction(place.y * ca - place.x * sa) + 0.5 / v.n), (float)ca, (float)sa};
        b->band[c] = (bolan_vec4){(float)(4.0 * sqrt(v.variance)), (float)texel,
                                  (float)(v.k_min > 0.0 ? 2.0 * BOLAN_PI / v.k_min : v.length), 0.0f};
        b->bound[c] = (bolan_vec4){(float)v.bound.height, (float)v.bound.drift, (float)v.bound.height_long,
                                   (float)v.bound.drift_long};
        fill_lift(b, sea, c, texel);
    }
}

static fields_block block_of(const bolan_water *water, bolan_dvec3 origin) {
    const bolan_sea *sea = water->sea;
    const double sharpness = sharpness_of(sea);
    fields_block b = {.cascade_count = (int32_t)bolan_sea_cascade_count(sea),
                      .wave_count = (int32_t)bolan_sea_component_count(sea),
                      .sharpness = (float)sharpness,
                      .mean = (float)(exp(-sharpness) * exp_cosine_mean(sharpness)),
                      .wave_height = (float)bolan_sea_get_summary(sea)->hs,
                      .choppiness = (float)bolan_sea_get_desc(sea)->choppiness,
                      .foam_threshold = (float)bolan_sea_foam_threshold(sea),
                      .level = (float)(water->level - origin.z)};
    if (b.wave_count > 0) {
        b.band[0].y = (float)SUM_SPACING_UNIT;
        fill_lift(&b, sea, 0, SUM_SPACING_UNIT);
    }
    fill_cascades(&b, sea, origin);
    b.layer_count = bolan_wave_layers_fill(water, origin, b.layer_wave, b.layer_area, b.layer_extent);
    return b;
}

// compute: NULL where the CPU makes the fields.
static bool update(host_fields *p, const bolan_water *water, bolan_dvec3 origin, sea_compute *compute) {
    const bolan_sea *sea = water->sea;
    const fields_block b = block_of(water, origin);
    const uint64_t serial = bolan_sea_serial(sea);
    if (p->block.id == 0 &&
        bolan_gl_buffer_create(GL_BUFFER_UNIFORM, GL_USAGE_STREAM, sizeof b, NULL, &p->block) != BOLAN_OK)
        return false;
    if (b.wave_count > 0 && !upload_waves(p, sea, (uint32_t)b.wave_count, origin)) return false;
    const uint32_t count = (uint32_t)b.cascade_count;
    if (count > 0 && p->serial != serial &&
        !(compute != NULL ? compute_cascades(p, sea, count, compute) : upload_cascades(p, sea, count)))
        return false;
    p->serial = serial;
    bolan_gl_buffer_update(&p->block, 0, sizeof b, &b);
    return true;
}

static void bind(const host_fields *p, uint32_t first, uint32_t slot) {
    const gl_texture *textures[BOLAN_FIELDS_UNITS] = {&p->displacement, &p->slopes, &p->foam, &p->waves};
    bolan_gl_guest_bind(textures, BOLAN_FIELDS_UNITS, first, &p->block, slot);
}

void bolan_host_fields_free(host_fields *p) {
    free_cascades(p);
    bolan_sea_tables_free(&p->tables);
    bolan_gl_texture_free(&p->waves);
    bolan_gl_buffer_free(&p->block);
}

// ---- calls ----------------------------------------------------------------------------------------------------------

const char *bolan_fields_glsl(void) {
    for (unsigned i = 0; i < bolan_shader_source_count; ++i)
        if (strcmp(bolan_shader_sources[i].path, "include/bolan_fields.glsl") == 0) return bolan_shader_sources[i].text;
    return "";
}

bolan_result bolan_renderer_link_fields(bolan_renderer *r, uint32_t program, uint32_t first_unit, uint32_t slot) {
    static const char *const samplers[BOLAN_FIELDS_UNITS] = {"bolan_displacement_map", "bolan_slope_map",
                                                             "bolan_foam_map", "bolan_wave_map"};
    BOLAN_ASSERT(r != NULL);
    bolan_result result = bolan_gl_check_context("link_fields");
    if (r == NULL || result != BOLAN_OK) return r == NULL ? BOLAN_ERROR_ARGUMENT : result;
    const char *problem =
        bolan_gl_guest_link(program, "bolan_sea_block", samplers, BOLAN_FIELDS_UNITS, first_unit, slot);
    if (problem == NULL) return BOLAN_OK;
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_GUEST_PROGRAM, "link_fields: program %u, units from %u, slot %u: %s", program,
              first_unit, slot, problem);
    return BOLAN_ERROR_ARGUMENT;
}

static bool can_bind(bolan_renderer *r, double level, bolan_dvec3 origin, uint32_t first_unit, uint32_t slot) {
    if (!bolan_gl_has_context())
        return bolan_renderer_refuse(r, CALL_BIND_FIELDS, BOLAN_LOG_GL_CONTEXT,
                                     "bind_fields: no OpenGL context is current on this thread");
    if (!isfinite(level) || !isfinite(origin.x) || !isfinite(origin.y) || !isfinite(origin.z))
        return bolan_renderer_refuse(r, CALL_BIND_FIELDS, BOLAN_LOG_NOT_FINITE,
                                     "bind_fields: level and origin must be finite");
    const char *problem = bolan_gl_guest_slots(BOLAN_FIELDS_UNITS, first_unit, slot);
    return problem == NULL ||
           bolan_renderer_refuse(r, CALL_BIND_FIELDS, BOLAN_LOG_GUEST_SLOTS, "bind_fields: units from %u, slot %u: %s",
                                 first_unit, slot, problem);
}

void bolan_renderer_bind_fields(bolan_renderer *r, const bolan_water *water, bolan_dvec3 origin, uint32_t first_unit,
                                uint32_t slot) {
    const bool given = r != NULL && water != NULL && bolan_water_is_valid(water);
    BOLAN_ASSERT(given);
    if (!given || !can_bind(r, water->level, origin, first_unit, slot)) return;
    bolan_renderer_accept(r, CALL_BIND_FIELDS);
    // Textures that go may be bound in the state that is saved and given back, so they go before.
    if (!cascades_fit(&r->fields, water->sea)) free_cascades(&r->fields);
    bolan_renderer_enter(r);
    sea_compute *compute = r->desc.backend == BOLAN_BACKEND_COMPUTE ? &r->compute : NULL;
    const bool ready = update(&r->fields, water, origin, compute);
    if (ready && !bolan_gl_may_ask()) bind(&r->fields, first_unit, slot);
    bolan_renderer_leave(r); // puts back what a binding here would move, where that was asked for
    if (ready && r->desc.restore == BOLAN_RESTORE_FULL) bind(&r->fields, first_unit, slot);
}
