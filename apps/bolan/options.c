// SPDX-License-Identifier: MIT
// See options.h.
#include "options.h"

#include "completion.h"
#include "describe.h"

#include <math.h>
#include <stdarg.h>
#include <string.h>

#define SCENE_COMMANDS (ON_VIEW | ON_RENDER | ON_MEASURE | ON_QUERY | ON_BAKE | ON_EXPORT | ON_FARM)
#define SPECTRUM_COMMANDS (SCENE_COMMANDS | ON_INFO)
#define PICTURE_COMMANDS (ON_VIEW | ON_RENDER | ON_FARM)
#define FILE_COMMANDS (ON_RENDER | ON_FARM)                                 // images without a window
#define GROUND_COMMANDS (PICTURE_COMMANDS | ON_QUERY | ON_MESH | ON_FIELDS) // the other commands do not read a sea bed

static const char *const stretching_names[] = {"none", "wheeler", NULL}; // by bolan_stretching

// An option of the command line alone.
#define OPTION(long_name, type, member, goes_with, value, ...)                                                    \
    {                                                                                                             \
        .name = (long_name), .kind = OPTION_##type, .offset = offsetof(options, member), .commands = (goes_with), \
        .argument = (value), __VA_ARGS__                                                                          \
    }
// A parameter of a scene; its row in the tables has values, range and help.
#define OF_SCENE(long_name, goes_with, value) OPTION(long_name, PARAM, edits, goes_with, value, .help = NULL)
// A key of scene files that is no field of a scene.
#define OF_FILE(long_name, member, goes_with, value) OPTION(long_name, PARAM, member, goes_with, value, .help = NULL)

// clang-format off
const char *const completion_shells[] = {"bash", "zsh", "fish", NULL};

const option_info option_table[] = {
    OF_FILE("technique", technique, SCENE_COMMANDS, "NAME"),
    OF_SCENE("waves", SCENE_COMMANDS, "MODEL"),
    OF_SCENE("surface", PICTURE_COMMANDS, "KIND"),
    OF_SCENE("optics", PICTURE_COMMANDS, "KIND"),
    OF_SCENE("paper", SCENE_COMMANDS, NULL),
    OF_SCENE("effects", PICTURE_COMMANDS, "LIST"),
    OF_SCENE("show", PICTURE_COMMANDS, "WHAT"),
    OF_SCENE("wind", SCENE_COMMANDS, "MPS"),
    OF_SCENE("wind-from", SCENE_COMMANDS, "DEG"),
    OF_SCENE("fetch", SCENE_COMMANDS, "KM"),
    OF_FILE("beaufort", beaufort, SCENE_COMMANDS, "B"),
    OF_FILE("sea-state", sea_state, SCENE_COMMANDS, "D"),
    OPTION("spectrum", TEXT, spectrum, SCENE_COMMANDS, "NAME|FILE",
           .help = "jonswap, pm, tma, phillips, donelan, elfouhaily; or a file of measured "
                   "spectra in the place of all waves"),
    OF_FILE("record", record, SPECTRUM_COMMANDS, "N|DATE"),
    OF_FILE("location", location, SPECTRUM_COMMANDS, "N|LON,LAT"),
    OF_SCENE("interpolate", SPECTRUM_COMMANDS, NULL),
    OF_SCENE("from", SPECTRUM_COMMANDS, "DEG"),
    OF_SCENE("spread", SPECTRUM_COMMANDS, "S"),
    OF_SCENE("depth", SCENE_COMMANDS, "M"),
    OF_SCENE("order", SCENE_COMMANDS, "N"),
    OF_SCENE("seed", SCENE_COMMANDS, "N"),
    OF_SCENE("time", SCENE_COMMANDS, "S"),
    OPTION("terrain", TEXT, terrain, GROUND_COMMANDS, "FILE",
           .help = "a raster of elevations (a file, or a name of GDAL's such as NETCDF:f.nc:z), island, or none"),
    OPTION("at", NUMBERS, at, GROUND_COMMANDS, "LAT,LON",
           .low = -360, .high = 360, .least = 2, .most = 2, .unit = "degrees",
           .help = "where in the raster the scene's origin lies"),
    OF_SCENE("water", PICTURE_COMMANDS | ON_BAKE, "TYPE"),
    OPTION("camera", NUMBERS, camera, PICTURE_COMMANDS | ON_MESH | ON_SKY, "X,Y,Z,HEADING,PITCH[,FOV]",
           .low = -1e7, .high = 1e7, .least = 5, .most = 6, .help = "metres; compass degrees; degrees up; degrees"),
    OPTION("sun", NUMBERS, sun, PICTURE_COMMANDS | ON_BAKE | ON_SKY, "AZIMUTH,ELEVATION",
           .low = -360, .high = 360, .least = 2, .most = 2, .unit = "degrees", .help = "compass degrees; degrees up"),
    OPTION("quality", NAME, quality, PICTURE_COMMANDS | ON_SKY, "LEVEL",
           .names = bolan_quality_names, .help = "how much an image may cost; high for render, medium for view"),
    OPTION("size", SIZE, size, PICTURE_COMMANDS | ON_MESH | ON_SKY, "WxH",
           .low = 16, .high = 65536,
           .help = "pixels: 1920x1080 for one image, 1280x720 for a sequence, film, window or mesh, "
                   "2048x1024 for a sky"),
    OPTION("samples", WHOLE, samples, FILE_COMMANDS | ON_VIEW, "N",
           .low = 1, .high = 256,
           .help = "images with shifted pixels that are averaged; "
                   "one image takes 1, 1, 4, 16 by quality, moving ones 1. view: begin paused and refine to so many"),
    OPTION("taa", FLAG, taa, ON_RENDER, NULL,
           .help = "temporal antialiasing: each image is blended with those before it; of one image, 16 of the same "
                   "moment"),
    OPTION("tile", WHOLE, tile, FILE_COMMANDS, "N",
           .low = 448, .high = 16384,
           .help = "largest side drawn at once, in pixels, above which tiles are drawn; by default what OpenGL can"),
    OPTION("frames", WHOLE, frames, PICTURE_COMMANDS | ON_BAKE | ON_MESH | ON_FIELDS, "N",
           .low = 1, .high = 1e6,
           .help = "how many; by default 10 seconds of them (render, farm), 32 (bake), one (export), or until you quit "
                   "(view)"),
    OPTION("fps", NUMBER, fps, FILE_COMMANDS | ON_MESH | ON_FIELDS, "F",
           .low = 1, .high = 240, .help = "frames a second; 30 by default"),
    OPTION("backend", NAME, backend, PICTURE_COMMANDS, "NAME",
           .names = bolan_backend_names,
           .help = "what makes the waves that are drawn; auto: compute shaders on a GPU that has them, else cpu"),
    OPTION("pixels", NAME, pixels, PICTURE_COMMANDS, "NAME",
           .names = bolan_pixels_names,
           .help = "what shades the pixels of water; auto: compute shaders on a GPU that has them, else fragment"),
    OPTION("threads", WHOLE, threads, SCENE_COMMANDS, "N",
           .low = 0, .high = 64, .help = "0 (default): one per processor; no bit of a result depends on it"),
    OF_SCENE("cpu", SCENE_COMMANDS, "SET"),
    OPTION("points", TEXT, points, ON_QUERY, "FILE",
           .help = "CSV of x,y[,z] in metres; - is standard input"),
    OPTION("columns", TEXT, columns, ON_QUERY, "LIST",
           .help = "which columns: x, y, z, height, normal, jacobian, residual, foam, rise, velocity, "
                   "acceleration, pressure, wet"),
    OPTION("least-wavelength", NUMBER, least_wavelength, ON_QUERY, "M",
           .low = 0, .high = 1e5, .unit = "m",
           .help = "waves shorter than this are left out of height, normal, rise, velocity, acceleration and pressure"),
    OPTION("stretching", NAME, stretching, ON_QUERY, "NAME",
           .names = stretching_names, .help = "how linear theory is continued to the surface; none by default"),
    OPTION("buoy", NUMBERS, buoy, ON_MEASURE, "X,Y",
           .low = -1e7, .high = 1e7, .least = 2, .most = 2, .unit = "m",
           .help = "the record of a buoy that is moored there: waves between zero-crossings, directional spectrum"),
    OPTION("duration", NUMBER, duration, ON_MEASURE, "S",
           .low = 1, .high = 86400, .unit = "s", .help = "of the buoy's record; 1800 by default"),
    OPTION("rate", NUMBER, rate, ON_MEASURE, "HZ",
           .low = 0.1, .high = 50, .unit = "Hz", .help = "samples a second of the buoy's record; 2 by default"),
    OPTION("record-time", FLAG, record_time, ON_MEASURE, NULL,
           .help = "only when the measured spectrum was taken, ISO 8601"),
    OPTION("rect", NUMBERS, rect, ON_MESH | ON_FIELDS, "X0,Y0,X1,Y1",
           .low = -1e7, .high = 1e7, .least = 4, .most = 4, .unit = "m",
           .help = "the rectangle of the world, south-west and north-east corner"),
    OPTION("spacing", NUMBER, spacing, ON_MESH | ON_FIELDS, "M",
           .low = 0.001, .high = 1e5, .unit = "m",
           .help = "distance of neighbouring points; 0.5 by default; without --rect a square of 513 points a "
                   "side round the camera"),
    OPTION("origin", NUMBERS, origin, ON_MESH, "X,Y[,Z]",
           .low = -1e7, .high = 1e7, .least = 2, .most = 3, .unit = "m",
           .help = "the place of the world that is the origin of the file"),
    OPTION("with", TEXT, with, ON_MESH, "ground",
           .help = "the ground too"),
    OPTION("half", FLAG, half, ON_FIELDS, NULL,
           .help = "16-bit floats in an .exr"),
    OPTION("output", TEXT, output, FILE_COMMANDS | ON_QUERY | ON_BAKE | ON_EXPORT | ON_MEASURE, "FILE",
           .letter = 'o', .help = "where to write"),
    OPTION("outputs", TEXT, outputs, ON_FARM, "LIST",
           .help = "of each frame: picture, linear, distance, normal, segmentation, motion; picture by default"),
    OPTION("processes", WHOLE, processes, ON_FARM, "N",
           .low = 1, .high = 1024, .help = "how many draw beside each other; by default one per processor, "
                                           "under mpirun one per rank"),
    OPTION("part", TEXT, part, ON_FARM, "K/N",
           .help = "only the frames K, K + N, K + 2 N ... from 0, as a task of an array does"),
    OPTION("times", TEXT, times, ON_FARM, "FILE",
           .help = "CSV of what each frame took: its process or rank, drawing, from hand-out to answer"),
    OPTION("slurm", TEXT, slurm, ON_FARM, "FILE",
           .help = "writes a Slurm array script that does the work, and draws nothing"),
    OPTION("screenshot", TEXT, screenshot, ON_VIEW, "FILE",
           .help = "the last frame as PNG"),
    OPTION("json", FLAG, json, ON_MEASURE | ON_INFO, NULL,
           .help = "one JSON object on standard output"),
    OPTION("parameters", FLAG, parameters, ON_INFO, NULL,
           .help = "the keys of scene files and the options of commands, as Markdown tables"),
    OPTION("schema", FLAG, schema, ON_INFO, NULL,
           .help = "the JSON schema of scene files, for editors"),
    OPTION("man", FLAG, man, ON_INFO, NULL,
           .help = "the manual page of this program, for `man`"),
    OPTION("completion", NAME, completion, ON_INFO, "SHELL",
           .names = completion_shells, .help = "the commands and options, for the completion of a shell"),
    OPTION("quiet", FLAG, quiet, SCENE_COMMANDS, NULL,
           .letter = 'q', .help = "nothing but errors and results"),
    OPTION("help", FLAG, help, ~0u, NULL,
           .letter = 'h', .help = "this text"),
    {.name = NULL},
};
// clang-format on
_Static_assert(sizeof option_table / sizeof *option_table - 1 <= MOST_OPTIONS, "options.given has a place for each");

// ---- parameters -----------------------------------------------------------------------------------------------------

// The row of an option in a list of groups; its offset counts from the struct of the groups.
static bool find_row(const bolan_param_group *groups, const char *option, bolan_param *row) {
    for (const bolan_param_group *g = groups; g->table; g++)
        for (uint32_t i = 0; i < g->table->count; i++) {
            const bolan_param *p = &g->table->params[i];
            if (!p->option || strcmp(p->option, option) != 0) continue;
            *row = *p;
            row->offset += g->offset;
            return true;
        }
    return false;
}

bolan_param option_param(const option_info *info) {
    bolan_param row = {.field = info->name};
    if (find_row(bolan_scene_groups, info->name, &row)) {
        row.offset += offsetof(options, edits);
    } else if (find_row(bolan_scene_file_groups, info->name, &row)) {
        row.offset = info->offset;
    } else {
        BOLAN_ASSERT(false && "an option without a row");
    }
    return row;
}

bool option_given(const options *o, const char *name) {
    for (int i = 0; option_table[i].name; i++)
        if (strcmp(option_table[i].name, name) == 0) return o->given[i];
    BOLAN_ASSERT(false && "no such option");
    return false;
}

void options_edit(const options *o, bolan_scene *scene) {
    for (int i = 0; option_table[i].name; i++) {
        bolan_param row;
        if (!o->given[i] || !find_row(bolan_scene_groups, option_table[i].name, &row)) continue;
        memcpy((char *)scene + row.offset, (const char *)&o->edits + row.offset, row.size);
    }
}

int usage_error(const char *format, ...) {
    char sentence[2048];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(sentence, sizeof sentence, format, arguments);
    va_end(arguments);
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_BAD_ARGUMENT, "%s", sentence);
    return EXIT_USAGE;
}

int failure(const char *format, ...) {
    char sentence[2048];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(sentence, sizeof sentence, format, arguments);
    va_end(arguments);
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_UNSUPPORTED, "%s", sentence);
    return EXIT_FAILED;
}

const char *shorten(const char *text, char out[SHORT_WORD]) {
    const size_t length = bolan_text_fit(text, 60);
    snprintf(out, SHORT_WORD, "%.*s%s", (int)length, text, text[length] ? "..." : "");
    return out;
}

static options nothing_given(void) {
    options o;
    memset(&o, 0, sizeof o);
    for (const option_info *i = option_table; i->name; i++) {
        char *member = (char *)&o + i->offset;
        const double absent = (double)NAN;
        const int count = i->kind == OPTION_NUMBERS ? i->most : i->kind == OPTION_SIZE ? 2 : 1;
        if (i->kind == OPTION_NAME) *(int *)(void *)member = -1;
        if (i->kind == OPTION_NUMBER || i->kind == OPTION_WHOLE || i->kind == OPTION_NUMBERS || i->kind == OPTION_SIZE)
            for (int k = 0; k < count; k++) ((double *)(void *)member)[k] = absent;
    }
    return o;
}

// ---- values ---------------------------------------------------------------------------------------------------------

static int bad_value(const option_info *info, const char *value) {
    char expected[256] = "", word[SHORT_WORD];
    const char *unit = info->unit ? info->unit : "";
    size_t used = 0;
    switch (info->kind) {
    case OPTION_NAME:
        for (int i = 0; info->names[i]; i++)
            used += (size_t)snprintf(expected + used, sizeof expected - used, "%s%s", i ? ", " : "", info->names[i]);
        break;
    case OPTION_PARAM: {
        const bolan_param row = option_param(info);
        bolan_param_expected(&row, expected, sizeof expected);
        if (row.kind == BOLAN_PARAM_TEXT) snprintf(expected, sizeof expected, "%s", info->argument);
        break;
    }
    case OPTION_NUMBERS:
        used = (size_t)snprintf(expected, sizeof expected, "%s", info->argument);
        if (info->unit) // otherwise each number has its own
            bolan_format(expected + used, sizeof expected - used, ", numbers from %.10g to %.10g %s", info->low,
                         info->high, unit);
        break;
    case OPTION_SIZE:
        bolan_format(expected, sizeof expected, "WIDTHxHEIGHT, each %.0f to %.0f", info->low, info->high);
        break;
    case OPTION_TEXT: snprintf(expected, sizeof expected, "%s", info->argument); break;
    default:
        bolan_format(expected, sizeof expected, "a %snumber from %.10g to %.10g%s%s",
                     info->kind == OPTION_WHOLE ? "whole " : "", info->low, info->high, *unit ? " " : "", unit);
    }
    return usage_error("--%s is %s; expected %s", info->name, *value ? shorten(value, word) : "empty", expected);
}

static bool in_range(const option_info *info, double value) {
    const bool whole = info->kind == OPTION_WHOLE || info->kind == OPTION_SIZE;
    return value >= info->low && value <= info->high && (!whole || value == floor(value));
}

// Numbers separated by one character.
static bool numbers(const option_info *info, const char *text, char separator, int least, int most, double *out) {
    int count = 0;
    for (const char *p = text;; count++) {
        const char *next = separator ? strchr(p, separator) : NULL, *end = next ? next : p + strlen(p);
        if (count == most || !bolan_parse_number(p, (size_t)(end - p), &out[count]) || !in_range(info, out[count]))
            return false;
        if (!next) break;
        p = next + 1;
    }
    return count + 1 >= least;
}

static bool set_value(const option_info *info, const char *value, options *o) {
    void *member = (char *)o + info->offset;
    switch (info->kind) {
    case OPTION_FLAG: *(bool *)member = true; return true;
    case OPTION_TEXT: *(const char **)member = value; return *value != '\0' && strlen(value) < BOLAN_PATH_MAX;
    case OPTION_NUMBER:
    case OPTION_WHOLE: return numbers(info, value, '\0', 1, 1, member);
    case OPTION_PARAM: {
        const bolan_param row = option_param(info);
        return bolan_param_parse(&row, info->argument ? value : "true", info->argument ? strlen(value) : 4, o);
    }
    case OPTION_NUMBERS: return numbers(info, value, ',', info->least, info->most, member);
    case OPTION_SIZE: return numbers(info, value, 'x', 2, 2, member);
    case OPTION_NAME:
        for (int i = 0; info->names[i]; i++)
            if (strcmp(info->names[i], value) == 0) return *(int *)member = i, true;
    }
    return false;
}

// ---- arguments ------------------------------------------------------------------------------------------------------

const option_info *options_find(const char *name, size_t length) {
    for (const option_info *i = option_table; i->name; i++)
        if (strlen(i->name) == length && strncmp(i->name, name, length) == 0) return i;
    return NULL;
}

static const option_info *find_option(const char *argument, size_t length) {
    for (const option_info *i = option_table; i->name; i++) {
        if (length == 2 && argument[0] == '-' && argument[1] == i->letter) return i;
    }
    return length > 2 ? options_find(argument + 2, length - 2) : NULL;
}

static bool is_option(const char *argument) {
    return argument[0] == '-' && argument[1] != '\0' && strcmp(argument, "-") != 0;
}

// One option at *index, with its value: "--wind 12" or "--wind=12".
static int parse_option(unsigned command, const char *command_name, int count, char **arguments, int *index,
                        options *o) {
    const char *argument = arguments[*index], *equals = argument[1] == '-' ? strchr(argument, '=') : NULL;
    const size_t length = equals ? (size_t)(equals - argument) : strlen(argument);
    const option_info *info = argument[1] == '-' || length == 2 ? find_option(argument, length) : NULL;
    char word[SHORT_WORD];
    if (!info) return usage_error("unknown option %s; see bolan %s --help", shorten(argument, word), command_name);
    if (!(info->commands & command)) return usage_error("--%s does not go with bolan %s", info->name, command_name);
    if (!info->argument && equals) return usage_error("--%s takes no value", info->name);
    const char *value = equals ? equals + 1 : "";
    if (info->argument && !equals) {
        if (*index + 1 >= count) return usage_error("--%s needs a value: %s", info->name, info->argument);
        value = arguments[++*index];
    }
    if (!set_value(info, value, o)) return bad_value(info, value);
    o->given[info - option_table] = true;
    return EXIT_OK;
}

int options_parse(unsigned command, const char *command_name, int count, char **arguments, options *out) {
    *out = nothing_given();
    return options_parse_more(command, command_name, count, arguments, out);
}

int options_parse_more(unsigned command, const char *command_name, int count, char **arguments, options *out) {
    bool only_names = false;
    for (int i = 0; i < count; i++) {
        if (!only_names && strcmp(arguments[i], "--") == 0) {
            only_names = true;
        } else if (!only_names && is_option(arguments[i])) {
            const int result = parse_option(command, command_name, count, arguments, &i, out);
            if (result) return result;
        } else if (out->scene) {
            char word[SHORT_WORD];
            return usage_error("unexpected %s; bolan %s takes one %s", shorten(arguments[i], word), command_name,
                               command == ON_INFO ? "file" : "scene");
        } else {
            out->scene = arguments[i];
        }
    }
    return EXIT_OK;
}

// The sentence of an option and the values that it takes, for a terminal.
static void print_help(FILE *file, const option_info *info) {
    char values[DESCRIBE_MAX];
    describe_option_values(info, "", values, sizeof values);
    for (const char *p = describe_option_help(info); *p; p++)
        if (*p != '`') fputc(*p, file);
    fprintf(file, *values ? " (%s)\n" : "%s\n", values);
}

void options_print(FILE *file, unsigned command) {
    for (const option_info *i = option_table; i->name; i++) {
        if (!(i->commands & command)) continue;
        char left[64], letter[8] = "    ";
        if (i->letter) snprintf(letter, sizeof letter, "-%c, ", i->letter);
        snprintf(left, sizeof left, "%s--%s%s%s", letter, i->name, i->argument ? " " : "",
                 i->argument ? i->argument : "");
        fprintf(file, strlen(left) > 26 ? "  %s\n  %-26s  " : "  %s%-.0s", left, "");
        if (strlen(left) <= 26) fprintf(file, "%*s  ", (int)(26 - strlen(left)), "");
        print_help(file, i);
    }
}
