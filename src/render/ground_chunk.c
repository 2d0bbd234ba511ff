// SPDX-License-Identifier: MIT
// Chunks of ground: heights, normals, cast shadows, ambient light, mesh.
//
// Shadows: a point is in shadow when the ground towards the sun rises over it by more than the sun's own slope. Swept
// from the sun's side, the height of the shadow over each node follows from the next node alone:
//     top(p) = max(ground(q), shadow(q)),   shadow(p) = top(q) - distance * tan(elevation),   q = p one step sunward
// so a chunk costs one pass, and what stands outside it is asked of its ancestors, which reach further.
// Open sky: each level takes off what its own neighbourhood of seven texels hides and multiplies with its parent's,
// which sums up every scale from the chunk's own to the whole island.
#include "ground_chunk.h"

#include "math/half.h"
#include "memory.h"

#define SHADOW_NONE (-1e9f)
#define CLEARANCE_LIMIT 200.0f // [m]

#define HEIGHTS_SIZE ((size_t)CHUNK_GRID * CHUNK_GRID * sizeof(float))
#define MAP_SIZE ((size_t)CHUNK_MAP * CHUNK_MAP * 4 * sizeof(uint16_t))

chunk_sun bolan_chunk_sun_from(bolan_vec3 d) {
    float level = sqrtf(d.x * d.x + d.y * d.y);
    chunk_sun s = {1.0f, 0.0f, 1e6f};
    if (level > 1e-4f) {
        // Under the horizon nothing is lit; a low sun keeps the shadows finite.
        s = (chunk_sun){d.x / level, d.y / level, fmaxf(d.z / level, 0.02f)};
    }
    return s;
}

bolan_result bolan_chunk_allocate(ground_chunk *c) {
    c->heights = allocate_for("the heights of a chunk of the ground", HEIGHTS_SIZE);
    c->map = c->heights ? allocate_for("the map of a chunk of the ground", MAP_SIZE) : NULL;
    return c->heights && c->map ? BOLAN_OK : BOLAN_ERROR_MEMORY;
}

void bolan_chunk_free(ground_chunk *c) {
    bolan_release(c->heights, HEIGHTS_SIZE);
    bolan_release(c->map, MAP_SIZE);
    c->heights = NULL, c->map = NULL;
}

// Node (i, j) of the map; the border may be reached with indices from -8.
static const float *height_at(const ground_chunk *c, int i, int j) {
    return &c->heights[(j + CHUNK_BORDER) * CHUNK_GRID + i + CHUNK_BORDER];
}

// Distance of the nodes from the mesh of so many texels per cell: twice the rms, which few nodes exceed and one sharp
// rock does not decide. @worst receives the largest.
static float mesh_error(const ground_chunk *c, int step, float *worst) {
    float sum = 0.0f;
    *worst = 0.0f;
    for (int j = 0; j < CHUNK_MAP; j++) {
        int v = j / step * step, v1 = v < CHUNK_TEXELS ? v + step : v;
        float t = (float)(j - v) / (float)step;
        for (int i = 0; i < CHUNK_MAP; i++) {
            int u = i / step * step, u1 = u < CHUNK_TEXELS ? u + step : u;
            float s = (float)(i - u) / (float)step;
            float south = (1.0f - s) * *height_at(c, u, v) + s * *height_at(c, u1, v);
            float north = (1.0f - s) * *height_at(c, u, v1) + s * *height_at(c, u1, v1);
            float e = fabsf(*height_at(c, i, j) - ((1.0f - t) * south + t * north));
            *worst = e > *worst ? e : *worst;
            sum += e * e;
        }
    }
    return 2.0f * sqrtf(sum / (CHUNK_MAP * CHUNK_MAP));
}

static void measure(ground_chunk *c) {
    c->lowest = INFINITY, c->highest = -INFINITY;
    for (int j = 0; j < CHUNK_MAP; j++) {
        for (int i = 0; i < CHUNK_MAP; i++) {
            float z = *height_at(c, i, j);
            c->lowest = z < c->lowest ? z : c->lowest;
            c->highest = z > c->highest ? z : c->highest;
        }
    }
    float worst[CHUNK_MESHES];
    for (int m = 0; m < CHUNK_MESHES; m++) {
        float e = mesh_error(c, CHUNK_RATIO << m, &worst[m]);
        c->error[m] = m > 0 ? fmaxf(e, c->error[m - 1]) : e;
    }
    // A neighbour's mesh may be coarser or finer; along the shared rim they differ by about both errors.
    c->skirt = 2.0f * worst[0] + worst[CHUNK_MESHES - 1] + 0.25f * (float)(c->size / CHUNK_CELLS);
}

static void fill_normals(ground_chunk *c) {
    float scale = (float)(0.5 * CHUNK_TEXELS / c->size);
    for (int j = 0; j < CHUNK_MAP; j++) {
        for (int i = 0; i < CHUNK_MAP; i++) {
            float dx = (*height_at(c, i + 1, j) - *height_at(c, i - 1, j)) * scale;
            float dy = (*height_at(c, i, j + 1) - *height_at(c, i, j - 1)) * scale;
            float n = 1.0f / sqrtf(1.0f + dx * dx + dy * dy);
            uint16_t *m = &c->map[4 * (j * CHUNK_MAP + i)];
            m[0] = half_from_float(-dx * n), m[1] = half_from_float(-dy * n);
        }
    }
}

void bolan_chunk_build(ground_chunk *c, const bolan_ground *terrain) {
    double texel = c->size / CHUNK_TEXELS;
    bolan_ground_elevations(terrain, c->west - CHUNK_BORDER * texel, c->south - CHUNK_BORDER * texel, texel, CHUNK_GRID,
                            CHUNK_GRID, c->heights);
    measure(c);
    fill_normals(c);
}

// ---- light
// -----------------------------------------------------------------------------------------------------------

// Ground or shadow, whichever is higher, at a node coordinate of @c that lies outside it, from the ancestors.
static float top_outside(const ground_chunk *c, float u, float v) {
    const ground_chunk *a = c->parent;
    double scale = 1.0 / CHUNK_TEXELS;
    double x = c->west + u * c->size * scale, y = c->south + v * c->size * scale;
    for (; a; a = a->parent) {
        float pu = (float)((x - a->west) / a->size * CHUNK_TEXELS),
              pv = (float)((y - a->south) / a->size * CHUNK_TEXELS);
        if (pu < 0.0f || pv < 0.0f || pu > CHUNK_TEXELS || pv > CHUNK_TEXELS) {
            continue;
        }
        int i = pu < CHUNK_TEXELS ? (int)pu : CHUNK_TEXELS - 1, j = pv < CHUNK_TEXELS ? (int)pv : CHUNK_TEXELS - 1;
        float top[4];
        for (int n = 0; n < 4; n++) {
            float clearance = float_from_half(a->map[4 * ((j + (n >> 1)) * CHUNK_MAP + i + (n & 1)) + 2]);
            top[n] = *height_at(a, i + (n & 1), j + (n >> 1)) + fmaxf(clearance, 0.0f);
        }
        float s = pu - (float)i, t = pv - (float)j;
        return (1.0f - t) * ((1.0f - s) * top[0] + s * top[1]) + t * ((1.0f - s) * top[2] + s * top[3]);
    }
    return SHADOW_NONE;
}

// Lines of nodes across the main direction to the sun, from the sun's side; `top` holds the line before.
static void cast_shadows(ground_chunk *c, const chunk_sun *sun) {
    bool columns = fabsf(sun->x) >= fabsf(sun->y); // lines are columns, and the sweep runs along x
    float main = columns ? sun->x : sun->y, side = columns ? sun->y : sun->x;
    int step = main > 0.0f ? 1 : -1;
    float shift = side / fabsf(main), fall = sun->slope * (float)(c->size / CHUNK_TEXELS) / fabsf(main);
    float before[CHUNK_MAP], here[CHUNK_MAP];
    for (int n = 0; n < CHUNK_MAP; n++) {
        int line = main > 0.0f ? CHUNK_MAP - 1 - n : n;
        for (int k = 0; k < CHUNK_MAP; k++) {
            float q = (float)k + shift, top;
            if (n > 0 && q >= 0.0f && q <= CHUNK_TEXELS) {
                int a = q < CHUNK_TEXELS ? (int)q : CHUNK_TEXELS - 1;
                top = before[a] + (q - (float)a) * (before[a + 1] - before[a]);
            } else {
                top = columns ? top_outside(c, (float)(line + step), q) : top_outside(c, q, (float)(line + step));
            }
            int i = columns ? line : k, j = columns ? k : line;
            float ground = *height_at(c, i, j), clearance = top - fall - ground;
            here[k] = ground + fmaxf(clearance, 0.0f);
            c->map[4 * (j * CHUNK_MAP + i) + 2] =
                half_from_float(fminf(fmaxf(clearance, -CLEARANCE_LIMIT), CLEARANCE_LIMIT));
        }
        memcpy(before, here, sizeof before);
    }
}

static float parent_sky(const ground_chunk *c, int i, int j) {
    if (!c->parent) {
        return 1.0f;
    }
    const ground_chunk *a = c->parent;
    int u = i + (c->west > a->west + 0.25 * a->size ? CHUNK_TEXELS : 0); // in half texels of the parent
    int v = j + (c->south > a->south + 0.25 * a->size ? CHUNK_TEXELS : 0);
    float sum = 0.0f;
    for (int n = 0; n < 4; n++) { // on a node all four are the same one
        int pu = (u + (n & 1)) / 2, pv = (v + (n >> 1)) / 2;
        sum += float_from_half(a->map[4 * (pv * CHUNK_MAP + pu) + 3]);
    }
    return 0.25f * sum;
}

static void open_sky(ground_chunk *c) {
    static const int ring[8][2] = {{7, 0}, {5, 5}, {0, 7}, {-5, 5}, {-7, 0}, {-5, -5}, {0, -7}, {5, -5}};
    float scale = (float)(CHUNK_TEXELS / (c->size * 7.0 * 8.0));
    for (int j = 0; j < CHUNK_MAP; j++) {
        for (int i = 0; i < CHUNK_MAP; i++) {
            float z = *height_at(c, i, j), rise = 0.0f;
            for (int n = 0; n < 8; n++) {
                rise += *height_at(c, i + ring[n][0], j + ring[n][1]) - z;
            }
            // The mean slope up to the ring; a plane has none, a pit of 45 degrees 1.
            float hidden = fminf(fmaxf(rise * scale, 0.0f) * 1.6f, 0.55f);
            c->map[4 * (j * CHUNK_MAP + i) + 3] = half_from_float(fmaxf(parent_sky(c, i, j) * (1.0f - hidden), 0.12f));
        }
    }
}

void bolan_chunk_light(ground_chunk *c, const chunk_sun *sun) {
    cast_shadows(c, sun);
    open_sky(c);
}

// ---- mesh
// ------------------------------------------------------------------------------------------------------------

// Vertex n of the rim, counter-clockwise from the south-west corner.
static void rim_vertex(uint32_t n, uint32_t *i, uint32_t *j) {
    uint32_t side = n / CHUNK_CELLS, k = n % CHUNK_CELLS;
    *i = side == 0 ? k : side == 1 ? CHUNK_CELLS : side == 2 ? CHUNK_CELLS - k : 0;
    *j = side == 0 ? 0 : side == 1 ? k : side == 2 ? CHUNK_CELLS : CHUNK_CELLS - k;
}

static float *put_vertex(const ground_chunk *c, uint32_t i, uint32_t j, float drop, float *out) {
    float cell = (float)(c->size / CHUNK_CELLS);
    out[0] = (float)i * cell, out[1] = (float)j * cell;
    out[2] = *height_at(c, (int)i * CHUNK_RATIO, (int)j * CHUNK_RATIO) - drop;
    return out + 3;
}

void bolan_chunk_vertices(const ground_chunk *c, float *xyz) {
    for (uint32_t j = 0; j <= CHUNK_CELLS; j++) {
        for (uint32_t i = 0; i <= CHUNK_CELLS; i++) {
            xyz = put_vertex(c, i, j, 0.0f, xyz);
        }
    }
    for (uint32_t n = 0; n < CHUNK_RIM; n++) {
        uint32_t i, j;
        rim_vertex(n, &i, &j);
        xyz = put_vertex(c, i, j, c->skirt, xyz);
    }
}

static uint32_t *put_quad(uint32_t a, uint32_t b, uint32_t c, uint32_t d, uint32_t *out) {
    const uint32_t corners[6] = {a, b, c, a, c, d};
    memcpy(out, corners, sizeof corners);
    return out + 6;
}

uint32_t bolan_chunk_index_count(uint32_t mesh) {
    uint32_t cells = CHUNK_CELLS >> mesh;
    return 6 * (cells * cells + 4 * cells);
}

uint32_t bolan_chunk_first_index(uint32_t mesh) {
    uint32_t first = 0;
    for (uint32_t m = 0; m < mesh; m++) {
        first += bolan_chunk_index_count(m);
    }
    return first;
}

static uint32_t *mesh_indices(uint32_t step, uint32_t *out) {
    const uint32_t row = CHUNK_CELLS + 1, rim = row * row;
    for (uint32_t j = 0; j < CHUNK_CELLS; j += step) {
        for (uint32_t i = 0; i < CHUNK_CELLS; i += step) {
            uint32_t n = j * row + i;
            out = put_quad(n, n + step, n + step * (row + 1), n + step * row, out);
        }
    }
    for (uint32_t n = 0; n < CHUNK_RIM; n += step) {
        uint32_t i, j, i1, j1, next = (n + step) % CHUNK_RIM;
        rim_vertex(n, &i, &j);
        rim_vertex(next, &i1, &j1);
        out = put_quad(rim + n, rim + next, j1 * row + i1, j * row + i, out);
    }
    return out;
}

void bolan_chunk_indices(uint32_t *out) {
    for (uint32_t m = 0; m < CHUNK_MESHES; m++) {
        out = mesh_indices(1u << m, out);
    }
}
