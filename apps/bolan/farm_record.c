// SPDX-License-Identifier: MIT
// See farm_record.h.
#include "farm_record.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

// A text that grows; NULL data: no memory was left.
typedef struct text {
    char *data;
    size_t size, capacity;
} text;

static void add_bytes(text *t, const char *bytes, size_t size) {
    while (t->data && t->size + size + 1 > t->capacity) {
        char *larger = realloc(t->data, t->capacity *= 2);
        if (!larger) free(t->data);
        t->data = larger;
    }
    if (!t->data) return;
    memcpy(t->data + t->size, bytes, size);
    t->size += size;
    t->data[t->size] = '\0';
}

#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
static void
add(text *t, const char *format, ...) {
    char piece[512];
    va_list arguments;
    va_start(arguments, format);
    const int size = vsnprintf(piece, sizeof piece, format, arguments);
    va_end(arguments);
    add_bytes(t, piece, size < (int)sizeof piece ? (size_t)size : sizeof piece - 1);
}

static text begin_text(void) { return (text){.data = malloc(4096), .capacity = 4096}; }

// A string of JSON.
static void add_string(text *t, const char *s) {
    add(t, "\"");
    for (; *s; s++) {
        if (*s == '"' || *s == '\\') add(t, "\\");
        if ((unsigned char)*s < 0x20)
            add(t, "\\u%04x", (unsigned)(unsigned char)*s);
        else
            add_bytes(t, s, 1);
    }
    add(t, "\"");
}

// ---- parameters -----------------------------------------------------------------------------------------------------

static void add_value(text *t, const bolan_param *p, const void *desc) {
    const void *field = (const char *)desc + p->offset;
    const double value = bolan_param_get(p, desc);
    if (p->kind == BOLAN_PARAM_TEXT) {
        add_string(t, field);
    } else if (p->kind == BOLAN_PARAM_NAME && value >= p->low && value <= p->high) {
        add_string(t, p->names[(int)(value - p->low)]);
    } else if (p->kind == BOLAN_PARAM_FLAG) {
        add(t, value != 0.0 ? "true" : "false");
    } else if (p->kind == BOLAN_PARAM_WHOLE && p->size == sizeof(uint64_t)) {
        uint64_t whole;
        memcpy(&whole, field, sizeof whole);
        add(t, "%llu", (unsigned long long)whole);
    } else if (isfinite(value)) {
        add(t, "%.17g", value);
    } else {
        add(t, "null");
    }
}

static void add_rows(text *t, const char *map, const bolan_param_table *table, const void *desc) {
    for (uint32_t i = 0; i < table->count; i++) {
        const bolan_param *p = &table->params[i];
        add(t, ",\n    \"%s%s%s\": ", map, *map ? "." : "", p->field);
        add_value(t, p, desc);
    }
}

// Every parameter of the scene, by the member of the struct.
static void add_scene(text *t, const bolan_scene *scene) {
    char map[128];
    for (const bolan_param_group *g = bolan_scene_groups; g->table; g++) {
        const char *desc = (const char *)scene + g->offset;
        uint32_t count = 1;
        if (g->capacity) memcpy(&count, (const char *)scene + g->count_offset, sizeof count);
        for (uint32_t i = 0; i < count; i++) {
            snprintf(map, sizeof map, g->capacity ? "%s[%u]" : "%s", g->field, (unsigned)i);
            add_rows(t, map, g->table, desc + i * g->stride);
        }
    }
    const bolan_sea_state *sea = &scene->sea.sea_state;
    for (uint32_t i = 0; i < sea->system_count; i++) {
        snprintf(map, sizeof map, "sea.sea_state.systems[%u]", (unsigned)i);
        add_rows(t, map, &bolan_wave_system_params, &sea->systems[i]);
    }
}

static void add_record(text *t, const farm_job *job, uint32_t frame, const bolan_scene *scene, const farm_result *r) {
    char path[BOLAN_PATH_MAX];
    add(t, "{\n  \"program\": \"bolan %s\",\n  \"frame\": %u,\n  \"files\": {", bolan_version(), (unsigned)frame);
    const char *comma = "";
    for (farm_file f = FARM_FILE_PICTURE; f < FARM_FILE_RECORD; f++) {
        if (!farm_job_has_file(job, f) || !farm_job_file(job, frame, f, path)) continue;
        add(t, "%s\n    ", comma);
        add_string(t, farm_last_part(path));
        add(t, ": \"%s\"", r->hash[f]);
        comma = ",";
    }
    add(t,
        "\n  },\n  \"parameters\": {\n    \"width\": %u,\n    \"height\": %u,\n    \"samples\": %u,\n    \"tile\": "
        "%u,\n",
        (unsigned)job->width, (unsigned)job->height, (unsigned)job->samples, (unsigned)job->tile);
    add(t, "    \"outputs\": %u,\n    \"quality\": \"%s\",\n    \"backend\": \"%s\",\n    \"pixels\": \"%s\"",
        job->outputs, bolan_quality_names[job->quality], bolan_backend_names[job->backend],
        bolan_pixels_names[job->pixels]);
    add_scene(t, scene);
    add(t, "\n  }\n}\n");
}

// ---- a record -------------------------------------------------------------------------------------------------------

static bool holds(const char *path, const text *t) {
    FILE *file = fopen(path, "rb");
    char *there = file ? malloc(t->size + 1) : NULL;
    const bool equal = there && fread(there, 1, t->size + 1, file) == t->size && memcmp(there, t->data, t->size) == 0;
    free(there);
    if (file) fclose(file);
    return equal;
}

bool farm_record(const farm_job *job, uint32_t frame, const bolan_scene *scene, bool write, farm_result *r) {
    char path[BOLAN_PATH_MAX];
    r->frame = frame;
    r->time = scene->time;
    for (farm_file f = FARM_FILE_PICTURE; f < FARM_FILE_RECORD; f++) {
        r->hash[f][0] = '\0';
        if (!farm_job_has_file(job, f)) continue;
        if (!farm_job_file(job, frame, f, path) || !sha256_file(path, r->hash[f])) return false;
    }
    text t = begin_text();
    add_record(&t, job, frame, scene, r);
    bool ok = t.data && farm_job_file(job, frame, FARM_FILE_RECORD, path);
    if (ok) ok = write ? bolan_file_write(path, t.data, t.size) == BOLAN_OK : holds(path, &t);
    if (ok) sha256_text(t.data, t.size, r->hash[FARM_FILE_RECORD]);
    free(t.data);
    return ok;
}

// ---- the manifest ---------------------------------------------------------------------------------------------------

static void add_frame(text *t, const farm_job *job, const farm_result *r) {
    char path[BOLAN_PATH_MAX];
    add(t, "    {\"frame\": %u, \"time\": %.17g, ", (unsigned)r->frame, r->time);
    if (job->has_table) add(t, "\"line\": %u, ", (unsigned)job->table.rows[r->frame].line);
    if (r->state == FARM_FAILED) {
        add(t, "\"reason\": ");
        add_string(t, r->reason);
        add(t, "}");
        return;
    }
    add(t, "\"files\": {");
    const char *comma = "";
    for (farm_file f = FARM_FILE_PICTURE; f < FARM_FILES; f++) {
        if (!farm_job_has_file(job, f) || !farm_job_file(job, r->frame, f, path)) continue;
        add(t, "%s", comma);
        add_string(t, farm_last_part(path));
        add(t, ": \"%s\"", r->hash[f]);
        comma = ", ";
    }
    add(t, "}}");
}

static uint32_t add_list(text *t, const farm_job *job, const farm_result *results, farm_state state) {
    uint32_t count = 0;
    for (uint32_t i = 0; i < job->count; i++) {
        if (results[i].state != state) continue;
        add(t, count++ ? ",\n" : "\n");
        add_frame(t, job, &results[i]);
    }
    add(t, count ? "\n  ]" : "]");
    return count;
}

int farm_manifest_write(const farm_job *job, const farm_result *results) {
    char path[BOLAN_PATH_MAX];
    text t = begin_text();
    add(&t, "{\n  \"program\": \"bolan %s\",\n  \"frames\": %u,\n  \"width\": %u,\n  \"height\": %u,\n",
        bolan_version(), (unsigned)job->count, (unsigned)job->width, (unsigned)job->height);
    add(&t, "  \"finished\": [");
    add_list(&t, job, results, FARM_DONE);
    add(&t, ",\n  \"failed\": [");
    add_list(&t, job, results, FARM_FAILED);
    add(&t, "\n}\n");
    const bool ok = t.data && farm_job_manifest(job, path) && !bolan_file_write(path, t.data, t.size);
    free(t.data);
    return ok ? EXIT_OK : EXIT_FAILED;
}
