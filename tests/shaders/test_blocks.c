// SPDX-License-Identifier: MIT
// The uniform blocks: OpenGL and C give each member the same offset.
#include "gl_support.h"

#include <epoxy/gl.h>
#include <stddef.h>

#include "probe.h"
#include "render/blocks.h"
#include "render/water_block.h"

typedef struct member {
    const char *name;
    size_t offset;
} member;

// The members as the C compiler sees them: the list of the shared file once more, by hand, so that a member that moves
// in one language alone is found.
#define FRAME(name) \
    { #name, offsetof(frame_block, name) }
#define VIEW(name) \
    { #name, offsetof(view_block, name) }
#define WATER(name) \
    { #name, offsetof(water_block, name) }
#define WATER_ARRAY(name) \
    { #name "[0]", offsetof(water_block, name) }
static const member frame_members[] = {FRAME(sun_direction),
                                       FRAME(radiance_unit),
                                       FRAME(water_reflectance),
                                       FRAME(water_index),
                                       FRAME(water_attenuation),
                                       FRAME(foam_strength),
                                       FRAME(wind_direction),
                                       FRAME(cloud_cover),
                                       FRAME(cloud_base),
                                       FRAME(surf_wave),
                                       FRAME(surf_time),
                                       FRAME(visibility),
                                       FRAME(streak_scale),
                                       FRAME(caustic_turn),
                                       FRAME(caustic_travel),
                                       FRAME(caustic_strength),
                                       FRAME(water_level),
                                       FRAME(earth_radius),
                                       FRAME(wind_speed),
                                       FRAME(gust_travel),
                                       FRAME(given_haze_radiance),
                                       FRAME(haze_given),
                                       FRAME(given_haze_extinction),
                                       FRAME(frame_padding_end)};
static const member view_members[] = {VIEW(view_projection),
                                      VIEW(inverse_view_projection),
                                      VIEW(eye_wrapped),
                                      VIEW(eye_wrapped_wide),
                                      VIEW(viewport_size),
                                      VIEW(pixel_size),
                                      VIEW(eye_height),
                                      VIEW(radians_per_pixel),
                                      VIEW(near_distance),
                                      VIEW(clip_zero_to_one),
                                      VIEW(eye_under_water),
                                      VIEW(under_fog),
                                      VIEW(mirrored_under_water),
                                      VIEW(shade_columns),
                                      VIEW(clip_side),
                                      VIEW(clip_elevation),
                                      VIEW(refraction_raise),
                                      VIEW(refraction_mode),
                                      VIEW(sun_light),
                                      VIEW(eye_above_clouds),
                                      VIEW(sky_light),
                                      VIEW(surf_phase),
                                      VIEW(exposure),
                                      VIEW(caustic_near_blur),
                                      VIEW(cloud_offset),
                                      VIEW(streak_place),
                                      VIEW(caustic_place),
                                      VIEW(tile_corner),
                                      VIEW(tile_share),
                                      VIEW(water_wrapped),
                                      VIEW(caustic_spread),
                                      VIEW(foam_wrapped),
                                      VIEW(eddies_wrapped),
                                      VIEW(caustic_near_place)};
static const member water_members[] = {
    WATER_ARRAY(cascade_bound), WATER_ARRAY(cascade_tile),   WATER_ARRAY(cascade_band), WATER_ARRAY(cascade_lift),
    WATER_ARRAY(warp_wave_of),  WATER_ARRAY(wave_component), WATER_ARRAY(exp_slope),    WATER_ARRAY(shore_level),
    WATER_ARRAY(ripple_tile),   WATER_ARRAY(ripple_size),    WATER_ARRAY(layer_wave),   WATER_ARRAY(layer_area),
    WATER_ARRAY(layer_extent),  WATER_ARRAY(nested_level),   WATER(nested_centre),      WATER(nested_eye),
    WATER(foam_weights),        WATER(grid_reach),           WATER(grid_azimuth),       WATER(wave_slopes),
    WATER(wave_slope_share),    WATER(slope_total),          WATER(height_deviation),   WATER(grid_cells),
    WATER(warp_at_eye),         WATER(significant_height),   WATER(peak_length),        WATER(shore_height),
    WATER(choppiness),          WATER(exp_sharpness),        WATER(exp_mean),           WATER(mesh_lift),
    WATER(look_distortion),     WATER(look_blend),           WATER(look_shininess),     WATER(look_ambient),
    WATER(look_diffuse),        WATER(look_specular),        WATER(look_show),          WATER(look_effects),
    WATER(cascade_count),       WATER(wave_count),           WATER(shore_present),      WATER(layer_count),
    WATER(warp_count)};
#define COUNT(a) (GLint)(sizeof(a) / sizeof((a)[0]))

static void compare(GLuint program, const char *block, GLuint slot, const member *members, GLint count, size_t size) {
    const GLuint index = glGetUniformBlockIndex(program, block);
    GLint binding = -1, bytes = 0, active = 0;
    assert_int_not_equal(index, GL_INVALID_INDEX);
    glGetActiveUniformBlockiv(program, index, GL_UNIFORM_BLOCK_BINDING, &binding);
    glGetActiveUniformBlockiv(program, index, GL_UNIFORM_BLOCK_DATA_SIZE, &bytes);
    glGetActiveUniformBlockiv(program, index, GL_UNIFORM_BLOCK_ACTIVE_UNIFORMS, &active);
    assert_int_equal(binding, slot);
    assert_int_equal(bytes, size);
    assert_int_equal(active, count);
    for (GLint i = 0; i < count; ++i) {
        GLuint at = GL_INVALID_INDEX;
        GLint offset = -1;
        glGetUniformIndices(program, 1, &members[i].name, &at);
        assert_int_not_equal(at, GL_INVALID_INDEX);
        glGetActiveUniformsiv(program, 1, &at, GL_UNIFORM_OFFSET, &offset);
        if ((size_t)offset != members[i].offset) print_message("%s.%s\n", block, members[i].name);
        assert_int_equal(offset, members[i].offset);
    }
}

static void set(const gl_program *program, const void *context) {
    compare(program->id, "Frame", BLOCK_FRAME, frame_members, COUNT(frame_members), sizeof(frame_block));
    compare(program->id, "View", BLOCK_VIEW, view_members, COUNT(view_members), sizeof(view_block));
    compare(program->id, "Water", BLOCK_WATER, water_members, COUNT(water_members), sizeof(water_block));
    block_buffers *buffers = (block_buffers *)(uintptr_t)context;
    const block_values values = {.frame.earth_radius = 3.0f, .view.surf_phase = 5.0f};
    const water_block water = {.height_deviation = 7.0f};
    water_block_buffers water_buffers; // gone with the test's context
    assert_int_equal(bolan_water_blocks_create(&water_buffers), BOLAN_OK);
    bolan_water_blocks_upload(&water_buffers, &water);
    assert_int_equal(bolan_blocks_create(buffers), BOLAN_OK);
    bolan_blocks_upload(buffers, &values);
}

static void members_have_the_same_offset_in_both_languages(void **state) {
    (void)state;
    block_buffers buffers = {0};
    float in[1][4] = {{1.0f}}, out[1][4];
    probe_run_with("#include \"common/frame.glsl\"\n#include \"common/water_block.glsl\"",
                   "vec4 probe(vec4 x) { return x.x * vec4(earth_radius, surf_phase, eye_height, height_deviation); }",
                   NULL, set, &buffers, in, 1, out);
    assert_near(out[0][0], 3.0, 0.0);
    assert_near(out[0][1], 5.0, 0.0);
    assert_near(out[0][2], 0.0, 0.0);
    assert_near(out[0][3], 7.0, 0.0);
    bolan_blocks_free(&buffers);
}

int main(void) {
    const struct CMUnitTest tests[] = {IN_BOTH_APIS(members_have_the_same_offset_in_both_languages)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
