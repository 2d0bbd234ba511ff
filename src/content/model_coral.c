// SPDX-License-Identifier: MIT
// Corals of a reef: heads of massive colonies, grooved like brains, with table corals over them, and a thicket of
// staghorn. Growing tips are pale.
#include "content/model_build.h"

#include <math.h>

static const bolan_vec3 ochre = {0.44f, 0.26f, 0.07f}, mauve = {0.40f, 0.15f, 0.34f}, rose = {0.62f, 0.20f, 0.18f},
                        pale = {0.60f, 0.53f, 0.43f}, cream = {0.56f, 0.45f, 0.22f}, shade = {0.06f, 0.045f, 0.035f};

// ---- massive colonies -----------------------------------------------------------------------------------------------

#define GROOVE 0.13f       // from ridge to ridge, about [m]
#define GROOVE_DEPTH 0.022f // [m]
#define LUMP 0.11f         // by which a colony's radius varies
#define LOWEST -0.35f      // z of the lowest ring of a dome, of a sphere of radius 1

typedef struct dome {
    bolan_vec3 at, color, seed;
    float radius;
} dome;

// The gyroid sin x cos y + sin y cos z + sin z cos x, -1.5..1.5: its zeros wind as the valleys of a brain coral do.
static float gyroid(bolan_vec3 p) {
    double sx, cx, sy, cy, sz, cz;
    bolan_sincos((double)p.x, &sx, &cx);
    bolan_sincos((double)p.y, &sy, &cy);
    bolan_sincos((double)p.z, &sz, &cz);
    return (float)(sx * cy + sy * cz + sz * cx);
}

// 0 in the grooves of the colony, 1 on its ridges.
static float ridge(const dome *d, bolan_vec3 dir) {
    const bolan_vec3 p = bolan_v3_scale(dir, 2.0f * d->radius / GROOVE); // the valleys are half a period apart
    const float h = fabsf(gyroid(bolan_v3_add(p, d->seed)));
    return h < 0.7f ? h / 0.7f : 1.0f;
}

static bolan_vec3 on_dome(const dome *d, bolan_vec3 dir) {
    const float lumps = gyroid(bolan_v3_add(bolan_v3_scale(dir, 3.2f), d->seed)) / 1.5f;
    const float r = d->radius * (1.0f + LUMP * lumps) + GROOVE_DEPTH * (ridge(d, dir) - 1.0f);
    return bolan_v3_add(d->at, bolan_v3(r * dir.x, 0.94f * r * dir.y, 0.8f * r * dir.z));
}

static void dome_vertex(model_builder *b, const dome *d, bolan_vec3 dir) {
    const float step = 0.15f * GROOVE / d->radius;
    const bolan_vec3 other = fabsf(dir.z) < 0.8f ? bolan_v3(0.0f, 0.0f, 1.0f) : bolan_v3(1.0f, 0.0f, 0.0f);
    const bolan_vec3 u = bolan_v3_normalize(bolan_v3_cross(other, dir)), v = bolan_v3_cross(dir, u);
    const bolan_vec3 p = on_dome(d, dir);
    const bolan_vec3 along =
        bolan_v3_sub(on_dome(d, bolan_v3_normalize(bolan_v3_add(dir, bolan_v3_scale(u, step)))), p);
    const bolan_vec3 up = bolan_v3_sub(on_dome(d, bolan_v3_normalize(bolan_v3_add(dir, bolan_v3_scale(v, step)))), p);
    const float high = ridge(d, dir), sky = 0.35f + 0.65f * fmaxf(dir.z, 0.0f);
    const bolan_vec3 color = build_mix(build_mix(shade, d->color, 0.55f), build_mix(d->color, pale, 0.25f), high);
    bolan_build_vertex(b, p, bolan_v3_normalize(bolan_v3_cross(along, up)), color, sky * (0.55f + 0.45f * high));
}

// The top, and rings below it of vertices two fifths of a groove apart, at most 160 a ring.
static void add_dome(model_builder *b, const dome *d) {
    const float wanted = 6.2832f * d->radius / (0.4f * GROOVE);
    const uint32_t around = wanted < 160.0f ? (uint32_t)wanted : 160, rings = around / 3;
    const uint32_t top = b->vertex_count, first = top + 1;
    dome_vertex(b, d, bolan_v3(0.0f, 0.0f, 1.0f));
    for (uint32_t i = 1; i <= rings; i++) {
        const float t = (float)i / (float)rings, z = 1.0f - (1.0f - LOWEST) * t * t; // even steps of the angle
        const float level = sqrtf(1.0f - z * z);
        for (uint32_t j = 0; j < around; j++) {
            double s, c;
            bolan_sincos(2.0 * BOLAN_PI * (j + 0.5 * (i & 1)) / around, &s, &c);
            dome_vertex(b, d, bolan_v3(level * (float)c, level * (float)s, z));
        }
    }
    for (uint32_t j = 0; j < around; j++) bolan_build_triangle(b, top, first + j, first + (j + 1) % around);
    for (uint32_t i = 0; i + 1 < rings; i++)
        for (uint32_t j = 0; j < around; j++) {
            const uint32_t next = (j + 1) % around, upper = first + i * around, lower = upper + around;
            bolan_build_triangle(b, upper + j, lower + j, lower + next);
            bolan_build_triangle(b, upper + j, lower + next, upper + next);
        }
}

static void massive(model_builder *b, uint32_t *chance, bolan_vec3 at, float radius, bolan_vec3 color) {
    dome d = {.at = at, .color = color, .radius = radius};
    d.seed.x = bolan_build_between(chance, 0.0f, 100.0f);
    d.seed.y = bolan_build_between(chance, 0.0f, 100.0f);
    d.seed.z = bolan_build_between(chance, 0.0f, 100.0f);
    add_dome(b, &d);
}

// ---- branching colonies ---------------------------------------------------------------------------------------------

// A branch that forks until it is thin.
static void branch(model_builder *b, uint32_t *chance, bolan_vec3 from, bolan_vec3 along, float radius, int forks,
                   bolan_vec3 color) {
    const float length = bolan_build_between(chance, 6.5f, 9.5f) * radius;
    const bolan_vec3 to = bolan_v3_add(from, bolan_v3_scale(along, length));
    const bolan_vec3 end = forks == 0 ? pale : build_mix(color, pale, 0.12f);
    bolan_build_tube(b, &(build_bar){from, to, radius, (forks == 0 ? 0.45f : 0.8f) * radius, color, end,
                                     forks >= 2 ? 0.45f : 0.9f, 5, false});
    for (int i = 0; forks > 0 && i < 3; i++) {
        const bolan_vec3 turn = bolan_v3_scale(bolan_build_direction(chance), 0.75f);
        bolan_vec3 next = bolan_v3_add(along, turn);
        next.z += 0.25f;
        branch(b, chance, to, bolan_v3_normalize(next), 0.8f * radius, forks - 1, end);
    }
}

enum { RIM = 36 };

// Radius of a table towards corner i of its rim, of 1: lobes where it grew faster.
static float rim_radius(uint32_t i, float seed) {
    double s, c;
    bolan_sincos(2.0 * BOLAN_PI * i / RIM, &s, &c);
    return 0.86f + 0.14f * gyroid(bolan_v3(2.3f * (float)c + seed, 2.3f * (float)s - seed, 0.7f * seed));
}

// The rough plate: a cone below, nearly level above, thin at the rim.
static void plate(model_builder *b, bolan_vec3 at, float radius, float seed, bolan_vec3 color) {
    const bolan_vec3 dark = build_mix(shade, color, 0.5f), rim = build_mix(color, pale, 0.45f);
    const uint32_t under =
        bolan_build_vertex(b, bolan_v3(at.x, at.y, at.z - 0.22f * radius), bolan_v3(0, 0, -1), dark, 0.3f);
    const uint32_t over = bolan_build_vertex(b, at, bolan_v3(0, 0, 1), color, 0.8f);
    for (uint32_t i = 0; i < RIM; i++) {
        double s, c;
        const float r = radius * rim_radius(i, seed);
        bolan_sincos(2.0 * BOLAN_PI * i / RIM, &s, &c);
        const bolan_vec3 p = {at.x + r * (float)c, at.y + r * (float)s, at.z + 0.06f * r};
        const bolan_vec3 out = {0.3f * (float)c, 0.3f * (float)s, -0.9539392f}; // of length 1
        bolan_build_vertex(b, p, out, dark, 0.5f);
        bolan_build_vertex(b, bolan_v3(p.x, p.y, p.z + 0.025f), bolan_v3(0.0f, 0.0f, 1.0f), rim, 1.0f);
    }
    const uint32_t first = over + 1;
    for (uint32_t i = 0; i < RIM; i++) {
        const uint32_t a = first + 2 * i, c = first + 2 * ((i + 1) % RIM);
        bolan_build_triangle(b, under, c, a);
        bolan_build_triangle(b, over, a + 1, c + 1);
        bolan_build_triangle(b, a, c, c + 1);
        bolan_build_triangle(b, a, c + 1, a + 1);
    }
}

// A plate on a stem, covered by short twigs.
static void table(model_builder *b, uint32_t *chance, bolan_vec3 at, float radius, bolan_vec3 color) {
    const bolan_vec3 foot = {at.x - 0.15f * radius, at.y, at.z - 1.1f * radius};
    const bolan_vec3 under = {at.x, at.y, at.z - 0.16f * radius};
    const float seed = bolan_build_between(chance, 0.0f, 50.0f);
    bolan_build_tube(b, &(build_bar){foot, under, 0.16f * radius, 0.1f * radius, build_mix(shade, color, 0.6f), color,
                                     0.5f, 7, false});
    plate(b, at, radius, seed, color);
    for (int i = 0; i < 90; i++) {
        double s, c;
        const float angle = bolan_build_random(chance), share = sqrtf(bolan_build_random(chance));
        bolan_sincos(2.0 * BOLAN_PI * (double)angle, &s, &c);
        const float r = 0.97f * share * radius * rim_radius((uint32_t)(angle * RIM), seed);
        const float size = radius * bolan_build_between(chance, 0.05f, 0.1f);
        const bolan_vec3 from = {at.x + r * (float)c, at.y + r * (float)s, at.z + 0.06f * r * share};
        const bolan_vec3 to = {from.x + 0.5f * size * (float)c, from.y + 0.5f * size * (float)s, from.z + size};
        bolan_build_tube(b, &(build_bar){from, to, 0.03f * radius, 0.015f * radius, build_mix(shade, color, 0.7f),
                                         build_mix(color, pale, 0.5f), 0.8f, 3, true});
    }
}

// ---- models ---------------------------------------------------------------------------------------------------------

void bolan_model_coral(model_builder *b) {
    uint32_t chance = 71;
    massive(b, &chance, bolan_v3(0.0f, 0.0f, 0.34f), 0.8f, ochre);
    massive(b, &chance, bolan_v3(0.85f, 0.3f, 0.22f), 0.52f, mauve);
    massive(b, &chance, bolan_v3(-0.75f, -0.55f, 0.2f), 0.45f, cream);
    massive(b, &chance, bolan_v3(-0.8f, 0.55f, 0.15f), 0.4f, rose);
    massive(b, &chance, bolan_v3(0.35f, -1.0f, 0.08f), 0.24f, rose);
    massive(b, &chance, bolan_v3(-0.25f, -1.05f, 0.05f), 0.17f, ochre);
    massive(b, &chance, bolan_v3(1.3f, -0.2f, 0.06f), 0.2f, cream);
    table(b, &chance, bolan_v3(0.55f, -0.65f, 0.75f), 0.62f, ochre);
    table(b, &chance, bolan_v3(-0.3f, 0.5f, 1.2f), 0.7f, mauve);
    for (int i = 0; i < 5; i++) {
        const bolan_vec3 foot = {bolan_build_between(&chance, -0.4f, 0.4f), -0.3f, 0.78f};
        branch(b, &chance, foot, bolan_v3_normalize(bolan_v3(foot.x, -0.3f, 0.9f)), 0.026f, 3, rose);
    }
}

void bolan_model_staghorn(model_builder *b) {
    uint32_t chance = 83;
    for (int i = 0; i < 16; i++) {
        const float x = bolan_build_between(&chance, -0.8f, 0.8f);
        const float y = bolan_build_between(&chance, -0.8f, 0.8f);
        const bolan_vec3 up = bolan_v3_normalize(bolan_v3(0.5f * x, 0.5f * y, 0.9f));
        branch(b, &chance, bolan_v3(x, y, -0.1f), up, bolan_build_between(&chance, 0.034f, 0.046f), 3,
               i % 3 == 0   ? cream
               : i % 3 == 1 ? ochre
                            : mauve);
    }
}
