// SPDX-License-Identifier: MIT
// Light through crests and ramps of foam. Three steps: the shape of the water over the static grid
// (shaders/papers/crest_shape.glsl), what varies slowly, in a small picture (water_air.h), and the light, each pixel
// once (crest.glsl).
#include "render/foam_statistics.h"
#include "render/kept_sizes.h"
#include "render/memory.h"
#include "render/papers/foam_ramps.h"
#include "render/papers/shade_columns.h"
#include "render/water_air.h"
#include "render/water_optics.h"
#include "shared/constants.glsl"
#include "shared/foam.glsl"
#include "shared/microfacets.glsl"

#include <math.h>
#include <stddef.h>

// Rows of one small texture: the ramps of foam, and row 0 of the table of unresolved slopes, which changes with the
// sun.
enum { TABLE_SLOPES = FOAM_RAMP_ROWS, TABLE_ROWS };

// What has the size of a view: 16 bytes a pixel.
typedef struct crest_targets {
    gl_texture kept; // output of crest_shape.glsl
    gl_target shape; // it, and the frame's depth
    water_air air;
    uint64_t depth_serial; // of the frame's depth that shape draws with
} crest_targets;

typedef struct crest {
    bolan_quality quality;
    double taps;
    gl_texture densities, tables;
    float table[TABLE_ROWS][FOAM_RAMP_SIZE][4]; // what `tables` holds
    kept_sizes kept;
    crest_targets sizes[KEPT_SIZES];
    crest_targets *now; // those of the present size
} crest;

enum { ONE_CASCADE = 1 << 4, SPARSE = 1 << 8 };

static const water_shader shape_shader = {.stem = "papers/crest_shape", .reads = WATER_FEATURE_ALL};
static const water_shader light_shader = {.stem = "papers/crest",
                                          .reads = WATER_FEATURE_WAVES | WATER_FEATURE_LAND,
                                          .defines = {[BOLAN_QUALITY_LOW] = "TAPS 2\n",
                                                      [BOLAN_QUALITY_MEDIUM] = "TAPS 2\n",
                                                      [BOLAN_QUALITY_HIGH] = "TAPS 3\n",
                                                      [BOLAN_QUALITY_ULTRA] = "TAPS 4\n",
                                                      "CASCADES 1\n",
                                                      "CASCADES 2\n",
                                                      "CASCADES 3\n",
                                                      "CASCADES 4\n",
                                                      "SPARSE 1\n"}};

static const double quality_taps[] = {2.0, 2.0, 3.0, 4.0};

static bolan_result create_densities(crest *p, bolan_quality quality) {
    const size_t bytes = (size_t)FOAM_TEXTURE_SIZE * FOAM_TEXTURE_SIZE * 4;
    uint8_t *pixels = allocate_for("the texture of foam", bytes);
    if (pixels == NULL) return BOLAN_ERROR_MEMORY;
    gl_texture_desc desc = {.format = GL_FMT_RGBA8,
                            .width = FOAM_TEXTURE_SIZE,
                            .height = FOAM_TEXTURE_SIZE,
                            .filter = quality < BOLAN_QUALITY_HIGH ? GL_FILTER_MIPMAP_NEAREST : GL_FILTER_MIPMAP,
                            .wrap = GL_WRAP_REPEAT};
    bolan_result result = bolan_foam_densities_fill(pixels);
    if (result == BOLAN_OK) result = bolan_gl_texture_create(&desc, &p->densities);
    if (result == BOLAN_OK) {
        bolan_gl_texture_upload(&p->densities, 0, -1, pixels, false);
        bolan_gl_texture_generate_mipmaps(&p->densities);
    }
    bolan_release(pixels, bytes);
    return result;
}

static bolan_result create_tables(crest *p) {
    uint8_t ramps[FOAM_RAMP_ROWS][FOAM_RAMP_SIZE][4];
    gl_texture_desc desc = {.format = GL_FMT_RGBA16F,
                            .width = FOAM_RAMP_SIZE,
                            .height = TABLE_ROWS,
                            .filter = GL_FILTER_LINEAR,
                            .wrap = GL_WRAP_CLAMP};
    bolan_foam_ramps_fill(ramps);
    for (int row = 0; row < FOAM_RAMP_ROWS; ++row)
        for (int i = 0; i < FOAM_RAMP_SIZE; ++i)
            for (int k = 0; k < 4; ++k) p->table[row][i][k] = (float)ramps[row][i][k] / 255.0f;
    return bolan_gl_texture_create(&desc, &p->tables);
}

static bolan_result create(void *state, bolan_quality quality) {
    crest *p = state;
    p->quality = quality;
    p->taps = quality_taps[quality];
    const bolan_result result = create_densities(p, quality);
    return result == BOLAN_OK ? create_tables(p) : result;
}

static void free_pictures(crest_targets *p) {
    bolan_gl_target_free(&p->shape);
    bolan_gl_texture_free(&p->kept);
    bolan_water_air_free(&p->air);
    p->depth_serial = 0;
}

static bolan_result create_pictures(crest_targets *p, const render_view *v) {
    const gl_texture_desc kept = {
        .format = GL_FMT_RGBA32UI, .width = v->width, .height = v->height, .filter = GL_FILTER_NEAREST};
    const gl_texture *color = &p->kept;
    bolan_result result = bolan_gl_texture_create(&kept, &p->kept);
    if (result == BOLAN_OK) result = bolan_water_air_create(&p->air, v);
    if (result == BOLAN_OK) result = bolan_gl_target_create(&color, 1, v->hdr_depth, -1, 0, &p->shape);
    return result;
}

static bool fit_pictures(crest *p, const render_view *v) {
    bool fresh;
    uint32_t over;
    const uint32_t slot = bolan_kept_sizes_use(&p->kept, v->width, v->height, &fresh);
    crest_targets *t = p->now = &p->sizes[slot];
    while (bolan_kept_sizes_over(&p->kept, &over)) free_pictures(&p->sizes[over]);
    if (!fresh && t->depth_serial == v->depth_serial) return true;
    free_pictures(t);
    if (create_pictures(t, v) != BOLAN_OK) {
        free_pictures(t);
        bolan_kept_sizes_forget(&p->kept, slot);
        return false;
    }
    t->depth_serial = v->depth_serial;
    return true;
}

static void free_all(void *state) {
    crest *p = state;
    for (int i = 0; i < KEPT_SIZES; ++i) free_pictures(&p->sizes[i]);
    bolan_gl_texture_free(&p->densities);
    bolan_gl_texture_free(&p->tables);
}

#define FRESH_EDGE 0.09 // how widely the edge of a breaking crest is drawn, in Jacobian

typedef struct crest_block {
#include "shared/crest_block.glsl"
} crest_block;

static crest_block foam_of(const render_view *v) {
    const foam_law law = bolan_foam_law(v->frame->sea, FRESH_EDGE, v->frame->foam_law == NULL);
    return (crest_block){.breaking_pinch = (float)law.breaking_gaussian,
                         .old_foam_memory = (float)law.memory,
                         .fresh_edge = (float)law.edge,
                         .old_edge = (float)fmax(law.memory_variance * OLD_FOAM_EDGE, 1e-9),
                         .slopes_beyond_cascades = (float)law.slopes_beyond,
                         .memory_share = (float)(law.memory_variance / law.variance),
                         .to_the_letter = v->frame->lighting.look.paper ? 1.0f : 0.0f};
}

// Isotropic footprints need only row 0 of the table of unresolved slopes. With it, the share of the facets turned to
// the sun that no other wave stands before.
static void upload_rough(crest *p, const render_view *v) {
    const float *from = bolan_sea_slope_table(v->frame->sea);
    const bolan_vec3 sun = v->frame->sun_direction;
    const double flat = fmax(sqrt((double)sun.x * sun.x + (double)sun.y * sun.y), 1e-4), up = fmax(sun.z, 0.0f);
    float(*row)[4] = p->table[TABLE_SLOPES];
    for (int i = 0; i < BOLAN_SLOPE_TABLE_MAJOR; ++i) {
        const double xx = from[4 * i] + SUN_DISC_SLOPES, xy = from[4 * i + 1], yy = from[4 * i + 2] + SUN_DISC_SLOPES;
        const double along = (xx * sun.x * sun.x + 2.0 * xy * sun.x * sun.y + yy * sun.y * sun.y) / (flat * flat);
        const double lit = lit_fast(up, flat * sqrt(fmax(along, 1e-8)));
        row[i][0] = (float)xx;
        row[i][1] = (float)xy;
        row[i][2] = (float)yy;
        row[i][3] = (float)lit;
    }
    bolan_gl_texture_upload(&p->tables, 0, -1, p->table, false);
}

static void prepare(void *state, const water_draw *d) { upload_rough(state, d->view); }

static bool draw_shape(crest *p, const water_draw *d) {
    if (!bolan_water_program(d, &shape_shader, 0)) return false;
    bolan_gl_target_bind(&p->now->shape);
    bolan_gl_target_clear_integers();
    bolan_gl_set_state(&(gl_state){.depth_test = true, .depth_write = true, .color_write = true});
    bolan_water_mesh_draw(d->mesh);
    return true;
}

// Rows of the picture, from the bottom, where pixels may be narrower than that [m]. Crests are nearer than the mean
// water on their rays: reckoned from as high as most of them reach.
static uint32_t rows_of_width(const render_view *v, double width, double taps, uint32_t rows) {
    const double above = v->block.eye_height - 0.7 * bolan_sea_get_summary(v->frame->sea)->hs;
    if (fabs(v->lens.roll_deg) > LEVEL_ROLL || above <= 0.0) return rows;
    return bolan_water_rows_steeper(v, sqrt(above * v->block.radians_per_pixel / (width * taps)), rows);
}

static uint32_t own_defines(bolan_quality quality, uint32_t cascades, bool sparse) {
    return 1u << quality | (uint32_t)ONE_CASCADE << (cascades - 1) | (sparse ? SPARSE : 0u);
}

static void list(const void *state, const water_setup *s, water_programs *all) {
    (void)state;
    bolan_water_programs_add(all, s, false, &shape_shader, 0);
    bolan_water_air_list(s, all);
    for (uint32_t cascades = 1; cascades <= s->cascades; ++cascades)
        for (int sparse = 0; sparse <= s->shares_samples; ++sparse)
            bolan_water_programs_add(all, s, false, &light_shader, own_defines(s->quality, cascades, sparse));
}

// By the foam that the GPU has made.
static void patch_foam(const water_draw *d) {
    static const struct {
        size_t offset, first;
    } members[] = {{offsetof(crest_block, old_foam_memory), FOAM_LAW_THRESHOLD},
                   {offsetof(crest_block, old_edge), FOAM_LAW_EDGE},
                   {offsetof(crest_block, memory_share), FOAM_LAW_SHARE}};
    const gl_buffer *law = d->view->frame->foam_law;
    for (size_t i = 0; law != NULL && i < sizeof members / sizeof *members; ++i)
        bolan_water_blocks_patch_optics(d->blocks, members[i].offset, law, members[i].first, 1);
}

static void draw_rows(crest *p, const water_draw *d, water_rows rows, uint32_t cascades) {
    const bool sparse = d->view->block.shade_columns > 1.0f;
    if (!bolan_water_program(d, &light_shader, own_defines(p->quality, cascades, sparse))) return;
    bolan_gl_texture_bind(&p->densities, UNIT_OWN + 4);
    bolan_gl_texture_bind(&p->tables, UNIT_OWN);
    bolan_gl_texture_bind(&p->now->kept, UNIT_OWN + 1);
    bolan_gl_texture_bind(&p->now->air.map, UNIT_OWN + 3);
    bolan_gl_target_bind_part(&d->view->hdr, 0, rows.from, d->view->hdr.width, rows.to - rows.from);
    bolan_gl_set_state(&(gl_state){.color_write = true});
    bolan_gl_draw_fullscreen();
}

// Rows where the widths of pixels still show waves of that cascade: 2.5 of them are its longest wave, and a tenth of
// its slopes left.
static uint32_t rows_of_cascade(const water_draw *d, uint32_t cascade, double taps, uint32_t rows) {
    const bolan_cascade_view v = bolan_sea_cascade_layout(d->view->frame->sea, cascade);
    return v.k_min > 0.0 ? rows_of_width(d->view, 0.4 * 2.0 * BOLAN_PI / v.k_min, taps, rows) : rows;
}

// Far rows fetch fewer cascades.
static void light(void *state, const water_draw *d, water_rows rows) {
    crest *p = state;
    const crest_block block = foam_of(d->view);
    bolan_water_blocks_upload_optics(d->blocks, &block, sizeof block);
    patch_foam(d);
    uint32_t cascades = d->waves == WATER_CASCADES ? bolan_sea_cascade_count(d->view->frame->sea) : 1;
    for (water_rows part = rows; part.from < rows.to;) {
        part.to = cascades > 1 ? rows_of_cascade(d, cascades - 1, p->taps, rows.to) : rows.to;
        if (part.to > part.from) {
            draw_rows(p, d, part, cascades);
            part.from = part.to;
        }
        if (cascades > 1) cascades--;
    }
}

static bool make_shape(void *state, const water_draw *d) {
    crest *p = state;
    return fit_pictures(p, d->view) && draw_shape(p, d) && bolan_water_air_draw(&p->now->air, d);
}

const water_optics bolan_optics_crest = {.kind = BOLAN_OPTICS_CREST,
                                         .size = sizeof(crest),
                                         .looks_through = true,
                                         .shade_columns = bolan_paper_columns,
                                         .coarse_grid = true,
                                         .packed = true,
                                         .create = create,
                                         .list = list,
                                         .prepare = prepare,
                                         .shape = make_shape,
                                         .light = light,
                                         .free = free_all};
