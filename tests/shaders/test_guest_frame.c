// SPDX-License-Identifier: MIT
// The water in a host's frame against the path that a host would write by hand: Bolan's distance read back, and each
// pixel decided on the CPU. Coverage, depth in each convention, mask, bounds, viewport rectangle.
#include "gl_support.h"

#include "bolan/query.h"

#include <epoxy/gl.h>
#include <string.h>

enum { WIDTH = 96, HEIGHT = 64, PIXELS = WIDTH * HEIGHT };

// ---- the host -------------------------------------------------------------------------------------------------------

// A frame of the host's, filled on the CPU: colour and depth as textures, its framebuffer of them.
typedef struct host_frame {
    GLuint color, depth, framebuffer;
    bolan_view view;
} host_frame;

typedef struct pixels {
    float rgb[PIXELS][4], distance[PIXELS]; // bottom row first; along the view axis, infinite where nothing is
} pixels;

static GLuint texture_of(GLint format, GLenum components, const void *data) {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexImage2D(GL_TEXTURE_2D, 0, format, WIDTH, HEIGHT, 0, components, GL_FLOAT, data);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return name;
}

// Window depth of a distance by the projection, as the hardware makes it.
static float depth_of(const bolan_view *v, double distance) {
    const float *m = v->projection.m;
    double clip;
    if (isinf(distance))
        clip = -(double)m[10];
    else
        clip = ((double)m[14] - (double)m[10] * distance) / distance;
    return (float)(v->zero_to_one ? clip : 0.5 * clip + 0.5);
}

static double distance_of(const bolan_view *v, double depth) {
    const float *m = v->projection.m;
    const double clip = v->zero_to_one ? depth : 2.0 * depth - 1.0;
    return (double)m[14] / (clip + (double)m[10]);
}

static float far_depth(const bolan_view *v) { return v->projection.m[14] > 0.0f ? 0.0f : 1.0f; }

static void fill(host_frame *h, const pixels *p) {
    static float depth[PIXELS];
    for (int i = 0; i < PIXELS; i++)
        depth[i] = isinf(p->distance[i]) ? far_depth(&h->view) : depth_of(&h->view, (double)p->distance[i]);
    glBindTexture(GL_TEXTURE_2D, h->color);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, WIDTH, HEIGHT, GL_RGBA, GL_FLOAT, p->rgb);
    glDeleteTextures(1, &h->depth);
    glBindFramebuffer(GL_FRAMEBUFFER, h->framebuffer);
    h->depth = texture_of(GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, depth);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, h->color, 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, h->depth, 0);
    assert_int_equal(glCheckFramebufferStatus(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
}

static void read(const host_frame *h, pixels *out) {
    static float rgba[PIXELS][4], depth[PIXELS];
    glBindFramebuffer(GL_FRAMEBUFFER, h->framebuffer);
    glReadPixels(0, 0, WIDTH, HEIGHT, GL_RGBA, GL_FLOAT, rgba);
    read_depths(&(gl_texture){.id = h->depth,
                              .target = GL_TEXTURE_2D,
                              .width = WIDTH,
                              .height = HEIGHT,
                              .depth = 1,
                              .levels = 1,
                              .format = GL_FMT_DEPTH32F},
                depth);
    for (int i = 0; i < PIXELS; i++) {
        for (int c = 0; c < 3; c++) out->rgb[i][c] = rgba[i][c];
        const bool nothing = depth[i] == far_depth(&h->view);
        out->distance[i] = nothing ? INFINITY : (float)distance_of(&h->view, (double)depth[i]);
    }
}

// ---- a rig ----------------------------------------------------------------------------------------------------------

typedef struct rig {
    bolan_context *context;
    bolan_sea *sea;
    bolan_renderer *renderer;
    bolan_water water;
    bolan_lighting lighting;
    host_frame host;
} rig;

static bolan_mat4 projection(float a, float b, float shift) {
    bolan_mat4 m = {{0.0f}};
    m.m[0] = 1.6f;
    m.m[5] = 1.6f * WIDTH / HEIGHT;
    m.m[8] = shift;
    m.m[9] = -0.2f;
    m.m[10] = a;
    m.m[11] = -1.0f;
    m.m[14] = b;
    return m;
}

// Made once for all tests of an API: what takes long is a renderer's programs.
static int open_rig(void **state, bolan_gl_api api) {
    static rig r;
    memset(&r, 0, sizeof r);
    if (gl_setup((void **)&r.context, api) != 0) return -1;
    bolan_sea_desc sea = bolan_sea_desc_default();
    sea.sea_state = bolan_sea_state_from_wind(8.0, 270.0, 100e3);
    sea.resolution = 64;
    assert_int_equal(bolan_sea_create(&sea, &r.sea), BOLAN_OK);
    bolan_sea_step(r.sea, 3.0);
    bolan_renderer_desc desc = bolan_renderer_desc_default();
    assert_int_equal(bolan_renderer_create(&desc, &r.renderer), BOLAN_OK);
    r.water = bolan_water_default();
    r.water.sea = r.sea;
    r.water.level = 1.5;
    r.lighting = bolan_lighting_default();
    r.host.color = texture_of(GL_RGBA16F, GL_RGBA, NULL);
    glGenFramebuffers(1, &r.host.framebuffer);
    *state = &r;
    return 0;
}

static int open_core(void **state) { return open_rig(state, BOLAN_GL_CORE); }
static int open_es(void **state) { return open_rig(state, BOLAN_GL_ES); }

static int close_rig(void **state) {
    rig *r = *state;
    glDeleteFramebuffers(1, &r->host.framebuffer);
    glDeleteTextures(1, &r->host.color);
    glDeleteTextures(1, &r->host.depth);
    bolan_renderer_destroy(&r->renderer);
    bolan_sea_destroy(&r->sea);
    return gl_teardown((void **)&r->context);
}

// The rig with the view that each test starts from.
static rig *start(void **state) {
    rig *r = *state;
    bolan_view *v = &r->host.view;
    *v = bolan_view_default();
    v->eye = (bolan_dvec3){100.0, -200.0, 6.0};
    v->view = bolan_m4_view(20.0, -8.0, 3.0);
    v->projection = projection(0.0f, 0.1f, 0.15f);
    v->zero_to_one = true;
    v->width = WIDTH;
    v->height = HEIGHT;
    v->output = BOLAN_OUTPUT_LINEAR;
    v->framebuffer = r->host.framebuffer;
    bolan_renderer_prepare(r->renderer, &r->water, &r->lighting);
    return r;
}

static int end(void **state) {
    (void)state;
    return watch_is_clean("at the end of the test") ? 0 : -1;
}

static void draw(rig *r, const pixels *scene, bolan_host given, pixels *out) {
    fill(&r->host, scene);
    if (given.color != 0) {
        given.color = r->host.color;
        given.depth = r->host.depth;
        given.x = r->host.view.x;
        given.y = r->host.view.y;
    }
    bolan_renderer_draw_water(r->renderer, &r->host.view, &given);
    read(&r->host, out);
}

static bolan_host with_scene(void) {
    bolan_host h = bolan_host_default();
    h.color = 1; // draw() puts the names in
    return h;
}

// Nothing but a background of that brightness.
static void clear(pixels *p, float brightness) {
    for (int i = 0; i < PIXELS; i++) {
        for (int c = 0; c < 3; c++) p->rgb[i][c] = brightness;
        p->distance[i] = INFINITY;
    }
}

// The middle third of the picture is a wall across the view at that distance.
static void put_wall(pixels *p, float distance) {
    for (int i = 0; i < PIXELS; i++)
        if (i % WIDTH >= WIDTH / 3 && i % WIDTH < 2 * WIDTH / 3) {
            p->distance[i] = distance;
            p->rgb[i][0] = 3.0f;
            p->rgb[i][1] = p->rgb[i][2] = 0.0f;
        }
}

// World position of what is seen at a pixel, at that distance along the axis.
static bolan_dvec3 place_of(const rig *r, int pixel, double distance) {
    const float *m = r->host.view.projection.m;
    const double x = 2.0 * (pixel % WIDTH + 0.5) / WIDTH - 1.0, y = 2.0 * (pixel / WIDTH + 0.5) / HEIGHT - 1.0;
    const double to[3] = {(x + (double)m[8]) / (double)m[0] * distance, (y + (double)m[9]) / (double)m[5] * distance,
                          -distance};
    const float *v = r->host.view.view.m;
    double world[3];
    for (int axis = 0; axis < 3; axis++)
        world[axis] = to[0] * (double)v[4 * axis] + to[1] * (double)v[4 * axis + 1] + to[2] * (double)v[4 * axis + 2];
    return (bolan_dvec3){r->host.view.eye.x + world[0], r->host.view.eye.y + world[1], r->host.view.eye.z + world[2]};
}

// ---- tests ----------------------------------------------------------------------------------------------------------

static pixels scene, alone, got;

// What is read back from the host's depth is the water that a query answers, however the camera is turned; no ray that
// must meet the water misses it.
static void check_depths(rig *r, double heading, double pitch, double roll, float reach, int least) {
    r->host.view.view = bolan_m4_view(heading, pitch, roll);
    clear(&scene, 0.25f);
    draw(r, &scene, bolan_host_default(), &got);
    int water = 0, compared = 0, apart = 0;
    double sum = 0.0;
    for (int i = 0; i < PIXELS; i++) {
        if (isinf(got.distance[i])) {
            for (int c = 0; c < 3; c++) assert_near(got.rgb[i][c], 0.25, 0.0);
            assert_true(place_of(r, i, 40.0).z > r->water.level); // 40 m on, or as near as a slanting ray comes
            continue;
        }
        water++;
        if (got.distance[i] > reach) continue; // there the mesh is coarser than the waves
        const bolan_dvec3 p = place_of(r, i, (double)got.distance[i]);
        bolan_query_point q;
        bolan_query_surface(&r->water, &(bolan_dvec2){p.x, p.y}, 1, &q);
        apart += fabs(p.z - (double)q.height) > 0.3;
        sum += (p.z - (double)q.height) * (p.z - (double)q.height);
        compared++;
    }
    assert_true(compared > PIXELS / 4);
    // The mesh of so small a picture lacks the shortest waves, so crests may be cut.
    assert_near(sqrt(sum / compared), 0.0, 0.06);
    assert_in_range(apart, 0, compared / 500);
    assert_in_range(water, least, PIXELS);
}

static void the_depth_written_is_that_of_the_water(void **state) {
    rig *r = start(state);
    check_depths(r, 20.0, -8.0, 3.0, 25.0f, PIXELS / 3);
    check_depths(r, 200.0, -20.0, 50.0, 25.0f, PIXELS / 3);
    check_depths(r, 100.0, -55.0, -120.0, 25.0f, PIXELS / 2);
    r->host.view.projection.m[8] = 1.5f; // far to one side of the axis
    check_depths(r, 200.0, -45.0, 60.0, 14.0f, PIXELS / 3);
    check_depths(r, 200.0, -45.0, -60.0, 14.0f, PIXELS / 3);
    r->host.view.projection.m[8] = r->host.view.projection.m[9] = 0.0f;
    check_depths(r, 300.0, -60.0, 200.0, 25.0f, PIXELS);
    check_depths(r, 35.0, -90.0, 0.0, 25.0f, PIXELS); // straight down
}

// By hand: the water where it is nearer than the wall, the wall where it is nearer than the water.
static void coverage_equals_a_composite_by_hand(void **state) {
    rig *r = start(state);
    clear(&scene, 0.25f);
    draw(r, &scene, bolan_host_default(), &alone);
    for (float distance = 8.0f; distance < 200.0f; distance *= 1.7f) {
        clear(&scene, 0.25f);
        put_wall(&scene, distance);
        for (int textures = 0; textures < 2; textures++) { // by the framebuffer's depth alone, and with textures
            int walls = 0, waters = 0;
            draw(r, &scene, textures ? with_scene() : bolan_host_default(), &got);
            for (int i = 0; i < PIXELS; i++) {
                const bool wall = !isinf(scene.distance[i]);
                if (fabsf(alone.distance[i] - scene.distance[i]) < 1e-3f * scene.distance[i]) continue; // either
                const bool water = alone.distance[i] < scene.distance[i];
                const float *from = water ? alone.rgb[i] : scene.rgb[i];
                const double want = (double)(water ? alone.distance[i] : scene.distance[i]);
                if (isinf(want))
                    assert_true(isinf(got.distance[i]));
                else
                    assert_near(got.distance[i], want, 1e-3 * want);
                // seen through textures the water shows the wall, by reflection and under it
                for (int c = 0; c < 3 && !(water && textures); c++)
                    assert_near(got.rgb[i][c], from[c], 2e-3 * (double)fabsf(from[c]) + 1e-4);
                walls += wall && !water;
                waters += wall && water;
            }
            assert_true(distance > 100.0f || walls > 20);
            assert_true(distance < 20.0f || waters > 20);
        }
    }
}

// The same picture and the same distances whatever depth buffer the host keeps.
static void every_depth_convention_gives_the_same_water(void **state) {
    const float n = 0.5f, f = 3000.0f;
    const struct {
        float a, b;
        bool zero_to_one;
    } kinds[] = {
        {0.0f, n, true},                                      // reversed, infinite, [0,1]
        {n / (f - n), n * f / (f - n), true},                 // reversed, finite, [0,1]
        {-f / (f - n), -n * f / (f - n), true},               // standard, finite, [0,1]
        {-(f + n) / (f - n), -2.0f * f * n / (f - n), false}, // standard, finite, [-1,1]
        {-1.0f, -2.0f * n, false},                            // standard, infinite, [-1,1]
        {1.0f, 2.0f * n, false},                              // reversed, infinite, [-1,1]
    };
    rig *r = start(state);
    for (int k = 0; k < 6; k++) {
        r->host.view.projection = projection(kinds[k].a, kinds[k].b, 0.15f);
        r->host.view.zero_to_one = kinds[k].zero_to_one;
        clear(&scene, 0.25f);
        put_wall(&scene, 30.0f);
        draw(r, &scene, with_scene(), k == 0 ? &alone : &got);
        int different = 0;
        for (int i = 0; i < PIXELS && k > 0; i++) {
            const double want = (double)alone.distance[i], away = fabs((double)got.distance[i] - want);
            if (want > 500.0) continue; // a standard depth buffer has a few bits left there
            different += away > 2e-3 * want || fabsf(got.rgb[i][0] - alone.rgb[i][0]) > 0.02f;
        }
        if (different > PIXELS / 200) fail_msg("convention %d: %d pixels differ", k, different);
    }
}

// The mask's pixel of a pixel of the view lies as much to the right and above as `x` and `y` say.
static void no_water_under_a_mask(void **state) {
    enum { X = 5, Y = 3 };
    static float mask[PIXELS];
    rig *r = start(state);
    r->host.view.width = WIDTH - X;
    r->host.view.height = HEIGHT - Y;
    clear(&scene, 0.25f);
    draw(r, &scene, bolan_host_default(), &alone);
    for (int i = 0; i < PIXELS; i++) mask[i] = (i % WIDTH) / 7 % 2 != i / WIDTH % 2 ? 0.52f : 0.48f;
    bolan_host host = bolan_host_default();
    host.mask = texture_of(GL_R32F, GL_RED, mask);
    host.x = X;
    host.y = Y;
    draw(r, &scene, host, &got);
    int cut = 0;
    for (int i = 0; i < PIXELS; i++) {
        const bool inside = i % WIDTH < WIDTH - X && i / WIDTH < HEIGHT - Y;
        const bool masked = inside && mask[i + Y * WIDTH + X] > 0.5f;
        assert_true(got.distance[i] == (masked ? INFINITY : alone.distance[i]));
        assert_near(got.rgb[i][1], masked ? 0.25f : alone.rgb[i][1], 1e-6);
        cut += masked && !isinf(alone.distance[i]);
    }
    assert_true(cut > PIXELS / 8);
    glDeleteTextures(1, &host.mask);
}

// Even-odd, by the angle that the corners turn round the point: another way than the shader's.
static bool is_inside(const bolan_dvec2 *corners, uint32_t count, bolan_dvec3 p) {
    double turn = 0.0;
    for (uint32_t i = 0; i < count; i++) {
        const bolan_dvec2 a = corners[i], b = corners[(i + 1) % count];
        const double ax = a.x - p.x, ay = a.y - p.y, bx = b.x - p.x, by = b.y - p.y;
        turn += atan2(ax * by - ay * bx, ax * bx + ay * by);
    }
    return fabs(turn) > BOLAN_PI;
}

static double distance_to_sides(const bolan_dvec2 *corners, uint32_t count, bolan_dvec3 p) {
    double least = INFINITY;
    for (uint32_t i = 0; i < count; i++) {
        const bolan_dvec2 a = corners[i], b = corners[(i + 1) % count];
        const double dx = b.x - a.x, dy = b.y - a.y;
        const double t = fmin(fmax(((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy), 0.0), 1.0);
        least = fmin(least, hypot(p.x - a.x - t * dx, p.y - a.y - t * dy));
    }
    return least;
}

// The water is cut where its surface crosses the sides of a polygon that is not convex.
static void water_ends_at_its_bounds(void **state) {
    rig *r = start(state);
    const bolan_dvec3 e = r->host.view.eye;
    const bolan_dvec2 corners[] = {{e.x - 8.0, e.y + 10.0},
                                   {e.x + 20.0, e.y + 12.0},
                                   {e.x + 26.0, e.y + 60.0},
                                   {e.x + 12.0, e.y + 30.0},
                                   {e.x - 4.0, e.y + 70.0}};
    clear(&scene, 0.25f);
    draw(r, &scene, bolan_host_default(), &alone);
    bolan_host host = bolan_host_default();
    host.bounds = corners;
    host.bounds_count = 5;
    draw(r, &scene, host, &got);
    int inside = 0, outside = 0;
    for (int i = 0; i < PIXELS; i++) {
        if (!isinf(got.distance[i])) { // whatever is drawn is inside
            const bolan_dvec3 p = place_of(r, i, (double)got.distance[i]);
            assert_true(is_inside(corners, 5, p) || distance_to_sides(corners, 5, p) < 0.05);
        }
        if (isinf(alone.distance[i])) continue;
        const bolan_dvec3 p = place_of(r, i, (double)alone.distance[i]);
        if (distance_to_sides(corners, 5, p) < 0.05) continue;
        const bool in = is_inside(corners, 5, p);
        if (in) { // nothing of it is missing, and it is lit as if it had no end
            assert_near(got.distance[i], alone.distance[i], 1e-3 * (double)alone.distance[i]);
            // two columns share samples, of which those beside the end have water on one side only
            const bool between = i % WIDTH > 0 && i % WIDTH < WIDTH - 1;
            if (between && !isinf(got.distance[i - 1]) && !isinf(got.distance[i + 1]))
                assert_near(got.rgb[i][1], alone.rgb[i][1], 1e-3);
        }
        inside += in;
        outside += !in && isinf(got.distance[i]);
    }
    assert_true(inside > 200 && outside > 200);
}

// A second water, higher and in a basin of its own, does not touch the first, and is hidden by what stands before it.
static void two_waters_share_a_frame(void **state) {
    rig *r = start(state);
    const bolan_dvec3 e = r->host.view.eye;
    const bolan_dvec2 basin[] = {
        {e.x, e.y + 15.0}, {e.x + 15.0, e.y + 15.0}, {e.x + 15.0, e.y + 30.0}, {e.x, e.y + 30.0}};
    clear(&scene, 0.25f);
    draw(r, &scene, bolan_host_default(), &alone);
    bolan_water high = r->water;
    high.level = r->water.level + 2.5;
    bolan_host host = bolan_host_default();
    host.bounds = basin;
    host.bounds_count = 4;
    bolan_renderer_prepare(r->renderer, &high, &r->lighting);
    bolan_renderer_draw_water(r->renderer, &r->host.view, &host);
    read(&r->host, &got);
    int upper = 0;
    for (int i = 0; i < PIXELS; i++) {
        if (got.distance[i] == alone.distance[i]) {
            assert_near(got.rgb[i][2], alone.rgb[i][2], 0.0);
            continue;
        }
        const bolan_dvec3 p = place_of(r, i, (double)got.distance[i]);
        bolan_query_point q;
        bolan_query_surface(&high, &(bolan_dvec2){p.x, p.y}, 1, &q);
        assert_true(got.distance[i] < alone.distance[i]);
        assert_true(is_inside(basin, 4, p) || distance_to_sides(basin, 4, p) < 0.05);
        assert_near(p.z, q.height, 0.4);
        upper++;
    }
    assert_true(upper > 100);
}

// Only the rectangle of the view is touched.
static void nothing_outside_the_rectangle_is_touched(void **state) {
    rig *r = start(state);
    clear(&scene, 0.25f);
    r->host.view.x = 16;
    r->host.view.y = 8;
    r->host.view.width = WIDTH / 2;
    r->host.view.height = HEIGHT / 2;
    draw(r, &scene, with_scene(), &got);
    int water = 0;
    for (int i = 0; i < PIXELS; i++) {
        const int x = i % WIDTH - 16, y = i / WIDTH - 8;
        const bool inside = x >= 0 && x < WIDTH / 2 && y >= 0 && y < HEIGHT / 2;
        water += inside && !isinf(got.distance[i]);
        if (!inside) assert_true(isinf(got.distance[i]) && got.rgb[i][0] == 0.25f);
    }
    assert_true(water > PIXELS / 12);
}

#define TEST(f) cmocka_unit_test_teardown(f, end)

int main(void) {
    const struct CMUnitTest tests[] = {
        TEST(the_depth_written_is_that_of_the_water),
        TEST(coverage_equals_a_composite_by_hand),
        TEST(every_depth_convention_gives_the_same_water),
        TEST(no_water_under_a_mask),
        TEST(water_ends_at_its_bounds),
        TEST(two_waters_share_a_frame),
        TEST(nothing_outside_the_rectangle_is_touched),
    };
    const int core = cmocka_run_group_tests_name("water in a host's frame (core)", tests, open_core, close_rig);
    return core + cmocka_run_group_tests_name("water in a host's frame (es)", tests, open_es, close_rig);
}
