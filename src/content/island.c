// SPDX-License-Identifier: MIT
// A generated island: its shape on a grid, then gullies that follow the slope of that shape.
#include "content/island.h"

#include "ground/noise.h"

#define NODES 1153u    // per side
#define HALF_WIDTH 2.3 // [radii]
#define GULLY_OCTAVES 5

typedef struct island_job {
    const island_plan *plan;
    double step, start;
    float *shape, *drained, *out;
} island_job;

static void shape_rows(void *context, uint32_t begin, uint32_t end, uint32_t worker) {
    const island_job *job = context;
    (void)worker;
    for (uint32_t n = begin * NODES; n < end * NODES; n++) {
        double x = job->start + n % NODES * job->step, y = job->start + n / NODES * job->step;
        job->shape[n] = bolan_island_shape(job->plan, x, y, &job->drained[n]);
    }
}

// The depth that running water cuts into a slope (dx, dy) at (x, y).
static float gullies(const island_job *job, double x, double y, float dx, float dy, float drained) {
    float cut = 0.0f, slope = sqrtf(dx * dx + dy * dy);
    double wavelength = 0.17 * job->plan->radius, c = 1.0, s = 0.0;
    for (uint32_t o = 0; o < GULLY_OCTAVES && wavelength > 2.2 * job->step; o++) {
        float total = sqrtf(dx * dx + dy * dy) + 1e-5f, ax = -dy / total, ay = dx / total;
        float lc = (float)c, ls = (float)s, w = (float)wavelength;
        noise_value n = directed_noise((c * x - s * y) / wavelength, (s * x + c * y) / wavelength, lc * ax - ls * ay,
                                       ls * ax + lc * ay, job->plan->seed + 40 + o);
        float fold = sqrtf(n.v * n.v + 0.02f);
        // Deep on steep ground; none on flat ground and on very steep faces.
        float k = w * 0.22f * drained * slope / (0.30f + slope) * smoothstepf(0.08f, 0.40f, slope);
        // Where the ground levels off, the downhill direction turns abruptly: gullies fade out before.
        k *= 0.8f * smoothstepf(0.0f, 0.5f * slope + 0.03f, total);
        cut += k * (0.35f * n.v + 1.0f * (0.40f - fold));
        float steer = k * (0.35f - n.v / fold) / w;
        dx += steer * (lc * n.dx + ls * n.dy);
        dy += steer * (-ls * n.dx + lc * n.dy);
        double turned = 0.8 * c - 0.6 * s;
        s = 0.6 * c + 0.8 * s, c = turned;
        wavelength *= 0.53;
    }
    return cut;
}

static void erode_rows(void *context, uint32_t begin, uint32_t end, uint32_t worker) {
    const island_job *job = context;
    (void)worker;
    for (uint32_t n = begin * NODES; n < end * NODES; n++) {
        uint32_t i = n % NODES, j = n / NODES;
        float z = job->shape[n];
        if (job->drained[n] > 0.0f && i > 1 && j > 1 && i < NODES - 2 && j < NODES - 2) {
            float scale = (float)(0.25 / job->step);
            float dx = (job->shape[n + 2] - job->shape[n - 2]) * scale;
            float dy = (job->shape[n + 2 * NODES] - job->shape[n - 2 * NODES]) * scale;
            float x = (float)(job->start + i * job->step), y = (float)(job->start + j * job->step);
            z = fmaxf(z + gullies(job, x, y, dx, dy, job->drained[n]), 0.4f * z);
        }
        job->out[n] = z;
    }
}

// Scales the land so that the summit has the requested height; the shore keeps its height.
static void set_summit(float *z, size_t count, float peak) {
    const float shore = fminf(6.0f, 0.2f * peak);
    float highest = 2.0f * shore;
    for (size_t n = 0; n < count; n++) {
        highest = fmaxf(highest, z[n]);
    }
    float scale = (peak - shore) / (highest - shore);
    for (size_t n = 0; n < count; n++) {
        z[n] = z[n] > shore ? shore + (z[n] - shore) * scale : z[n];
    }
}

bolan_result bolan_island_create(const bolan_ground_generator *generator, bolan_ground **out) {
    bolan_result r = bolan_params_validate(&bolan_ground_generator_params, generator, "bolan_ground_generator.");
    if (r != BOLAN_OK) {
        return r;
    }
    const size_t plane = (size_t)NODES * NODES;
    float *memory = bolan_allocate(3 * plane * sizeof(float));
    if (!memory) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "no memory for an island of %u x %u elevations", NODES,
                  NODES);
        return BOLAN_ERROR_MEMORY;
    }
    island_plan plan = bolan_island_plan_make(generator);
    double step = 2.0 * HALF_WIDTH * generator->radius / (NODES - 1);
    island_job job = {&plan, step, -HALF_WIDTH * generator->radius, memory, memory + plane, memory + 2 * plane};
    bolan_parallel(NODES, 8, shape_rows, &job);
    bolan_parallel(NODES, 8, erode_rows, &job);
    set_summit(job.out, plane, plan.peak);
    bolan_ground_desc d = bolan_ground_desc_default();
    d.field = (bolan_heightfield){NODES, NODES, job.start, job.start, step, step, job.out};
    d.seed = generator->seed;
    d.edge_elevation = generator->sea_floor;
    r = bolan_ground_create(&d, out);
    bolan_release(memory, 3 * plane * sizeof(float));
    return r;
}
