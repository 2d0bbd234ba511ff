// SPDX-License-Identifier: MIT
// The parts of the crest optics: the static grid's twin, the rational forms of the facets, the foam's densities, ramps
// and threshold, and the texels made on the CPU.
#include "cascade_twin.h"
#include "probe.h"

#include <math.h>

#include "bolan/earth.h"
#include "bolan/surface.h"
#include "bolan/waves.h"
#include "render/foam_statistics.h"
#include "render/frame.h"
#include "render/papers/foam_ramps.h"
#include "render/sea_texels.h"
#include "render/water_block.h"
#include "shared/constants.glsl"
#include "shared/foam.glsl"
#include "shared/grid.glsl"

// ---- the static grid ------------------------------------------------------------------------------------------------

enum { ACROSS = 2, DEEP = 3, COLUMNS = ACROSS * GRID_BLOCK + 1, ROWS = DEEP * GRID_BLOCK + 1 };

// Every seventh vertex is compared: 7 is prime to both sides.
enum { STEP = 7, COMPARED = (COLUMNS * ROWS + STEP - 1) / STEP };

// The block that draws a vertex, and its corner in it; a vertex between two blocks is in the later one.
static void find_block(int column, int row, float out[4]) {
    const int a = column < COLUMNS - 1 ? column / GRID_BLOCK : ACROSS - 1;
    const int b = row < ROWS - 1 ? row / GRID_BLOCK : DEEP - 1;
    out[0] = (float)(column - a * GRID_BLOCK);
    out[1] = (float)(row - b * GRID_BLOCK);
    out[2] = (float)(b * ACROSS + a);
}

static void grid_on_the_gpu(const float u[8], float (*out)[4]) {
    float in[COMPARED][4] = {{0}};
    char body[512];
    for (int i = 0; i < COMPARED; ++i) find_block(STEP * i % COLUMNS, STEP * i / COLUMNS, in[i]);
    snprintf(body, sizeof body,
             "vec4 probe(vec4 x) { const vec2 cells = vec2(%d.0, %d.0); "
             "return grid_point(grid_place(x.xy, int(x.z + 0.5), cells), vec4(%.9g, %.9g, %.9g, %.9g), vec4(%.9g, "
             "%.9g, %.9g, %.9g), "
             "cells); }",
             COLUMNS - 1, ROWS - 1, u[0], u[1], u[2], u[3], u[4], u[5], u[6], u[7]);
    probe_run("#include \"common/grid.glsl\"", body, in, COMPARED, out);
}

static void the_vertex_shader_puts_the_grid_where_the_cpu_does(void **state) {
    (void)state;
    const double heights[] = {0.6, 12.0, 300.0, 10000.0}, pitches[] = {-80.0, -5.0, 10.0};
    for (int k = 0; k < 12; ++k) {
        const bolan_surface_view view = {.eye = {0, 0, heights[k / 3]},
                                         .heading_deg = 123,
                                         .pitch_deg = pitches[k % 3],
                                         .fov_y = 0.9,
                                         .aspect = 1.5,
                                         .pixel_height = 768,
                                         .vertical = 2,
                                         .horizontal = 2};
        const bolan_surface_projector p = bolan_surface_projector_of(&view);
        if (!p.visible) continue;
        const bolan_surface_size size = {COLUMNS, ROWS};
        bolan_surface_vertex cpu[COLUMNS * ROWS];
        float u[8], gpu[COMPARED][4];
        bolan_surface_projector_vertices(&p, size, cpu);
        bolan_surface_projector_uniforms(&p, size, u);
        grid_on_the_gpu(u, gpu);
        for (int i = 0; i < COMPARED; ++i) {
            const bolan_surface_vertex *c = &cpu[STEP * i];
            const double r = hypot(c->x, c->y);
            // float's sine, tangent and exponential, the worst of them the tangent near x1: 2e-5 of the distance is a
            // fiftieth of a pixel, and the mesh has no seams for it to open
            assert_true(hypot(gpu[i][0] - c->x, gpu[i][1] - c->y) < 2e-5 * r + 1e-4);
            assert_true(fabs(gpu[i][2] - c->z) < 1e-6 * fabs(c->z) + 4e-5 * r * r / BOLAN_EARTH_RADIUS + 1e-4);
            assert_true(fabs(gpu[i][3] - c->spacing) < 1e-4 * c->spacing);
        }
    }
}

// ---- facets ---------------------------------------------------------------------------------------------------------

static void quadratic_fresnel_falls_with_roughness_as_published(void **state) {
    (void)state;
    // 85 deg: .42, .30, .22 for slope variances .01, .03, .062 (Bruneton et al. 2010)
    float in[3][4] = {{0.1f}, {0.17320508f}, {0.2489980f}}, out[3][4];
    const double expected[3] = {.42, .30, .22};
    probe_run(
        "#include \"common/rough.glsl\"",
        "vec4 probe(vec4 x) { vec3 v = vec3(0.9961947, 0.0, 0.0871557); "
        "rough_facets f = rough_seen(v, vec2(0.0), vec3(x.x * x.x, 0.0, x.x * x.x)); "
        "vec3 n = normalize(vec3(f.shift, 0.0, 1.0)); return vec4(fresnel_mean_fast(dot(v, n), f.sigma, 1.333)); }",
        in, 3, out);
    for (int i = 0; i < 3; ++i)
        assert_true(fabs(out[i][0] - expected[i]) < 0.025); // Schlick's curve alone is 0.05 off at this angle
}

// ---- light through crests -------------------------------------------------------------------------------------------

// The technique's own functions: its main() by another name, and its output beside the probe's.
#define CREST_INCLUDES "#define main crest_main\n#include \"common/../papers/crest.glsl\"\n#undef main"

typedef struct crest_rig {
    block_buffers uniforms;
    block_values blocks;
} crest_rig;

static void set_crest(const gl_program *program, const void *context) {
    const crest_rig *r = context;
    bolan_blocks_bind(&r->uniforms);
    (void)program;
    const water_block block = {.significant_height = 2.0f, .peak_length = 60.0f, .shore_height = 2.0f};
    water_block_buffers buffers; // gone with the test's context
    assert_int_equal(bolan_water_blocks_create(&buffers), BOLAN_OK);
    bolan_water_blocks_upload(&buffers, &block);
}

// Sunlight leaves a crest through the side that leans to the eye: water that falls towards it. The higher and the more
// pinched, the more. x, y: to the eye; z: slope towards it; w: height over the mean water.
static void crests_glow_on_the_side_that_leans_to_the_eye(void **state) {
    (void)state;
    float in[16][4], out[16][4];
    for (int i = 0; i < 16; ++i) {
        const double a = 0.5 + BOLAN_PI / 2.0 * (i / 4);
        in[i][0] = (float)cos(a), in[i][1] = (float)sin(a);
        in[i][2] = (const float[]){-0.15f, 0.0f, 0.15f, -0.15f}[i % 4];
        in[i][3] = i % 4 == 3 ? -0.5f : 1.0f;
    }
    probe_run_with(CREST_INCLUDES,
                   "vec4 probe(vec4 x) { crest_pixel p; p.position = vec3(0.0); p.rest = vec2(0.0); return vec4("
                   "crest_mask(p, wave_fields(x.z * x.xy, 0.7, 0.0), x.w, x.xy), crest_mask(p, wave_fields(x.z * x.xy, "
                   "1.0, 0.0), x.w, x.xy), 0.0, 0.0); }",
                   "CASCADES 4\nTAPS 2\n", set_crest, &(crest_rig){0}, in, 16, out);
    for (int i = 0; i < 16; i += 4) {
        // the face that leans to the eye is 0.4 + 0.3, level water 0.4, the back 0.4 - 0.3 of full
        assert_near(out[i][0] / out[i + 1][0], 7.0 / 4.0, 0.01);
        assert_near(out[i + 2][0] / out[i + 1][0], 1.0 / 4.0, 0.01);
        assert_true(out[i][0] > 3.0f * out[i + 3][0]); // troughs are dark
        assert_near(out[i][0] / out[i][1], (0.25 + 1.3 * 0.3) / 0.25, 0.01);
    }
}

// Against the sun the light is forward scattered (fifth power of the cosine), with it only the rest from all around; by
// Beer's law the red goes first. x: elevation of the eye over the water, sun 0.3 rad high in the north-east.
static void light_through_crests_is_brightest_against_the_sun(void **state) {
    (void)state;
    const double elevation = 0.3, c = cos(elevation) * sqrt(0.5);
    crest_rig r = {.blocks.frame = {.sun_direction = {(float)c, (float)c, (float)sin(elevation)},
                                    .water_attenuation = {0.4f, 0.08f, 0.04f},
                                    .foam_strength = 1.0f}};
    assert_int_equal(bolan_blocks_create(&r.uniforms), BOLAN_OK);
    bolan_blocks_upload(&r.uniforms, &r.blocks);
    float in[3][4] = {{(float)-c, (float)-c, -0.1f}, {(float)c, (float)c, -0.1f}, {(float)-c, (float)c, -0.1f}},
          out[3][4];
    for (int i = 0; i < 3; ++i) in[i][2] = 0.2955202f;
    probe_run_with(
        CREST_INCLUDES,
        "vec4 probe(vec4 x) { vec3 v = normalize(x.xyz); return vec4(crest_light(0.5, v, vec3(2.0)), -dot(v, "
        "sun_direction)); }",
        "CASCADES 4\nTAPS 2\n", set_crest, &r, in, 3, out);
    for (int i = 0; i < 3; ++i) {
        const double ahead = fmax((double)out[i][3], 0.0), up = 0.2955202;
        const double share = (0.16 * pow(ahead, 5.0) + 0.012) * (1.0 - up * up) * 0.5 * 2.0;
        for (int k = 0; k < 3; ++k) // a path of 1.2 Hs = 2.4 m
            assert_near(out[i][k], share * exp(-2.4 * (const double[]){0.4, 0.08, 0.04}[k]), 2e-4 * share + 1e-6);
    }
    assert_true(out[0][1] > 5.0f * out[1][1] && out[0][1] > 3.0f * out[2][1]);
    bolan_blocks_free(&r.uniforms);
}

// ---- foam -----------------------------------------------------------------------------------------------------------

static void densities_have_their_means_and_tile(void **state) {
    (void)state;
    static uint8_t pixels[FOAM_TEXTURE_SIZE][FOAM_TEXTURE_SIZE][4];
    const double means[3] = {FOAM_THIN, FOAM_MIDDLING, FOAM_DENSE};
    assert_int_equal(bolan_foam_densities_fill(&pixels[0][0][0]), BOLAN_OK);
    for (int k = 0; k < 3; ++k) {
        double sum = 0, inside = 0, seam = 0;
        for (int j = 0; j < FOAM_TEXTURE_SIZE; ++j) {
            for (int i = 0; i < FOAM_TEXTURE_SIZE; ++i) sum += pixels[j][i][k];
            inside += abs(pixels[j][255][k] - pixels[j][256][k]);
            seam += abs(pixels[j][0][k] - pixels[j][FOAM_TEXTURE_SIZE - 1][k]);
        }
        sum /= 255.0 * FOAM_TEXTURE_SIZE * FOAM_TEXTURE_SIZE;
        assert_true(fabs(sum - means[k]) < 0.01); // 8 bits, and ranks in 4080 steps
        assert_true(seam < 2.0 * inside);         // neighbours across the seam differ as neighbours do
    }
}

static void the_open_seas_ramp_has_the_intensity_as_its_mean(void **state) {
    (void)state;
    uint8_t ramps[FOAM_RAMP_ROWS][FOAM_RAMP_SIZE][4];
    const double means[4] = {0.22, 0.5, 0.82, 1.0};
    bolan_foam_ramps_fill(ramps);
    for (int i = 0; i < FOAM_RAMP_SIZE; ++i) {
        double mean = 0;
        for (int k = 0; k < 4; ++k) mean += means[k] * ramps[2][i][k] / 255.0;
        assert_true(fabs(mean - i / (FOAM_RAMP_SIZE - 1.0)) < 0.006); // 8 bits in each of two shares
    }
    for (int row = 0; row < 2; ++row) // thin foam comes first, dense foam last
        assert_true(ramps[row][20][0] > ramps[row][20][2] && ramps[row][127][2] > ramps[row][127][0]);
}

// Acceptance: the cover within a factor 1.5 of Monahan & O'Muircheartaigh's for 7 to 20 m/s.
static void breaking_crests_cover_monahans_share(void **state) {
    (void)state;
    const double winds[] = {7, 10, 15, 20}, covers[] = {0.00293, 0.00987, 0.0393, 0.105}; // 3.84e-6 U^3.41
    for (int k = 0; k < 4; ++k) {
        bolan_sea_desc desc = bolan_sea_desc_default();
        desc.sea_state = bolan_sea_state_from_wind(winds[k], 240.0, 3e5);
        desc.resolution = 128;
        bolan_sea *sea = NULL;
        assert_int_equal(bolan_sea_create(&desc, &sea), BOLAN_OK);
        bolan_sea_step(sea, 3.0);
        const double breaks = bolan_foam_law(sea, 0.0, true).breaking_gaussian;
        uint32_t below = 0, random = 1;
        enum { TRIES = 400000 };
        for (int i = 0; i < TRIES; ++i) { // tiles are independent: any place of each
            double pinch = 0;
            for (uint32_t c = 0; c < bolan_sea_cascade_count(sea); ++c) {
                const bolan_cascade_view v = bolan_sea_cascade(sea, c);
                double at[2];
                for (int axis = 0; axis < 2; ++axis) {
                    random = random * 1664525u + 1013904223u;
                    at[axis] = v.length * (double)(random >> 8) / 16777216.0;
                }
                const twin_place p = twin_place_in(&v, (bolan_dvec2){at[0], at[1]});
                pinch +=
                    desc.choppiness * (twin_linear(TWIN_PLANE(&v, dxx), &p) + twin_linear(TWIN_PLANE(&v, dyy), &p));
            }
            below += pinch < breaks;
        }
        const double cover = (double)below / TRIES;
        assert_true(cover > covers[k] / 1.5 && cover < covers[k] * 1.5);
        bolan_sea_destroy(&sea);
    }
}

// ---- texels ---------------------------------------------------------------------------------------------------------

static double half_value(uint16_t h) {
    const int exponent = h >> 10 & 31, mantissa = h & 1023;
    const double m = exponent ? ldexp(1024 + mantissa, exponent - 25) : ldexp(mantissa, -24);
    return h & 0x8000 ? -m : m;
}

static void levels_are_means_down_to_one_texel(void **state) {
    (void)state;
    enum { N = 64, PITCH = N + 4 };
    static float planes[TEXEL_PLANES][N * N], texels[N * PITCH * TEXEL_PLANES];
    const float *const from[TEXEL_PLANES] = {planes[0], planes[1], planes[2], planes[3]};
    for (int p = 0; p < TEXEL_PLANES; ++p)
        for (int i = 0; i < N * N; ++i) {
            planes[p][i] = (float)((i * (7 + p) + i / N * 3) % 101) / 50.0f - 1.0f;
            texels[TEXEL_PLANES * (i / N * PITCH + i % N) + p] = planes[p][i];
        }
    float *scratch = malloc(bolan_texel_scratch_bytes(N));
    uint16_t *levels = malloc(bolan_texel_chain_bytes(N)), *same = malloc(bolan_texel_chain_bytes(N)), *at = levels;
    bolan_texel_chain_of_texels(N, PITCH, texels, scratch, same);
    bolan_texel_chain(N, from, scratch, levels);
    assert_memory_equal(levels, same, sizeof *levels * TEXEL_PLANES * (N * N - 1) / 3);
    for (int size = N / 2, step = 2; size >= 1; size /= 2, step *= 2) {
        for (int j = 0; j < size; ++j)
            for (int i = 0; i < size; ++i)
                for (int p = 0; p < TEXEL_PLANES; ++p) {
                    double sum = 0;
                    for (int y = 0; y < step; ++y)
                        for (int x = 0; x < step; ++x) sum += planes[p][(j * step + y) * N + i * step + x];
                    // half has 11 bits
                    assert_true(fabs(half_value(at[4 * (j * size + i) + p]) - sum / (step * step)) < 6e-4);
                }
        at += 4 * size * size;
    }
    free(scratch);
    free(levels);
    free(same);
}

static void packed_texels_hold_slope_pinch_and_foam(void **state) {
    (void)state;
    enum { N = 64 };
    float a[N], b[N], c0[N], c1[N], d[N], sum[N];
    uint16_t out[4 * N];
    for (int i = 0; i < N; ++i) {
        a[i] = 0.01f * (float)i, b[i] = -a[i], c0[i] = 0.5f - a[i], c1[i] = 0.25f, d[i] = 2.0f * a[i];
    }
    bolan_texel_kernels_best()->pack(N, a, b, c0, c1, d, sum, out);
    for (int i = 0; i < N; ++i) {
        const double expected[4] = {a[i], b[i], c0[i] + c1[i], d[i]};
        for (int k = 0; k < 4; ++k) assert_true(fabs(half_value(out[4 * i + k]) - expected[k]) < 6e-4);
        assert_true(fabsf(sum[i] - (c0[i] + c1[i])) < 1e-6f);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        IN_BOTH_APIS(the_vertex_shader_puts_the_grid_where_the_cpu_does),
        IN_BOTH_APIS(quadratic_fresnel_falls_with_roughness_as_published),
        // two outputs, which ES wants placed: the technique's is not
        cmocka_unit_test_setup_teardown(crests_glow_on_the_side_that_leans_to_the_eye, gl_setup_core, gl_teardown),
        cmocka_unit_test_setup_teardown(light_through_crests_is_brightest_against_the_sun, gl_setup_core, gl_teardown),
        cmocka_unit_test(densities_have_their_means_and_tile),
        cmocka_unit_test(the_open_seas_ramp_has_the_intensity_as_its_mean),
        cmocka_unit_test(breaking_crests_cover_monahans_share),
        cmocka_unit_test(levels_are_means_down_to_one_texel),
        cmocka_unit_test(packed_texels_hold_slope_pinch_and_foam),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
