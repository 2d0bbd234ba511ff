// SPDX-License-Identifier: MIT
// Liu, Xu & Chen 2009: normals of the mesh and one light. Shader: shaders/papers/lit.glsl.
#include "render/foam_texture.h"
#include "render/ripple_texture.h"
#include "render/papers/nested_levels.h"
#include "render/papers/shade_columns.h"
#include "render/water_optics.h"

#include <math.h>

typedef struct lit {
    bolan_quality quality;
    gl_texture foam_detail, ripples;
} lit;

enum { BY_THE_PAPER = 1 << 4 };

static const water_shader shader = {.stem = "papers/lit",
                                    .reads = WATER_FEATURE_ALL,
                                    .defines = {[BOLAN_QUALITY_LOW] = "TAPS 1\nRIPPLES 1\nROUGH_VERTICES 1\n",
                                                [BOLAN_QUALITY_MEDIUM] = "TAPS 2\nRIPPLES 2\nROUGH_VERTICES 1\n",
                                                [BOLAN_QUALITY_HIGH] = "TAPS 4\nRIPPLES 2\n",
                                                [BOLAN_QUALITY_ULTRA] = "TAPS 8\nRIPPLES 2\n",
                                                [4] = "PAPER 1\n"}};

static bolan_result create(void *state, bolan_quality quality) {
    lit *p = state;
    p->quality = quality;
    bolan_result result = bolan_foam_texture_create(&p->foam_detail);
    return result == BOLAN_OK ? bolan_ripple_texture_create(&p->ripples) : result;
}

#define FOAM_EDGE 0.1 // how widely a breaking patch's edge is drawn, in Jacobian

// Unresolved slopes widen the Jacobian's distribution, so that more area falls below the threshold.
typedef struct lit_block {
#include "shared/lit_block.glsl"
} lit_block;

static lit_block foam_of(const render_view *v) {
    float beyond[3]; // what is no part of the waves whose Jacobian the threshold is made for
    bolan_sea_unresolved_slopes(v->frame->sea, 0.0, 0.0, 0.0, beyond);
    return (lit_block){.foam_jacobian = (float)fmax(bolan_sea_foam_threshold(v->frame->sea), -1e30),
                       .foam_edge = (float)FOAM_EDGE,
                       .slopes_beyond_waves = beyond[0] + beyond[2]};
}

static uint32_t own_defines(bool by_the_paper, bolan_quality quality) {
    return by_the_paper ? (uint32_t)BY_THE_PAPER : 1u << quality;
}

static void list(const void *state, const water_setup *s, water_programs *all) {
    (void)state;
    bolan_water_programs_add(all, s, false, &shader, own_defines(s->look->paper, s->quality));
}

static void draw(void *state, const water_draw *d) {
    const lit *p = state;
    if (!bolan_water_program(d, &shader, own_defines(d->view->frame->lighting.look.paper, p->quality))) return;
    const lit_block block = foam_of(d->view);
    bolan_water_blocks_upload_optics(d->blocks, &block, sizeof block);
    if (d->waves != WATER_CASCADES) bolan_gl_texture_bind(&p->ripples, UNIT_RIPPLES);
    bolan_gl_texture_bind(&p->foam_detail, UNIT_FOAM_DETAIL);
    bolan_water_draw_forward(d);
}

static void free_all(void *state) {
    lit *p = state;
    bolan_gl_texture_free(&p->foam_detail);
    bolan_gl_texture_free(&p->ripples);
}

const water_optics bolan_optics_lit = {.kind = BOLAN_OPTICS_LIT,
                                       .size = sizeof(lit),
                                       .looks_through = true,
                                       .shade_columns = bolan_paper_columns,
                                       .mesh = bolan_paper_nested_levels,
                                       .create = create,
                                       .list = list,
                                       .draw = draw,
                                       .free = free_all};
