// SPDX-License-Identifier: MIT
// bolan measure --buoy: a buoy that rides on a parcel of the sea, its record as CSV, and its statistics.
#ifndef BOLAN_CLI_BUOY_H
#define BOLAN_CLI_BUOY_H

#include "options.h"

#include "bolan/waves.h"

// Whether the options of a buoy go together; says one sentence and returns false where they do not.
bool buoy_options_check(const options *o);
// Records and prints. Returns an exit code; failures were reported.
int buoy_measure(const options *o, const bolan_sea *sea);

#endif
