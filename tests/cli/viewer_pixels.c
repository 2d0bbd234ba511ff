// SPDX-License-Identifier: MIT
// viewer_pixels FILE X0 Y0 X1 Y1: mean red, green, blue and the standard deviation of brightness inside a rectangle of
// a picture, given in parts of its size, as four whole numbers.
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#include <stb/stb_image.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

int main(int argc, char **argv) {
    int width, height, channels;
    unsigned char *rgb = argc == 6 ? stbi_load(argv[1], &width, &height, &channels, 3) : NULL;
    if (rgb == NULL) {
        fprintf(stderr, "usage: viewer_pixels PICTURE.png X0 Y0 X1 Y1, numbers from 0 to 1\n");
        return 2;
    }
    int x0 = (int)(atof(argv[2]) * width), y0 = (int)(atof(argv[3]) * height);
    int x1 = (int)(atof(argv[4]) * width), y1 = (int)(atof(argv[5]) * height);
    double sum[3] = {0}, bright = 0, square = 0, count = 0;
    for (int y = y0; y < y1; ++y)
        for (int x = x0; x < x1; ++x, ++count) {
            const unsigned char *p = rgb + 3 * ((size_t)y * width + x);
            double value = (p[0] + p[1] + p[2]) / 3.0;
            for (int c = 0; c < 3; ++c) sum[c] += p[c];
            bright += value;
            square += value * value;
        }
    double deviation = sqrt(fmax(square / count - bright * bright / (count * count), 0.0));
    printf("%.0f %.0f %.0f %.0f\n", sum[0] / count, sum[1] / count, sum[2] / count, deviation);
    stbi_image_free(rgb);
    return 0;
}
