// SPDX-License-Identifier: MIT
// Sequences of tiles: Ma, Zhu & Gong 2006, sections 2.3 (3) and 3 (2). The paper takes its textures from an animation
// program; here they are frames of a sea of BOLAN_WAVES_TEXTURES.
#include "bolan/tiles.h"

#include <math.h>
#include <string.h>

struct bolan_tiles {
    bolan_tiles_view view;
    float *height;
    uint8_t *bytes; // normal, detail, caustics
};

bolan_tiles_desc bolan_tiles_desc_default(void) {
    return (bolan_tiles_desc){.bump = 1.0, .color = {0.02f, 0.07f, 0.08f}, .sun = {0.0f, 0.0f, 1.0f}, .index = 1.34};
}

static size_t texels(const bolan_tiles_view *v) { return (size_t)v->frames * v->n * v->n; }

void bolan_tiles_destroy(bolan_tiles **tiles) {
    if (tiles == NULL || *tiles == NULL) return;
    bolan_release((*tiles)->height, texels(&(*tiles)->view) * sizeof(float));
    bolan_release((*tiles)->bytes, texels(&(*tiles)->view) * 7);
    bolan_release(*tiles, sizeof **tiles);
    *tiles = NULL;
}

// Tiles with arrays that are not filled yet.
static bolan_tiles *reserve(const bolan_tiles_view *shape) {
    bolan_tiles *t = bolan_allocate(sizeof *t);
    if (t != NULL) {
        t->view = *shape;
        t->height = bolan_allocate(texels(shape) * sizeof(float));
        t->bytes = bolan_allocate(texels(shape) * 7);
    }
    if (t == NULL || t->height == NULL || t->bytes == NULL) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "no memory for %u tiles of %u x %u",
                  (unsigned)shape->frames, (unsigned)shape->n, (unsigned)shape->n);
        bolan_tiles_destroy(&t);
        return NULL;
    }
    t->view.height = t->height;
    t->view.normal = t->bytes;
    t->view.detail = t->bytes + 3 * texels(shape);
    t->view.caustics = t->bytes + 6 * texels(shape);
    return t;
}

static bolan_result refuse(const char *what, double value, const char *expected) {
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_RANGE, "tiles: %s %g; expected %s", what, value, expected);
    return BOLAN_ERROR_ARGUMENT;
}

static bool within(double value, double low, double high) { return value >= low && value <= high; } // NAN is not

bolan_result bolan_tiles_create(const bolan_tiles_view *view, bolan_tiles **out) {
    BOLAN_ASSERT(view != NULL && out != NULL);
    BOLAN_ASSERT(view->height != NULL && view->normal != NULL && view->detail != NULL && view->caustics != NULL);
    *out = NULL;
    if (!within(view->n, 8, 1024) || (view->n & (view->n - 1)) != 0)
        return refuse("texels of a side", view->n, "a power of two 8..1024");
    if (!within(view->frames, 1, BOLAN_MAX_LOOP_FRAMES)) return refuse("frames", view->frames, "1..64");
    if (!within(view->length, 0.01, 1e6)) return refuse("length", view->length, "0.01..1e6 m");
    if (!within(view->period, 0.01, 1e6)) return refuse("period", view->period, "0.01..1e6 s");
    if (!within(view->depth, 0.05, 200.0)) return refuse("depth", view->depth, "0.05..200 m");
    if (!isfinite(view->angle)) return refuse("angle", view->angle, "a finite number");
    bolan_tiles *t = reserve(view);
    if (t == NULL) return BOLAN_ERROR_MEMORY;
    memcpy(t->height, view->height, texels(view) * sizeof(float));
    memcpy(t->bytes, view->normal, 3 * texels(view));
    memcpy(t->bytes + 3 * texels(view), view->detail, 3 * texels(view));
    memcpy(t->bytes + 6 * texels(view), view->caustics, texels(view));
    *out = t;
    return BOLAN_OK;
}

bolan_tiles_view bolan_tiles_get_view(const bolan_tiles *tiles) { return tiles->view; }

uint32_t bolan_tiles_frame(const bolan_tiles *tiles, double time, double *share) {
    const double loops = time / tiles->view.period, frames = tiles->view.frames;
    const double at = fmin((loops - floor(loops)) * frames, frames * (1.0 - 1e-12));
    const double frame = fmin(floor(at), frames - 1.0);
    if (share != NULL) *share = at - frame;
    return (uint32_t)frame;
}

// ---- the textures of one frame --------------------------------------------------------------------------------------

static uint8_t to_byte(double x) { return (uint8_t)fmin(fmax(x + 0.5, 0.0), 255.0); }

// h[x+1] - h[x-1] and h[y+1] - h[y-1].
static void differences(const float *h, uint32_t n, uint32_t i, uint32_t j, double d[2]) {
    const uint32_t m = n - 1;
    d[0] = (double)h[j * n + ((i + 1) & m)] - (double)h[j * n + ((i - 1) & m)];
    d[1] = (double)h[((j + 1) & m) * n + i] - (double)h[((j - 1) & m) * n + i];
}

void bolan_tile_normals(const float *height, uint32_t n, double s, uint8_t *rgb) {
    BOLAN_ASSERT(height != NULL && rgb != NULL && n >= 8 && (n & (n - 1)) == 0);
    for (uint32_t j = 0; j < n; j++)
        for (uint32_t i = 0; i < n; i++, rgb += 3) {
            double d[2];
            differences(height, n, i, j, d);
            const double x = -s * d[0], y = -s * d[1], unit = 127.5 / sqrt(1.0 + x * x + y * y); // T1 x T2
            rgb[0] = to_byte(127.5 + x * unit), rgb[1] = to_byte(127.5 + y * unit), rgb[2] = to_byte(127.5 + unit);
        }
}

// The water's own texture, as figure 6c: its colour, lighter on crests and on slopes towards the sun, white where it
// breaks.
static void paint(const bolan_tiles_desc *desc, const float *height, const float *foam, uint32_t n, double texel,
                  double sigma, double steep, uint8_t *rgb) {
    const bolan_vec3 c = desc->color;
    const double most = fmax(fmax((double)c.x, (double)c.y), fmax((double)c.z, 1e-6));
    const double color[3] = {127.5 * (double)c.x / most, 127.5 * (double)c.y / most, 127.5 * (double)c.z / most};
    const double level = sqrt((double)(desc->sun.x * desc->sun.x + desc->sun.y * desc->sun.y));
    const double lx = level > 1e-4 ? (double)desc->sun.x / level : 0.0,
                 ly = level > 1e-4 ? (double)desc->sun.y / level : 1.0;
    for (uint32_t j = 0; j < n; j++)
        for (uint32_t i = 0; i < n; i++, rgb += 3) {
            double d[2];
            differences(height, n, i, j, d);
            const double facing = -(d[0] * lx + d[1] * ly) / (2.0 * texel * steep);
            const double shade = fmin(fmax(1.0 + 0.22 * (double)height[j * n + i] / sigma + 0.16 * facing, 0.3), 1.9);
            const double white = foam != NULL ? (double)foam[j * n + i] : 0.0;
            for (int k = 0; k < 3; k++) rgb[k] = to_byte(shade * color[k] * (1.0 - white) + 240.0 * white);
        }
}

// ---- baking ---------------------------------------------------------------------------------------------------------

typedef struct bake {
    const bolan_tiles_desc *desc;
    bolan_tiles *tiles;
    float *scratch; // n n for each worker
} bake;

static void gather_light(void *context, uint32_t begin, uint32_t end, uint32_t worker) {
    const bake *b = context;
    const bolan_tiles_view *v = &b->tiles->view;
    const size_t size = (size_t)v->n * v->n;
    float *light = b->scratch + worker * size;
    for (uint32_t f = begin; f < end; f++) {
        uint8_t *out = b->tiles->bytes + 6 * texels(v) + f * size;
        bolan_tile_caustics(v->height + f * size, v->n, v->length, v->depth, b->desc->sun, b->desc->index, light);
        for (size_t i = 0; i < size; i++) out[i] = to_byte((double)light[i] * (255.0 / BOLAN_CAUSTICS_RANGE));
    }
}

// Heights of the texels, and the share of foam by the fold of the surface at the moment.
static void sample_texels(const bolan_sea *sea, const bolan_cascade_view *c, float *height, float *foam) {
    enum { RUN = 32 }; // the least resolution
    const double threshold = bolan_sea_foam_threshold(sea), lift = bolan_sea_lift(sea, 0, 0.0);
    const double texel = c->length / c->n;
    double ca, sa;
    bolan_sincos(c->angle, &sa, &ca);
    bolan_dvec2 at[RUN];
    bolan_sea_sample sample[RUN];
    for (size_t first = 0; first < (size_t)c->n * c->n; first += RUN) {
        for (size_t i = 0; i < RUN; i++) {
            const double u = texel * (double)((first + i) % c->n), v = texel * (double)((first + i) / c->n);
            at[i] = (bolan_dvec2){u * ca - v * sa, u * sa + v * ca};
        }
        bolan_sea_sample_rest(sea, at, RUN, sample);
        for (size_t i = 0; i < RUN; i++) {
            height[first + i] = (float)((double)sample[i].height - lift);
            foam[first + i] = (float)fmin(fmax((threshold - (double)sample[i].jacobian) / 0.15 + 0.5, 0.0), 1.0);
        }
    }
}

static void bake_frame(bake *b, const bolan_sea *sea, uint32_t frame) {
    const bolan_cascade_view c = bolan_sea_cascade(sea, 0);
    const bolan_tiles_view *v = &b->tiles->view;
    const size_t size = (size_t)c.n * c.n;
    const double texel = c.length / c.n, sigma = sqrt(fmax(c.variance, 1e-12)), steep = sqrt(fmax(c.mss, 1e-8));
    float *height = b->tiles->height + frame * size;
    sample_texels(sea, &c, height, b->scratch);
    const double s = b->desc->bump / texel * (b->desc->paper ? 1.0 : 0.5);
    bolan_tile_normals(height, c.n, s, b->tiles->bytes + 3 * frame * size);
    paint(b->desc, height, b->scratch, c.n, texel, sigma, steep, b->tiles->bytes + 3 * texels(v) + 3 * frame * size);
}

static bolan_result check(const bolan_sea *sea, const bolan_tiles_desc *d) {
    if (bolan_sea_get_loop(sea).frames == 0) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_RANGE, "tiles: a sea of %s waves; expected one of textures",
                  bolan_wave_model_names[bolan_sea_get_desc(sea)->waves]);
        return BOLAN_ERROR_ARGUMENT;
    }
    if (!within(d->bump, 0.01, 100.0)) return refuse("bump", d->bump, "0.01..100");
    if (d->depth != 0.0 && !within(d->depth, 0.05, 200.0)) return refuse("depth", d->depth, "0 or 0.05..200 m");
    if (!within(d->index, 1.01, 3.0)) return refuse("index", d->index, "1.01..3");
    if (!within((double)d->sun.z, 1e-3, 1.001)) return refuse("sun.z", (double)d->sun.z, "above 0");
    if (fabs((double)bolan_v3_dot(d->sun, d->sun) - 1.0) > 1e-3)
        return refuse("sun's length squared", (double)bolan_v3_dot(d->sun, d->sun), "1");
    return BOLAN_OK;
}

// While rays have not crossed, the light varies by d (n - 1)/n times the Laplacian of the height. Where the rms of the
// variation is about NET, the first rays cross and the light forms a net of bright lines.
#define NET 0.7
#define DEEPEST_NET 2.0 // [m]

// The spline through the heights at a sample.
static double height_at(const bolan_cascade_view *c, uint32_t i, uint32_t j) {
    static const double weight[3] = {1.0 / 6.0, 2.0 / 3.0, 1.0 / 6.0};
    const uint32_t n = c->n, m = n - 1;
    double sum = 0.0;
    for (uint32_t b = 0; b < 3; b++)
        for (uint32_t a = 0; a < 3; a++)
            sum += weight[a] * weight[b] *
                   (double)c->displacement[((j + b - 1) & m) * c->pitch + ((i + a - 1) & m)].height;
    return sum;
}

static double best_depth(const bolan_cascade_view *c, double index) {
    const uint32_t n = c->n;
    const double texel = c->length / n;
    double sum = 0.0;
    for (uint32_t j = 0; j < n; j++)
        for (uint32_t i = 0; i < n; i++) {
            // over two texels, as the rays take their slopes
            const double around =
                height_at(c, i + 2, j) + height_at(c, i - 2, j) + height_at(c, i, j + 2) + height_at(c, i, j - 2);
            const double l = (around - 4.0 * height_at(c, i, j)) / (4.0 * texel * texel);
            sum += l * l;
        }
    const double rms = sqrt(sum / ((double)n * n));
    return fmin(fmax(NET * index / ((index - 1.0) * fmax(rms, 1e-6)), 0.05), DEEPEST_NET);
}

bolan_result bolan_tiles_bake(bolan_sea *sea, const bolan_tiles_desc *desc, bolan_tiles **out) {
    BOLAN_ASSERT(sea != NULL && desc != NULL && out != NULL);
    *out = NULL;
    const bolan_result checked = check(sea, desc);
    if (checked != BOLAN_OK) return checked;
    const bolan_sea_loop loop = bolan_sea_get_loop(sea);
    const bolan_cascade_view c = bolan_sea_cascade(sea, 0);
    const bolan_tiles_view shape = {.n = c.n,
                                    .frames = loop.frames,
                                    .length = c.length,
                                    .angle = c.angle,
                                    .period = loop.period,
                                    .depth = desc->depth > 0.0 ? desc->depth : best_depth(&c, desc->index),
                                    .paper = desc->paper};
    const size_t scratch = (size_t)bolan_threads() * c.n * c.n * sizeof(float);
    bake b = {desc, reserve(&shape), NULL};
    if (b.tiles == NULL) return BOLAN_ERROR_MEMORY;
    b.scratch = bolan_allocate(scratch);
    if (b.scratch == NULL) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "no memory to gather the light of %u x %u texels",
                  (unsigned)shape.n, (unsigned)shape.n);
        bolan_tiles_destroy(&b.tiles);
        return BOLAN_ERROR_MEMORY;
    }
    const double before = bolan_sea_time(sea);
    for (uint32_t f = 0; f < shape.frames; f++) {
        bolan_sea_step(sea, (f + 0.5) * shape.period / shape.frames); // a moment well inside the frame
        bake_frame(&b, sea, f);
    }
    bolan_sea_step(sea, before);
    bolan_parallel(shape.frames, 1, gather_light, &b);
    bolan_release(b.scratch, scratch);
    *out = b.tiles;
    return BOLAN_OK;
}
