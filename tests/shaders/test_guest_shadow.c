// SPDX-License-Identifier: MIT
// A host's shadow map on the water: where a ray to the sun meets a board over the sea the sun's light is missing, and
// nowhere else; the board's place is traced on the CPU.
#include "gl_support.h"

#include <epoxy/gl.h>
#include <string.h>

enum { WIDTH = 96, HEIGHT = 64, PIXELS = WIDTH * HEIGHT, MAP = 256 };
#define BOARD_HEIGHT 8.0 // over the eye [m]
#define MAP_SIDE 110.0   // [m]
#define MAP_RANGE 200.0  // of its depth [m]

static const double board[4] = {-6.0, 9.0, 14.0, 40.0}; // west, east, south, north of it from the eye [m]

typedef struct rig {
    bolan_sea *sea;
    bolan_renderer *renderer;
    bolan_target *target;
    bolan_water water;
    bolan_lighting lighting;
    bolan_view view;
    GLuint cube, map;
    double a[3], b[3], sun[3]; // axes of the map, and to the sun
} rig;

static double dot3(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static bool is_on_board(double x, double y) {
    return x >= board[0] && x <= board[1] && y >= board[2] && y <= board[3];
}

static GLuint shadow_map(const rig *r) {
    static float depth[MAP * MAP];
    for (int k = 0; k < MAP * MAP; k++) {
        const double u = ((k % MAP + 0.5) / MAP - 0.5) * MAP_SIDE, v = ((k / MAP + 0.5) / MAP - 0.5) * MAP_SIDE;
        const double x = u * r->a[0] + v * r->b[0], y = u * r->a[1] + v * r->b[1], z = u * r->a[2] + v * r->b[2];
        const double along = (BOARD_HEIGHT - z) / r->sun[2]; // towards the sun, to the board's plane
        const bool hit = is_on_board(x + along * r->sun[0], y + along * r->sun[1]);
        depth[k] = hit ? (float)(0.5 - along / MAP_RANGE) : 1.0f;
    }
    GLuint name;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, MAP, MAP, 0, GL_DEPTH_COMPONENT, GL_FLOAT, depth);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE); // as a host has it
    return name;
}

static bolan_mat4 map_matrix(const rig *r) {
    bolan_mat4 m = {{0.0f}};
    for (int c = 0; c < 3; c++) {
        m.m[4 * c] = (float)(r->a[c] / MAP_SIDE);
        m.m[4 * c + 1] = (float)(r->b[c] / MAP_SIDE);
        m.m[4 * c + 2] = (float)(-r->sun[c] / MAP_RANGE);
    }
    m.m[12] = m.m[13] = m.m[14] = 0.5f;
    m.m[15] = 1.0f;
    return m;
}

static GLuint black_cube(void) {
    static const float black[4];
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_CUBE_MAP, name);
    for (GLenum face = 0; face < 6; face++)
        glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_RGB16F, 1, 1, 0, GL_RGB, GL_FLOAT, black);
    return name;
}

// Water that shines by the sunlight in it alone.
static void open_rig(rig *r) {
    memset(r, 0, sizeof *r);
    r->sea = small_sea(bolan_sea_state_from_wind(4.0, 270.0, 20e3));
    bolan_renderer_desc desc = bolan_renderer_desc_default();
    assert_int_equal(bolan_renderer_create(&desc, &r->renderer), BOLAN_OK);
    assert_int_equal(bolan_target_create(WIDTH, HEIGHT, &r->target), BOLAN_OK);
    const double e = bolan_radians(50.0), azimuth = bolan_radians(230.0);
    const double sun[3] = {sin(azimuth) * cos(e), cos(azimuth) * cos(e), sin(e)}, flat = hypot(sun[0], sun[1]);
    const double a[3] = {sun[1] / flat, -sun[0] / flat, 0.0};
    const double b[3] = {sun[1] * a[2] - sun[2] * a[1], sun[2] * a[0] - sun[0] * a[2], sun[0] * a[1] - sun[1] * a[0]};
    memcpy(r->sun, sun, sizeof sun), memcpy(r->a, a, sizeof a), memcpy(r->b, b, sizeof b);
    r->cube = black_cube();
    r->map = shadow_map(r);
    r->water = bolan_water_default();
    r->water.sea = r->sea;
    r->lighting = bolan_lighting_default();
    r->lighting.environment.cube = r->cube;
    r->lighting.environment.sun_direction = bolan_v3((float)sun[0], (float)sun[1], (float)sun[2]);
    r->lighting.environment.sun_irradiance = bolan_v3(1.0f, 1.0f, 1.0f);
    r->lighting.haze.kind = BOLAN_HAZE_NONE;
    r->lighting.look.effects = BOLAN_EFFECT_AMBIENT;
    r->view = bolan_view_default();
    r->view.eye = (bolan_dvec3){3000.0, -500.0, 7.0};
    r->view.view = bolan_m4_view(0.0, -20.0, 0.0);
    r->view.projection = bolan_m4_projection(bolan_radians(50.0), (double)WIDTH / HEIGHT, 0.1, 0);
    r->view.framebuffer = bolan_target_framebuffer(r->target);
    r->view.width = WIDTH;
    r->view.height = HEIGHT;
}

static void close_rig(rig *r) {
    glDeleteTextures(1, &r->cube);
    glDeleteTextures(1, &r->map);
    bolan_target_destroy(&r->target);
    bolan_renderer_destroy(&r->renderer);
    bolan_sea_destroy(&r->sea);
}

static float lit[PIXELS][3], shadowed[PIXELS][3], distance[PIXELS];

static void draw(rig *r, const bolan_host *host, float *rgb) {
    bolan_renderer_prepare(r->renderer, &r->water, &r->lighting);
    bolan_renderer_draw_water(r->renderer, &r->view, host);
    bolan_renderer_read_linear(r->renderer, rgb, distance);
}

// Eye-relative place of a pixel of the image, row 0 at the top.
static void place_of(const rig *r, int pixel, double out[3]) {
    const float *m = r->view.projection.m, *v = r->view.view.m;
    const double x = 2.0 * (pixel % WIDTH + 0.5) / WIDTH - 1.0, y = 1.0 - 2.0 * (pixel / WIDTH + 0.5) / HEIGHT;
    const double t = (double)distance[pixel], to[3] = {x / (double)m[0] * t, y / (double)m[5] * t, -t};
    for (int axis = 0; axis < 3; axis++)
        out[axis] = to[0] * (double)v[4 * axis] + to[1] * (double)v[4 * axis + 1] + to[2] * (double)v[4 * axis + 2];
}

// From the board's nearest edge, in its plane [m]: below 0 inside.
static double from_edge(double x, double y) {
    return fmax(fmax(board[0] - x, x - board[1]), fmax(board[2] - y, y - board[3]));
}

static void a_board_shadows_the_water_under_it(void **state) {
    (void)state;
    rig r;
    open_rig(&r);
    draw(&r, NULL, lit[0]);
    const bolan_host host = {.shadow = r.map, .shadow_matrix = map_matrix(&r), .shadow_bias = 0.001f};
    draw(&r, &host, shadowed[0]);
    int dark = 0, bright = 0;
    for (int i = 0; i < PIXELS; i++) {
        double p[3];
        if (isinf(distance[i])) continue;
        assert_true(lit[i][1] > 1e-4f);
        place_of(&r, i, p);
        const double along = (BOARD_HEIGHT - p[2]) / r.sun[2];
        const double off = from_edge(p[0] + along * r.sun[0], p[1] + along * r.sun[1]);
        if (fabs(off) < 2.0) continue; // two texels of the map, on a slant
        if (off < 0.0) {
            assert_near(shadowed[i][1], 0.0, 1e-6);
            dark++;
        } else {
            assert_near(shadowed[i][1], lit[i][1], 0.0);
            bright++;
        }
    }
    assert_true(dark > 100 && bright > 1000);
    assert_true(fabs(dot3(r.a, r.sun)) < 1e-12 && fabs(dot3(r.b, r.sun)) < 1e-12);
    close_rig(&r);
}

// The next view without a map is lit as before.
static void a_shadow_belongs_to_its_call(void **state) {
    (void)state;
    rig r;
    open_rig(&r);
    draw(&r, NULL, lit[0]);
    const bolan_host host = {.shadow = r.map, .shadow_matrix = map_matrix(&r), .shadow_bias = 0.001f};
    draw(&r, &host, shadowed[0]);
    assert_memory_not_equal(shadowed, lit, sizeof lit);
    draw(&r, NULL, shadowed[0]);
    assert_memory_equal(shadowed, lit, sizeof lit);
    close_rig(&r);
}

static char sentence[256];

static void note(void *user, bolan_log_level level, bolan_log_id id, const char *text) {
    (void)user, (void)level;
    if (id == BOLAN_LOG_GUEST_FRAME) snprintf(sentence, sizeof sentence, "%s", text);
}

static void expect(rig *r, const bolan_host *host, const char *words) {
    sentence[0] = '\0';
    bolan_renderer_prepare(r->renderer, &r->water, &r->lighting);
    bolan_renderer_draw_water(r->renderer, &r->view, host);
    if (strstr(sentence, words) == NULL) fail_msg("'%s', not '%s'", sentence, words);
}

static void a_map_that_cannot_be_read_is_refused(void **state) {
    (void)state;
    rig r;
    open_rig(&r);
    bolan_set_hooks(&(bolan_hooks){.log = note});
    bolan_host host = {.shadow = 9999, .shadow_matrix = map_matrix(&r)};
    expect(&r, &host, "shadow is no 2D texture of this context");
    host.shadow = r.map;
    host.shadow_matrix.m[5] = NAN;
    expect(&r, &host, "shadow_matrix is not finite");
    host.shadow_matrix = map_matrix(&r);
    r.lighting.technique.optics = BOLAN_OPTICS_LIT;
    expect(&r, &host, "shadow is given, and the optics is not physical");
    close_rig(&r);
    bolan_set_hooks(NULL);
}

int main(void) {
    const struct CMUnitTest tests[] = {IN_BOTH_APIS(a_board_shadows_the_water_under_it),
                                       IN_BOTH_APIS(a_shadow_belongs_to_its_call),
                                       IN_BOTH_APIS(a_map_that_cannot_be_read_is_refused)};
    return cmocka_run_group_tests_name("shadows of a host", tests, NULL, NULL);
}
