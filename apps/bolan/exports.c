// SPDX-License-Identifier: MIT
// Meshes and fields: one file, or a numbered sequence.
#include "exports.h"

#include "output.h"
#include "progress.h"
#include "session.h"

#include "bolan/export.h"

#include <math.h>
#include <string.h>

enum { HALF_SIDE = 256 }; // points from the camera to the side of a square, where only the spacing is given

// Writes one file of the world at its present time, or an animation.
typedef bolan_result write_function(bolan_world *world, const void *desc, const char *path);

typedef struct sequence {
    const options *o;
    output_name name;
    uint32_t frames; // files
    double fps;
} sequence;

static bool ends_in(const char *path, const char *suffix) {
    const size_t length = strlen(path), tail = strlen(suffix);
    return length > tail && strcmp(path + length - tail, suffix) == 0;
}

// `many`: one file of this suffix holds all frames.
static int plan(const options *o, const char *many, sequence *s, bolan_export_frames *frames) {
    const uint32_t count = isnan(o->frames) ? 1 : (uint32_t)o->frames;
    *s = (sequence){.o = o, .name = output_parse(o->output), .frames = 1, .fps = isnan(o->fps) ? 30.0 : o->fps};
    if (s->name.wrong_pattern)
        return usage_error("-o %s: expected %%d or %%04d, once; %%%% is a percent sign", o->output);
    frames->fps = s->fps;
    if (s->name.numbered) {
        s->frames = count;
    } else if (ends_in(o->output, many)) {
        frames->count = count;
    } else if (count > 1) {
        return usage_error("--frames %.0f into one file; expected a %s, or a numbered name such as sea-%%04d%s",
                           o->frames, many, strrchr(o->output, '.') ? strrchr(o->output, '.') : "");
    }
    return EXIT_OK;
}

static bool path_of(const sequence *s, uint32_t number, char out[BOLAN_PATH_MAX]) {
    if (output_frame_path(&s->name, s->o->output, number, out)) return true;
    usage_error("-o: the name is longer than %d bytes", BOLAN_PATH_MAX - 1);
    return false;
}

static bool can_write(const sequence *s) {
    char path[BOLAN_PATH_MAX];
    return path_of(s, s->frames - 1, path) && path_of(s, 0, path) && !bolan_file_check_writable(path);
}

static int write_files(const sequence *s, bolan_world *w, const void *desc, write_function *write) {
    const double start = bolan_world_scene(w)->time;
    char path[BOLAN_PATH_MAX];
    int result = EXIT_OK;
    progress bar = progress_start(s->frames, s->o->quiet);
    for (uint32_t i = 0; i < s->frames && !result; i++) {
        const double time = start + i / s->fps;
        if (i == 0) {
            bolan_world_settle(w, time);
        } else {
            bolan_world_step(w, time);
        }
        const bolan_camera camera = bolan_world_camera_at(w, time);
        bolan_world_set_camera(w, &camera);
        const bolan_result written = path_of(s, i, path) ? write(w, desc, path) : BOLAN_ERROR_ARGUMENT;
        if (written) result = written == BOLAN_ERROR_ARGUMENT ? EXIT_USAGE : EXIT_FAILED;
        progress_update(&bar, i + 1);
    }
    progress_end(&bar);
    return result;
}

// The rectangle that is asked for; *given: there is one.
static void grid_of(const options *o, const bolan_scene *scene, bolan_export_grid *grid, bool *given) {
    *given = !isnan(o->rect[0]) || !isnan(o->spacing);
    if (!isnan(o->spacing)) grid->spacing = o->spacing;
    const double half = HALF_SIDE * grid->spacing, x = floor(scene->camera.position.x);
    const double y = floor(scene->camera.position.y);
    grid->from = (bolan_dvec2){x - half, y - half};
    grid->to = (bolan_dvec2){x + half, y + half};
    if (isnan(o->rect[0])) return;
    grid->from = (bolan_dvec2){o->rect[0], o->rect[1]};
    grid->to = (bolan_dvec2){o->rect[2], o->rect[3]};
}

static int check_grid(const bolan_export_grid *grid) {
    uint32_t columns, rows;
    bolan_export_grid_size(grid, &columns, &rows);
    if (columns > 0) return EXIT_OK;
    return usage_error("--rect and --spacing: expected the south-west corner first, and 2 to 65536 points along each "
                       "side, at most 2^28 in all");
}

static void show(void *user, uint32_t done, uint32_t total) {
    (void)total;
    progress_update(user, done);
}

static bolan_result write_mesh(bolan_world *world, const void *desc, const char *path) {
    return bolan_export_mesh(world, desc, path);
}

static bolan_result write_fields(bolan_world *world, const void *desc, const char *path) {
    return bolan_export_fields(world, desc, path);
}

// One file has a bar of its own.
static int run(const sequence *s, bolan_world *w, bolan_export_frames *frames, const void *desc,
               write_function *write) {
    progress bar = progress_start(s->frames == 1 ? 1000 : 1, s->o->quiet);
    if (s->frames == 1) frames->progress = show, frames->user = &bar;
    const int result = write_files(s, w, desc, write);
    progress_end(&bar);
    return result;
}

int export_mesh(const options *o) {
    bolan_export_mesh_desc d = bolan_export_mesh_desc_default();
    sequence s;
    bolan_world *w = NULL;
    bool rectangle;
    if (!ends_in(o->output, ".ply") && !ends_in(o->output, ".obj") && !ends_in(o->output, ".glb"))
        return usage_error("-o %s: expected a name that ends in .ply, .obj or .glb", o->output);
    if (o->with && strcmp(o->with, "ground") != 0) return usage_error("--with %.60s: expected ground", o->with);
    int result = plan(o, ".glb", &s, &d.frames);
    if (!result) result = can_write(&s) ? session_open(o, &w) : EXIT_FAILED;
    if (result) return result;
    grid_of(o, bolan_world_scene(w), &d.grid, &rectangle);
    if (rectangle) d.vertices = BOLAN_EXPORT_RECTANGLE;
    if (!isnan(o->size[0])) d.width = (uint32_t)o->size[0], d.height = (uint32_t)o->size[1];
    if (!isnan(o->origin[0]))
        d.origin = bolan_dv3(o->origin[0], o->origin[1], isnan(o->origin[2]) ? 0.0 : o->origin[2]);
    d.ground = o->with != NULL;
    if (rectangle) result = check_grid(&d.grid);
    if (!result) result = run(&s, w, &d.frames, &d, write_mesh);
    bolan_world_destroy(&w);
    return result;
}

int export_fields(const options *o) {
    bolan_export_fields_desc d = bolan_export_fields_desc_default();
    sequence s;
    bolan_world *w = NULL;
    if (!ends_in(o->output, ".exr") && !ends_in(o->output, ".nc"))
        return usage_error("-o %s: expected a name that ends in .exr or .nc", o->output);
    if (o->half && !ends_in(o->output, ".exr")) return usage_error("--half goes with an .exr; a .nc holds floats");
    int result = plan(o, ".nc", &s, &d.frames);
    if (!result) result = can_write(&s) ? session_open(o, &w) : EXIT_FAILED;
    if (result) return result;
    grid_of(o, bolan_world_scene(w), &d.grid, &d.resampled);
    d.half = o->half;
    if (d.resampled) result = check_grid(&d.grid);
    if (!result) result = run(&s, w, &d.frames, &d, write_fields);
    bolan_world_destroy(&w);
    return result;
}
