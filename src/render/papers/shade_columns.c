// SPDX-License-Identifier: MIT
// See shade_columns.h.
#include "render/papers/shade_columns.h"

uint32_t bolan_paper_columns(const bolan_look *look, bolan_quality quality) {
    static const uint32_t by_quality[] = {
        [BOLAN_QUALITY_LOW] = 4, [BOLAN_QUALITY_MEDIUM] = 2, [BOLAN_QUALITY_HIGH] = 1, [BOLAN_QUALITY_ULTRA] = 1};
    return look->paper ? 1 : by_quality[quality];
}
