// SPDX-License-Identifier: MIT
// Corals of a reef: heads of massive colonies with table corals over them, and a thicket of staghorn. Growing tips are
// pale.
#include "content/model_build.h"

static const bolan_vec3 ochre = {0.44f, 0.26f, 0.07f}, mauve = {0.40f, 0.15f, 0.34f}, rose = {0.62f, 0.20f, 0.18f},
                        pale = {0.60f, 0.53f, 0.43f}, cream = {0.56f, 0.45f, 0.22f}, shade = {0.06f, 0.045f, 0.035f};

// A colony that grows as a dome, with the lumps of its surface.
static void dome(model_builder *b, uint32_t *chance, bolan_vec3 at, float radius, bolan_vec3 color) {
    const build_lump whole = {.center = at,
                              .radius = {radius, 0.9f * radius, 0.8f * radius},
                              .core = {at.x, at.y, at.z - radius},
                              .low_color = build_mix(shade, color, 0.35f),
                              .high_color = color,
                              .low_open = 0.3f,
                              .high_open = 1.0f,
                              .rough = 0.06f,
                              .seed = (uint32_t)(1000.0f * bolan_build_random(chance)),
                              .fine = true};
    bolan_build_blob(b, &whole);
    for (int i = 0; i < 16; i++) {
        bolan_vec3 out = bolan_build_direction(chance);
        out.z = out.z < -0.2f ? -out.z : out.z;
        build_lump knob = whole;
        const float size = radius * bolan_build_between(chance, 0.2f, 0.34f);
        knob.center =
            bolan_v3_add(at, bolan_v3(0.93f * radius * out.x, 0.84f * radius * out.y, 0.75f * radius * out.z));
        knob.radius = bolan_v3(size, size, 0.8f * size);
        knob.core = at;
        knob.high_color = build_mix(bolan_build_vary(chance, color, 0.2f), pale, 0.12f + 0.2f * out.z);
        knob.low_open = 0.5f;
        knob.rough = 0.1f;
        knob.seed = (uint32_t)i;
        bolan_build_blob(b, &knob);
    }
}

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

// A level plate on a stem; its rim is pale.
static void table(model_builder *b, bolan_vec3 at, float radius, bolan_vec3 color) {
    const bolan_vec3 foot = {at.x - 0.15f * radius, at.y, at.z - 1.1f * radius};
    const bolan_vec3 under = {at.x, at.y, at.z - 0.16f * radius};
    bolan_build_tube(b, &(build_bar){foot, under, 0.16f * radius, 0.1f * radius, color, color, 0.6f, 7, false});
    bolan_build_tube(b, &(build_bar){under, at, 0.12f * radius, radius, build_mix(shade, color, 0.6f),
                                     build_mix(color, pale, 0.3f), 0.9f, 15, false});
}

void bolan_model_coral(model_builder *b) {
    uint32_t chance = 71;
    dome(b, &chance, bolan_v3(0.0f, 0.0f, 0.28f), 0.85f, ochre);
    dome(b, &chance, bolan_v3(0.95f, 0.3f, 0.1f), 0.55f, mauve);
    dome(b, &chance, bolan_v3(-0.75f, -0.6f, 0.05f), 0.5f, cream);
    dome(b, &chance, bolan_v3(-0.8f, 0.55f, 0.05f), 0.42f, rose);
    table(b, bolan_v3(0.55f, -0.65f, 0.75f), 0.62f, ochre);
    table(b, bolan_v3(-0.3f, 0.5f, 1.25f), 0.7f, mauve);
    for (int i = 0; i < 5; i++) {
        const bolan_vec3 foot = {bolan_build_between(&chance, -0.5f, 0.5f), -0.35f, 0.75f};
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
