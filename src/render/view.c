// SPDX-License-Identifier: MIT
// What a camera is: a caller's matrices become a lens, our own reversed-Z projection and the uniform block View.
//
// The x and y rows of a perspective projection say where a direction falls in the picture; the z row says what depth
// buffer the host keeps. The first are taken as they are, so that every frustum works, tiled or off-centre; the second
// is replaced by reversed Z with an infinite far plane:
//
//     | m0  0   m8  0  |      x = (m0 X + m8 Z) / -Z       w = -Z, the distance along the view axis
//     | 0   m5  m9  0  |      y = (m5 Y + m9 Z) / -Z
//     | 0   0   0   n  |      window depth = n / -Z        (clip depth in [0,1]; with [-1,1] the row is 0 0 1 2n)
//     | 0   0  -1   0  |
#include "view.h"

#include <math.h>

#include "shared/constants.glsl"

#include "bolan/ground.h"
#include "frame.h"

#define ROTATION_ERROR 1e-3 // of a float matrix that was multiplied up

bolan_view bolan_view_default(void) {
    return (bolan_view){.eye = {0.0, 0.0, 10.0},
                        .view = bolan_m4_view(0.0, 0.0, 0.0),
                        .projection = bolan_m4_projection(bolan_radians(50.0), 16.0 / 9.0, 0.1, 0),
                        .width = 1280,
                        .height = 720,
                        .samples = 1};
}

bolan_view bolan_view_from_camera(const bolan_camera *camera, uint32_t width, uint32_t height) {
    BOLAN_ASSERT(camera != NULL);
    bolan_view v = bolan_view_default();
    v.eye = camera->position;
    v.width = width;
    v.height = height;
    v.view = bolan_m4_view(camera->heading_deg, camera->pitch_deg, camera->roll_deg);
    v.projection = bolan_m4_projection(bolan_radians(camera->fov_deg),
                                       (double)(width > 0 ? width : 1) / (height > 0 ? height : 1), 0.1, 0);
    return v;
}

static bool is_finite(const bolan_mat4 *m) {
    for (int i = 0; i < 16; ++i)
        if (!isfinite(m->m[i])) return false;
    return true;
}

static const char *projection_problem(const float *m) {
    if (m[3] != 0.0f || m[7] != 0.0f || m[11] == 0.0f || m[15] != 0.0f)
        return "its projection is not a perspective, where w is the distance along the view axis; expected a matrix "
               "whose last row is 0 0 -1 0";
    if (m[1] != 0.0f || m[4] != 0.0f || m[12] != 0.0f || m[13] != 0.0f)
        return "its projection turns, skews or moves the picture; expected turns in the view matrix and the place in "
               "the eye";
    if (!(m[0] > 0.0f && m[5] > 0.0f)) return "its projection is singular or mirrors the picture";
    if (m[14] == 0.0f) return "its projection is singular: depth does not depend on the distance";
    return NULL;
}

static const char *rotation_problem(const float *m, double sign) {
    for (int i = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j) {
            double dot = 0.0;
            for (int k = 0; k < 3; ++k) dot += (double)m[4 * i + k] * (double)m[4 * j + k];
            if (fabs(dot - (i == j ? 1.0 : 0.0)) > ROTATION_ERROR) return "its view matrix is not a rotation";
        }
    const double determinant = (double)m[0] * ((double)m[5] * (double)m[10] - (double)m[6] * (double)m[9]) -
                               (double)m[4] * ((double)m[1] * (double)m[10] - (double)m[2] * (double)m[9]) +
                               (double)m[8] * ((double)m[1] * (double)m[6] - (double)m[2] * (double)m[5]);
    return sign * determinant > 0.0 ? NULL : "its view matrix mirrors the world";
}

// The grid of the water is placed by the lens, and its columns must not come and go with the rounding of a float
// matrix: so the lens has whole steps of 1e-5 degrees, and the sides of the picture where they fit. Its guard is 1.1
// degrees.
static double stepped(double degrees) { return floor(degrees * 1e5 + 0.5) / 1e5; }

// Rows of a rotation: right, up, backward in world axes. A camera that looks along +z has its z row turned.
static void measure_turn(view_lens *lens, const bolan_mat4 *view) {
    const float *m = view->m;
    const double forward[3] = {-(double)m[2], -(double)m[6], -(double)m[10]};
    lens->pitch_deg = stepped(bolan_degrees(atan2(forward[2], hypot(forward[0], forward[1]))));
    const bool level = hypot(forward[0], forward[1]) > 1e-4;
    // Where the axis is vertical, roll is zero and the heading is that of the picture's right edge.
    const double heading = level ? atan2(forward[0], forward[1]) : atan2(-(double)m[4], (double)m[0]);
    lens->heading_deg = stepped(bolan_degrees(heading < 0.0 ? heading + 2.0 * BOLAN_PI : heading));
    const double side[3] = {cos(heading), -sin(heading), 0.0}; // right of the heading
    const double right = (double)m[0] * side[0] + (double)m[4] * side[1];
    const double sinks = (double)m[1] * side[0] + (double)m[5] * side[1];
    lens->roll_deg = level ? stepped(bolan_degrees(atan2(sinks, right))) : 0.0;
}

static double near_plane(double height, bool zero_to_one) {
    // Reversed-Z keeps its precision whatever the near plane; without clip control the depth is a fixed-point number.
    return fmin(fmax(fabs(height) * 0.04, zero_to_one ? 0.02 : 0.4), 20.0);
}

// The part of the whole picture that is drawn: the same directions, other edges.
static void cut_tile(render_view *v, const bolan_view *from) {
    bolan_mat4 *p = &v->projection;
    const double w = (double)from->tile.whole_width / from->width, h = (double)from->tile.whole_height / from->height;
    p->m[8] = (float)((double)p->m[8] * w - (w - 2.0 * from->tile.x / from->width - 1.0));
    p->m[9] = (float)((double)p->m[9] * h - (h - 2.0 * from->tile.y / from->height - 1.0));
    p->m[0] = (float)((double)p->m[0] * w);
    p->m[5] = (float)((double)p->m[5] * h);
    v->tile_corner = (bolan_vec2){(float)from->tile.x, (float)from->tile.y};
    v->tile_share = (bolan_vec2){(float)(1.0 / w), (float)(1.0 / h)};
}

static bool is_tile(const bolan_view *v) { return v->tile.whole_width != 0 || v->tile.whole_height != 0; }

static const char *tile_problem(const bolan_view *v) {
    if (!is_tile(v)) return NULL;
    const bool inside = (uint64_t)v->tile.x + v->width <= v->tile.whole_width &&
                        (uint64_t)v->tile.y + v->height <= v->tile.whole_height;
    return inside ? NULL : "its tile reaches beyond the whole picture";
}

const char *bolan_view_problem(const bolan_view *from) {
    if (!is_finite(&from->view) || !is_finite(&from->projection) || !isfinite(from->eye.x) || !isfinite(from->eye.y) ||
        !isfinite(from->eye.z))
        return "its matrices or its eye are not finite";
    const char *problem = projection_problem(from->projection.m);
    if (problem == NULL) problem = rotation_problem(from->view.m, from->projection.m[11] < 0.0f ? 1.0 : -1.0);
    return problem != NULL ? problem : tile_problem(from);
}

static double aspect_of(const bolan_mat4 *p, const bolan_view *from) {
    const double aspect = (double)p->m[5] / (double)p->m[0];
    const double sides =
        is_tile(from) ? (double)from->tile.whole_width / from->tile.whole_height : (double)from->width / from->height;
    return fabs(aspect / sides - 1.0) < 1e-6 ? sides : aspect;
}

void bolan_view_open(render_view *v, frame *f, const bolan_view *from, bool zero_to_one) {
    const float *host = from->projection.m;
    const float scale = 1.0f / fabsf(host[11]), side = host[11] < 0.0f ? 1.0f : -1.0f; // side: of the camera's z axis
    v->frame = f;
    v->eye = from->eye;
    v->view = from->view;
    v->view.m[12] = v->view.m[13] = v->view.m[14] = 0.0f;
    v->view.m[3] = v->view.m[7] = v->view.m[11] = 0.0f;
    v->view.m[15] = 1.0f;
    for (int i = 0; i < 3; ++i) v->view.m[4 * i + 2] *= side;
    measure_turn(&v->lens, &v->view);
    v->near_distance = near_plane(from->eye.z - f->level, zero_to_one);
    v->projection = bolan_m4_projection(1.0, 1.0, v->near_distance, zero_to_one);
    v->projection.m[0] = host[0] * scale;
    v->projection.m[5] = host[5] * scale;
    v->projection.m[8] = host[8] * scale * side;
    v->projection.m[9] = host[9] * scale * side;
    v->lens.fov_y = bolan_radians(stepped(bolan_degrees(2.0 * atan(1.0 / (double)v->projection.m[5]))));
    v->lens.aspect = aspect_of(&v->projection, from);
    v->lens.shift_x = (double)v->projection.m[8];
    v->lens.shift_y = (double)v->projection.m[9];
    v->lens.pixel_height = is_tile(from) ? from->tile.whole_height : from->height;
    v->tile_corner = (bolan_vec2){0.0f, 0.0f};
    v->tile_share = (bolan_vec2){1.0f, 1.0f};
    if (is_tile(from)) cut_tile(v, from);
    v->projection.m[8] -= 2.0f * from->jitter.x / (float)from->width;
    v->projection.m[9] -= 2.0f * from->jitter.y / (float)from->height;
    v->zero_to_one = zero_to_one;
    v->width = from->width;
    v->height = from->height;
    v->progressive = from->progressive;
    v->mirror = bolan_m4_identity();
    v->shade_columns = v->pixel_scale = 1.0f;
}

void bolan_view_set_near(render_view *v, double distance) {
    const bolan_mat4 p = bolan_m4_projection(1.0, 1.0, distance, v->zero_to_one);
    v->near_distance = distance;
    v->projection.m[10] = p.m[10];
    v->projection.m[14] = p.m[14];
}

void bolan_view_shift(render_view *v, bolan_vec2 pixels) {
    v->projection.m[8] -= 2.0f * pixels.x / (float)v->width;
    v->projection.m[9] -= 2.0f * pixels.y / (float)v->height;
}

double bolan_view_row(const render_view *v, double t) {
    return (0.5 + 0.5 * (t * (double)v->projection.m[5] - (double)v->projection.m[9])) * v->height;
}

// ---- the uniform block ----------------------------------------------------------------------------------------------

static void fill_camera(render_view *v) {
    view_block *b = &v->block;
    // A mirrored direction has no translation, and the sky is drawn by directions.
    bolan_mat4 turn = v->mirror;
    turn.m[12] = turn.m[13] = turn.m[14] = 0.0f;
    const bolan_mat4 camera = bolan_m4_mul(v->projection, v->view);
    b->view_projection = bolan_m4_mul(camera, v->mirror);
    b->inverse_view_projection = bolan_m4_mul(turn, bolan_m4_inverse(camera));
    b->radians_per_pixel = (float)(2.0 * tan(0.5 * v->lens.fov_y) / v->lens.pixel_height);
    b->near_distance = (float)v->near_distance;
    b->clip_zero_to_one = v->zero_to_one ? 1.0f : 0.0f;
}

static bolan_vec2 wrapped(bolan_dvec2 place, bolan_dvec2 drift) {
    return (bolan_vec2){bolan_reduced(place.x - drift.x, WORLD_WRAP), bolan_reduced(place.y - drift.y, WORLD_WRAP)};
}

static void fill_eye(render_view *v) {
    view_block *b = &v->block;
    const frame *f = v->frame;
    const double x = v->eye.x, y = v->eye.y;
    const bolan_dvec2 drift = bolan_frame_drift(f), water = {x - drift.x, y - drift.y};
    b->water_wrapped = (bolan_vec2){bolan_reduced(water.x, WORLD_WRAP), bolan_reduced(water.y, WORLD_WRAP)};
    b->eye_wrapped = (bolan_vec2){bolan_reduced(x, WORLD_WRAP), bolan_reduced(y, WORLD_WRAP)};
    b->eye_wrapped_wide = (bolan_vec2){bolan_reduced(x, WORLD_WRAP_WIDE), bolan_reduced(y, WORLD_WRAP_WIDE)};
    b->eye_height = (float)(v->eye.z - v->frame->level);
    const bolan_dvec2 foam = bolan_frame_foam_drift(f), eddies = bolan_frame_eddy_drift(f);
    b->foam_wrapped = wrapped(water, foam);
    b->eddies_wrapped = wrapped(water, eddies);
    b->streak_place = bolan_frame_streaks((bolan_dvec3){water.x, water.y, v->eye.z}, f->wind_to, f->block.streak_scale);
    b->streak_place.y = bolan_reduced((double)b->streak_place.y - bolan_frame_windrow_drift(f), 1.0);
    b->surf_phase = bolan_reduced(f->surf_periods - f->surf_wave.x * x - f->surf_wave.y * y, 1.0);
    b->caustic_place = v->caustic_place;
    b->caustic_spread = v->caustic_spread;
    b->caustic_near_place = v->caustic_near_place;
    b->caustic_near_blur = v->caustic_near_blur;
    b->cloud_offset = v->light.cloud_offset;
    b->eye_above_clouds = v->light.above_clouds ? 1.0f : 0.0f;
    b->sun_light = v->light.sun;
    b->sky_light = v->light.sky;
    b->exposure = v->light.exposure;
}

void bolan_view_fill(render_view *v) {
    view_block *b = &v->block;
    fill_camera(v);
    fill_eye(v);
    bolan_view_block_resize(b, v->width, v->height);
    b->eye_under_water = v->under ? 1.0f : 0.0f;
    b->mirrored_under_water = v->mirrored_under ? 1.0f : 0.0f;
    b->under_fog = v->fog ? 1.0f : 0.0f;
    b->shade_columns = v->shade_columns;
    b->tile_corner = v->tile_corner;
    b->tile_share = v->tile_share;
    b->clip_side = v->clip.side;
    b->clip_elevation = v->clip.elevation;
    b->refraction_raise = v->clip.raise;
    b->refraction_mode = v->clip.mode;
}

void bolan_view_use(render_view *v) {
    bolan_view_fill(v);
    bolan_blocks_upload_view(v->uniforms, &v->block);
}

// ---- boxes ----------------------------------------------------------------------------------------------------------

static bool outside_plane(const float low[3], const float high[3], float x, float y, float z, float w) {
    const float most =
        w + x * (x > 0.0f ? high[0] : low[0]) + y * (y > 0.0f ? high[1] : low[1]) + z * (z > 0.0f ? high[2] : low[2]);
    return most < 0.0f;
}

bool bolan_outside_frustum(const bolan_mat4 *view_projection, const float low[3], const float high[3]) {
    const float *m = view_projection->m;
    for (int row = 0; row < 2; row++)
        for (int sign = -1; sign <= 1; sign += 2) {
            const float s = (float)sign * 0.99f; // the samples of one picture shift it by parts of a pixel
            if (outside_plane(low, high, m[3] + s * m[row], m[7] + s * m[4 + row], m[11] + s * m[8 + row],
                              m[15] + s * m[12 + row]))
                return true;
        }
    return outside_plane(low, high, m[3], m[7], m[11], m[15]); // behind the eye
}
