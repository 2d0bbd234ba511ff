// SPDX-License-Identifier: MIT
// A sum of a few long waves leaves the water between them smooth, where the wind makes ripples that carry most of the
// slope. Here they are drawn from a tile, once for the five octaves below the shortest wave of the sum, and where there
// is time once more for the next five. Their variance is taken from what the wind's law (Cox & Munk 1954) leaves over
// from the sum, in equal parts for each octave.
#include "ripple_texture.h"
#include "memory.h"

#include <math.h>
#include <string.h>

#define SIZE RIPPLE_TEXTURE_SIZE
#define WAVES 96
#define SHORTEST_WAVE 0.002 // [m]: below it there are none

typedef struct ripple {
    int nx, ny; // waves along the sides
    double ux, uy, phase;
} ripple;

static double uniform(uint32_t *state) { // 0..1 (Steele, Lea & Flood 2014, reduced to 32 bits)
    uint32_t h = *state += 0x9E3779B9u;
    h = (h ^ (h >> 16)) * 0x85EBCA6Bu;
    h = (h ^ (h >> 13)) * 0xC2B2AE35u;
    return (h ^ (h >> 16)) / 4294967296.0;
}

// Even in log k; about the wind as cos^2.
static void draw_lots(ripple out[WAVES]) {
    uint32_t state = 7;
    for (int i = 0; i < WAVES; ++i) {
        double n = RIPPLE_LONGEST * pow(2.0, RIPPLE_OCTAVES * (i + uniform(&state)) / WAVES), angle;
        do angle = BOLAN_PI * (uniform(&state) - 0.5);
        while (cos(angle) * cos(angle) < uniform(&state));
        out[i].nx = (int)lrint(n * cos(angle));
        out[i].ny = (int)lrint(n * sin(angle));
        double length = hypot(out[i].nx, out[i].ny);
        out[i].ux = out[i].nx / length;
        out[i].uy = out[i].ny / length;
        out[i].phase = 2.0 * BOLAN_PI * uniform(&state);
    }
}

typedef struct filling {
    ripple wave[WAVES];
    float *out;
} filling;

// Along a row a wave's phase turns by the same angle from texel to texel: one complex product instead of a cosine.
static void fill_rows(void *context, uint32_t begin, uint32_t end, uint32_t worker) {
    (void)worker;
    const filling *f = context;
    const double step = 2.0 * BOLAN_PI / SIZE, amplitude = sqrt(2.0 / WAVES);
    for (uint32_t j = begin; j < end; ++j) {
        float *row = f->out + (size_t)4 * SIZE * j;
        memset(row, 0, sizeof(float) * 4 * SIZE);
        for (int w = 0; w < WAVES; ++w) {
            const ripple *r = &f->wave[w];
            const float turn_re = (float)cos(step * r->nx), turn_im = (float)sin(step * r->nx);
            const float sx = (float)(amplitude * r->ux), sy = (float)(amplitude * r->uy);
            const double start = r->phase + step * r->ny * j;
            float re = (float)cos(start), im = (float)sin(start);
            for (int i = 0; i < SIZE; ++i) {
                row[4 * i] += sx * re;
                row[4 * i + 1] += sy * re;
                const float next = re * turn_re - im * turn_im;
                im = re * turn_im + im * turn_re;
                re = next;
            }
        }
        for (int i = 0; i < SIZE; ++i) row[4 * i + 2] = row[4 * i] * row[4 * i] + row[4 * i + 1] * row[4 * i + 1];
    }
}

void bolan_ripple_texture_fill(float *out) {
    filling f = {.out = out};
    draw_lots(f.wave);
    bolan_parallel(SIZE, 16, fill_rows, &f);
}

bolan_result bolan_ripple_texture_create(gl_texture *out) {
    size_t bytes = sizeof(float) * 4 * SIZE * SIZE;
    float *pixels = allocate_for("the texture of ripples", bytes);
    if (pixels == NULL) return BOLAN_ERROR_MEMORY;
    bolan_ripple_texture_fill(pixels);
    gl_texture_desc desc = {.format = GL_FMT_RGBA16F,
                            .width = SIZE,
                            .height = SIZE,
                            .filter = GL_FILTER_MIPMAP_NEAREST,
                            .wrap = GL_WRAP_REPEAT};
    bolan_result result = bolan_gl_texture_create(&desc, out);
    if (result == BOLAN_OK) {
        bolan_gl_texture_upload(out, 0, -1, pixels, false);
        bolan_gl_texture_generate_mipmaps(out);
    }
    bolan_release(pixels, bytes);
    return result;
}

// ---- a frame --------------------------------------------------------------------------------------------------------

static double fraction(double x) { return x - floor(x); }

// Where the eye stands in a tile that runs with the phase speed of the wave in its middle, by `angle` off the wind,
// over water that drifts.
static void place(const render_view *v, double longest, double angle, vec4 *tile, vec4 *size) {
    const double to = bolan_compass_from_to_math(bolan_sea_get_desc(v->frame->sea)->sea_state.wind_from_deg) + angle;
    const bolan_dvec2 drift = bolan_frame_drift(v->frame);
    const double x = v->eye.x - drift.x, y = v->eye.y - drift.y, time = v->frame->time;
    const double length = RIPPLE_LONGEST * longest, c = cos(to), s = sin(to);
    const double middle = longest * pow(0.5, 0.5 * RIPPLE_OCTAVES);
    const double speed = sqrt(BOLAN_GRAVITY * middle / (2.0 * BOLAN_PI));
    tile->x = (float)fraction((x * c + y * s - fraction(speed * time / length) * length) / length);
    tile->y = (float)fraction((-x * s + y * c) / length);
    tile->z = (float)c;
    tile->w = (float)s;
    size->x = (float)(1.0 / length);
    size->z = (float)log2(length);
}

void bolan_ripple_fill(water_block *b, const render_view *v) {
    const bolan_sea *sea = v->frame->sea;
    const uint32_t count = bolan_sea_component_count(sea);
    float rest[3];
    double shortest = 1.0; // of the sum
    if (count > 0) {
        bolan_sea_component last = bolan_sea_get_component(sea, count - 1);
        shortest = 2.0 * BOLAN_PI / hypot(last.kx, last.ky);
    }
    bolan_sea_unresolved_slopes(sea, 0.0, 0.0, 0.0, rest);
    double octaves = fmax(log2(shortest / SHORTEST_WAVE), 2.0 * RIPPLE_OCTAVES);
    double variance = (rest[0] + rest[2]) * RIPPLE_OCTAVES / octaves; // of one of the two
    place(v, 0.7 * shortest, 0.3, &b->ripple_tile[0], &b->ripple_size[0]);
    place(v, 0.7 * shortest * pow(0.5, RIPPLE_OCTAVES), -0.4, &b->ripple_tile[1], &b->ripple_size[1]);
    for (int i = 0; i < 2; ++i) {
        b->ripple_size[i].y = (float)variance;
        b->ripple_size[i].w = (float)sqrt(variance);
    }
}
