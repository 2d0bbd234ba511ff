// SPDX-License-Identifier: MIT
// See options.h.
#include "options.h"

#include <math.h>
#include <stdarg.h>
#include <string.h>

#define SCENE_COMMANDS (ON_VIEW | ON_RENDER | ON_MEASURE | ON_QUERY | ON_BAKE)
#define PICTURE_COMMANDS (ON_VIEW | ON_RENDER)
#define GROUND_COMMANDS (PICTURE_COMMANDS | ON_QUERY) // the others have no use for a sea bed

static const char *const technique_names[] = {"ocean",       "two-triangle", "exp-cosine",
                                              "nested-grid", "flight-sim",   NULL}; // the order of bolan_techniques()
static const char *const water_names[] = {"I", "IA", "IB", "II", "III", "1C", "3C", "5C", "7C", "9C", NULL};
static const char *const quality_names[] = {"low", "medium", "high", "ultra", NULL};
static const char *const backend_names[] = {"cpu", "compute", NULL};
static const char *const cpu_names[] = {"auto", "scalar", "sse2", "avx2", "avx512", NULL};

#define OPTION(long_name, type, member, goes_with, value, ...)                                                    \
    {                                                                                                             \
        .name = (long_name), .kind = OPTION_##type, .offset = offsetof(options, member), .commands = (goes_with), \
        .argument = (value), __VA_ARGS__                                                                          \
    }

// clang-format off
const option_info option_table[] = {
    OPTION("technique", NAME, technique, SCENE_COMMANDS, "NAME",
           .names = technique_names,
           .help = "a way to make water: ocean, two-triangle, exp-cosine, nested-grid or flight-sim"),
    OPTION("waves", NAME, waves, SCENE_COMMANDS, "MODEL",
           .names = bolan_wave_model_names, .help = "its wave model: fft, cosines, exp-cosine or textures"),
    OPTION("surface", NAME, surface, PICTURE_COMMANDS, "KIND",
           .names = bolan_surface_kind_names, .help = "its geometry: projected, nested or quad"),
    OPTION("optics", NAME, optics, PICTURE_COMMANDS, "KIND",
           .names = bolan_optics_kind_names, .help = "its light: physical, mirror, phong, lit or crest"),
    OPTION("paper", FLAG, paper, SCENE_COMMANDS, NULL,
           .help = "follow the technique's paper to the letter, also where we know better"),
    OPTION("effects", TEXT, effects, PICTURE_COMMANDS, "LIST",
           .help = "only these parts of the light, separated by commas: reflection, refraction, bump, distortion, glitter, "
                   "caustics, ambient, diffuse, specular, scattering, foam, fog; or none"),
    OPTION("show", NAME, show, PICTURE_COMMANDS, "WHAT",
           .names = bolan_show_names, .help = "picture, mask (false colours) or mesh"),
    OPTION("wind", NUMBER, wind, SCENE_COMMANDS, "MPS",
           .low = 0, .high = 70, .unit = "m/s", .help = "wind speed at 10 m; rebuilds the wind sea, keeps swells"),
    OPTION("wind-from", NUMBER, wind_from, SCENE_COMMANDS, "DEG",
           .low = -360, .high = 360, .unit = "degrees", .help = "where the wind comes from, compass degrees"),
    OPTION("fetch", NUMBER, fetch_km, SCENE_COMMANDS, "KM",
           .low = 0.1, .high = 1e4, .unit = "km", .help = "open water to windward"),
    OPTION("beaufort", NUMBER, beaufort, SCENE_COMMANDS, "B",
           .low = 0, .high = 12, .help = "fully developed sea of a wind force, 0..12"),
    OPTION("sea-state", WHOLE, sea_state, SCENE_COMMANDS, "D",
           .low = 0, .high = 9, .help = "fully developed sea of a Douglas degree, 0..9"),
    OPTION("spectrum", TEXT, spectrum, SCENE_COMMANDS, "NAME|FILE",
           .help = "jonswap, pm, tma, phillips, or a measured spectrum (SWAN, WAVEWATCH III, NDBC)"),
    OPTION("record", TEXT, record, SCENE_COMMANDS, "N|DATE",
           .help = "which record in time of that file: 0, the earliest, or a date such as 2018-01-01T06:00"),
    OPTION("location", TEXT, location, SCENE_COMMANDS, "N|LON,LAT",
           .help = "which location of that file: 1, the first, or the nearest to a place"),
    OPTION("from", NUMBER, from, SCENE_COMMANDS, "DEG",
           .low = -360, .high = 360, .unit = "degrees",
           .help = "where its waves come from, compass degrees, if it does not say"),
    OPTION("spread", NUMBER, spread, SCENE_COMMANDS, "S",
           .low = 0, .high = 200, .help = "exponent of its cos-2s spreading, 0..200, if it does not say"),
    OPTION("depth", NUMBER, depth, SCENE_COMMANDS, "M",
           .low = 0.1, .high = BOLAN_DEEP, .unit = "m", .help = "water depth for the waves"),
    OPTION("seed", INTEGER, seed, SCENE_COMMANDS, "N",
           .low = 0, .high = 0x1p64, .help = "which sea of this state"),
    OPTION("time", NUMBER, time, SCENE_COMMANDS, "S",
           .low = -1e9, .high = 1e9, .unit = "s", .help = "seconds"),
    OPTION("terrain", TEXT, terrain, GROUND_COMMANDS, "FILE",
           .help = "a raster of elevations (any GDAL format), island, or none"),
    OPTION("at", NUMBERS, at, GROUND_COMMANDS, "LAT,LON",
           .low = -360, .high = 360, .least = 2, .most = 2, .unit = "degrees",
           .help = "where in the raster the scene's origin lies"),
    OPTION("water", NAME, water, PICTURE_COMMANDS | ON_BAKE, "TYPE",
           .names = water_names, .help = "Jerlov's water type: I IA IB II III 1C 3C 5C 7C 9C"),
    OPTION("camera", NUMBERS, camera, PICTURE_COMMANDS, "X,Y,Z,HEADING,PITCH[,FOV]",
           .low = -1e7, .high = 1e7, .least = 5, .most = 6, .help = "metres; compass degrees; degrees up"),
    OPTION("sun", NUMBERS, sun, PICTURE_COMMANDS | ON_BAKE, "AZIMUTH,ELEVATION",
           .low = -360, .high = 360, .least = 2, .most = 2, .unit = "degrees", .help = "compass degrees; degrees up"),
    OPTION("quality", NAME, quality, PICTURE_COMMANDS, "LEVEL",
           .names = quality_names, .help = "low, medium, high or ultra"),
    OPTION("size", SIZE, size, PICTURE_COMMANDS, "WxH",
           .low = 16, .high = 16384, .help = "pixels"),
    OPTION("samples", WHOLE, samples, ON_RENDER, "N",
           .low = 1, .high = 256, .help = "pictures with shifted pixels that are averaged, 1..256"),
    OPTION("frames", WHOLE, frames, PICTURE_COMMANDS | ON_BAKE, "N",
           .low = 1, .high = 1e6, .help = "how many; by default 10 seconds of them (render), 32 (bake), or until you quit (view)"),
    OPTION("fps", NUMBER, fps, ON_RENDER, "F",
           .low = 1, .high = 240, .help = "frames a second, 1..240; 30 by default"),
    OPTION("backend", NAME, backend, SCENE_COMMANDS, "NAME",
           .names = backend_names, .help = "who makes the waves: cpu or compute"),
    OPTION("threads", WHOLE, threads, SCENE_COMMANDS, "N",
           .low = 0, .high = 64, .help = "threads, 0..64; 0 (default): one per processor"),
    OPTION("cpu", NAME, cpu, SCENE_COMMANDS, "SET",
           .names = cpu_names, .help = "auto, scalar, sse2, avx2 or avx512; no bit of the result changes"),
    OPTION("points", TEXT, points, ON_QUERY, "FILE",
           .help = "CSV of x,y[,z] in metres; - is standard input"),
    OPTION("output", TEXT, output, ON_RENDER | ON_QUERY | ON_BAKE, "FILE",
           .letter = 'o', .help = "where to write"),
    OPTION("screenshot", TEXT, screenshot, ON_VIEW, "FILE",
           .help = "the last frame as PNG"),
    OPTION("json", FLAG, json, ON_MEASURE | ON_INFO, NULL,
           .help = "one JSON object on standard output"),
    OPTION("quiet", FLAG, quiet, SCENE_COMMANDS, NULL,
           .letter = 'q', .help = "nothing but errors and results"),
    OPTION("help", FLAG, help, ~0u, NULL,
           .letter = 'h', .help = "this text"),
    {.name = NULL},
};
// clang-format on

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
    case OPTION_INTEGER: snprintf(expected, sizeof expected, "a whole number from 0 to 18446744073709551615"); break;
    case OPTION_NUMBERS: snprintf(expected, sizeof expected, "%s", info->argument); break;
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

// A whole number of 64 bits, every one exactly, written with nothing but digits.
static bool integer(const char *text, option_integer *out) {
    uint64_t value = 0;
    for (const char *p = text; *p; p++) {
        if (*p < '0' || *p > '9') return false;
        const uint64_t digit = (uint64_t)(*p - '0');
        if (value > (UINT64_MAX - digit) / 10) return false;
        value = 10 * value + digit;
    }
    *out = (option_integer){*text != '\0', value};
    return out->given;
}

static bool set_value(const option_info *info, const char *value, options *o) {
    void *member = (char *)o + info->offset;
    switch (info->kind) {
    case OPTION_FLAG: *(bool *)member = true; return true;
    case OPTION_TEXT: *(const char **)member = value; return *value != '\0' && strlen(value) < BOLAN_PATH_MAX;
    case OPTION_NUMBER:
    case OPTION_WHOLE: return numbers(info, value, '\0', 1, 1, member);
    case OPTION_INTEGER: return integer(value, member);
    case OPTION_NUMBERS: return numbers(info, value, ',', info->least, info->most, member);
    case OPTION_SIZE: return numbers(info, value, 'x', 2, 2, member);
    case OPTION_NAME:
        for (int i = 0; info->names[i]; i++)
            if (strcmp(info->names[i], value) == 0) return *(int *)member = i, true;
        if (info->names == water_names) return (*(int *)member = bolan_jerlov_from_name(value)) >= 0;
    }
    return false;
}

// ---- arguments ------------------------------------------------------------------------------------------------------

static const option_info *find_option(const char *argument, size_t length) {
    for (const option_info *i = option_table; i->name; i++) {
        if (length == 2 && argument[0] == '-' && argument[1] == i->letter) return i;
        if (length > 2 && strlen(i->name) == length - 2 && strncmp(i->name, argument + 2, length - 2) == 0) return i;
    }
    return NULL;
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
    if (info->kind == OPTION_FLAG && equals) return usage_error("--%s takes no value", info->name);
    const char *value = equals ? equals + 1 : "";
    if (info->kind != OPTION_FLAG && !equals) {
        if (*index + 1 >= count) return usage_error("--%s needs a value: %s", info->name, info->argument);
        value = arguments[++*index];
    }
    return set_value(info, value, o) ? EXIT_OK : bad_value(info, value);
}

int options_parse(unsigned command, const char *command_name, int count, char **arguments, options *out) {
    *out = nothing_given();
    bool only_names = false;
    for (int i = 0; i < count; i++) {
        if (!only_names && strcmp(arguments[i], "--") == 0) {
            only_names = true;
        } else if (!only_names && is_option(arguments[i])) {
            const int result = parse_option(command, command_name, count, arguments, &i, out);
            if (result) return result;
        } else if (out->scene || command == ON_INFO) {
            char word[SHORT_WORD];
            return usage_error("unexpected %s; bolan %s takes %s", shorten(arguments[i], word), command_name,
                               command == ON_INFO ? "only options" : "one scene");
        } else {
            out->scene = arguments[i];
        }
    }
    return EXIT_OK;
}

void options_print(FILE *file, unsigned command) {
    for (const option_info *i = option_table; i->name; i++) {
        if (!(i->commands & command)) continue;
        char left[64], letter[8] = "    ";
        if (i->letter) snprintf(letter, sizeof letter, "-%c, ", i->letter);
        snprintf(left, sizeof left, "%s--%s%s%s", letter, i->name, i->argument ? " " : "",
                 i->argument ? i->argument : "");
        if (strlen(left) > 26) {
            fprintf(file, "  %s\n  %-26s  %s\n", left, "", i->help);
        } else {
            fprintf(file, "  %-26s  %s\n", left, i->help);
        }
    }
}
