// SPDX-License-Identifier: MIT
// A wooden rowing boat, 4.4 m long, bow to +y, its origin in the waterline amidships. The hull is lofted through
// sections whose half-beam, keel and sheer follow simple curves; the inside is the same surface, a plank's thickness
// within.
#include "content/model_build.h"

#define STATIONS 11 // along the hull
#define RIBS 5      // points from keel to gunwale
#define HALF_BOAT 2.2f
#define PLANK 0.035f

// A point of the hull: t from stern (0) to bow (1), u from keel (0) to gunwale (1), on the +x side.
static bolan_vec3 hull_point(float t, float u, float thickness) {
    const float bow = t > 0.42f ? (t - 0.42f) / 0.58f : 0.0f, stern = t < 0.42f ? (0.42f - t) / 0.42f : 0.0f;
    const float beam = 0.74f * (1.0f - bow * bow * (0.55f + 0.45f * bow)) * (1.0f - 0.36f * stern * stern);
    const float keel = -0.15f + 0.30f * bow * bow * bow * bow + 0.05f * stern * stern;
    const float sheer = 0.36f + 0.24f * bow * bow + 0.07f * stern * stern;
    const float round = u * (2.0f - u), width = beam * (0.55f * round + 0.45f * sqrtf(u));
    const float lift = u * u * (1.35f - 0.35f * u);
    const float rake = 0.16f * bow * bow * u;
    const float half = width > thickness ? width - thickness : 0.0f; // fmaxf(-0.0f, 0.0f) may be either zero
    return bolan_v3(half, HALF_BOAT * (2.0f * t - 1.0f) + rake - thickness * bow,
                    keel + (sheer - keel) * lift + (u < 0.5f ? thickness : 0.0f));
}

// The floor inside lies above the waterline, because the surface of the water passes through the boat.
#define FLOOR 0.07f
static bolan_vec3 shell_point(float t, float u, bool inside) {
    bolan_vec3 p = hull_point(t, u, inside ? PLANK : 0.0f);
    if (inside) p.z = fmaxf(p.z, FLOOR);
    return p;
}

static bolan_vec3 mirrored(bolan_vec3 p, float side) { return bolan_v3(side * p.x, p.y, p.z); }

static bolan_vec3 strake_color(int k, bool inside, uint32_t *chance) {
    const bolan_vec3 varnish = {0.235f, 0.125f, 0.055f}, paint = {0.030f, 0.095f, 0.105f},
                     white = {0.56f, 0.55f, 0.50f}, bottom = {0.20f, 0.050f, 0.035f};
    if (inside) return bolan_build_vary(chance, varnish, 0.14f);
    return k == RIBS - 2 ? white : k == 0 ? bottom : bolan_build_vary(chance, paint, 0.06f);
}

static void shell(model_builder *b, float side, bool inside, uint32_t *chance) {
    for (int k = 0; k + 1 < RIBS; k++) {
        const bolan_vec3 color = strake_color(k, inside, chance);
        for (int i = 0; i + 1 < STATIONS; i++) {
            const float t0 = (float)i / (STATIONS - 1), t1 = (float)(i + 1) / (STATIONS - 1);
            const float u0 = (float)k / (RIBS - 1), u1 = (float)(k + 1) / (RIBS - 1);
            bolan_vec3 c[4] = {mirrored(shell_point(t0, u0, inside), side), mirrored(shell_point(t1, u0, inside), side),
                               mirrored(shell_point(t1, u1, inside), side),
                               mirrored(shell_point(t0, u1, inside), side)};
            if ((side > 0.0f) == inside) { // reversed winding
                const bolan_vec3 swap = c[1];
                c[1] = c[0], c[0] = swap;
                const bolan_vec3 other = c[3];
                c[3] = c[2], c[2] = other;
            }
            const float low = inside ? 0.28f + 0.45f * u0 : 0.6f, high = inside ? 0.28f + 0.45f * u1 : 0.75f;
            bolan_build_quad(b, c, color, low, high);
        }
    }
}

static void gunwale(model_builder *b, float side) {
    const bolan_vec3 oak = {0.27f, 0.165f, 0.085f};
    for (int i = 0; i + 1 < STATIONS; i++) {
        const float t0 = (float)i / (STATIONS - 1), t1 = (float)(i + 1) / (STATIONS - 1);
        const bolan_vec3 a = hull_point(t0, 1.0f, -0.03f), d = hull_point(t1, 1.0f, -0.03f),
                         e = hull_point(t1, 1.0f, PLANK), g = hull_point(t0, 1.0f, PLANK);
        bolan_vec3 c[4] = {mirrored(a, side), mirrored(d, side), mirrored(e, side), mirrored(g, side)};
        if (side < 0.0f)
            c[0] = mirrored(d, side), c[1] = mirrored(a, side), c[2] = mirrored(g, side), c[3] = mirrored(e, side);
        for (int k = 0; k < 4; k++) c[k].z += 0.03f;
        bolan_build_quad(b, c, oak, 1.0f, 1.0f);
    }
}

static void transom(model_builder *b) {
    const bolan_vec3 varnish = {0.25f, 0.135f, 0.060f};
    for (int k = 0; k + 1 < RIBS; k++) {
        const bolan_vec3 low = hull_point(0.0f, (float)k / (RIBS - 1), 0.0f),
                         high = hull_point(0.0f, (float)(k + 1) / (RIBS - 1), 0.0f);
        const bolan_vec3 c[4] = {mirrored(low, -1.0f), low, high, mirrored(high, -1.0f)};
        bolan_build_quad(b, c, varnish, 0.6f, 0.9f);
    }
}

static void thwart(model_builder *b, float t) {
    const bolan_vec3 at = hull_point(t, 0.80f, PLANK);
    bolan_build_box(b, bolan_v3(-at.x, at.y - 0.13f, 0.19f), bolan_v3(at.x, at.y + 0.13f, 0.225f),
                    bolan_v3(0.29f, 0.175f, 0.090f), false);
}

// Shipped: the blade lies over the stern.
static void oar(model_builder *b, float side) {
    const bolan_vec3 ash = {0.36f, 0.255f, 0.145f};
    const bolan_vec3 from = {0.20f * side, 1.25f, 0.27f}, to = {0.40f * side, -1.45f, 0.34f};
    bolan_build_tube(b, &(build_bar){from, to, 0.022f, 0.019f, ash, ash, 0.9f, 6, false});
    const bolan_vec3 c[4] = {{to.x - 0.02f, to.y, to.z},
                             {to.x + 0.01f * side + 0.05f, to.y - 0.75f, to.z + 0.03f},
                             {to.x + 0.01f * side - 0.09f, to.y - 0.75f, to.z + 0.03f},
                             {to.x - 0.05f, to.y, to.z}};
    bolan_build_quad(b, c, ash, 0.9f, 0.9f);
}

void bolan_model_boat(model_builder *b) {
    uint32_t chance = 51;
    for (int side = -1; side <= 1; side += 2) {
        shell(b, (float)side, false, &chance);
        shell(b, (float)side, true, &chance);
        gunwale(b, (float)side);
        oar(b, (float)side);
    }
    transom(b);
    thwart(b, 0.12f);
    thwart(b, 0.45f);
    thwart(b, 0.74f);
    const bolan_vec3 floor = {0.15f, 0.090f, 0.045f};
    bolan_build_box(b, bolan_v3(-0.33f, -1.7f, FLOOR), bolan_v3(0.33f, 1.0f, FLOOR + 0.025f), floor, true);
}
