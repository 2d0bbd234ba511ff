// SPDX-License-Identifier: MIT
// See farm_job.h.
#include "farm_job.h"

#include <math.h>
#include <string.h>

static double otherwise(double value, double fallback) { return isnan(value) ? fallback : value; }

// ---- names ----------------------------------------------------------------------------------------------------------

const char *farm_last_part(const char *path) {
    const char *slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
}

static const char *const suffixes[FARM_FILES] = {".png", ".exr", ".json"};

// The path without its suffix .png or .exr.
static size_t stem_of(const farm_job *job) { return strlen(job->path) - (job->name.kind == OUTPUT_UNKNOWN ? 0 : 4); }

bool farm_job_file(const farm_job *job, uint32_t frame, farm_file file, char out[BOLAN_PATH_MAX]) {
    const size_t stem = stem_of(job);
    char path[BOLAN_PATH_MAX + 16];
    if (job->name.kind == OUTPUT_UNKNOWN) { // a folder
        const bool slash = stem > 0 && job->path[stem - 1] == '/';
        return snprintf(out, BOLAN_PATH_MAX, "%s%s%06u%s", job->path, slash ? "" : "/", (unsigned)frame,
                        suffixes[file]) < BOLAN_PATH_MAX;
    }
    snprintf(path, sizeof path, "%.*s%s", (int)stem, job->path, suffixes[file]);
    return output_frame_path(&job->name, path, frame, out);
}

bool farm_job_has_file(const farm_job *job, farm_file file) {
    if (file == FARM_FILE_RECORD) return true;
    return (job->outputs & (file == FARM_FILE_PICTURE ? FARM_PICTURE : FARM_LAYERS)) != 0;
}

bool farm_job_manifest(const farm_job *job, char out[BOLAN_PATH_MAX]) {
    const size_t stem = stem_of(job);
    int length;
    if (job->name.kind == OUTPUT_UNKNOWN) {
        const bool slash = stem > 0 && job->path[stem - 1] == '/';
        length = snprintf(out, BOLAN_PATH_MAX, "%s%smanifest.json", job->path, slash ? "" : "/");
    } else {
        length = snprintf(out, BOLAN_PATH_MAX, "%.*smanifest%.*s.json", (int)job->name.before, job->path,
                          (int)(stem - job->name.after), job->path + job->name.after);
    }
    return length < BOLAN_PATH_MAX;
}

static int check_name(farm_job *job) {
    output_name *n = &job->name;
    const char *last = farm_last_part(job->path);
    if (n->kind == OUTPUT_VIDEO || n->wrong_pattern || (n->kind != OUTPUT_UNKNOWN && !n->numbered) ||
        (n->kind == OUTPUT_UNKNOWN && (strchr(last, '%') || strchr(last, '.'))))
        return usage_error("-o %s: expected a numbered name such as sea-%%04d.png or sea-%%04d.exr, or a folder",
                           job->path);
    char out[BOLAN_PATH_MAX];
    if (!farm_job_file(job, job->count - 1, FARM_FILE_RECORD, out) || !farm_job_manifest(job, out))
        return usage_error("-o: the name is longer than %d bytes", BOLAN_PATH_MAX - 1);
    return EXIT_OK;
}

// ---- what to write --------------------------------------------------------------------------------------------------

static int read_outputs(farm_job *job, const char *list) {
    static const char *const names[] = {"picture", "linear", "distance", "normal", "segmentation", "motion"};
    enum { COUNT = sizeof names / sizeof *names };
    job->outputs = job->name.kind == OUTPUT_EXR ? FARM_LINEAR | FARM_DISTANCE : FARM_PICTURE;
    if (!list) return EXIT_OK;
    job->outputs = 0;
    for (const char *p = list;; p++) {
        const size_t length = strcspn(p, ",");
        int i = 0;
        while (i < COUNT && (strlen(names[i]) != length || strncmp(names[i], p, length) != 0)) i++;
        char word[SHORT_WORD];
        if (i == COUNT)
            return usage_error(
                "--outputs is %s; expected some of picture, linear, distance, normal, segmentation, motion",
                shorten(list, word));
        job->outputs |= 1u << i;
        p += length;
        if (!*p) return EXIT_OK;
    }
}

static int read_part(farm_job *job, const char *text) {
    job->part = 0, job->parts = 1;
    if (!text) return EXIT_OK;
    const char *slash = strchr(text, '/');
    double k = -1.0, n = 0.0;
    char word[SHORT_WORD];
    if (!slash || !bolan_parse_number(text, (size_t)(slash - text), &k) ||
        !bolan_parse_number(slash + 1, strlen(slash + 1), &n) || k != floor(k) || n != floor(n) || k < 0.0 || k >= n ||
        n > 1e6)
        return usage_error("--part is %s; expected K/N with K from 0 below N, such as 0/8", shorten(text, word));
    job->part = (uint32_t)k, job->parts = (uint32_t)n;
    return EXIT_OK;
}

static int read_size(farm_job *job, const options *o) {
    static const uint32_t still_samples[] = {1, 1, 4, 16};
    job->width = (uint32_t)otherwise(o->size[0], 1280.0);
    job->height = (uint32_t)otherwise(o->size[1], 720.0);
    job->tile = (uint32_t)otherwise(o->tile, 0.0);
    job->quality = o->quality >= 0 ? (bolan_quality)o->quality : BOLAN_QUALITY_HIGH;
    job->backend = o->backend >= 0 ? (bolan_backend)o->backend : BOLAN_BACKEND_AUTO;
    job->pixels = o->pixels >= 0 ? (bolan_pixels)o->pixels : BOLAN_PIXELS_AUTO;
    job->samples = (uint32_t)otherwise(o->samples, job->has_table ? still_samples[job->quality] : 1.0);
    if ((uint64_t)job->width * job->height <= BOLAN_IMAGE_MOST_PIXELS) return EXIT_OK;
    return usage_error("--size %ux%u: expected at most %u pixels in all", (unsigned)job->width, (unsigned)job->height,
                       BOLAN_IMAGE_MOST_PIXELS);
}

// ---- frames ---------------------------------------------------------------------------------------------------------

static bool is_table(const char *scene) {
    const size_t length = scene ? strlen(scene) : 0;
    return length > 4 && strcmp(scene + length - 4, ".csv") == 0;
}

static int read_frames(farm_job *job) {
    const options *o = &job->given;
    job->has_table = is_table(o->scene);
    job->fps = otherwise(o->fps, 30.0);
    job->count = (uint32_t)otherwise(o->frames, ceil(10.0 * job->fps));
    if (!job->has_table) return options_scene(o, &job->scene);
    if (!isnan(o->frames) || !isnan(o->fps))
        return usage_error("--%s does not go with a table, whose rows are the frames",
                           isnan(o->fps) ? "frames" : "fps");
    const int result = farm_table_read(o->scene, &job->table);
    job->count = job->table.count;
    job->given.scene = NULL;
    return result;
}

int farm_job_read(const options *o, farm_job *job) {
    *job = (farm_job){.given = *o, .path = o->output, .quiet = o->quiet};
    if (!o->output) return usage_error("farm needs -o: a numbered name such as sea-%%04d.png, or a folder");
    job->name = output_parse(o->output);
    int result = read_outputs(job, o->outputs);
    if (!result) result = read_part(job, o->part);
    if (!result) result = read_frames(job);
    if (!result) result = read_size(job, o);
    if (!result) result = check_name(job);
    if (!result) bolan_set_threads(isnan(o->threads) ? 0 : (uint32_t)o->threads);
    return result;
}

void farm_job_free(farm_job *job) { farm_table_free(&job->table); }

int farm_job_scene(const farm_job *job, uint32_t frame, bolan_scene *scene) {
    if (!job->has_table) {
        *scene = job->scene;
        scene->time = job->scene.time + frame / job->fps;
        return EXIT_OK;
    }
    const farm_row *row = &job->table.rows[frame];
    options o = job->given;
    const int result = options_parse_more(ON_FARM, "farm", row->count, job->table.arguments + row->first, &o);
    return result ? result : options_scene(&o, scene);
}
