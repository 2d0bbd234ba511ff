// SPDX-License-Identifier: MIT
// See spectrum_plot.h. A picture of 960 x 720: the disc on the left, the scale of colours and the systems on the right.
#include "io/spectrum_plot.h"

#include "bolan/math.h"
#include "io/canvas.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { WIDTH = 960, HEIGHT = 720, LETTERS_MAX = 96 };

#define CENTRE_X 330.0
#define CENTRE_Y 385.0
#define RADIUS 270.0
#define SIDE 672 // where the right column begins

// Nine colours of equal steps, from white over green to dark blue.
static void colour_of(double share, uint8_t out[3]) {
    static const uint8_t anchors[9][3] = {{255, 255, 255}, {237, 248, 177}, {199, 233, 180},
                                          {127, 205, 187}, {65, 182, 196},  {29, 145, 192},
                                          {34, 94, 168},   {37, 52, 148},   {8, 29, 88}};
    const double at = 8.0 * fmin(fmax(share, 0.0), 1.0);
    const int i = at < 8.0 ? (int)at : 7;
    for (int c = 0; c < 3; c++)
        out[c] = (uint8_t)(anchors[i][c] + (at - i) * (anchors[i + 1][c] - anchors[i][c]) + 0.5);
}

static void darken(uint8_t rgb[3], double amount) {
    for (int c = 0; c < 3; c++) rgb[c] = (uint8_t)(rgb[c] * (1.0 - amount) + 90.0 * amount);
}

// ---- the disc -------------------------------------------------------------------------------------------------------

typedef struct plot {
    const bolan_sea_state *sea_state; // the sampled spectrum alone
    double ring;                      // step of the rings [Hz]
    double outer;                     // frequency of the rim [Hz]
    double largest;                   // density [m2/Hz/deg]
} plot;

// m2 s/rad per rad to m2/Hz per degree.
static double per_hertz_and_degree(double density) { return density * 2.0 * BOLAN_PI * BOLAN_PI / 180.0; }

// The rim: the frequency below which 98 % of the variance lies, rounded up to a ring; 3 to 6 rings.
static plot prepare(const bolan_sea_state *sampled, const bolan_measured_view *v) {
    plot p = {.sea_state = sampled};
    double whole = 0.0, sum = 0.0, rim = 0.1;
    for (int pass = 0; pass < 2; pass++)
        for (uint32_t i = 0; i + 1 < v->frequency_count; i++) {
            double row = 0.0;
            for (uint32_t j = 0; j < v->direction_count; j++) {
                const double density = v->density[(size_t)i * v->direction_count + j];
                p.largest = fmax(p.largest, per_hertz_and_degree(density));
                row += density * (v->omega[i + 1] - v->omega[i]);
            }
            if (pass == 0) whole += row;
            if (pass == 1 && sum < 0.98 * whole) rim = v->omega[i + 1] / (2.0 * BOLAN_PI);
            if (pass == 1) sum += row;
        }
    static const double steps[] = {0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0};
    for (int i = 0; i < 8; i++) {
        p.ring = steps[i];
        if (rim <= 6.0 * steps[i]) break;
    }
    p.outer = p.ring * ceil(rim / p.ring);
    return p;
}

static void draw_disc(const plot *p, canvas *out) {
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < SIDE - 20; x++) {
            const double dx = x + 0.5 - CENTRE_X, dy = CENTRE_Y - y - 0.5, r = hypot(dx, dy);
            if (r > RADIUS + 1.0) continue;
            const double hertz = r / RADIUS * p->outer, from = atan2(dx, dy); // clockwise from the north
            double to = 1.5 * BOLAN_PI - from;
            to -= 2.0 * BOLAN_PI * floor(to / (2.0 * BOLAN_PI));
            const double density =
                per_hertz_and_degree(bolan_sea_state_density(p->sea_state, 2.0 * BOLAN_PI * hertz, to));
            uint8_t *rgb = bolan_canvas_pixel(out, x, y);
            if (r <= RADIUS) colour_of(p->largest > 0.0 ? sqrt(density / p->largest) : 0.0, rgb);
            const double rings = hertz / p->ring, spokes = from / (BOLAN_PI / 6.0);
            const double to_ring = fabs(rings - round(rings)) * p->ring / p->outer * RADIUS;
            const double to_spoke = fabs(spokes - round(spokes)) * BOLAN_PI / 6.0 * r;
            darken(rgb, 0.35 * fmax(fmax(1.0 - to_ring, 1.0 - to_spoke), 0.0));
            if (fabs(r - RADIUS) < 1.0) darken(rgb, 0.8);
        }
}

static void draw_axes(const plot *p, canvas *out) {
    char text[LETTERS_MAX];
    for (int i = 0; i < 12; i++) {
        static const char *const names[12] = {"N", "30", "60", "E", "120", "150", "S", "210", "240", "W", "300", "330"};
        const double angle = i * BOLAN_PI / 6.0, r = RADIUS + 22.0;
        bolan_canvas_print_centred(out, (int)(CENTRE_X + r * sin(angle)), (int)(CENTRE_Y - r * cos(angle)), 2,
                                   names[i]);
    }
    for (double hertz = p->ring; hertz < p->outer + 0.5 * p->ring; hertz += p->ring) {
        const double r = hertz / p->outer * RADIUS, angle = BOLAN_PI / 12.0; // between two spokes
        bolan_format(text, sizeof text, "%g Hz, %.3g s", hertz, 1.0 / hertz);
        if (hertz <= p->outer * 1.001)
            bolan_canvas_print_centred(out, (int)(CENTRE_X + r * sin(angle)), (int)(CENTRE_Y - r * cos(angle)), 1,
                                       text);
    }
}

static void draw_scale(const plot *p, canvas *out) {
    enum { TOP = 130, LENGTH = 200, BREADTH = 24 };
    char text[LETTERS_MAX];
    bolan_canvas_print(out, SIDE, TOP - 40, 1, "density, m2/(Hz deg)");
    for (int y = 0; y < LENGTH; y++) {
        uint8_t colour[3];
        colour_of(1.0 - (double)y / LENGTH, colour);
        bolan_canvas_fill(out, SIDE, TOP + y, SIDE + BREADTH, TOP + y + 1, colour);
    }
    for (int i = 0; i <= 4; i++) {
        const double share = i / 4.0;
        bolan_format(text, sizeof text, "%.3g", p->largest * share * share); // the colour is the square root
        bolan_canvas_print(out, SIDE + BREADTH + 10, TOP + LENGTH - i * LENGTH / 4 - 4, 1, text);
    }
}

// The number of a system, beside its peak.
static void draw_mark(const plot *p, canvas *out, const bolan_partition *system, int number) {
    static const uint8_t white[3] = {255, 255, 255};
    const double r = 1.0 / system->tp / p->outer * RADIUS + 16.0, angle = bolan_radians(system->from_deg);
    const int x = (int)(CENTRE_X + r * sin(angle)), y = (int)(CENTRE_Y - r * cos(angle));
    char text[4];
    if (r > RADIUS + 16.0) return;
    snprintf(text, sizeof text, "%d", number % 10);
    bolan_canvas_fill(out, x - 8, y - 10, x + 8, y + 9, white);
    bolan_canvas_print_centred(out, x + 1, y + 1, 2, text);
}

static bolan_result draw_systems(const plot *p, const bolan_sea_state *sea_state, canvas *out) {
    bolan_partition systems[BOLAN_MAX_PARTITIONS];
    uint32_t count = 0;
    char text[LETTERS_MAX];
    const bolan_result result = bolan_sea_state_partition(sea_state, systems, &count);
    if (result) return result;
    for (uint32_t i = 0; i < count; i++) {
        const bolan_partition *s = &systems[i];
        const int y = 375 + 40 * (int)i;
        bolan_format(text, sizeof text, "%u %s", (unsigned)i + 1, s->wind_sea ? "wind sea" : "swell");
        bolan_canvas_print(out, SIDE, y, 2, text);
        bolan_format(text, sizeof text, "Hs %.2f m  Tp %.1f s  from %.0f  spread %.0f deg", s->hs, s->tp, s->from_deg,
                     s->spread_deg);
        bolan_canvas_print(out, SIDE, y + 20, 1, text);
        draw_mark(p, out, s, (int)i + 1);
    }
    return BOLAN_OK;
}

static void draw_title(const bolan_sea_state *sea_state, const bolan_measured_view *v, const char *title, canvas *out) {
    char text[2 * LETTERS_MAX];
    const bolan_sea_summary s = bolan_sea_state_summary(sea_state);
    snprintf(text, sizeof text, "%s%s%s", title, v->time[0] ? "  " : "", v->time);
    bolan_canvas_print(out, 24, 18, 2, text);
    bolan_format(text, sizeof text, "Hs %.2f m   Tp %.1f s   Tm02 %.1f s   from %.0f deg   spread %.0f deg", s.hs, s.tp,
                 s.tm02, s.from_deg, s.spread_deg);
    bolan_canvas_print(out, 24, 44, 2, text);
    bolan_canvas_print(out, 24, HEIGHT - 20, 1, "directions: where waves come from; frequency outwards");
}

bolan_result bolan_spectrum_plot(const char *path, const bolan_sea_state *sea_state,
                                 const bolan_measured_spectrum *spectrum, const char *title) {
    const size_t bytes = (size_t)WIDTH * HEIGHT * 3;
    canvas image = {WIDTH, HEIGHT, bolan_allocate(bytes)}, *out = &image;
    if (!out->rgb) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "%s: no memory to draw it", path);
        return BOLAN_ERROR_MEMORY;
    }
    memset(out->rgb, 255, bytes);
    const bolan_measured_view view = bolan_measured_spectrum_view(spectrum);
    bolan_sea_state sampled = bolan_sea_state_default();
    sampled.measured = spectrum;
    const plot p = prepare(&sampled, &view);
    draw_disc(&p, out);
    draw_axes(&p, out);
    draw_scale(&p, out);
    draw_title(sea_state, &view, title, out);
    bolan_result result = draw_systems(&p, sea_state, out);
    if (!result) result = bolan_png_write(path, WIDTH, HEIGHT, out->rgb);
    bolan_release(out->rgb, bytes);
    return result;
}
