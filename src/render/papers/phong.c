// SPDX-License-Identifier: MIT
// Liu & Xie 2010: pictures of what is mirrored and refracted, and three parts of light. Shader:
// shaders/papers/phong.glsl.
#include "render/ripple_texture.h"
#include "render/papers/planar_views.h"
#include "render/papers/shade_columns.h"
#include "render/water_optics.h"

#include <math.h>

typedef struct phong {
    bolan_quality quality;
    gl_texture ripples;
    planar_views views;
} phong;

enum { PICTURES = 1 << 4, BY_THE_PAPER = 1 << 5, FINE = 1 << 6 };

static const water_shader shader = {.stem = "papers/phong",
                                    .reads = WATER_FEATURE_ALL,
                                    .defines = {[BOLAN_QUALITY_LOW] = "TAPS 1\nRIPPLES 1\n",
                                                [BOLAN_QUALITY_MEDIUM] = "TAPS 1\nRIPPLES 2\n",
                                                [BOLAN_QUALITY_HIGH] = "TAPS 4\nRIPPLES 2\n",
                                                [BOLAN_QUALITY_ULTRA] = "TAPS 8\nRIPPLES 2\n",
                                                "PICTURES 1\n",
                                                "PAPER 1\n",
                                                "FINE 1\n"}};

#define HIGH_EYE 400.0f // [m]: from there on the haze of common/haze.glsl, which is alike all the way, would be another

// dC of the paper's look-ups, which gives no numbers: the mirrored as far behind the water as 1 m, the refracted 1 m
// under it, of which refraction takes 1 - 1/1.333 [m].
#define REFLECTION_PUSH 2.0f
#define REFRACTION_PUSH (-0.25f)

static bolan_result create(void *state, bolan_quality quality) {
    phong *p = state;
    p->quality = quality;
    return bolan_ripple_texture_create(&p->ripples);
}

// Two broad tiles of the ripples, the second turned by a right angle, bend the crests: see wander_of() in the shader.
typedef struct phong_block {
#include "shared/phong_block.glsl"
} phong_block;

static phong_block block_of(const render_view *view) {
    const double peak_length = bolan_sea_peak_length(bolan_sea_get_summary(view->frame->sea));
    const double fine = 1.0 / fmax(32.0 * peak_length, 1.0), broad = 0.37 * fine;
    const double x = view->eye.x * fine, y = view->eye.y * fine, u = view->eye.y * broad, v = view->eye.x * broad;
    return (phong_block){
        .wander_eye = {(float)(x - floor(x)), (float)(y - floor(y)), (float)(u - floor(u)), (float)(v - floor(v))},
        .wander_fine = (float)fine,
        .wander_broad = (float)broad,
        .reflection_push = REFLECTION_PUSH,
        .refraction_push = REFRACTION_PUSH};
}

static uint32_t own_defines(bolan_quality quality, bool pictures, bool by_the_paper, bool fine) {
    return 1u << quality | (pictures ? PICTURES : 0u) | (by_the_paper ? BY_THE_PAPER : 0u) | (fine ? FINE : 0u);
}

static void list(const void *state, const water_setup *s, water_programs *all) {
    (void)state;
    for (int fine = s->quality >= BOLAN_QUALITY_HIGH; fine <= 1; ++fine)
        bolan_water_programs_add(all, s, false, &shader, own_defines(s->quality, s->land, s->look->paper, fine));
}

static void draw(void *state, const water_draw *d) {
    const phong *p = state;
    const bool pictures = d->view->frame->behind, paper = d->view->frame->lighting.look.paper;
    const bool fine = p->quality >= BOLAN_QUALITY_HIGH || d->view->block.eye_height > HIGH_EYE;
    if (!bolan_water_program(d, &shader, own_defines(p->quality, pictures, paper, fine))) return;
    const phong_block block = block_of(d->view);
    bolan_water_blocks_upload_optics(d->blocks, &block, sizeof block);
    if (d->waves != WATER_CASCADES) bolan_gl_texture_bind(&p->ripples, UNIT_RIPPLES);
    bolan_water_draw_forward(d);
}

static void draw_world_behind(void *state, const water_draw *d, const world_drawer *world) {
    bolan_planar_views_draw(&((phong *)state)->views, d, false, world);
}

static void free_all(void *state) {
    phong *p = state;
    bolan_gl_texture_free(&p->ripples);
    bolan_planar_views_free(&p->views);
}

const water_optics bolan_optics_phong = {.kind = BOLAN_OPTICS_PHONG,
                                         .size = sizeof(phong),
                                         .shade_columns = bolan_paper_columns,
                                         .planar_mirrors = true,
                                         .own_sky = true,
                                         .create = create,
                                         .list = list,
                                         .behind = draw_world_behind,
                                         .draw = draw,
                                         .free = free_all};
