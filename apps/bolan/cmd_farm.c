// SPDX-License-Identifier: MIT
// bolan farm: the frames of a scene or the rows of a table, drawn by many processes: of this machine, of MPI, of Slurm.
#include "commands.h"
#include "farm_clean.h"
#include "farm_run.h"
#include "farm_slurm.h"
#include "help.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static const char what[] =
    "Draws frames by many processes; every file has the bytes that one process would write.\n"
    "SCENE: --frames of it, --fps apart. TABLE.csv: a row a frame, of the columns scene and options of scenes\n"
    "(wind, sea-state, seed, time, camera, sun, ...). FILE: a numbered name, sea-%04d.png or .exr, or a folder.\n"
    "Beside each frame stands its record NAME.json with all parameters and the SHA-256 of its files, beside all of "
    "them\n"
    "the manifest. What is finished is not drawn again. mpirun -n 8 bolan farm ... draws with eight ranks.";

// ---- before ---------------------------------------------------------------------------------------------------------

static const char *table_path;
static uint32_t table_line;

// A sentence about a row, with file and line.
static void print_of_row(void *user, bolan_log_level level, bolan_log_id id, const char *sentence) {
    (void)user, (void)id;
    if (level == BOLAN_LOG_ERROR) fprintf(stderr, "bolan: %s:%u: %s\n", table_path, (unsigned)table_line, sentence);
}

// Every row is checked before the first is drawn, and every frame that is finished found.
static int check_frames(const farm_job *job, farm_result *results) {
    bolan_scene scene;
    const bolan_hooks hooks = bolan_get_hooks();
    int code = EXIT_OK;
    table_path = job->table.path;
    if (job->has_table) bolan_set_hooks(&(bolan_hooks){.log = print_of_row});
    for (uint32_t i = 0; i < job->count && !code; i++) {
        if (job->has_table) table_line = job->table.rows[i].line;
        code = farm_job_scene(job, i, &scene);
        results[i].frame = i;
        if (!code && farm_record(job, i, &scene, false, &results[i])) results[i].state = FARM_DONE;
    }
    bolan_set_hooks(&hooks);
    return code;
}

// The folder of the output, and whether it can be written to.
static int open_folder(const farm_job *job) {
    char path[BOLAN_PATH_MAX];
    if (job->name.kind == OUTPUT_UNKNOWN && mkdir(job->path, 0777) != 0 && errno != EEXIST)
        return failure("%s: cannot be made: %s", job->path, strerror(errno));
    return farm_job_manifest(job, path) && !bolan_file_check_writable(path) ? EXIT_OK : EXIT_FAILED;
}

static uint32_t list_todo(const farm_job *job, const farm_result *results, uint32_t *todo) {
    uint32_t count = 0;
    for (uint32_t i = job->part; i < job->count; i += job->parts)
        if (results[i].state != FARM_DONE) todo[count++] = i;
    return count;
}

// ---- after ----------------------------------------------------------------------------------------------------------

static int report_failures(const farm_run *run) {
    enum { SHOWN = 5 };
    char list[5 * (FARM_SENTENCE + 32)];
    size_t used = 0;
    uint32_t failed = 0, open = 0;
    for (uint32_t i = 0; i < run->todo_count; i++) {
        const farm_result *r = &run->results[run->todo[i]];
        open += r->state == FARM_OPEN;
        if (r->state != FARM_FAILED || ++failed > SHOWN) continue;
        used += (size_t)snprintf(list + used, sizeof list - used, "%s%u (%.120s)", failed > 1 ? ", " : "",
                                 (unsigned)r->frame, r->reason);
    }
    if (failed + open == 0) return EXIT_OK;
    char left[64] = "";
    if (open) snprintf(left, sizeof left, ", and %u were not begun", (unsigned)open);
    return failure("%u of %u frames failed: %s%s%s; the same command draws what is missing", (unsigned)failed,
                   (unsigned)run->todo_count, list, failed > SHOWN ? ", ..." : "", left);
}

// The manifest is that of all frames. A part writes it when it finds that it was the last.
static int finish(const farm_job *job, farm_result *results) {
    char path[BOLAN_PATH_MAX];
    bolan_scene scene;
    for (uint32_t i = 0; job->parts > 1 && i < job->count; i++)
        if (results[i].state == FARM_OPEN &&
            (!farm_job_file(job, i, FARM_FILE_RECORD, path) || access(path, F_OK) != 0))
            return EXIT_OK;
    for (uint32_t i = 0; job->parts > 1 && i < job->count; i++)
        if (results[i].state == FARM_OPEN && !farm_job_scene(job, i, &scene) &&
            farm_record(job, i, &scene, false, &results[i]))
            results[i].state = FARM_DONE;
    const int code = farm_manifest_write(job, results);
    if (!code && !job->quiet && farm_job_manifest(job, path)) output_print(path), printf("\n");
    return code;
}

// The frames of this run in the order of their numbers, and what handing out has cost.
static int write_times(const farm_run *run) {
    char *text = NULL;
    size_t size = 0;
    FILE *file = run->job->given.times ? open_memstream(&text, &size) : NULL;
    if (!file) return EXIT_OK;
    fprintf(file, "frame,by,draw_s,taken_s\n");
    for (uint32_t i = 0; i < run->todo_count; i++) {
        const farm_result *r = &run->results[run->todo[i]];
        if (r->state == FARM_DONE)
            fprintf(file, "%u,%u,%.6f,%.6f\n", (unsigned)r->frame, (unsigned)r->by, r->draw, r->taken);
    }
    fprintf(file, "# processor time of the process that hands out: %.6f s\n", run->processor);
    const bool ok = fclose(file) == 0 && bolan_file_write(run->job->given.times, text, size) == BOLAN_OK;
    free(text);
    return ok ? EXIT_OK : EXIT_FAILED;
}

static uint32_t processors(void) {
    const long count = sysconf(_SC_NPROCESSORS_ONLN);
    return count > 1 ? (uint32_t)count : 1;
}

static int draw(const farm_job *job, const ranks *r, farm_run *run) {
    if (r->rank > 0) return farm_run_rank(run) ? EXIT_OK : EXIT_FAILED;
    int code = check_frames(job, run->results);
    if (!code) code = open_folder(job);
    for (int rank = 1; code && rank < r->count; rank++) ranks_give(rank, FARM_STOP);
    if (code) return code;
    run->todo_count = list_todo(job, run->results, run->todo);
    farm_clean(job, run->todo, run->todo_count);
    if (!farm_run_all(run, r)) return EXIT_FAILED;
    code = report_failures(run);
    const int finished = finish(job, run->results), told = write_times(run);
    return code ? code : finished ? finished : told;
}

static int run_job(const farm_job *job, const ranks *r, int count, char **arguments, bool *lost) {
    const uint32_t all = processors();
    farm_run run = {.job = job, .count = count, .arguments = arguments, .processes = all};
    if (!isnan(job->given.processes)) run.processes = (uint32_t)job->given.processes;
    run.threads = run.processes < all && r->count == 1 ? all / run.processes : 1;
    run.results = calloc(job->count, sizeof *run.results);
    run.todo = calloc(job->count, sizeof *run.todo);
    int code = run.results && run.todo ? EXIT_OK : failure("no memory for %u frames", (unsigned)job->count);
    if (!code) code = draw(job, r, &run);
    *lost = run.lost;
    free(run.results);
    free(run.todo);
    return code;
}

// One sentence, by rank 0.
static void say_nothing(void *user, bolan_log_level level, bolan_log_id id, const char *sentence) {
    (void)user, (void)level, (void)id, (void)sentence;
}

int command_farm(int count, char **arguments) {
    options o;
    farm_job job;
    ranks r;
    bool lost = false;
    int code = options_parse(ON_FARM, "farm", count, arguments, &o);
    if (code) return code;
    if (o.help) return help_command(ON_FARM, "farm [SCENE|TABLE.csv] -o FILE [OPTIONS]", what);
    code = ranks_begin(&r);
    if (r.rank > 0) bolan_set_hooks(&(bolan_hooks){.log = say_nothing});
    if (!code && r.count > 1 && !isnan(o.processes))
        code = usage_error("--processes does not go with mpirun, under which every rank draws");
    if (!code) {
        code = farm_job_read(&o, &job);
        if (!code && o.slurm)
            code = r.rank == 0 ? farm_slurm_write(&job, o.slurm, count, arguments) : EXIT_OK;
        else if (!code)
            code = run_job(&job, &r, count, arguments, &lost);
        farm_job_free(&job);
    }
    ranks_end(&r, lost);
    return code;
}
