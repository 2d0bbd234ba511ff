// SPDX-License-Identifier: MIT
// The options of the command line. One table (options.c) serves every command, its help and its checks.
#ifndef BOLAN_CLI_OPTIONS_H
#define BOLAN_CLI_OPTIONS_H

#include "bolan/io.h"

#include <stdio.h>

// Exit codes.
enum { EXIT_OK = 0, EXIT_FAILED = 1, EXIT_USAGE = 2, EXIT_INTERRUPTED = 130 };

// Commands, as bits of option_info.commands.
enum {
    ON_VIEW = 1,
    ON_RENDER = 2,
    ON_MEASURE = 4,
    ON_QUERY = 8,
    ON_INFO = 16,
    ON_BAKE = 32,
    ON_SPECTRUM = 64, // of export
    ON_MESH = 128,
    ON_FIELDS = 256,
    ON_SKY = 512,
    ON_EXPORT = ON_SPECTRUM | ON_MESH | ON_FIELDS | ON_SKY,
    ON_FARM = 1024,
};

enum { MOST_OPTIONS = 96 }; // of all commands
// The parsed options. Of options that are no parameter, a number that was not given is NAN, a name -1, a text NULL.
typedef struct options {
    const char *scene;
    bool given[MOST_OPTIONS]; // those of the table
    bolan_scene edits; // the fields whose options were given
    // Keys of scene files that are no field of a scene.
    int technique;
    double beaufort;
    uint32_t sea_state;
    char record[32], location[64];
    // Options that are no parameter.
    double at[2], camera[6], sun[2]; // latitude, longitude; x, y, z, heading, pitch[, fov]; azimuth, elevation
    double fps, frames, samples, threads, tile, processes;
    double size[2];
    double least_wavelength, buoy[2], duration, rate;
    int quality, backend, pixels, stretching, completion;
    const char *spectrum, *terrain, *points, *columns, *output, *screenshot, *outputs, *slurm, *part, *times;
    bool record_time, taa, json, parameters, schema, man, quiet, help;
    double rect[4], spacing, origin[3]; // of an export
    const char *with;
    bool half;
} options;

typedef enum option_kind {
    OPTION_FLAG,
    OPTION_NUMBER,
    OPTION_WHOLE,
    OPTION_PARAM,   // by its row in the tables of scenes
    OPTION_NUMBERS, // separated by commas
    OPTION_SIZE,    // WxH
    OPTION_NAME,
    OPTION_TEXT,
} option_kind;

typedef struct option_info {
    const char *name; // without the dashes
    char letter;      // or 0
    option_kind kind;
    size_t offset;        // in options
    unsigned commands;    // ON_...
    const char *argument; // as in the help; NULL: the option takes no value
    const char *help;
    double low, high;
    int least, most;          // of NUMBERS
    const char *const *names; // of NAME, NULL at the end
    const char *unit;         // for messages, may be NULL
} option_info;

extern const option_info option_table[]; // a NULL name ends it

// Reads the arguments after the command's name. Prints one sentence and returns EXIT_USAGE on an error.
int options_parse(unsigned command, const char *command_name, int count, char **arguments, options *out);
// Reads further arguments; what they give replaces what was given before.
int options_parse_more(unsigned command, const char *command_name, int count, char **arguments, options *out);
// The option of this name without its dashes; NULL: there is none.
const option_info *options_find(const char *name, size_t length);
// Log one sentence through bolan_log(), which escapes control characters of the arguments, and return EXIT_USAGE or
// EXIT_FAILED.
#if defined(__GNUC__)
__attribute__((format(printf, 1, 2)))
#endif
int usage_error(const char *format, ...);
#if defined(__GNUC__)
__attribute__((format(printf, 1, 2)))
#endif
int failure(const char *format, ...);
// A word of the user for a sentence: at most 60 bytes, cut between characters, with "..." where there was more.
enum { SHORT_WORD = 64 };
const char *shorten(const char *text, char out[SHORT_WORD]);
// The row of an option of kind PARAM; its offset counts from struct options.
bolan_param option_param(const option_info *info);
// Whether the option of this name was given.
bool option_given(const options *o, const char *name);
// Copies the fields whose options were given to the scene.
void options_edit(const options *o, bolan_scene *scene);
// The options of a command, for its help.
void options_print(FILE *file, unsigned command);

// What is read of a spectrum file, by --record and the options beside it. Returns an exit code; failures were reported.
int options_spectrum(const options *o, bolan_spectrum_options *spectrum);
// The scene that is meant: loaded, changed by the options, and checked. Returns an exit code; failures were reported.
int options_scene(const options *o, bolan_scene *scene);

#endif
