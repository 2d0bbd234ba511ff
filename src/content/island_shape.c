// SPDX-License-Identifier: MIT
// The island's plan and shape. Two signed distances define them: to the coast (positive on land) and to the outer edge
// of the reef (positive inside).
//
//      windward: cliffs,   .-~~~-.      u -> lagoon side
//      rock stacks       .'  ^ ^  '.__        headlands, bays with beaches
//                       (  (  crater   >  ~ lagoon 1-6 m ~ )|  reef crest, sand islets, passes
//                        '.  ^    .'~~        bommies      )|
//                          '-.__.-'                         \ drop-off
#include "content/island.h"

#include "ground/noise.h"

static float hypot2(float x, float y) { return sqrtf(x * x + y * y); }
// Unit vector at so many degrees from u towards v.
static void direction(float degrees, float *u, float *v) {
    float turns = degrees / 360.0f;
    corners c = cosines_of_turns((corners){turns, turns - 0.25f, 0.0f, 0.0f});
    *u = c[0], *v = c[1];
}

// ---- the plan
// --------------------------------------------------------------------------------------------------------

static void plan_headlands(island_plan *p) {
    const float at[ISLAND_HEADLANDS] = {-78.0f, -24.0f, 31.0f, 84.0f};
    for (uint32_t n = 0; n < ISLAND_HEADLANDS; n++) {
        float u, v, reach = 0.83f + 0.17f * hash_unit(p->seed, 10 + n);
        direction(at[n] + 14.0f * (hash_unit(p->seed, 20 + n) - 0.5f), &u, &v);
        p->headland[n].u = 0.35f * u - 0.1f, p->headland[n].v = 0.35f * v;
        p->headland[n].tu = reach * u, p->headland[n].tv = reach * v;
        p->headland[n].root = 0.15f, p->headland[n].tip = 0.045f + 0.03f * hash_unit(p->seed, 30 + n);
        p->headland[n].height = 0.24f + 0.22f * hash_unit(p->seed, 40 + n);
    }
}

static void plan_reef(island_plan *p) {
    const float motu_at[ISLAND_MOTUS] = {-62.0f, -33.0f, 14.0f, 52.0f};
    const float pass_at[ISLAND_PASSES] = {-8.0f, 33.0f};
    for (uint32_t n = 0; n < ISLAND_MOTUS; n++) {
        float u, v;
        direction(motu_at[n] + 10.0f * (hash_unit(p->seed, 50 + n) - 0.5f), &u, &v);
        p->motu[n].u = 0.28f + 0.955f * u, p->motu[n].v = 0.955f * v;
        p->motu[n].along_u = -v, p->motu[n].along_v = u;
        p->motu[n].length = 0.07f + 0.09f * hash_unit(p->seed, 60 + n);
        p->motu[n].width = 0.018f + 0.018f * hash_unit(p->seed, 70 + n);
    }
    for (uint32_t n = 0; n < ISLAND_PASSES; n++) {
        direction(pass_at[n] + 12.0f * (hash_unit(p->seed, 80 + n) - 0.5f), &p->pass[n].u, &p->pass[n].v);
    }
}

island_plan bolan_island_plan_make(const bolan_ground_generator *generator) {
    island_plan p = {0};
    double sine, cosine;
    bolan_sincos(bolan_radians(bolan_wrap_degrees(generator->lagoon_from_deg)), &sine, &cosine);
    p.radius = (float)generator->radius, p.peak = (float)generator->peak, p.sea_floor = (float)generator->sea_floor;
    p.axis_x = (float)sine, p.axis_y = (float)cosine;
    p.seed = hash_cell((int32_t)(generator->seed & 0xffffffffu), (int32_t)(generator->seed >> 32), 0xb01au);
    plan_headlands(&p);
    plan_reef(&p);
    direction(96.0f + 30.0f * hash_unit(p.seed, 90), &p.peak2_u, &p.peak2_v);
    return p;
}

// ---- distances
// -------------------------------------------------------------------------------------------------------

// A point of the island: distances [radii] and the kind of place.
typedef struct place {
    float u, v;     // [radii]
    float x, y;     // [m]
    float coast;    // distance to the coast, positive on land
    float reef;     // distance to the reef's outer edge, positive inside
    float lee;      // 1 on the lagoon side, 0 to windward
    float sandy;    // 1 in the bays, 0 on rocky shores
    float headland; // distance to the nearest headland's axis
    float spur;     // height of that headland as a share of the peak
} place;

static float capsule(const island_plan *p, uint32_t n, float u, float v, float *along) {
    float du = p->headland[n].tu - p->headland[n].u, dv = p->headland[n].tv - p->headland[n].v;
    float t = clamp01(((u - p->headland[n].u) * du + (v - p->headland[n].v) * dv) / (du * du + dv * dv));
    *along = t;
    return hypot2(u - p->headland[n].u - t * du, v - p->headland[n].v - t * dv);
}

static place locate(const island_plan *p, double x, double y) {
    place a = {0};
    a.x = (float)x, a.y = (float)y;
    float u = (a.x * p->axis_x + a.y * p->axis_y) / p->radius, v = (a.y * p->axis_x - a.x * p->axis_y) / p->radius;
    float rho = hypot2(u, v);
    a.lee = smoothstepf(-0.25f, 0.45f, u / fmaxf(rho, 0.05f));
    // Domain warp, so that outlines are not circles. Rocky coasts are ragged, sandy ones smooth.
    float wu = fractal_noise(2.1 * u + 3.7, 2.1 * v, 3, p->seed + 1),
          wv = fractal_noise(2.1 * u, 2.1 * v + 8.1, 3, p->seed + 2);
    float ragged = fractal_noise(9.0 * u, 9.0 * v, 4, p->seed + 3);
    a.u = u + 0.085f * wu, a.v = v + 0.085f * wv;
    float land = 0.66f - hypot2(a.u + 0.16f, a.v * 0.94f);
    land = smooth_max(land, 0.36f - hypot2(a.u + 0.38f, a.v - 0.38f), 0.15f);
    land = smooth_max(land, 0.33f - hypot2(a.u + 0.34f, a.v + 0.42f), 0.15f);
    a.headland = 10.0f;
    for (uint32_t n = 0; n < ISLAND_HEADLANDS; n++) {
        float t, d = capsule(p, n, a.u, a.v, &t);
        land = smooth_max(land, lerpf(p->headland[n].root, p->headland[n].tip, t) - d, 0.10f);
        if (d < a.headland) {
            a.headland = d;
            a.spur = p->headland[n].height * lerpf(1.0f, 0.55f, t * t);
        }
    }
    a.sandy = a.lee * smoothstepf(0.075f, 0.15f, a.headland + 0.03f * ragged);
    a.coast = land + lerpf(0.040f, 0.006f, a.sandy) * ragged;
    float blob = 1.02f + 0.035f * ragged - hypot2(u - 0.28f + 0.07f * wu, v + 0.07f * wv);
    a.reef = smooth_max(land + 0.05f + 0.03f * wu, blob - 0.5f * (1.0f - a.lee), 0.08f) + 0.006f * ragged;
    return a;
}

// ---- land
// ------------------------------------------------------------------------------------------------------------

// Concave flank of an eroded ridge: 1 on the crest, falling as running water leaves it.
static float flank(float x) { return 1.0f / ((1.0f + x) * (1.0f + 0.8f * x * x)); }

static float crater(const island_plan *p, const place *a) {
    float u = a->u + 0.20f, v = a->v, r = fmaxf(hypot2(u, v), 1e-3f);
    float cu = u / r, cv = v / r;
    // The rim: highest to windward, broken open towards the lagoon, with a second summit and saddles.
    float rim = lerpf(0.92f, 0.16f, smoothstepf(-0.1f, 0.85f, cu));
    float second = cu * p->peak2_u + cv * p->peak2_v;
    rim += 0.50f * smoothstepf(0.80f, 1.0f, second) + 0.16f * smoothstepf(0.93f, 1.0f, -cu + 0.25f * cv);
    rim *= 1.0f + 0.42f * gradient_noise(3.1 * cu + 11.0, 3.1 * cv, p->seed + 5).v;
    float off = r - 0.25f - 0.05f * gradient_noise(2.0 * cu, 2.0 * cv + 5.0, p->seed + 6).v;
    float x = sqrtf(off * off + 0.0002f) / (off > 0.0f ? 0.20f : 0.11f);
    return rim * flank(x);
}

static float mountains(const island_plan *p, const place *a) {
    float cone = 0.30f * clamp01(1.0f - hypot2(a->u + 0.2f, a->v) / 0.75f);
    float spur = a->spur * flank(sqrtf(a->headland * a->headland + 0.0002f) / 0.075f);
    float body = smooth_max(smooth_max(crater(p, a), cone, 0.06f), spur, 0.08f);
    float hills = fractal_noise(5.0 * a->u + 1.7, 5.0 * a->v, 3, p->seed + 7);
    return p->peak * body * (1.0f + 0.22f * hills);
}

// Land at @d metres from the coast: a beach and a plain in the bays, a platform under a cliff elsewhere.
static float shore_profile(const island_plan *p, const place *a, float d) {
    float beach = d < 54.0f ? d / 15.0f : 3.6f + (d - 54.0f) * 0.022f;
    float bluff = 0.5f + 0.7f * fractal_noise(a->x / 260.0, a->y / 260.0, 2, p->seed + 8);
    float cliff = 0.06f * d + fminf(0.06f * p->peak, 34.0f) * clamp01(bluff) * smoothstepf(2.0f, 22.0f, d) + 0.22f * d;
    return lerpf(cliff, beach, a->sandy);
}

static float land(const island_plan *p, const place *a, float *drained) {
    float d = a->coast * p->radius;
    float spurs = 1.0f + 0.6f * fractal_noise(a->x / (0.16 * p->radius), a->y / (0.16 * p->radius), 2, p->seed + 9);
    float foot = lerpf(0.16f, 0.30f, a->sandy) * p->radius * fmaxf(spurs, 0.3f);
    float rise = smoothstepf(lerpf(0.0f, 0.045f, a->sandy) * p->radius, foot, d);
    float z = shore_profile(p, a, d) * (1.0f - 0.8f * rise) + mountains(p, a) * (0.25f * rise + 0.75f * rise * rise);
    *drained = smoothstepf(4.0f, 30.0f + 0.05f * p->peak, z);
    return z;
}

// ---- sea bed
// ---------------------------------------------------------------------------------------------------------

// Round features, one on every @cell metres: returns the distance of the nearest over its radius (> 1: outside) and its
// random number.
static float scatter(float x, float y, float cell, float smallest, float largest, float share, uint32_t seed,
                     float *random) {
    float fx, fy, best = 2.0f;
    int32_t ix = split_cell(x / cell, &fx), iy = split_cell(y / cell, &fy);
    for (int32_t c = 0; c < 9; c++) {
        int32_t i = c % 3 - 1, j = c / 3 - 1;
        uint32_t h = hash_cell(ix + i, iy + j, seed);
        if ((float)(h & 0xffu) * (1.0f / 256.0f) >= share) {
            continue;
        }
        float px = (float)i + (float)(h >> 8 & 0xffu) * (1.0f / 256.0f),
              py = (float)j + (float)(h >> 16 & 0xffu) * (1.0f / 256.0f);
        float r = lerpf(smallest, largest, (float)(h >> 24) * (1.0f / 256.0f));
        float d = hypot2(px - fx, py - fy) * cell / r;
        if (d < best) {
            best = d;
            *random = (float)(h >> 24) * (1.0f / 256.0f);
        }
    }
    return best;
}

static float drop_off(const island_plan *p, const place *a) {
    float out = -a->reef * p->radius;
    if (out < 0.0f) {
        return -out * 0.5f;
    }
    float spur_and_groove = 1.0f + 0.5f * fractal_noise(a->x / 45.0, a->y / 45.0, 2, p->seed + 12);
    float terrace = 14.0f * clamp01(out / 90.0f) * spur_and_groove;
    float x = 1.0f - clamp01((out - 40.0f) / (1.35f * p->radius));
    return -1.2f - terrace + p->sea_floor * (1.0f - x * x * x);
}

// Sand islets and the living reef along the rim; passes cut through it.
static float reef_top(const island_plan *p, const place *a, float bed) {
    float inside = a->reef * p->radius; // [m]
    float rim = smoothstepf(-8.0f, 10.0f, inside) * (1.0f - smoothstepf(50.0f, 130.0f, inside)) * a->lee;
    float coral = fractal_noise(a->x / 23.0, a->y / 23.0, 3, p->seed + 13);
    float z = lerpf(bed, -0.75f + 0.55f * coral, rim * smoothstepf(0.05f, 0.10f, -a->coast));
    for (uint32_t n = 0; n < ISLAND_MOTUS; n++) {
        float du = a->u - p->motu[n].u, dv = a->v - p->motu[n].v;
        float s = (du * p->motu[n].along_u + dv * p->motu[n].along_v) / p->motu[n].length;
        float t = (dv * p->motu[n].along_u - du * p->motu[n].along_v) / p->motu[n].width + 0.9f * s * s;
        float islet = 1.0f - hypot2(s, t);
        z = smooth_max(z, fminf(islet * p->motu[n].width * p->radius / 11.0f, 4.6f), 0.6f);
    }
    float bend = fractal_noise(a->x / (0.12 * p->radius), a->y / (0.12 * p->radius), 2, p->seed + 20);
    for (uint32_t n = 0; n < ISLAND_PASSES; n++) {
        float ru = a->u - 0.28f, along = ru * p->pass[n].u + a->v * p->pass[n].v;
        float across = a->v * p->pass[n].u - ru * p->pass[n].v + 0.035f * bend;
        float cut = smoothstepf(0.055f, 0.015f, fabsf(across)) * smoothstepf(0.55f, 0.93f, along);
        z = lerpf(z, fminf(z, -10.0f), cut);
    }
    return z;
}

static float lagoon(const island_plan *p, const place *a, float out) {
    float wide = fractal_noise(a->x / (0.23 * p->radius), a->y / (0.23 * p->radius), 2, p->seed + 14);
    float bars = fractal_noise(a->x / 170.0 + 0.5 * wide, a->y / 170.0, 3, p->seed + 15);
    float bar = 1.0f - fabsf(bars) * 2.4f;
    float depth = 4.4f + 4.2f * wide - 2.0f * clamp01(bar) + 0.5f * bars;
    depth = fmaxf(depth, 1.0f + 0.2f * bars);
    float z = lerpf(smooth_max(-out / 15.0f, -1.6f, 0.7f), -depth, smoothstepf(30.0f, 260.0f, out));
    // Coral heads in gardens.
    float random = 0.0f, garden = smoothstepf(0.05f, 0.35f, fractal_noise(a->x / 210.0, a->y / 210.0, 2, p->seed + 16));
    float head = scatter(a->x, a->y, 42.0f, 7.0f, 21.0f, 0.6f, p->seed + 17, &random);
    float top = -0.6f - 1.4f * random;
    float dome = 1.0f - smoothstepf(0.45f, 1.0f, head + 0.15f * bars);
    return lerpf(z, fmaxf(z, top), dome * garden * smoothstepf(60.0f, 110.0f, out));
}

// Rock stacks before the cliffs.
static float stacks(const island_plan *p, const place *a, float out, float z) {
    float band = smoothstepf(14.0f, 30.0f, out) * (1.0f - smoothstepf(90.0f, 150.0f, out)) * (1.0f - a->sandy);
    if (band <= 0.0f) {
        return z;
    }
    float random = 0.0f, d = scatter(a->x, a->y, 120.0f, 14.0f, 38.0f, 0.22f, p->seed + 18, &random);
    d += 0.25f * fractal_noise(a->x / 16.0, a->y / 16.0, 2, p->seed + 19);
    return lerpf(z, fmaxf(z, 4.0f + 20.0f * random), (1.0f - smoothstepf(0.35f, 1.0f, d)) * band);
}

static float sea_bed(const island_plan *p, const place *a) {
    float out = -a->coast * p->radius;
    float boulders = fractal_noise(a->x / 30.0, a->y / 30.0, 3, p->seed + 10);
    float rocky = -0.32f * out - 2.2f * boulders * smoothstepf(2.0f, 20.0f, out);
    rocky = smooth_max(rocky, -11.0f - 0.07f * out, 4.0f);
    float z =
        lerpf(rocky, lagoon(p, a, out), smoothstepf(0.0f, 1.0f, a->sandy + a->lee * smoothstepf(40.0f, 160.0f, out)));
    z = stacks(p, a, out, z);
    z = reef_top(p, a, z);
    return smooth_min(z, drop_off(p, a), 3.0f);
}

float bolan_island_shape(const island_plan *p, double x, double y, float *drained) {
    *drained = 0.0f;
    place a = locate(p, x, y);
    if (a.reef < -0.25f) {
        return drop_off(p, &a);
    }
    return a.coast > 0.0f ? land(p, &a, drained) : sea_bed(p, &a);
}
