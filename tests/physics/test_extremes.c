// SPDX-License-Identifier: MIT
// Seas, flows and questions at the ends of every range, and far away in place and time.
//
// The rows come from the tables of parameters: a new field of a sea, a sea state, a system of waves, a wave train or a
// generated ground is tried without a line here. What is accepted must work: finite, inside its bounds, with the
// variance of its waves. unit/test_io_params refuses what lies just outside each range.
#include "heard.h"
#include "sea_support.h"

#include "bolan/content.h"
#include "bolan/query.h"
#include "bolan/scene.h"

#include <string.h>

enum { NEAR = 512, FAR = 64, POINTS = NEAR + FAR };

// ---- descs ----------------------------------------------------------------------------------------------------------

// Wind and swell, a wave train and a ground.
static bolan_scene common_scene(bolan_wave_model waves) {
    bolan_scene s = bolan_scene_default();
    s.sea.sea_state = bolan_sea_state_from_wind(9.0, 240.0, 100e3);
    bolan_sea_state_add_swell(&s.sea.sea_state, 1.5, 11.0, 300.0, 30.0);
    s.sea.waves = waves;
    s.sea.resolution = 64;
    s.trains[0] = bolan_wave_train_desc_default();
    s.trains[0].height = 0.05;
    snprintf(s.terrain.generator.name, sizeof s.terrain.generator.name, "island");
    return s;
}

typedef struct part {
    const bolan_param_table *table;
    void *desc;
} part;

enum { PARTS = 6 };

static void parts_of(bolan_scene *s, part out[PARTS]) {
    const part parts[PARTS] = {{&bolan_sea_params, &s->sea},
                               {&bolan_sea_state_params, &s->sea.sea_state},
                               {&bolan_wave_system_params, &s->sea.sea_state.systems[1]},
                               {&bolan_wave_train_params, &s->trains[0]},
                               {&bolan_seawater_params, &s->water},
                               {&bolan_ground_generator_params, &s->terrain.generator}};
    memcpy(out, parts, sizeof parts);
}

// ---- what an accepted desc must do ----------------------------------------------------------------------------------

static bolan_dvec2 place[POINTS];

// The first place that answers other than heights are asked at: all, or with BOLAN_TEST_SHORT 64 near and all far.
static int first_place;

// Scattered over 100 km; then around 1e8 m, and places that are none.
static void scatter_places(void) {
    for (int i = 0; i < POINTS; i++) {
        const double x = i * 0.7548776662466927, y = i * 0.5698402909980532;
        place[i] = (bolan_dvec2){1e5 * (x - floor(x)), 1e5 * (y - floor(y))};
        if (i >= NEAR) place[i].x = (i & 1 ? 1.0 : -1.0) * (1e8 - place[i].x), place[i].y -= 1e8;
    }
    place[NEAR] = (bolan_dvec2){(double)NAN, 0.0};
    place[NEAR + 1] = (bolan_dvec2){0.0, (double)INFINITY};
    place[NEAR + 2] = (bolan_dvec2){-(double)INFINITY, (double)NAN};
    place[NEAR + 3] = (bolan_dvec2){1e300, -1e300};
}

static bool is_finite3(bolan_vec3 v) { return isfinite(v.x) && isfinite(v.y) && isfinite(v.z); }

static bool is_unit(bolan_vec3 v) {
    return v.z >= 0.0f && fabs((double)v.x * v.x + (double)v.y * v.y + (double)v.z * v.z - 1.0) < 1e-4;
}

static const char *surface_fault(const bolan_water *w) {
    static bolan_query_point at[POINTS];
    const bolan_dvec2 *asked = place + first_place;
    const int count = POINTS - first_place;
    double vertical, horizontal;
    bolan_water_bounds(w, &vertical, &horizontal);
    if (!isfinite(vertical) || !isfinite(horizontal)) return "bounds that are not finite";
    bolan_query_surface(w, asked, count, at);
    for (int i = 0; i < count; i++) {
        const double height = (double)at[i].height - w->level;
        if (!(fabs(height) <= vertical * 1.0001 + 1e-4)) return "a height outside the bounds";
        if (!is_unit(at[i].normal)) return "a normal of another length";
        if (!isfinite(at[i].jacobian) || !isfinite(at[i].residual)) return "a Jacobian that is not finite";
        const bool nowhere = !isfinite(asked[i].x) || !isfinite(asked[i].y);
        if (nowhere && (height != (double)(float)w->level - w->level || at[i].normal.z != 1.0f))
            return "waves at no place";
    }
    return NULL;
}

static const char *motion_fault(const bolan_water *w) {
    static bolan_surface_motion at[POINTS];
    static bolan_kinematics below[POINTS];
    static bolan_dvec3 xyz[POINTS];
    const bolan_dvec2 *asked = place + first_place;
    const int count = POINTS - first_place;
    const double depths[] = {0.0, -0.5, -5.0, -50.0, -1e4, 1e3, -1e300, (double)NAN};
    bolan_query_motion(w, NULL, asked, count, at);
    for (int i = 0; i < count; i++) {
        if (!isfinite(at[i].height) || !isfinite(at[i].rise) || !is_unit(at[i].normal)) return "a motion's surface";
        if (!is_finite3(at[i].velocity) || !is_finite3(at[i].acceleration)) return "a surface motion";
        xyz[i] = bolan_dv3(asked[i].x, asked[i].y, depths[i % 8]);
    }
    for (int stretched = 0; stretched < 2; stretched++) {
        const bolan_question question = {stretched ? 1e5 : 0.0, (bolan_stretching)stretched};
        bolan_query_below(w, &question, xyz, count, below);
        for (int i = 0; i < count; i++)
            if (!is_finite3(below[i].velocity) || !is_finite3(below[i].acceleration) || !isfinite(below[i].pressure))
                return "a motion below";
    }
    return NULL;
}

static const char *lines_fault(const bolan_water *w) {
    bolan_ray rays[3] = {{{1e8, -1e8, 1e4}, {0.2, 0.1, -1.0}, 1e7},
                         {{0.0, 0.0, 1e5}, {0.0, 0.0, -1e-150}, 1e7},
                         {{0.0, (double)NAN, 5.0}, {0.0, 1.0, -1.0}, 100.0}};
    bolan_ray_hit hits[3];
    bolan_query_rays(w, NULL, rays, 3, hits);
    if (!hits[0].hit || !hits[1].hit || hits[2].hit) return "a ray that misses";
    for (int i = 0; i < 2; i++)
        if (!isfinite(hits[i].distance) || !isfinite(hits[i].point.x + hits[i].point.y + hits[i].point.z))
            return "a hit that is not finite";
    return NULL;
}

// Variance of a sea's waves: of its bands, or of its components.
static double variance_of(const bolan_sea *sea) {
    double sum = 0.0;
    for (uint32_t i = 0; i < bolan_sea_cascade_count(sea); i++) sum += bolan_sea_cascade(sea, i).variance;
    for (uint32_t i = 0; i < bolan_sea_component_count(sea); i++)
        sum += 0.5 * pow(bolan_sea_get_component(sea, i).amplitude, 2.0);
    return sum;
}

typedef struct sums {
    double count, heights, squares;
} sums;

static void gather_heights(const bolan_sea *sea, sums *s) {
    static float height[NEAR];
    bolan_query_heights(&(bolan_water){.sea = sea}, place, NEAR, height);
    for (int i = 0; i < NEAR; i++) {
        s->count++, s->heights += (double)height[i];
        s->squares += (double)height[i] * (double)height[i];
    }
}

// The first tile holds many waves of the peak.
static bool is_wide(const bolan_sea *sea) {
    if (bolan_sea_form(sea) != BOLAN_FORM_CASCADES) return false;
    const double omega = 2.0 * BOLAN_PI / fmax(bolan_sea_get_summary(sea)->tp, 0.1);
    const double k = bolan_k_from_omega(omega, bolan_sea_get_desc(sea)->sea_state.depth);
    return bolan_sea_cascade_layout(sea, 0).length > 6.0 * 2.0 * BOLAN_PI / k;
}

// Where parcels move as linear theory says; choppier water spends more of its area in troughs.
static const char *variance_fault(const bolan_sea *sea, const sums *s) {
    const double mean = s->heights / s->count, variance = s->squares / s->count - mean * mean;
    // Waves exp(s cos) have their own form, and a tile that is not much longer than its waves has a few, which beat.
    const double expected = variance_of(sea), share = is_wide(sea) ? 1.3 : 2.0;
    if (bolan_sea_get_desc(sea)->choppiness > 1.0) return NULL;
    if (!(variance <= share * expected + 1e-9 && variance >= expected / share - 1e-9)) {
        print_error("variance %.5g, of its waves %.5g\n", variance, expected);
        return "another variance than its waves";
    }
    return NULL;
}

static const char *sea_fault(bolan_sea *sea, bolan_flow *flow, const bolan_water *open, const bolan_water *coast) {
    static const double times[] = {0.0, 1e9, -1e9, 86400.37, 1e300};
    sums heights = {0};
    for (int i = 0; i < 5; i++) {
        bolan_sea_step(sea, times[i]);
        gather_heights(sea, &heights);
        if (flow) bolan_flow_step(flow, sea);
        const char *fault = surface_fault(open);
        if (!fault && coast->ground) fault = surface_fault(coast);
        if (!fault && flow) fault = motion_fault(open);
        if (!fault && flow && coast->ground) fault = motion_fault(coast);
        if (!fault) fault = lines_fault(open);
        if (fault) return fault;
    }
    return variance_fault(sea, &heights);
}

static const char *scene_fault(const bolan_scene *s) {
    bolan_sea *sea = NULL;
    bolan_flow *flow = NULL;
    bolan_ground *ground = NULL;
    bolan_wave_layer *layer = NULL;
    const char *fault = NULL;
    heard.errors = 0;
    bolan_result result = bolan_sea_create(&s->sea, &sea);
    if (!result) result = bolan_wave_layer_create_train(&s->trains[0], &layer);
    if (!result && s->terrain.kind) result = bolan_content_create_ground(&s->terrain.generator, &ground);
    if (!result && s->sea.resolution <= 256) result = bolan_flow_create(sea, &flow);
    if ((result != BOLAN_OK) != (heard.errors == 1) || (result && result != BOLAN_ERROR_ARGUMENT)) {
        fault = "no single sentence of refusal";
    } else if (!result) {
        bolan_water open = bolan_water_default(), coast;
        open.sea = sea, open.flow = flow, open.level = s->water.level, open.foam = s->water.foam;
        open.layers = (const bolan_wave_layer *const *)&layer, open.layer_count = 1;
        coast = open;
        coast.ground = ground;
        fault = sea_fault(sea, flow, &open, &coast);
    }
    bolan_flow_destroy(&flow);
    bolan_sea_destroy(&sea);
    bolan_ground_destroy(&ground);
    bolan_wave_layer_destroy(&layer);
    return fault;
}

// ---- one field, and corners -----------------------------------------------------------------------------------------

static unsigned tried, refused, faults;

static void try_scene(const bolan_scene *s, const char *what) {
    const char *fault = scene_fault(s);
    tried++;
    refused += heard.errors > 0;
    if (!fault) return;
    faults++;
    print_error("%s: %s\n", what, fault);
}

// Ends of a row: its range, 0 where that means "not given", and the far end of the other sign. False: there is no such
// end.
static bool end_of(const bolan_param *p, int index, double *value) {
    const double ends[4] = {p->low, fmin(p->high, p->kind == BOLAN_PARAM_WHOLE ? 0x1p63 : HUGE_VAL), 0.0, -p->high};
    *value = ends[index];
    if ((index == 2 && !(p->rules & BOLAN_PARAM_OR_ZERO)) || (index == 3 && !(p->rules & BOLAN_PARAM_EITHER_SIGN)))
        return false;
    return p->kind != BOLAN_PARAM_TEXT && isfinite(*value);
}

static void try_row(bolan_wave_model waves, int at, const bolan_param *p) {
    for (int index = 0; index < 4; index++) {
        bolan_scene s = common_scene(waves);
        part parts[PARTS];
        char what[128];
        double value;
        parts_of(&s, parts);
        if (!end_of(p, index, &value) || value == bolan_param_get(p, parts[at].desc)) continue;
        if (parts[at].table == &bolan_ground_generator_params) s.terrain.kind = BOLAN_GROUND_GENERATED;
        bolan_param_set(p, parts[at].desc, value);
        snprintf(what, sizeof what, "%s, %s.%s = %g", bolan_wave_model_names[waves], parts[at].table->type, p->field,
                 value);
        try_scene(&s, what);
    }
}

// The models read the spectrum by two ways, FFT and COSINES; layers, level and ground are the same for all.
static void every_field_works_at_its_ends(void **state) {
    (void)state;
    tried = refused = faults = 0;
    bolan_scene s = common_scene(BOLAN_WAVES_FFT);
    part parts[PARTS];
    parts_of(&s, parts);
    for (int at = 0; at < PARTS; at++)
        for (int waves = 0; waves < BOLAN_WAVE_MODELS; waves++) {
            if (at > 2 && waves != BOLAN_WAVES_FFT) continue;
            if (at > 0 && waves > BOLAN_WAVES_COSINES) continue;
            for (uint32_t row = 0; row < parts[at].table->count; row++)
                try_row((bolan_wave_model)waves, at, &parts[at].table->params[row]);
        }
    print_message("%u descs, of which %u are refused\n", tried, refused);
    assert_int_equal(faults, 0);
    assert_true(tried > 150 && refused <= 2); // a train of 40 m is steeper than Miche's limit
}

// splitmix64
static uint64_t random_bits(void) {
    static uint64_t x;
    uint64_t z = x += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return z ^ z >> 31;
}

// Sets every fourth row to one of its values, and says which.
static void set_at_random(const part *of, char *what, size_t size) {
    size_t used = strlen(what);
    for (uint32_t row = 0; row < of->table->count; row++) {
        const bolan_param *p = &of->table->params[row];
        const uint64_t bits = random_bits(), choice = bits >> 8;
        double value;
        if (bits % 4 || strcmp(p->field, "waves") == 0 || strcmp(p->field, "resolution") == 0) continue;
        if (!end_of(p, (int)(choice % 4), &value)) continue;
        if (p->kind == BOLAN_PARAM_NAME) value = p->low + (double)(choice % (uint64_t)(p->high - p->low + 1.0));
        bolan_param_set(p, of->desc, value);
        used += (size_t)snprintf(what + used, used < size ? size - used : 0, "%s = %g, ", p->field, value);
        if (used >= size) used = size - 1;
    }
}

static void corners_of_several_fields_work(void **state) {
    (void)state;
    const int corners = getenv("BOLAN_LONG") ? 1000 : 32;
    tried = refused = faults = 0;
    for (int i = 0; i < corners; i++) {
        bolan_scene s = common_scene((bolan_wave_model)(i % BOLAN_WAVE_MODELS));
        part parts[PARTS];
        char what[1024] = "";
        parts_of(&s, parts);
        for (int at = 0; at < PARTS - 1; at++) set_at_random(&parts[at], what, sizeof what);
        try_scene(&s, what);
    }
    print_message("%u corners, of which %u are refused\n", tried, refused);
    assert_int_equal(faults, 0);
    assert_true((int)refused < corners / 2);
}

static int listen(void **state) {
    (void)state;
    const bolan_hooks hooks = {.log = hear};
    bolan_set_hooks(&hooks);
    scatter_places();
    first_place = getenv("BOLAN_TEST_SHORT") ? NEAR - 64 : 0;
    return 0;
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_field_works_at_its_ends),
        cmocka_unit_test(corners_of_several_fields_work),
    };
    return cmocka_run_group_tests(tests, listen, NULL);
}
