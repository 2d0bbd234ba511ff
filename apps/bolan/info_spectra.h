// SPDX-License-Identifier: MIT
// bolan info FILE: what a file of spectra holds.
#ifndef BOLAN_CLI_INFO_SPECTRA_H
#define BOLAN_CLI_INFO_SPECTRA_H

#include "options.h"

// Prints it as a table or as JSON, with the systems of the record that the options choose. Returns an exit code;
// failures were reported.
int info_spectra(const options *o);

#endif
