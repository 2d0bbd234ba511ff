// SPDX-License-Identifier: MIT
// Filling holes: pull-push (Gortler et al., "The Lumigraph", SIGGRAPH 1996, section 3.5). Each coarser level holds the
// mean of the known values of four; on the way back a hole takes the coarser level's value. Linear in the number of
// samples, whatever the size of the holes.
#include "io/gdal/raster.h"

static bool has_hole(const float *values, size_t count) {
    for (size_t i = 0; i < count; i++)
        if (isnan(values[i])) return true;
    return false;
}

static float mean_of_known(const float *values, int width, int height, int x, int y) {
    float sum = 0.0f;
    int known = 0;
    for (int k = 0; k < 4; k++) {
        const int i = 2 * x + (k & 1), j = 2 * y + (k >> 1);
        if (i >= width || j >= height || isnan(values[(size_t)j * (size_t)width + (size_t)i])) continue;
        sum += values[(size_t)j * (size_t)width + (size_t)i];
        known++;
    }
    return known ? sum / (float)known : NAN;
}

// Bilinear in the coarse level, whose sample (x, y) stands in the middle of four fine ones.
static float coarse_value(const float *coarse, int width, int height, int i, int j) {
    const float u = (float)i * 0.5f - 0.25f, v = (float)j * 0.5f - 0.25f;
    const int x = u < 0.0f ? 0 : (int)u, y = v < 0.0f ? 0 : (int)v;
    const int x1 = x + 1 < width ? x + 1 : x, y1 = y + 1 < height ? y + 1 : y;
    const float s = fmaxf(u - (float)x, 0.0f), t = fmaxf(v - (float)y, 0.0f);
    const float *low = coarse + (size_t)y * (size_t)width, *high = coarse + (size_t)y1 * (size_t)width;
    return (low[x] * (1.0f - s) + low[x1] * s) * (1.0f - t) + (high[x] * (1.0f - s) + high[x1] * s) * t;
}

bolan_result bolan_raster_no_memory(const char *path, size_t count, const char *what) {
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "%s: no memory for %zu %s", path, count, what);
    return BOLAN_ERROR_MEMORY;
}

bolan_result bolan_raster_fill(const char *path, float *values, int width, int height) {
    const size_t count = (size_t)width * (size_t)height;
    if (!has_hole(values, count)) return BOLAN_OK;
    if (width <= 1 && height <= 1) return BOLAN_ERROR_FORMAT;
    const int w = (width + 1) / 2, h = (height + 1) / 2;
    const size_t bytes = (size_t)w * (size_t)h * sizeof(float);
    float *coarse = bolan_allocate(bytes);
    if (!coarse) return bolan_raster_no_memory(path, count, "samples");
    for (int y = 0; y < h; y++)
        for (int x = 0; x < w; x++)
            coarse[(size_t)y * (size_t)w + (size_t)x] = mean_of_known(values, width, height, x, y);
    const bolan_result result = bolan_raster_fill(path, coarse, w, h);
    for (int j = 0; j < height && !result; j++)
        for (int i = 0; i < width; i++) {
            float *value = &values[(size_t)j * (size_t)width + (size_t)i];
            if (isnan(*value)) *value = coarse_value(coarse, w, h, i, j);
        }
    bolan_release(coarse, bytes);
    return result;
}
