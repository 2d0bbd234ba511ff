// SPDX-License-Identifier: MIT
// The mirror optics: see shaders/papers/mirror.glsl. Tiles come from paper_tiles.c, the pictures from planar_views.c.
#include "render/papers/planar_views.h"
#include "render/papers/shade_columns.h"
#include "render/papers/tiles.h"
#include "render/water_optics.h"
#include "shared/cascade.glsl"

#include <math.h>

#define SLIDE_RADIUS 0.06   // rms radius of the sun on its slide [rad]
#define SLIDE_SHARE 0.25    // of half its width: see draw_glint()
#define PUSH 0.08           // Co of eq. 9; the paper gives none
#define GLITTER_PUSH 0.25   // Cpo of eq. 10
#define OWN_BRIGHTNESS 0.16 // of the water's own texture in paper mode: radiance by irradiance

enum { TILES = 1, RIPPLES = 2, BY_THE_PAPER = 4, BELOW = 8, HIGH = 16 };

static const water_shader shader = {.stem = "papers/mirror",
                                    .reads = WATER_FEATURE_ALL,
                                    .defines = {"TILES 1\n", "RIPPLES 1\n", "PAPER 1\n", "BELOW 1\n", "HIGH 1\n"}};

// [m]. Below it the shadow of one cloud is all that is seen of the sea, and the air is alike all the way.
#define HIGH_EYE 40.0f

typedef struct mirror_block {
#include "shared/mirror_block.glsl"
} mirror_block;

typedef struct mirror {
    paper_tiles tiles;
    planar_views views;
    gl_program body; // the water round an eye in it
} mirror;

static bolan_result create(void *state, bolan_quality quality) {
    mirror *m = state;
    (void)quality;
    const bolan_result result = bolan_paper_tiles_create(&m->tiles);
    return result == BOLAN_OK ? bolan_gl_program_create("papers/medium", NULL, &m->body) : result;
}

static bolan_result reload(void *state) { return bolan_gl_program_reload(&((mirror *)state)->body); }

static void free_all(void *state) {
    mirror *m = state;
    bolan_paper_tiles_free(&m->tiles);
    bolan_planar_views_free(&m->views);
    bolan_gl_program_free(&m->body);
}

// The quad has no displaced vertices, and its pixels take the waves from tiles, once these are baked.
static bool table_only(const void *state, const frame *f) {
    const paper_tiles *t = &((const mirror *)state)->tiles;
    return t->whole && t->sea == bolan_sea_id(f->sea) && f->lighting.technique.surface == BOLAN_SURFACE_QUAD;
}

static bool stale(const void *state) { return ((const mirror *)state)->tiles.stale; }

// Where the eye stands in a tile, reduced in double: texel (0, 0) of the tile lies half a texel inside the texture.
static bolan_vec2 place_in(const bolan_tiles_view *v, const render_view *view) {
    const double c = cos(v->angle), s = sin(v->angle);
    const bolan_dvec2 drift = bolan_frame_drift(view->frame);
    const double east = view->eye.x - drift.x, north = view->eye.y - drift.y;
    const double x = along_tile(east, north, c, s) / v->length, y = across_tile(east, north, c, s) / v->length;
    return (bolan_vec2){(float)(x - floor(x) + 0.5 / v->n), (float)(y - floor(y) + 0.5 / v->n)};
}

// The tile's turn, over its side [1/m].
static bolan_vec2 turn_of(const bolan_tiles_view *v) {
    return (bolan_vec2){(float)(cos(v->angle) / v->length), (float)(sin(v->angle) / v->length)};
}

static bolan_vec4 place_of(const bolan_tiles_view *v, const render_view *view) {
    const bolan_vec2 place = place_in(v, view), turn = turn_of(v);
    return (bolan_vec4){place.x, place.y, turn.x, turn.y};
}

static void set_caustics(render_view *view, const paper_tiles *t) {
    const bolan_look *look = &view->frame->lighting.look;
    const bolan_tiles_view v = bolan_tiles_get_view(bolan_paper_tiles_fine(t));
    const double height = fmax((double)view->frame->sun_direction.z, 0.12), n = (double)view->frame->block.water_index;
    const double level = hypot((double)view->frame->sun_direction.x, (double)view->frame->sun_direction.y);
    const double sine = sqrt(1.0 - height * height) / n,
                 travel = level > 1e-6 ? sine / sqrt(1.0 - sine * sine) / level : 0.0;
    view->frame->caustics.strength = look->effects & BOLAN_EFFECT_CAUSTICS ? 1.0f : 0.0f;
    view->caustic_place = place_in(&v, view);
    view->frame->caustics.turn = turn_of(&v);
    // sunlight runs away from the sun
    view->frame->caustics.travel = (bolan_vec2){(float)(-travel * (double)view->frame->sun_direction.x),
                                                (float)(-travel * (double)view->frame->sun_direction.y)};
}

static void prepare(void *state, const water_draw *d) {
    paper_tiles *t = &((mirror *)state)->tiles;
    bolan_paper_tiles_prepare(t, d->view);
    if (!t->failed) set_caustics(d->view, t);
}

// Rows x, y, w of bias * P_sun * V_sun for directions: the sun looks along itself reversed, so what it would see of a
// mirrored ray is where the ray hits the slide (the paper's section 3 (1), steps 1 and 3).
static void set_slide(mirror_block *b, const render_view *v) {
    const bolan_vec3 s = v->frame->sun_direction;
    const float level = fmaxf(sqrtf(s.x * s.x + s.y * s.y), 1e-4f);
    const bolan_vec3 right = {-s.y / level, s.x / level, 0.0f};
    const bolan_vec3 up = {-s.z * s.x / level, -s.z * s.y / level, level};
    const float scale =
        (float)(0.5 * SLIDE_SHARE / SLIDE_RADIUS); // bias: half; projection: 1 / tangent of half the width
    b->sun_slide[0] = (vec4){scale * right.x + 0.5f * s.x, scale * right.y + 0.5f * s.y, 0.5f * s.z, 0.0f};
    b->sun_slide[1] = (vec4){scale * up.x + 0.5f * s.x, scale * up.y + 0.5f * s.y, scale * up.z + 0.5f * s.z, 0.0f};
    b->sun_slide[2] = (vec4){s.x, s.y, s.z, 0.0f};
}

// Slope variance that neither tile has: the sea's total less what they hold. The fine tile overlaps the base
// tile; it is scaled to supply only the missing variance.
static void set_waves(mirror_block *b, const render_view *view, const paper_tiles *t) {
    const bolan_tiles *base = bolan_paper_tiles_base(t), *fine = bolan_paper_tiles_fine(t);
    float rest[3];
    bolan_sea_unresolved_slopes(view->frame->sea, 0.0, 0.0, 0.0, rest);
    double missing = fmax((double)(rest[0] + rest[2]), 0.0), share = 0.0;
    bolan_tiles_view v = bolan_tiles_get_view(base);
    b->tile_place = place_of(&v, view);
    const double texels = log2(v.n / v.length);
    if (fine != base) {
        v = bolan_tiles_get_view(fine);
        v.angle = bolan_paper_tiles_ripple_angle(t);
        b->ripple_place = place_of(&v, view);
        share = fmin(1.0, sqrt(missing / fmax(t->fine_variance, 1e-9)));
        missing = fmax(missing - share * share * t->fine_variance, 0.0);
    }
    b->tile_texels = (float)texels;
    b->ripple_texels = (float)log2(v.n / v.length);
    b->ripple_share = (float)share;
    b->missing_slopes = (float)missing;
}

static mirror_block block_of(const render_view *v, const paper_tiles *t) {
    const bolan_look *look = &v->frame->lighting.look;
    const float bright = (float)OWN_BRIGHTNESS;
    mirror_block b = {.own_radiance = look->paper ? (vec3){bright, bright, bright} : v->frame->block.water_reflectance,
                      .picture_push = (float)(PUSH * look->distortion),
                      .glitter_push = (float)(GLITTER_PUSH * look->distortion),
                      .blur_texels = 2.0f * (float)bolan_planar_views_share(v) / v->block.radians_per_pixel,
                      .slide_radius = (float)SLIDE_RADIUS};
    if (bolan_paper_tiles_base(t) != NULL) set_waves(&b, v, t);
    set_slide(&b, v);
    return b;
}

static uint32_t own_defines(const paper_tiles *t, bool by_the_paper) {
    const bool tiles = bolan_paper_tiles_base(t) != NULL;
    const bool ripples = tiles && !by_the_paper && bolan_paper_tiles_fine(t) != bolan_paper_tiles_base(t);
    return (tiles ? TILES : 0u) | (ripples ? RIPPLES : 0u) | (by_the_paper ? BY_THE_PAPER : 0u);
}

static void list_waves(const water_setup *s, uint32_t own, water_programs *all) {
    bolan_water_programs_add(all, s, false, &shader, own);
    bolan_water_programs_add(all, s, false, &shader, own | HIGH);
    bolan_water_programs_add(all, s, true, &shader, own | BELOW);
}

static void list(const void *state, const water_setup *s, water_programs *all) {
    const paper_tiles *t = &((const mirror *)state)->tiles;
    if (t->failed) return;
    const uint32_t letter = s->look->paper ? BY_THE_PAPER : 0u;
    if (t->sea != 0) {
        list_waves(s, own_defines(t, s->look->paper), all);
        return;
    }
    // Not baked yet: whichever tiles there will be.
    list_waves(s, letter, all);
    list_waves(s, letter | TILES, all);
    if (!letter) list_waves(s, TILES | RIPPLES, all);
}

static void draw_world_behind(void *state, const water_draw *d, const world_drawer *world) {
    bolan_planar_views_draw(&((mirror *)state)->views, d, true, world);
}

static void draw_body(void *state) {
    bolan_gl_set_state(&(gl_state){.depth_test = true, .color_write = true});
    bolan_gl_program_use(&((mirror *)state)->body);
    bolan_gl_draw_fullscreen();
}

static void draw(void *state, const water_draw *d) {
    paper_tiles *t = &((mirror *)state)->tiles;
    const render_view *v = d->view;
    if (t->failed) return;
    const bolan_look *look = &v->frame->lighting.look;
    const bool below = v->block.eye_under_water > 0.5f;
    const bool high = v->block.eye_height > HIGH_EYE;
    const uint32_t own = own_defines(t, look->paper) | (below ? BELOW : high ? HIGH : 0u);
    if (!bolan_water_program(d, &shader, own)) return;
    const mirror_block block = block_of(v, t);
    bolan_water_blocks_upload_optics(d->blocks, &block, sizeof block);
    bolan_paper_tiles_bind(t);
    bolan_water_draw_forward(d);
}

const water_optics bolan_optics_mirror = {.kind = BOLAN_OPTICS_MIRROR,
                                          .size = sizeof(mirror),
                                          .shade_columns = bolan_paper_columns,
                                          .planar_mirrors = true,
                                          .table_only = table_only,
                                          .stale = stale,
                                          .create = create,
                                          .list = list,
                                          .prepare = prepare,
                                          .reload = reload,
                                          .behind = draw_world_behind,
                                          .draw = draw,
                                          .draw_body = draw_body,
                                          .free = free_all};
