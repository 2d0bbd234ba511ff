// SPDX-License-Identifier: MIT
// See tiles.h. Baking takes a moment when the sea or the water changes, or when it is asked for; nothing is allocated
// else.
#include "render/papers/tiles.h"
#include "render/memory.h"

#include "render/sky_lattice.h"

#include <math.h>

#define FINE_LENGTH 12.0   // [m] of the ripples' tile: waves that gather light in shallow water
#define FINE_PERIOD 4.0    // [s] of its loop
#define COARSE_LENGTH 40.0 // [m]: a tile as long as this has no such waves
#define SUN_STEP 8.0       // between suns that the light on the bottom is made for [deg]
#define LOWEST_SUN 0.12    // sine of the height from which the light on the bottom comes at least
#define GLINT_SIZE 64

enum { TILE = 256 };

static bolan_result create_texture(gl_format format, uint32_t size, gl_filter filter, gl_wrap wrap, gl_texture *out) {
    gl_texture_desc d = {.format = format, .width = size, .height = size, .filter = filter, .wrap = wrap};
    return bolan_gl_texture_create(&d, out);
}

// The slide that the sun projects: a round glow that has faded to nothing at its rim. Its rms radius is GLINT_RADIUS of
// half a width.
static void draw_glint(gl_texture *t) {
    uint8_t pixels[GLINT_SIZE * GLINT_SIZE];
    for (int j = 0; j < GLINT_SIZE; ++j)
        for (int i = 0; i < GLINT_SIZE; ++i) {
            double x = (i + 0.5) / (0.5 * GLINT_SIZE) - 1.0, y = (j + 0.5) / (0.5 * GLINT_SIZE) - 1.0;
            bool rim = i == 0 || j == 0 || i == GLINT_SIZE - 1 || j == GLINT_SIZE - 1;
            pixels[j * GLINT_SIZE + i] = rim ? 0 : (uint8_t)(255.0 * exp(-0.5 * (x * x + y * y) / (0.25 * 0.25)) + 0.5);
        }
    bolan_gl_texture_upload(t, 0, -1, pixels, false);
}

bolan_result bolan_paper_tiles_create(paper_tiles *t) {
    *t = (paper_tiles){.shown = NAN, .staging_bytes = (size_t)TILE * TILE * 4 * sizeof(float)};
    t->staging = allocate_for("the tiles of the water", t->staging_bytes);
    if (t->staging == NULL) return BOLAN_ERROR_MEMORY;
    bolan_result r = create_texture(GL_FMT_RGBA16F, TILE, GL_FILTER_MIPMAP_NEAREST, GL_WRAP_REPEAT, &t->slopes);
    if (r == BOLAN_OK) r = create_texture(GL_FMT_RGBA16F, TILE, GL_FILTER_MIPMAP_NEAREST, GL_WRAP_REPEAT, &t->ripples);
    if (r == BOLAN_OK) r = create_texture(GL_FMT_RGBA8, TILE, GL_FILTER_MIPMAP_NEAREST, GL_WRAP_REPEAT, &t->own);
    if (r == BOLAN_OK) r = create_texture(GL_FMT_R8, GLINT_SIZE, GL_FILTER_LINEAR, GL_WRAP_CLAMP, &t->glint);
    if (r == BOLAN_OK) draw_glint(&t->glint);
    return r;
}

void bolan_paper_tiles_free(paper_tiles *t) {
    bolan_gl_texture_free(&t->slopes);
    bolan_gl_texture_free(&t->ripples);
    bolan_gl_texture_free(&t->own);
    bolan_gl_texture_free(&t->glint);
    bolan_tiles_destroy(&t->base);
    bolan_tiles_destroy(&t->fine);
    bolan_release(t->staging, t->staging_bytes);
}

const bolan_tiles *bolan_paper_tiles_base(const paper_tiles *t) { return t->given ? t->given : t->base; }

const bolan_tiles *bolan_paper_tiles_fine(const paper_tiles *t) {
    return t->fine ? t->fine : bolan_paper_tiles_base(t);
}

double bolan_paper_tiles_ripple_angle(const paper_tiles *t) {
    return bolan_tiles_get_view(bolan_paper_tiles_fine(t)).angle + 0.9;
}

void bolan_paper_tiles_bind(const paper_tiles *t) {
    bolan_gl_texture_bind(&t->slopes, UNIT_RIPPLES);
    bolan_gl_texture_bind(&t->own, UNIT_TILE);
    bolan_gl_texture_bind(&t->glint, UNIT_GLINT);
    bolan_gl_texture_bind(&t->ripples, UNIT_RIPPLE_SLOPES);
}

// ---- baking ---------------------------------------------------------------------------------------------------------

static bolan_tiles_desc how(const render_view *v) {
    bolan_tiles_desc d = bolan_tiles_desc_default();
    const bolan_vec3 sun = bolan_sky_lattice_direction(v->frame->sun_direction, bolan_radians(SUN_STEP));
    d.paper = v->frame->lighting.look.paper;
    d.color = v->frame->block.water_reflectance;
    // A darkish blue-green whatever the water is, as animation programs paint it.
    if (d.paper) d.color = bolan_v3(0.035f, 0.09f, 0.10f);
    d.sun = bolan_v3_normalize(bolan_v3(sun.x, sun.y, fmaxf(sun.z, (float)LOWEST_SUN)));
    d.index = (double)v->frame->block.water_index;
    return d;
}

static bolan_tiles *bake(const bolan_sea_desc *desc, const bolan_tiles_desc *how, double *hs) {
    bolan_sea *sea = NULL;
    bolan_tiles *tiles = NULL;
    if (bolan_sea_create(desc, &sea) == BOLAN_OK) {
        *hs = bolan_sea_get_summary(sea)->hs;
        (void)bolan_tiles_bake(sea, how, &tiles);
    }
    bolan_sea_destroy(&sea);
    return tiles;
}

static double slope_variance(const bolan_tiles *tiles) {
    if (tiles == NULL) return 0.0;
    const bolan_tiles_view v = bolan_tiles_get_view(tiles);
    double sum = 0.0, s = 0.5 * v.n / v.length;
    for (uint32_t j = 0; j < v.n; ++j)
        for (uint32_t i = 0; i < v.n; ++i) {
            const float *h = v.height, *row = h + (size_t)j * v.n;
            double x = s * (double)(row[(i + 1) & (v.n - 1)] - row[(i - 1) & (v.n - 1)]);
            double y = s * (double)(h[((j + 1) & (v.n - 1)) * v.n + i] - h[((j - 1) & (v.n - 1)) * v.n + i]);
            sum += x * x + y * y;
        }
    return sum / ((double)v.n * v.n);
}

static void bake_all(paper_tiles *t, const render_view *v, const bolan_tiles_desc desc) {
    t->brightest = desc.color.z >= desc.color.y && desc.color.z >= desc.color.x ? 2
                   : desc.color.y >= desc.color.x                               ? 1
                                                                                : 0;
    const double hs = bolan_sea_get_summary(v->frame->sea)->hs;
    bolan_sea_desc sea = *bolan_sea_get_desc(v->frame->sea);
    double found = 0.0;
    bolan_tiles_destroy(&t->base);
    bolan_tiles_destroy(&t->fine);
    sea.resolution = TILE;
    const bool textures = bolan_sea_get_loop(v->frame->sea).frames > 0;
    sea.waves = BOLAN_WAVES_TEXTURES;
    if (textures && t->given == NULL) t->base = bake(&sea, &desc, &found);
    // A measured spectrum is not in the sea's desc: then the tiles are another sea.
    t->whole = t->given != NULL || (t->base != NULL && fabs(found - hs) <= 0.02 * hs + 1e-6);
    if (!t->whole) bolan_tiles_destroy(&t->base);
    if (!t->whole || bolan_tiles_get_view(bolan_paper_tiles_base(t)).length > COARSE_LENGTH) {
        sea.length = FINE_LENGTH;
        sea.textures.period = FINE_PERIOD;
        t->fine = bake(&sea, &desc, &found);
    }
    t->base_variance = slope_variance(bolan_paper_tiles_base(t));
    t->fine_variance = slope_variance(bolan_paper_tiles_fine(t));
    t->failed = bolan_paper_tiles_fine(t) == NULL;
    t->shown = NAN;
}

// Of what the loops show; the sun only lights the bottom under them.
static bool is_other_water(const paper_tiles *t, const render_view *v, const bolan_tiles_desc *desc) {
    return !t->ready || t->asked != v->frame->tiles || t->paper != v->frame->lighting.look.paper ||
           t->color.x != desc->color.x || t->color.y != desc->color.y || t->color.z != desc->color.z ||
           t->sea != bolan_sea_id(v->frame->sea);
}

static bool is_other_sun(const paper_tiles *t, bolan_vec3 sun) {
    return t->sun.x != sun.x || t->sun.y != sun.y || t->sun.z != sun.z;
}

static void keep(paper_tiles *t, const render_view *v) {
    const bolan_tiles_desc desc = how(v);
    const bool other = is_other_water(t, v, &desc), turned = is_other_sun(t, desc.sun);
    t->stale = turned && !other && !v->bake;
    if (!other && (!turned || t->stale)) return;
    t->sea = bolan_sea_id(v->frame->sea);
    t->given = bolan_sea_get_loop(v->frame->sea).frames > 0 ? v->frame->tiles : NULL;
    if (t->given != NULL && bolan_tiles_get_view(t->given).n != TILE) t->given = NULL;
    t->paper = v->frame->lighting.look.paper;
    t->sun = desc.sun;
    t->color = desc.color;
    t->asked = v->frame->tiles;
    t->ready = true;
    bake_all(t, v, desc);
}

// ---- the textures of a moment ---------------------------------------------------------------------------------------

typedef struct moment {
    uint32_t a, b; // frames
    float share;   // of b
} moment;

// The paper shows one frame after the other.
static moment moment_of(const bolan_tiles *tiles, double time, bool paper) {
    double share;
    const uint32_t at = bolan_tiles_frame(tiles, time, &share);
    return (moment){at, (at + 1) % bolan_tiles_get_view(tiles).frames, paper ? 0.0f : (float)share};
}

// Along the world's axes, the tile lying at that angle: so the pixels need not turn them.
static void fill_slopes(paper_tiles *t, const bolan_tiles *tiles, const moment *m, double angle, gl_texture *to) {
    enum { MASK = TILE - 1 };
    const bolan_tiles_view v = bolan_tiles_get_view(tiles);
    const float *a = v.height + (size_t)m->a * TILE * TILE, *b = v.height + (size_t)m->b * TILE * TILE;
    const uint8_t *own = v.detail + (size_t)m->a * TILE * TILE * 3 + t->brightest;
    const float s = (float)(0.5 * TILE / v.length), sa = s * (1.0f - m->share), sb = s * m->share;
    const float c = (float)cos(angle), d = (float)sin(angle);
    for (int j = 0; j < TILE; ++j) {
        const int here = j * TILE, up = ((j + 1) & MASK) * TILE, down = ((j - 1) & MASK) * TILE;
        float *out = t->staging + (size_t)here * 4;
        for (int i = 0; i < TILE; ++i, out += 4) {
            const int e = here + ((i + 1) & MASK), w = here + ((i - 1) & MASK);
            const float x = sa * (a[e] - a[w]) + sb * (b[e] - b[w]);
            const float y = sa * (a[up + i] - a[down + i]) + sb * (b[up + i] - b[down + i]);
            out[0] = c * x - d * y;
            out[1] = d * x + c * y;
            out[2] = out[0] * out[0] + out[1] * out[1];
            out[3] = (float)own[3 * (here + i)] / 127.5f;
        }
    }
    bolan_gl_texture_upload(to, 0, -1, t->staging, false);
    bolan_gl_texture_generate_mipmaps(to);
}

// The bytes of the normal map, as a shader of the paper's day would have them.
static void fill_normals(paper_tiles *t, const bolan_tiles *tiles, const moment *m, gl_texture *to) {
    const uint8_t *rgb = bolan_tiles_get_view(tiles).normal + (size_t)m->a * TILE * TILE * 3;
    for (size_t i = 0; i < (size_t)TILE * TILE; ++i)
        for (int k = 0; k < 4; ++k) t->staging[4 * i + k] = k < 3 ? (float)rgb[3 * i + k] / 127.5f - 1.0f : 0.0f;
    bolan_gl_texture_upload(to, 0, -1, t->staging, false);
    bolan_gl_texture_generate_mipmaps(to);
}

#define CAUSTICS_PUSH 2.0f // Cco [texels]; the paper gives none

// Eq. 11: Tc1 = Tc0 + Cco N. Tile and normals lie one on the other, so that it can be done here.
static uint8_t disturbed(const bolan_tiles_view *v, uint32_t at, int i, int j) {
    const size_t size = (size_t)TILE * TILE;
    const uint8_t *n = v->normal + 3 * (at * size + (size_t)(j * TILE + i));
    const int x = i + (int)lrintf(CAUSTICS_PUSH * ((float)n[0] / 127.5f - 1.0f));
    const int y = j + (int)lrintf(CAUSTICS_PUSH * ((float)n[1] / 127.5f - 1.0f));
    return v->caustics[at * size + (size_t)((y & (TILE - 1)) * TILE + (x & (TILE - 1)))];
}

static void fill_own(paper_tiles *t, const moment *mo, const moment *mc) {
    const bolan_tiles *base = bolan_paper_tiles_base(t) ? bolan_paper_tiles_base(t) : bolan_paper_tiles_fine(t);
    const bolan_tiles_view o = bolan_tiles_get_view(base), c = bolan_tiles_get_view(bolan_paper_tiles_fine(t));
    const size_t size = (size_t)TILE * TILE;
    const uint8_t *oa = o.detail + 3 * size * mo->a, *ob = o.detail + 3 * size * mo->b;
    const uint8_t *ca = c.caustics + size * mc->a, *cb = c.caustics + size * mc->b;
    uint8_t *out = (uint8_t *)t->staging;
    const int so = (int)(mo->share * 256.0f), sc = (int)(mc->share * 256.0f);
    for (size_t i = 0; i < size; ++i, out += 4) {
        for (int k = 0; k < 3; ++k) out[k] = (uint8_t)(oa[3 * i + k] + ((ob[3 * i + k] - oa[3 * i + k]) * so >> 8));
        out[3] = t->paper ? disturbed(&c, mc->a, (int)(i % TILE), (int)(i / TILE))
                          : (uint8_t)(ca[i] + ((cb[i] - ca[i]) * sc >> 8));
    }
    bolan_gl_texture_upload(&t->own, 0, -1, t->staging, false);
    bolan_gl_texture_generate_mipmaps(&t->own);
}

void bolan_paper_tiles_prepare(paper_tiles *t, const render_view *v) {
    keep(t, v);
    if (t->failed) return;
    if (t->shown != v->frame->time) {
        const bolan_tiles *base = bolan_paper_tiles_base(t), *fine = bolan_paper_tiles_fine(t);
        const moment mf = moment_of(fine, v->frame->time, t->paper),
                     mb = base ? moment_of(base, v->frame->time, t->paper) : mf;
        if (base && t->paper) fill_normals(t, base, &mb, &t->slopes);
        if (base && !t->paper) fill_slopes(t, base, &mb, bolan_tiles_get_view(base).angle, &t->slopes);
        if (base && !t->paper && fine != base)
            fill_slopes(t, fine, &mf, bolan_paper_tiles_ripple_angle(t), &t->ripples);
        fill_own(t, &mb, &mf);
        t->shown = v->frame->time;
    }
    bolan_paper_tiles_bind(t);
}
