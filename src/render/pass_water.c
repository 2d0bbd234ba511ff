// SPDX-License-Identifier: MIT
// The water: uploads the sea's cascades, builds the surface of this view, draws its shape into a few numbers per pixel, and
// shades these over a copy of what lies behind. Shaders: shaders/water_surface.glsl, shaders/water.glsl.
#include "foam_texture.h"
#include "frame.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define SLOPE_ANGLES (BOLAN_SLOPE_TABLE_ANGLE + 1) // the first repeats at the end, so that linear filtering wraps

enum { SURFACE_COUNT = 4 };

struct pass_water {
    bolan_surface_desc surface;
    gl_program shape[2], light[2];         // [1]: with terrain
    gl_texture shape_map[SURFACE_COUNT];   // outputs of water_surface.glsl
    gl_target shape_target;                // they, and the frame's depth
    uint32_t depth_id;                     // of that depth
    gl_texture displacement, slopes, fold; // arrays, a layer per cascade
    gl_texture slope_table, foam_detail;
    gl_buffer vertices, indices;
    gl_mesh mesh;
    bolan_surface_vertex *cpu_vertices;
    uint32_t *cpu_indices;
    uint16_t *cpu_fold;
    size_t cpu_fold_bytes;
    bolan_surface_size size; // of the indices in the buffer
    double vertical;         // bound of the displacement [m]
};

static const struct {
    double pixels_per_vertex;
    uint32_t max_vertices;
    const char *defines;
} quality_table[] = {
    [BOLAN_QUALITY_LOW] = {8.0, 40000, "TAPS 1\nRAYS 1\n"},
    [BOLAN_QUALITY_MEDIUM] = {6.0, 100000, "TAPS 2\nRAYS 1\n"},
    [BOLAN_QUALITY_HIGH] = {3.0, 300000, "TAPS 4\nRAYS 3\n"},
    [BOLAN_QUALITY_ULTRA] = {2.0, 700000, "TAPS 8\nRAYS 3\n"},
};

static bolan_result create_foam_detail(pass_water *p) {
    size_t bytes = (size_t)FOAM_TEXTURE_SIZE * FOAM_TEXTURE_SIZE * 4;
    uint8_t *pixels = bolan_allocate(bytes);
    if (pixels == NULL) return BOLAN_ERROR_MEMORY;
    bolan_result result = foam_texture_fill(pixels);
    gl_texture_desc desc = {.format = GL_FMT_RGBA8,
                            .width = FOAM_TEXTURE_SIZE,
                            .height = FOAM_TEXTURE_SIZE,
                            .filter = GL_FILTER_MIPMAP,
                            .wrap = GL_WRAP_REPEAT};
    if (result == BOLAN_OK) result = gl_texture_create(&desc, &p->foam_detail);
    if (result == BOLAN_OK) {
        gl_texture_upload(&p->foam_detail, 0, -1, pixels, false);
        gl_texture_generate_mipmaps(&p->foam_detail);
    }
    bolan_release(pixels, bytes);
    return result;
}

static bolan_result create_mesh(pass_water *p) {
    size_t vertex_bytes = sizeof(bolan_surface_vertex) * p->surface.max_vertices;
    size_t index_bytes = sizeof(uint32_t) * 6 * p->surface.max_vertices;
    p->cpu_vertices = bolan_allocate(vertex_bytes);
    p->cpu_indices = bolan_allocate(index_bytes);
    if (p->cpu_vertices == NULL || p->cpu_indices == NULL) return BOLAN_ERROR_MEMORY;
    bolan_result result = gl_buffer_create(GL_BUFFER_VERTEX, GL_USAGE_STREAM, vertex_bytes, NULL, &p->vertices);
    if (result == BOLAN_OK) result = gl_buffer_create(GL_BUFFER_INDEX, GL_USAGE_STREAM, index_bytes, NULL, &p->indices);
    uint8_t components[] = {4};
    if (result == BOLAN_OK)
        result = gl_mesh_create(&p->vertices, &p->indices, components, 1, sizeof(bolan_surface_vertex), &p->mesh);
    return result;
}

bolan_result pass_water_create(bolan_quality quality, pass_water **out) {
    pass_water *p = bolan_allocate(sizeof *p);
    if (p == NULL) return BOLAN_ERROR_MEMORY;
    p->surface = bolan_surface_desc_default();
    p->surface.pixels_per_vertex = quality_table[quality].pixels_per_vertex;
    p->surface.max_vertices = quality_table[quality].max_vertices;
    char with_land[64];
    snprintf(with_land, sizeof with_land, "%sLAND 1\n", quality_table[quality].defines);
    bolan_result result = gl_program_create("water_surface", NULL, &p->shape[0]);
    if (result == BOLAN_OK) result = gl_program_create("water_surface", "LAND 1\n", &p->shape[1]);
    if (result == BOLAN_OK) result = gl_program_create("water", quality_table[quality].defines, &p->light[0]);
    if (result == BOLAN_OK) result = gl_program_create("water", with_land, &p->light[1]);
    if (result == BOLAN_OK) result = create_foam_detail(p);
    if (result == BOLAN_OK) result = create_mesh(p);
    gl_texture_desc table = {.format = GL_FMT_RGBA16F,
                             .width = BOLAN_SLOPE_TABLE_MAJOR,
                             .height = BOLAN_SLOPE_TABLE_ASPECT,
                             .depth = SLOPE_ANGLES,
                             .filter = GL_FILTER_LINEAR,
                             .wrap = GL_WRAP_CLAMP};
    if (result == BOLAN_OK) result = gl_texture_create(&table, &p->slope_table);
    if (result != BOLAN_OK) {
        pass_water_destroy(&p);
        return result;
    }
    *out = p;
    return BOLAN_OK;
}

static void free_shape(pass_water *p) {
    gl_target_free(&p->shape_target);
    for (int i = 0; i < SURFACE_COUNT; ++i) gl_texture_free(&p->shape_map[i]);
    p->depth_id = 0;
}

// Textures of the frame's size, with its depth.
static bolan_result fit_shape(pass_water *p, const frame *f) {
    if (p->depth_id == f->hdr_depth->id && p->shape_map[0].width == f->hdr.width &&
        p->shape_map[0].height == f->hdr.height)
        return BOLAN_OK;
    free_shape(p);
    const gl_texture *colors[SURFACE_COUNT];
    bolan_result result = BOLAN_OK;
    for (int i = 0; i < SURFACE_COUNT && result == BOLAN_OK; ++i) {
        gl_texture_desc desc = {.format = i == 0 ? GL_FMT_RGBA32F : GL_FMT_RGBA16F,
                                .width = f->hdr.width,
                                .height = f->hdr.height,
                                .filter = GL_FILTER_NEAREST,
                                .wrap = GL_WRAP_CLAMP};
        result = gl_texture_create(&desc, &p->shape_map[i]);
        colors[i] = &p->shape_map[i];
    }
    if (result == BOLAN_OK) result = gl_target_create(colors, SURFACE_COUNT, f->hdr_depth, -1, 0, &p->shape_target);
    if (result == BOLAN_OK)
        p->depth_id = f->hdr_depth->id;
    else
        free_shape(p);
    return result;
}

void pass_water_destroy(pass_water **pass) {
    if (pass == NULL || *pass == NULL) return;
    pass_water *p = *pass;
    gl_mesh_free(&p->mesh);
    gl_buffer_free(&p->vertices);
    gl_buffer_free(&p->indices);
    gl_texture_free(&p->displacement);
    gl_texture_free(&p->slopes);
    gl_texture_free(&p->fold);
    gl_texture_free(&p->slope_table);
    gl_texture_free(&p->foam_detail);
    free_shape(p);
    for (int i = 0; i < 2; ++i) {
        gl_program_free(&p->shape[i]);
        gl_program_free(&p->light[i]);
    }
    bolan_release(p->cpu_vertices, sizeof(bolan_surface_vertex) * p->surface.max_vertices);
    bolan_release(p->cpu_indices, sizeof(uint32_t) * 6 * p->surface.max_vertices);
    bolan_release(p->cpu_fold, p->cpu_fold_bytes);
    bolan_release(p, sizeof *p);
    *pass = NULL;
}

bolan_result pass_water_reload(pass_water *p) {
    gl_program *programs[] = {&p->shape[0], &p->shape[1], &p->light[0], &p->light[1]};
    bolan_result result = BOLAN_OK;
    for (int i = 0; i < 4 && result == BOLAN_OK; ++i) result = gl_program_reload(programs[i]);
    return result;
}

// Arrays that fit this sea; kept while n and the number of cascades stay.
static void fit_textures(pass_water *p, uint32_t n, uint32_t count) {
    if (p->displacement.width == n && p->displacement.depth == count) return;
    gl_texture_free(&p->displacement);
    gl_texture_free(&p->slopes);
    gl_texture_free(&p->fold);
    gl_texture_desc desc = {.format = GL_FMT_RGBA16F,
                            .width = n,
                            .height = n,
                            .depth = count,
                            .array = true,
                            .filter = GL_FILTER_MIPMAP,
                            .wrap = GL_WRAP_REPEAT};
    gl_texture_create(&desc, &p->displacement);
    gl_texture_create(&desc, &p->slopes);
    desc.format = GL_FMT_RG16F;
    gl_texture_create(&desc, &p->fold);
    bolan_release(p->cpu_fold, p->cpu_fold_bytes);
    p->cpu_fold_bytes = sizeof(uint16_t) * 2 * n * n;
    p->cpu_fold = bolan_allocate(p->cpu_fold_bytes);
}

// dxy and foam side by side, so that the fragment shader gets both by one look-up.
static void interleave_fold(const bolan_cascade_view *v, uint16_t *out) {
    for (size_t i = 0; i < (size_t)v->n * v->n; ++i) {
        out[2 * i] = v->displacement_half[4 * i + 3];
        out[2 * i + 1] = v->foam_half[i];
    }
}

static void upload_sea(pass_water *p, const bolan_sea *sea) {
    uint32_t count = bolan_sea_cascade_count(sea);
    for (uint32_t c = 0; c < count; ++c) {
        bolan_cascade_view v = bolan_sea_cascade(sea, c);
        if (c == 0) fit_textures(p, v.n, count);
        gl_texture_upload(&p->displacement, 0, (int)c, v.displacement_half, true);
        gl_texture_upload(&p->slopes, 0, (int)c, v.slope_half, true);
        interleave_fold(&v, p->cpu_fold);
        gl_texture_upload(&p->fold, 0, (int)c, p->cpu_fold, true);
    }
    gl_texture_generate_mipmaps(&p->displacement);
    gl_texture_generate_mipmaps(&p->slopes);
    gl_texture_generate_mipmaps(&p->fold);
}

static void upload_slope_table(pass_water *p, const bolan_sea *sea) {
    float table[SLOPE_ANGLES * BOLAN_SLOPE_TABLE_ASPECT * BOLAN_SLOPE_TABLE_MAJOR * 4];
    size_t layer = (size_t)BOLAN_SLOPE_TABLE_ASPECT * BOLAN_SLOPE_TABLE_MAJOR * 4;
    const float *from = bolan_sea_slope_table(sea);
    memcpy(table, from, sizeof(float) * layer * BOLAN_SLOPE_TABLE_ANGLE);
    memcpy(table + layer * BOLAN_SLOPE_TABLE_ANGLE, from, sizeof(float) * layer);
    gl_texture_upload(&p->slope_table, 0, -1, table, false);
}

static void build_surface(pass_water *p, frame *f) {
    const bolan_camera *camera = &f->scene->camera;
    bolan_surface_view view = {.eye = f->eye,
                               .heading_deg = camera->heading_deg,
                               .pitch_deg = camera->pitch_deg,
                               .roll_deg = camera->roll_deg,
                               .fov_y = bolan_radians(camera->fov_deg),
                               .aspect = (double)f->desc->width / f->desc->height,
                               .pixel_height = f->desc->height,
                               .water_level = f->scene->water.level};
    bolan_sea_bounds(f->desc->sea, &view.vertical, &view.horizontal);
    p->vertical = view.vertical;
    bolan_surface_size size = bolan_surface_projected(&p->surface, &view, p->cpu_vertices);
    gl_buffer_update(&p->vertices, 0, sizeof(bolan_surface_vertex) * size.columns * size.rows, p->cpu_vertices);
    if (size.columns != p->size.columns || size.rows != p->size.rows) {
        uint32_t count = bolan_surface_grid_indices(size, p->cpu_indices);
        gl_buffer_update(&p->indices, 0, sizeof(uint32_t) * count, p->cpu_indices);
        p->size = size;
    }
}

void pass_water_prepare(pass_water *p, frame *f) {
    upload_sea(p, f->desc->sea);
    upload_slope_table(p, f->desc->sea);
    build_surface(p, f);
    gl_texture_bind(&p->displacement, UNIT_DISPLACEMENT);
    gl_texture_bind(&p->slopes, UNIT_SLOPES);
    gl_texture_bind(&p->fold, UNIT_FOLD);
    gl_texture_bind(&p->slope_table, UNIT_SLOPE_TABLE);
    gl_texture_bind(&p->foam_detail, UNIT_FOAM_DETAIL);
}

// Where the eye stands in each tile, reduced in double so that the GPU never sees a large coordinate.
static void set_cascades(const gl_program *g, const frame *f) {
    float tile[4 * BOLAN_MAX_CASCADES] = {0}, band[4 * BOLAN_MAX_CASCADES] = {0};
    uint32_t count = bolan_sea_cascade_count(f->desc->sea);
    for (uint32_t c = 0; c < count; ++c) {
        bolan_cascade_view v = bolan_sea_cascade(f->desc->sea, c);
        double ca = cos(v.angle), sa = sin(v.angle);
        double u = (f->eye.x * ca + f->eye.y * sa) / v.length, w = (-f->eye.x * sa + f->eye.y * ca) / v.length;
        double texel = v.length / v.n;
        // sample (0, 0) lies at the tile's corner, a texture's first texel half a texel inside
        tile[4 * c] = (float)(u - floor(u) + 0.5 / v.n);
        tile[4 * c + 1] = (float)(w - floor(w) + 0.5 / v.n);
        tile[4 * c + 2] = (float)(ca / v.length);
        tile[4 * c + 3] = (float)(sa / v.length);
        band[4 * c] = (float)(4.0 * sqrt(v.variance));
        band[4 * c + 1] = (float)texel;
        band[4 * c + 3] = (float)log2(texel);
        band[4 * c + 2] = (float)(v.k_min > 0.0 ? 2.0 * BOLAN_PI / v.k_min : v.length);
    }
    gl_program_int(g, "cascade_count", (int)count);
    gl_program_vec4_array(g, "cascade_tile", tile, BOLAN_MAX_CASCADES);
    gl_program_vec4_array(g, "cascade_band", band, BOLAN_MAX_CASCADES);
    gl_program_float(g, "choppiness", (float)bolan_sea_get_desc(f->desc->sea)->choppiness);
}

// The x at which the standard normal distribution reaches p.
static double normal_quantile(double p) {
    double low = -8.0, high = 8.0;
    for (int i = 0; i < 50; ++i) {
        double middle = 0.5 * (low + high);
        if (0.5 * erfc(-middle * 0.70710678118654752) < p)
            low = middle;
        else
            high = middle;
    }
    return 0.5 * (low + high);
}

// Mean and variance of the summed foam memory, from a sparse lattice of each cascade.
static void foam_moments(const bolan_sea *sea, double *mean, double *variance) {
    *mean = *variance = 0.0;
    for (uint32_t c = 0; c < bolan_sea_cascade_count(sea); ++c) {
        bolan_cascade_view v = bolan_sea_cascade(sea, c);
        double sum = 0.0, squares = 0.0;
        uint32_t count = 0, size = v.n * v.n;
        for (uint32_t i = 0; i < size; i += 61, ++count) { // 61 is prime to every n
            sum += v.foam[i];
            squares += (double)v.foam[i] * v.foam[i];
        }
        *mean += sum / count;
        *variance += squares / count - (sum / count) * (sum / count);
    }
}

#define FOAM_EDGE 0.12     // how widely a breaking patch's edge is drawn, in Jacobian
#define OLD_EDGE 0.1       // likewise for old foam, as a share of the memory's variance
#define OLD_FOAM_SHARE 2.0 // decaying foam covers about twice what the breaking crests do

static void set_foam(const gl_program *g, const frame *f) {
    const bolan_sea *sea = f->desc->sea;
    const bolan_sea_desc *desc = bolan_sea_get_desc(sea);
    double variance = 0.0, mss = 0.0, memory_mean, memory_variance;
    for (uint32_t c = 0; c < bolan_sea_cascade_count(sea); ++c) {
        variance += bolan_sea_cascade(sea, c).variance;
        mss += bolan_sea_cascade(sea, c).mss;
    }
    // A soft edge widens a Gaussian field; the covered share stays when the threshold moves out with the standard deviation.
    double spread = fmax(desc->choppiness * desc->choppiness * mss, 1e-9);
    double threshold = 1.0 - (1.0 - bolan_sea_foam_threshold(sea)) * sqrt(1.0 + FOAM_EDGE * FOAM_EDGE / spread);
    foam_moments(sea, &memory_mean, &memory_variance);
    double share = fmin(0.3, OLD_FOAM_SHARE * bolan_monahan_cover(desc->sea_state.wind_speed));
    double old = memory_mean - normal_quantile(share) * sqrt(memory_variance * (1.0 + OLD_EDGE));
    float rest[3];
    bolan_sea_unresolved_slopes(sea, 0.0, 0.0, 0.0, rest);
    bolan_sea_summary summary = bolan_sea_state_summary(&desc->sea_state);
    gl_program_vec4(g, "foam_law",
                    (bolan_vec4){(float)fmax(threshold, -1e30), rest[0] + rest[2], (float)(4.0 * sqrt(variance)),
                                 (float)(summary.tp > 0.0 ? summary.tp : 8.0)});
    gl_program_vec2(g, "foam_edge", (float)(FOAM_EDGE * FOAM_EDGE), (float)OLD_EDGE);
    gl_program_vec4(g, "foam_memory",
                    (bolan_vec4){(float)old, (float)fmax(memory_variance, 1e-9), (float)spread,
                                 (float)bolan_compass_from_to_math(summary.from_deg)});
}

// Rows of the picture, from the bottom, that can show water: up to the horizon raised by the highest wave.
static uint32_t water_rows(const pass_water *p, const frame *f) {
    const bolan_camera *c = &f->scene->camera;
    if (c->roll_deg != 0.0) return f->desc->height;
    double above = f->uniforms.eye.z - p->vertical;
    if (above <= 1.0) return f->desc->height; // among the waves: they may stand anywhere
    double top = bolan_radians(c->pitch_deg) + acos(BOLAN_EARTH_RADIUS / (BOLAN_EARTH_RADIUS + above)); // over it
    double half = 0.5 * bolan_radians(c->fov_deg);
    double y = -tan(top) / tan(half); // in the middle; the curve of the horizon bends down from there
    double rows = (0.5 + 0.5 * y) * f->desc->height + 3.0;
    return (uint32_t)fmin(fmax(rows, 1.0), f->desc->height);
}

static void draw_shape(pass_water *p, frame *f, uint32_t triangles) {
    const gl_program *g = &p->shape[f->shore->present];
    gl_target_bind(&p->shape_target);
    gl_target_clear_color(0.0f, 0.0f, 0.0f, 0.0f);
    gl_set_state(&(gl_state){.depth_test = true, .depth_write = true, .color_write = true});
    gl_program_use(g);
    if (f->shore->present) shore_map_apply(f->shore, g);
    set_cascades(g, f);
    gl_mesh_draw(&p->mesh, 0, 3 * triangles);
}

static void draw_light(pass_water *p, const frame *f) {
    const gl_program *g = &p->light[f->shore->present];
    gl_target_bind_part(&f->hdr, 0, 0, f->hdr.width, water_rows(p, f));
    gl_set_state(&(gl_state){.color_write = true});
    for (uint32_t i = 0; i < SURFACE_COUNT; ++i) gl_texture_bind(&p->shape_map[i], UNIT_SURFACE + i);
    gl_program_use(g);
    if (f->shore->present) shore_map_apply(f->shore, g);
    set_cascades(g, f);
    set_foam(g, f);
    gl_draw_fullscreen();
    gl_target_bind(&f->hdr);
}

void pass_water_draw(pass_water *p, frame *f) {
    if (p->size.columns < 2 || p->size.rows < 2 || fit_shape(p, f) != BOLAN_OK) return;
    uint32_t triangles = 2 * (p->size.columns - 1) * (p->size.rows - 1);
    draw_shape(p, f, triangles);
    draw_light(p, f);
    f->triangles += triangles;
    f->water_triangles += triangles;
}
