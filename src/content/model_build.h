// SPDX-License-Identifier: MIT
/// @file model_build.h
/// The shapes of which the built-in models consist. Only + - * / and square roots are used, so that a model is the same
/// on every machine. Private to src/content.
///
/// Colours are linear albedo. The w of a vertex colour, the open share of the sky, is set by hand: low under eaves and
/// inside crowns. No call fails: when memory is short, `failed` is set and every further call is ignored.
#ifndef BOLAN_CONTENT_MODEL_BUILD_H
#define BOLAN_CONTENT_MODEL_BUILD_H

#include "bolan/model.h"

typedef struct model_builder {
    uint32_t vertex_count, index_count, vertex_capacity, index_capacity;
    bolan_vec3 *positions, *normals;
    bolan_vec4 *colors;
    uint32_t *indices;
    bool failed;
} model_builder;

void bolan_build_free(model_builder *b);
uint32_t bolan_build_vertex(model_builder *b, bolan_vec3 position, bolan_vec3 normal, bolan_vec3 color, float open);
void bolan_build_triangle(model_builder *b, uint32_t i, uint32_t j, uint32_t k);

/// A flat quadrilateral, corners counter-clockwise from outside; the first two have openness `low`, the others `high`.
void bolan_build_quad(model_builder *b, const bolan_vec3 corner[4], bolan_vec3 color, float low, float high);
/// A flat triangle.
void bolan_build_facet(model_builder *b, bolan_vec3 p, bolan_vec3 q, bolan_vec3 r, bolan_vec3 color, float open);
/// A box between two corners, without its bottom when `open_below`.
void bolan_build_box(model_builder *b, bolan_vec3 low, bolan_vec3 high, bolan_vec3 color, bool open_below);
/// A round bar between two points with a radius at each; closed at its far end unless `open_end`.
typedef struct build_bar {
    bolan_vec3 from, to;
    float from_radius, to_radius;
    bolan_vec3 from_color, to_color;
    float open;
    uint32_t sides;
    bool open_end;
} build_bar;
void bolan_build_tube(model_builder *b, const build_bar *bar);

/// A lumpy ball: 20 triangles, or 80 with `fine`.
typedef struct build_lump {
    bolan_vec3 center, radius;
    bolan_vec3 core; ///< normals point away from the middle between `core` and the centre of the lump
    bolan_vec3 low_color, high_color;
    float low_open, high_open;
    float rough; ///< share of the radius by which it varies
    uint32_t seed;
    bool fine, faceted;
} build_lump;
void bolan_build_blob(model_builder *b, const build_lump *lump);

/// Uniform in [0, 1); moves the state on. At most one call that moves the state in a full expression: C leaves the
/// order of arguments and initialisers to the compiler.
float bolan_build_random(uint32_t *state);
/// Uniform in [low, high).
float bolan_build_between(uint32_t *state, float low, float high);
/// A direction, uniform on the sphere.
bolan_vec3 bolan_build_direction(uint32_t *state);
/// The colour, lighter or darker by up to `share`.
bolan_vec3 bolan_build_vary(uint32_t *state, bolan_vec3 color, float share);
/// A leafy twig: one triangle, turned by chance, lit as if it faced `out`.
void bolan_build_leaf(model_builder *b, uint32_t *state, bolan_vec3 at, bolan_vec3 out, float size, bolan_vec3 color,
                      float open);
static inline bolan_vec3 build_mix(bolan_vec3 a, bolan_vec3 b, float t) {
    return bolan_v3_add(bolan_v3_scale(a, 1.0f - t), bolan_v3_scale(b, t));
}

void bolan_model_pond_ground(model_builder *b);
void bolan_model_pond_wood(model_builder *b);
void bolan_model_house(model_builder *b);
void bolan_model_boat(model_builder *b);
void bolan_model_stick(model_builder *b);
void bolan_model_tree(model_builder *b);
void bolan_model_conifer(model_builder *b);
void bolan_model_reeds(model_builder *b);
void bolan_model_jetty(model_builder *b);
void bolan_model_rock(model_builder *b);
void bolan_model_coral(model_builder *b);
void bolan_model_staghorn(model_builder *b);

#endif
