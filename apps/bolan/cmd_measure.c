// SPDX-License-Identifier: MIT
// bolan measure: statistics of the synthesised sea, as JSON or as a table.
#include "buoy.h"
#include "commands.h"
#include "help.h"
#include "output.h"
#include "session.h"
#include "systems.h"

#include <math.h>

typedef struct quantity {
    const char *key, *unit, *what;
    double value;
} quantity;

enum { QUANTITIES = 17 };

static void list_quantities(const bolan_sea_statistics *s, quantity out[QUANTITIES]) {
    const quantity list[QUANTITIES] = {
        {"hs", "m", "significant wave height", s->hs},
        {"tp", "s", "peak period", s->tp},
        {"tm02", "s", "zero-crossing period", s->tm02},
        {"te", "s", "energy period", s->te},
        {"direction_from", "deg", "mean direction, from", s->direction_from},
        {"spread", "deg", "directional spread", s->spread},
        {"mss", "", "mean square slope", s->mss},
        {"mss_up", "", "  along the wind", s->mss_up},
        {"mss_cross", "", "  across the wind", s->mss_cross},
        {"skewness", "", "skewness of the height", s->skewness},
        {"kurtosis", "", "kurtosis of the height", s->kurtosis},
        {"mean_level", "m", "mean of the height", s->mean_level},
        {"jacobian_min", "", "smallest Jacobian", s->jacobian_min},
        {"jacobian_mean", "", "mean Jacobian", s->jacobian_mean},
        {"whitecap_fraction", "", "whitecap fraction", s->whitecap_fraction},
        {"m0_spectrum", "m2", "variance asked for", s->m0_spectrum},
        {"m0_field", "m2", "variance of the surface", s->m0_field},
    };
    for (int i = 0; i < QUANTITIES; i++) out[i] = list[i];
}

// JSON has no NaN or infinity.
static void print_number(double value) {
    char text[32] = "null";
    if (isfinite(value)) bolan_format(text, sizeof text, "%.9g", value);
    printf("%s", text);
}

static bool print_json(const bolan_sea *sea, const bolan_sea_state *sea_state, const quantity *list, const char *hash) {
    printf("{\n");
    for (int i = 0; i < QUANTITIES; i++) {
        printf("  \"%s\": ", list[i].key);
        print_number(list[i].value);
        printf(",\n");
    }
    printf("  \"cascades\": [\n");
    const uint32_t count = bolan_sea_cascade_count(sea);
    for (uint32_t i = 0; i < count; i++) {
        const bolan_cascade_view c = bolan_sea_cascade_layout(sea, i);
        char text[192];
        bolan_format(text, sizeof text,
                     "{\"n\": %u, \"length\": %.9g, \"k_min\": %.9g, \"k_max\": %.9g, \"variance\": %.9g}",
                     (unsigned)c.n, c.length, c.k_min, c.k_max, c.variance);
        printf("    %s%s\n", text, i + 1 < count ? "," : "");
    }
    printf("  ],\n  \"systems\": ");
    const bool ok = systems_print_json(sea_state);
    printf(",\n  \"components\": %u,\n  \"record_time\": \"%s\",\n  \"hash\": \"%s\"\n}\n",
           (unsigned)bolan_sea_component_count(sea), bolan_sea_record_time(sea), hash);
    return ok;
}

// The parts of the sea: its cascades, or the first and the last wave of a sum.
static void print_waves(const bolan_sea *sea) {
    const uint32_t waves = bolan_sea_component_count(sea);
    if (bolan_sea_cascade_count(sea) > 0) {
        printf("\n  cascade     n     length m   k_min rad/m   k_max rad/m   variance m2\n");
        for (uint32_t i = 0; i < bolan_sea_cascade_count(sea); i++) {
            const bolan_cascade_view c = bolan_sea_cascade_layout(sea, i);
            printf("  %7u %5u %12.4g %13.4g %13.4g %13.4g\n", (unsigned)i, (unsigned)c.n, c.length, c.k_min, c.k_max,
                   c.variance);
        }
    }
    for (uint32_t i = 0; i<waves; i += waves> 1 ? waves - 1 : 1) {
        const bolan_sea_component c = bolan_sea_get_component(sea, i);
        printf("%s  %u of %u waves: length %.4g m, amplitude %.4g m, period %.4g s\n", i == 0 ? "\n" : "",
               (unsigned)i + 1, (unsigned)waves, 2.0 * BOLAN_PI / hypot(c.kx, c.ky), c.amplitude,
               2.0 * BOLAN_PI / fabs(c.omega));
    }
}

static bool print_table(const bolan_scene *scene, const bolan_sea *sea, const bolan_sea_state *sea_state,
                        const quantity *list, const char *hash) {
    output_print(scene->name);
    printf(", seed %llu, at %g s\n\n", (unsigned long long)scene->sea.seed, scene->time);
    for (int i = 0; i < QUANTITIES; i++) printf("  %-26s %12.5g %s\n", list[i].what, list[i].value, list[i].unit);
    if (bolan_sea_record_time(sea)[0]) printf("  %-26s %s\n", "spectrum taken at", bolan_sea_record_time(sea));
    const bool ok = systems_print_table(sea_state);
    print_waves(sea);
    printf("\n  hash %s\n", hash);
    return ok;
}

static int measure_sea(const bolan_world *world, bool json) {
    const bolan_sea *sea = bolan_world_water(world)->sea;
    const bolan_sea_statistics statistics = bolan_sea_measure(sea);
    char hash[17];
    bolan_sea_hash(sea, hash);
    quantity list[QUANTITIES];
    list_quantities(&statistics, list);
    const bolan_sea_desc desc = bolan_world_sea_desc(world);
    const bool ok = json ? print_json(sea, &desc.sea_state, list, hash)
                         : print_table(bolan_world_scene(world), sea, &desc.sea_state, list, hash);
    return ok ? EXIT_OK : EXIT_FAILED;
}

int command_measure(int count, char **arguments) {
    options o;
    bolan_world *w = NULL;
    int result = options_parse(ON_MEASURE, "measure", count, arguments, &o);
    if (result) return result;
    if (o.help)
        return help_command(ON_MEASURE, "measure [SCENE] [OPTIONS]", "Makes the scene's sea and prints what it is.");
    if (!buoy_options_check(&o)) return EXIT_USAGE;
    result = session_open_sea(&o, &w);
    if (result) return result;
    const bolan_sea *sea = bolan_world_water(w)->sea;
    if (o.record_time) {
        printf("%s\n", bolan_sea_record_time(sea));
    } else if (option_given(&o, "buoy")) {
        result = buoy_measure(&o, sea);
    } else {
        result = measure_sea(w, o.json);
    }
    bolan_world_destroy(&w);
    return result;
}
