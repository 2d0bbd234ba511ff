// SPDX-License-Identifier: MIT
// The pictures that some optics look up: the world above the water mirrored in its plane, and the world below it raised as
// refraction raises it (Ma, Zhu & Gong 2006, section 2.2; there P-buffers, here textures of the picture's size). The water plane
// stays where it is in both, so that a place of the water finds what it mirrors and what lies under it at its own place in them.
#include "frame.h"

struct pass_mirror {
    gl_texture reflection, refraction, depth; // one depth serves both: they are drawn one after the other
    gl_target reflection_target, refraction_target;
};

bolan_result pass_mirror_create(pass_mirror **out) {
    *out = bolan_allocate(sizeof **out);
    return *out != NULL ? BOLAN_OK : BOLAN_ERROR_MEMORY;
}

static void free_pictures(pass_mirror *p) {
    gl_target_free(&p->reflection_target);
    gl_target_free(&p->refraction_target);
    gl_texture_free(&p->reflection);
    gl_texture_free(&p->refraction);
    gl_texture_free(&p->depth);
}

void pass_mirror_destroy(pass_mirror **pass) {
    if (pass == NULL || *pass == NULL) return;
    free_pictures(*pass);
    bolan_release(*pass, sizeof **pass);
    *pass = NULL;
}

bool pass_mirror_fit(pass_mirror *p, uint32_t width, uint32_t height) {
    if (p->refraction_target.id != 0 && p->depth.width == width && p->depth.height == height) return true;
    free_pictures(p);
    gl_texture_desc color = {
        .format = GL_FMT_RGBA16F, .width = width, .height = height, .filter = GL_FILTER_LINEAR, .wrap = GL_WRAP_CLAMP};
    gl_texture_desc depth = color;
    depth.format = GL_FMT_DEPTH32F;
    depth.filter = GL_FILTER_NEAREST;
    const gl_texture *reflection = &p->reflection, *refraction = &p->refraction;
    return gl_texture_create(&color, &p->reflection) == BOLAN_OK &&
           gl_texture_create(&color, &p->refraction) == BOLAN_OK && gl_texture_create(&depth, &p->depth) == BOLAN_OK &&
           gl_target_create(&reflection, 1, &p->depth, -1, 0, &p->reflection_target) == BOLAN_OK &&
           gl_target_create(&refraction, 1, &p->depth, -1, 0, &p->refraction_target) == BOLAN_OK;
}

// The mirror z -> -2 h - z about the plane h below the eye, before the camera (paper A: S = I - 2 n n^T). Directions, which the
// sky is drawn by, have no translation.
frame pass_mirror_reflect(pass_mirror *p, const frame *f) {
    frame m = *f;
    bolan_mat4 mirror = bolan_m4_identity(), turn = bolan_m4_identity();
    mirror.m[10] = turn.m[10] = -1.0f;
    mirror.m[14] = -2.0f * f->uniforms.eye.z;
    m.uniforms.view_projection = bolan_m4_mul(f->uniforms.view_projection, mirror);
    m.uniforms.inverse_view_projection = bolan_m4_mul(turn, f->uniforms.inverse_view_projection);
    m.uniforms.clip = (bolan_vec4){1.0f, 0.0f, 1.0f, 0.0f};
    m.hdr = p->reflection_target;
    return m;
}

frame pass_mirror_refract(pass_mirror *p, const frame *f) {
    frame m = *f;
    m.uniforms.clip = (bolan_vec4){-1.0f, 0.0f, 0.75f, 1.0f};
    m.hdr = p->refraction_target;
    return m;
}

void pass_mirror_bind(const pass_mirror *p) {
    gl_texture_bind(&p->reflection, UNIT_REFLECTION);
    gl_texture_bind(&p->refraction, UNIT_REFRACTION);
}
