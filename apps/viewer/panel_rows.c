// SPDX-License-Identifier: MIT
// See panel_rows.h.
#include "panel_rows.h"

#include <stdio.h>
#include <string.h>

#define KEY_OF(name, key) key,
static const char *const keys[PANEL_ROW_COUNT] = {PANEL_ROWS(KEY_OF)};

static panel_row row_of(const bolan_param *p, const char *key) {
    const char *unit = p->factor > 0.0 ? p->factor_unit : p->unit ? p->unit : "";
    const bool degrees = strcmp(unit, "degrees") == 0, usual = p->usual_high > p->usual_low;
    panel_row row = {.factor = p->factor > 0.0 ? p->factor : 1.0,
                     .logarithmic = (p->rules & BOLAN_PARAM_LOGARITHMIC) != 0};
    row.low = usual ? p->usual_low : p->low / row.factor;
    row.high = usual ? p->usual_high : p->high / row.factor;
    snprintf(row.label, sizeof row.label, "%s##%s", p->label ? p->label : p->field, key);
    // A number around zero that is no angle shows its sign.
    snprintf(row.format, sizeof row.format, "%%%s.%df%s%s", row.low < 0.0 && !degrees ? "+" : "", p->digits,
             *unit ? " " : "", degrees ? "deg" : unit);
    return row;
}

void panel_rows_make(panel_row rows[PANEL_ROW_COUNT]) {
    for (int i = 0; i < PANEL_ROW_COUNT; i++) {
        uint32_t count = 0;
        const bolan_param *p = bolan_param_find_key(bolan_scene_groups, keys[i], NULL, &count);
        if (!p) p = bolan_param_find_key(bolan_scene_file_groups, keys[i], NULL, &count);
        BOLAN_ASSERT(p);
        if (p) rows[i] = row_of(p, keys[i]);
    }
}
