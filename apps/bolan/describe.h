// SPDX-License-Identifier: MIT
// Parameters for people and for editors: their values in words, Markdown tables, and the JSON schema of scene files.
#ifndef BOLAN_CLI_DESCRIBE_H
#define BOLAN_CLI_DESCRIBE_H

#include "options.h"

enum { DESCRIBE_MAX = 512 };

// The values that a key takes, such as "0..70 m/s", with @p quote around each name; "" where every value is good.
void describe_values(const bolan_param *param, const char *quote, char *out, size_t capacity);
// The values of an option of the command line.
void describe_option_values(const option_info *info, const char *quote, char *out, size_t capacity);
// The sentence of an option.
const char *describe_option_help(const option_info *info);
// The commands that an option goes with, such as "view, render"; "all" where it goes with every one.
void describe_goes_with(const option_info *info, char *out, size_t capacity);
// Markdown: a section for each map of scene files and one for the options, each under a line "# NAME".
void describe_print_tables(FILE *file);
// The JSON schema (draft 7) of scene files.
void describe_print_schema(FILE *file);

#endif
