// SPDX-License-Identifier: MIT
// The sea of cascades as the shaders have it (shaders/common/waves.glsl) against its twins on the CPU: vertices,
// pixels, gusts, shallow water, and what a pixel's footprint leaves to the roughness.
#include "bolan/coast.h"
#include "cascade_twin.h"
#include "probe.h"

#include "render/sea_gpu.h"
#include "render/shore_map.h"
#include "waves/model.h"

typedef struct rig {
    bolan_sea *sea;
    gl_caps caps;
    shore_map shore;
    frame step;
    render_view f;
    sea_gpu fields;
    water_block_buffers *blocks;
    water_block_buffers own_blocks;
    bool packed;
} rig;

static bolan_dvec2 current; // of the seas below [m/s]
static uint32_t order = 1;
static bool splines; // pixels read them

static void rig_open(rig *r, double from_deg, double choppiness, bolan_dvec2 eye, double time, bool packed) {
    memset(r, 0, sizeof *r);
    bolan_sea_desc desc = bolan_sea_desc_default();
    desc.sea_state = bolan_sea_state_from_wind(9.0, from_deg, 200e3);
    desc.sea_state.current_x = current.x, desc.sea_state.current_y = current.y;
    desc.resolution = 128;
    desc.choppiness = choppiness;
    desc.order = order;
    desc.foam_decay = 1.0;
    assert_int_equal(bolan_sea_create(&desc, &r->sea), BOLAN_OK);
    bolan_sea_settle(r->sea, time);
    r->caps = bolan_gl_get_caps();
    r->packed = packed;
    r->step = (frame){.caps = &r->caps, .sea = r->sea, .lighting = bolan_lighting_default(), .time = time};
    r->f = (render_view){.frame = &r->step, .eye = {eye.x, eye.y, 5.0}, .shore = &r->shore};
    assert_int_equal(bolan_sea_gpu_create(&r->fields), BOLAN_OK);
    assert_int_equal(bolan_water_blocks_create(&r->own_blocks), BOLAN_OK);
    r->blocks = &r->own_blocks;
    bolan_sea_gpu_prepare(&r->fields, &r->step, packed ? WATER_TEXTURES_PACKED : WATER_TEXTURES_ALL);
    bolan_sea_gpu_view(&r->fields, &r->f, WATER_CASCADES);
}

static void rig_close(rig *r) {
    bolan_sea_gpu_free(&r->fields);
    bolan_water_blocks_free(&r->own_blocks);
    bolan_sea_destroy(&r->sea);
}

static void set_waves(const gl_program *program, const void *context) {
    const rig *r = context;
    bolan_sea_gpu_bind(&r->fields, WATER_CASCADES);
    (void)program;
    water_block block = {.cascade_count = 0};
    bolan_sea_gpu_fill(&block, &r->f, WATER_CASCADES);
    bolan_water_blocks_upload(r->blocks, &block);
}

// Both stages' functions in one. LAND: depth attenuates each band.
static void run(const rig *r, const char *body, uint32_t taps, float (*in)[4], uint32_t count, float (*out)[4]) {
    char defines[96];
    snprintf(defines, sizeof defines, "LAND 1\nTAPS %u\n%s%s%s", taps, r->packed ? "PACKED 1\n" : "",
             splines ? "SPLINES 1\n" : "", bolan_sea_get_desc(r->sea)->order > 1 ? "BOUND_WAVES 1\n" : "");
    probe_run_with("#include \"common/frame.glsl\"\n#define VERTEX\n#include \"common/waves.glsl\"\n#undef VERTEX",
                   body, defines, set_waves, r, in, count, out);
}

// ---- the twin -------------------------------------------------------------------------------------------------------

typedef struct sums {
    double dx, dy, z, sx, sy, foam;
    double xx, yy, xy;        // derivatives of dx and dy along the axes of the plane
    double east[2], north[2]; // gradients of dx and dy by the rest point
} sums;

// gust: a factor on the cascades of waves below 20 m; depth: of the water, which takes its share of each band.
static sums twin(const bolan_sea *sea, double x, double y, double gust, double depth) {
    sums t = {0};
    double g[4];
    const bolan_dvec2 at = bolan_sea_place_read(sea, x, y, g);
    const uint32_t count = bolan_sea_cascade_count(sea);
    float heights[BOLAN_MAX_CASCADES], shares[BOLAN_MAX_CASCADES];
    const double peak = bolan_sea_peak_length(bolan_sea_get_summary(sea));
    for (uint32_t c = 0; c < count; ++c) heights[c] = (float)(4.0 * sqrt(bolan_sea_cascade(sea, c).variance));
    bolan_coast_attenuations((float)depth, heights, count, shares);
    for (uint32_t c = 0; c < count; ++c) {
        const bolan_cascade_view v = bolan_sea_cascade(sea, c);
        const twin_place p = twin_place_in(&v, at);
        const double shallow = (double)shares[c];
        const double keep = v.k_min > 0.0 && 2.0 * BOLAN_PI / v.k_min < 20.0 ? gust * shallow : shallow;
        t.dx += shallow * twin_cubic(TWIN_TEXELS(&v, dx), &p), t.dy += shallow * twin_cubic(TWIN_TEXELS(&v, dy), &p),
            t.z += shallow * twin_cubic(TWIN_TEXELS(&v, height), &p);
        t.z += shallow * shallow * bolan_sea_lift(sea, c, 0.0);
        t.sx += keep * twin_linear(TWIN_PLANE(&v, slope_x), &p),
            t.sy += keep * twin_linear(TWIN_PLANE(&v, slope_y), &p);
        t.xx += keep * twin_linear(TWIN_PLANE(&v, dxx), &p), t.yy += keep * twin_linear(TWIN_PLANE(&v, dyy), &p),
            t.xy += keep * twin_linear(TWIN_TEXELS(&v, dxy), &p);
        const double longest = v.k_min > 0.0 ? 2.0 * BOLAN_PI / v.k_min : v.length;
        t.foam += keep * fmin(8.0 * longest / peak, 1.0) * twin_linear(TWIN_PLANE(&v, foam), &p);
    }
    const double sx = t.sx, sy = t.sy;
    t.sx = sx * g[0] + sy * g[2], t.sy = sx * g[1] + sy * g[3];
    for (int e = 0; e < 2; ++e) {
        t.east[e] = t.xx * g[e] + t.xy * g[2 + e];
        t.north[e] = t.xy * g[e] + t.yy * g[2 + e];
    }
    return t;
}

// ---- fields ---------------------------------------------------------------------------------------------------------

enum { COUNT = 256 };
#define REACH 400.0f // from the eye [m]

static void scatter(float (*in)[4], float z, float w) {
    uint32_t h = 1;
    for (int i = 0; i < COUNT; ++i) {
        for (int k = 0; k < 2; ++k) {
            h = h * 1664525u + 1013904223u;
            in[i][k] = ((float)(h >> 8) / 8388608.0f - 1.0f) * REACH;
        }
        in[i][2] = z, in[i][3] = w;
    }
}

static const struct {
    double from, x, y, time;
} cases[] = {{250.0, 0.0, 0.0, 0.0}, {20.0, 123456.7, -98765.4, 4321.5}, {140.0, -3.3e6, 2.1e6, 17.25}};
enum { CASES = 3 };

// Half floats carry 11 bits: a field is rounded by 2^-12 of itself in each of four cascades. The warp moves places by
// some hundred metres, of which floats round 0.1 mm: 0.005 texels of the smallest tile, whose slope changes by 0.1 in
// one. Heights of 3 m, slopes of 0.5.
#define HEIGHT_ERROR 2e-3
#define SLOPE_ERROR 1.2e-3
#define JACOBIAN_ERROR 2e-3

static const char *const vertex_probe = "vec4 probe(vec4 x) { vec4 fields; return vec4(wave_offset(x.xy, "
                                        "place_of(x.xy), 1e-3, x.w, fields), fields.x); }";

static void vertices_stand_where_the_cpu_has_them(void **state) {
    (void)state;
    const float depths[] = {1e3f, 2.0f};
    current = (bolan_dvec2){1.5, -0.7}; // tiles drift
    for (int k = 0; k < CASES * 2; ++k) {
        rig r;
        rig_open(&r, cases[k / 2].from, 0.8, (bolan_dvec2){cases[k / 2].x, cases[k / 2].y}, cases[k / 2].time, false);
        float in[COUNT][4], out[COUNT][4];
        scatter(in, 1.0f, depths[k % 2]);
        run(&r, vertex_probe, 4, in, COUNT, out);
        for (int i = 0; i < COUNT; ++i) {
            const bolan_dvec2 at = {r.f.eye.x + (double)in[i][0], r.f.eye.y + (double)in[i][1]};
            const sums t = twin(r.sea, at.x, at.y, 1.0, (double)in[i][3]);
            assert_near(out[i][0], 0.8 * t.dx, HEIGHT_ERROR);
            assert_near(out[i][1], 0.8 * t.dy, HEIGHT_ERROR);
            assert_near(out[i][2], t.z, HEIGHT_ERROR);
            assert_near(out[i][3], t.sx, SLOPE_ERROR);
            if (k % 2 == 1) continue;
            bolan_sea_sample s; // deep water: what queries answer
            bolan_sea_sample_rest(r.sea, &at, 1, &s);
            assert_near(out[i][0], s.dx, HEIGHT_ERROR);
            assert_near(out[i][2], s.height, HEIGHT_ERROR);
        }
        rig_close(&r);
    }
    current = (bolan_dvec2){0.0, 0.0};
}

// On a coarse mesh the shader fetches a level of its textures, the CPU averages samples: the same waves but for the
// last octave, which holds the energy that `errors` allows, relative to the rms height of all waves (13, 45 and 30 %
// were measured). With 16 m that octave is the peak of this sea, of 70 m waves. A level is a mean of the spline's
// coefficients, which hold 1.2 of a wave of six texels, and 0.7 of it are left by a fetch of the first level: more than
// the CPU leaves, and nearer to the wave.
static void vertices_of_a_coarse_mesh_have_the_long_waves(void **state) {
    (void)state;
    const double spacings[] = {4.0, 16.0, 64.0}, errors[] = {0.135, 0.46, 0.31}, ratios[] = {1.035, 1.68, 1.84};
    rig r;
    rig_open(&r, 20.0, 1.0, (bolan_dvec2){5000.0, -777.0}, 33.0, false);
    for (int k = 0; k < 3; ++k) {
        float in[COUNT][4], out[COUNT][4];
        scatter(in, (float)spacings[k], 1e3f);
        run(&r,
            "vec4 probe(vec4 x) { vec4 fields; "
            "return vec4(wave_offset(x.xy, place_of(x.xy), x.z, x.w, fields), 0.0); }",
            4, in, COUNT, out);
        double error = 0.0, energy = 0.0, shader = 0.0, cpu = 0.0;
        for (int i = 0; i < COUNT; ++i) {
            const bolan_dvec2 at = {r.f.eye.x + (double)in[i][0], r.f.eye.y + (double)in[i][1]};
            const float spacing = in[i][2];
            bolan_sea_sample all, s;
            bolan_sea_sample_rest(r.sea, &at, 1, &all);
            bolan_sea_sample_grid(r.sea, &at, &spacing, 1, &s);
            shader += pow((double)out[i][2], 2.0), cpu += pow((double)s.height, 2.0);
            error += pow((double)(out[i][2] - s.height), 2.0), energy += pow((double)all.height, 2.0);
        }
        // the shader's level is half a level finer, because its triangles blur too: more is left at the vertices
        assert_near(sqrt(shader / cpu), ratios[k], 0.05 * ratios[k]);
        if (!(sqrt(error / energy) < errors[k]))
            fail_msg("on a mesh of %.0f m off by %.3f of the rms height", spacings[k], sqrt(error / energy));
    }
    rig_close(&r);
}

// How far the slopes of pixels, by linear fetches, and of queries, by the gradient of cubic splines, are apart, as a
// share of their root mean square. A wave k along an axis has images k' = k + 2 pi m / h. With r = k / k' a fetch makes
// r^2 of the wave that it leaves, the spline r^4 of the height and so r^3 of its slope (waves/cascades/spline.h).
typedef struct imaging {
    const bolan_cascade_view *view;
    double error, energy;
} imaging;

enum { IMAGES = 2 };
static double ratio_of_image(double kh, int m) { return m == 0 ? 1.0 : kh / (kh + 2.0 * BOLAN_PI * m); }

static double left_by_linear(double kh) {
    const double x = 0.5 * kh, sinc = fabs(x) < 1e-9 ? 1.0 : sin(x) / x;
    return sinc * sinc / sqrt((2.0 + cos(kh)) / 3.0);
}

static void add_images(void *context, const sea_mode *m) {
    imaging *i = context;
    const double h = i->view->length / i->view->n, k = sqrt(m->kx * m->kx + m->ky * m->ky);
    if (k < i->view->k_min || k >= i->view->k_max) return;
    const double c = cos(i->view->angle), s = sin(i->view->angle);
    const double u = h * (m->kx * c + m->ky * s), v = h * (m->ky * c - m->kx * s);
    const double left = left_by_linear(u) * left_by_linear(v);
    const double power = (m->expected + (m->paired ? m->expected_back : 0.0)) / (h * h);
    i->energy += power * (u * u + v * v);
    for (int a = -IMAGES; a <= IMAGES; ++a)
        for (int b = -IMAGES; b <= IMAGES; ++b) {
            const double r = ratio_of_image(u, a), q = ratio_of_image(v, b), fetched = left * r * r * q * q;
            i->error += power * pow(u * (fetched - r * r * r * pow(q, 4.0)), 2.0);
            i->error += power * pow(v * (fetched - q * q * q * pow(r, 4.0)), 2.0);
        }
}

static double images_of_readers(const bolan_sea *sea) {
    imaging all = {0};
    for (uint32_t c = 0; c < bolan_sea_cascade_count(sea); ++c) {
        const bolan_cascade_view v = bolan_sea_cascade(sea, c);
        all.view = &v;
        sea->shared->model->each_wave(sea->shared, add_images, &all);
    }
    return sqrt(all.error / all.energy);
}

static void compare_pixels(const rig *r, double choppiness, double gust, double depth) {
    float in[COUNT][4], out[COUNT][4];
    scatter(in, (float)gust, (float)depth);
    run(r,
        "vec4 probe(vec4 x) { footprint f = footprint(vec2(1.0, 0.0), 1e-4, 1e-4); "
        "wave_fields w = waves_at(x.xy, place_of(x.xy), f, x.z, x.w, vec4(0.0)); "
        "return vec4(w.slope, w.jacobian, w.foam); }",
        4, in, COUNT, out);
    int plain = 0;
    double error = 0.0, energy = 0.0;
    for (int i = 0; i < COUNT; ++i) {
        const bolan_dvec2 at = {r->f.eye.x + (double)in[i][0], r->f.eye.y + (double)in[i][1]};
        const sums t = twin(r->sea, at.x, at.y, gust, depth);
        const double xx = 1.0 + choppiness * t.east[0], xy = choppiness * t.east[1];
        const double yy = 1.0 + choppiness * t.north[1], yx = choppiness * t.north[0];
        const double jacobian = r->packed ? 1.0 + choppiness * (t.xx + t.yy) : xx * yy - xy * yx;
        assert_near(out[i][2], jacobian, JACOBIAN_ERROR);
        assert_near(out[i][3], t.foam, JACOBIAN_ERROR);
        double sx = (t.sx * yy - t.sy * yx) / jacobian, sy = (t.sy * xx - t.sx * xy) / jacobian;
        if (r->packed) sx = t.sx / (0.25 + 0.75 * jacobian), sy = t.sy / (0.25 + 0.75 * jacobian);
        if (jacobian < 0.4 || hypot(sx, sy) > 1.15) continue; // there the shader bounds them
        // An error of the fields is divided by the Jacobian once, and that of the Jacobian by its square.
        const double tolerance = SLOPE_ERROR / jacobian / fmin(jacobian, 1.0);
        assert_near(out[i][0], sx, tolerance);
        assert_near(out[i][1], sy, tolerance);
        bolan_sea_sample s; // what queries answer
        bolan_sea_sample_rest(r->sea, &at, 1, &s);
        error += pow((double)(out[i][0] - s.slope_x), 2.0) + pow((double)(out[i][1] - s.slope_y), 2.0);
        energy += (double)(s.slope_x * s.slope_x + s.slope_y * s.slope_y);
        ++plain;
    }
    // Pixels and queries have the same slopes but for the images that a linear fetch has and a spline has not.
    if (!r->packed && gust == 1.0 && depth > 100.0) {
        const double images = images_of_readers(r->sea);
        print_message("slopes of pixels and queries are %.4f apart; images leave %.4f\n", sqrt(error / energy), images);
        assert_near(sqrt(error / energy), images, 0.15 * images);
    }
    assert_true(plain > COUNT * 9 / 10);
}

static void pixels_have_the_slopes_of_the_cpu(void **state) {
    (void)state;
    const double gusts[] = {1.0, 1.4, 0.7}, depths[] = {1e3, 1e3, 3.0};
    for (int k = 0; k < CASES * 2; ++k) {
        rig r;
        const bolan_dvec2 eye = {cases[k / 2].x, cases[k / 2].y};
        rig_open(&r, cases[k / 2].from, 0.9, eye, cases[k / 2].time, k % 2 == 1);
        for (int i = 0; i < 3; ++i) compare_pixels(&r, 0.9, gusts[i], depths[i]);
        rig_close(&r);
    }
}

// ---- the warped plane -----------------------------------------------------------------------------------------------

// Pixels interpolate between vertices where the sea is read. The gradient of a wave of the warp goes from -0.036 to
// 0.036 in half its length: 0.039 a tile for the shortest, 0.086 for all six. An interpolation over a spacing s is off
// by an eighth of that times s^2: by 0.011 s over a tile, and pixels resolve no waves much shorter than s.
#define BEND_OF_WARP 0.086 // largest second derivative of the place, times the side of the first tile

static void places_may_be_interpolated_between_vertices(void **state) {
    (void)state;
    rig r;
    rig_open(&r, 20.0, 0.0, (bolan_dvec2){123456.7, -98765.4}, 3.0, false);
    const double side = bolan_sea_cascade_layout(r.sea, 0).length;
    float in[COUNT][4], out[COUNT][4];
    scatter(in, 0.0f, 0.0f);
    for (int i = 0; i < COUNT; ++i) in[i][2] = (float)(1.0 * pow(2.0, i % 9)), in[i][3] = (float)i;
    run(&r,
        "vec4 probe(vec4 x) { vec2 half_way = 0.5 * x.z * vec2(cos(x.w), sin(x.w)); "
        "sea_place a = place_of(x.xy - half_way), b = place_of(x.xy + half_way), at = place_of(x.xy); "
        "vec3 bend = abs(0.5 * (a.bend + b.bend) - at.bend); return vec4(distance(0.5 * (a.at + b.at), at.at), "
        "max(bend.x, max(bend.y, bend.z)), distance(at.at, x.xy), length(at.bend)); }",
        4, in, COUNT, out);
    double shift = 0.0, bend = 0.0;
    for (int i = 0; i < COUNT; ++i) {
        const double s = (double)in[i][2];
        const double error = BEND_OF_WARP * s * s / 8.0 / side;
        assert_true((double)out[i][0] < error + 1e-3); // a float of some hundred metres
        assert_true((double)out[i][1] < BEND_OF_WARP * s / 2.0 / side + 1e-5);
        assert_true(error < 0.1 * s);
        shift = fmax(shift, (double)out[i][2]), bend = fmax(bend, (double)out[i][3]);
    }
    assert_true(shift > 5.0 && bend > 0.05); // else there is no warp, and the test says nothing
    rig_close(&r);
}

// The texel of a kept shape holds the rest point to .12 millionths of the distance of the pixel's water where that is
// displaced by little of it; of a displacement as long as the distance, to ten millionths: (1 + 8)^2 times that.
// Of it .119 are half a step of the codes, the rest is the rounding of a float near 1.
#define REST_ERROR 1.3e-7
// Of half a step of the codes: 15 bits of the slope about 0, 13 of the depth by a scale of 4 m, a 32nd of an octave.
#define MESH_SLOPE_ERROR 1.6e-5
#define DEPTH_ERROR 2.6e-4
#define SPACING_ERROR 0.016

// in: xy, the offset of the rest point over the distance; z: log2 of that distance; w: anything.
static const char *const kept_shape = "\n#include \"common/shape.glsl\"\nvec4 probe(vec4 x) { float away = exp2(x.z); "
                                      "vec2 at = away * vec2(cos(x.w), sin(x.w)); "
                                      "water_shape s = water_shape(at + away * x.xy, x.yx, x.z, 4.0 * x.x); "
                                      "uvec4 t = shape_texel(s, at, 1.0 / away); water_shape k = shape_of(t, at); ";

static void a_kept_shape_holds_rest_point_and_mesh(void **state) {
    (void)state;
    rig r;
    rig_open(&r, 20.0, 0.0, (bolan_dvec2){0}, 3.0, false);
    float in[COUNT][4], rest[COUNT][4], mesh[COUNT][4];
    char body[1024];
    for (int i = 0; i < COUNT; ++i) {
        const float angle = 2.4f * (float)i, length = 2.0f * (float)i / (float)COUNT;
        in[i][0] = length * cosf(angle), in[i][1] = length * sinf(angle);
        in[i][2] = (float)(i % 24 - 6), in[i][3] = angle; // from 2 cm to 130 km
    }
    snprintf(body, sizeof body, "%sreturn vec4((k.rest - s.rest) / away, uintBitsToFloat(t.x) * away, 0.0); }",
             kept_shape);
    run(&r, body, 4, in, COUNT, rest);
    snprintf(body, sizeof body, "%sreturn vec4(k.slope - s.slope, k.spacing - s.spacing, k.depth - s.depth); }",
             kept_shape);
    run(&r, body, 4, in, COUNT, mesh);
    double worst = 0.0;
    for (int i = 0; i < COUNT; ++i) {
        for (int axis = 0; axis < 2; ++axis) {
            const double x = 1.0 + 8.0 * fabs((double)in[i][axis]), y = 1.0 + fabs((double)in[i][1 - axis]);
            const double off = fabs((double)rest[i][axis]);
            worst = fmax(worst, (off - 4e-7) / (x * x));
            assert_true(off < REST_ERROR * x * x + 4e-7); // and the rounding of two places of that distance
            assert_true(fabs((double)mesh[i][axis]) < MESH_SLOPE_ERROR * y * y);
        }
        const double x = 1.0 + fabs((double)in[i][0]);
        assert_true(fabs((double)mesh[i][3]) < DEPTH_ERROR * x * x && fabs((double)mesh[i][2]) < SPACING_ERROR);
        assert_true(fabs((double)rest[i][2] - 1.0) < 1e-6);
    }
    assert_true(worst > 0.3 * REST_ERROR); // else the codes were finer than 20 bits
    rig_close(&r);
}

// ---- bound waves ----------------------------------------------------------------------------------------------------

static const char *const pixel_probe = "vec4 probe(vec4 x) { footprint f = footprint(vec2(1.0, 0.0), 1e-4, 1e-4); "
                                       "wave_fields w = waves_at(x.xy, place_of(x.xy), f, 1.0, x.w, vec4(0.0)); "
                                       "return vec4(w.slope, 0.0, 0.0); }";

// What order 2 adds to vertices and pixels is what it adds to samples. A pixel fetches the splines of height and
// displacement linearly, which overstates the short waves in its products.
static void check_bound_waves(bool by_splines, double tolerance) {
    splines = by_splines;
    float in[COUNT][4], vertex[2][COUNT][4], pixel[2][COUNT][4];
    bolan_sea_sample sample[2][COUNT];
    for (int o = 0; o < 2; ++o) {
        rig r;
        order = 1u + (uint32_t)o;
        rig_open(&r, 250.0, 1.0, (bolan_dvec2){123456.7, -98765.4}, 4321.5, false);
        scatter(in, 1.0f, 1e3f);
        run(&r, vertex_probe, 4, in, COUNT, vertex[o]);
        run(&r, pixel_probe, 4, in, COUNT, pixel[o]);
        for (int i = 0; i < COUNT; ++i) {
            const bolan_dvec2 at = {r.f.eye.x + (double)in[i][0], r.f.eye.y + (double)in[i][1]};
            bolan_sea_sample_rest(r.sea, &at, 1, &sample[o][i]);
        }
        rig_close(&r);
    }
    order = 1;
    splines = false;
    double heights = 0.0, slopes = 0.0, slope_error = 0.0;
    for (int i = 0; i < COUNT; ++i) {
        const double raised = (double)(sample[1][i].height - sample[0][i].height);
        assert_near(vertex[1][i][2] - vertex[0][i][2], raised, 5e-4);
        heights += raised * raised / COUNT;
        if (sample[0][i].jacobian < 0.5f) continue; // there the shader bounds slopes
        const double x = (double)(sample[1][i].slope_x - sample[0][i].slope_x),
                     y = (double)(sample[1][i].slope_y - sample[0][i].slope_y);
        slopes += x * x + y * y;
        slope_error += pow((double)(pixel[1][i][0] - pixel[0][i][0]) - x, 2.0) +
                       pow((double)(pixel[1][i][1] - pixel[0][i][1]) - y, 2.0);
    }
    print_message("bound waves: %.4f m rms; slopes of pixels off by %.3f of theirs\n", sqrt(heights),
                  sqrt(slope_error / slopes));
    assert_true(sqrt(heights) > 0.01);
    assert_true(sqrt(slope_error / slopes) < tolerance);
}

static void bound_waves_reach_vertices_and_pixels(void **state) {
    (void)state;
    check_bound_waves(false, 0.25);
    check_bound_waves(true, 0.01);
}

// ---- footprints -----------------------------------------------------------------------------------------------------

// Mean squares of the slopes of pixels at 4096 places of a square of 5 km, by R2 sequence; a quarter of them, from x.w
// on: software OpenGL ends a shader's loops after 65535 turns in all.
enum { QUARTER = 1024 };
static const char *const energy_probe =
    "vec4 probe(vec4 x) {\n"
    "    footprint f = footprint(vec2(cos(x.z), sin(x.z)), x.x, x.y);\n"
    "    vec3 sum = vec3(0.0);\n"
    "    for (int i = 0; i < 1024; ++i) {\n"
    "        vec2 at = 5000.0 * fract((x.w + float(i)) * vec2(0.75487766, 0.56984029));\n"
    "        vec2 s = waves_at(at, place_of(at), f, 1.0, 1e3, vec4(0.0)).slope;\n"
    "        sum += s.xxy * s.xyy / 4096.0;\n"
    "    }\n"
    "    return vec4(sum, 0.0);\n"
    "}\n";
static const char *const rest_probe =
    "vec4 probe(vec4 x) { footprint f = footprint(vec2(cos(x.z), sin(x.z)), x.x, x.y);\n"
    "return vec4(unresolved_slopes(f), 0.0); }";

// What a pixel shows of the slopes and what it leaves to the roughness make the same sum from 1 cm to 1 km, in each
// component of the covariance, to 3 %: the variance of 4096 places is known to sqrt(1 / 4096) = 1.6 %.
#define SUM_ERROR 0.03

static void check_energy(double from, bool packed, uint32_t taps, double aspect) {
    enum { WIDTHS = 17 };
    rig r;
    rig_open(&r, from, 0.0, (bolan_dvec2){4321.0, -1234.0}, 12.0, packed);
    float all[3], in[WIDTHS * 2][4], seen[WIDTHS * 2][4] = {{0}}, left[WIDTHS * 2][4];
    bolan_sea_unresolved_slopes(r.sea, 1e5, 1e5, 0.0, all);
    for (int i = 0; i < WIDTHS * 2; ++i) {
        in[i][1] = (float)(0.01 * pow(10.0, 5.0 * (i % WIDTHS) / (WIDTHS - 1.0)));
        in[i][0] = (float)(aspect * (double)in[i][1]);
        in[i][2] = i < WIDTHS ? 0.3f : 1.9f;
    }
    for (int part = 0; part < 4; ++part) {
        float quarter[WIDTHS * 2][4];
        for (int i = 0; i < WIDTHS * 2; ++i) in[i][3] = (float)(part * QUARTER);
        run(&r, energy_probe, taps, in, WIDTHS * 2, quarter);
        for (int i = 0; i < WIDTHS * 2; ++i)
            for (int k = 0; k < 3; ++k) seen[i][k] += quarter[i][k];
    }
    for (int i = 0; i < WIDTHS * 2; ++i) in[i][3] = (float)taps;
    run(&r, rest_probe, taps, in, WIDTHS * 2, left);
    const double total = (double)(all[0] + all[2]);
    for (int i = 0; i < WIDTHS * 2; ++i) {
        const double width = (double)in[i][1];
        double gain[3];
        for (int k = 0; k < 3; ++k) gain[k] = (double)(seen[i][k] + left[i][k] - all[k]) / total;
        if (!(fabs(gain[0] + gain[2]) < SUM_ERROR))
            fail_msg("a pixel of %.2f m, aspect %.0f: %.3f of the slope variance gained", width, aspect,
                     gain[0] + gain[2]);
        for (int k = 0; k < 3; ++k)
            if (!(fabs(gain[k]) < SUM_ERROR))
                fail_msg("a pixel of %.2f m, aspect %.0f: %.3f gained in component %d", width, aspect, gain[k], k);
    }
    rig_close(&r);
}

static void no_footprint_loses_or_gains_slope_variance(void **state) {
    (void)state;
    check_energy(250.0, false, 4, 1.0);
    check_energy(20.0, false, 4, 4.0);
    check_energy(20.0, false, 2, 8.0);
    check_energy(20.0, true, 1, 1.0);
    splines = true;
    check_energy(250.0, false, 4, 1.0);
    check_energy(20.0, false, 4, 4.0);
    splines = false;
}

// The look-up of the table, at any width, aspect and direction, against the function that it tabulates. Texels lie 2/3
// of an octave and 22.5 degrees apart: 1 % of the sum between them. The sun's radius adds 6e-6.
static void the_table_of_unresolved_slopes_is_looked_up_where_it_should_be(void **state) {
    (void)state;
    rig r;
    rig_open(&r, 20.0, 0.0, (bolan_dvec2){0.0, 0.0}, 1.0, false);
    float all[3], in[COUNT][4], out[COUNT][4];
    bolan_sea_unresolved_slopes(r.sea, 1e5, 1e5, 0.0, all);
    for (int i = 0; i < COUNT; ++i) {
        in[i][0] = (float)(0.05 * pow(2000.0, i % 16 / 15.0));
        in[i][1] = in[i][0] / (float[]){1.0f, 3.0f, 10.0f, 40.0f}[i / 16 % 4];
        in[i][2] = (float)(BOLAN_PI * (0.03 + i / 64 * 0.25));
    }
    run(&r,
        "vec4 probe(vec4 x) { return vec4(unresolved_slopes(footprint(vec2(cos(x.z), sin(x.z)), x.x, x.y)), 0.0); }", 4,
        in, COUNT, out);
    const double total = (double)(all[0] + all[2]);
    double worst = 0.0;
    for (int i = 0; i < COUNT; ++i) {
        float want[3];
        bolan_sea_unresolved_slopes(r.sea, 0.4 * (double)in[i][0], 0.4 * (double)in[i][1], (double)in[i][2], want);
        for (int k = 0; k < 3; ++k) worst = fmax(worst, fabs((double)(out[i][k] - want[k])) / total);
    }
    assert_true(worst < 0.01); // half a per cent was measured
    rig_close(&r);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        IN_BOTH_APIS(vertices_stand_where_the_cpu_has_them),
        IN_BOTH_APIS(vertices_of_a_coarse_mesh_have_the_long_waves),
        IN_BOTH_APIS(pixels_have_the_slopes_of_the_cpu),
        IN_BOTH_APIS(places_may_be_interpolated_between_vertices),
        IN_BOTH_APIS(a_kept_shape_holds_rest_point_and_mesh),
        IN_BOTH_APIS(bound_waves_reach_vertices_and_pixels),
        IN_BOTH_APIS(the_table_of_unresolved_slopes_is_looked_up_where_it_should_be),
        IN_BOTH_APIS(no_footprint_loses_or_gains_slope_variance),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
