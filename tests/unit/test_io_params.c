// SPDX-License-Identifier: MIT
// Every parameter through every door: its range by validation, by the key of a scene file and by the option's reader;
// its default in the default functions; its range and default in the comment of the header; its field in no other row.
#include "bolan/io.h"
#include "io_support.h"

#include <ctype.h>
#include <float.h>

// ---- the tables -----------------------------------------------------------------------------------------------------

typedef void (*visitor)(const bolan_param_group *group, const bolan_param *param);

static void visit(visitor f) {
    for (const bolan_param_group *g = bolan_scene_groups; g->table; g++)
        for (uint32_t i = 0; i < g->table->count; i++) f(g, &g->table->params[i]);
}

static unsigned tried;

static bool is_number(const bolan_param *p) { return p->kind == BOLAN_PARAM_NUMBER || p->kind == BOLAN_PARAM_WHOLE; }

// The nearest values that are outside; false: there are none, since the type ends there.
static bool step_below(const bolan_param *p, double *value) {
    *value = p->kind == BOLAN_PARAM_NUMBER ? nextafter(p->low, -HUGE_VAL) : p->low - 1.0;
    if (p->rules & BOLAN_PARAM_POWER_OF_TWO) *value = 0.5 * p->low;
    if (p->rules & BOLAN_PARAM_OR_ZERO && *value == 0.0) return false;
    return p->kind == BOLAN_PARAM_NUMBER ? !isinf(p->low) : *value >= 0.0 || p->kind == BOLAN_PARAM_NAME;
}

static bool step_above(const bolan_param *p, double *value) {
    *value = p->kind == BOLAN_PARAM_NUMBER ? nextafter(p->high, HUGE_VAL) : p->high + 1.0;
    if (p->rules & BOLAN_PARAM_POWER_OF_TWO) *value = 2.0 * p->high;
    return p->kind == BOLAN_PARAM_NUMBER ? !isinf(p->high) : p->high < 0x1p32;
}

// ---- validation -----------------------------------------------------------------------------------------------------

// A valid scene with one object, two keys of a path, and the ground that the group describes.
static bolan_scene scene_for(const bolan_param_group *group) {
    bolan_scene s = bolan_scene_default();
    s.object_count = 1;
    s.objects[0].scale = 1.0;
    s.train_count = 1;
    s.trains[0] = bolan_wave_train_desc_default();
    s.spectrum.place[0] = s.spectrum.place[1] = 0.0; // both or none
    s.camera_key_count = 2;
    s.camera_keys[0].camera = s.camera_keys[1].camera = s.camera;
    s.camera_keys[0].time = -1e9, s.camera_keys[1].time = 1e9;
    if (group->table == &bolan_ground_generator_params) s.terrain.kind = BOLAN_GROUND_GENERATED;
    if (group->table == &bolan_raster_params) s.terrain.kind = BOLAN_GROUND_RASTER;
    return s;
}

static void validation_is_by_the_table(const bolan_param_group *group, const bolan_param *p) {
    const double sign = p->rules & BOLAN_PARAM_EITHER_SIGN ? -1.0 : 1.0;
    const double good[] = {p->low, p->high, p->fallback, sign * p->low, sign * p->high};
    double bad[2];
    const bool has_bad[2] = {step_below(p, &bad[0]), step_above(p, &bad[1])};
    char place[128];
    snprintf(place, sizeof place, "%s%s%s%s is ", group->field, group->capacity ? "[0]" : "", *group->field ? "." : "",
             p->field);
    if (p->kind == BOLAN_PARAM_TEXT || p->kind == BOLAN_PARAM_FLAG) return;
    if (group->table == &bolan_ground_source_params) return; // another kind needs another ground
    for (size_t i = 0; i < sizeof good / sizeof *good; i++) {
        bolan_scene s = scene_for(group);
        if (isnan(good[i]) || isinf(good[i]) || (strcmp(p->field, "time") == 0 && group->capacity)) continue;
        bolan_param_set(p, (char *)&s + group->offset, good[i]);
        if (bolan_scene_validate(&s)) print_error("%s%.17g: %s\n", place, good[i], last_sentence);
        assert_int_equal(bolan_scene_validate(&s), BOLAN_OK);
    }
    for (int i = 0; i < 2; i++) {
        bolan_scene s = scene_for(group);
        if (!has_bad[i]) continue;
        bolan_param_set(p, (char *)&s + group->offset, bad[i]);
        assert_refusal(bolan_scene_validate(&s), BOLAN_ERROR_ARGUMENT,
                       is_number(p) ? BOLAN_LOG_OUT_OF_RANGE : BOLAN_LOG_BAD_ARGUMENT, place);
        tried++;
    }
}

static void test_validation_refuses_what_lies_outside(void **state) {
    (void)state;
    tried = 0;
    visit(validation_is_by_the_table);
    assert_true(tried > 100);
}

static void not_finite_is_refused(const bolan_param_group *group, const bolan_param *p) {
    bolan_scene s = scene_for(group);
    if (p->kind != BOLAN_PARAM_NUMBER || p->rules & BOLAN_PARAM_OR_NAN) return;
    bolan_param_set(p, (char *)&s + group->offset, (double)NAN);
    assert_refusal(bolan_scene_validate(&s), BOLAN_ERROR_ARGUMENT, BOLAN_LOG_NOT_FINITE, p->field);
}

static void text_without_end_is_refused(const bolan_param_group *group, const bolan_param *p) {
    bolan_scene s = scene_for(group);
    if (p->kind != BOLAN_PARAM_TEXT) return;
    memset((char *)&s + group->offset + p->offset, 'x', p->size);
    assert_refusal(bolan_scene_validate(&s), BOLAN_ERROR_ARGUMENT, BOLAN_LOG_BAD_ARGUMENT, p->field);
    ((char *)&s)[group->offset + p->offset + p->size - 1] = '\0';
    assert_int_equal(bolan_scene_validate(&s), BOLAN_OK);
}

static void test_validation_refuses_what_is_no_value(void **state) {
    (void)state;
    visit(not_finite_is_refused);
    visit(text_without_end_is_refused);
}

// ---- keys of scene files --------------------------------------------------------------------------------------------

// The document that gives the rows with this key one value: "sky: {clouds: {cover: 0.5}}".
static void write_document(const bolan_param_group *group, const bolan_param *p, const char *value, char *out,
                           size_t size) {
    char path[128];
    int depth = 0;
    size_t used = 0;
    snprintf(path, sizeof path, "%s%s%s", group->key, *group->key ? "." : "", p->key);
    out[0] = '\0';
    for (char *word = strtok(path, "."); word; word = strtok(NULL, "."), depth++)
        used += (size_t)snprintf(out + used, size - used, "%s%s: ", depth ? "{" : "", word);
    used += (size_t)snprintf(out + used, size - used, "%s", value);
    for (; depth > 1; depth--) used += (size_t)snprintf(out + used, size - used, "}");
}

// A value as a file has it; the components beside it are 0.
static void write_value(const bolan_param_group *group, const bolan_param *p, double value, char *out, size_t size) {
    char number[64];
    size_t used = 0;
    const double factor = p->factor > 0.0 ? p->factor : 1.0;
    bolan_format(number, sizeof number, "%.17g", value / factor);
    if (p->kind == BOLAN_PARAM_WHOLE) bolan_format(number, sizeof number, "%.0f", value);
    uint32_t first = (uint32_t)(p - group->table->params), count = 1, at = 0;
    while (first > 0 && p[-1 - (int)at].key && strcmp(p[-1 - (int)at].key, p->key) == 0) first--, at++;
    while (first + count < group->table->count && group->table->params[first + count].key &&
           strcmp(group->table->params[first + count].key, p->key) == 0)
        count++;
    for (uint32_t i = 0; i < count && count > 1; i++)
        used += (size_t)snprintf(out + used, size - used, "%s%s", i ? ", " : "[", i == at ? number : "0");
    snprintf(out + used, size - used, "%s", count > 1 ? "]" : number);
}

static void keys_are_by_the_table(const bolan_param_group *group, const bolan_param *p) {
    char text[256], value[128], words[128], key[64];
    bolan_scene s;
    if (!p->key || !is_number(p) || group->capacity) return;
    const double good[] = {p->low, p->high};
    double bad[2];
    const bool has_bad[2] = {step_below(p, &bad[0]), step_above(p, &bad[1])};
    for (int i = 0; i < 2; i++) {
        if (isinf(good[i]) || good[i] >= 0x1p64) continue;
        write_value(group, p, good[i], value, sizeof value);
        write_document(group, p, value, text, sizeof text);
        if (group->table == &bolan_spectrum_options_params)
            snprintf(text, sizeof text, "sea: {spectrum: {file: a, %s: %s}}", p->key, value);
        if (bolan_scene_parse("t", text, strlen(text), &s)) print_error("%s: %s\n", text, last_sentence);
        assert_int_equal(bolan_scene_parse("t", text, strlen(text), &s), BOLAN_OK);
        assert_near(bolan_param_get(p, (char *)&s + group->offset), good[i], fabs(good[i]) * 1e-15);
    }
    for (int i = 0; i < 2; i++) {
        if (!has_bad[i]) continue;
        write_value(group, p, bad[i] + (bad[i] - good[i]) * 8.0, value, sizeof value); // the unit's factor rounds
        write_document(group, p, value, text, sizeof text);
        snprintf(key, sizeof key, "%s%s%s", group->key, *group->key ? "." : "", p->key);
        snprintf(words, sizeof words, "t:1: %s", key);
        assert_refusal(bolan_scene_parse("t", text, strlen(text), &s), BOLAN_ERROR_FORMAT, BOLAN_LOG_SCENE_BAD_VALUE,
                       words);
        tried++;
    }
}

static void names_are_keys(const bolan_param_group *group, const bolan_param *p) {
    char text[256];
    bolan_scene s;
    if (!p->key || group->capacity || (p->kind != BOLAN_PARAM_NAME && p->kind != BOLAN_PARAM_SET)) return;
    for (int i = 0; p->names[i]; i++) {
        write_document(group, p, p->names[i], text, sizeof text);
        if (strcmp(p->names[i], "tma") == 0) snprintf(text, sizeof text, "sea: {depth: 9, spectrum: {shape: tma}}");
        assert_int_equal(bolan_scene_parse("t", text, strlen(text), &s), BOLAN_OK);
        const double expected = p->kind == BOLAN_PARAM_SET ? (double)(1u << i) : p->low + i;
        assert_near(bolan_param_get(p, (char *)&s + group->offset), expected, 0.0);
        if (p->kind == BOLAN_PARAM_NAME) assert_true(p->names[i + 1] || expected == p->high);
        tried++;
    }
}

// Below its map, after a dot: not beside another that begins alike.
static void a_key_is_found_at_its_place_alone(const bolan_param_group *group, const bolan_param *p) {
    const bolan_param_group *found = NULL;
    char path[128];
    uint32_t count = 0;
    if (!p->key) return;
    snprintf(path, sizeof path, "%s%s%s", group->key, *group->key ? "." : "", p->key);
    const bolan_param *first = bolan_param_find_key(bolan_scene_groups, path, &found, &count);
    assert_true(first && found == group && first <= p && p < first + count);
    if (!*group->key) return;
    path[strlen(group->key)] = '_';
    assert_null(bolan_param_find_key(bolan_scene_groups, path, &found, &count));
    tried++;
}

static void test_keys_of_scene_files(void **state) {
    (void)state;
    tried = 0;
    visit(a_key_is_found_at_its_place_alone);
    assert_true(tried > 60);
    tried = 0;
    visit(keys_are_by_the_table);
    assert_true(tried > 60);
    tried = 0;
    visit(names_are_keys);
    assert_true(tried > 30);
}

// A key in an element of a list: the same rows as elsewhere, at the element's place.
static void test_keys_of_lists(void **state) {
    (void)state;
    bolan_scene s;
    const char *text = "objects:\n  - {model: a}\n  - {model: b, position: [1, 2, 3], heading: -360, scale: 1000}\n"
                       "camera: {path: [{time: -1e9}, {time: 1e9, fov: 150, position: [1e7, -1e7, 1e6]}]}\n";
    assert_int_equal(bolan_scene_parse("t", text, strlen(text), &s), BOLAN_OK);
    assert_int_equal(s.object_count, 2);
    assert_string_equal(s.objects[0].model, "a");
    assert_near(s.objects[0].scale, 1.0, 0.0);
    assert_near(s.objects[1].position.z, 3.0, 0.0);
    assert_near(s.objects[1].heading_deg, -360.0, 0.0);
    assert_near(s.objects[1].scale, 1000.0, 0.0);
    assert_near(s.camera_keys[0].time, -1e9, 0.0);
    assert_near(s.camera_keys[1].camera.fov_deg, 150.0, 0.0);
    assert_near(s.camera_keys[1].camera.position.y, -1e7, 0.0);
    text = "trains: [{from: 12}, {length: 30, height: 0.5, centre: [4, -5], half_width: 60}]";
    assert_int_equal(bolan_scene_parse("t", text, strlen(text), &s), BOLAN_OK);
    assert_int_equal(s.train_count, 2);
    assert_near(s.trains[0].from_deg, 12.0, 0.0);
    assert_near(s.trains[0].length, 100.0, 0.0); // what is left out has its default
    assert_near(s.trains[1].length, 30.0, 0.0);
    assert_near(s.trains[1].centre.y, -5.0, 0.0);
    assert_near(s.trains[1].half_width, 60.0, 0.0);
    assert_near(s.trains[1].half_length, 1e7, 0.0);
    text = "objects: [{model: a, scale: 1001}]";
    assert_refusal(bolan_scene_parse("t", text, strlen(text), &s), BOLAN_ERROR_FORMAT, BOLAN_LOG_SCENE_BAD_VALUE,
                   "t:1: objects[0].scale is 1001; expected a number from 0.001 to 1000");
    text = "camera: {path: [{time: 0}, {time: 1, pitch: 91}]}";
    assert_refusal(bolan_scene_parse("t", text, strlen(text), &s), BOLAN_ERROR_FORMAT, BOLAN_LOG_SCENE_BAD_VALUE,
                   "t:1: camera.path[1].pitch is 91; expected a number from -90 to 90 degrees");
}

// ---- text -----------------------------------------------------------------------------------------------------------

static bool reads(const bolan_param *p, const char *text, double expected) {
    struct {
        double space[256];
    } desc;
    memset(&desc, 0x5a, sizeof desc);
    bolan_param row = *p;
    row.offset = 8;
    if (!bolan_param_parse(&row, text, strlen(text), &desc)) return false;
    assert_near(bolan_param_get(&row, &desc), expected, fabs(expected) * 1e-15);
    return true;
}

static void test_what_a_text_may_be(void **state) {
    (void)state;
    const bolan_param *km = bolan_param_find(&bolan_sky_params, "visibility");
    const bolan_param *seed = bolan_param_find(&bolan_sea_params, "seed");
    const bolan_param *power = bolan_param_find(&bolan_sea_params, "resolution");
    const bolan_param *type = bolan_param_find(&bolan_seawater_params, "type");
    const bolan_param *effects = bolan_param_find(&bolan_look_params, "effects");
    const bolan_param *scale = bolan_param_find(&bolan_raster_params, "vertical_scale");
    const bolan_param *paper = bolan_param_find(&bolan_look_params, "paper");
    assert_true(reads(km, "0.5", 500.0) && reads(km, "300", 300e3) && !reads(km, "301", 0) && !reads(km, "0.49", 0));
    assert_true(!reads(km, "", 0) && !reads(km, "1 ", 0) && !reads(km, "1km", 0) && !reads(km, "nan", 0));
    assert_true(reads(seed, "18446744073709551615", 0x1p64) && !reads(seed, "18446744073709551616", 0));
    assert_true(!reads(seed, "-1", 0) && !reads(seed, "1.0", 0) && !reads(seed, "1e3", 0) && !reads(seed, "", 0));
    assert_true(reads(power, "64", 64) && !reads(power, "96", 0) && !reads(power, "16", 0) && !reads(power, "2048", 0));
    assert_true(reads(type, "ib", BOLAN_JERLOV_IB) && !reads(type, "IC", 0) && !reads(type, "I B", 0));
    assert_true(reads(effects, "foam, fog", BOLAN_EFFECT_FOAM | BOLAN_EFFECT_FOG) && reads(effects, "none", 0.0));
    assert_true(reads(effects, "all", BOLAN_EFFECTS_ALL) && !reads(effects, "foam,,fog", 0) && !reads(effects, "", 0));
    assert_true(!reads(effects, "foam,", 0) && !reads(effects, ",foam", 0) && reads(effects, "fog", 1 << 11));
    assert_true(reads(scale, "-1000", -1000) && reads(scale, "0.001", 1e-3) && !reads(scale, "-0.0009", 0));
    assert_true(reads(paper, "true", 1) && reads(paper, "Off", 0) && !reads(paper, "1", 0));
    char text[32];
    bolan_param row = {.kind = BOLAN_PARAM_TEXT, .size = 4};
    assert_true(bolan_param_parse(&row, "abc", 3, text) && strcmp(text, "abc") == 0);
    assert_false(bolan_param_parse(&row, "abcd", 4, text) || bolan_param_parse(&row, "", 0, text));
    assert_false(bolan_param_parse(&row, "a\0b", 3, text));
}

static void test_what_is_expected_is_said(void **state) {
    (void)state;
    char text[256];
    static const struct {
        const bolan_param_table *table;
        const char *field, *words;
    } said[] = {
        {&bolan_sky_params, "visibility", "a number from 0.5 to 300 km"},
        {&bolan_sea_params, "seed", "a whole number from 0 to 18446744073709551615"},
        {&bolan_sea_params, "resolution", "a power of two from 32 to 1024"},
        {&bolan_raster_params, "vertical_scale", "a number from 0.001 to 1000, or its negative"},
        {&bolan_raster_params, "nodata_value", "a number"},
        {&bolan_raster_params, "nodata", "fill, sea"},
        {&bolan_look_params, "show", "picture, mask, mesh"},
        {&bolan_scene_params, "name", "a text of 1 to 63 characters"},
    };
    for (size_t i = 0; i < sizeof said / sizeof *said; i++) {
        bolan_param_expected(bolan_param_find(said[i].table, said[i].field), text, sizeof text);
        assert_string_equal(text, said[i].words);
    }
    bolan_param_expected(bolan_param_find(&bolan_look_params, "effects"), text, 20); // cut, not overrun
    assert_string_equal(text, "all, none, or some ");
    assert_null(bolan_param_find(&bolan_look_params, "sparkle"));
}

// ---- the rows -------------------------------------------------------------------------------------------------------

static void test_no_two_rows_share_a_field(void **state) {
    (void)state;
    for (const bolan_param_group *g = bolan_scene_groups; g->table; g++)
        for (uint32_t i = 0; i < g->table->count; i++)
            for (const bolan_param_group *h = g; h->table; h++)
                for (uint32_t k = h == g ? i + 1 : 0; k < h->table->count; k++) {
                    const bolan_param *a = &g->table->params[i], *b = &h->table->params[k];
                    const size_t from = g->offset + a->offset, to = h->offset + b->offset;
                    assert_true(from + a->size <= to || to + b->size <= from);
                }
}

static void a_row_is_whole(const bolan_param_group *group, const bolan_param *p) {
    (void)group;
    const size_t sizes[] = {sizeof(double), p->size == 8 ? 8 : 4, sizeof(bool), sizeof(int), sizeof(uint32_t), p->size};
    assert_int_equal(p->size, sizes[p->kind]);
    assert_true(p->kind == BOLAN_PARAM_TEXT || p->low <= p->high);
    assert_true(bolan_param_accepts(p, p->fallback));
    assert_true(p->help || (p->key && strcmp(p->key, p[-1].key) == 0)); // of a list the first component says it
    if (p->kind == BOLAN_PARAM_SET) assert_near(p->high, BOLAN_EFFECTS_ALL, 0.0);
    if (p->usual_high > p->usual_low) {
        const double factor = p->factor > 0.0 ? p->factor : 1.0;
        assert_true(p->usual_low * factor >= p->low && p->usual_high * factor <= p->high);
    }
}

static void test_every_row_is_whole(void **state) {
    (void)state;
    visit(a_row_is_whole);
}

static void expect_defaults(const bolan_param_table *table, const void *desc) {
    for (uint32_t i = 0; i < table->count; i++) {
        const double value = bolan_param_get(&table->params[i], desc), row = table->params[i].fallback;
        if (value != row && !(isnan(value) && isnan(row))) print_error("%s.%s\n", table->type, table->params[i].field);
        assert_true(value == row || (isnan(value) && isnan(row)));
    }
}

static void test_default_functions_and_rows_agree(void **state) {
    (void)state;
    const bolan_sea_desc sea = bolan_sea_desc_default();
    const bolan_look look = bolan_look_default();
    const bolan_raster_desc raster = bolan_raster_desc_default();
    const bolan_spectrum_options options = bolan_spectrum_options_default();
    const bolan_sea_state calm = bolan_sea_state_default();
    const bolan_scene scene = bolan_scene_default();
    expect_defaults(&bolan_sea_params, &sea);
    expect_defaults(&bolan_sea_params, &scene.sea);
    expect_defaults(&bolan_look_params, &look);
    expect_defaults(&bolan_raster_params, &raster);
    expect_defaults(&bolan_spectrum_options_params, &options);
    expect_defaults(&bolan_sea_state_params, &calm);
    expect_defaults(&bolan_camera_params, &scene.camera);
    expect_defaults(&bolan_sky_params, &scene.sky);
    expect_defaults(&bolan_seawater_params, &scene.water);
    expect_defaults(&bolan_ground_generator_params, &scene.terrain.generator);
    expect_defaults(&bolan_wind_sea_params, &scene);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_validation_refuses_what_lies_outside),
        cmocka_unit_test(test_validation_refuses_what_is_no_value),
        cmocka_unit_test(test_keys_of_scene_files),
        cmocka_unit_test(test_keys_of_lists),
        cmocka_unit_test(test_what_a_text_may_be),
        cmocka_unit_test(test_what_is_expected_is_said),
        cmocka_unit_test(test_no_two_rows_share_a_field),
        cmocka_unit_test(test_every_row_is_whole),
        cmocka_unit_test(test_default_functions_and_rows_agree),
    };
    return cmocka_run_group_tests(tests, listen_to_log, NULL);
}
