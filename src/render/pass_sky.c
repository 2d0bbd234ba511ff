// SPDX-License-Identifier: MIT
// The sky: keeps the tables of the air, the clouds and the environment map, measures the light on the sea, and draws
// the background. Shader: shaders/sky.glsl; atmosphere.c and clouds.c fill the tables.
#include "atmosphere.h"
#include "clouds.h"
#include "host_light.h"
#include "memory.h"
#include "pixels.h"
#include "sky_lattice.h"

#include <math.h>
#include <string.h>

enum { ENVIRONMENT_SIZE = 512, ENVIRONMENT_LEVELS = 8, LIGHT_PIXELS = 4 };

// The two parts of the background are drawn with one mesh: first a rectangle, then the same in columns.
enum { COLUMNS = 8, CORNERS = 2 * (COLUMNS + 1), RECTANGLE_INDICES = 6, INDICES = RECTANGLE_INDICES * (COLUMNS + 1) };

// The programs of the background, and what each defines.
enum { SKY, SKY_BELOW, SKY_PANORAMA, SKY_SUN, SKY_OVER, SKY_ENVIRONMENT, SKY_PREFILTER, SKY_LIGHT, SKY_PROGRAMS };
static const char *const sky_sources[SKY_PROGRAMS][2] = {[SKY] = {"sky", NULL},
                                                         [SKY_BELOW] = {"sky", "BELOW 1\n"},
                                                         [SKY_PANORAMA] = {"sky_panorama", NULL},
                                                         [SKY_SUN] = {"sky_sun", NULL},
                                                         [SKY_OVER] = {"sky_over", NULL},
                                                         [SKY_ENVIRONMENT] = {"sky_environment", NULL},
                                                         [SKY_PREFILTER] = {"sky_prefilter", NULL},
                                                         [SKY_LIGHT] = {"sky_light", NULL}};

struct pass_sky {
    atmosphere air;
    clouds clouds;
    host_light host;
    gl_program programs[SKY_PROGRAMS];
    gl_program pixels; // both parts of the background as a compute shader; none where fragment shaders shade pixels
    bool borrowed;     // the programs are those of another
    gl_buffer corners, indices;
    gl_mesh mesh;
    gl_texture panorama; // clear sky and clouds together
    gl_target panorama_target;
    bolan_vec3 lattice_sun;               // direction to the sun that all of this was made for
    gl_texture plain, environment, light; // the environment before and after its levels are blurred
    gl_target plain_target, environment_target[ENVIRONMENT_LEVELS], light_target;
    block_buffers uniforms;           // while tables are drawn
    float measured[4 * LIGHT_PIXELS]; // what sky_light.glsl measured, as far as it was read back
    gl_readback reading;              // of light_target
    bool unread;                      // light_target is newer than what was read, and is not being read
    bool lit;                         // `measured` was read once
    bolan_vec3 measured_sun;          // direction to the sun when it was last begun to be read
};

static bolan_result create_targets(pass_sky *p) {
    const gl_texture_desc environment = {.format = GL_FMT_RGBA16F,
                                         .width = ENVIRONMENT_SIZE,
                                         .height = ENVIRONMENT_SIZE,
                                         .levels = ENVIRONMENT_LEVELS,
                                         .filter = GL_FILTER_MIPMAP};
    const gl_texture_desc light = {.format = GL_FMT_RGBA32F, .width = LIGHT_PIXELS, .height = 1};
    const gl_texture *color = &p->plain;
    bolan_result result = bolan_gl_texture_create(&environment, &p->plain);
    if (result == BOLAN_OK) result = bolan_gl_target_create(&color, 1, NULL, -1, 0, &p->plain_target);
    if (result == BOLAN_OK) result = bolan_gl_texture_create(&environment, &p->environment);
    color = &p->environment;
    for (uint32_t l = 0; l < ENVIRONMENT_LEVELS && result == BOLAN_OK; l++) {
        result = bolan_gl_target_create(&color, 1, NULL, -1, l, &p->environment_target[l]);
    }
    if (result == BOLAN_OK) result = bolan_gl_texture_create(&light, &p->light);
    color = &p->light;
    if (result == BOLAN_OK) result = bolan_gl_target_create(&color, 1, NULL, -1, 0, &p->light_target);
    if (result == BOLAN_OK) result = bolan_blocks_create(&p->uniforms);
    return result;
}

static void fill_rectangle(uint32_t *to, uint32_t from_column, uint32_t to_column) {
    const uint32_t a = 2 * from_column, b = 2 * to_column; // each column has a lower and an upper corner
    const uint32_t order[RECTANGLE_INDICES] = {a, b, a + 1, a + 1, b, b + 1};
    memcpy(to, order, sizeof order);
}

static bolan_result create_mesh(pass_sky *p) {
    static const uint8_t components[] = {2};
    float corners[CORNERS][2];
    uint32_t indices[INDICES];
    for (int i = 0; i < CORNERS; i++) {
        corners[i][0] = (float)(i / 2) / COLUMNS;
        corners[i][1] = (float)(i % 2);
    }
    fill_rectangle(indices, 0, COLUMNS);
    for (uint32_t i = 0; i < COLUMNS; i++) fill_rectangle(indices + RECTANGLE_INDICES * (i + 1), i, i + 1);
    bolan_result result =
        bolan_gl_buffer_create(GL_BUFFER_VERTEX, GL_USAGE_STATIC, sizeof corners, corners, &p->corners);
    if (result == BOLAN_OK) {
        result = bolan_gl_buffer_create(GL_BUFFER_INDEX, GL_USAGE_STATIC, sizeof indices, indices, &p->indices);
    }
    if (result == BOLAN_OK) {
        result = bolan_gl_mesh_create(&p->corners, &p->indices, components, 1, (uint32_t)sizeof corners[0], &p->mesh);
    }
    return result;
}

static void share_programs(pass_sky *p, const pass_sky *from) {
    p->borrowed = true;
    memcpy(p->programs, from->programs, sizeof p->programs);
    p->pixels = from->pixels;
}

void bolan_pass_sky_share(pass_sky *p, const pass_sky *from) {
    bolan_atmosphere_share(&p->air, &from->air);
    bolan_clouds_share(&p->clouds, &from->clouds);
    p->host.program = from->host.program;
    share_programs(p, from);
}

bolan_result bolan_pass_sky_create(const gl_caps *caps, bool compute, const pass_sky *from, pass_sky **out) {
    *out = NULL;
    if (!caps->color_float) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_UNSUPPORTED,
                  "this OpenGL ES lacks EXT_color_buffer_float, which the sky needs");
        return BOLAN_ERROR_UNSUPPORTED;
    }
    pass_sky *p = allocate_for("the sky", sizeof *p);
    if (!p) return BOLAN_ERROR_MEMORY;
    bolan_result result = bolan_atmosphere_create(&p->air, from != NULL ? &from->air : NULL);
    if (result == BOLAN_OK) result = bolan_clouds_create(&p->clouds, from != NULL ? &from->clouds : NULL);
    if (result == BOLAN_OK) result = bolan_host_light_create(&p->host, from != NULL ? &from->host : NULL);
    if (from != NULL) share_programs(p, from);
    for (int i = 0; i < SKY_PROGRAMS && from == NULL && result == BOLAN_OK; i++)
        result = bolan_gl_program_create(sky_sources[i][0], sky_sources[i][1], &p->programs[i]);
    if (compute && from == NULL && result == BOLAN_OK)
        result = bolan_gl_program_create_compute("sky", NULL, &p->pixels);
    if (result == BOLAN_OK) result = create_targets(p);
    if (result == BOLAN_OK) result = create_mesh(p);
    if (result != BOLAN_OK) {
        bolan_pass_sky_destroy(&p);
        return result;
    }
    *out = p;
    return BOLAN_OK;
}

bolan_result bolan_pass_sky_reload(pass_sky *p) {
    bolan_result result = bolan_atmosphere_reload(&p->air);
    if (result == BOLAN_OK) result = bolan_clouds_reload(&p->clouds);
    if (result == BOLAN_OK) result = bolan_gl_program_reload(&p->host.program);
    for (int i = 0; i < SKY_PROGRAMS && result == BOLAN_OK; i++) result = bolan_gl_program_reload(&p->programs[i]);
    if (p->pixels.id && result == BOLAN_OK) result = bolan_gl_program_reload(&p->pixels);
    return result;
}

static void draw_environment(pass_sky *p, const bolan_environment *e) {
    bolan_gl_target_bind(&p->plain_target);
    if (e->cube != 0) {
        bolan_host_light_draw(&p->host, e, UNIT_OWN);
    } else {
        bolan_gl_texture_bind(&p->air.sea_view, UNIT_OWN);
        bolan_gl_program_use(&p->programs[SKY_ENVIRONMENT]);
        bolan_gl_draw_fullscreen();
    }
    p->host.drawn = *e;
    bolan_gl_texture_generate_mipmaps(&p->plain);
    bolan_gl_texture_bind(&p->plain, UNIT_OWN);
    for (int l = 0; l < ENVIRONMENT_LEVELS; l++) {
        bolan_gl_target_bind(&p->environment_target[l]);
        bolan_gl_program_float(&p->programs[SKY_PREFILTER], "level", (float)l);
        bolan_gl_draw_fullscreen();
    }
}

// As fine as the clouds in it.
static bool resize_panorama(pass_sky *p, uint32_t width, uint32_t height) {
    if (p->panorama_target.id && p->panorama.width == width && p->panorama.height == height) return true;
    bolan_gl_target_free(&p->panorama_target);
    bolan_gl_texture_free(&p->panorama);
    const gl_texture_desc d = {.format = GL_FMT_RGBA16F,
                               .width = width,
                               .height = height,
                               .filter = GL_FILTER_LINEAR,
                               .wrap = GL_WRAP_REPEAT_CLAMP};
    const gl_texture *color = &p->panorama;
    return bolan_gl_texture_create(&d, &p->panorama) == BOLAN_OK &&
           bolan_gl_target_create(&color, 1, NULL, -1, 0, &p->panorama_target) == BOLAN_OK;
}

static void draw_panorama(pass_sky *p) {
    const gl_texture *map = bolan_clouds_map(&p->clouds);
    if (!resize_panorama(p, map->width, map->height)) return;
    bolan_gl_set_state(&(gl_state){.color_write = true});
    bolan_gl_target_bind(&p->panorama_target);
    bolan_gl_program_use(&p->programs[SKY_PANORAMA]);
    bolan_gl_draw_fullscreen();
}

// Of the map before its levels are blurred, which spreads the bright horizon.
static void measure_light(pass_sky *p) {
    bolan_gl_texture_bind(&p->plain, UNIT_ENVIRONMENT);
    bolan_gl_target_bind(&p->light_target);
    bolan_gl_program_use(&p->programs[SKY_LIGHT]);
    bolan_gl_draw_fullscreen();
    p->unread = true;
}

// What the host says counts; what it leaves out was measured.
static void keep_given_light(pass_sky *p, const bolan_environment *e) {
    const bolan_vec3 sun = e->sun_direction.z > 0.0f ? e->sun_irradiance : bolan_v3(0.0f, 0.0f, 0.0f);
    const bolan_vec3 lights[] = {e->sky_irradiance, sun, sun};
    for (int i = e->sky_irradiance.x < 0.0f ? 1 : 0; i < 3; ++i) memcpy(p->measured + 4 * i, &lights[i], sizeof sun);
    p->measured[12] = 1.0f; // no cloud of Bolan's takes any
}

#define LIGHT_STEP 0.02 // turn of the sun within which a window keeps the light of its last frames [rad]

// Another light altogether would be seen for some frames.
static bool is_near(const pass_sky *p, bolan_vec3 sun) {
    return p->lit && bolan_v3_dot(sun, p->measured_sun) > (float)cos(LIGHT_STEP);
}

static void wait_for_light(pass_sky *p) {
    if (p->unread || bolan_gl_readback_is_under_way(&p->reading))
        bolan_gl_target_read_float(&p->light_target, 0, p->measured);
    bolan_gl_readback_cancel(&p->reading);
    p->unread = false;
}

// One copy at a time: what is measured meanwhile is read after it.
static void follow_light(pass_sky *p) {
    (void)bolan_gl_readback_end(&p->reading, p->measured);
    if (!p->unread || bolan_gl_readback_is_under_way(&p->reading)) return;
    bolan_gl_readback_begin(&p->reading, &p->light_target);
    p->unread = false;
}

// Brings the measured light to the CPU. A window that goes on shows the light of an earlier frame and never waits.
// other: the light comes from another environment.
static void read_light(pass_sky *p, const render_view *v, bolan_vec3 sun, bool other) {
    const bolan_environment *e = &v->frame->lighting.environment;
    if (v->progressive && !other && bolan_gl_readback_is_possible() && is_near(p, sun))
        follow_light(p);
    else
        wait_for_light(p);
    p->lit = true;
    p->measured_sun = sun;
    if (e->cube != 0) keep_given_light(p, e);
}

static float luminance(const float *c) { return 0.2126f * c[0] + 0.7152f * c[1] + 0.0722f * c[2]; }

// Automatic exposure, from the light that falls on the sea: as a photographer does, who opens up as the day fades, at
// first by less than half a stop for each stop of light (the sky about a low sun stays bright), then by nearly all of
// it, so that dusk is seen but looks darker than noon.
static float exposure(const pass_sky *p, const render_view *v, float unit) {
    const float noon_light = 0.25f, noon_exposure = 7.1f;
    const float direct = 0.18f * luminance(p->measured + 4) * p->measured[12];
    const float light = fmaxf((luminance(p->measured) + direct) / unit, 1e-10f);
    const float darker = fmaxf(log2f(noon_light / light), -1.0f); // in stops
    const float stops = 0.93f * darker - 2.7f * (1.0f - expf(-darker / 5.0f));
    // Seen from above, sunlit clouds are the scene.
    const frame_block *f = &v->frame->block;
    const float over =
        fminf(fmaxf((v->block.eye_height - f->cloud_base) / 2000.0f, 0.0f), 1.0f) * sqrtf(f->cloud_cover);
    return noon_exposure * exp2f(stops - 0.8f * over + (float)v->frame->lighting.exposure) / unit;
}

// A photographer sets the film for daylight and lets a little of the light's own color go, so that a cloud is white by
// day and an evening stays golden.
static bolan_vec3 white_balance(const pass_sky *p, float sun_z) {
    const float daylight[] = {1.0175f, 0.9998f, 0.9644f}; // on the sea, sun 60 degrees high; luminance 1
    const float adapted = 0.25f;
    const float *sky = p->measured, *sun = p->measured + 4;
    float light[3], gain[3];
    for (int c = 0; c < 3; ++c) light[c] = sky[c] + sun[c] * fmaxf(sun_z, 0.0f);
    const float grey = luminance(light);
    for (int c = 0; c < 3; ++c) {
        const float color = grey > 0.0f ? fminf(fmaxf(light[c] / grey / daylight[c], 0.05f), 20.0f) : 1.0f;
        gain[c] = 1.0f / (daylight[c] * powf(color, adapted));
    }
    return bolan_v3_scale(bolan_v3(gain[0], gain[1], gain[2]), 1.0f / luminance(gain));
}

static void set_light(const pass_sky *p, render_view *v) {
    const float *sky = p->measured, *sun = p->measured + 4;
    v->light.sky = bolan_v3(sky[0], sky[1], sky[2]);
    v->light.sun = bolan_v3(sun[0], sun[1], sun[2]);
    v->light.exposure =
        bolan_v3_scale(white_balance(p, v->frame->sun_direction.z), exposure(p, v, v->frame->block.radiance_unit));
}

#define SUN_STEP 0.0005 // between suns that the tables are made for [rad]: 0.3 % of the light of a sun at 5 degrees

// The frame's uniforms with sun and eye where the tables are made for them.
static block_values on_lattice(const render_view *v) {
    block_values u = {.frame = v->frame->block, .view = v->block};
    u.frame.sun_direction = bolan_sky_lattice_direction(v->frame->sun_direction, SUN_STEP);
    u.view.eye_height = (float)bolan_sky_lattice_height(u.view.eye_height);
    return u;
}

// Clouds are lit through the air of their own place and sun.
static bool update_clouds(pass_sky *p, render_view *v, cloud_work work) {
    bolan_blocks_upload(&p->uniforms, &p->clouds.uniforms);
    if (work == CLOUDS_ALL) (void)bolan_atmosphere_update(&p->air, &p->clouds.uniforms);
    bolan_atmosphere_bind(&p->air);
    bolan_gl_set_state(&(gl_state){.color_write = true});
    bolan_gl_texture_bind(&p->air.sea_view, UNIT_OWN);
    return bolan_clouds_march(&p->clouds, v, work);
}

// Everything made of the tables and the clouds together.
static void draw_maps(pass_sky *p, const bolan_environment *e) {
    draw_panorama(p);
    bolan_gl_set_state(&(gl_state){.color_write = true});
    draw_environment(p, e);
    measure_light(p);
}

void bolan_pass_sky_prepare(pass_sky *p, render_view *v) {
    const bolan_environment *e = &v->frame->lighting.environment;
    const cloud_work work = bolan_clouds_plan(&p->clouds, v);
    bool changed = work != CLOUDS_KEEP && update_clouds(p, v, work);
    bolan_clouds_place(&p->clouds, v);
    bolan_view_fill(v);
    block_values u = on_lattice(v);
    u.view.cloud_offset.x = u.view.cloud_offset.y = 0.0f; // the light is measured in the middle of the clouds' maps
    bolan_blocks_upload(&p->uniforms, &u);
    if (bolan_atmosphere_update(&p->air, &u)) changed = true;
    bolan_atmosphere_bind(&p->air);
    bolan_gl_texture_bind(bolan_clouds_map(&p->clouds), UNIT_CLOUDS);
    const bool turned = u.frame.sun_direction.x != p->lattice_sun.x || u.frame.sun_direction.y != p->lattice_sun.y;
    const bool other = bolan_host_light_is_new(&p->host, e);
    if (changed || turned || other) draw_maps(p, e);
    p->lattice_sun = u.frame.sun_direction;
    read_light(p, v, u.frame.sun_direction, other);
    bolan_gl_texture_bind(&p->environment, UNIT_ENVIRONMENT);
    set_light(p, v);
}

bolan_result bolan_pass_sky_map(pass_sky *p, uint32_t width, uint32_t height, float *rgba) {
    const gl_texture_desc desc = {.format = GL_FMT_RGBA32F, .width = width, .height = height};
    gl_texture texture = {.id = 0};
    const gl_texture *color = &texture;
    gl_target target = {.id = 0};
    gl_program program = {.id = 0};
    bolan_result result = bolan_gl_texture_create(&desc, &texture);
    if (result == BOLAN_OK) result = bolan_gl_target_create(&color, 1, NULL, -1, 0, &target);
    if (result == BOLAN_OK) result = bolan_gl_program_create("sky_map", NULL, &program);
    if (result == BOLAN_OK) {
        bolan_gl_set_state(&(gl_state){.color_write = true});
        bolan_gl_texture_bind(&p->panorama, UNIT_OWN);
        bolan_gl_target_bind(&target);
        bolan_gl_program_use(&program);
        bolan_gl_draw_fullscreen();
        bolan_gl_target_read_float(&target, 0, rgba);
    }
    bolan_gl_program_free(&program);
    bolan_gl_target_free(&target);
    bolan_gl_texture_free(&texture);
    return result;
}

static void draw_parts(const pass_sky *p) {
    bolan_gl_set_state(&(gl_state){.depth_test = true, .color_write = true});
    bolan_gl_program_use(&p->programs[SKY]);
    bolan_gl_mesh_draw(&p->mesh, 0, RECTANGLE_INDICES);
    bolan_gl_program_use(&p->programs[SKY_BELOW]);
    bolan_gl_mesh_draw(&p->mesh, RECTANGLE_INDICES, INDICES - RECTANGLE_INDICES);
}

void bolan_pass_sky_draw(pass_sky *p, const render_view *v, bool own) {
    bolan_gl_texture_bind(&p->panorama, UNIT_OWN);
    if (own && p->pixels.id) {
        bolan_gl_texture_bind(v->hdr_depth, UNIT_OWN + 1);
        bolan_gl_program_use(&p->pixels);
        bolan_pixels_draw(&p->pixels, &v->hdr, 0, v->height);
    } else {
        draw_parts(p);
    }
    if (v->frame->block.sun_direction.z < -0.1f) return; // below any horizon to 20 km
    bolan_gl_set_state(&(gl_state){.depth_test = true, .color_write = true, .blend = GL_BLEND_ADD});
    bolan_gl_program_use(&p->programs[SKY_SUN]);
    bolan_gl_draw_fullscreen();
}

void bolan_pass_sky_draw_over(pass_sky *p, const render_view *v) {
    if (v->block.eye_above_clouds < 0.5f || v->frame->block.cloud_cover <= 0.0f) return;
    bolan_gl_set_state(&(gl_state){.color_write = true, .blend = GL_BLEND_PREMULTIPLIED});
    bolan_gl_program_use(&p->programs[SKY_OVER]);
    bolan_gl_program_float(&p->programs[SKY_OVER], "rise", (float)bolan_clouds_rise(&p->clouds, v));
    bolan_gl_draw_fullscreen();
}

void bolan_pass_sky_destroy(pass_sky **pp) {
    if (!pp || !*pp) return;
    pass_sky *p = *pp;
    bolan_atmosphere_free(&p->air);
    bolan_host_light_free(&p->host);
    bolan_clouds_free(&p->clouds);
    for (int l = 0; l < ENVIRONMENT_LEVELS; l++) bolan_gl_target_free(&p->environment_target[l]);
    bolan_gl_target_free(&p->plain_target);
    bolan_gl_target_free(&p->light_target);
    bolan_gl_texture_free(&p->plain);
    bolan_gl_texture_free(&p->environment);
    bolan_gl_texture_free(&p->light);
    bolan_gl_readback_free(&p->reading);
    bolan_gl_target_free(&p->panorama_target);
    bolan_gl_texture_free(&p->panorama);
    bolan_gl_mesh_free(&p->mesh);
    bolan_gl_buffer_free(&p->corners);
    bolan_gl_buffer_free(&p->indices);
    for (int i = 0; i < SKY_PROGRAMS && !p->borrowed; i++) bolan_gl_program_free(&p->programs[i]);
    if (!p->borrowed) bolan_gl_program_free(&p->pixels);
    bolan_blocks_free(&p->uniforms);
    bolan_release(p, sizeof *p);
    *pp = NULL;
}
