// SPDX-License-Identifier: MIT
// What `bolan export` writes. Each function gets options that were parsed, with an output, and returns an exit code.
#ifndef BOLAN_CLI_EXPORTS_H
#define BOLAN_CLI_EXPORTS_H

#include "options.h"

int export_spectrum(const options *o);
int export_mesh(const options *o);
int export_fields(const options *o);
int export_sky(const options *o);

#endif
