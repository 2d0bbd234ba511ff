// SPDX-License-Identifier: MIT
// A broad-leaved tree, a spruce and a clump of reeds. Crowns are lumps that carry loose leaves: the lumps give body and
// a dark inside, the leaves break the outline. Their normals point out of the crown, so that it is shaded as a whole.
#include "content/model_build.h"

// Leaves on the surface of a lump, thicker above.
static void leaves(model_builder *b, uint32_t *chance, const build_lump *l, int count, float size) {
    for (int i = 0; i < count; i++) {
        bolan_vec3 dir = bolan_build_direction(chance);
        if (dir.z < -0.5f) dir.z = -dir.z;
        const bolan_vec3 at = bolan_v3_add(
            l->center, bolan_v3_scale(bolan_v3(dir.x * l->radius.x, dir.y * l->radius.y, dir.z * l->radius.z),
                                      bolan_build_between(chance, 0.95f, 1.22f)));
        const bolan_vec3 out = bolan_v3_normalize(bolan_v3_sub(at, build_mix(l->center, l->core, 0.5f)));
        const float t = 0.5f + 0.5f * dir.z;
        bolan_build_leaf(b, chance, at, out, size * bolan_build_between(chance, 0.7f, 1.3f),
                         build_mix(l->low_color, l->high_color, t), 0.25f + 0.75f * t * l->high_open);
    }
}

static const struct {
    float x, y, z, r;
} crown[] = {
    {0.0f, 0.0f, 7.6f, 1.9f},   {1.9f, 0.4f, 5.9f, 1.8f},   {-1.8f, 0.8f, 5.6f, 1.9f},
    {0.3f, -2.0f, 5.5f, 1.8f},  {0.2f, 1.9f, 5.8f, 1.7f},   {1.3f, -1.2f, 7.0f, 1.5f},
    {-1.2f, -0.9f, 6.9f, 1.6f}, {-2.5f, -0.9f, 4.5f, 1.3f}, {2.4f, -1.3f, 4.4f, 1.25f},
};

void bolan_model_tree(model_builder *b) {
    const bolan_vec3 bark = {0.085f, 0.066f, 0.048f}, dark = {0.050f, 0.040f, 0.030f};
    uint32_t chance = 5;
    bolan_build_tube(b,
                     &(build_bar){{0.0f, 0.0f, -0.4f}, {0.06f, 0.04f, 0.7f}, 0.40f, 0.24f, bark, bark, 0.7f, 7, true});
    bolan_build_tube(b,
                     &(build_bar){{0.06f, 0.04f, 0.7f}, {0.0f, 0.1f, 3.6f}, 0.24f, 0.18f, bark, dark, 0.55f, 7, false});
    bolan_build_tube(b, &(build_bar){{0.0f, 0.1f, 3.4f}, {0.1f, 0.0f, 6.8f}, 0.18f, 0.06f, dark, dark, 0.3f, 5, false});
    const int count = (int)(sizeof crown / sizeof *crown);
    for (int i = 1; i < count; i++) {
        const bolan_vec3 tip = {0.8f * crown[i].x, 0.8f * crown[i].y, crown[i].z - 0.3f};
        bolan_build_tube(
            b, &(build_bar){{0.03f, 0.08f, 2.4f + 0.16f * (float)i}, tip, 0.10f, 0.03f, dark, dark, 0.35f, 4, false});
    }
    for (int i = 0; i < count; i++) {
        const float r = crown[i].r, high = crown[i].z / 8.5f;
        const bolan_vec3 low = bolan_build_vary(&chance, bolan_v3(0.026f, 0.043f, 0.013f), 0.15f);
        const bolan_vec3 top = bolan_build_vary(&chance, bolan_v3(0.066f, 0.097f, 0.025f), 0.15f);
        build_lump l = {.center = {crown[i].x, crown[i].y, crown[i].z},
                        .radius = {r, r, 0.86f * r},
                        .core = {0.0f, 0.0f, 5.2f},
                        .low_color = low,
                        .high_color = top,
                        .low_open = 0.16f,
                        .high_open = 0.45f + 0.5f * high,
                        .rough = 0.17f,
                        .seed = 100u + (uint32_t)i,
                        .fine = i < 7};
        bolan_build_blob(b, &l);
        leaves(b, &chance, &l, i < 7 ? 34 : 26, 0.34f);
    }
}

// One whorl of branches: a skirt whose rim goes out to tips and back to notches.
static void whorl(model_builder *b, uint32_t *chance, float base, float top, float radius, float high) {
    const uint32_t first = b->vertex_count, tips = 8;
    const bolan_vec3 tone = bolan_build_vary(chance, bolan_v3(0.022f, 0.041f, 0.022f), 0.16f);
    bolan_build_vertex(b, bolan_v3(0.0f, 0.0f, top), bolan_v3(0.0f, 0.0f, 1.0f), bolan_v3_scale(tone, 0.7f),
                       0.35f + 0.6f * high);
    const float turn = bolan_build_random(chance);
    for (uint32_t i = 0; i < 2 * tips; i++) {
        double s, c;
        bolan_sincos(BOLAN_PI * ((double)i + 2.0 * (double)turn) / tips, &s, &c);
        const bool tip = i % 2 == 0;
        const float r =
            radius * (tip ? bolan_build_between(chance, 0.9f, 1.15f) : bolan_build_between(chance, 0.5f, 0.62f));
        const float z = base + (tip ? bolan_build_between(chance, -0.12f, 0.12f) : 0.30f * (top - base));
        const bolan_vec3 n = bolan_v3_normalize(bolan_v3((float)c, (float)s, tip ? 0.65f : 0.25f));
        bolan_build_vertex(b, bolan_v3(r * (float)c, r * (float)s, z), n, bolan_v3_scale(tone, tip ? 1.45f : 0.75f),
                           (tip ? 0.75f : 0.3f) * (0.55f + 0.45f * high));
    }
    for (uint32_t i = 0; i < 2 * tips; i++)
        bolan_build_triangle(b, first, first + 1 + i, first + 1 + (i + 1) % (2 * tips));
}

void bolan_model_conifer(model_builder *b) {
    const bolan_vec3 bark = {0.075f, 0.052f, 0.038f};
    uint32_t chance = 9;
    bolan_build_tube(b,
                     &(build_bar){{0.0f, 0.0f, -0.4f}, {0.0f, 0.0f, 11.2f}, 0.24f, 0.03f, bark, bark, 0.45f, 6, false});
    const int whorls = 13;
    for (int i = 0; i < whorls; i++) {
        const float t = (float)i / (float)(whorls - 1), radius = 2.35f * (1.0f - t) + 0.22f;
        const float base = 1.0f + 9.7f * t * (1.15f - 0.15f * t);
        whorl(b, &chance, base, base + 1.15f + 0.3f * (1.0f - t), radius, t);
        for (int k = 0; k < 9 - 4 * (int)(t + 0.5f); k++) {
            double s, c;
            bolan_sincos(2.0 * BOLAN_PI * (double)bolan_build_random(&chance), &s, &c);
            const float r = radius * bolan_build_between(&chance, 0.5f, 1.0f);
            bolan_build_leaf(b, &chance, bolan_v3(r * (float)c, r * (float)s, base + 0.45f * (1.0f - r / radius)),
                             bolan_v3_normalize(bolan_v3((float)c, (float)s, 0.6f)), 0.34f,
                             bolan_v3(0.030f, 0.054f, 0.026f), 0.6f + 0.3f * t);
        }
    }
}

// A blade that bends over: two parts, the upper one a tip.
static void blade(model_builder *b, uint32_t *chance, bolan_vec3 foot, float height, float width) {
    double s, c;
    bolan_sincos(2.0 * BOLAN_PI * (double)bolan_build_random(chance), &s, &c);
    const float lean = bolan_build_between(chance, 0.08f, 0.34f) * height;
    const bolan_vec3 to = {(float)c, (float)s, 0.0f}, side = {-(float)s * width, (float)c * width, 0.0f};
    const bolan_vec3 young = {0.085f, 0.115f, 0.035f}, old = {0.19f, 0.165f, 0.08f};
    const float first = bolan_build_random(chance), age = first * bolan_build_random(chance);
    const bolan_vec3 color = bolan_build_vary(chance, build_mix(young, old, age), 0.2f);
    const bolan_vec3 n = bolan_v3_normalize(bolan_v3(to.x * 0.5f, to.y * 0.5f, 0.8f));
    const bolan_vec3 half = bolan_v3_add(foot, bolan_v3(to.x * 0.3f * lean, to.y * 0.3f * lean, 0.6f * height));
    const bolan_vec3 tip = bolan_v3_add(foot, bolan_v3(to.x * lean, to.y * lean, height));
    const uint32_t i = bolan_build_vertex(b, bolan_v3_sub(foot, side), n, bolan_v3_scale(color, 0.55f), 0.35f);
    bolan_build_vertex(b, bolan_v3_add(foot, side), n, bolan_v3_scale(color, 0.55f), 0.35f);
    bolan_build_vertex(b, bolan_v3_add(half, bolan_v3_scale(side, 0.8f)), n, color, 0.75f);
    bolan_build_vertex(b, bolan_v3_sub(half, bolan_v3_scale(side, 0.8f)), n, color, 0.75f);
    bolan_build_vertex(b, tip, n, bolan_v3_scale(color, 1.2f), 1.0f);
    bolan_build_triangle(b, i, i + 1, i + 2);
    bolan_build_triangle(b, i, i + 2, i + 3);
    bolan_build_triangle(b, i + 3, i + 2, i + 4);
}

void bolan_model_reeds(model_builder *b) {
    uint32_t chance = 21;
    for (int i = 0; i < 34; i++) {
        const float x = bolan_build_between(&chance, -1.0f, 1.0f), y = bolan_build_between(&chance, -0.6f, 0.6f);
        const float width = bolan_build_between(&chance, 0.026f, 0.046f),
                    height = bolan_build_between(&chance, 1.3f, 2.5f);
        blade(b, &chance, bolan_v3(x * 1.2f, y, -0.5f), height, width);
    }
    for (int i = 0; i < 4; i++) { // cattails
        const float x = bolan_build_between(&chance, -0.9f, 0.9f), y = bolan_build_between(&chance, -0.4f, 0.4f),
                    h = bolan_build_between(&chance, 1.6f, 2.1f);
        const bolan_vec3 brown = {0.075f, 0.042f, 0.022f};
        bolan_build_tube(
            b, &(build_bar){{x, y, h - 0.28f}, {x + 0.02f, y, h}, 0.026f, 0.022f, brown, brown, 0.9f, 4, false});
    }
}
