// SPDX-License-Identifier: MIT
// The rows of the viewer's panel.
#include "../../apps/viewer/panel_rows.c"
#include "../../apps/viewer/sea_knobs.h"
#include "support.h"

// A slider never offers what a scene refuses, and its text has the unit of its range.
static void rows_of_the_panel_lie_in_the_ranges_of_scenes(void **state) {
    (void)state;
    panel_row rows[PANEL_ROW_COUNT];
    memset(rows, 0, sizeof rows);
    panel_rows_make(rows);
    for (int i = 0; i < PANEL_ROW_COUNT; i++) {
        uint32_t count = 0;
        const bolan_param *p = bolan_param_find_key(bolan_scene_groups, keys[i], NULL, &count);
        if (!p) p = bolan_param_find_key(bolan_scene_file_groups, keys[i], NULL, &count);
        assert_true(rows[i].low < rows[i].high && rows[i].label[0] && rows[i].format[0] == '%');
        assert_true(bolan_param_accepts(p, rows[i].low * rows[i].factor));
        assert_true(bolan_param_accepts(p, rows[i].high * rows[i].factor));
    }
    assert_string_equal(rows[ROW_WIND_SPEED].label, "wind##sea.wind.speed");
    assert_string_equal(rows[ROW_WIND_SPEED].format, "%.1f m/s");
    assert_near(rows[ROW_WIND_SPEED].high, 40.0, 0.0);
    assert_string_equal(rows[ROW_VISIBILITY].format, "%.1f km");
    assert_near(rows[ROW_VISIBILITY].low, 0.5, 0.0);
    assert_near(rows[ROW_VISIBILITY].high, 300.0, 0.0);
    assert_near(rows[ROW_VISIBILITY].factor, 1000.0, 0.0);
    assert_true(rows[ROW_VISIBILITY].logarithmic && !rows[ROW_FOAM].logarithmic);
    assert_string_equal(rows[ROW_EXPOSURE].format, "%+.1f stops");
    assert_string_equal(rows[ROW_SUN_ELEVATION].format, "%.1f deg");
    assert_string_equal(rows[ROW_FOAM].format, "%.2f");
    assert_near(rows[ROW_FETCH].low, SEA_KNOBS_FETCH_MIN, 0.0);
    assert_near(rows[ROW_FETCH].high, SEA_KNOBS_FETCH_MAX, 0.0);
}

RUN_TESTS(cmocka_unit_test(rows_of_the_panel_lie_in_the_ranges_of_scenes))
