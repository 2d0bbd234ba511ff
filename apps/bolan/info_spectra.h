// SPDX-License-Identifier: MIT
// bolan info FILE: what a file of spectra holds.
#ifndef BOLAN_CLI_INFO_SPECTRA_H
#define BOLAN_CLI_INFO_SPECTRA_H

#include <stdbool.h>

// Prints it as a table or as JSON. Returns an exit code; failures were reported.
int info_spectra(const char *path, bool json);

#endif
