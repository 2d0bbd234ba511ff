// SPDX-License-Identifier: MIT
// The blur of the environment map (shaders/sky_prefilter.glsl): the same all round the horizon, and as wide as it says.
#include "gl_support.h"
#include "render/gl/gl.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define RIM 0.9 // radius of the horizon in the map
enum { SIZE = 512, LEVELS = 8 };

// Twin of environment_direction() in shaders/common/environment.glsl.
static void direction_of(double u, double v, double out[3]) {
    const double x = (2 * u - 1) / RIM, y = (2 * v - 1) / RIM, r2 = x * x + y * y;
    out[0] = 2 * x / (1 + r2), out[1] = 2 * y / (1 + r2), out[2] = fabs(1 - r2) / (1 + r2);
}

typedef struct blur_rig {
    gl_program program;
    gl_texture plain, made;
    float *texels;
} blur_rig;

static void rig_open(blur_rig *r, double (*sky)(const double direction[3], const double *about), const double *about) {
    const gl_texture_desc d = {
        .format = GL_FMT_RGBA16F, .width = SIZE, .height = SIZE, .levels = LEVELS, .filter = GL_FILTER_MIPMAP};
    *r = (blur_rig){.texels = malloc(sizeof(float) * 4 * SIZE * SIZE)};
    assert_int_equal(bolan_gl_program_create("sky_prefilter", NULL, &r->program), BOLAN_OK);
    assert_int_equal(bolan_gl_texture_create(&d, &r->plain), BOLAN_OK);
    assert_int_equal(bolan_gl_texture_create(&d, &r->made), BOLAN_OK);
    for (int j = 0; j < SIZE; ++j)
        for (int i = 0; i < SIZE; ++i) {
            double to[3];
            direction_of((i + 0.5) / SIZE, (j + 0.5) / SIZE, to);
            for (int c = 0; c < 4; ++c) r->texels[4 * (j * SIZE + i) + c] = (float)sky(to, about);
        }
    bolan_gl_texture_upload(&r->plain, 0, -1, r->texels, false);
    bolan_gl_texture_generate_mipmaps(&r->plain);
}

// Blurs one level and reads it: red, n x n.
static void rig_blur(blur_rig *r, uint32_t level, double *out) {
    const gl_texture *color = &r->made;
    gl_target target = {0};
    assert_int_equal(bolan_gl_target_create(&color, 1, NULL, -1, level, &target), BOLAN_OK);
    bolan_gl_set_state(&(gl_state){.color_write = true});
    bolan_gl_target_bind(&target);
    bolan_gl_texture_bind(&r->plain, 15);
    bolan_gl_program_use(&r->program);
    bolan_gl_program_float(&r->program, "level", (float)level);
    bolan_gl_draw_fullscreen();
    bolan_gl_target_read_float(&target, 0, r->texels);
    const int n = SIZE >> level;
    for (int i = 0; i < n * n; ++i) out[i] = (double)r->texels[4 * i];
    bolan_gl_target_free(&target);
}

static void rig_close(blur_rig *r) {
    bolan_gl_texture_free(&r->plain);
    bolan_gl_texture_free(&r->made);
    bolan_gl_program_free(&r->program);
    free(r->texels);
}

// Interpolated as the hardware does.
static double look_up(const double *level, int n, const double to[3]) {
    double x = (to[0] * RIM / (1 + to[2]) * 0.5 + 0.5) * n - 0.5, y = (to[1] * RIM / (1 + to[2]) * 0.5 + 0.5) * n - 0.5;
    x = fmin(fmax(x, 0.0), n - 1.001), y = fmin(fmax(y, 0.0), n - 1.001);
    const int i = (int)x, j = (int)y;
    const double fx = x - i, fy = y - j, *a = level + j * n + i;
    return (a[0] * (1 - fx) + a[1] * fx) * (1 - fy) + (a[n] * (1 - fx) + a[n + 1] * fx) * fy;
}

static double bright_horizon(const double to[3], const double *about) { return 0.1 + exp(-asin(to[2]) / about[0]); }

static void a_ring_of_light_is_the_same_all_round(void **state) {
    (void)state;
    const double scale = bolan_radians(10.0);
    blur_rig r;
    rig_open(&r, bright_horizon, &scale);
    double *level = malloc(sizeof(double) * SIZE * SIZE);
    for (uint32_t l = 1; l <= 6; ++l) {
        rig_blur(&r, l, level);
        for (double elevation = 2.0; elevation <= 60.0; elevation *= 2.3) {
            double least = 1e9, most = 0.0;
            for (int i = 0; i < 72; ++i) {
                const double a = bolan_radians(5.0 * i), e = bolan_radians(elevation);
                const double to[3] = {cos(a) * cos(e), sin(a) * cos(e), sin(e)}, value = look_up(level, SIZE >> l, to);
                least = fmin(least, value), most = fmax(most, value);
            }
            const double spread = (most - least) / (most + least);
            if (spread > (l < 6 ? 0.02 : 0.05))
                print_message("level %u, %.1f deg: %.3f .. %.3f\n", l, elevation, least, most);
            assert_true(spread < (l < 6 ? 0.02 : 0.05)); // level 6 has eight texels for all the sky
        }
    }
    free(level);
    rig_close(&r);
}

static double spot(const double to[3], const double *about) { // of 0.01 rad
    double d2 = 0;
    for (int i = 0; i < 3; ++i) d2 += (to[i] - about[i]) * (to[i] - about[i]);
    return exp(-0.5 * d2 / 1e-4);
}

// Solid angle of a texel, relative: the projection keeps angles, and its scale is 1 + z. What lies beyond the horizon
// is there twice.
static double solid_angle(double u, double v, const double to[3]) {
    return hypot(2 * u - 1, 2 * v - 1) < RIM ? (1 + to[2]) * (1 + to[2]) : 0.0;
}

static void a_point_becomes_a_gaussian_of_the_width_it_stands_for(void **state) {
    (void)state;
    double *level = malloc(sizeof(double) * SIZE * SIZE);
    for (int k = 0; k < 8; ++k) {
        const double e = bolan_radians((double[]){35, 45, 60, 80}[k / 2]), a = bolan_radians(k % 2 ? 45 : 10);
        const double at[3] = {cos(a) * cos(e), sin(a) * cos(e), sin(e)}, side[3] = {-sin(a), cos(a), 0};
        const double up[3] = {-cos(a) * sin(e), -sin(a) * sin(e), cos(e)};
        blur_rig r;
        rig_open(&r, spot, at);
        for (uint32_t l = 2; l <= 4; ++l) {
            const int n = SIZE >> l;
            double sum = 0, across = 0, along = 0, mean = 0;
            rig_blur(&r, l, level);
            for (int j = 0; j < 512; ++j)
                for (int i = 0; i < 512; ++i) { // as it is looked up
                    double to[3], x = 0, y = 0;
                    direction_of((i + 0.5) / 512, (j + 0.5) / 512, to);
                    for (int c = 0; c < 3; ++c) x += to[c] * side[c], y += to[c] * up[c];
                    const double w = look_up(level, n, to) * solid_angle((i + 0.5) / 512, (j + 0.5) / 512, to);
                    sum += w, across += w * x * x, along += w * y * y, mean += w * y;
                }
            const double wanted = sqrt(pow((double)(1u << l) * 4.0 / SIZE, 2) + 1e-4); // with the spot's own
            assert_near(sqrt(across / sum), wanted, 0.1 * wanted); // texels overhead are as wide as the blur
            assert_near(sqrt(along / sum - pow(mean / sum, 2)), wanted, 0.1 * wanted);
            assert_near(mean / sum, 0.0,
                        0.6 * wanted); // a point lies anywhere in a texel, up to a half from its middle
        }
        rig_close(&r);
    }
    free(level);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        IN_BOTH_APIS(a_ring_of_light_is_the_same_all_round),
        IN_BOTH_APIS(a_point_becomes_a_gaussian_of_the_width_it_stands_for),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
