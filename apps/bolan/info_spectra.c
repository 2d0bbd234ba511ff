// SPDX-License-Identifier: MIT
// See info_spectra.h.
#include "info_spectra.h"

#include "output.h"
#include "systems.h"

#include <math.h>
#include <string.h>

enum { PLACES_SHOWN = 20 };

// ---- a table --------------------------------------------------------------------------------------------------------

// A length of time in its largest fitting unit: 3600 is "1 h", 5400 "1.5 h", 90 "1.5 min".
static void print_step(double seconds) {
    static const struct {
        double length;
        const char *name;
    } units[] = {{86400.0, "d"}, {3600.0, "h"}, {60.0, "min"}, {0.0, "s"}};
    int i = 0;
    while (seconds < units[i].length) i++;
    printf("%.4g %s", units[i].length > 0.0 ? seconds / units[i].length : seconds, units[i].name);
}

static void print_records(const bolan_spectrum_contents *c) {
    printf("  records      %u", (unsigned)c->record_count);
    const bolan_spectrum_record *r = c->records;
    if (r[0].time[0]) printf(", %s", r[0].time);
    if (r[0].time[0] && c->record_count > 1) {
        double least = HUGE_VAL, most = 0.0;
        for (uint32_t i = 1; i < c->record_count; i++) {
            least = fmin(least, r[i].seconds - r[i - 1].seconds);
            most = fmax(most, r[i].seconds - r[i - 1].seconds);
        }
        printf(" to %s, every ", r[c->record_count - 1].time);
        if (least < most) print_step(least), printf(" to ");
        print_step(most);
    }
    printf("\n");
}

static void print_places(const bolan_spectrum_contents *c) {
    printf("  locations    %s", c->place_count == 0 ? "one, which the file does not give\n" : "");
    for (uint32_t i = 0; i < c->place_count && i < PLACES_SHOWN; i++) {
        const bolan_spectrum_place *p = &c->places[i];
        printf("%s%u at %.6g, %.6g%s", i ? "               " : "", (unsigned)i + 1, p->x, p->y,
               i              ? ""
               : c->spherical ? " (longitude, latitude)"
                              : " (x, y in metres)");
        if (p->name[0]) printf("  "), output_print(p->name);
        printf("\n");
    }
    if (c->place_count > PLACES_SHOWN) printf("               and %u more\n", (unsigned)c->place_count - PLACES_SHOWN);
}

static void print_table(const char *path, const bolan_spectrum_contents *c) {
    output_print(path);
    printf(": %s\n", c->title);
    print_records(c);
    print_places(c);
    printf("  frequencies  %u, %.4g to %.4g Hz\n", (unsigned)c->frequency_count, c->lowest_hertz, c->highest_hertz);
    if (c->direction_count)
        printf("  directions   %u, every %.4g degrees\n", (unsigned)c->direction_count, 360.0 / c->direction_count);
    else
        printf("  directions   %s\n", c->has_moments ? "their moments, by band" : "none");
    printf("  height       Hs %.4g to %.4g m\n", c->hs_min, c->hs_max);
    printf("  period       Tp %.4g to %.4g s\n", c->tp_min, c->tp_max);
    const double all = (double)c->record_count * (c->place_count ? c->place_count : 1);
    if (c->read_count < all) printf("               (of %u of the %.0f spectra)\n", (unsigned)c->read_count, all);
    if (c->unreadable_count)
        printf("  unreadable   %u of the %u spectra that were read\n", (unsigned)c->unreadable_count,
               (unsigned)c->read_count);
}

// The record whose systems follow.
static void print_record(const bolan_sea_state *sea_state) {
    const bolan_measured_view v = bolan_measured_spectrum_view(sea_state->measured);
    const bolan_sea_summary s = bolan_sea_state_summary(sea_state);
    printf("\n  %s", v.time[0] ? v.time : "the record");
    if (v.place.known) printf(" at %.6g, %.6g", v.place.x, v.place.y);
    printf(": Hs %.4g m, Tp %.4g s, from %.1f degrees, spread %.1f degrees\n", s.hs, s.tp, s.from_deg, s.spread_deg);
}

// ---- JSON -----------------------------------------------------------------------------------------------------------

static void print_json(const bolan_spectrum_contents *c) {
    printf("{\n  \"format\": \"%s\",\n  \"title\": \"%s\",\n  \"records\": [", c->format, c->title);
    for (uint32_t i = 0; i < c->record_count; i++) printf("%s\"%s\"", i ? ", " : "", c->records[i].time);
    printf("],\n  \"spherical\": %s,\n  \"locations\": [", c->spherical ? "true" : "false");
    for (uint32_t i = 0; i < c->place_count; i++) {
        const bolan_spectrum_place *p = &c->places[i];
        printf("%s{\"x\": %.9g, \"y\": %.9g, \"name\": \"", i ? ", " : "", p->x, p->y);
        for (const char *t = p->name; *t; t++) printf(*t == '"' || *t == '\\' ? "\\%c" : "%c", *t);
        printf("\"}");
    }
    printf("],\n  \"frequencies\": {\"count\": %u, \"lowest\": %.9g, \"highest\": %.9g},\n",
           (unsigned)c->frequency_count, c->lowest_hertz, c->highest_hertz);
    printf("  \"directions\": %u,\n  \"moments\": %s,\n  \"read\": %u,\n  \"unreadable\": %u,\n",
           (unsigned)c->direction_count, c->has_moments ? "true" : "false", (unsigned)c->read_count,
           (unsigned)c->unreadable_count);
    printf("  \"hs\": [%.9g, %.9g],\n  \"tp\": [%.9g, %.9g],\n", c->hs_min, c->hs_max, c->tp_min, c->tp_max);
}

static void print_all(const options *o, const bolan_spectrum_contents *contents, const bolan_sea_state *sea_state,
                      const char *time, bool *ok) {
    if (o->json) {
        print_json(contents);
        printf("  \"record_time\": \"%s\",\n  \"systems\": ", time);
        *ok = systems_print_json(sea_state);
        printf("\n}\n");
    } else {
        print_table(o->scene, contents);
        if (sea_state->measured) print_record(sea_state);
        *ok = systems_print_table(sea_state);
    }
}

int info_spectra(const options *o) {
    bolan_spectrum_contents *contents = NULL;
    bolan_measured_spectrum *spectrum = NULL;
    bolan_spectrum_options read = bolan_spectrum_options_default();
    read.interpolate = o->edits.spectrum.interpolate;
    if (option_given(o, "from")) read.from_deg = o->edits.spectrum.from_deg;
    if (option_given(o, "spread")) read.spread_s = o->edits.spectrum.spread_s;
    if (options_spectrum(o, &read)) return EXIT_USAGE;
    bool ok = !bolan_spectrum_contents_load(o->scene, &contents);
    // Without a choice the first record at the first location, where it has data.
    const bool chosen = option_given(o, "record") || option_given(o, "location");
    if (ok && !option_given(o, "location") && contents->place_count > 0) read.location = 1;
    if (ok && (chosen || contents->unreadable_count == 0)) ok = !bolan_spectrum_load(o->scene, &read, &spectrum);
    bolan_sea_state sea_state = bolan_sea_state_default();
    sea_state.measured = spectrum;
    if (ok) print_all(o, contents, &sea_state, spectrum ? bolan_measured_spectrum_view(spectrum).time : "", &ok);
    bolan_measured_spectrum_destroy(&spectrum);
    bolan_spectrum_contents_destroy(&contents);
    return ok ? EXIT_OK : EXIT_FAILED;
}
