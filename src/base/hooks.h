// SPDX-License-Identifier: MIT
// The hooks in force, for the files of this folder only, and the mute of the log, for the library.
#ifndef BOLAN_BASE_HOOKS_H
#define BOLAN_BASE_HOOKS_H

#include "bolan/base.h"

/// The caller's hooks; a NULL member means the built-in behaviour.
const bolan_hooks *bolan_active_hooks(void);

/// No message of this thread reaches the hook until it is turned off again: for trials whose failure is a result.
void bolan_log_mute(bool on);

#endif
