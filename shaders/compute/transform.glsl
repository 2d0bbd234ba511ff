// SPDX-License-Identifier: MIT
// Inverse Fourier transforms of SIZE = 32 .. 1024 values in shared memory (Stockham; Cooley & Tukey 1965), two complex
// numbers a value. Defined before: SIZE, and SLOT(i, f), the place in `values` of value i of transform f.
//
// A group has 128 threads and 16 kB of shared memory, which every context has: 1024 values, 1024 / SIZE transforms. A
// thread holds the values t + k STEP of its transform, k = 0 .. 7, before the first stage and after the last one, and
// does butterflies of radix 8. What 8 leaves of SIZE is the radix of the last stage:
//
//     SIZE      32    64   128    256    512    1024
//     radix     8 4   8 8  8 8 2  8 8 4  8 8 8  8 8 8 2
#define THREADS 128
#define VALUES 1024
#define TRANSFORMS (VALUES / SIZE) // of a group
#define STEP (SIZE / 8)            // threads of a transform
layout(local_size_x = THREADS) in;
shared vec4 values[VALUES];

// Threads of a half warp write 8 apart: their places are spread over the banks.
int spread(int i) { return i ^ ((i >> 3) & 7); }

// Cosine and sine of 2 pi x for |x| <= 1/2 turn, to 1e-7, since GLSL promises nothing of its own: the polynomials of
// src/waves/cascades/synth_columns.kernel.c.
vec2 turn_of(float x) {
    float n = floor(x * 4.0 + 0.5);
    float r = (x - n * 0.25) * 6.28318530717958648, z = r * r;
    float p = (-0.000194949505 * z + 0.00833197311) * z - 0.166666657;
    float q = (2.44377316e-05 * z - 0.00138873619) * z + 0.0416666456;
    float s = r + r * z * p, c = (1.0 - 0.5 * z) + z * z * q;
    int quadrant = int(n);
    vec2 unit = (quadrant & 1) != 0 ? vec2(s, c) : vec2(c, s);
    return vec2(((quadrant + 1) & 2) != 0 ? -unit.x : unit.x, (quadrant & 2) != 0 ? -unit.y : unit.y);
}

vec2 product(vec2 a, vec2 b) { return vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x); }
vec4 turned(vec4 a, vec2 w) { return vec4(product(a.xy, w), product(a.zw, w)); }
vec4 by_i(vec4 a) { return vec4(-a.y, a.x, -a.w, a.z); }

// ---- butterflies: sums over r of a[r] e^{2 pi i q r / radix} --------------------------------------------------------

void radix4(inout vec4 a, inout vec4 b, inout vec4 c, inout vec4 d) {
    vec4 even = a + c, odd = b + d, even_difference = a - c, odd_difference = by_i(b - d);
    a = even + odd;
    b = even_difference + odd_difference;
    c = even - odd;
    d = even_difference - odd_difference;
}

void butterfly8(inout vec4 e[8]) {
    const float h = 0.707106781186547524;
    radix4(e[0], e[2], e[4], e[6]);
    radix4(e[1], e[3], e[5], e[7]);
    vec4 even[4] = vec4[4](e[0], e[2], e[4], e[6]);
    vec4 odd[4] = vec4[4](e[1], turned(e[3], vec2(h, h)), by_i(e[5]), turned(e[7], vec2(-h, h)));
    for (int q = 0; q < 4; ++q) {
        e[q] = even[q] + odd[q];
        e[q + 4] = even[q] - odd[q];
    }
}

void butterfly4(inout vec4 e[8]) {
    radix4(e[0], e[2], e[4], e[6]);
    radix4(e[1], e[3], e[5], e[7]);
}

void butterfly2(inout vec4 e[8]) {
    for (int u = 0; u < 4; ++u) {
        vec4 sum = e[u] + e[u + 4];
        e[u + 4] = e[u] - e[u + 4];
        e[u] = sum;
    }
}

// ---- stages: `done` values are a transform already ----------------------------------------------------------

// Twiddle factors of butterflies of that radix: values u + q (8 / radix) are those of butterfly u.
void twiddle(inout vec4 e[8], int t, int radix, int done) {
    int apart = 8 / radix;
    for (int u = 0; u < apart; ++u) {
        vec2 w = turn_of(float((t + u * STEP) & (done - 1)) / float(done * radix)), power = w;
        for (int q = 1; q < radix; ++q) {
            e[u + q * apart] = turned(e[u + q * apart], power);
            power = product(power, w);
        }
    }
}

// After butterflies of radix 8: hands the values on to the threads of the next stage.
void exchange(inout vec4 e[8], int t, int f, int done) {
    int first = (t / done) * done * 8 + (t & (done - 1));
    barrier();
    for (int q = 0; q < 8; ++q) values[SLOT(first + q * done, f)] = e[q];
    barrier();
    for (int k = 0; k < 8; ++k) e[k] = values[SLOT(t + k * STEP, f)];
}

// Of transform f of the group, by its thread t. All threads of the group call it.
void transform(inout vec4 e[8], int t, int f) {
    butterfly8(e);
    exchange(e, t, f, 1);
#if SIZE == 32
    twiddle(e, t, 4, 8);
    butterfly4(e);
#else
    twiddle(e, t, 8, 8);
    butterfly8(e);
#if SIZE > 64
    exchange(e, t, f, 8);
#if SIZE == 128
    twiddle(e, t, 2, 64);
    butterfly2(e);
#elif SIZE == 256
    twiddle(e, t, 4, 64);
    butterfly4(e);
#else
    twiddle(e, t, 8, 64);
    butterfly8(e);
#if SIZE == 1024
    exchange(e, t, f, 64);
    twiddle(e, t, 2, 512);
    butterfly2(e);
#endif
#endif
#endif
#endif
}
