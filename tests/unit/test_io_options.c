// SPDX-License-Identifier: MIT
// Every option that is a parameter: its range is that of its row, its value lands in the row's field of the scene, and
// in no other.
#include "../../apps/bolan/describe.c"
#include "../../apps/bolan/options.c"

#include "io_support.h"

static int parse(const option_info *info, const char *value, options *o) {
    char name[64], text[64];
    char *arguments[] = {name, text};
    unsigned command = 1;
    while (!(info->commands & command)) command <<= 1;
    snprintf(name, sizeof name, "--%s", info->name);
    snprintf(text, sizeof text, "%s", value);
    return options_parse(command, "test", info->argument ? 2 : 1, arguments, o);
}

static void number_is_refused(const option_info *info, const bolan_param *row, double value) {
    options o;
    char text[64], words[80];
    snprintf(words, sizeof words, "--%s is ", info->name);
    const double factor = row->factor > 0.0 ? row->factor : 1.0;
    bolan_format(text, sizeof text, row->kind == BOLAN_PARAM_WHOLE ? "%.0f" : "%.17g", value / factor);
    error_count = 0;
    assert_int_equal(parse(info, text, &o), EXIT_USAGE);
    assert_int_equal(error_count, 1);
    assert_non_null(strstr(last_sentence, words));
}

// The field of a scene with this option, by the tables alone: options.c has its own way to find it.
static const bolan_param *row_of_scene(const char *option, size_t *place) {
    for (const bolan_param_group *g = bolan_scene_groups; g->table; g++)
        for (uint32_t k = 0; k < g->table->count; k++)
            if (g->table->params[k].option && strcmp(g->table->params[k].option, option) == 0) {
                *place = g->offset;
                return &g->table->params[k];
            }
    return NULL;
}

// The scene is the default one but for this field.
static void lands_in_its_field(const option_info *info, const char *text, double expected) {
    options o;
    const bolan_param row = option_param(info);
    size_t place = 0;
    const bolan_param *field = row_of_scene(info->name, &place);
    assert_int_equal(parse(info, text, &o), EXIT_OK);
    assert_near(bolan_param_get(&row, &o), expected, 1e-15 * fabs(expected));
    assert_true(option_given(&o, info->name));
    if (!field) return;
    bolan_scene scene = bolan_scene_default(), before = scene;
    options_edit(&o, &scene);
    assert_near(bolan_param_get(field, (char *)&scene + place), expected, 1e-15 * fabs(expected));
    bolan_param_set(field, (char *)&before + place, expected);
    assert_memory_equal(&scene, &before, sizeof scene);
}

static void numbers_keep_to_the_range_of_their_row(void **state) {
    (void)state;
    unsigned tried = 0;
    for (const option_info *i = option_table; i->name; i++) {
        if (i->kind != OPTION_PARAM) continue;
        const bolan_param row = option_param(i);
        const double factor = row.factor > 0.0 ? row.factor : 1.0, ends[] = {row.low, row.high};
        if (row.kind != BOLAN_PARAM_NUMBER && row.kind != BOLAN_PARAM_WHOLE) continue;
        for (int k = 0; k < 2; k++) {
            char text[64];
            bolan_format(text, sizeof text, row.kind == BOLAN_PARAM_WHOLE ? "%.0f" : "%.17g", ends[k] / factor);
            if (ends[k] < 0x1p64) lands_in_its_field(i, text, ends[k]);
        }
        const double step = row.kind == BOLAN_PARAM_WHOLE ? 1.0 : 1e-9 * fmax(1.0, fabs(row.high));
        number_is_refused(i, &row, row.low - step);
        if (row.high < 0x1p64) number_is_refused(i, &row, row.high + step);
        tried++;
    }
    assert_true(tried >= 9);
}

static void names_and_flags_land_in_their_field(void **state) {
    (void)state;
    unsigned tried = 0;
    for (const option_info *i = option_table; i->name; i++) {
        if (i->kind != OPTION_PARAM) continue;
        const bolan_param row = option_param(i);
        if (row.kind == BOLAN_PARAM_FLAG) lands_in_its_field(i, "", 1.0), tried++;
        if (row.kind != BOLAN_PARAM_NAME && row.kind != BOLAN_PARAM_SET) continue;
        for (int k = 0; row.names[k]; k++, tried++)
            lands_in_its_field(i, row.names[k], row.kind == BOLAN_PARAM_SET ? (double)(1u << k) : row.low + k);
        options o;
        assert_int_equal(parse(i, "sparkle", &o), EXIT_USAGE);
        assert_non_null(strstr(last_sentence, " is sparkle; expected "));
    }
    assert_true(tried > 40);
}

static void every_row_with_an_option_has_one(void **state) {
    (void)state;
    for (int f = 0; f < 2; f++)
        for (const bolan_param_group *g = f ? bolan_scene_file_groups : bolan_scene_groups; g->table; g++)
            for (uint32_t k = 0; k < g->table->count; k++) {
                const char *name = g->table->params[k].option;
                unsigned found = 0;
                for (const option_info *i = option_table; i->name && name; i++)
                    found += strcmp(i->name, name) == 0 && i->kind == OPTION_PARAM;
                assert_int_equal(found, name ? 1 : 0);
            }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(numbers_keep_to_the_range_of_their_row),
        cmocka_unit_test(names_and_flags_land_in_their_field),
        cmocka_unit_test(every_row_with_an_option_has_one),
    };
    return cmocka_run_group_tests(tests, listen_to_log, NULL);
}
