// SPDX-License-Identifier: MIT
// Light through crests and ramps of foam: see shaders/water_crest.glsl. Everything in one pass over the static grid.
#include "foam_ramps.h"
#include "foam_statistics.h"
#include "water_optics.h"

#include <math.h>

typedef struct crest {
    const char *defines; // of this quality
    gl_texture densities, ramps;
} crest;

static const char *const quality_defines[] = {
    [BOLAN_QUALITY_LOW] = "TAPS 2\n",
    [BOLAN_QUALITY_MEDIUM] = "TAPS 2\n",
    [BOLAN_QUALITY_HIGH] = "TAPS 3\n",
    [BOLAN_QUALITY_ULTRA] = "TAPS 4\n",
};

static bolan_result create_densities(crest *p) {
    const size_t bytes = (size_t)FOAM_TEXTURE_SIZE * FOAM_TEXTURE_SIZE * 4;
    uint8_t *pixels = bolan_allocate(bytes);
    if (pixels == NULL) return BOLAN_ERROR_MEMORY;
    gl_texture_desc desc = {.format = GL_FMT_RGBA8,
                            .width = FOAM_TEXTURE_SIZE,
                            .height = FOAM_TEXTURE_SIZE,
                            .filter = GL_FILTER_MIPMAP,
                            .wrap = GL_WRAP_REPEAT};
    bolan_result result = foam_densities_fill(pixels);
    if (result == BOLAN_OK) result = gl_texture_create(&desc, &p->densities);
    if (result == BOLAN_OK) {
        gl_texture_upload(&p->densities, 0, -1, pixels, false);
        gl_texture_generate_mipmaps(&p->densities);
    }
    bolan_release(pixels, bytes);
    return result;
}

static bolan_result create_ramps(crest *p) {
    uint8_t ramps[FOAM_RAMP_ROWS][FOAM_RAMP_SIZE][4];
    gl_texture_desc desc = {.format = GL_FMT_RGBA8,
                            .width = FOAM_RAMP_SIZE,
                            .height = FOAM_RAMP_ROWS,
                            .filter = GL_FILTER_LINEAR,
                            .wrap = GL_WRAP_CLAMP};
    foam_ramps_fill(ramps);
    bolan_result result = gl_texture_create(&desc, &p->ramps);
    if (result == BOLAN_OK) gl_texture_upload(&p->ramps, 0, -1, ramps, false);
    return result;
}

static bolan_result create(void *state, bolan_quality quality) {
    crest *p = state;
    p->defines = quality_defines[quality];
    bolan_result result = create_densities(p);
    return result == BOLAN_OK ? create_ramps(p) : result;
}

static void free_all(void *state) {
    crest *p = state;
    gl_texture_free(&p->densities);
    gl_texture_free(&p->ramps);
}

#define FRESH_EDGE 0.09    // standard deviation that softens the edge of breaking crests, in pinch
#define OLD_EDGE 0.1       // likewise for old foam, as a share of the memory's variance
#define OLD_FOAM_SHARE 2.0 // decaying foam covers about twice what the breaking crests do

// A crest breaks where dxx + dyy falls below a threshold. Their sum is normal with variance mss, so the threshold that
// covers Monahan & O'Muircheartaigh's share is a quantile; the soft edge widens the distribution, and the quantile with it.
static void set_foam(const gl_program *g, const frame *f) {
    const bolan_sea *sea = f->desc->sea;
    const bolan_sea_desc *desc = bolan_sea_get_desc(sea);
    const double chop2 = desc->choppiness * desc->choppiness, cover = bolan_monahan_cover(desc->sea_state.wind_speed);
    double mss = 0.0, memory_mean, memory_variance;
    for (uint32_t c = 0; c < bolan_sea_cascade_count(sea); ++c) mss += bolan_sea_cascade(sea, c).mss;
    foam_memory_moments(sea, &memory_mean, &memory_variance);
    const double spread = fmax(chop2 * mss, 1e-9), edge = FRESH_EDGE * FRESH_EDGE;
    const double breaks = cover > 1e-7 ? foam_quantile(fmin(cover, 0.4)) * sqrt(spread + edge) : -1e3;
    const double share = fmin(0.3, OLD_FOAM_SHARE * cover);
    const double old =
        share > 1e-7 ? memory_mean - foam_quantile(share) * sqrt(memory_variance * (1.0 + OLD_EDGE)) : 1e3;
    float rest[3];
    bolan_sea_unresolved_slopes(sea, 0.0, 0.0, 0.0, rest);
    gl_program_vec4(
        g, "crest_foam",
        (bolan_vec4){(float)breaks, (float)old, (float)edge, (float)fmax(memory_variance * OLD_EDGE, 1e-9)});
    gl_program_vec4(g, "crest_hidden",
                    (bolan_vec4){rest[0] + rest[2], (float)chop2, (float)(memory_variance / spread), 0.0f});
}

static void draw(void *state, const water_draw *d) {
    const crest *p = state;
    const gl_program *g = water_program(d, "water_crest", 0, p->defines);
    if (!g) return;
    water_look_apply(g, &d->f->scene->look);
    set_foam(g, d->f);
    gl_texture_bind(&p->densities, UNIT_OPTICS);
    gl_texture_bind(&p->ramps, UNIT_OPTICS + 1);
    water_draw_forward(d);
}

const water_optics optics_crest = {
    .size = sizeof(crest), .static_grid = true, .packed = true, .create = create, .draw = draw, .free = free_all};
