// SPDX-License-Identifier: MIT
// The physical optics: draws the water's shape into a few numbers per pixel, and shades these over a copy of what lies
// behind. Shaders: shaders/water_shape.glsl, shaders/water_physical.glsl.
#include "below.h"
#include "caustics.h"
#include "foam_statistics.h"
#include "foam_texture.h"
#include "kept_sizes.h"
#include "pixel_tiles.h"
#include "pixels.h"
#include "shared/constants.glsl"
#include "shared/foam.glsl"
#include "spray.h"
#include "water_air.h"
#include "water_optics.h"

#include <math.h>
#include <stddef.h>

// What has the size of a view: 16 bytes a pixel, 17 where something casts shadows.
typedef struct shape {
    gl_texture kept;  // output of water_shape.glsl
    gl_target target; // it, and the frame's depth
    gl_texture sun;   // share of the sun that objects leave; made when it is first needed
    gl_target sun_target;
    water_air air;
    gl_texture land; // land_mirror.glsl, where there is land
    gl_target land_target;
    uint64_t depth_serial; // of that depth
    pixel_tiles tiles;     // where compute shaders shade
} shape;

typedef struct physical {
    bolan_quality quality;
    kept_sizes kept;
    shape shapes[KEPT_SIZES];
    shape *shape;          // of the present size
    gl_sampler sampler;    // of a host's shadow map
    gl_texture no_shadow;  // a texel: no object takes any of the sun
    const gl_texture *sun; // share that objects leave in the present view
    below_water below;
    gl_texture foam_noise;
    caustic_maps caustics;
    spray spray;
} physical;

static const water_shader shape_shader = {.stem = "water_shape", .reads = WATER_FEATURE_ALL};
static const water_shader land_shader = {.stem = "land_mirror"};
static const water_shader shadow_shader = {.stem = "host_shadow"};
static const water_shader object_shadow_shader = {.stem = "object_shadow"};
// By quality: texture fetches along a footprint, reflected rays that look for land, slopes by cubic splines. Then, what
// a sea with streaks of foam adds, and what one that never foams leaves out; and for tiles of pixels.
enum { STREAKS = BOLAN_QUALITIES, BARE, TILES, BEHIND };
#define LIGHT                                                                         \
    .stem = "water_physical", .pixels = true,                                         \
    .defines = {[BOLAN_QUALITY_LOW] = "TAPS 1\nRAYS 1\nLAND_STEPS 12\n",              \
                [BOLAN_QUALITY_MEDIUM] = "TAPS 2\nRAYS 1\nLAND_STEPS 12\n",           \
                [BOLAN_QUALITY_HIGH] = "TAPS 4\nRAYS 3\nLAND_STEPS 32\nSPLINES 1\n",  \
                [BOLAN_QUALITY_ULTRA] = "TAPS 8\nRAYS 3\nLAND_STEPS 48\nSPLINES 1\n", \
                [STREAKS] = "STREAKS 1\n",                                            \
                [BARE] = "BARE 1\n",                                                  \
                [TILES] = "TILES 1\n",                                                \
                [BEHIND] = "BEHIND 1\n"}
static const water_shader light_shader = {LIGHT, .reads = WATER_FEATURE_WAVES | WATER_FEATURE_LAND};
static const water_shader far_shader = {LIGHT, .reads = WATER_FEATURE_WAVES}; // far from land
static const water_shader tile_shader = {.stem = "compute/water_tiles", .dispatched = true, .defines = {"BEGIN 1\n"}};

typedef struct light_variant {
    const water_shader *shader;
    uint32_t own;
} light_variant;

// A shore foams on every sea.
static uint32_t light_own(bolan_quality quality, bool land, bool foams, bool streaks) {
    return 1u << quality | (!foams && !land ? 1u << BARE : 0) | (streaks ? 1u << STREAKS : 0);
}

static light_variant light_of_tiles(pixel_tile_class class, bolan_quality quality, bool foams, bool streaks) {
    const bool near = class == TILES_NEAR;
    const uint32_t own = light_own(quality, near, foams, streaks) | 1u << TILES;
    return (light_variant){.shader = near ? &light_shader : &far_shader,
                           .own = class == TILES_DEEP ? own | 1u << BEHIND : own};
}

static bolan_result create_no_shadow(physical *p) {
    static const uint8_t all = 255;
    const gl_texture_desc desc = {.format = GL_FMT_R8, .width = 1, .height = 1};
    const bolan_result result = bolan_gl_texture_create(&desc, &p->no_shadow);
    if (result == BOLAN_OK) bolan_gl_texture_upload(&p->no_shadow, 0, -1, &all, false);
    return result;
}

static bolan_result create(void *state, bolan_quality quality) {
    physical *p = state;
    p->quality = quality;
    bolan_gl_sampler_create(&p->sampler, false);
    bolan_result result = bolan_caustics_create(&p->caustics, quality);
    if (result == BOLAN_OK) result = bolan_spray_create(&p->spray);
    if (result == BOLAN_OK) result = create_no_shadow(p);
    return result == BOLAN_OK ? bolan_foam_noise_create(&p->foam_noise) : result;
}

static void free_shape(shape *s) {
    bolan_gl_target_free(&s->target);
    bolan_gl_target_free(&s->sun_target);
    bolan_gl_texture_free(&s->sun);
    bolan_gl_texture_free(&s->kept);
    bolan_water_air_free(&s->air);
    bolan_gl_target_free(&s->land_target);
    bolan_gl_texture_free(&s->land);
    bolan_pixel_tiles_free(&s->tiles);
    s->depth_serial = 0;
}

static uint32_t land_side(uint32_t pixels) {
    const uint32_t whole = 1u << (uint32_t)LAND_MIRROR_LEVELS;
    const uint32_t part = (pixels + LAND_MIRROR_PART - 1) / LAND_MIRROR_PART;
    return (part + whole - 1) / whole * whole;
}

static bolan_result create_land(shape *s, const render_view *v) {
    const gl_texture_desc desc = {.format = GL_FMT_RGBA16F,
                                  .width = land_side(v->width),
                                  .height = land_side(v->height),
                                  .filter = GL_FILTER_MIPMAP,
                                  .wrap = GL_WRAP_CLAMP};
    const gl_texture *color = &s->land;
    const bolan_result result = bolan_gl_texture_create(&desc, &s->land);
    return result == BOLAN_OK ? bolan_gl_target_create(&color, 1, NULL, -1, 0, &s->land_target) : result;
}

static bolan_result create_shape(shape *s, const render_view *v) {
    const gl_texture_desc kept = {.format = GL_FMT_RGBA32UI,
                                  .width = v->width,
                                  .height = v->height,
                                  .filter = GL_FILTER_NEAREST,
                                  .wrap = GL_WRAP_CLAMP};
    const gl_texture *color = &s->kept;
    bolan_result result = bolan_gl_texture_create(&kept, &s->kept);
    if (result == BOLAN_OK) result = bolan_gl_target_create(&color, 1, v->hdr_depth, -1, 0, &s->target);
    if (result == BOLAN_OK) result = bolan_water_air_create(&s->air, v);
    if (result == BOLAN_OK) result = create_land(s, v);
    if (result == BOLAN_OK && v->frame->compute_pixels)
        result = bolan_pixel_tiles_create(v->width, v->height, &s->tiles);
    if (result == BOLAN_OK) s->depth_serial = v->depth_serial;
    return result;
}

// Textures of the view's size, with its depth.
static bolan_result fit_shape(physical *p, const render_view *v) {
    bool fresh;
    uint32_t over;
    const uint32_t slot = bolan_kept_sizes_use(&p->kept, v->width, v->height, &fresh);
    shape *s = p->shape = &p->shapes[slot];
    while (bolan_kept_sizes_over(&p->kept, &over)) free_shape(&p->shapes[over]);
    if (!fresh && s->depth_serial == v->depth_serial) return BOLAN_OK;
    free_shape(s);
    const bolan_result result = create_shape(s, v);
    if (result != BOLAN_OK) {
        free_shape(s);
        bolan_kept_sizes_forget(&p->kept, slot);
    }
    return result;
}

static void free_all(void *state) {
    physical *p = state;
    for (int i = 0; i < KEPT_SIZES; ++i) free_shape(&p->shapes[i]);
    bolan_below_free(&p->below);
    bolan_gl_texture_free(&p->foam_noise);
    bolan_gl_texture_free(&p->no_shadow);
    bolan_caustics_free(&p->caustics);
    bolan_spray_free(&p->spray);
    bolan_gl_sampler_free(&p->sampler);
}

typedef struct physical_block {
#include "shared/physical_block.glsl"
} physical_block;

// The field of streaks is a noise and the Jacobian of the waves.
static double streak_excess(const bolan_sea *sea) {
    const double share = bolan_foam_streak_share(sea);
    if (!(share > 0.0)) return -FOAM_NEVER;
    return bolan_foam_quantile(share) * sqrt(1.0 + STREAKS_ON_CRESTS * STREAKS_ON_CRESTS);
}

static physical_block foam_of(const render_view *v) {
    const bolan_sea *sea = v->frame->sea;
    const foam_law law = bolan_foam_law(sea, bolan_foam_breaking_edge(sea), v->frame->foam_law == NULL);
    return (physical_block){.breaking_jacobian = (float)(1.0 + law.breaking),
                            .slopes_beyond_cascades = (float)law.slopes_beyond,
                            .fresh_edge = (float)law.edge,
                            .old_edge = (float)OLD_FOAM_EDGE,
                            .old_foam_memory = (float)law.memory,
                            .memory_variance = (float)fmax(law.memory_variance, 1e-9),
                            .jacobian_variance = (float)law.variance,
                            .streak_excess = (float)streak_excess(sea),
                            .spray_time = bolan_spray_time(v->frame->time),
                            .water_scattering = v->frame->water.optics.scattering};
}

static void set_fine(physical_block *b, const render_view *v) {
    const fine_values fine = bolan_fine_values(v);
    b->fine_tile = fine.tile;
    b->fine_slopes = fine.slopes;
    b->fine_widest = fine.widest;
    b->fine_texel = fine.texel;
}

static bool draw_shape(physical *p, const water_draw *d) {
    if (!bolan_water_program(d, &shape_shader, 0)) return false;
    bolan_gl_target_bind(&p->shape->target);
    bolan_gl_target_clear_integers();
    bolan_gl_set_state(&(gl_state){.depth_test = true, .depth_write = true, .color_write = true});
    bolan_water_mesh_draw(d->mesh);
    return true;
}

static bolan_result create_sun(shape *s, const render_view *v) {
    const gl_texture_desc desc = {.format = GL_FMT_R8,
                                  .width = v->width,
                                  .height = v->height,
                                  .filter = GL_FILTER_NEAREST,
                                  .wrap = GL_WRAP_CLAMP};
    const gl_texture *color = &s->sun;
    const bolan_result result = bolan_gl_texture_create(&desc, &s->sun);
    return result == BOLAN_OK ? bolan_gl_target_create(&color, 1, NULL, -1, 0, &s->sun_target) : result;
}

// Takes the share that a host's objects leave from the sun's.
static void draw_shadow(const physical *p, const water_draw *d) {
    const bolan_host *host = d->view->frame->host;
    const gl_program *g = bolan_water_program(d, &shadow_shader, 0);
    if (g == NULL) return;
    bolan_gl_program_vec4_array(g, "shadow_matrix", host->shadow_matrix.m, 4);
    bolan_gl_program_float(g, "shadow_bias", host->shadow_bias);
    bolan_gl_set_state(&(gl_state){.color_write = true, .blend = GL_BLEND_MULTIPLY});
    bolan_gl_guest_texture_bind(host->shadow, UNIT_OWN, &p->sampler);
    bolan_gl_draw_fullscreen();
    bolan_gl_guest_texture_bind(0, UNIT_OWN, NULL);
}

// The same for the scene's objects.
static void draw_object_shadow(const water_draw *d) {
    const gl_program *g = bolan_water_program(d, &object_shadow_shader, 0);
    if (g == NULL) return;
    bolan_casters_use(d->view, g);
    bolan_gl_set_state(&(gl_state){.color_write = true, .blend = GL_BLEND_MULTIPLY});
    bolan_gl_draw_fullscreen();
}

// What casts shadows on the water above which the eye is.
static bool draw_shadows(physical *p, const water_draw *d) {
    const bolan_host *host = d->view->frame->host;
    const bool guests = host != NULL && host->shadow != 0, own = d->view->caster_count > 0;
    p->sun = &p->no_shadow;
    if (!guests && !own) return true;
    shape *s = p->shape;
    if (s->sun_target.id == 0 && create_sun(s, d->view) != BOLAN_OK) return false;
    bolan_gl_target_bind(&s->sun_target);
    bolan_gl_target_clear_color(1.0f, 1.0f, 1.0f, 1.0f);
    bolan_gl_texture_bind(&s->kept, UNIT_OWN + 1);
    if (guests) draw_shadow(p, d);
    if (own) draw_object_shadow(d);
    p->sun = &s->sun;
    return true;
}

static bool draw_land(shape *s, const water_draw *d) {
    if (!bolan_water_program(d, &land_shader, 0)) return false;
    bolan_gl_target_bind(&s->land_target);
    bolan_gl_set_state(&(gl_state){.color_write = true});
    bolan_gl_draw_fullscreen();
    bolan_gl_texture_generate_mipmaps(&s->land);
    return true;
}

// Where land or objects are in the scene, by compute shaders.
static void light_tiles(const physical *p, const water_draw *d, water_rows rows, bool foams, bool streaks) {
    const gl_program *sort = bolan_water_find_program(d, &tile_shader, 0);
    const gl_program *begin = bolan_water_find_program(d, &tile_shader, 1);
    const gl_program *programs[TILE_CLASSES];
    bool all = sort != NULL && begin != NULL;
    for (int i = 0; i < TILE_CLASSES; ++i) {
        const light_variant v = light_of_tiles((pixel_tile_class)i, p->quality, foams, streaks);
        programs[i] = bolan_water_find_program(d, v.shader, v.own);
        all = all && programs[i] != NULL;
    }
    if (!all) return;
    gl_compute_saved saved;
    bolan_gl_compute_begin(&saved);
    bolan_pixel_tiles_sort(&p->shape->tiles, begin, sort, &d->view->hdr, rows.from, rows.to);
    bolan_pixel_tiles_draw(&p->shape->tiles, programs, &d->view->hdr, rows.from, rows.to);
    bolan_gl_compute_end(&saved);
}

static void light_rows(const physical *p, const water_draw *d, water_rows rows) {
    const frame *f = d->view->frame;
    const bool foams = bolan_foam_can_form(f->sea), streaks = bolan_foam_streak_share(f->sea) > 0.0;
    if (f->compute_pixels && f->behind) {
        light_tiles(p, d, rows, foams, streaks);
        return;
    }
    const gl_program *program = bolan_water_program(d, &light_shader, light_own(p->quality, f->behind, foams, streaks));
    if (program != NULL) bolan_pixels_draw(program, &d->view->hdr, rows.from, rows.to);
}

static void light(void *state, const water_draw *d, water_rows rows) {
    physical *p = state;
    physical_block block = foam_of(d->view);
    set_fine(&block, d->view);
    bolan_water_blocks_upload_optics(d->blocks, &block, sizeof block);
    const gl_buffer *law = d->view->frame->foam_law;
    if (law != NULL)
        bolan_water_blocks_patch_optics(d->blocks, offsetof(physical_block, old_foam_memory), law, FOAM_LAW_THRESHOLD,
                                        2); // and memory_variance
    bolan_gl_texture_bind(&p->foam_noise, UNIT_FOAM_DETAIL);
    bolan_gl_texture_bind(&p->shape->kept, UNIT_OWN + 1);
    bolan_gl_texture_bind(p->sun, UNIT_OWN + 2);
    bolan_gl_texture_bind(&p->shape->air.map, UNIT_OWN + 3);
    bolan_gl_texture_bind(&p->shape->land, UNIT_OWN + 4);
    if (d->fields->now->fine.id != 0) bolan_gl_texture_bind(&d->fields->now->fine, UNIT_FINE);
    light_rows(p, d, rows);
    bolan_gl_target_bind(&d->view->hdr);
}

static void list_light(const water_setup *s, water_programs *all) {
    if (!s->compute || !s->land) {
        bolan_water_programs_add(all, s, false, &light_shader, light_own(s->quality, s->land, s->foams, s->streaks));
        return;
    }
    for (int i = 0; i < TILE_CLASSES; ++i) {
        const light_variant v = light_of_tiles((pixel_tile_class)i, s->quality, s->foams, s->streaks);
        bolan_water_programs_add(all, s, false, v.shader, v.own);
    }
    for (uint32_t own = 0; own < 2; ++own) bolan_water_programs_add(all, s, false, &tile_shader, own);
}

static void list(const void *state, const water_setup *s, water_programs *all) {
    (void)state;
    bolan_water_programs_add(all, s, false, &shape_shader, 0);
    bolan_water_air_list(s, all);
    list_light(s, all);
    bolan_water_programs_add(all, s, false, &land_shader, 0);
    bolan_water_programs_add(all, s, false, &shadow_shader, 0); // a host may bring shadows to any view
    if (s->land) bolan_water_programs_add(all, s, false, &object_shadow_shader, 0);
    bolan_below_list(s, all);
    bolan_caustics_list(s, all);
    bolan_spray_list(s, all);
}

static bool make_shape(void *state, const water_draw *d) {
    physical *p = state;
    if (fit_shape(p, d->view) != BOLAN_OK || !draw_shape(p, d)) return false;
    if (d->view->medium == EYE_IN_WATER) return false; // draw_below() shades it
    if (!draw_shadows(p, d)) return false;
    if (d->view->frame->behind && !draw_land(p->shape, d)) return false;
    return bolan_water_air_draw(&p->shape->air, d);
}

static void gather(void *state, const water_draw *d) { bolan_caustics_draw(&((physical *)state)->caustics, d); }

static bolan_result reload(void *state) { return bolan_caustics_reload(&((physical *)state)->caustics); }

static void behind(void *state, const water_draw *d, const world_drawer *world) {
    bolan_below_behind(&((physical *)state)->below, d, world);
}

static void draw_below(void *state, const water_draw *d) {
    physical *p = state;
    bolan_gl_texture_bind(&p->shape->kept, UNIT_OWN + 1);
    bolan_below_draw(&p->below, d);
}

static void draw_over(void *state, const water_draw *d) {
    const physical *p = state;
    bolan_gl_texture_bind(&p->foam_noise, UNIT_FOAM_DETAIL);
    bolan_spray_draw(&p->spray, d);
}

static uint32_t shade_columns(const bolan_look *look, bolan_quality quality) {
    (void)look;
    return quality <= BOLAN_QUALITY_MEDIUM ? 2 : 1;
}

const water_optics bolan_optics_physical = {.kind = BOLAN_OPTICS_PHYSICAL,
                                            .size = sizeof(physical),
                                            .looks_through = true,
                                            .shade_columns = shade_columns,
                                            .create = create,
                                            .reload = reload,
                                            .gather = gather,
                                            .list = list,
                                            .behind = behind,
                                            .shape = make_shape,
                                            .light = light,
                                            .draw_over = draw_over,
                                            .draw_below = draw_below,
                                            .free = free_all};
