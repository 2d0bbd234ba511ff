// SPDX-License-Identifier: MIT
// The sky against numbers from elsewhere: an independent quadrature, Bodhaine's optical depths, Koschmieder's law, the
// geometry of the horizon, and the measured light of day and twilight.
#include "sky_support.h"

#include "render/atmosphere.h"
#include <stdio.h>
#include <stdlib.h>

enum { QUESTIONS = 7 };

typedef struct probe {
    gl_program program;
    gl_texture answers;
    gl_target target;
} probe;

static void probe_create(probe *p) {
    const gl_texture_desc d = {.format = GL_FMT_RGBA32F, .width = QUESTIONS, .height = 1};
    const gl_texture *color = &p->answers;
    bolan_gl_program_set_directory(BOLAN_SOURCE_DIR "/shaders");
    assert_int_equal(bolan_gl_program_create("../tests/shaders/probe_sky", NULL, &p->program), BOLAN_OK);
    bolan_gl_program_set_directory(NULL);
    assert_int_equal(bolan_gl_texture_create(&d, &p->answers), BOLAN_OK);
    assert_int_equal(bolan_gl_target_create(&color, 1, NULL, -1, 0, &p->target), BOLAN_OK);
}

static void probe_ask(const probe *p, double x, double y, double z, double w, float answers[QUESTIONS][4]) {
    bolan_gl_set_state(&(gl_state){.color_write = true});
    bolan_gl_target_bind(&p->target);
    bolan_gl_program_vec4(&p->program, "ask", (bolan_vec4){(float)x, (float)y, (float)z, (float)w});
    bolan_gl_draw_fullscreen();
    bolan_gl_target_read_float(&p->target, 0, answers[0]);
}

static void probe_destroy(probe *p) {
    bolan_gl_target_free(&p->target);
    bolan_gl_texture_free(&p->answers);
    bolan_gl_program_free(&p->program);
}

static double luminance(const float *c) { return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]; }

// ---- transmittance ------------------------------------------------------------------------------------------------

// Optical depth by the plainest means: equal steps, the law of cosines in doubles, content written down again.
static void quadrature(double h, double mu, double visibility, double depth[3]) {
    const double earth = 6371e3, top = earth + 100e3, r = earth + h, color[3] = {0.8896, 1.0, 1.1508};
    const double rayleigh[3] = {0.049184, 0.097070, 0.221110}, ozone[3] = {0.03384, 0.02578, 0.00201};
    const double haze = fmax(3.912 / visibility - rayleigh[1] / 8000.0, 2e-6),
                 reach = -r * mu + sqrt(top * top - r * r * (1 - mu * mu));
    const int steps = 20000;
    depth[0] = depth[1] = depth[2] = 0.0;
    for (int i = 0; i < steps; i++) {
        const double d = reach * (i + 0.5) / steps, height = fmax(sqrt(r * r + d * d + 2 * r * d * mu) - earth, 0.0);
        for (int c = 0; c < 3; c++) {
            depth[c] += reach / steps *
                        (rayleigh[c] / 8000.0 * exp(-height / 8000.0) + haze * color[c] * exp(-height / 1000.0) +
                         ozone[c] / 15000.0 * fmax(0.0, 1.0 - fabs(height - 25000.0) / 15000.0));
        }
    }
}

// Of the table's own rays (Bruneton & Neyret 2008): texel -> height and cosine, in doubles.
static void table_ray(int x, int y, double *h, double *mu) {
    const double earth = 6371e3, top = 100e3, longest = sqrt(top * (2 * earth + top));
    const double rho = longest * y / (SKY_TRANSMITTANCE_HEIGHT - 1.0), u = x / (SKY_TRANSMITTANCE_WIDTH - 1.0);
    *h = sqrt(earth * earth + rho * rho) - earth;
    const double shortest = top - *h, d = shortest + u * (rho + longest - shortest), r = earth + *h;
    *mu = d < 1.0 ? 1.0 : ((earth + top) * (earth + top) - r * r - d * d) / (2 * r * d);
}

static void the_transmittance_table_agrees_with_an_independent_quadrature(void **state) {
    (void)state;
    sky_rig r;
    rig_create(&r, 16, 16);
    atmosphere a;
    assert_int_equal(bolan_atmosphere_create(&a, NULL), BOLAN_OK);
    rig_prepare(&r);
    assert_true(bolan_atmosphere_update(&a, &(block_values){.frame = r.step.block, .view = r.f.block}));
    float *table = malloc(sizeof(float) * 4 * SKY_TRANSMITTANCE_WIDTH * SKY_TRANSMITTANCE_HEIGHT);
    bolan_gl_target_read_float(&a.transmittance_target, 0, table);
    double worst = 0.0;
    for (int y = 0; y < SKY_TRANSMITTANCE_HEIGHT - 1; y += 6) {
        for (int x = 0; x < SKY_TRANSMITTANCE_WIDTH; x += 17) {
            double h, mu, depth[3];
            table_ray(x, y, &h, &mu);
            quadrature(h, fmax(-1.0, fmin(1.0, mu)), 40000.0, depth);
            for (int c = 0; c < 3; c++) {
                const double got = table[4 * (y * SKY_TRANSMITTANCE_WIDTH + x) + c];
                worst = fmax(worst, fabs(exp(-got) - exp(-depth[c])));
            }
        }
    }
    print_message("largest error of a transmittance: %.5f\n", worst);
    // The table holds depths as halfs, 2^-11 of each: exp(-t) t 2^-11 < 1.8e-4; 2 x 60 steps on a grazing ray: 1.5e-3.
    assert_true(worst < 0.002);
    free(table);
    bolan_atmosphere_free(&a);
    rig_destroy(&r);
}

static void the_zenith_sun_in_clean_air_loses_bodhaine_and_ozone(void **state) {
    (void)state;
    sky_rig r;
    probe p;
    float got[QUESTIONS][4];
    rig_create(&r, 16, 16);
    probe_create(&p);
    r.step.lighting.sky.visibility = 300000;
    r.step.lighting.sky.sun_elevation_deg = 90;
    rig_prepare(&r);
    probe_ask(&p, 0, 0, 1, 0, got);
    // Bodhaine et al. 1999, eq. 30: 0.04918, 0.09707, 0.22111 at 650, 550, 450 nm; 300 Dobson units of ozone: 8.06e18
    // / cm2 times 4.2, 3.2, 0.25e-21 cm2; the haze left at this visibility is 2e-6 / m over 1 km.
    const double depth[3] = {0.04918 + 0.03385 + 0.0018, 0.09707 + 0.02579 + 0.0020, 0.22111 + 0.0020 + 0.0023};
    for (int c = 0; c < 3; c++) assert_near(got[4][c], exp(-depth[c]), 0.002); // as the table's error above
    probe_destroy(&p);
    rig_destroy(&r);
}

static void contrast_falls_to_two_per_cent_at_the_visibility(void **state) {
    (void)state;
    sky_rig r;
    probe p;
    float got[QUESTIONS][4];
    rig_create(&r, 16, 16);
    probe_create(&p);
    for (double visibility = 1000; visibility <= 20000; visibility *= 4) {
        r.step.lighting.sky.visibility = visibility;
        r.camera.position.z = 2;
        rig_prepare(&r);
        // Along the level line of sight; the earth falls away under it, by 20 m in 16 km, so the air thins by a
        // percent.
        probe_ask(&p, 0, visibility, 0, 0, got);
        assert_near(got[1][1], exp(-3.912), 0.001);
    }
    probe_destroy(&p);
    rig_destroy(&r);
}

// ---- geometry -----------------------------------------------------------------------------------------------------

// Height of the horizon in a picture of the bare sky: below it every row is alike, above it brightness changes.
static double rendered_dip(sky_rig *r, double height, double dip_deg) {
    r->camera = (bolan_camera){.position = {0, 0, height}, .heading_deg = 0, .pitch_deg = -dip_deg, .fov_deg = 1.0};
    rig_prepare(r);
    rig_draw(r);
    const uint32_t w = r->f.width, h = r->f.height;
    float *rgba = malloc(sizeof(float) * 4 * w * h);
    bolan_gl_target_read_float(&r->hdr, 0, rgba);
    uint32_t y = 0; // bottom row first
    const double below = luminance(rgba + 4 * (w / 2));
    while (y < h && fabs(luminance(rgba + 4 * (y * w + w / 2)) / below - 1.0) < 0.0015)
        y++; // a half has 2^-11 = 0.0005
    free(rgba);
    const double from_centre = (y - 0.5 * h) / (0.5 * h) * tan(bolan_radians(0.5));
    return dip_deg - bolan_degrees(atan(from_centre));
}

static void the_horizon_dips_as_on_a_round_earth(void **state) {
    (void)state;
    // acos(R / (R + h)) with R = 6371 km: 2 m .0454 deg, 10 m .1015, 100 m .3210, 1000 m 1.0151, 10 km 3.2081
    static const double heights[] = {2, 10, 100, 1000, 10000}, dips[] = {0.0454, 0.1015, 0.3210, 1.0151, 3.2081};
    sky_rig r;
    probe p;
    float got[QUESTIONS][4];
    rig_create(&r, 4, 400); // 0.0025 deg a pixel
    probe_create(&p);
    for (int i = 0; i < 5; i++) {
        const double dip = rendered_dip(&r, heights[i], dips[i]);
        print_message("%5.0f m: %.4f deg\n", heights[i], dip);
        assert_near(dip, dips[i], 0.03); // the sky's brightness must first change by three steps of a half
        probe_ask(&p, 0, 1, 0, heights[i], got);
        assert_near(bolan_degrees(got[5][1]), dips[i], 0.0001);
    }
    probe_destroy(&p);
    rig_destroy(&r);
}

static void heights_along_a_ray_keep_their_precision(void **state) {
    (void)state;
    sky_rig r;
    probe p;
    float got[QUESTIONS][4];
    rig_create(&r, 16, 16);
    probe_create(&p);
    rig_prepare(&r);
    for (double d = 100; d < 400000; d *= 3) {
        for (double elevation = -0.02; elevation <= 0.02; elevation += 0.01) {
            const double h = 12.5, R = 6371000.0, z = sin(elevation);
            probe_ask(&p, 0, d * cos(elevation), d * z, h, got);
            const double want = sqrt((R + h) * (R + h) + d * d + 2 * (R + h) * d * z) - R;
            if (want < -1000) continue;
            // d (d + 2 r mu) and h (2 r + h) in floats: 2^-23 of the larger, over 2 r; the direction's own rounding:
            // d 2^-24
            assert_near(got[5][2], want, 0.01 + 3e-7 * d);
        }
    }
    probe_destroy(&p);
    rig_destroy(&r);
}

static void the_environment_map_unfolds_to_the_direction_it_was_asked(void **state) {
    (void)state;
    sky_rig r;
    probe p;
    float got[QUESTIONS][4];
    rig_create(&r, 16, 16);
    probe_create(&p);
    rig_prepare(&r);
    for (int i = 0; i < 50; i++) {
        const double azimuth = i * 2.39996, z = (i + 0.5) / 50.0, s = sqrt(1 - z * z);
        probe_ask(&p, s * cos(azimuth), s * sin(azimuth), z, 0, got);
        assert_near(got[6][0], s * cos(azimuth), 1e-5);
        assert_near(got[6][1], s * sin(azimuth), 1e-5);
        assert_near(got[6][2], z, 1e-5);
    }
    probe_destroy(&p);
    rig_destroy(&r);
}

// ---- light --------------------------------------------------------------------------------------------------------

static void the_sky_is_positive_and_finite_for_every_sun_and_height(void **state) {
    (void)state;
    sky_rig r;
    probe p;
    float got[QUESTIONS][4];
    rig_create(&r, 16, 16);
    probe_create(&p);
    static const double suns[] = {-18, -6, -0.3, 0.5, 20, 90}, heights[] = {0, 2, 1000, 20000};
    for (int s = 0; s < 6; s++) {
        for (int h = 0; h < 4; h++) {
            r.step.lighting.sky.sun_elevation_deg = suns[s];
            r.camera.position.z = heights[h];
            rig_prepare(&r);
            assert_true(isfinite(r.f.block.exposure.y) && r.f.block.exposure.y > 0);
            assert_true(r.f.block.sky_light.x > 0 && r.f.block.sky_light.y > 0 && r.f.block.sky_light.z > 0);
            for (int i = 0; i < 24; i++) {
                const double z = -1 + 2 * (i + 0.5) / 24, side = sqrt(1 - z * z), d = pow(10, 1 + i % 5);
                probe_ask(&p, d * side * sin(i * 2.4), d * side * cos(i * 2.4), d * z, 0.1, got);
                for (int q = 0; q < 4; q++) {
                    for (int c = 0; c < 3; c++) assert_true(isfinite(got[q][c]) && got[q][c] >= 0);
                }
                assert_true(luminance(got[0]) > 0 && luminance(got[3]) > 0);
                for (int c = 0; c < 3; c++) assert_true(got[1][c] <= 1.0f);
            }
        }
    }
    probe_destroy(&p);
    rig_destroy(&r);
}

// A white surface level on the sea: white by day to 2 %, and at dusk three quarters of the color, the daylight's own
// divided out. Red over blue of the surface under the light, as it is and as it is exposed.
static void daylight_is_white_and_dusk_keeps_its_color(void **state) {
    (void)state;
    static const double suns[] = {60.0, -4.0};
    double lit[2], seen[2];
    sky_rig r;
    rig_create(&r, 16, 16);
    for (int s = 0; s < 2; s++) {
        r.step.lighting.sky.sun_elevation_deg = suns[s];
        rig_prepare(&r);
        const bolan_vec3 sky = r.f.light.sky, sun = r.f.light.sun, gain = r.f.light.exposure;
        const double z = fmax(sin(bolan_radians(suns[s])), 0.0);
        lit[s] = ((double)sky.x + z * (double)sun.x) / ((double)sky.z + z * (double)sun.z);
        seen[s] = lit[s] * (double)(gain.x / gain.z);
    }
    print_message("red over blue: %.3f seen as %.3f by day, %.3f as %.3f at dusk\n", lit[0], seen[0], lit[1],
                  seen[1]);
    assert_near(seen[0], 1.0, 0.02);
    assert_true(fabs(log(lit[1] / lit[0])) > 0.2);
    assert_near(log(seen[1]), 0.75 * log(lit[1] / lit[0]), 0.03);
    rig_destroy(&r);
}

static void the_light_on_the_sea_is_the_integral_of_the_sky(void **state) {
    (void)state;
    enum { RINGS = 40, SECTORS = 36 };
    static const double suns[] = {60.0, 35.0, 5.0};
    sky_rig r;
    probe p;
    rig_create(&r, 16, 16);
    probe_create(&p);
    r.camera.position.z = 2.0; // the height that the sea's own sky is made for
    r.step.lighting.sky.cloud_cover = 0.0;
    for (int s = 0; s < 3; s++) {
        r.step.lighting.sky.sun_elevation_deg = suns[s];
        rig_prepare(&r);
        double sum[3] = {0.0, 0.0, 0.0};
        float got[QUESTIONS][4];
        for (int i = 0; i < RINGS; i++) {
            const double elevation = (i + 0.5) * 0.5 * BOLAN_PI / RINGS;
            const double weight =
                sin(elevation) * cos(elevation) * (0.5 * BOLAN_PI / RINGS) * (2.0 * BOLAN_PI / SECTORS);
            for (int j = 0; j < SECTORS; j++) {
                const double azimuth = 2.0 * BOLAN_PI * (j + 0.5) / SECTORS;
                probe_ask(&p, cos(azimuth) * cos(elevation), sin(azimuth) * cos(elevation), sin(elevation), 0.0, got);
                for (int c = 0; c < 3; c++) sum[c] += weight * got[0][c];
            }
        }
        const float light[3] = {r.f.block.sky_light.x, r.f.block.sky_light.y, r.f.block.sky_light.z};
        // Both sums have steps of 3 to 5 degrees, in which the glare round the sun is coarse: 1 % of the whole.
        for (int c = 0; c < 3; c++) {
            if (fabs(light[c] / sum[c] - 1.0) > 0.015)
                print_message("sun at %g: %g of %g\n", suns[s], (double)light[c], sum[c]);
            assert_true(fabs(light[c] / sum[c] - 1.0) <= 0.015);
        }
    }
    probe_destroy(&p);
    rig_destroy(&r);
}

// Illuminance on a level surface, in lux: 128 klx is the sun's above the air.
static double illuminance(sky_rig *r, double elevation) {
    r->step.lighting.sky.sun_elevation_deg = elevation;
    rig_prepare(r);
    const float sun[3] = {r->f.block.sun_light.x, r->f.block.sun_light.y, r->f.block.sun_light.z},
                sky[3] = {r->f.block.sky_light.x, r->f.block.sky_light.y, r->f.block.sky_light.z};
    const double lux = 128e3 * (luminance(sun) * fmax(sin(bolan_radians(elevation)), 0.0) + luminance(sky)) /
                       r->step.block.radiance_unit;
    print_message("%5.1f deg: %.3g lx\n", elevation, lux);
    return lux;
}

static void day_and_twilight_are_as_bright_as_measured(void **state) {
    (void)state;
    sky_rig r;
    rig_create(&r, 16, 16);
    // Janiczek & DeYoung 1987 (US Naval Observatory Circular 171), clear sky. Air differs from day to day: 30 % by
    // day; in twilight a factor of two; at -12 deg, where the table of multiple scattering is crudest, of five.
    assert_near(illuminance(&r, 90) / 129e3, 1.0, 0.3);
    assert_near(illuminance(&r, 40) / 67.5e3, 1.0, 0.3);
    assert_near(illuminance(&r, 10) / 11.1e3, 1.0, 0.3);
    assert_near(log2(illuminance(&r, 0) / 759), 0.0, 1.0);
    assert_near(log2(illuminance(&r, -6) / 3.4), 0.0, 1.0);
    assert_near(log2(illuminance(&r, -12) / 0.0081), 0.0, 2.4);
    assert_near(log2(illuminance(&r, -18) / 6.5e-4), 0.0, 1.0);
    rig_destroy(&r);
}

static void the_noon_zenith_is_blue_and_the_setting_sun_is_red(void **state) {
    (void)state;
    sky_rig r;
    probe p;
    float zenith[QUESTIONS][4], horizon[QUESTIONS][4];
    rig_create(&r, 16, 16);
    probe_create(&p);
    r.step.lighting.sky.sun_elevation_deg = 60;
    rig_prepare(&r);
    probe_ask(&p, 0, 0.1, 1, 0, zenith);
    probe_ask(&p, 0, 1, 0.02, 0, horizon);
    // Rayleigh's law alone gives (650/450)^4 = 4.4 of blue to red; haze whitens it, most at the horizon, which is
    // brighter.
    assert_true(zenith[0][2] / zenith[0][0] > 2.0 && zenith[0][2] / zenith[0][0] < 4.4);
    assert_true(horizon[0][2] / horizon[0][0] < 0.6 * zenith[0][2] / zenith[0][0]);
    assert_true(luminance(horizon[0]) > 1.5 * luminance(zenith[0]));
    r.step.lighting.sky.sun_elevation_deg = 1;
    rig_prepare(&r);
    assert_true(r.f.block.sun_light.x > 2.0f * r.f.block.sun_light.y &&
                r.f.block.sun_light.y > 2.0f * r.f.block.sun_light.z);
    probe_destroy(&p);
    rig_destroy(&r);
}

static void the_far_sea_fades_into_the_sky_above_it(void **state) {
    (void)state;
    sky_rig r;
    probe p;
    float sea[QUESTIONS][4], sky[QUESTIONS][4];
    rig_create(&r, 16, 16);
    probe_create(&p);
    static const double heights[] = {300, 3000, 10000, 20000};
    for (int i = 0; i < 4; i++) {
        const double h = heights[i], R = 6371000.0, far = sqrt(2 * R * h + h * h), dip = acos(R / (R + h));
        r.camera.position.z = h;
        r.step.lighting.sky.visibility = 20000;
        rig_prepare(&r);
        for (double azimuth = 0; azimuth < 3.2; azimuth += 0.5) {
            const double x = sin(azimuth), y = cos(azimuth);
            probe_ask(&p, far * x * cos(dip), far * y * cos(dip), -far * sin(dip), 0, sea);
            probe_ask(&p, x * cos(dip - 1e-4), y * cos(dip - 1e-4), -sin(dip - 1e-4), 0, sky);
            const double hidden = 1.0 - luminance(sea[1]);
            // What the air hides of the sea it replaces by its own light; 6 %: two tables of different grids.
            assert_near(luminance(sea[2]) / (luminance(sky[0]) * hidden), 1.0, 0.06);
        }
    }
    probe_destroy(&p);
    rig_destroy(&r);
}

// ---- the two APIs -------------------------------------------------------------------------------------------------

static void draw_picture(bolan_gl_api api, uint8_t *rgb, uint32_t w, uint32_t h) {
    bolan_context *context = NULL;
    assert_int_equal(bolan_context_create(api, &context), BOLAN_OK);
    sky_rig r;
    rig_create(&r, w, h);
    r.step.lighting.sky.cloud_cover = 0.3;
    r.camera = (bolan_camera){.position = {0, 0, 5}, .heading_deg = 200, .pitch_deg = 10, .fov_deg = 50};
    rig_prepare(&r);
    rig_draw(&r);
    bolan_gl_target_bind(&r.display);
    bolan_pass_tonemap_draw(r.tonemap, &r.f, &r.to, &r.color, 0, NULL);
    read_bytes(r.display.id, w, h, rgb);
    assert_true(watch_is_clean("picture"));
    rig_destroy(&r);
    bolan_context_destroy(&context);
}

static void core_and_es_draw_the_same_sky(void **state) {
    (void)state;
    enum { WIDTH = 128, HEIGHT = 96, SIZE = WIDTH * HEIGHT * 3 };
    static uint8_t core[SIZE], es[SIZE];
    draw_picture(BOLAN_GL_CORE, core, WIDTH, HEIGHT);
    draw_picture(BOLAN_GL_ES, es, WIDTH, HEIGHT);
    int worst = 0;
    for (int i = 0; i < SIZE; i++) worst = abs(core[i] - es[i]) > worst ? abs(core[i] - es[i]) : worst;
    print_message("largest difference: %d of 255\n", worst);
    assert_true(worst <= 3); // the same source, other rounding
}

int main(void) {
    const struct CMUnitTest tests[] = {
        IN_BOTH_APIS(the_transmittance_table_agrees_with_an_independent_quadrature),
        IN_BOTH_APIS(the_zenith_sun_in_clean_air_loses_bodhaine_and_ozone),
        IN_BOTH_APIS(contrast_falls_to_two_per_cent_at_the_visibility),
        IN_BOTH_APIS(the_horizon_dips_as_on_a_round_earth),
        IN_BOTH_APIS(heights_along_a_ray_keep_their_precision),
        IN_BOTH_APIS(the_environment_map_unfolds_to_the_direction_it_was_asked),
        IN_BOTH_APIS(the_sky_is_positive_and_finite_for_every_sun_and_height),
        IN_BOTH_APIS(daylight_is_white_and_dusk_keeps_its_color),
        IN_BOTH_APIS(the_light_on_the_sea_is_the_integral_of_the_sky),
        IN_BOTH_APIS(day_and_twilight_are_as_bright_as_measured),
        IN_BOTH_APIS(the_noon_zenith_is_blue_and_the_setting_sun_is_red),
        IN_BOTH_APIS(the_far_sea_fades_into_the_sky_above_it),
        cmocka_unit_test(core_and_es_draw_the_same_sky),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
