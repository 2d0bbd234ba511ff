// SPDX-License-Identifier: MIT
// See caustics.h.
#include "caustics.h"

#include <math.h>

#include "memory.h"
#include "shared/caustic_patches.glsl"
#include "shared/constants.glsl"
#include "shared/refraction.glsl"

#define LOWEST_SUN 0.06     // sine of its height; below, hardly any sunlight enters
#define HIGHEST_EYE 15.0    // over the water [m]: from higher up the patch is a few pixels
#define DEEPEST_BED 20.0    // that an eye above the water sees lit [m]
#define SUN_RADIUS 0.00465  // [rad]
#define DEEPEST_MIDDLE 10.0 // depth at which the middle of the near patch is lit, at most [m]
enum { TEXELS_A_CELL = 2, DEPTHS = 3, WIDE = 0, NEAR = 1 };

// Of the wide patch and of the near one: side, and how far ahead of the eye the middle lies [m].
static const double sides[CAUSTIC_PATCHES] = {24.0, 24.0 / CAUSTIC_FINER}, ahead[CAUSTIC_PATCHES] = {7.0, 3.0};
static const float depths[DEPTHS] = {1.5f, 4.0f, 10.0f}; // [m]: CAUSTIC_DEPTHS of gathered.glsl
static const uint32_t cells_of[] = {
    [BOLAN_QUALITY_LOW] = 64, [BOLAN_QUALITY_MEDIUM] = 96, [BOLAN_QUALITY_HIGH] = 160, [BOLAN_QUALITY_ULTRA] = 240};
static const water_shader source_shader = {.stem = "caustic_source", .reads = WATER_FEATURE_WAVES | WATER_FEATURE_LAND};

// ---- life -----------------------------------------------------------------------------------------------------------

static bolan_result create_mesh(caustic_maps *c) {
    static const uint8_t components[] = {2};
    const uint32_t n = c->cells, side = n + 1;
    const size_t node_bytes = (size_t)side * side * 2 * sizeof(float);
    const size_t index_bytes = (size_t)n * n * 6 * sizeof(uint32_t);
    float *nodes = allocate_for("the rays of the caustics", node_bytes);
    uint32_t *indices = allocate_for("the rays of the caustics", index_bytes);
    bolan_result r = nodes != NULL && indices != NULL ? BOLAN_OK : BOLAN_ERROR_MEMORY;
    for (uint32_t i = 0; r == BOLAN_OK && i < side * side; ++i) {
        nodes[2 * i] = (float)(i % side);
        nodes[2 * i + 1] = (float)(i / side);
    }
    for (uint32_t i = 0; r == BOLAN_OK && i < n * n; ++i) {
        const uint32_t a = i / n * side + i % n, b = a + side;
        const uint32_t two[6] = {a, a + 1, b + 1, a, b + 1, b};
        for (int k = 0; k < 6; ++k) indices[6 * i + k] = two[k];
    }
    if (r == BOLAN_OK) r = bolan_gl_buffer_create(GL_BUFFER_VERTEX, GL_USAGE_STATIC, node_bytes, nodes, &c->nodes);
    if (r == BOLAN_OK) r = bolan_gl_buffer_create(GL_BUFFER_INDEX, GL_USAGE_STATIC, index_bytes, indices, &c->indices);
    if (r == BOLAN_OK) r = bolan_gl_mesh_create(&c->nodes, &c->indices, components, 1, 2 * sizeof(float), &c->mesh);
    bolan_release(nodes, node_bytes);
    bolan_release(indices, index_bytes);
    return r;
}

bolan_result bolan_caustics_create(caustic_maps *c, bolan_quality quality) {
    *c = (caustic_maps){.cells = cells_of[quality]};
    const uint32_t nodes = c->cells + 1, texels = c->cells * TEXELS_A_CELL;
    const gl_texture_desc ray = {.format = GL_FMT_RGBA32F, .width = nodes, .height = nodes, .wrap = GL_WRAP_CLAMP};
    const gl_texture_desc map = {.format = GL_FMT_RGBA16F,
                                 .width = texels,
                                 .height = texels,
                                 .depth = CAUSTIC_PATCHES,
                                 .array = true,
                                 .filter = GL_FILTER_MIPMAP,
                                 .wrap = GL_WRAP_CLAMP};
    const gl_texture *sources[] = {&c->rays, &c->lights}, *map_layer[] = {&c->map};
    bolan_result r = bolan_gl_texture_create(&ray, &c->rays);
    if (r == BOLAN_OK) r = bolan_gl_texture_create(&ray, &c->lights);
    if (r == BOLAN_OK) r = bolan_gl_texture_create(&map, &c->map);
    if (r == BOLAN_OK) r = bolan_gl_target_create(sources, 2, NULL, -1, 0, &c->source);
    for (int i = 0; r == BOLAN_OK && i < CAUSTIC_PATCHES; ++i)
        r = bolan_gl_target_create(map_layer, 1, NULL, i, 0, &c->targets[i]);
    if (r == BOLAN_OK) r = create_mesh(c);
    return r == BOLAN_OK ? bolan_gl_program_create("caustics", NULL, &c->program) : r;
}

bolan_result bolan_caustics_reload(caustic_maps *c) { return bolan_gl_program_reload(&c->program); }

void bolan_caustics_free(caustic_maps *c) {
    bolan_gl_target_free(&c->source);
    for (int i = 0; i < CAUSTIC_PATCHES; ++i) bolan_gl_target_free(&c->targets[i]);
    bolan_gl_texture_free(&c->rays);
    bolan_gl_texture_free(&c->lights);
    bolan_gl_texture_free(&c->map);
    bolan_gl_mesh_free(&c->mesh);
    bolan_gl_buffer_free(&c->nodes);
    bolan_gl_buffer_free(&c->indices);
    bolan_gl_program_free(&c->program);
}

// Of a mesh, the vertices lie elsewhere than the rays.
static water_waves source_waves(water_waves waves) { return waves == WATER_MESH ? WATER_SUM : waves; }

void bolan_caustics_list(const water_setup *s, water_programs *all) {
    water_setup source = *s;
    source.waves = source_waves(s->waves);
    bolan_water_programs_add(all, &source, false, &source_shader, 0);
}

// ---- a view ---------------------------------------------------------------------------------------------------------

// Whether the view can show light on things in the water near the eye.
static bool shows(const render_view *v) {
    const frame *f = v->frame;
    if (f->host != NULL || !(f->lighting.look.effects & BOLAN_EFFECT_CAUSTICS)) return false;
    if (f->sun_direction.z < (float)LOWEST_SUN) return false;
    if (v->medium != EYE_IN_AIR) return true;
    if (!f->behind || v->eye.z - f->level > HIGHEST_EYE) return false;
    return f->ground == NULL ||
           (double)bolan_ground_elevation(f->ground, v->eye.x, v->eye.y, sides[WIDE]) - f->level > -DEEPEST_BED;
}

typedef struct patch {
    double side;               // [m]
    double corner_x, corner_y; // eye-relative [m]
    double cell, texel;        // [m]
} patch;

// Level travel of the sunlight that lights the things about the eye: those of a bed in sight, or those as deep as it.
static bolan_dvec2 travel_to_sight(const render_view *v, bolan_vec2 travel) {
    const frame *f = v->frame;
    double depth = f->level - v->eye.z;
    if (f->ground != NULL)
        depth = f->level - (double)bolan_ground_elevation(f->ground, v->eye.x, v->eye.y, sides[WIDE]);
    depth = fmin(fmax(depth, 0.0), DEEPEST_MIDDLE);
    return (bolan_dvec2){depth * (double)travel.x, depth * (double)travel.y};
}

// Ahead of the eye, where the light enters that falls there. Its corner is a whole number of cells of the world, so
// that nothing swims.
static patch patch_of(const caustic_maps *c, const render_view *v, int i, bolan_vec2 travel) {
    patch p = {.side = sides[i], .cell = sides[i] / c->cells, .texel = sides[i] / c->cells / TEXELS_A_CELL};
    const double heading = bolan_radians(v->lens.heading_deg);
    const double level = ahead[i] * cos(bolan_radians(v->lens.pitch_deg));
    const bolan_dvec2 shift = travel_to_sight(v, travel);
    const double x = v->eye.x + level * sin(heading) - shift.x - 0.5 * p.side;
    const double y = v->eye.y + level * cos(heading) - shift.y - 0.5 * p.side;
    p.corner_x = floor(x / p.cell) * p.cell - v->eye.x;
    p.corner_y = floor(y / p.cell) * p.cell - v->eye.y;
    return p;
}

// Blur a metre of depth of rays through slopes that a footprint of that width hides. Where flat water turns a ray from
// the direction `air` to an angle w, a slope moves the place where it lands by g = (n cos w - cos i) / (n cos w) of
// itself across its way, and by g / cos^2 w along it. The images have one blur for both.
static double blur_of(const frame *f, bolan_vec3 air, double width) {
    float hidden[3];
    const double deviation = FOOTPRINT_DEVIATION * width, index = (double)f->block.water_index;
    const double x = (double)air.x, y = (double)air.y, up = (double)air.z, level = fmax(hypot(x, y), 1e-6);
    const double down = refracted_cosine(up, index), turn = 1.0 - up / (index * down);
    bolan_sea_unresolved_slopes(f->sea, deviation, deviation, 0.0, hidden);
    const double xx = (double)hidden[0], xy = (double)hidden[1], yy = (double)hidden[2];
    const double along = fmax((x * x * xx + 2.0 * x * y * xy + y * y * yy) / (level * level), 0.0);
    const double longer = 1.0 / (down * down * down * down);
    return turn * sqrt(0.5 * (fmax(xx + yy - along, 0.0) + longer * along));
}

// The same of the sun's disc.
static double disc_blur(const frame *f) {
    const double up = (double)f->sun_direction.z, index = (double)f->block.water_index;
    const double down = refracted_cosine(up, index), across = 0.5 * SUN_RADIUS / (index * down);
    return across * sqrt(0.5 * (1.0 + up * up / (down * down * down * down)));
}

#define LOWEST_VIEW 0.17 // sine of its depression
// The same of the view through the surface, 0 for an eye in the water: what waves below a pixel do to the sight of the
// pattern.
static double view_blur(const render_view *v) {
    if (v->medium != EYE_IN_AIR) return 0.0;
    const double heading = bolan_radians(v->lens.heading_deg), pitch = bolan_radians(v->lens.pitch_deg);
    const double down = fmax(-sin(pitch), LOWEST_VIEW), level = sqrt(1.0 - down * down);
    const double away = fmax(v->eye.z - v->frame->level, 0.0) / down;
    const bolan_vec3 to_eye = {(float)(-level * sin(heading)), (float)(-level * cos(heading)), (float)down};
    return blur_of(v->frame, to_eye, away * (double)v->block.radians_per_pixel);
}

static bolan_vec2 travel_of(const frame *f) {
    const double index = (double)f->block.water_index;
    const double down = refracted_cosine((double)f->sun_direction.z, index);
    return (bolan_vec2){(float)(-(double)f->sun_direction.x / index / down),
                        (float)(-(double)f->sun_direction.y / index / down)};
}

static bolan_vec2 place_of_eye(const patch *p) {
    return (bolan_vec2){(float)(-p->corner_x / p->side), (float)(-p->corner_y / p->side)};
}

static void set_block(const patch p[CAUSTIC_PATCHES], bolan_vec2 travel, render_view *v) {
    frame *f = v->frame;
    const double down = refracted_cosine((double)f->sun_direction.z, (double)f->block.water_index);
    f->caustics.strength = 1.0f;
    f->caustics.turn = (bolan_vec2){(float)(1.0 / sides[WIDE]), 0.0f};
    f->caustics.travel = travel;
    v->caustic_place = place_of_eye(&p[WIDE]);
    v->caustic_near_place = place_of_eye(&p[NEAR]);
    const double seen = hypot(disc_blur(f), view_blur(v)), near = blur_of(f, f->sun_direction, p[NEAR].cell);
    v->caustic_near_blur = f->ground != NULL ? (float)(2.0 * hypot(near, seen)) : 0.0f;
    // what is scattered at all leaves the pattern
    v->caustic_spread = (bolan_vec2){(float)(2.0 * hypot(blur_of(f, f->sun_direction, p[WIDE].cell), seen)),
                                     (float)(0.5 * (double)f->water.optics.scattering.y / down)};
}

static void draw_source(const caustic_maps *c, const patch *p, const water_draw *d) {
    water_draw source = *d;
    source.waves = source_waves(d->waves);
    const gl_program *g = bolan_water_program(&source, &source_shader, 0);
    if (g == NULL) return;
    bolan_gl_program_vec4(g, "patch_place", (bolan_vec4){(float)p->corner_x, (float)p->corner_y, (float)p->cell, 0.0f});
    bolan_gl_target_bind(&c->source);
    bolan_gl_set_state(&(gl_state){.color_write = true});
    bolan_gl_draw_fullscreen();
}

// depth: of the image [m], < 0: the bed's; channel: 1 in those that get its light; weighed: 1 in the third as well,
// which gets the light times the depth.
static void draw_image(const caustic_maps *c, const patch *p, float depth, bolan_vec4 channel, float weighed) {
    bolan_gl_program_vec4(&c->program, "layer", (bolan_vec4){depth, (float)(1.0 / p->side), weighed, 0.0f});
    bolan_gl_program_vec4(&c->program, "channel", channel);
    bolan_gl_mesh_draw(&c->mesh, 0, c->cells * c->cells * 6);
}

// The wide patch has the images of all depths, and that of the bed where there is one. The near one has that alone.
static void draw_images(const caustic_maps *c, const patch *p, int which, bool bed) {
    const gl_program *g = &c->program;
    bolan_gl_program_use(g);
    bolan_gl_texture_bind(&c->rays, UNIT_OWN);
    bolan_gl_texture_bind(&c->lights, UNIT_OWN + 1);
    bolan_gl_program_vec4(g, "patch_place",
                          (bolan_vec4){(float)p->corner_x, (float)p->corner_y, (float)p->cell, (float)p->texel});
    bolan_gl_target_bind(&c->targets[which]);
    bolan_gl_set_state(&(gl_state){.color_write = true, .blend = GL_BLEND_ADD});
    bolan_gl_target_clear_color(0.0f, 0.0f, 0.0f, 0.0f);
    for (int i = 0; which == WIDE && i < DEPTHS; ++i)
        draw_image(c, p, depths[i], (bolan_vec4){i == 0, i == 1, i == 2, 0.0f}, 0.0f);
    if (bed) draw_image(c, p, -1.0f, (bolan_vec4){0.0f, 0.0f, 0.0f, 1.0f}, which == NEAR);
}

void bolan_caustics_draw(caustic_maps *c, const water_draw *d) {
    render_view *v = d->view;
    v->caustic_spread = (bolan_vec2){0.0f, 0.0f};
    v->caustic_near_blur = 0.0f;
    v->frame->caustics.strength = 0.0f;
    if (shows(v)) {
        const bolan_vec2 travel = travel_of(v->frame);
        const bool bed = v->frame->ground != NULL;
        const patch patches[CAUSTIC_PATCHES] = {patch_of(c, v, WIDE, travel), patch_of(c, v, NEAR, travel)};
        set_block(patches, travel, v);
        bolan_frame_fill(v->frame);
        bolan_blocks_upload_frame(v->uniforms, &v->frame->block);
        bolan_view_use(v);
        for (int i = 0; i < (bed ? CAUSTIC_PATCHES : 1); ++i) {
            draw_source(c, &patches[i], d);
            draw_images(c, &patches[i], i, bed);
        }
        bolan_gl_texture_generate_mipmaps(&c->map);
    }
    bolan_gl_texture_bind(&c->map, UNIT_CAUSTICS);
}
