// SPDX-License-Identifier: MIT
// Objects at a pond: a house, a jetty, a pole, a rock.
#include "content/model_build.h"

// ---- house ----------------------------------------------------------------------------------------------------------

// 10 m along x, 7 m along y; its door looks to -y. Walls 3 m, ridge 6.2 m.
#define HALF_LENGTH 5.0f
#define HALF_WIDTH 3.5f
#define EAVES 3.0f
#define RIDGE 6.2f
#define OVERHANG 0.55f

static bolan_vec3 turned(bolan_vec3 p, int side) {
    // Walls are described looking at the front; side 1 is the back, 2 and 3 the ends.
    if (side == 0) return p;
    if (side == 1) return bolan_v3(-p.x, -p.y, p.z);
    return side == 2 ? bolan_v3(-p.y, p.x, p.z) : bolan_v3(p.y, -p.x, p.z);
}

// A rectangle in the wall, `out` before it: x along the wall, z up.
static void panel(model_builder *b, int side, float depth, const float rect[4], float out, bolan_vec3 color, float low,
                  float high) {
    const float y = -depth - out;
    const bolan_vec3 corner[4] = {
        turned(bolan_v3(rect[0], y, rect[2]), side), turned(bolan_v3(rect[1], y, rect[2]), side),
        turned(bolan_v3(rect[1], y, rect[3]), side), turned(bolan_v3(rect[0], y, rect[3]), side)};
    bolan_build_quad(b, corner, color, low, high);
}

static void window(model_builder *b, int side, float depth, float x, float z, float width, float height) {
    const bolan_vec3 frame = {0.52f, 0.50f, 0.45f}, glass = {0.022f, 0.028f, 0.034f},
                     shutter = {0.060f, 0.115f, 0.105f};
    const float w = 0.5f * width;
    panel(b, side, depth, (float[]){x - w - 0.09f, x + w + 0.09f, z - 0.11f, z + height + 0.09f}, 0.02f, frame, 0.8f,
          0.6f);
    for (int k = 0; k < 2; k++) {
        const float from = x - w + (float)k * (w + 0.03f);
        panel(b, side, depth, (float[]){from, from + w - 0.03f, z, z + height}, 0.035f, glass, 0.8f, 0.5f);
        const float hinge = k ? x + w + 0.10f : x - w - 0.10f - 0.9f * w;
        panel(b, side, depth, (float[]){hinge, hinge + 0.9f * w, z - 0.08f, z + height + 0.06f}, 0.05f, shutter, 0.85f,
              0.6f);
    }
}

static void walls(model_builder *b) {
    const bolan_vec3 plaster = {0.50f, 0.455f, 0.365f}, stone = {0.20f, 0.185f, 0.165f};
    for (int side = 0; side < 4; side++) {
        const float half = side < 2 ? HALF_LENGTH : HALF_WIDTH, depth = side < 2 ? HALF_WIDTH : HALF_LENGTH;
        panel(b, side, depth, (float[]){-half - 0.06f, half + 0.06f, -1.5f, 0.55f}, 0.06f, stone, 0.5f, 0.85f);
        panel(b, side, depth, (float[]){-half, half, 0.5f, 2.1f}, 0.0f, plaster, 0.8f, 0.85f);
        panel(b, side, depth, (float[]){-half, half, 2.1f, EAVES}, 0.0f, plaster, 0.85f, side < 2 ? 0.35f : 0.8f);
        if (side < 2) continue;
        const bolan_vec3 wood = {0.17f, 0.115f, 0.070f};
        bolan_build_facet(b, turned(bolan_v3(-half, -depth, EAVES), side), turned(bolan_v3(half, -depth, EAVES), side),
                          turned(bolan_v3(0.0f, -depth, RIDGE), side), wood, 0.6f);
    }
}

// Rows of tiles, one strip of quads a row, each with its own tone.
static void roof(model_builder *b) {
    uint32_t chance = 31;
    const int rows = 6, columns = 8;
    const float run = HALF_WIDTH + OVERHANG, fall = RIDGE - EAVES, slope = fall / HALF_WIDTH, top = RIDGE + 0.12f;
    for (int side = 0; side < 2; side++)
        for (int r = 0; r < rows; r++)
            for (int c = 0; c < columns; c++) {
                // Each row runs up under the next.
                const float y0 = run * (float)(r + 1) / (float)rows,
                            y1 = fmaxf(run * (float)r / (float)rows - 0.2f, 0.0f);
                const float x0 = (HALF_LENGTH + OVERHANG) * (2.0f * (float)c / (float)columns - 1.0f),
                            x1 = (HALF_LENGTH + OVERHANG) * (2.0f * (float)(c + 1) / (float)columns - 1.0f);
                const bolan_vec3 corner[4] = {turned(bolan_v3(x0, -y0, top - slope * y0 + 0.05f), side),
                                              turned(bolan_v3(x1, -y0, top - slope * y0 + 0.05f), side),
                                              turned(bolan_v3(x1, -y1, top - slope * y1), side),
                                              turned(bolan_v3(x0, -y1, top - slope * y1), side)};
                bolan_build_quad(b, corner, bolan_build_vary(&chance, bolan_v3(0.205f, 0.088f, 0.055f), 0.16f), 1.0f,
                                 1.0f);
            }
    // Its underside and edge.
    const bolan_vec3 board = {0.13f, 0.095f, 0.065f};
    const float x = HALF_LENGTH + OVERHANG, low = top - slope * run;
    for (int side = 0; side < 2; side++) {
        const bolan_vec3 edge[4] = {
            turned(bolan_v3(-x, -run, low - 0.14f), side), turned(bolan_v3(x, -run, low - 0.14f), side),
            turned(bolan_v3(x, -run, low + 0.06f), side), turned(bolan_v3(-x, -run, low + 0.06f), side)};
        bolan_build_quad(b, edge, board, 0.7f, 0.9f);
        const bolan_vec3 gable[4] = {
            turned(bolan_v3(x, -run, low - 0.14f), side), turned(bolan_v3(x, 0.0f, top - 0.16f), side),
            turned(bolan_v3(x, 0.0f, top + 0.04f), side), turned(bolan_v3(x, -run, low + 0.06f), side)};
        bolan_build_quad(b, gable, board, 0.8f, 0.9f);
        const bolan_vec3 other[4] = {
            turned(bolan_v3(-x, 0.0f, top - 0.16f), side), turned(bolan_v3(-x, -run, low - 0.14f), side),
            turned(bolan_v3(-x, -run, low + 0.06f), side), turned(bolan_v3(-x, 0.0f, top + 0.04f), side)};
        bolan_build_quad(b, other, board, 0.8f, 0.9f);
    }
}

void bolan_model_house(model_builder *b) {
    const bolan_vec3 brick = {0.22f, 0.105f, 0.075f}, door = {0.085f, 0.050f, 0.030f}, frame = {0.52f, 0.50f, 0.45f},
                     step = {0.24f, 0.225f, 0.20f};
    walls(b);
    roof(b);
    panel(b, 0, HALF_WIDTH, (float[]){-0.62f, 0.62f, 0.5f, 2.68f}, 0.02f, frame, 0.8f, 0.5f);
    panel(b, 0, HALF_WIDTH, (float[]){-0.5f, 0.5f, 0.5f, 2.58f}, 0.04f, door, 0.8f, 0.5f);
    bolan_build_box(b, bolan_v3(-0.9f, -HALF_WIDTH - 1.1f, -0.8f), bolan_v3(0.9f, -HALF_WIDTH, 0.48f), step, true);
    window(b, 0, HALF_WIDTH, -2.9f, 1.15f, 1.2f, 1.25f);
    window(b, 0, HALF_WIDTH, 2.9f, 1.15f, 1.2f, 1.25f);
    window(b, 1, HALF_WIDTH, -2.5f, 1.15f, 1.1f, 1.2f);
    window(b, 1, HALF_WIDTH, 2.5f, 1.15f, 1.1f, 1.2f);
    for (int side = 2; side < 4; side++) {
        window(b, side, HALF_LENGTH, -1.6f, 1.15f, 1.0f, 1.2f);
        window(b, side, HALF_LENGTH, 1.6f, 1.15f, 1.0f, 1.2f);
        window(b, side, HALF_LENGTH, 0.0f, 3.55f, 0.8f, 0.9f);
    }
    bolan_build_box(b, bolan_v3(2.2f, 0.3f, 4.6f), bolan_v3(3.0f, 1.1f, 7.1f), brick, true);
    bolan_build_box(b, bolan_v3(2.12f, 0.22f, 7.1f), bolan_v3(3.08f, 1.18f, 7.25f), step, false);
}

// ---- jetty, pole, rock ----------------------------------------------------------------------------------------------

// From the origin on the shore 9 m along +y; planks 0.55 m above the water.
void bolan_model_jetty(model_builder *b) {
    uint32_t chance = 41;
    const bolan_vec3 wood = {0.215f, 0.180f, 0.140f}, wet = {0.070f, 0.055f, 0.040f};
    for (int i = 0; i < 20; i++) {
        const float y = -0.6f + 0.48f * (float)i, skew = bolan_build_between(&chance, -0.05f, 0.05f),
                    z = 0.55f + bolan_build_between(&chance, -0.012f, 0.012f);
        bolan_build_box(b, bolan_v3(-0.75f + skew, y, z - 0.05f), bolan_v3(0.75f + skew, y + 0.445f, z),
                        bolan_build_vary(&chance, wood, 0.22f), false);
    }
    for (int side = -1; side <= 1; side += 2) {
        const float x = 0.62f * (float)side;
        bolan_build_box(b, bolan_v3(x - 0.06f, -0.6f, 0.36f), bolan_v3(x + 0.06f, 9.0f, 0.5f),
                        bolan_v3_scale(wood, 0.6f), false);
        for (int i = 0; i < 4; i++) {
            const float y = 0.4f + 2.75f * (float)i, top = i == 3 ? 1.35f : 0.56f;
            bolan_build_tube(
                b, &(build_bar){{x * 1.14f, y, -3.2f}, {x * 1.14f, y, 0.15f}, 0.085f, 0.085f, wet, wet, 0.7f, 6, true});
            bolan_build_tube(b, &(build_bar){{x * 1.14f, y, 0.1f},
                                             {x * 1.14f, y, top},
                                             0.085f,
                                             0.08f,
                                             build_mix(wood, wet, 0.5f),
                                             wood,
                                             0.9f,
                                             6,
                                             false});
        }
    }
}

// 3.5 m long, leaning a little: a straight object shows refraction best.
void bolan_model_stick(model_builder *b) {
    const bolan_vec3 white = {0.70f, 0.69f, 0.65f}, red = {0.42f, 0.060f, 0.035f}, stained = {0.46f, 0.45f, 0.36f};
    const bolan_vec3 along = bolan_v3_normalize(bolan_v3(0.30f, 0.06f, 1.0f));
    for (int i = 0; i < 7; i++) {
        const float from = 0.5f * (float)i, thick = 0.060f - 0.0015f * from;
        const bolan_vec3 color = i == 6 || i == 2 ? red : i < 3 ? stained : white;
        bolan_build_tube(b, &(build_bar){bolan_v3_scale(along, from), bolan_v3_scale(along, from + 0.5f), thick,
                                         thick - 0.0007f, color, color, 1.0f, 8, i < 6});
    }
}

void bolan_model_rock(model_builder *b) {
    bolan_build_blob(b, &(build_lump){.center = {0.0f, 0.0f, 0.12f},
                                      .radius = {0.95f, 0.70f, 0.55f},
                                      .core = {0.0f, 0.0f, 0.0f},
                                      .low_color = {0.085f, 0.080f, 0.070f},
                                      .high_color = {0.215f, 0.205f, 0.185f},
                                      .low_open = 0.35f,
                                      .high_open = 1.0f,
                                      .rough = 0.19f,
                                      .seed = 3,
                                      .fine = true,
                                      .faceted = true});
}
