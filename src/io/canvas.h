// SPDX-License-Identifier: MIT
/// @file canvas.h
/// Lines, rectangles and letters on an image in memory, for plots. Private to src/io and tools.
#ifndef BOLAN_IO_CANVAS_H
#define BOLAN_IO_CANVAS_H

#include <stdint.h>

/// An image: rgb[(y * width + x) * 3 ...], from the top down. The memory is the caller's.
typedef struct canvas {
    int width, height;
    uint8_t *rgb;
} canvas;

/// The pixel at (x, y), which must lie inside.
uint8_t *bolan_canvas_pixel(const canvas *c, int x, int y);
/// Fills the rectangle [x0, x1) x [y0, y1), as far as it lies inside.
void bolan_canvas_fill(const canvas *c, int x0, int y0, int x1, int y1, const uint8_t colour[3]);
/// Draws a line of @p width pixels with soft edges.
void bolan_canvas_line(const canvas *c, double x0, double y0, double x1, double y1, double width,
                       const uint8_t colour[3]);
/// A line of text with its upper left corner at (x, y), in letters of 7 x scale pixels; at most 95 letters.
void bolan_canvas_print(const canvas *c, int x, int y, int scale, const char *text);
/// Likewise, with its middle at (x, y).
void bolan_canvas_print_centred(const canvas *c, int x, int y, int scale, const char *text);

#endif
