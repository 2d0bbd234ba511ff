// SPDX-License-Identifier: MIT
// See motion.h.
#include "motion.h"

#include "renderer.h"

static bool fit(motion_pass *m) {
    bolan_result result = BOLAN_OK;
    if (m->camera.stem[0] == '\0') result = bolan_gl_program_create("motion", NULL, &m->camera);
    if (m->object.stem[0] == '\0' && result == BOLAN_OK)
        result = bolan_gl_program_create("surfaces", "OBJECT 1\nMOTION 1\n", &m->object);
    return m->camera.id != 0 && m->object.id != 0;
}

// Rows that take a place relative to the eye of `to` to w times its pixel, and to w, in the camera of `from` without
// jitter. The rectangle is that of `to`.
static void fill_camera(frame *f, const bolan_view *to, const bolan_view *from, float rows[12]) {
    bolan_view steady = *to;
    render_view v;
    steady.eye = from->eye;
    steady.view = from->view;
    steady.projection = from->projection;
    steady.jitter = (bolan_vec2){0.0f, 0.0f};
    bolan_view_open(&v, f, &steady, true);
    const bolan_mat4 camera = bolan_m4_mul(v.projection, v.view);
    const double gone[3] = {to->eye.x - from->eye.x, to->eye.y - from->eye.y, to->eye.z - from->eye.z};
    const double scale[3] = {0.5 * to->width, 0.5 * to->height, 1.0};
    static const int row[3] = {0, 1, 3};
    for (int i = 0; i < 3; i++) {
        double last = (double)camera.m[12 + row[i]];
        for (int k = 0; k < 3; k++) {
            const double m = (double)camera.m[4 * k + row[i]];
            rows[4 * i + k] = (float)(scale[i] * m);
            last += m * gone[k];
        }
        rows[4 * i + 3] = (float)(scale[i] * last);
    }
}

static void set_camera(bolan_renderer *r, const gl_program *program, const bolan_view *to, const motion_request *q) {
    float now[12], before[12];
    fill_camera(&r->frame, to, to, now);
    fill_camera(&r->frame, to, q->before != NULL ? q->before : to, before);
    bolan_gl_program_vec4_array(program, "camera_now", now, 3);
    bolan_gl_program_vec4_array(program, "camera_before", before, 3);
    bolan_gl_program_vec2(program, "origin", (float)q->x, (float)q->y);
}

void bolan_motion_draw(bolan_renderer *r, render_view *v, const bolan_view *to, const motion_request *q) {
    const frame *f = v->frame;
    const bolan_host *host = q->host;
    const bool masked = host != NULL && host->mask != 0;
    if (!fit(&r->motion_pass)) return;
    bolan_gl_target_bind_external(q->framebuffer, q->x, q->y, v->width, v->height);
    bolan_gl_set_state(&(gl_state){.color_write = true});
    const gl_program *program = bolan_pass_water_use_motion(r->water, v, q->time);
    if (program == NULL) bolan_gl_program_use(program = &r->motion_pass.camera);
    set_camera(r, program, to, q);
    const bool scene = host != NULL || f->behind;
    bolan_gl_program_vec4(program, "wanted",
                          (bolan_vec4){scene ? 1.0f : 0.0f, host != NULL ? 1.0f : 0.0f, masked ? 1.0f : 0.0f, 0.0f});
    if (masked) bolan_gl_program_vec2(program, "mask_origin", (float)host->x, (float)host->y);
    bolan_gl_texture_bind(v->hdr_depth, UNIT_OWN);
    bolan_gl_texture_bind(&r->targets.behind_depth, UNIT_SCENE_DEPTH);
    if (masked) bolan_gl_guest_texture_bind(host->mask, UNIT_OWN + 2, &r->host.sampler);
    bolan_gl_draw_fullscreen();
    if (masked) bolan_gl_guest_texture_bind(0, UNIT_OWN + 2, NULL);
    if (host != NULL || f->scene == NULL || f->scene->object_count == 0) return;
    bolan_gl_program_use(&r->motion_pass.object);
    set_camera(r, &r->motion_pass.object, to, q);
    bolan_pass_objects_draw_motion(r->models, v, &r->motion_pass.object, q->time);
}

void bolan_motion_draw_asked(bolan_renderer *r, render_view *v, const bolan_view *to, const bolan_host *host) {
    const motion_request q = {to->motion.framebuffer, to->x, to->y, to->motion.before, to->motion.time, host};
    if (to->motion.framebuffer == 0) return;
    bolan_motion_draw(r, v, to, &q);
}

bolan_result bolan_motion_reload(motion_pass *m) {
    bolan_result result = m->camera.id != 0 ? bolan_gl_program_reload(&m->camera) : BOLAN_OK;
    if (result == BOLAN_OK && m->object.id != 0) result = bolan_gl_program_reload(&m->object);
    return result;
}

void bolan_motion_free(motion_pass *m) {
    bolan_gl_program_free(&m->camera);
    bolan_gl_program_free(&m->object);
}
