// SPDX-License-Identifier: MIT
// The nested levels to the letter of Liu, Xu & Chen 2009.
#ifndef BOLAN_RENDER_PAPERS_NESTED_LEVELS_H
#define BOLAN_RENDER_PAPERS_NESTED_LEVELS_H

#include "render/water_mesh.h"

// The rules of the paper where the look asks for it; NULL: Bolan's own levels.
const mesh_rules *bolan_paper_nested_levels(const bolan_look *look);

#endif
