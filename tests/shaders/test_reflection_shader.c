// SPDX-License-Identifier: MIT
// What rough water reflects (shaders/common/reflection.glsl, slopes.glsl) against sums over facets done the long way.
#include "probe.h"

#include <math.h>

#define INCLUDES                                                                                                  \
    "#include \"shared/earth.glsl\"\n#include \"shared/fresnel.glsl\"\n"                                          \
    "#include \"common/slopes.glsl\"\n#include "                                                                  \
    "\"common/reflection.glsl\"\nsurroundings alone(vec2 m, vec3 c) { return surroundings(m, c, vec3(0.0), 0.0, " \
    "1e4); }"

// A sea whose axes are turned: covariance (xx, xy, yy) of variances along and across an axis at `turn` [rad].
typedef struct covariance {
    double xx, xy, yy;
} covariance;
static covariance turned(double along, double across, double turn) {
    const double c = cos(turn), s = sin(turn);
    return (covariance){along * c * c + across * s * s, (along - across) * c * s, along * s * s + across * c * c};
}

static double fresnel(double c, double n) {
    const double t = sqrt(1.0 - (1.0 - c * c) / (n * n));
    const double rs = (c - n * t) / (c + n * t), rp = (n * c - t) / (n * c + t);
    return 0.5 * (rs * rs + rp * rp);
}
static double below(double x) { return 0.5 * erfc(-x / sqrt(2.0)); }
static double density(double x) { return exp(-0.5 * x * x) / sqrt(2.0 * BOLAN_PI); }
static double unhidden(double u) { // Smith 1967
    return u > 0.0 ? u / (u * below(u) + density(u)) : 0.0;
}

static void the_mean_reflectance_is_the_sum_over_visible_facets(void **state) {
    (void)state;
    // The sea's axis lies 30 degrees from the world's, so that x, y and their covariance all count.
    FILE *file = fopen(BOLAN_SOURCE_DIR "/tests/data/light/mean_fresnel.csv", "r");
    assert_non_null(file);
    char line[256];
    uint32_t count = 0;
    double seas[8][2];
    uint32_t sea_count = 0;
    float in[PROBE_WIDTH][4], out[PROBE_WIDTH][4];
    double want[PROBE_WIDTH];
    while (fgets(line, sizeof line, file) != NULL) {
        double along, across, azimuth, down, mean;
        if (sscanf(line, "%lf,%lf,%lf,%lf,%lf", &along, &across, &azimuth, &down, &mean) != 5) continue;
        if (sea_count == 0 || seas[sea_count - 1][0] != along)
            seas[sea_count][0] = along, seas[sea_count++][1] = across;
        const double a = bolan_radians(30.0 + azimuth);
        in[count][0] = (float)(cos(a) * cos(bolan_radians(down)));
        in[count][1] = (float)(sin(a) * cos(bolan_radians(down)));
        in[count][2] = (float)sin(bolan_radians(down));
        in[count][3] = (float)(sea_count - 1);
        want[count++] = mean;
    }
    fclose(file);
    assert_int_equal(count, 108);
    covariance c[3];
    assert_int_equal(sea_count, 3);
    for (int i = 0; i < 3; ++i) c[i] = turned(seas[i][0], seas[i][1], bolan_radians(30.0));
    char body[1024];
    snprintf(body, sizeof body,
             "vec4 probe(vec4 x) { vec3 c = x.w < 0.5 ? vec3(%.7f, %.7f, %.7f) : x.w < 1.5 ? vec3(%.7f, %.7f, %.7f) : "
             "vec3(%.7f, %.7f, %.7f); visible_facets f = facets_seen(x.xyz, vec2(0.0), c); rough_reflection r = "
             "reflection_of(x.xyz, vec2(0.0), f, alone(vec2(0.0), c), 1.34); return vec4(r.reflectance, r.clear, 0.0, "
             "0.0); }",
             c[0].xx, c[0].xy, c[0].yy, c[1].xx, c[1].xy, c[1].yy, c[2].xx, c[2].xy, c[2].yy);
    probe_run(INCLUDES, body, in, count, out);
    for (uint32_t i = 0; i < count; ++i) {
        assert_near(out[i][0], want[i], 0.01 * want[i]); // three places stand for all facets: within 0.6 %
        assert_true(out[i][1] <= out[i][0] && out[i][1] > 0.2f * out[i][0]);
    }
}

static void still_water_is_a_mirror(void **state) {
    (void)state;
    float in[5][4] = {{60}, {75}, {80}, {85}, {20}}, out[5][4];
    probe_run(INCLUDES,
              "vec4 probe(vec4 x) { float a = radians(x.x); vec3 v = vec3(0.6 * sin(a), -0.8 * sin(a), cos(a)), c = "
              "vec3(1e-7, 0.0, 1e-7); visible_facets f = facets_seen(v, vec2(0.0), c); rough_reflection r = "
              "reflection_of(v, vec2(0.0), f, alone(vec2(0.0), c), 1.333); return vec4(r.reflectance, r.clear, r.tilt, "
              "r.spread); }",
              in, 5, out);
    const double want[5] = {.05969, .21238, .34792, .58352, .02073};
    for (int i = 0; i < 5; ++i) {
        assert_near(out[i][0], want[i], 1e-3);
        assert_near(out[i][1], want[i], 0.02 * want[i]); // nothing stands in the way; the sum of five places
        assert_near(out[i][2], 0.0, 1e-3);
        assert_true(out[i][3] < 1e-3f);
    }
}

// The same integrals over a lattice of slopes along the view and across it.
static void tilted_and_turned_facets_match_quadrature(void **state) {
    (void)state;
    const covariance c = turned(0.05, 0.015, bolan_radians(30.0));
    const double mx = 0.06, my = -0.04;
    enum { COUNT = 12 };
    float in[COUNT][4], area[COUNT][4], more[COUNT][4];
    for (int i = 0; i < COUNT; ++i) {
        const double azimuth = bolan_radians(20.0 + 75.0 * (i % 4)), down = bolan_radians(i < 4   ? 4.0
                                                                                          : i < 8 ? 20.0
                                                                                                  : 60.0);
        in[i][0] = (float)(cos(azimuth) * cos(down)), in[i][1] = (float)(sin(azimuth) * cos(down)),
        in[i][2] = (float)sin(down);
    }
    char body[512];
    snprintf(
        body, sizeof body,
        "vec4 probe(vec4 x) { visible_facets f = facets_seen(x.xyz, vec2(%.3f, %.3f), vec3(%.8f, %.8f, %.8f)); return ",
        mx, my, c.xx, c.xy, c.yy);
    char first[600], second[600];
    snprintf(first, sizeof first, "%s vec4(f.area, f.shift, f.sigma, f.across); }", body);
    snprintf(second, sizeof second, "%s vec4(f.toward, f.narrow, 0.0); }", body);
    probe_run(INCLUDES, first, in, COUNT, area);
    probe_run(INCLUDES, second, in, COUNT, more);
    for (int i = 0; i < COUNT; ++i) {
        const double vx = in[i][0], vy = in[i][1], vz = in[i][2], flat = hypot(vx, vy), det = c.xx * c.yy - c.xy * c.xy;
        double m0 = 0, m1 = 0, m2 = 0, mq = 0, mtq = 0, mqq = 0;
        for (int j = -200; j < 200; ++j)
            for (int k = -200; k < 200; ++k) {
                const double x = (j + 0.5) * 0.006, y = (k + 0.5) * 0.006; // extra slope
                const double p =
                    exp(-0.5 * (c.yy * x * x - 2 * c.xy * x * y + c.xx * y * y) / det) / (2 * BOLAN_PI * sqrt(det));
                const double w = p * fmax(vz - vx * (mx + x) - vy * (my + y), 0.0) * 0.006 * 0.006;
                const double t = -(x * vx + y * vy) / flat, q = (x * -vy + y * vx) / flat;
                m0 += w, m1 += w * t, m2 += w * t * t, mq += w * q, mtq += w * t * q, mqq += w * q * q;
            }
        const double mean = m1 / m0, deviation = sqrt(m2 / m0 - mean * mean),
                     all = sqrt(c.xx * vx * vx + 2 * c.xy * vx * vy + c.yy * vy * vy) / flat;
        assert_near(area[i][0], m0, 0.01 * m0 + 1e-4); // the distribution function is good to 1e-5, next to small areas
        assert_near(area[i][1], mean, 0.01 * all + 1e-4);
        assert_near(area[i][2], deviation, 0.01 * all + 1e-4);
        assert_near(more[i][2], 1.0 - deviation / all, 0.01);
        // slope across the view goes with that along it: regression, and what is left
        const double toward_x = more[i][0], toward_y = more[i][1];
        assert_near(-(toward_x * vx + toward_y * vy) / flat, 1.0, 1e-3);
        assert_near((toward_x * -vy + toward_y * vx) / flat, mtq / m2, 0.01);
        assert_near(area[i][3], sqrt(mqq / m0 - mtq * mtq / (m2 * m0)), 0.02 * all);
    }
}

static void three_places_have_the_moments_of_the_visible_facets(void **state) {
    (void)state;
    enum { COUNT = 8 };
    float in[COUNT][4], offset[COUNT][4], weight[COUNT][4];
    const double u[COUNT] = {-1.5, -0.5, 0.0, 0.5, 1.0, 2.0, 3.0, 8.0};
    for (int i = 0; i < COUNT; ++i) in[i][0] = (float)u[i];
#define NODES                                                                                                        \
    "vec4 probe(vec4 x) { vec3 o, w; facet_nodes(facets_seen(normalize(vec3(1.0, 0.0, 0.1)), vec2(0.1 - 0.1 * x.x, " \
    "0.0), "                                                                                                         \
    "vec3(0.01, 0.0, 0.01)), o, w); return vec4("
    probe_run(INCLUDES, NODES "o, 0.0); }", in, COUNT, offset);
    probe_run(INCLUDES, NODES "w, 0.0); }", in, COUNT, weight);
    for (int i = 0; i < COUNT; ++i) {
        double m[4] = {0}, want[3] = {0}, sum[4] = {0};
        for (int k = 0; k < 3; ++k)
            for (int p = 0; p < 4; ++p) m[p] += (double)weight[i][k] * pow((double)offset[i][k], p);
        for (int j = -40000; j < 40000; ++j) {
            const double t = (j + 0.5) * 2e-4, w = fmax(u[i] + t, 0.0) * exp(-0.5 * t * t);
            for (int p = 0; p < 4; ++p) sum[p] += w * pow(t, p);
        }
        for (int p = 1; p < 4; ++p) want[p - 1] = sum[p] / sum[0];
        const double s2 = want[1] - want[0] * want[0];
        const double skewness = (want[2] - 3 * want[0] * want[1] + 2 * pow(want[0], 3)) / pow(s2, 1.5);
        assert_near(m[0], 1.0, 1e-4);
        assert_near(m[1], 0.0, 1e-4);
        assert_near(m[2], 1.0, 1e-3);
        assert_near(m[3], skewness, 0.06); // the cubics are good to 0.03, next to 1 to 3
        for (int k = 0; k < 3; ++k) assert_true(weight[i][k] > 0.0f);
    }
}

// Over all directions the reflected sun, weighed by their cosine, gives what the facets reflect that both sides see:
// the sum over facets of density, lit area, Fresnel's reflectance and Smith's shares. Low suns too, and a sea whose
// axes are turned.
static void the_glitter_has_the_energy_of_the_facets(void **state) {
    (void)state;
    const double suns[4][3] = {{0.6, 0.0, 0.8}, {0.0, 0.6, 0.8}, {0.9961947, 0.0, 0.0871557}, {-0.7, 0.68571, 0.2}};
    for (int k = 0; k < 4; ++k) {
        const double rough = k < 2 ? 0.02 : 1.0; // nearly still water under the high suns
        const covariance c = turned(0.03 * rough, 0.01 * rough, bolan_radians(30.0));
        const double *s = suns[k], step = 0.075 * sqrt(rough), det = c.xx * c.yy - c.xy * c.xy;
        float in[256][4] = {{0}}, out[256][4];
        double weight[256], want = 0, sum = 0,
                            along_sun = sqrt(c.xx * s[0] * s[0] + 2 * c.xy * s[0] * s[1] + c.yy * s[1] * s[1]);
        for (int i = 0; i < 256; ++i) {
            const double x = (i % 16 - 7.5) * step, y = (i / 16 - 7.5) * step, n = sqrt(1 + x * x + y * y);
            const double normal[3] = {-x / n, -y / n, 1 / n},
                         cosine = normal[0] * s[0] + normal[1] * s[1] + normal[2] * s[2];
            double v[3];
            for (int a = 0; a < 3; ++a) v[a] = 2 * cosine * normal[a] - s[a], in[i][a] = (float)v[a];
            weight[i] = cosine > 0 && v[2] > 0 ? v[2] * 4.0 * cosine * pow(normal[2], 3) * step * step : 0.0;
            if (weight[i] == 0.0) in[i][0] = 0, in[i][1] = 0.6f, in[i][2] = 0.8f;
            if (weight[i] == 0.0) continue;
            const double p =
                exp(-0.5 * (c.yy * x * x - 2 * c.xy * x * y + c.xx * y * y) / det) / (2 * BOLAN_PI * sqrt(det));
            const double along = sqrt(c.xx * v[0] * v[0] + 2 * c.xy * v[0] * v[1] + c.yy * v[1] * v[1]);
            want += p * fresnel(cosine, 1.34) * cosine / normal[2] * unhidden(v[2] / along) *
                    unhidden(s[2] / along_sun) * step * step;
        }
        char body[600];
        snprintf(
            body, sizeof body,
            "vec4 probe(vec4 x) { vec3 c = vec3(%.8f, %.8f, %.8f); visible_facets f = facets_seen(x.xyz, vec2(0.0), "
            "c); "
            "return vec4(sun_glint(x.xyz, vec3(%.7f, %.7f, %.7f), vec2(0.0), c, f, alone(vec2(0.0), c), f, 1.34)); }",
            c.xx, c.xy, c.yy, s[0], s[1], s[2]);
        probe_run(INCLUDES, body, in, 256, out);
        for (int i = 0; i < 256; ++i) sum += (double)out[i][0] * weight[i];
        assert_near(sum, want, 0.03 * want); // Smith's ratio in rational form: 0.005 at each end, and the area 1 %
        // high sun: F(36.87 deg) = .0231 of the irradiance on the water, less what lies beyond the lattice

        if (k < 2) assert_near(sum, 0.0231 * 0.8, 0.05 * 0.0231 * 0.8);
    }
}

// Of the motions that neither of two opposite barriers stops: a sum of sines (Borodin & Salminen 2002).
static double between(double u, double w, double tilt) {
    double sum = 0, l = u + w;
    for (int k = 1; k < 60; ++k)
        sum += sin(k * BOLAN_PI * w / l) * sin(k * BOLAN_PI * (w - tilt) / l) * exp(-0.5 * pow(k * BOLAN_PI / l, 2));
    return 2 / l * sum / density(tilt);
}
static double one_side(double u, double tilt) { return 1 - exp(-2 * u * (u + tilt)); }

// The area of the facets over the plan of the light that falls on them, or that the observer sees.
static double plan_over_area(double u, double step) {
    const double w = u + 2 * step;
    return u / (u * below(u) + density(u) + w * below(-w) - density(w));
}

// Waves of all lengths over a level sea of one deviation on all sides, an observer `down` and a sun `up`: to the other
// side, across, and to the observer's side.
static double lit(double down, double up, double deviation, double step, int side) {
    const double v[3] = {cos(down), 0, sin(down)};
    const double s[3] = {side * cos(up), side == 0 ? cos(up) : 0, sin(up)};
    const double x = -(v[0] + s[0]) / (v[2] + s[2]), y = -(v[1] + s[1]) / (v[2] + s[2]); // the facet's slope
    const double u = tan(down) / deviation, w = tan(up) / deviation, b = step / deviation;
    const double tilt = -x / deviation, to_sun = side == 0 ? -y / deviation : side * tilt;
    const double both = side < 0    ? between(u + b, w + b, tilt)
                        : side == 0 ? one_side(u + b, tilt) * one_side(w + b, to_sun)
                                    : one_side(fmin(u, w) + b, tilt);
    return both * plan_over_area(u, b) * plan_over_area(w, b) * (u * below(u) + density(u)) / u;
}

static void what_leans_towards_the_observer_leans_away_from_a_low_sun(void **state) {
    (void)state;
    enum { COUNT = 12 };
    const double cases[COUNT][3] = {{1.5, 5, -1}, {4, 5, -1}, {7, 5, -1}, {10, 5, -1}, {1.5, 20, -1}, {10, 20, -1},
                                    {5, 60, -1},  {3, 8, 0},  {8, 12, 0}, {20, 5, 0},  {3, 12, 1},    {15, 6, 1}};
    const double deviation = 0.1355, step = 0.02;
    float in[COUNT][4] = {{0}}, out[COUNT][4];
    for (int i = 0; i < COUNT; ++i) {
        in[i][0] = (float)bolan_radians(cases[i][0]), in[i][1] = (float)bolan_radians(cases[i][1]);
        in[i][2] = (float)cases[i][2];
    }
    char body[700];
    snprintf(body, sizeof body,
             "vec4 probe(vec4 x) { vec2 h = vec2(0.8, -0.6), to = x.z == 0.0 ? vec2(0.6, 0.8) : x.z * h; vec3 v = "
             "vec3(h * cos(x.x), sin(x.x)), s = vec3(to * cos(x.y), sin(x.y)), m = normalize(v + s), c = vec3(%.8f, "
             "0.0, %.8f); surroundings n = surroundings(vec2(0.0), c, vec3(0.0), 0.0, %.8f); return vec4(lit_share(v, "
             "s, -m.xy / m.z, n, facets_seen(v, vec2(0.0), c)), 0.0, 0.0, 0.0); }",
             deviation * deviation, deviation * deviation, step);
    probe_run(INCLUDES, body, in, COUNT, out);
    for (int i = 0; i < COUNT; ++i) {
        const double want = lit((double)in[i][0], (double)in[i][1], deviation, step, (int)cases[i][2]);
        assert_near(out[i][0], want, 0.01 * want + 0.01); // the images: 0.01
    }
    assert_true(out[0][0] < 0.5f * 0.8f); // 0.8: Smith's share of facets that a sun of 5 degrees reaches
}

static void waves_of_the_mesh_hide_low_rays_from_low_places(void **state) {
    (void)state;
    // height [deviations], elevation [deviations of the slope]: P^L with P(-1, 0, 2) = .1587, .5, .9772, L(.5, 1) =
    // .3957, .0833
    float in[5][4] = {{0, 0.5f}, {0, 1.0f}, {-1, 0.5f}, {2, 0.5f}, {0, -0.5f}}, out[5][4];
    probe_run(INCLUDES,
              "vec4 probe(vec4 x) { surroundings s = surroundings_of(vec2(0.0), vec3(0.0), vec3(0.04, 0.0, 0.01), "
              "x.x); return "
              "vec4(clear_of_mesh(s, x.y * 0.2, 1.0 / 0.2), s.mesh); }",
              in, 5, out);
    const double want[4] = {pow(.5, .3957), pow(.5, .0833), pow(.1587, .3957), pow(.9772, .3957)};
    for (int i = 0; i < 4; ++i)
        assert_near(out[i][0], want[i], 0.006); // the rational form's 0.005 and the distribution's 2e-4
    assert_true(out[4][0] < 0.01f);
    assert_near(out[0][1], 0.04, 1e-6);
    assert_near(out[0][3], 0.01, 1e-6);
}

// Detail that look-ups resolve is found at any slope; its visible part leans towards the observer by the regression on
// the whole tilt.
static void detail_is_seen_where_it_leans_towards_the_observer(void **state) {
    (void)state;
    const double detail = 0.006, rest = 0.012, down = bolan_radians(4.0), turn = bolan_radians(40.0), u = tan(down);
    double m0 = 0, m1 = 0, m2 = 0;
    for (int i = -400; i < 400; ++i)
        for (int j = -400; j < 400; ++j) {
            const double a = (i + 0.5) * 0.0125, b = (j + 0.5) * 0.0125, t = a * sqrt(detail);
            const double w = exp(-0.5 * (a * a + b * b)) * fmax(u + t + b * sqrt(rest), 0.0);
            m0 += w, m1 += w * t, m2 += w * t * t;
        }
    const double mean = m1 / m0, kept = sqrt(m2 / m0 - mean * mean) / sqrt(detail);
    // the middle of the distribution and one deviation towards the observer, whose direction is h; the mesh's plane is
    // level
    float in[2][4] = {{0}, {(float)-sqrt(detail)}}, out[2][4];
    char body[700];
    snprintf(body, sizeof body,
             "vec4 probe(vec4 x) { vec2 h = vec2(%.7f, %.7f); vec3 v = vec3(h * %.7f, %.7f), c = vec3(%.5f, 0.0, "
             "%.5f); surroundings s = "
             "alone(vec2(0.0), c); vec2 m = seen_slope(v, h * x.x + 0.03 * vec2(-h.y, h.x), s, facets_seen(v, "
             "vec2(0.0), c), "
             "vec3(%.5f, 0.0, %.5f)); return vec4(dot(m, h), dot(m, vec2(-h.y, h.x)), 0.0, 0.0); }",
             cos(turn), sin(turn), cos(down), sin(down), detail + rest, detail + rest, rest, rest);
    probe_run(INCLUDES, body, in, 2, out);
    assert_near(out[0][0], -mean, 0.01 * sqrt(detail));
    assert_near(out[1][0], -mean - kept * sqrt(detail), 0.02 * sqrt(detail));
    assert_near(out[0][1], 0.03, 1e-5); // nothing happens across the view
}

// Seen level, rough water reflects what tests/data/light/mean_fresnel.csv has at 1 degree; a sea without waves, all.
// Rounding may leave a variance a little below 0.
static void level_water_reflects_less_the_rougher_it_is(void **state) {
    (void)state;
    float in[6][4] = {{0.008f}, {0.02528f}, {0.06f}, {0.01836f}, {0.04f}, {-1e-9f}}, out[6][4];
    const double want[6] = {0.51671, 0.35414, 0.24258, 0.40081, 0.29649, 1.0};
    probe_run(INCLUDES, "vec4 probe(vec4 x) { return vec4(level_reflectance(x.x)); }", in, 6, out);
    for (int i = 0; i < 6; ++i) assert_near(out[i][0], want[i], 0.09 * want[i]); // as the function says
}

static void heights_are_over_the_round_earths_water(void **state) {
    (void)state;
    // A crest 2 m high 10 km away seen from 30 m: the water lies 7.848 m lower there; a trough of 1 m beside the eye.
    float in[2][4] = {{6000, -8000, 2.0f - 30.0f - 7.848f, 30}, {3, 4, -31, 30}}, out[2][4];
    probe_run(INCLUDES, "vec4 probe(vec4 x) { return vec4(earth_height(x.z, x.w, dot(x.xy, x.xy), 6371000.0)); }", in,
              2, out);
    assert_near(out[0][0], 2.0, 1e-3);
    assert_near(out[1][0], -1.0, 1e-3);
}

static void two_fetches_keep_the_lobes_width_and_make_one_image(void **state) {
    (void)state;
    float in[5][4] = {{0.1f, 0.0f}, {0.1f, 0.05f}, {0.1f, 0.08f}, {0.1f, 0.2f}, {0.02f, 0.01f}}, out[5][4];
    probe_run(INCLUDES, "vec4 probe(vec4 x) { return vec4(fetches_of(x.x, x.y), 0.0, 0.0); }", in, 5, out);
    for (int i = 0; i < 5; ++i) {
        const double blur = out[i][0], apart = out[i][1], along = in[i][0];
        assert_near(blur * blur + apart * apart, along * along, 1e-5 * along * along);
        double most = 0.0, middle = 0.0;
        for (int k = 0; k <= 100; ++k) {
            const double x = 0.02 * k * along, less = (x - apart) / blur, more = (x + apart) / blur;
            const double density = exp(-0.5 * less * less) + exp(-0.5 * more * more);
            most = fmax(most, density);
            if (k == 0) middle = density;
        }
        assert_true(middle > 0.95 * most); // a dip of a tenth shows as two edges of a cloud
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        IN_BOTH_APIS(the_mean_reflectance_is_the_sum_over_visible_facets),
        IN_BOTH_APIS(still_water_is_a_mirror),
        IN_BOTH_APIS(two_fetches_keep_the_lobes_width_and_make_one_image),
        IN_BOTH_APIS(tilted_and_turned_facets_match_quadrature),
        IN_BOTH_APIS(three_places_have_the_moments_of_the_visible_facets),
        IN_BOTH_APIS(the_glitter_has_the_energy_of_the_facets),
        IN_BOTH_APIS(what_leans_towards_the_observer_leans_away_from_a_low_sun),
        IN_BOTH_APIS(waves_of_the_mesh_hide_low_rays_from_low_places),
        IN_BOTH_APIS(heights_are_over_the_round_earths_water),
        IN_BOTH_APIS(level_water_reflects_less_the_rougher_it_is),
        IN_BOTH_APIS(detail_is_seen_where_it_leans_towards_the_observer),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
