// SPDX-License-Identifier: MIT
// Motion vectors against where the places of a picture really were in the frame before: of land, sky and objects by the
// cameras in double, of water by the parcels of the CPU's sea at both times.
#include "picture.h"

#include "../shaders/gl_support.h"

enum { WIDTH = 160, HEIGHT = 96, PIXELS = WIDTH * HEIGHT };

#define START 20.0 // [s]
#define STEP 0.1   // [s]

// A stage with a target for motion and what was read of its last frame, bottom row first.
typedef struct rig {
    stage s;
    bolan_target *target;
    gl_texture texture;
    gl_target motion_target;
    bolan_view before;
    float motion[4 * PIXELS];
    float distance[PIXELS]; // top row first
} rig;

static rig *open_rig(bolan_scene *scene) {
    rig *r = calloc(1, sizeof *r);
    scene->time = START;
    scene->sky.cloud_cover = 0.0;
    scene->sea.resolution = 128;
    assert_true(stage_open(&r->s, scene, BOLAN_QUALITY_LOW, false));
    assert_int_equal(bolan_target_create(WIDTH, HEIGHT, &r->target), BOLAN_OK);
    const gl_texture_desc desc = {.format = GL_FMT_RGBA32F, .width = WIDTH, .height = HEIGHT};
    const gl_texture *colors[] = {&r->texture};
    assert_int_equal(bolan_gl_texture_create(&desc, &r->texture), BOLAN_OK);
    assert_int_equal(bolan_gl_target_create(colors, 1, NULL, -1, 0, &r->motion_target), BOLAN_OK);
    return r;
}

static void close_rig(rig *r) {
    bolan_gl_target_free(&r->motion_target);
    bolan_gl_texture_free(&r->texture);
    bolan_target_destroy(&r->target);
    stage_close(&r->s);
    free(r);
}

static bolan_view begin(rig *r, double time) {
    bolan_view view = stage_view(&r->s, r->target, WIDTH, HEIGHT);
    view.motion.framebuffer = r->motion_target.id;
    view.motion.before = &r->before;
    view.motion.time = time;
    return view;
}

static void end(rig *r, const bolan_view *view) {
    bolan_renderer_draw_world(r->s.renderer, r->s.world, view);
    bolan_renderer_read_linear(r->s.renderer, NULL, r->distance);
    bolan_gl_target_read_float(&r->motion_target, 0, r->motion);
}

// Draws the frame before at START, then the camera moves and the sea goes on.
static bolan_view draw_two(rig *r, void (*change)(bolan_scene *), double step) {
    r->before = stage_view(&r->s, r->target, WIDTH, HEIGHT);
    bolan_view first = begin(r, START);
    end(r, &first);
    change(&r->s.scene);
    stage_step(&r->s, START + step);
    const bolan_view view = begin(r, START);
    end(r, &view);
    return view;
}

// ---- in double ------------------------------------------------------------------------------------------------------

static bolan_dvec3 camera_of(const bolan_view *v, bolan_dvec3 p) { // relative to its eye
    const float *m = v->view.m;
    return (bolan_dvec3){(double)m[0] * p.x + (double)m[4] * p.y + (double)m[8] * p.z,
                         (double)m[1] * p.x + (double)m[5] * p.y + (double)m[9] * p.z,
                         (double)m[2] * p.x + (double)m[6] * p.y + (double)m[10] * p.z};
}

// Pixel of a place of the world, or of a direction.
static bolan_dvec2 pixel_of(const bolan_view *v, bolan_dvec3 p, bool direction) {
    const bolan_dvec3 from = direction ? p : (bolan_dvec3){p.x - v->eye.x, p.y - v->eye.y, p.z - v->eye.z};
    const bolan_dvec3 c = camera_of(v, from);
    return (bolan_dvec2){0.5 * WIDTH * ((double)v->projection.m[0] * c.x / -c.z + 1.0),
                         0.5 * HEIGHT * ((double)v->projection.m[5] * c.y / -c.z + 1.0)};
}

// The direction of a pixel's middle, of length 1 along the axis; y from the bottom.
static bolan_dvec3 ray_of(const bolan_view *v, double x, double y) {
    const double c[3] = {(2.0 * x / WIDTH - 1.0) / (double)v->projection.m[0],
                         (2.0 * y / HEIGHT - 1.0) / (double)v->projection.m[5], -1.0};
    const float *m = v->view.m;
    double d[3] = {0};
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) d[i] += (double)m[4 * i + k] * c[k];
    return (bolan_dvec3){d[0], d[1], d[2]};
}

static double distance_at(const rig *r, int x, int y) { return (double)r->distance[(HEIGHT - 1 - y) * WIDTH + x]; }

static bolan_dvec3 place_of(const rig *r, const bolan_view *v, int x, int y) {
    const bolan_dvec3 ray = ray_of(v, x + 0.5, y + 0.5);
    const double d = distance_at(r, x, y);
    return (bolan_dvec3){v->eye.x + d * ray.x, v->eye.y + d * ray.y, v->eye.z + d * ray.z};
}

static double error_of(const rig *r, int x, int y, bolan_dvec2 now, bolan_dvec2 before) {
    const float *m = r->motion + 4 * (y * WIDTH + x);
    return hypot((double)m[0] - (before.x - now.x), (double)m[1] - (before.y - now.y));
}

static void move_camera(bolan_scene *s) {
    s->camera.position.x += 0.4;
    s->camera.position.z += 0.1;
    s->camera.heading_deg += 1.0;
    s->camera.pitch_deg -= 0.5;
}

static void move_nothing(bolan_scene *s) { (void)s; }

static bolan_scene scene_of(const char *name, double height, double pitch_deg) {
    bolan_scene s;
    assert_int_equal(bolan_scene_load(name, &s), BOLAN_OK);
    s.camera.position.z = height;
    s.camera.pitch_deg = pitch_deg;
    return s;
}

// ---- tests ----------------------------------------------------------------------------------------------------------

static void a_still_world_has_no_motion_whatever_the_jitter(void **state) {
    (void)state;
    bolan_scene scene = scene_of("island", 12.0, -6.0);
    rig *r = open_rig(&scene);
    draw_two(r, move_nothing, 0.0);
    bolan_view view = begin(r, START);
    view.jitter = (bolan_vec2){0.37f, -0.21f};
    r->before.jitter = (bolan_vec2){-0.4f, 0.1f};
    end(r, &view);
    for (int i = 0; i < PIXELS; i++)
        if (r->motion[4 * i] != 0.0f || r->motion[4 * i + 1] != 0.0f)
            fail_msg("pixel %d moves by %g, %g", i, (double)r->motion[4 * i], (double)r->motion[4 * i + 1]);
    close_rig(r);
}

// The sea stands still, so that every place does.
static void the_camera_s_motion_is_that_of_places_and_directions(void **state) {
    (void)state;
    bolan_scene scene = scene_of("island", 12.0, -3.0);
    rig *r = open_rig(&scene);
    const bolan_view view = draw_two(r, move_camera, 0.0);
    double worst = 0.0;
    uint32_t sky = 0;
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++) {
            const bool up = isinf(distance_at(r, x, y));
            const bolan_dvec3 p = up ? ray_of(&view, x + 0.5, y + 0.5) : place_of(r, &view, x, y);
            worst = fmax(worst, error_of(r, x, y, pixel_of(&view, p, up), pixel_of(&r->before, p, up)));
            sky += up;
        }
    print_message("largest error %.2g px, %u pixels of sky\n", worst, sky);
    assert_true(sky > 1000 && sky < PIXELS - 5000);
    assert_true(worst < 5e-4); // measured 3e-5: the rounding of floats, 1e-7 of some 100 px, and of the depth read back
    close_rig(r);
}

// The rest point whose parcel is above a place.
static bolan_dvec2 rest_of(const bolan_sea *sea, bolan_dvec3 p, bolan_sea_sample *there) {
    bolan_dvec2 rest = {p.x, p.y};
    for (int i = 0; i < 30; i++) {
        bolan_sea_sample_rest(sea, &rest, 1, there);
        rest = (bolan_dvec2){p.x - (double)there->dx, p.y - (double)there->dy};
    }
    return rest;
}

// Root mean squares over the water: of the error, and of the motion itself.
static void compare_water(const rig *r, const bolan_view *view, const bolan_sea *before, double drift, double out[2]) {
    const bolan_sea *sea = stage_sea(&r->s);
    uint32_t count = 0;
    out[0] = out[1] = 0.0;
    for (int y = 0; y < HEIGHT; y += 3)
        for (int x = 0; x < WIDTH; x += 3) {
            if (!(distance_at(r, x, y) < 200.0)) continue;
            const bolan_dvec3 p = place_of(r, view, x, y);
            bolan_sea_sample now, then;
            bolan_dvec2 rest = rest_of(sea, p, &now);
            const bolan_dvec2 drifted = {rest.x - drift, rest.y};
            bolan_sea_sample_rest(before, &drifted, 1, &then);
            const bolan_dvec3 was = {p.x + (double)(then.dx - now.dx) - drift, p.y + (double)(then.dy - now.dy),
                                     p.z + (double)(then.height - now.height)};
            const bolan_dvec2 here = pixel_of(view, p, false), there = pixel_of(&r->before, was, false);
            const double e = error_of(r, x, y, here, there), m = hypot(there.x - here.x, there.y - here.y);
            out[0] += e * e;
            out[1] += m * m;
            count++;
        }
    assert_true(count > 300);
    out[0] = sqrt(out[0] / count);
    out[1] = sqrt(out[1] / count);
}

static void check_water(double current, uint32_t order, double most) {
    bolan_scene scene = scene_of("open-sea", 8.0, -12.0);
    scene.sea.sea_state.current_x = current;
    scene.sea.order = order;
    rig *r = open_rig(&scene);
    bolan_sea *before = NULL;
    assert_int_equal(bolan_sea_fork(stage_sea(&r->s), &before), BOLAN_OK);
    bolan_sea_step(before, START);
    const bolan_view view = draw_two(r, move_nothing, STEP);
    double rms[2];
    compare_water(r, &view, before, current * STEP, rms);
    print_message("current %g, order %u: motion %.3f px rms, error %.4f\n", current, order, rms[1], rms[0]);
    assert_true(rms[1] > 0.3);
    assert_true(rms[0] < most);
    bolan_sea_destroy(&before);
    close_rig(r);
}

// Measured 0.009 px: vertices are 8 pixels apart and do not carry the shorter waves, and halfs hold the fields.
static void water_moves_with_its_parcels(void **state) {
    (void)state;
    check_water(0.0, 1, 0.02);
    check_water(3.0, 2, 0.02);
}

static uint32_t moved_object;
static void move_object(bolan_scene *s) {
    s->objects[moved_object].position.x += 0.25;
    s->objects[moved_object].position.z += 0.1;
}

static void objects_move_by_their_poses(void **state) {
    (void)state;
    bolan_scene scene;
    assert_int_equal(bolan_scene_load("pond", &scene), BOLAN_OK);
    scene.camera = (bolan_camera){.position = {9.0, 20.0, 2.5}, .fov_deg = 40.0}; // before the house, at (9, 42)
    for (uint32_t i = 0; i < scene.object_count; i++)
        if (hypot(scene.objects[i].position.x - 9.0, scene.objects[i].position.y - 42.0) < 2.0) moved_object = i;
    rig *r = open_rig(&scene);
    const bolan_view view = draw_two(r, move_object, STEP);
    const int x = WIDTH / 2, y = HEIGHT / 2; // its front wall
    const bolan_dvec3 p = place_of(r, &view, x, y), was = {p.x - 0.25, p.y, p.z - 0.1};
    const double error = error_of(r, x, y, pixel_of(&view, p, false), pixel_of(&r->before, was, false));
    print_message("house: %.4f, %.4f px, error %.2g\n", (double)r->motion[4 * (y * WIDTH + x)],
                  (double)r->motion[4 * (y * WIDTH + x) + 1], error);
    assert_true(error < 5e-4); // as above
    // the top of the wood above its roof stands still
    const float *still = r->motion + 4 * (2 * WIDTH + 2);
    assert_true(still[0] == 0.0f && still[1] == 0.0f);
    close_rig(r);
}

// In a host's frame the water's pixels alone are written, and those as in a world.
static void a_host_gets_the_water_s_motion_alone(void **state) {
    (void)state;
    bolan_scene scene = scene_of("open-sea", 8.0, -4.0);
    rig *r = open_rig(&scene);
    const bolan_view view = draw_two(r, move_camera, STEP);
    float *world = malloc(sizeof r->motion);
    memcpy(world, r->motion, sizeof r->motion);
    const bolan_lighting lighting = bolan_lighting_from_scene(&r->s.scene);
    bolan_gl_target_bind(&r->motion_target);
    bolan_gl_target_clear_color(777.0f, 0.0f, 0.0f, 0.0f);
    bolan_renderer_prepare(r->s.renderer, bolan_world_water(r->s.world), &lighting);
    bolan_renderer_draw_water(r->s.renderer, &view, NULL);
    bolan_gl_target_read_float(&r->motion_target, 0, r->motion);
    uint32_t water = 0, sky = 0;
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++) {
            const float *got = r->motion + 4 * (y * WIDTH + x), *want = world + 4 * (y * WIDTH + x);
            const bool up = isinf(distance_at(r, x, y));
            if (up ? got[0] != 777.0f : got[0] != want[0] || got[1] != want[1])
                fail_msg("pixel %d, %d: %g", x, y, (double)got[0]);
            water += !up;
            sky += up;
        }
    assert_true(water > 1000 && sky > 1000);
    free(world);
    close_rig(r);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        IN_BOTH_APIS(a_still_world_has_no_motion_whatever_the_jitter),
        IN_BOTH_APIS(the_camera_s_motion_is_that_of_places_and_directions),
        IN_BOTH_APIS(water_moves_with_its_parcels),
        IN_BOTH_APIS(objects_move_by_their_poses),
        IN_BOTH_APIS(a_host_gets_the_water_s_motion_alone),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
