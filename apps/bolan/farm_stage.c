// SPDX-License-Identifier: MIT
// See farm_stage.h.
#include "farm_stage.h"

#include "session.h"
#include "shot.h"
#include "tiles.h"

#include <stdlib.h>
#include <string.h>

_Static_assert(sizeof(bolan_vec3) == 3 * sizeof(float), "a plane is three floats a pixel");
enum { MOST_CHANNELS = 11, PLANES = 10 }; // PLANES: all channels but the distance

struct farm_stage {
    const farm_job *job;
    bolan_context *context;
    bolan_renderer *renderer;
    tiles tiles;
    bolan_world *world;
    bolan_scene scene; // which the world was loaded from
    uint8_t *rgb;
    float *linear, *distance, *planes; // NULL where no layer is asked for
    bolan_surfaces surfaces;           // those that are asked for
    bolan_flow *flow;                  // of the world's sea, where motion is asked for
};

farm_stage *farm_stage_open(const farm_job *job) {
    const size_t pixels = (size_t)job->width * job->height;
    const bool layers = (job->outputs & FARM_LAYERS) != 0;
    const unsigned wanted = job->outputs;
    bolan_renderer_desc desc = bolan_renderer_desc_default();
    desc.quality = job->quality;
    desc.backend = job->backend;
    desc.pixels = job->pixels;
    desc.restore = BOLAN_RESTORE_NONE; // the context is this program's
    farm_stage *s = calloc(1, sizeof *s);
    if (!s) return failure("no memory to draw"), NULL;
    s->job = job;
    s->rgb = malloc(pixels * 3);
    s->linear = layers ? malloc(pixels * 3 * sizeof(float)) : NULL;
    s->distance = layers ? malloc(pixels * sizeof(float)) : NULL;
    s->planes = layers ? malloc(pixels * PLANES * sizeof(float)) : NULL;
    bolan_surfaces *to = &s->surfaces;
    to->label = wanted & FARM_SEGMENTATION ? malloc(pixels * sizeof *to->label) : NULL;
    to->normal = wanted & FARM_NORMAL ? malloc(pixels * sizeof *to->normal) : NULL;
    to->motion = wanted & FARM_MOTION ? malloc(pixels * sizeof *to->motion) : NULL;
    bool ok = s->rgb && (!layers || (s->linear && s->distance && s->planes)) &&
              !(wanted & FARM_SEGMENTATION) == !to->label && !(wanted & FARM_NORMAL) == !to->normal &&
              !(wanted & FARM_MOTION) == !to->motion;
    if (!ok) failure("no memory for a picture of %ux%u", (unsigned)job->width, (unsigned)job->height);
    ok = ok && !bolan_context_create(BOLAN_GL_CORE, &s->context) && !bolan_renderer_create(&desc, &s->renderer) &&
         tiles_open(&s->tiles, s->renderer, job->width, job->height, job->tile, layers) &&
         tiles_add_surfaces(&s->tiles, to);
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
    bolan_flow_destroy(&s->flow);
    free(s->surfaces.label), free(s->surfaces.normal), free(s->surfaces.motion);
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
        bolan_flow_destroy(&s->flow);
        bolan_world_destroy(&s->world);
        if (bolan_world_load_scene(scene, &s->world)) return false;
        if (s->surfaces.motion && bolan_flow_create(bolan_world_water(s->world)->sea, &s->flow)) return false;
        s->scene = *scene;
        bolan_renderer_bake(s->renderer); // nothing that was baked for another sun
    }
    bolan_world_set_camera(s->world, &scene->camera);
    bolan_world_settle(s->world, scene->time);
    if (s->flow) bolan_flow_step(s->flow, bolan_world_water(s->world)->sea);
    s->surfaces.flow = s->flow;
    return !session_check_camera(s->world);
}

// ---- files ----------------------------------------------------------------------------------------------------------

static bool write_layers(farm_stage *s, const char *path) {
    const farm_job *j = s->job;
    const size_t pixels = (size_t)j->width * j->height;
    bolan_exr_channel channels[MOST_CHANNELS];
    float *plane = s->planes;
    uint32_t count = 0;
    const struct {
        unsigned output;
        const float *pixels;
        const char *names[3];
    } vectors[] = {{FARM_LINEAR, s->linear, {"R", "G", "B"}},
                   {FARM_NORMAL, (const float *)s->surfaces.normal, {"normal.X", "normal.Y", "normal.Z"}},
                   {FARM_MOTION, (const float *)s->surfaces.motion, {"motion.X", "motion.Y", "motion.Z"}}};
    for (size_t i = 0; i < sizeof vectors / sizeof *vectors; i++) {
        if (!(j->outputs & vectors[i].output)) continue;
        shot_planes(vectors[i].pixels, pixels, plane);
        for (size_t c = 0; c < 3; c++, plane += pixels)
            channels[count++] = (bolan_exr_channel){vectors[i].names[c], plane};
    }
    if (j->outputs & FARM_DISTANCE) channels[count++] = (bolan_exr_channel){"Z", s->distance};
    if (j->outputs & FARM_SEGMENTATION) {
        for (size_t i = 0; i < pixels; i++) plane[i] = (float)s->surfaces.label[i];
        channels[count++] = (bolan_exr_channel){"segmentation", plane};
    }
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
    if ((s->job->outputs & FARM_SURFACES) && view.eye.z < scene.water.level)
        return failure("normal, segmentation and motion are those of an eye above the water; expected a higher camera"),
               false;
    tiles_draw(&s->tiles, s->world, &view, s->rgb, s->linear, s->distance,
               s->job->outputs & FARM_SURFACES ? &s->surfaces : NULL);
    if (!write_files(s, frame)) return false;
    if (farm_record(s->job, frame, &scene, true, result)) return true;
    return failure("frame %u: its record cannot be written", (unsigned)frame), false;
}
