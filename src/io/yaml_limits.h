// SPDX-License-Identifier: MIT
/// @file yaml_limits.h
/// Limits of a YAML text that bound the cost of libyaml. Private to src/io.
#ifndef BOLAN_IO_YAML_LIMITS_H
#define BOLAN_IO_YAML_LIMITS_H

#include "bolan/base.h"

enum { YAML_SIZE_LIMIT = 256 << 10, YAML_BRACKET_LIMIT = 4096, YAML_ANCHOR_LIMIT = 4096 };

/// FORMAT with a sentence where the text is longer than YAML_SIZE_LIMIT bytes, or holds more than YAML_BRACKET_LIMIT of
/// [ and {, or more than YAML_ANCHOR_LIMIT anchors and aliases.
bolan_result bolan_yaml_check_limits(const char *name, const char *text, size_t size);

#endif
