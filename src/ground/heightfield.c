// SPDX-License-Identifier: MIT
// Grids of heights: the pyramid, limited bicubic interpolation, and bounds.
//
// The interpolant is the bicubic Hermite patch with Catmull-Rom derivatives, limited where a cubic would overshoot its
// data (Fritsch & Carlson 1980, SIAM J. Numer. Anal. 17, 238: a derivative of at most three times the smaller
// neighbouring difference, and none at an extremum): a steep sea bed beside a flat coast must not produce an island.
// It is C1.
#include "ground/ground.h"

#include "ground/noise.h"

#include <string.h>

static size_t grid_bytes(uint32_t width, uint32_t height) { return (size_t)width * height * sizeof(float); }

// ---- pyramid --------------------------------------------------------------------------------------------------------

static float node(const height_level *l, int64_t i, int64_t j) {
    i = i < 0 ? 0 : i >= (int64_t)l->width ? (int64_t)l->width - 1 : i;
    j = j < 0 ? 0 : j >= (int64_t)l->height ? (int64_t)l->height - 1 : j;
    return l->z[(size_t)j * l->width + (size_t)i];
}

static float filtered_node(const height_level *l, int64_t i, int64_t j) {
    float sum = 0.0f;
    for (int b = -1; b <= 1; b++) {
        for (int a = -1; a <= 1; a++) {
            sum += node(l, i + a, j + b) * (float)((2 - a * a) * (2 - b * b));
        }
    }
    return sum * (1.0f / 16.0f);
}

typedef struct reduce_job {
    const height_level *from;
    height_level *to;
} reduce_job;

static void reduce_rows(void *context, uint32_t begin, uint32_t end, uint32_t worker) {
    const reduce_job *job = context;
    (void)worker;
    for (uint32_t j = begin; j < end; j++) {
        for (uint32_t i = 0; i < job->to->width; i++) {
            job->to->z[(size_t)j * job->to->width + i] = filtered_node(job->from, 2 * (int64_t)i, 2 * (int64_t)j);
        }
    }
}

static bolan_result build_level(bolan_ground *t) {
    const height_level *from = &t->level[t->level_count - 1];
    height_level *to = &t->level[t->level_count];
    // The last node of an even grid has no partner: one more coarse node reaches past it, where node() clamps.
    *to = (height_level){from->width / 2 + 1, from->height / 2 + 1, from->step_x * 2.0, from->step_y * 2.0, NULL};
    to->z = bolan_allocate(grid_bytes(to->width, to->height));
    if (!to->z) {
        return BOLAN_ERROR_MEMORY;
    }
    t->level_count++;
    reduce_job job = {from, to};
    bolan_parallel(to->height, 16, reduce_rows, &job);
    return BOLAN_OK;
}

static bolan_result allocate_blocks(bolan_ground *t, uint32_t width, uint32_t height) {
    block_level *b = &t->block[t->block_count];
    *b = (block_level){width, height, bolan_allocate(grid_bytes(width, height)),
                       bolan_allocate(grid_bytes(width, height))};
    t->block_count++; // freed with the rest even when half of it failed
    return b->low && b->high ? BOLAN_OK : BOLAN_ERROR_MEMORY;
}

static void bound_block(const height_level *l, uint32_t bi, uint32_t bj, float *low, float *high) {
    float lo = INFINITY, hi = -INFINITY;
    for (uint32_t j = 0; j <= TERRAIN_BLOCK; j++) {
        for (uint32_t i = 0; i <= TERRAIN_BLOCK; i++) {
            float z = node(l, (int64_t)bi * TERRAIN_BLOCK + i, (int64_t)bj * TERRAIN_BLOCK + j);
            lo = z < lo ? z : lo;
            hi = z > hi ? z : hi;
        }
    }
    *low = lo;
    *high = hi;
}

static bolan_result build_blocks(bolan_ground *t) {
    const height_level *l = &t->level[0];
    uint32_t w = (l->width + TERRAIN_BLOCK - 2) / TERRAIN_BLOCK, h = (l->height + TERRAIN_BLOCK - 2) / TERRAIN_BLOCK;
    bolan_result r = allocate_blocks(t, w, h);
    for (uint32_t j = 0; r == BOLAN_OK && j < h; j++) {
        for (uint32_t i = 0; i < w; i++) {
            bound_block(l, i, j, &t->block[0].low[j * w + i], &t->block[0].high[j * w + i]);
        }
    }
    while (r == BOLAN_OK && (w > 1 || h > 1) && t->block_count < TERRAIN_LEVELS) {
        const block_level *from = &t->block[t->block_count - 1];
        r = allocate_blocks(t, (w + 1) / 2, (h + 1) / 2);
        block_level *to = &t->block[t->block_count - 1];
        for (uint32_t n = 0; r == BOLAN_OK && n < to->width * to->height; n++) {
            to->low[n] = INFINITY, to->high[n] = -INFINITY;
        }
        for (uint32_t n = 0; r == BOLAN_OK && n < w * h; n++) {
            uint32_t m = n / w / 2 * to->width + n % w / 2;
            to->low[m] = fminf(to->low[m], from->low[n]);
            to->high[m] = fmaxf(to->high[m], from->high[n]);
        }
        w = to->width, h = to->height;
    }
    return r;
}

bolan_result bolan_heightfield_build(bolan_ground *t, const bolan_heightfield *field) {
    height_level *l = &t->level[0];
    *l = (height_level){field->width, field->height, field->step_x, field->step_y, NULL};
    l->z = bolan_allocate(grid_bytes(field->width, field->height));
    if (!l->z) {
        return BOLAN_ERROR_MEMORY;
    }
    memcpy(l->z, field->elevation, grid_bytes(field->width, field->height));
    t->level_count = 1;
    bolan_result r = BOLAN_OK;
    while (r == BOLAN_OK && t->level_count < TERRAIN_LEVELS && t->level[t->level_count - 1].width > 8 &&
           t->level[t->level_count - 1].height > 8) {
        r = build_level(t);
    }
    return r == BOLAN_OK ? build_blocks(t) : r;
}

void bolan_heightfield_free(bolan_ground *t) {
    for (uint32_t n = 0; n < TERRAIN_LEVELS; n++) {
        height_level *l = &t->level[n];
        bolan_release(l->z, grid_bytes(l->width, l->height));
        bolan_release(t->block[n].low, grid_bytes(t->block[n].width, t->block[n].height));
        bolan_release(t->block[n].high, grid_bytes(t->block[n].width, t->block[n].height));
    }
}

// ---- interpolation --------------------------------------------------------------------------------------------------

static float limited(float left, float right) {
    if (left * right <= 0.0f) {
        return 0.0f;
    }
    float mean = 0.5f * (left + right), most = 3.0f * fminf(fabsf(left), fabsf(right));
    return mean > most ? most : mean < -most ? -most : mean;
}

// Value, derivatives and twist at a node, in units of the cell.
static void node_jet(const height_level *l, int64_t i, int64_t j, float jet[4]) {
    float z = node(l, i, j), w = node(l, i - 1, j), e = node(l, i + 1, j), s = node(l, i, j - 1), n = node(l, i, j + 1);
    float fx = limited(z - w, e - z), fy = limited(z - s, n - z);
    float cx = 0.5f * (e - w), cy = 0.5f * (n - s);
    // The twist is limited as its parents were.
    float kx = fabsf(cx) > 1e-6f ? fx / cx : 0.0f, ky = fabsf(cy) > 1e-6f ? fy / cy : 0.0f;
    float twist =
        0.25f * (node(l, i + 1, j + 1) - node(l, i + 1, j - 1) - node(l, i - 1, j + 1) + node(l, i - 1, j - 1));
    jet[0] = z, jet[1] = fx, jet[2] = fy, jet[3] = twist * kx * ky;
}

// Hermite data of a curve -> coefficients of 1, t, t^2, t^3.
static void hermite(float a, float da, float b, float db, float c[4]) {
    c[0] = a, c[1] = da, c[2] = 3.0f * (b - a) - 2.0f * da - db, c[3] = 2.0f * (a - b) + da + db;
}

// patch[4 * r + c]: coefficient of s^c t^r.
static void build_patch(const height_level *l, int64_t i, int64_t j, float patch[16]) {
    float jet[4][4];
    for (int c = 0; c < 4; c++) {
        node_jet(l, i + (c & 1), j + (c >> 1), jet[c]);
    }
    float south[4], north[4], south_dy[4], north_dy[4];
    hermite(jet[0][0], jet[0][1], jet[1][0], jet[1][1], south);
    hermite(jet[2][0], jet[2][1], jet[3][0], jet[3][1], north);
    hermite(jet[0][2], jet[0][3], jet[1][2], jet[1][3], south_dy);
    hermite(jet[2][2], jet[2][3], jet[3][2], jet[3][3], north_dy);
    for (int c = 0; c < 4; c++) {
        float column[4];
        hermite(south[c], south_dy[c], north[c], north_dy[c], column);
        for (int r = 0; r < 4; r++) {
            patch[4 * r + c] = column[r];
        }
    }
}

static surface_point patch_at(const float p[16], float s, float t) {
    float row[4], slope[4];
    for (int r = 0; r < 4; r++) {
        const float *q = p + 4 * r;
        row[r] = q[0] + s * (q[1] + s * (q[2] + s * q[3]));
        slope[r] = q[1] + s * (2.0f * q[2] + s * 3.0f * q[3]);
    }
    surface_point o;
    o.z = row[0] + t * (row[1] + t * (row[2] + t * row[3]));
    o.dx = slope[0] + t * (slope[1] + t * (slope[2] + t * slope[3]));
    o.dy = row[1] + t * (2.0f * row[2] + t * 3.0f * row[3]);
    return o;
}

void bolan_height_cursor_start(height_cursor *c, const bolan_ground *t) {
    c->terrain = t;
    c->i[0] = c->i[1] = c->j[0] = c->j[1] = INT64_MIN;
    c->level[0] = c->level[1] = 0;
}

static surface_point level_at(height_cursor *c, uint32_t slot, uint32_t level, double x, double y) {
    const height_level *l = &c->terrain->level[level];
    double u = (x - c->terrain->west) / l->step_x, v = (y - c->terrain->south) / l->step_y;
    int64_t i = (int64_t)u, j = (int64_t)v; // u, v >= 0: the point was clamped to the grid
    i = i > (int64_t)l->width - 2 ? (int64_t)l->width - 2 : i;
    j = j > (int64_t)l->height - 2 ? (int64_t)l->height - 2 : j;
    if (c->i[slot] != i || c->j[slot] != j || c->level[slot] != level) {
        build_patch(l, i, j, c->patch[slot]);
        c->i[slot] = i, c->j[slot] = j, c->level[slot] = level;
    }
    surface_point p = patch_at(c->patch[slot], (float)(u - (double)i), (float)(v - (double)j));
    p.dx /= (float)l->step_x;
    p.dy /= (float)l->step_y;
    return p;
}

float bolan_ground_inside(const bolan_ground *t, double x, double y) {
    if (!isfinite(x + y)) { // outside of everything, also where it is no number
        return 0.0f;
    }
    double dx = fmax(fmax(t->west - x, x - t->east), 0.0), dy = fmax(fmax(t->south - y, y - t->north), 0.0);
    if (dx == 0.0 && dy == 0.0) {
        return 1.0f;
    }
    return 1.0f - smoothstepf(0.0f, 1.0f, (float)fmin(sqrt(dx * dx + dy * dy) / t->margin, 1.0));
}

surface_point bolan_height_cursor_at(height_cursor *c, double x, double y, double resolution) {
    const bolan_ground *t = c->terrain;
    double px = fmin(fmax(x, t->west), t->east), py = fmin(fmax(y, t->south), t->north);
    // Level n resolves the wavelengths that a grid of spacing step * 2^n can represent.
    uint32_t level = 0;
    double spacing = t->step;
    while (level + 2 < t->level_count && spacing * 2.0 <= resolution) {
        spacing *= 2.0;
        level++;
    }
    surface_point p = level_at(c, 0, level, px, py);
    if (resolution > spacing && level + 1 < t->level_count) {
        surface_point q = level_at(c, 1, level + 1, px, py);
        float w = (float)fmin(resolution / spacing - 1.0, 1.0);
        p = (surface_point){lerpf(p.z, q.z, w), lerpf(p.dx, q.dx, w), lerpf(p.dy, q.dy, w)};
    }
    if (px != x || py != y) {
        float inside = bolan_ground_inside(t, x, y);
        p = (surface_point){lerpf(t->edge_elevation, p.z, inside), p.dx * inside, p.dy * inside};
    }
    return p;
}
