// SPDX-License-Identifier: MIT
// bolan render: images and films of a scene, without a window.
#include "commands.h"
#include "help.h"
#include "output.h"
#include "progress.h"
#include "session.h"
#include "shot.h"
#include "tiles.h"

#include "bolan/render.h"

#include <math.h>
#include <string.h>

typedef struct job {
    const char *path;
    output_name name;
    uint32_t width, height, frames, samples;
    uint32_t tile;     // largest side that is drawn at once; 0: as OpenGL has it
    double fps, start; // frames a second; time of the first [s]
    bolan_quality quality;
    bolan_backend backend;
    bolan_pixels pixels;
    bool taa;
    bool quiet;
} job;

enum { STILL_TAA = 16 }; // images of one moment that a single one is the mean of

typedef struct stage {
    bolan_context *context;
    bolan_renderer *renderer;
    tiles tiles;
    bolan_video *video;
    uint8_t *rgb;
    float *linear; // EXR: rgb of every pixel, distance of every pixel, then the planes R, G, B
    size_t rgb_bytes, linear_bytes;
} stage;

// ---- what to do -----------------------------------------------------------------------------------------------------

static double otherwise(double value, double fallback) { return isnan(value) ? fallback : value; }

static int make_job(const options *o, job *j) {
    if (!o->output) return usage_error("render needs -o FILE: .png, .exr, a numbered sequence (%%04d), .mp4 or .webm");
    *j = (job){.path = o->output, .name = output_parse(o->output), .taa = o->taa, .quiet = o->quiet};
    if (j->name.kind == OUTPUT_UNKNOWN)
        return usage_error("-o %s: expected a name that ends in .png, .exr, .mp4 or .webm", o->output);
    if (j->name.wrong_pattern)
        return usage_error("-o %s: expected %%d or %%04d, once, in the name of a sequence of pictures and of no video; "
                           "%%%% is a percent sign",
                           o->output);
    const bool video = j->name.kind == OUTPUT_VIDEO, moving = video || j->name.numbered;
    if (!moving && o->frames > 1.0)
        return usage_error("--frames %.0f into one picture; expected a video, or a numbered name such as sea-%%04d.png",
                           o->frames);
    j->fps = otherwise(o->fps, 30.0);
    j->frames = (uint32_t)otherwise(o->frames, moving ? ceil(10.0 * j->fps) : 1.0);
    j->width = (uint32_t)otherwise(o->size[0], moving ? 1280 : 1920);
    j->height = (uint32_t)otherwise(o->size[1], moving ? 720 : 1080);
    if ((uint64_t)j->width * j->height > BOLAN_IMAGE_MOST_PIXELS)
        return usage_error("--size %ux%u: expected at most %u pixels in all", (unsigned)j->width, (unsigned)j->height,
                           BOLAN_IMAGE_MOST_PIXELS);
    if (video && (j->width % 2 || j->height % 2))
        return usage_error("--size %ux%u: a video's width and height are even", (unsigned)j->width,
                           (unsigned)j->height);
    j->tile = (uint32_t)otherwise(o->tile, 0.0);
    j->quality = o->quality >= 0 ? (bolan_quality)o->quality : BOLAN_QUALITY_HIGH;
    j->backend = o->backend >= 0 ? (bolan_backend)o->backend : BOLAN_BACKEND_AUTO;
    j->pixels = o->pixels >= 0 ? (bolan_pixels)o->pixels : BOLAN_PIXELS_AUTO;
    static const uint32_t still_samples[] = {1, 1, 4, 16};
    j->samples = (uint32_t)otherwise(o->samples, moving || j->taa ? 1 : still_samples[j->quality]);
    if (j->taa && j->name.kind == OUTPUT_EXR)
        return usage_error("--taa blends display values; expected a name that ends in .png, .mp4 or .webm");
    return EXIT_OK;
}

static bool frame_path(const job *j, uint32_t number, char out[BOLAN_PATH_MAX]) {
    if (output_frame_path(&j->name, j->path, number, out)) return true;
    usage_error("-o: the name is longer than %d bytes", BOLAN_PATH_MAX - 1);
    return false;
}

// ---- the stage ------------------------------------------------------------------------------------------------------

static bool open_stage(const job *j, stage *s) {
    const size_t pixels = (size_t)j->width * j->height;
    bolan_renderer_desc desc = bolan_renderer_desc_default();
    desc.quality = j->quality;
    desc.backend = j->backend;
    desc.pixels = j->pixels;
    desc.restore = BOLAN_RESTORE_NONE; // the context is this program's
    *s = (stage){.rgb_bytes = pixels * 3, .linear_bytes = j->name.kind == OUTPUT_EXR ? pixels * 7 * sizeof(float) : 0};
    if (bolan_context_create(BOLAN_GL_CORE, &s->context) || bolan_renderer_create(&desc, &s->renderer) ||
        !tiles_open(&s->tiles, s->renderer, j->width, j->height, j->tile, j->name.kind == OUTPUT_EXR))
        return false;
    if (j->taa && (s->tiles.columns < j->width || s->tiles.rows < j->height)) {
        failure("--taa draws no tiles, and %ux%u takes several", (unsigned)j->width, (unsigned)j->height);
        return false;
    }
    s->rgb = bolan_allocate(s->rgb_bytes);
    s->linear = bolan_allocate(s->linear_bytes);
    if (!s->rgb || (s->linear_bytes && !s->linear)) {
        failure("no memory for a picture of %ux%u", (unsigned)j->width, (unsigned)j->height);
        return false;
    }
    char path[BOLAN_PATH_MAX];
    return j->name.kind != OUTPUT_VIDEO ||
           (frame_path(j, 0, path) && !bolan_video_open(path, j->width, j->height, j->fps, &s->video));
}

// @p keep: the film is complete. Returns false when finishing it failed.
static bool close_stage(stage *s, bool keep) {
    const bool ok = bolan_video_close(&s->video, keep) == BOLAN_OK;
    bolan_release(s->rgb, s->rgb_bytes);
    bolan_release(s->linear, s->linear_bytes);
    tiles_close(&s->tiles);
    bolan_renderer_destroy(&s->renderer);
    bolan_context_destroy(&s->context);
    return ok;
}

// ---- frames ---------------------------------------------------------------------------------------------------------

static bool write_exr(const job *j, stage *s, const char *path) {
    const size_t pixels = (size_t)j->width * j->height;
    float *rgb = s->linear, *distance = rgb + 3 * pixels, *plane = distance + pixels;
    shot_planes(rgb, pixels, plane);
    const bolan_exr_channel channels[] = {
        {"R", plane}, {"G", plane + pixels}, {"B", plane + 2 * pixels}, {"Z", distance}};
    return bolan_exr_write(path, j->width, j->height, channels, 4) == BOLAN_OK;
}

static bool write_frame(const job *j, stage *s, uint32_t number) {
    char path[BOLAN_PATH_MAX];
    if (!frame_path(j, number, path)) return false;
    if (j->name.kind == OUTPUT_EXR) return write_exr(j, s, path);
    if (s->video) return bolan_video_write(s->video, s->rgb) == BOLAN_OK;
    return bolan_png_write(path, j->width, j->height, s->rgb) == BOLAN_OK;
}

static bool render_frame(const job *j, bolan_world *w, stage *s, uint32_t number) {
    const double time = j->start + number / j->fps;
    if (number == 0) {
        bolan_world_settle(w, time); // with the foam of the seconds before
    } else {
        bolan_world_step(w, time);
    }
    bolan_view view = shot_view(w, time, j->width, j->height, j->samples);
    view.temporal = j->taa;
    float *distance = s->linear != NULL ? s->linear + 3 * (size_t)j->width * j->height : NULL;
    for (int i = j->taa && j->frames == 1 ? STILL_TAA : 1; i > 0; i--)
        tiles_draw(&s->tiles, w, &view, s->rgb, s->linear, distance, NULL);
    return write_frame(j, s, number);
}

// Prints the name of the output; of a sequence, its pattern.
static void print_name(const job *j) {
    char path[BOLAN_PATH_MAX];
    output_print(!j->name.numbered && frame_path(j, 0, path) ? path : j->path);
    printf("\n");
}

static int render_all(const job *j, bolan_world *w) {
    stage s;
    bool ok = open_stage(j, &s);
    progress bar = progress_start(j->frames, j->quiet || !ok);
    for (uint32_t i = 0; i < j->frames && ok; i++) {
        ok = render_frame(j, w, &s, i);
        progress_update(&bar, i + 1);
    }
    progress_end(&bar);
    if (!close_stage(&s, ok)) ok = false;
    if (ok && !j->quiet) print_name(j);
    return ok ? EXIT_OK : EXIT_FAILED;
}

// Checks the output before the work, not after it.
static bool can_write(const job *j) {
    char path[BOLAN_PATH_MAX];
    // The last number makes the longest name; the first name is tried.
    if (!frame_path(j, j->frames - 1, path) || !frame_path(j, 0, path)) return false;
    if (j->name.kind == OUTPUT_VIDEO) return !bolan_video_check(path, j->width, j->height, j->fps);
    return !bolan_file_check_writable(path);
}

int command_render(int count, char **arguments) {
    options o;
    job j;
    bolan_world *w = NULL;
    int result = options_parse(ON_RENDER, "render", count, arguments, &o);
    if (result) return result;
    if (o.help)
        return help_command(
            ON_RENDER, "render [SCENE] -o FILE [OPTIONS]",
            "Draws the scene without a window: FILE is one .png or .exr (linear R, G, B and Z, the distance),\n"
            "a numbered sequence of them (sea-%04d.png), or a video, .mp4 or .webm (needs ffmpeg).");
    result = make_job(&o, &j);
    if (result) return result;
    result = can_write(&j) ? session_open(&o, &w) : EXIT_FAILED;
    if (!result) result = session_check_camera(w);
    if (!result) {
        j.start = bolan_world_scene(w)->time;
        result = render_all(&j, w);
    }
    bolan_world_destroy(&w);
    return result;
}
