// SPDX-License-Identifier: MIT
// See second_order.h. R = w^2 / g = k tanh(k depth).
#include "waves/second_order.h"

#include "spectrum/portable.h"

typedef struct free_wave {
    double k, r, root; // |k|, R, sqrt(R)
} free_wave;

static free_wave wave_of(bolan_dvec2 k, double depth) {
    const double size = sqrt(k.x * k.x + k.y * k.y), r = size * portable_tanh(size * depth);
    return (free_wave){size, r, sqrt(r)};
}

// D of the paper; `sign` +1 for the sum and -1 for the difference.
static double potential(free_wave a, free_wave b, double dot, double together, double depth, double sign) {
    const double root = a.root + sign * b.root, free = together * portable_tanh(together * depth);
    const double below = root * root - free;
    const double first = b.root * (a.k * a.k - a.r * a.r) + sign * a.root * (b.k * b.k - b.r * b.r);
    const double above = root * first + 2.0 * root * root * (dot - sign * a.r * b.r);
    return below != 0.0 ? above / below : 0.0; // 0 / 0: a wave with itself
}

static double kernel(free_wave a, free_wave b, double dot, double together, double depth, double sign) {
    const double d = potential(a, b, dot, together, depth, sign);
    return (d - (dot - sign * a.r * b.r)) / (a.root * b.root) + a.r + b.r;
}

second_order bolan_second_order(bolan_dvec2 k1, bolan_dvec2 k2, double depth) {
    const free_wave a = wave_of(k1, depth), b = wave_of(k2, depth);
    const double dot = k1.x * k2.x + k1.y * k2.y;
    const double sx = k1.x + k2.x, sy = k1.y + k2.y, dx = k1.x - k2.x, dy = k1.y - k2.y;
    second_order out = {.sum = kernel(a, b, dot, sqrt(sx * sx + sy * sy), depth, 1.0)};
    if (dx != 0.0 || dy != 0.0) out.difference = kernel(a, b, dot, sqrt(dx * dx + dy * dy), depth, -1.0);
    return out;
}
