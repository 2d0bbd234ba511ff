// SPDX-License-Identifier: MIT
// Half-rate shading of the papers' optics.
#ifndef BOLAN_RENDER_PAPERS_SHADE_COLUMNS_H
#define BOLAN_RENDER_PAPERS_SHADE_COLUMNS_H

#include "bolan/technique.h"

// Columns of pixels that share a sample, by quality; to the letter each pixel has its own.
uint32_t bolan_paper_columns(const bolan_look *look, bolan_quality quality);

#endif
