// SPDX-License-Identifier: MIT
// The hooks in force, for the files of this folder only.
#ifndef BOLAN_BASE_HOOKS_H
#define BOLAN_BASE_HOOKS_H

#include "bolan/base.h"

/// The caller's hooks; a NULL member means the built-in behaviour.
const bolan_hooks *bolan_active_hooks(void);

#endif
