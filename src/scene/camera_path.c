// SPDX-License-Identifier: MIT
// A camera's path through its keys: monotone cubic pieces for each number (Fritsch & Carlson, SIAM J. Numer. Anal. 17,
// 1980), so that a descent never dips below the key it ends at.
#include "bolan/scene.h"

enum { NUMBERS = 7 }; // x, y, z, heading, pitch, roll, fov

static void take_apart(const bolan_camera *c, double out[NUMBERS]) {
    const double numbers[NUMBERS] = {c->position.x, c->position.y, c->position.z, c->heading_deg,
                                     c->pitch_deg,  c->roll_deg,   c->fov_deg};
    for (int i = 0; i < NUMBERS; i++) out[i] = numbers[i];
}

static bolan_camera put_together(const double n[NUMBERS]) {
    return (bolan_camera){bolan_dv3(n[0], n[1], n[2]), remainder(n[3], 360.0), n[4], n[5], n[6]};
}

// The difference from a to b; headings, number 3, the short way round.
static double difference(int number, double a, double b) { return number == 3 ? remainder(b - a, 360.0) : b - a; }

// Slope at a key between pieces of these mean slopes and lengths: 0 at an extreme, else their weighted harmonic mean.
static double key_slope(double before, double after, double length_before, double length_after) {
    if (!(before * after > 0.0)) return 0.0;
    const double w1 = 2.0 * length_after + length_before, w2 = length_after + 2.0 * length_before;
    return (w1 + w2) / (w1 / before + w2 / after);
}

static double mean_slope(const bolan_scene *s, int number, uint32_t piece) {
    double a[NUMBERS], b[NUMBERS];
    take_apart(&s->camera_keys[piece].camera, a);
    take_apart(&s->camera_keys[piece + 1].camera, b);
    return difference(number, a[number], b[number]) / (s->camera_keys[piece + 1].time - s->camera_keys[piece].time);
}

static double slope_at(const bolan_scene *s, int number, uint32_t key) {
    const uint32_t last = s->camera_key_count - 1;
    if (key == 0) return mean_slope(s, number, 0);
    if (key == last) return mean_slope(s, number, last - 1);
    const bolan_camera_key *k = s->camera_keys;
    return key_slope(mean_slope(s, number, key - 1), mean_slope(s, number, key), k[key].time - k[key - 1].time,
                     k[key + 1].time - k[key].time);
}

bolan_camera bolan_scene_camera_at(const bolan_scene *s, double time) {
    BOLAN_ASSERT(s);
    const bolan_camera_key *k = s->camera_keys;
    const uint32_t count = s->camera_key_count;
    if (count == 0) return s->camera;
    if (count == 1 || time <= k[0].time) return k[0].camera;
    if (time >= k[count - 1].time) return k[count - 1].camera;
    uint32_t piece = 0;
    while (time >= k[piece + 1].time) piece++;
    const double length = k[piece + 1].time - k[piece].time, t = (time - k[piece].time) / length;
    double a[NUMBERS], b[NUMBERS], out[NUMBERS];
    take_apart(&k[piece].camera, a);
    take_apart(&k[piece + 1].camera, b);
    for (int i = 0; i < NUMBERS; i++) {
        const double step = difference(i, a[i], b[i]); // Hermite's cubic, from a to a + step
        const double h01 = t * t * (3.0 - 2.0 * t), h10 = t * (1.0 - t) * (1.0 - t), h11 = t * t * (t - 1.0);
        out[i] = a[i] + h01 * step + length * (h10 * slope_at(s, i, piece) + h11 * slope_at(s, i, piece + 1));
    }
    return put_together(out);
}
