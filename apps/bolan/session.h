// SPDX-License-Identifier: MIT
// The world of the options of a command.
#ifndef BOLAN_CLI_SESSION_H
#define BOLAN_CLI_SESSION_H

#include "options.h"

#include "bolan/io.h"

// Returns an exit code; failures were reported, and then *world is NULL.
int session_open(const options *o, bolan_world **world);
// Like session_open(), without ground and objects, for commands that need the open sea only.
int session_open_sea(const options *o, bolan_world **world);

// Refuses a camera below the water where the optics has no such view. Returns an exit code.
int session_check_camera(const bolan_world *world);

#endif
