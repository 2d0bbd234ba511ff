// SPDX-License-Identifier: MIT
// The pond: an uneven oval basin in a meadow. Only + - * / and square roots, so that it is the same on every machine.
#include "content/pond.h"

#include "bolan/content.h"
#include "ground/noise.h"

#define NODES 641u // per side of the grid, 1 m apart

float bolan_pond_outline(float c, float s) {
    // Cosines and sines of multiples of the angle.
    const float c2 = c * c - s * s, s2 = 2.0f * s * c, c3 = c2 * c - s2 * s, s3 = s2 * c + c2 * s,
                c5 = c3 * c2 - s3 * s2, s5 = s3 * c2 + c3 * s2, s7 = s5 * c2 + c5 * s2;
    return 37.2f + 7.6f * c2 - 1.6f * s3 + 0.9f * c3 + 1.1f * c5 - 0.6f * s5 + 0.5f * s7;
}

// Depth at `t` metres inside the shore: banks that fall off, and a sandy shelf in the south.
static float depth_inside(float t, float south) {
    const float bank = 4.6f * t / (t + 7.0f);
    const float shelf = 0.115f * t + 1.8f * smoothstepf(14.0f, 25.0f, t);
    return smooth_min(lerpf(bank, shelf, south), 4.0f, 0.8f);
}

static float height_outside(double x, double y, float d, float south, float north, float r) {
    const float bank = 0.85f * d / (d + lerpf(2.2f, 6.5f, south));
    const float rolling = fractal_noise(x / 75.0, y / 75.0, 3, 11);
    float z = bank + smoothstepf(3.0f, 80.0f, d) * (1.3f + 2.0f * rolling);
    z += 10.0f * smoothstepf(14.0f, 120.0f, d) * north; // the wooded rise
    z += 4.5f * smoothstepf(60.0f, 220.0f, d);          // hides the plane of the water beyond the pond
    z += smoothstepf(250.0f, 2500.0f, r) * (28.0f + 60.0f * fractal_noise(x / 1100.0, y / 1100.0, 3, 23));
    return z;
}

float bolan_pond_elevation(double x, double y) {
    const float fx = (float)x, fy = (float)y, r = sqrtf(fx * fx + fy * fy);
    const float c = r > 0.0f ? fx / r : 1.0f, s = r > 0.0f ? fy / r : 0.0f;
    // Small bays and spits.
    const float d = r - bolan_pond_outline(c, s) + 0.9f * gradient_noise(x / 7.0, y / 7.0, 5).v;
    const float south = smoothstepf(0.25f, 0.80f, -s), north = smoothstepf(0.1f, 0.8f, s);
    if (d >= 0.0f) return height_outside(x, y, d, south, north, r);
    const float waves = 0.16f * fractal_noise(x / 6.0, y / 6.0, 2, 31) * smoothstepf(0.5f, 6.0f, -d);
    return -depth_inside(-d, south) + waves;
}

bolan_result bolan_pond_create(const bolan_ground_generator *generator, bolan_ground **out) {
    (void)generator;
    const size_t bytes = (size_t)NODES * NODES * sizeof(float);
    float *z = bolan_allocate(bytes);
    if (!z) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "no memory for a pond of %u x %u elevations", NODES, NODES);
        return BOLAN_ERROR_MEMORY;
    }
    const double start = -0.5 * (NODES - 1);
    for (uint32_t n = 0; n < NODES * NODES; n++) z[n] = bolan_pond_elevation(start + n % NODES, start + n / NODES);
    bolan_ground_desc d = bolan_ground_desc_default();
    d.field = (bolan_heightfield){NODES, NODES, start, start, 1.0, 1.0, z};
    d.detail = 0.0;
    d.edge_elevation = 30.0;
    const bolan_result result = bolan_ground_create(&d, out);
    bolan_release(z, bytes);
    return result;
}
