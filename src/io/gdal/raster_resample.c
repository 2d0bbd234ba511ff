// SPDX-License-Identifier: MIT
// From a window of pixels to the local grid.
//
// Where a grid point lies in the raster is computed for every 16th point and interpolated between: the maps involved
// bend by s^2 / 200 km over 16 steps of s metres, a few per cent of a step at most. Values are interpolated by the
// cubic of Keys (IEEE Trans. ASSP 29, 1981; a = -1/2), which keeps slopes smooth, and held within the four nearest
// samples, so that a cliff produces no island beside it.
#include "io/gdal/raster.h"

enum { NET = 16 };

typedef struct resample_job {
    const raster_window *window;
    const raster_plan *plan;
    const double *net_x, *net_y; // sample coordinates of every NETth point
    uint32_t net_width;
    float *out;
} resample_job;

static int clamp(int value, int last) { return value < 0 ? 0 : value > last ? last : value; }

static void cubic_weights(double t, double w[4]) {
    w[0] = ((-0.5 * t + 1.0) * t - 0.5) * t;
    w[1] = (1.5 * t - 2.5) * t * t + 1.0;
    w[2] = ((-1.5 * t + 2.0) * t + 0.5) * t;
    w[3] = (0.5 * t - 0.5) * t * t;
}

// At sample coordinates (x, y): sample (i, j) stands at (i, j).
static float interpolate(const raster_window *window, double x, double y) {
    const int last_x = window->width - 1, last_y = window->height - 1;
    x = fmin(fmax(x, 0.0), last_x), y = fmin(fmax(y, 0.0), last_y);
    const int i = (int)x, j = (int)y;
    double wx[4], wy[4], sum = 0.0, low = HUGE_VAL, high = -HUGE_VAL;
    cubic_weights(x - i, wx);
    cubic_weights(y - j, wy);
    for (int b = 0; b < 4; b++) {
        const float *row = window->values + (size_t)clamp(j + b - 1, last_y) * (size_t)window->width;
        for (int a = 0; a < 4; a++) {
            const double value = (double)row[clamp(i + a - 1, last_x)];
            sum += wx[a] * wy[b] * value;
            if ((a == 1 || a == 2) && (b == 1 || b == 2)) low = fmin(low, value), high = fmax(high, value);
        }
    }
    return (float)fmin(fmax(sum, low), high);
}

static void resample_rows(void *context, uint32_t begin, uint32_t end, uint32_t worker) {
    const resample_job *job = context;
    (void)worker;
    for (uint32_t j = begin; j < end; j++) {
        const size_t low = (size_t)(j / NET) * job->net_width, high = low + job->net_width;
        const double t = (double)(j % NET) / NET;
        for (uint32_t i = 0; i < job->plan->width; i++) {
            const size_t a = low + i / NET, b = high + i / NET;
            const double s = (double)(i % NET) / NET;
            const double w00 = (1 - s) * (1 - t), w10 = s * (1 - t), w01 = (1 - s) * t, w11 = s * t;
            const double x =
                job->net_x[a] * w00 + job->net_x[a + 1] * w10 + job->net_x[b] * w01 + job->net_x[b + 1] * w11;
            const double y =
                job->net_y[a] * w00 + job->net_y[a + 1] * w10 + job->net_y[b] * w01 + job->net_y[b + 1] * w11;
            job->out[(size_t)j * job->plan->width + i] = isfinite(x + y) ? interpolate(job->window, x, y) : NAN;
        }
    }
}

static void make_net(const raster_source *source, const raster_window *window, const raster_plan *plan, uint32_t width,
                     uint32_t height, double *x, double *y) {
    for (uint32_t j = 0; j < height; j++) {
        double *row_x = x + (size_t)j * width, *row_y = y + (size_t)j * width;
        for (uint32_t i = 0; i < width; i++) {
            row_x[i] = plan->west + plan->step_x * i * NET;
            row_y[i] = plan->south + plan->step_y * j * NET;
        }
        bolan_raster_local_to_pixel(source, (int)width, row_x, row_y);
        for (uint32_t i = 0; i < width; i++) { // from pixels to the window's samples, whose centres are whole numbers
            row_x[i] = (row_x[i] - window->x) / window->pixels_per_sample - 0.5;
            row_y[i] = (row_y[i] - window->y) / window->pixels_per_sample - 0.5;
        }
    }
}

bolan_result bolan_raster_resample(const raster_source *source, const raster_window *window, const raster_plan *plan,
                                   float *out) {
    const uint32_t width = (plan->width - 1) / NET + 2, height = (plan->height - 1) / NET + 2;
    const size_t count = (size_t)width * height, bytes = 2 * count * sizeof(double);
    double *net = bolan_allocate(bytes);
    if (!net) return bolan_raster_no_memory(source->path, count, "places");
    make_net(source, window, plan, width, height, net, net + count);
    resample_job job = {window, plan, net, net + count, width, out};
    bolan_parallel(plan->height, 16, resample_rows, &job);
    bolan_release(net, bytes);
    return BOLAN_OK;
}
