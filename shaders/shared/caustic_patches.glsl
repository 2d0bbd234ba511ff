// SPDX-License-Identifier: MIT
// The near patch of caustics has texels this many times finer than the wide one (src/render/caustics.c,
// common/gathered.glsl). C and GLSL.
#define CAUSTIC_FINER 3.0
