// SPDX-License-Identifier: MIT
// See canvas.h. Letters are those of stb_easy_font, as filled rectangles.
#include "io/canvas.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#pragma GCC diagnostic ignored "-Wunused-function" // of which some are left over
#include <stb/stb_easy_font.h>

enum { LETTERS_MAX = 96 };

uint8_t *bolan_canvas_pixel(const canvas *c, int x, int y) { return c->rgb + ((size_t)y * c->width + x) * 3; }

void bolan_canvas_fill(const canvas *c, int x0, int y0, int x1, int y1, const uint8_t colour[3]) {
    for (int y = y0 < 0 ? 0 : y0; y < y1 && y < c->height; y++)
        for (int x = x0 < 0 ? 0 : x0; x < x1 && x < c->width; x++) memcpy(bolan_canvas_pixel(c, x, y), colour, 3);
}

// Coverage falls from 1 to 0 over one pixel at the edge.
static void blend(uint8_t *rgb, const uint8_t colour[3], double share) {
    for (int i = 0; i < 3; i++) rgb[i] = (uint8_t)(rgb[i] + share * (colour[i] - rgb[i]) + 0.5);
}

void bolan_canvas_line(const canvas *c, double x0, double y0, double x1, double y1, double width,
                       const uint8_t colour[3]) {
    const double dx = x1 - x0, dy = y1 - y0, square = dx * dx + dy * dy, reach = 0.5 * width + 0.5;
    const int left = (int)fmax(fmin(x0, x1) - reach, 0.0), right = (int)fmin(fmax(x0, x1) + reach, c->width - 1.0);
    const int top = (int)fmax(fmin(y0, y1) - reach, 0.0), bottom = (int)fmin(fmax(y0, y1) + reach, c->height - 1.0);
    for (int y = top; y <= bottom; y++)
        for (int x = left; x <= right; x++) {
            const double px = x + 0.5 - x0, py = y + 0.5 - y0;
            const double along = square > 0.0 ? fmin(fmax((px * dx + py * dy) / square, 0.0), 1.0) : 0.0;
            const double share = reach - hypot(px - along * dx, py - along * dy);
            if (share > 0.0) blend(bolan_canvas_pixel(c, x, y), colour, fmin(share, 1.0));
        }
}

typedef struct letter_vertex {
    float x, y, z;
    uint8_t colour[4];
} letter_vertex;

void bolan_canvas_print(const canvas *c, int x, int y, int scale, const char *text) {
    static const uint8_t ink[3] = {25, 30, 40};
    letter_vertex quads[LETTERS_MAX * 20][4];
    char line[LETTERS_MAX];
    snprintf(line, sizeof line, "%s", text);
    for (char *letter = line; *letter; letter++)
        if (*letter < ' ' || *letter > '~') *letter = '?';
    const int count = stb_easy_font_print(0.0f, 0.0f, line, NULL, quads, (int)sizeof quads);
    for (int i = 0; i < count; i++)
        bolan_canvas_fill(c, x + scale * (int)quads[i][0].x, y + scale * (int)quads[i][0].y,
                          x + scale * (int)quads[i][2].x, y + scale * (int)quads[i][2].y, ink);
}

void bolan_canvas_print_centred(const canvas *c, int x, int y, int scale, const char *text) {
    char line[LETTERS_MAX];
    snprintf(line, sizeof line, "%s", text);
    bolan_canvas_print(c, x - scale * stb_easy_font_width(line) / 2, y - 4 * scale, scale, line);
}
