// SPDX-License-Identifier: MIT
// The ground of the pond, as rings that follow its outline, and the wood on the rise behind it.
#include "bolan/content.h"
#include "content/model_build.h"

#include "content/pond.h"
#include "ground/noise.h"

#define COLUMNS 64u // round the pond; closer together in the south, where the camera looks from

// Rings [m] from the shore, inward ones negative. A ring that would come nearer to the middle than its share of the
// outline stays there.
static const float rings[] = {-24.0f, -20.5f, -17.5f, -15.0f, -12.6f,  -10.4f,  -8.3f,  -6.4f,  -4.7f,
                              -3.2f,  -1.9f,  -0.9f,  0.0f,   0.8f,    1.8f,    3.2f,   5.2f,   8.0f,
                              12.0f,  17.0f,  24.0f,  33.0f,  45.0f,   60.0f,   80.0f,  108.0f, 145.0f,
                              195.0f, 260.0f, 420.0f, 750.0f, 1400.0f, 2800.0f, 6000.0f};
#define RINGS (sizeof rings / sizeof *rings)

static void column_direction(uint32_t i, float *c, float *s) {
    // theta = u - 0.5 sin(u - south): equal steps of u crowd together at `south`.
    const double u = 2.0 * BOLAN_PI * i / COLUMNS, south = -0.5 * BOLAN_PI;
    double bend, unused, sine, cosine;
    bolan_sincos(u - south, &bend, &unused);
    bolan_sincos(u - 0.55 * bend, &sine, &cosine);
    *c = (float)cosine;
    *s = (float)sine;
}

static bolan_vec3 ground_normal(double x, double y, double step) {
    const float ex = bolan_pond_elevation(x + step, y) - bolan_pond_elevation(x - step, y);
    const float ey = bolan_pond_elevation(x, y + step) - bolan_pond_elevation(x, y - step);
    return bolan_v3_normalize(bolan_v3(-ex, -ey, (float)(2.0 * step)));
}

static bolan_vec3 meadow(double x, double y, float z) {
    const bolan_vec3 lush = {0.050f, 0.082f, 0.021f}, dry = {0.135f, 0.125f, 0.050f}, dark = {0.033f, 0.056f, 0.016f};
    const float wide = fractal_noise(x / 38.0, y / 38.0, 3, 71), fine = fractal_noise(x / 6.0, y / 6.0, 2, 72);
    bolan_vec3 c = build_mix(lush, dry, clamp01(0.22f + 0.9f * wide + 0.35f * fine));
    return build_mix(c, dark, smoothstepf(0.15f, 0.6f, -wide - 0.3f * fine) * 0.7f + 0.004f * clamp01(z));
}

// Fields, hedges and woods of the country around.
static bolan_vec3 country(double x, double y) {
    const bolan_vec3 wood = {0.022f, 0.036f, 0.014f}, field = {0.090f, 0.100f, 0.036f},
                     reaped = {0.19f, 0.155f, 0.075f};
    const float patch = fractal_noise(x / 260.0, y / 260.0, 2, 81), kind = fractal_noise(x / 420.0, y / 420.0, 2, 82);
    const bolan_vec3 open = build_mix(field, reaped, smoothstepf(0.05f, 0.35f, kind));
    return build_mix(open, wood, smoothstepf(-0.12f, 0.12f, patch));
}

static bolan_vec3 bed(double x, double y, float depth, float south) {
    const bolan_vec3 sand = {0.40f, 0.335f, 0.225f}, mud = {0.115f, 0.095f, 0.060f}, weed = {0.042f, 0.058f, 0.022f};
    const float patch = fractal_noise(x / 5.0, y / 5.0, 3, 91);
    const float sandy = south * (1.0f - smoothstepf(1.3f, 2.6f, depth + 0.6f * patch)) + 0.25f * (1.0f - south);
    bolan_vec3 c = build_mix(mud, sand, clamp01(sandy));
    c = build_mix(c, weed,
                  smoothstepf(0.05f, 0.35f, patch) * lerpf(0.75f, 0.6f, south) * smoothstepf(0.3f, 1.0f, depth));
    return bolan_v3_scale(c, 1.0f + 0.4f * patch);
}

static bolan_vec3 ground_color(double x, double y, float z, float d) {
    const float r = sqrtf((float)(x * x + y * y)), south = smoothstepf(0.25f, 0.8f, -(float)y / fmaxf(r, 1.0f));
    if (z < -0.05f) return bed(x, y, -z, south);
    const bolan_vec3 sand = {0.44f, 0.37f, 0.25f}, earth = {0.15f, 0.115f, 0.072f}, forest = {0.040f, 0.046f, 0.018f};
    bolan_vec3 c = meadow(x, y, z);
    const float ragged = 1.6f * fractal_noise(x / 3.0, y / 3.0, 2, 95);
    const bolan_vec3 bank = build_mix(earth, sand, south);
    c = build_mix(bank, c, smoothstepf(lerpf(0.1f, 2.6f, south), lerpf(1.3f, 6.5f, south), d + ragged));
    c = bolan_v3_scale(c, lerpf(0.55f, 1.0f, smoothstepf(0.0f, 0.22f, z))); // wet
    const float north = smoothstepf(0.1f, 0.6f, (float)y / fmaxf(r, 1.0f));
    c = build_mix(c, forest,
                  north * smoothstepf(38.0f, 52.0f, d + 4.0f * ragged) * (1.0f - smoothstepf(200.0f, 300.0f, d)));
    return build_mix(c, country(x, y), smoothstepf(150.0f, 330.0f, d));
}

static void ground_vertex(model_builder *b, float c, float s, float ring) {
    const float outline = bolan_pond_outline(c, s),
                d = ring < 0.0f ? fmaxf(ring, outline * (0.12f + ring * 0.004f - 1.0f)) : ring;
    const double x = (double)(c * (outline + d)), y = (double)(s * (outline + d));
    const float z = bolan_pond_elevation(x, y), far = fmaxf(d, 0.0f);
    bolan_build_vertex(b, bolan_v3((float)x, (float)y, z), ground_normal(x, y, (double)(0.4f + 0.1f * far)),
                       ground_color(x, y, z, d), 1.0f);
}

void bolan_model_pond_ground(model_builder *b) {
    for (size_t k = 0; k < RINGS; k++)
        for (uint32_t i = 0; i < COLUMNS; i++) {
            float c, s;
            column_direction(i, &c, &s);
            ground_vertex(b, c, s, rings[k]);
        }
    const float z = bolan_pond_elevation(0.0, 0.0);
    const uint32_t middle =
        bolan_build_vertex(b, bolan_v3(0.0f, 0.0f, z), bolan_v3(0.0f, 0.0f, 1.0f), bed(0.0, 0.0, -z, 0.0f), 1.0f);
    for (uint32_t i = 0; i < COLUMNS; i++) {
        const uint32_t next = (i + 1) % COLUMNS;
        bolan_build_triangle(b, middle, i, next);
        for (uint32_t k = 0; k + 1 < RINGS; k++) {
            const uint32_t a = k * COLUMNS + i, e = k * COLUMNS + next;
            // The shorter diagonal, in turns.
            bolan_build_triangle(b, a, a + COLUMNS, e + COLUMNS);
            bolan_build_triangle(b, a, e + COLUMNS, e);
        }
    }
}

// ---- the wood -------------------------------------------------------------------------------------------------------

#define FAR_LEAVES 9 // of a lump

// A spruce seen from afar: three ragged skirts.
static void far_conifer(model_builder *b, uint32_t *chance, bolan_vec3 foot, float height) {
    static const float base[] = {0.08f, 0.32f, 0.58f}, top[] = {0.55f, 0.78f, 1.0f}, width[] = {0.205f, 0.160f, 0.105f};
    const bolan_vec3 tone = bolan_build_vary(chance, bolan_v3(0.021f, 0.037f, 0.019f), 0.30f);
    for (int k = 0; k < 3; k++) {
        const uint32_t first = b->vertex_count, sides = 10;
        const bolan_vec3 tip = bolan_v3(foot.x, foot.y, foot.z + top[k] * height);
        bolan_build_vertex(b, tip, bolan_v3(0.0f, 0.0f, 1.0f), tone, k == 2 ? 0.95f : 0.4f);
        for (uint32_t i = 0; i < sides; i++) {
            double s, c;
            bolan_sincos(2.0 * BOLAN_PI * (i + 0.3 * k) / sides, &s, &c);
            const bool out = i % 2 == 0;
            const float r = width[k] * height *
                            (out ? bolan_build_between(chance, 0.95f, 1.3f) : bolan_build_between(chance, 0.6f, 0.8f));
            const float x = r * (float)c, y = r * (float)s,
                        z = (base[k] + (out ? 0.0f : 0.07f) + bolan_build_between(chance, 0.0f, 0.04f)) * height;
            bolan_build_vertex(b, bolan_v3(foot.x + x, foot.y + y, foot.z + z),
                               bolan_v3_normalize(bolan_v3(x, y, 0.5f * r)), bolan_v3_scale(tone, out ? 1.35f : 0.7f),
                               (out ? 0.5f : 0.25f) + 0.2f * (float)k);
        }
        for (uint32_t i = 0; i < sides; i++) bolan_build_triangle(b, first, first + 1 + i, first + 1 + (i + 1) % sides);
    }
}

static void far_crown(model_builder *b, uint32_t *chance, bolan_vec3 foot, float height) {
    const bolan_vec3 tone = bolan_build_vary(chance, bolan_v3(0.042f, 0.068f, 0.020f), 0.25f);
    const bolan_vec3 warm = build_mix(tone, bolan_v3(0.078f, 0.082f, 0.024f), bolan_build_random(chance) * 0.4f);
    build_lump l = {.low_color = bolan_v3_scale(warm, 0.55f), .high_color = bolan_v3_scale(warm, 1.2f), .rough = 0.24f};
    l.core = bolan_v3(foot.x, foot.y, foot.z + 0.45f * height);
    for (int k = 0; k < 2; k++) {
        const float r = height * (k ? 0.25f : 0.34f);
        const float y = k ? bolan_build_between(chance, -0.5f, 0.5f) * r : 0.0f;
        const float x = k ? bolan_build_between(chance, -0.5f, 0.5f) * r : 0.0f;
        l.center = bolan_v3(foot.x + x, foot.y + y, foot.z + height * (k ? 0.70f : 0.33f));
        l.radius = bolan_v3(r, r, r * (k ? 0.95f : 1.15f));
        l.low_open = k ? 0.5f : 0.2f;
        l.high_open = k ? 1.0f : 0.75f;
        l.seed = (uint32_t)(bolan_build_random(chance) * 1e6f);
        bolan_build_blob(b, &l);
        for (int i = 0; i < FAR_LEAVES; i++) {
            bolan_vec3 dir = bolan_build_direction(chance);
            if (dir.z < -0.2f) dir.z = -dir.z;
            const bolan_vec3 at = bolan_v3_add(l.center, bolan_v3(dir.x * r, dir.y * r, dir.z * l.radius.z));
            const bolan_vec3 color = build_mix(l.low_color, l.high_color, 0.5f + 0.5f * dir.z);
            bolan_build_leaf(b, chance, at, dir, 0.08f * height, color, 0.4f + 0.5f * fmaxf(dir.z, 0.0f));
        }
    }
}

// Bushes round the foot of a tree.
static void undergrowth(model_builder *b, uint32_t *chance, bolan_vec3 foot, int count) {
    for (int i = 0; i < count; i++) {
        double s, c;
        bolan_sincos(2.0 * BOLAN_PI * (double)bolan_build_random(chance), &s, &c);
        const float r = bolan_build_between(chance, 0.8f, 3.4f), x = foot.x + r * (float)c, y = foot.y + r * (float)s;
        const float z = bolan_pond_elevation((double)x, (double)y) + bolan_build_between(chance, 0.0f, 0.9f);
        bolan_build_leaf(b, chance, bolan_v3(x, y, z), bolan_v3_normalize(bolan_v3((float)c, (float)s, 0.9f)),
                         bolan_build_between(chance, 0.7f, 1.4f), bolan_v3(0.036f, 0.058f, 0.019f), 0.45f);
    }
}

// Trees stand in rows along the foot of the rise, the front ones lower, so that the wood has a mantle.
#define WOOD_TREES 46
#define WOOD_BUSHES 143 // makes the scene `pond` 13 912 triangles, as the paper's
void bolan_model_pond_wood(model_builder *b) {
    uint32_t chance = 77;
    for (int i = 0; i < WOOD_TREES; i++) {
        double s, c;
        const int row = i % 3;
        const float along = ((float)i + bolan_build_between(&chance, -0.8f, 0.8f)) / WOOD_TREES;
        bolan_sincos(BOLAN_PI * (0.2 + 0.6 * (double)along), &s, &c);
        const float d = bolan_pond_outline((float)c, (float)s) + 45.0f + 10.0f * (float)row +
                        bolan_build_between(&chance, -4.0f, 4.0f);
        const double x = c * (double)d, y = s * (double)d;
        const bolan_vec3 foot = bolan_v3((float)x, (float)y, bolan_pond_elevation(x, y) - 0.3f);
        const float height = bolan_build_between(&chance, 10.0f, 15.0f) + 1.5f * (float)row;
        if (5 * i % 7 < 3)
            far_conifer(b, &chance, foot, height * 1.2f);
        else
            far_crown(b, &chance, foot, 1.1f * height);
        undergrowth(b, &chance, foot, WOOD_BUSHES * (i + 1) / WOOD_TREES - WOOD_BUSHES * i / WOOD_TREES);
    }
}
