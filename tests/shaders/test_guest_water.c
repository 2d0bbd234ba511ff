// SPDX-License-Identifier: MIT
// The water in a host's frame, and its fields in a host's programs: whatever state the host has set, the water is the
// same, and each call leaves all of it as it was.
#include "guest_host.h"

// A frame of the host's with its light: a cube map, a mask, a polygon.
typedef struct guest_frame {
    GLuint color, depth, framebuffer, cube, mask;
    bolan_dvec2 corners[4];
    bolan_water water;
    bolan_lighting lighting;
    bolan_view view;
    bolan_host host;
} guest_frame;

static GLuint plain_texture(GLint format, GLenum components, GLenum type) {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexImage2D(GL_TEXTURE_2D, 0, format, WIDTH, HEIGHT, 0, components, type, NULL);
    return name; // with the filter that a texture has at first, which wants levels
}

static void open_frame(guest_frame *f, const rig *r) {
    const bolan_dvec3 e = r->scene.camera.position;
    memset(f, 0, sizeof *f);
    f->color = plain_texture(GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE);
    f->depth = plain_texture(GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT);
    f->mask = plain_texture(GL_R8, GL_RED, GL_UNSIGNED_BYTE);
    glGenTextures(1, &f->cube);
    glBindTexture(GL_TEXTURE_CUBE_MAP, f->cube);
    for (GLenum face = 0; face < 6; face++)
        glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_RGBA8, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
    glGenFramebuffers(1, &f->framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, f->framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, f->color, 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, f->depth, 0);
    for (int i = 0; i < 4; i++)
        f->corners[i] = (bolan_dvec2){e.x + (i == 0 || i == 3 ? -40.0 : 40.0), e.y + (i < 2 ? -90.0 : 90.0)};
    f->water = bolan_water_default();
    f->water.sea = bolan_world_water(r->world)->sea;
    f->lighting = bolan_lighting_from_scene(&r->scene);
    f->lighting.environment.cube = f->cube;
    f->lighting.environment.sun_irradiance = bolan_v3(1.0f, 1.0f, 1.0f);
    f->view = bolan_view_from_camera(&r->scene.camera, WIDTH, HEIGHT);
    f->view.framebuffer = f->framebuffer;
    f->host =
        (bolan_host){.color = f->color, .depth = f->depth, .mask = f->mask, .bounds = f->corners, .bounds_count = 4};
}

static void close_frame(guest_frame *f) {
    glDeleteTextures(1, &f->color);
    glDeleteTextures(1, &f->depth);
    glDeleteTextures(1, &f->cube);
    glDeleteTextures(1, &f->mask);
    glDeleteFramebuffers(1, &f->framebuffer);
}

// Whatever state it finds, the same water; the clears are the host's own and so made before.
static void clear_frame(const guest_frame *f) {
    glBindFramebuffer(GL_FRAMEBUFFER, f->framebuffer);
    glClearColor(0.2f, 0.3f, 0.4f, 1.0f);
    glClearDepthf(0.0f); // the depth of bolan_m4_projection() is reversed
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

static void draw_in_frame(rig *r, guest_frame *f) {
    f->lighting.environment.serial++; // the cube is read again, amid the host's state
    bolan_renderer_prepare(r->renderer, &f->water, &f->lighting);
    bolan_renderer_draw_water(r->renderer, &f->view, &f->host);
}

static void water_in_a_frame_changes_no_state(void **state) {
    (void)state;
    static snapshot before;
    static uint8_t calm[PIXELS * 3], wild[PIXELS * 3], sky[PIXELS * 3];
    host h;
    rig r;
    guest_frame f;
    open_low(&r);
    open_host(&h);
    open_frame(&f, &r);
    clear_frame(&f);
    read_bytes(f.framebuffer, WIDTH, HEIGHT, sky);
    draw_in_frame(&r, &f);
    read_bytes(f.framebuffer, WIDTH, HEIGHT, calm);
    assert_memory_not_equal(calm, sky, sizeof sky);
    clear_frame(&f);
    set_apart(&h);
    assert_true(watch_is_clean("the host itself"));
    take(&before);
    draw_in_frame(&r, &f);
    assert_same(&before, "prepare and draw_water");
    bolan_renderer_read_rgb8(r.renderer, f.framebuffer, WIDTH, HEIGHT, wild);
    assert_memory_equal(wild, calm, sizeof wild);
    close_frame(&f);
    close_rig(&r);
    close_host(&h);
}

// bind_fields leaves its textures and its block, and nothing else.
static void fields_touch_their_units_and_slot_alone(void **state) {
    (void)state;
    static snapshot before, after;
    const uint32_t unit = 6, slot = 5;
    host h;
    rig r;
    open_low(&r);
    open_host(&h);
    set_apart(&h);
    take(&before);
    bolan_renderer_bind_fields(r.renderer, bolan_world_water(r.world), (bolan_dvec3){0.0, 0.0, 2.0}, unit, slot);
    take(&after);
    assert_int_equal(before.count, after.count);
    int changed = 0;
    for (int i = 0; i < before.count; i++) {
        const entry *a = &before.entries[i], *b = &after.entries[i];
        int index = -1;
        assert_string_equal(a->name, b->name);
        if (a->value == b->value) continue;
        changed++;
        sscanf(strchr(a->name, '[') + 1, "%d", &index);
        const bool texture = strstr(a->name, "TEXTURE") || strstr(a->name, "SAMPLER");
        const bool block = strncmp(a->name, "GL_UNIFORM_BUFFER[", 18) == 0 && index == (int)slot;
        if (!block && !(texture && index >= (int)unit && index < (int)unit + BOLAN_FIELDS_UNITS))
            fail_msg("%s was %g and is %g", a->name, a->value, b->value);
    }
    assert_in_range(changed, 4, 16);
    close_rig(&r);
    close_host(&h);
}

int main(void) {
    const struct CMUnitTest tests[] = {IN_BOTH_APIS(water_in_a_frame_changes_no_state),
                                       IN_BOTH_APIS(fields_touch_their_units_and_slot_alone)};
    return cmocka_run_group_tests_name("water among a host's state", tests, NULL, NULL);
}
