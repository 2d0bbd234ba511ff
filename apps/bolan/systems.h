// SPDX-License-Identifier: MIT
// The wind sea and the swells of a sea, as a table or as JSON.
#ifndef BOLAN_CLI_SYSTEMS_H
#define BOLAN_CLI_SYSTEMS_H

#include "bolan/spectrum.h"

// Prints a row a system; nothing for a calm. Both return false where memory is short, which was reported.
bool systems_print_table(const bolan_sea_state *sea_state);
// Prints a JSON array.
bool systems_print_json(const bolan_sea_state *sea_state);

#endif
