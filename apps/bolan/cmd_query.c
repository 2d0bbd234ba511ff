// SPDX-License-Identifier: MIT
// bolan query: the surface at points, as CSV.
#include "commands.h"
#include "help.h"
#include "session.h"

#include "bolan/query.h"

#include <stdlib.h>
#include <string.h>

enum { LINE_CAPACITY = 192, BATCH = 65536 };

static const char *const header = "x,y,height,normal_x,normal_y,normal_z,jacobian,residual\n";

// Text that grows; one write at the end puts it into the file as a whole.
typedef struct text {
    char *data;
    size_t size, capacity;
} text;

static bool reserve(text *t, size_t more) {
    if (t->size + more <= t->capacity) return true;
    const size_t capacity = 2 * t->capacity + more;
    char *data = realloc(t->data, capacity);
    if (!data) return false;
    t->data = data;
    t->capacity = capacity;
    return true;
}

static bool append_rows(text *t, const bolan_dvec2 *xy, const bolan_query_point *answers, uint32_t count) {
    if (!reserve(t, (size_t)count * LINE_CAPACITY)) return false;
    for (uint32_t i = 0; i < count; i++) {
        const bolan_query_point *a = &answers[i];
        t->size += (size_t)bolan_format(t->data + t->size, LINE_CAPACITY, "%.12g,%.12g,%.7g,%.7g,%.7g,%.7g,%.6g,%.3g\n",
                                        xy[i].x, xy[i].y, (double)a->height, (double)a->normal.x, (double)a->normal.y,
                                        (double)a->normal.z, (double)a->jacobian, (double)a->residual);
    }
    return true;
}

static bool answer_all(const bolan_water *water, const bolan_points *points, text *out) {
    bolan_dvec2 *xy = malloc(BATCH * sizeof *xy);
    bolan_query_point *answers = malloc(BATCH * sizeof *answers);
    bool ok = xy && answers && reserve(out, strlen(header));
    if (ok) {
        memcpy(out->data, header, strlen(header));
        out->size = strlen(header);
    }
    for (uint32_t first = 0; first < points->count && ok; first += BATCH) {
        const uint32_t count = points->count - first < BATCH ? points->count - first : BATCH;
        for (uint32_t i = 0; i < count; i++)
            xy[i] = (bolan_dvec2){points->points[first + i].x, points->points[first + i].y};
        bolan_query_surface(water, xy, count, answers);
        ok = append_rows(out, xy, answers, count);
    }
    free(xy);
    free(answers);
    return ok;
}

static int write_answers(const bolan_water *water, const bolan_points *points, const char *output) {
    text rows = {NULL, 0, 0};
    int result = EXIT_OK;
    if (!answer_all(water, points, &rows)) {
        result = failure("no memory for the answers to %u points", (unsigned)points->count);
    } else if (output) {
        result = bolan_file_write(output, rows.data, rows.size) ? EXIT_FAILED : EXIT_OK;
    } else {
        fwrite(rows.data, 1, rows.size, stdout);
    }
    free(rows.data);
    return result;
}

int command_query(int count, char **arguments) {
    options o;
    bolan_world *w = NULL;
    bolan_points points;
    int result = options_parse(ON_QUERY, "query", count, arguments, &o);
    if (result) return result;
    if (o.help)
        return help_command(ON_QUERY, "query [SCENE] --points FILE.csv [-o FILE.csv] [OPTIONS]",
                            "Prints height, normal and Jacobian of the water at points: the surface that is drawn.");
    if (!o.points) return usage_error("query needs --points FILE, a CSV file of x,y in metres");
    if (o.output && strcmp(o.output, "-") == 0) o.output = NULL;
    if (bolan_points_load(strcmp(o.points, "-") == 0 ? "/dev/stdin" : o.points, &points)) return EXIT_FAILED;
    result = o.output && bolan_file_check_writable(o.output) ? EXIT_FAILED : session_open(&o, &w);
    if (!result) {
        result = write_answers(bolan_world_water(w), &points, o.output);
        bolan_world_destroy(&w);
    }
    bolan_points_destroy(&points);
    return result;
}
