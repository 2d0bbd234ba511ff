// SPDX-License-Identifier: MIT
// See sea_gpu.h.
#include "sea_gpu.h"

#include "memory.h"
#include "sea_texels.h"
#include "shared/constants.glsl"

#include <string.h>

enum { TABLE_ROW = 64, TABLE_ROWS = BOLAN_MAX_FREQUENCIES * BOLAN_MAX_DIRECTIONS / TABLE_ROW };

water_waves bolan_water_waves_of(bolan_wave_form form, bolan_surface_kind surface) {
    static const water_waves with_vertices[] = {[BOLAN_FORM_CASCADES] = WATER_CASCADES,
                                                [BOLAN_FORM_COSINES] = WATER_MESH,
                                                [BOLAN_FORM_EXP_COSINES] = WATER_EXP};
    static const water_waves on_quad[] = {
        [BOLAN_FORM_CASCADES] = WATER_CASCADES, [BOLAN_FORM_COSINES] = WATER_SUM, [BOLAN_FORM_EXP_COSINES] = WATER_EXP};
    return (surface == BOLAN_SURFACE_QUAD ? on_quad : with_vertices)[form];
}

const char *bolan_water_waves_define(water_waves waves) {
    static const char *const defines[] = {"", "WAVES_EXP 1\n", "WAVES_SUM 1\n", "WAVES_MESH 1\n"};
    return defines[waves];
}

bolan_result bolan_sea_gpu_create(sea_gpu *p) {
    gl_texture_desc waves = {
        .format = GL_FMT_RGBA32F, .width = TABLE_ROW, .height = TABLE_ROWS, .filter = GL_FILTER_NEAREST};
    *p = (sea_gpu){.now = NULL};
    p->now = &p->kept[0];
    for (int i = 0; i < BOLAN_KEPT_SEAS; ++i) p->kept[i].time = p->kept[i].time_before = NAN;
    return bolan_gl_texture_create(&waves, &p->table);
}

// What a cascade's texels are made in.
typedef struct water_texel_work {
    float *sum, *scratch[2];      // pinch; levels as planes
    uint16_t *packed, *levels[2]; // first level, packed; levels below the first: of displacement, of slopes
} water_texel_work;

// Every array of the work starts on a cache line, as the whole does.
static size_t whole_lines(size_t bytes) { return (bytes + 63) / 64 * 64; }

static void *take(char **at, size_t bytes) {
    void *taken = *at;
    *at += whole_lines(bytes);
    return taken;
}

static size_t work_bytes(uint32_t n) {
    const size_t texels = (size_t)n * n;
    return whole_lines(sizeof(water_texel_work)) + whole_lines(sizeof(float) * texels) +
           whole_lines(sizeof(uint16_t) * 4 * texels) +
           2 * (whole_lines(bolan_texel_scratch_bytes(n)) + whole_lines(bolan_texel_chain_bytes(n)));
}

static void free_work(sea_gpu *p) {
    for (int c = 0; c < BOLAN_MAX_CASCADES; ++c) {
        bolan_release(p->work[c], work_bytes(p->work_n));
        p->work[c] = NULL;
    }
}

static water_texel_work *create_work(uint32_t n) {
    const size_t texels = (size_t)n * n;
    water_texel_work *w = allocate_for("the texels of a cascade", work_bytes(n));
    if (w == NULL) return NULL;
    char *at = (char *)w + whole_lines(sizeof *w);
    w->sum = take(&at, sizeof(float) * texels);
    w->packed = take(&at, sizeof(uint16_t) * 4 * texels);
    for (int i = 0; i < 2; ++i) {
        w->scratch[i] = take(&at, bolan_texel_scratch_bytes(n));
        w->levels[i] = take(&at, bolan_texel_chain_bytes(n));
    }
    return w;
}

static void free_textures(sea_fields *f) {
    bolan_gl_texture_free(&f->displacement);
    bolan_gl_texture_free(&f->displacement_before);
    f->time = f->time_before = NAN;
    bolan_gl_texture_free(&f->slopes);
    bolan_gl_texture_free(&f->fold);
    for (int c = 0; c < BOLAN_MAX_CASCADES; ++c) bolan_gl_texture_free(&f->packed_slopes[c]);
}

static void free_fold(sea_gpu *p) {
    bolan_release(p->cpu_fold, p->cpu_fold_bytes);
    p->cpu_fold = NULL;
    p->cpu_fold_bytes = 0;
}

void bolan_sea_gpu_free(sea_gpu *p) {
    free_work(p);
    free_fold(p);
    for (int i = 0; i < BOLAN_KEPT_SEAS; ++i) {
        free_textures(&p->kept[i]);
        bolan_sea_tables_free(&p->kept[i].tables);
        bolan_gl_texture_free(&p->kept[i].fine);
        bolan_gl_texture_free(&p->kept[i].slope_table);
    }
    bolan_gl_texture_free(&p->table);
}

// ---- cascades -------------------------------------------------------------------------------------------------------

static bolan_result create_packed(sea_fields *p, gl_texture_desc desc, uint32_t count) {
    bolan_result result = BOLAN_OK;
    desc.array = false;
    desc.depth = 0;
    for (uint32_t c = 0; c < count && result == BOLAN_OK; ++c)
        result = bolan_gl_texture_create(&desc, &p->packed_slopes[c]);
    return result;
}

static bolan_result create_whole(sea_fields *p, gl_texture_desc desc) {
    bolan_result result = bolan_gl_texture_create(&desc, &p->slopes);
    if (!desc.storage) desc.format = GL_FMT_RG16F; // ES has no images of two channels
    return result == BOLAN_OK ? bolan_gl_texture_create(&desc, &p->fold) : result;
}

// One array, which compute shaders write, and its layers, which all others read.
static bolan_result create_packed_storage(sea_fields *p, const gl_texture_desc *desc, uint32_t count) {
    const bolan_result result = bolan_gl_texture_create(desc, &p->slopes);
    for (uint32_t c = 0; c < count && result == BOLAN_OK; ++c)
        bolan_gl_texture_layer(&p->slopes, c, desc, &p->packed_slopes[c]);
    return result;
}

gl_texture_desc bolan_sea_array_desc(uint32_t n, uint32_t count, bool storage) {
    return (gl_texture_desc){.format = GL_FMT_RGBA16F,
                             .width = n,
                             .height = n,
                             .depth = count,
                             .array = true,
                             .storage = storage,
                             .filter = GL_FILTER_MIPMAP,
                             .wrap = GL_WRAP_REPEAT};
}

// Textures that fit this sea; kept while n, the number of cascades and what they hold stay. False: they cannot be had
// (logged).
static bool fit_textures(sea_fields *p, uint32_t n, uint32_t count, bool packed, bool storage) {
    if (p->displacement.width == n && p->displacement.depth == count && p->packed == packed) return true;
    free_textures(p);
    const gl_texture_desc desc = bolan_sea_array_desc(n, count, storage);
    p->packed = packed;
    bolan_result result = bolan_gl_texture_create(&desc, &p->displacement);
    if (result == BOLAN_OK)
        result = !packed   ? create_whole(p, desc)
                 : storage ? create_packed_storage(p, &desc, count)
                           : create_packed(p, desc, count);
    if (result != BOLAN_OK) free_textures(p);
    return result == BOLAN_OK;
}

// dxy and foam side by side, so that the fragment shader gets both by one look-up.
static void interleave_fold(const bolan_cascade_view *v, uint16_t *out) {
    for (size_t i = 0; i < (size_t)v->n * v->n; ++i) {
        out[2 * i] = v->displacement_half[4 * i + 3];
        out[2 * i + 1] = v->foam_half[i];
    }
}

// What the workers make of a frame's cascades: item 2c the levels of the displacement of cascade c, 2c + 1 of its
// slopes.
typedef struct texel_job {
    const sea_gpu *gpu;
    const bolan_sea *sea;
    bool packed, levels;
} texel_job;

static void make_texels(void *context, uint32_t begin, uint32_t end, uint32_t worker) {
    const texel_job *job = context;
    (void)worker;
    for (uint32_t item = begin; item < end; ++item) {
        water_texel_work *w = job->gpu->work[item / 2];
        const bolan_cascade_view v = bolan_sea_cascade(job->sea, item / 2);
        const float *slopes[] = {v.slope_x, v.slope_y, job->packed ? w->sum : v.dxx, job->packed ? v.foam : v.dyy};
        const bool second = item % 2 == 1;
        if (second && job->packed)
            bolan_texel_kernels_best()->pack((size_t)v.n * v.n, v.slope_x, v.slope_y, v.dxx, v.dyy, v.foam, w->sum,
                                             w->packed);
        if (job->levels && second) bolan_texel_chain(v.n, slopes, w->scratch[1], w->levels[1]);
        if (job->levels && !second)
            bolan_texel_chain_of_texels(v.n, v.pitch, &v.displacement->dx, w->scratch[0], w->levels[0]);
    }
}

static void upload_levels(gl_texture *t, int layer, const uint16_t *levels) {
    for (uint32_t l = 1; l < t->levels; ++l) {
        bolan_gl_texture_upload(t, l, layer, levels, true);
        levels += 4 * (size_t)(t->width >> l) * (t->width >> l);
    }
}

static bool fit_work(sea_gpu *p, uint32_t n, uint32_t count) {
    if (p->work_n != n) free_work(p);
    p->work_n = n;
    bool all = true;
    for (uint32_t c = 0; c < count; ++c) {
        if (all && p->work[c] == NULL) p->work[c] = create_work(n);
        all = all && p->work[c] != NULL;
    }
    return all;
}

static bool fit_fold(sea_gpu *p, uint32_t n) {
    const size_t bytes = sizeof(uint16_t) * 2 * n * n;
    if (p->cpu_fold_bytes == bytes) return true;
    free_fold(p);
    p->cpu_fold = allocate_for("the foam of the cascades", bytes);
    p->cpu_fold_bytes = p->cpu_fold != NULL ? bytes : 0;
    return p->cpu_fold != NULL;
}

static void upload_fold(const sea_gpu *p, sea_fields *f, const bolan_sea *sea, uint32_t count) {
    for (uint32_t c = 0; c < count; ++c) {
        bolan_cascade_view v = bolan_sea_cascade(sea, c);
        interleave_fold(&v, p->cpu_fold);
        bolan_gl_texture_upload(&f->fold, 0, (int)c, p->cpu_fold, true);
    }
    bolan_gl_texture_generate_mipmaps(&f->fold);
}

// On software GL the levels are made here; a GPU makes them in no time.
static bool upload_cascades(sea_gpu *p, sea_fields *f, const bolan_sea *sea, bool packed, bool software) {
    const uint32_t count = bolan_sea_cascade_count(sea), n = bolan_sea_cascade_layout(sea, 0).n;
    if (!fit_textures(f, n, count, packed, false) || !fit_work(p, n, count) || (!packed && !fit_fold(p, n)))
        return false;
    texel_job job = {.gpu = p, .sea = sea, .packed = packed, .levels = software};
    if (packed || software) bolan_parallel(2 * count, 1, make_texels, &job);
    for (uint32_t c = 0; c < count; ++c) {
        const bolan_cascade_view v = bolan_sea_cascade(sea, c);
        bolan_gl_texture_upload(&f->displacement, 0, (int)c, v.displacement_half, true);
        gl_texture *slopes = packed ? &f->packed_slopes[c] : &f->slopes;
        const int layer = packed ? -1 : (int)c;
        bolan_gl_texture_upload(slopes, 0, layer, packed ? p->work[c]->packed : v.slope_half, true);
        if (software) upload_levels(&f->displacement, (int)c, p->work[c]->levels[0]);
        if (software) upload_levels(slopes, layer, p->work[c]->levels[1]);
        if (!software && packed) bolan_gl_texture_generate_mipmaps(slopes);
    }
    if (!packed) upload_fold(p, f, sea, count);
    if (software) return true;
    bolan_gl_texture_generate_mipmaps(&f->displacement);
    if (!packed) bolan_gl_texture_generate_mipmaps(&f->slopes);
    return true;
}

static sea_layout layout_of(bool packed) { return packed ? SEA_LAYOUT_PACKED : SEA_LAYOUT_WHOLE; }

bool bolan_sea_gpu_compile(const frame *f, bool packed) {
    return bolan_sea_compute_compile(f->compute, bolan_sea_cascade_layout(f->sea, 0).n, layout_of(packed));
}

static bool compute_cascades(sea_fields *to, const frame *f, bool packed) {
    const uint32_t count = bolan_sea_cascade_count(f->sea), n = bolan_sea_cascade_layout(f->sea, 0).n;
    const sea_images images = {layout_of(packed), &to->displacement, &to->slopes, &to->fold};
    return fit_textures(to, n, count, packed, true) &&
           bolan_sea_compute_run(f->compute, &to->tables, f->sea, &images, f->timing);
}

// ---- sums -----------------------------------------------------------------------------------------------------------

bool bolan_water_waves_have_table(water_waves waves) { return waves == WATER_SUM || waves == WATER_MESH; }

static void upload_table(sea_gpu *p, const render_view *v) {
    static const float empty[4] = {0};
    float waves[TABLE_ROW * TABLE_ROWS][4];
    uint32_t count = bolan_sea_component_count(v->frame->sea);
    for (uint32_t i = 0; i < TABLE_ROW * TABLE_ROWS; ++i) {
        if (i < count)
            bolan_sea_wave_at(v, i, 1.0, waves[i]);
        else
            memcpy(waves[i], empty, sizeof empty);
    }
    bolan_gl_texture_upload(&p->table, 0, -1, waves, false);
}

// ---- both -----------------------------------------------------------------------------------------------------------

static bool upload_slope_table(sea_fields *f, const bolan_sea *sea) {
    static const gl_texture_desc desc = {.format = GL_FMT_RGBA16F,
                                         .width = BOLAN_SLOPE_TABLE_MAJOR,
                                         .height = BOLAN_SLOPE_TABLE_ASPECT,
                                         .depth = SLOPE_TABLE_LAYERS,
                                         .filter = GL_FILTER_LINEAR,
                                         .wrap = GL_WRAP_CLAMP};
    float table[SLOPE_TABLE_LAYERS * BOLAN_SLOPE_TABLE_ASPECT * BOLAN_SLOPE_TABLE_MAJOR * 4];
    size_t layer = (size_t)BOLAN_SLOPE_TABLE_ASPECT * BOLAN_SLOPE_TABLE_MAJOR * 4;
    const float *from = bolan_sea_slope_table(sea);
    if (f->slope_table.id == 0 && bolan_gl_texture_create(&desc, &f->slope_table) != BOLAN_OK) return false;
    memcpy(table, from, sizeof(float) * layer * BOLAN_SLOPE_TABLE_ANGLE);
    memcpy(table + layer * BOLAN_SLOPE_TABLE_ANGLE, from, sizeof(float) * layer);
    bolan_gl_texture_upload(&f->slope_table, 0, -1, table, false);
    return true;
}

// The fields of this sea and layout; else those that were prepared the longest time ago, which another sea may have.
static sea_fields *choose(sea_gpu *p, uint64_t sea, water_textures textures) {
    sea_fields *oldest = &p->kept[0];
    for (int i = 0; i < BOLAN_KEPT_SEAS; ++i) {
        sea_fields *f = &p->kept[i];
        if (f->sea == sea && f->textures == textures) return f;
        if (f->used < oldest->used) oldest = f;
    }
    return oldest;
}

// The fine waves come from the CPU, with either backend. The levels below the first: see upload_cascades().
static bool upload_fine(sea_gpu *p, sea_fields *to, const bolan_sea *sea, bool software) {
    const bolan_sea_fine_view v = bolan_sea_fine(sea);
    if (v.n == 0) return true;
    if (to->fine.width != v.n) {
        const gl_texture_desc desc = {
            .format = GL_FMT_RGBA16F, .width = v.n, .height = v.n, .filter = GL_FILTER_MIPMAP, .wrap = GL_WRAP_REPEAT};
        bolan_gl_texture_free(&to->fine);
        if (bolan_gl_texture_create(&desc, &to->fine) != BOLAN_OK) return false;
    }
    bolan_gl_texture_upload(&to->fine, 0, -1, v.slope_half, true);
    if (!software || !fit_work(p, v.n, 1)) {
        bolan_gl_texture_generate_mipmaps(&to->fine);
        return true;
    }
    const float *const planes[TEXEL_PLANES] = {v.slope_x, v.slope_y, v.slope_x, v.slope_y};
    bolan_texel_chain(v.n, planes, p->work[0]->scratch[1], p->work[0]->levels[1]);
    upload_levels(&to->fine, -1, p->work[0]->levels[1]);
    return true;
}

// The present displacement becomes that of the step before, and what was that is filled anew. Without memory (logged)
// only the motion of the waves is missing.
static void keep_displacement(sea_fields *f, bool storage) {
    const gl_texture now = f->displacement;
    const gl_texture_desc desc = bolan_sea_array_desc(now.width, now.depth, storage);
    if (now.id == 0) return;
    if (f->displacement_before.id == 0 && bolan_gl_texture_create(&desc, &f->displacement_before) != BOLAN_OK) return;
    f->displacement = f->displacement_before;
    f->displacement_before = now;
    f->time_before = f->time;
}

const gl_texture *bolan_sea_gpu_before(const sea_gpu *p, double time) {
    const sea_fields *f = p->now;
    return f->displacement_before.id != 0 && f->time_before == time ? &f->displacement_before : NULL;
}

static bool make_cascades(sea_gpu *p, sea_fields *now, const frame *f, bool packed) {
    if (!packed && !upload_fine(p, now, f->sea, f->caps->software)) return false;
    if (f->motion) keep_displacement(now, f->compute != NULL);
    const bool made = f->compute != NULL ? compute_cascades(now, f, packed)
                                         : upload_cascades(p, now, f->sea, packed, f->caps->software);
    now->time = made ? f->time : NAN;
    return made;
}

bool bolan_sea_gpu_prepare(sea_gpu *p, frame *f, water_textures textures) {
    const water_waves waves = bolan_water_waves_of(bolan_sea_form(f->sea), f->lighting.technique.surface);
    const uint64_t serial = bolan_sea_serial(f->sea), sea = bolan_sea_id(f->sea);
    sea_fields *now = p->now = choose(p, sea, textures);
    const bool known = now->sea == sea && now->textures == textures;
    const bool fields = waves == WATER_CASCADES && textures != WATER_TEXTURES_NONE;
    now->used = ++p->preparations;
    f->foam_law = fields && f->compute != NULL ? &now->tables.law : NULL;
    if (known && now->serial == serial) return true;
    now->serial = 0;
    if (now->sea != sea) {
        now->sea = 0;
        now->time = NAN; // its displacement is another sea's
        if (!upload_slope_table(now, f->sea)) return false;
    }
    now->sea = sea;
    now->textures = textures;
    if (fields && !make_cascades(p, now, f, textures == WATER_TEXTURES_PACKED)) return false;
    now->serial = serial;
    return true;
}

void bolan_sea_gpu_view(sea_gpu *p, const render_view *v, water_waves waves) {
    if (bolan_water_waves_have_table(waves)) upload_table(p, v);
    bolan_sea_gpu_bind(p, waves);
}

static void bind_cascades(const sea_fields *f) {
    bolan_gl_texture_bind(&f->displacement, UNIT_DISPLACEMENT);
    if (f->packed) {
        bolan_gl_texture_bind(&f->packed_slopes[0], UNIT_SLOPES);
        for (int c = 1; c < BOLAN_MAX_CASCADES; ++c) bolan_gl_texture_bind(&f->packed_slopes[c], UNIT_CASCADES + c - 1);
    } else {
        bolan_gl_texture_bind(&f->slopes, UNIT_SLOPES);
        bolan_gl_texture_bind(&f->fold, UNIT_FOLD);
    }
}

void bolan_sea_gpu_bind(const sea_gpu *p, water_waves waves) {
    if (bolan_water_waves_have_table(waves)) bolan_gl_texture_bind(&p->table, UNIT_WAVE_TABLE);
    if (waves == WATER_CASCADES) bind_cascades(p->now);
    bolan_gl_texture_bind(&p->now->slope_table, UNIT_SLOPE_TABLE);
}
