// SPDX-License-Identifier: MIT
// bolan query: the water at points, as CSV of any length: points are read, answered and printed batch by batch.
#include "commands.h"
#include "help.h"
#include "progress.h"
#include "query_table.h"
#include "session.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { BATCH = 16384, SLICE = 256, SLICES = BATCH / SLICE, ROW = QUERY_MAX_COLUMNS * QUERY_CELL };

// A row is seldom longer than some 20 bytes a column; the longest number has less than QUERY_CELL.
typedef struct stream {
    const bolan_water *water;
    bolan_question question;
    query_columns columns;
    unsigned asks;
    query_batch batch;
    bolan_points_reader *reader;
    bolan_dvec3 *first; // the first batch, which is read before the columns are known
    uint32_t first_count;
    bolan_file_stream *file; // NULL: standard output
    progress bar;
    size_t row;          // capacity of a row [bytes]
    char *text;          // SLICES * SLICE rows
    size_t used[SLICES]; // text of each slice
} stream;

// Task: slices [begin, end) of the batch.
static void print_slices(void *context, uint32_t begin, uint32_t end, uint32_t worker) {
    (void)worker;
    stream *s = context;
    for (uint32_t i = begin; i < end; i++) {
        const uint32_t first = i * SLICE, last = first + SLICE < s->batch.count ? first + SLICE : s->batch.count;
        s->used[i] =
            query_batch_print(&s->batch, &s->columns, &s->question, first, last, s->text + (size_t)first * s->row);
    }
}

static bool write_text(stream *s, const char *text, size_t size) {
    if (s->file) return bolan_file_stream_write(s->file, text, size) == BOLAN_OK;
    return fwrite(text, 1, size, stdout) == size;
}

static bool write_header(stream *s) {
    char header[ROW];
    return write_text(s, header, query_columns_header(&s->columns, header));
}

static bool write_batch(stream *s) {
    const uint32_t slices = (s->batch.count + SLICE - 1) / SLICE;
    bolan_parallel(slices, 1, print_slices, s);
    for (uint32_t i = 0; i < slices; i++)
        if (!write_text(s, s->text + (size_t)i * SLICE * s->row, s->used[i])) return false;
    return true;
}

static void show_progress(stream *s) {
    uint64_t position, size;
    bolan_points_progress(s->reader, &position, &size);
    progress_update(&s->bar, (uint32_t)(position >> 10));
}

// The first batch. True where one of its points has a z, in *has_z.
static bool read_first(stream *s, bool *has_z) {
    *has_z = false;
    s->first = malloc(BATCH * sizeof *s->first);
    if (!s->first) {
        failure("no memory for %d points", (int)BATCH);
        return false;
    }
    if (bolan_points_next(s->reader, s->first, BATCH, &s->first_count)) return false;
    for (uint32_t i = 0; i < s->first_count; i++) *has_z |= !isnan(s->first[i].z);
    return true;
}

static bool answer_all(stream *s) {
    memcpy(s->batch.xyz, s->first, s->first_count * sizeof *s->first);
    s->batch.count = s->first_count;
    if (!write_header(s)) return false;
    for (;; s->batch.count = 0) {
        if (s->batch.count == 0 && bolan_points_next(s->reader, s->batch.xyz, BATCH, &s->batch.count)) return false;
        if (s->batch.count == 0) return true;
        query_batch_answer(&s->batch, s->water, &s->question, s->asks);
        if (!write_batch(s)) return false;
        show_progress(s);
    }
}

static int run(stream *s, const options *o) {
    uint64_t position, size;
    if (o->output && bolan_file_stream_open(o->output, &s->file)) return EXIT_FAILED;
    bolan_points_progress(s->reader, &position, &size);
    const bool on_terminal = !o->output && isatty(STDOUT_FILENO);
    s->bar = progress_start((uint32_t)(size >> 10), o->quiet || on_terminal);
    s->bar.unit = " KiB";
    const bool answered = answer_all(s);
    progress_end(&s->bar);
    if (!s->file && ferror(stdout)) return EXIT_OK; // main() finds that and says so
    const bool kept = bolan_file_stream_close(&s->file, answered) == BOLAN_OK;
    return answered && kept ? EXIT_OK : EXIT_FAILED;
}

// Answers with a flow, where a column needs one.
static int run_in(stream *s, const options *o, const bolan_world *world) {
    bolan_water water = *bolan_world_water(world);
    bolan_flow *flow = NULL;
    s->row = (size_t)s->columns.count * QUERY_CELL;
    s->text = malloc((size_t)BATCH * s->row);
    int result = EXIT_FAILED;
    if (!query_batch_create(&s->batch, BATCH, s->asks) || !s->text) {
        failure("no memory for %d points", (int)BATCH);
    } else if (!(s->asks & (ASK_MOTION | ASK_BELOW)) || bolan_flow_create(water.sea, &flow) == BOLAN_OK) {
        water.flow = flow;
        s->water = &water;
        result = run(s, o);
    }
    query_batch_free(&s->batch);
    free(s->text);
    bolan_flow_destroy(&flow);
    return result;
}

static bolan_question question_of(const options *o) {
    bolan_question q = bolan_question_default();
    if (!isnan(o->least_wavelength)) q.least_wavelength = o->least_wavelength;
    if (o->stretching >= 0) q.stretching = (bolan_stretching)o->stretching;
    return q;
}

// What the columns and the question need.
static void ask(stream *s, const options *o) {
    s->question = question_of(o);
    s->asks = s->columns.asks;
    if (s->question.least_wavelength > 0.0 && (s->asks & ASK_SURFACE)) s->asks |= ASK_MOTION;
}

int command_query(int count, char **arguments) {
    options o;
    bolan_world *w = NULL;
    stream s = {.file = NULL};
    bool has_z;
    int result = options_parse(ON_QUERY, "query", count, arguments, &o);
    if (result) return result;
    if (o.help)
        return help_command(
            ON_QUERY, "query [SCENE] --points FILE.csv [-o FILE.csv] [OPTIONS]",
            "Prints the water at points: height and normal of the surface that is drawn, and its motion.");
    if (!o.points) return usage_error("query needs --points FILE, a CSV file of x,y or x,y,z in metres");
    if (o.columns && !query_columns_parse(o.columns, &s.columns)) return EXIT_USAGE;
    if (o.output && strcmp(o.output, "-") == 0) o.output = NULL;
    if (bolan_points_open(strcmp(o.points, "-") == 0 ? "/dev/stdin" : o.points, &s.reader)) return EXIT_FAILED;
    result = o.output && bolan_file_check_writable(o.output) ? EXIT_FAILED : session_open(&o, &w);
    if (!result) {
        result = read_first(&s, &has_z) ? EXIT_OK : EXIT_FAILED;
        if (!o.columns) query_columns_parse(has_z ? QUERY_COLUMNS_BELOW : QUERY_COLUMNS_SURFACE, &s.columns);
        ask(&s, &o);
        if (!result) result = run_in(&s, &o, w);
        bolan_world_destroy(&w);
    }
    free(s.first);
    bolan_points_close(&s.reader);
    return result;
}
