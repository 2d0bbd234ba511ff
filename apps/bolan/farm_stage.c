// SPDX-License-Identifier: MIT
// See farm_stage.h.
#include "farm_stage.h"

#include "session.h"
#include "shot.h"
#include "tiles.h"

#include <stdlib.h>
#include <string.h>

enum { MOST_CHANNELS = 11 };

struct farm_stage {
    const farm_job *job;
    bolan_context *context;
    bolan_renderer *renderer;
    tiles tiles;
    bolan_world *world;
    bolan_scene scene; // which the world was loaded from
    uint8_t *rgb;
    float *linear, *distance, *planes; // NULL where no layer is asked for
};

farm_stage *farm_stage_open(const farm_job *job) {
    const size_t pixels = (size_t)job->width * job->height;
    const bool layers = (job->outputs & FARM_LAYERS) != 0;
    bolan_renderer_desc desc = bolan_renderer_desc_default();
    desc.quality = job->quality;
    desc.backend = job->backend;
    desc.restore = BOLAN_RESTORE_NONE; // the context is this program's
    farm_stage *s = calloc(1, sizeof *s);
    if (!s) return failure("no memory to draw"), NULL;
    s->job = job;
    s->rgb = malloc(pixels * 3);
    s->linear = layers ? malloc(pixels * 3 * sizeof(float)) : NULL;
    s->distance = layers ? malloc(pixels * sizeof(float)) : NULL;
    s->planes = layers ? malloc(pixels * 3 * sizeof(float)) : NULL;
    bool ok = s->rgb && (!layers || (s->linear && s->distance && s->planes));
    if (!ok) failure("no memory for a picture of %ux%u", (unsigned)job->width, (unsigned)job->height);
    ok = ok && !bolan_context_create(BOLAN_GL_CORE, &s->context) && !bolan_renderer_create(&desc, &s->renderer) &&
         tiles_open(&s->tiles, s->renderer, job->width, job->height, job->tile, layers);
    if (!ok) farm_stage_close(&s);
    return s;
}

void farm_stage_close(farm_stage **stage) {
    farm_stage *s = *stage;
    if (!s) return;
    tiles_close(&s->tiles);
    bolan_renderer_destroy(&s->renderer);
    bolan_context_destroy(&s->context);
    bolan_world_destroy(&s->world);
    free(s->rgb), free(s->linear), free(s->distance), free(s->planes);
    free(s);
    *stage = NULL;
}

// ---- the world ------------------------------------------------------------------------------------------------------

// Whether two scenes differ in time and camera alone, which a world can change. Padding may make equal scenes differ:
// then the world is loaded once too often.
static bool same_world(const bolan_scene *a, const bolan_scene *b) {
    bolan_scene moved = *a;
    moved.time = b->time;
    moved.camera = b->camera;
    return memcmp(&moved, b, sizeof moved) == 0;
}

static bool use_scene(farm_stage *s, const bolan_scene *scene) {
    if (!s->world || !same_world(&s->scene, scene)) {
        bolan_world_destroy(&s->world);
        if (bolan_world_load_scene(scene, &s->world)) return false;
        s->scene = *scene;
        bolan_renderer_bake(s->renderer); // nothing that was baked for another sun
    }
    bolan_world_set_camera(s->world, &scene->camera);
    bolan_world_settle(s->world, scene->time);
    return !session_check_camera(s->world);
}

// ---- files ----------------------------------------------------------------------------------------------------------

static bool write_layers(farm_stage *s, const char *path) {
    const farm_job *j = s->job;
    const size_t pixels = (size_t)j->width * j->height;
    bolan_exr_channel channels[MOST_CHANNELS];
    uint32_t count = 0;
    if (j->outputs & FARM_LINEAR) {
        static const char *const names[] = {"R", "G", "B"};
        shot_planes(s->linear, pixels, s->planes);
        for (size_t c = 0; c < 3; c++) channels[count++] = (bolan_exr_channel){names[c], s->planes + c * pixels};
    }
    if (j->outputs & FARM_DISTANCE) channels[count++] = (bolan_exr_channel){"Z", s->distance};
    return bolan_exr_write(path, j->width, j->height, channels, count) == BOLAN_OK;
}

static bool write_files(farm_stage *s, uint32_t frame) {
    const farm_job *j = s->job;
    char path[BOLAN_PATH_MAX];
    if ((j->outputs & FARM_PICTURE) &&
        (!farm_job_file(j, frame, FARM_FILE_PICTURE, path) || bolan_png_write(path, j->width, j->height, s->rgb)))
        return false;
    return !(j->outputs & FARM_LAYERS) || (farm_job_file(j, frame, FARM_FILE_LAYERS, path) && write_layers(s, path));
}

bool farm_stage_draw(farm_stage *s, uint32_t frame, farm_result *result) {
    bolan_scene scene;
    if (farm_job_scene(s->job, frame, &scene) || !use_scene(s, &scene)) return false;
    const bolan_view view = shot_view(s->world, scene.time, s->job->width, s->job->height, s->job->samples);
    tiles_draw(&s->tiles, s->world, &view, s->rgb, s->linear, s->distance);
    if (!write_files(s, frame)) return false;
    if (farm_record(s->job, frame, &scene, true, result)) return true;
    return failure("frame %u: its record cannot be written", (unsigned)frame), false;
}
