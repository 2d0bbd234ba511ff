// SPDX-License-Identifier: MIT
// The sky as an equirectangular map, with the sun in the header.
#include "io/export/writer.h"

#include "bolan/export.h"

#include <math.h>

static bolan_exr_attribute vector(const char *name, bolan_vec3 v) {
    return (bolan_exr_attribute){name, NULL, 3, {(double)v.x, (double)v.y, (double)v.z}};
}

bolan_result bolan_export_sky(const char *path, uint32_t width, uint32_t height, const float *rgb,
                              const bolan_sky_light *light) {
    BOLAN_ASSERT(path && rgb && light);
    const size_t pixels = (size_t)width * height, bytes = 3 * pixels * sizeof(float);
    if (!bolan_export_has_suffix(path, ".exr")) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_BAD_ARGUMENT, "%s: expected a name that ends in .exr", path);
        return BOLAN_ERROR_ARGUMENT;
    }
    float *planes = bolan_allocate(bytes);
    if (!planes) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "%s: no memory for a map of %ux%u", path, (unsigned)width,
                  (unsigned)height);
        return BOLAN_ERROR_MEMORY;
    }
    for (size_t i = 0; i < pixels; i++)
        for (size_t c = 0; c < 3; c++) planes[c * pixels + i] = rgb[3 * i + c];
    const bolan_vec3 sun = light->sun_direction;
    const double azimuth = bolan_degrees(atan2((double)sun.x, (double)sun.y));
    const bolan_exr_channel channels[] = {{"R", planes}, {"G", planes + pixels}, {"B", planes + 2 * pixels}};
    const bolan_exr_attribute attributes[] = {
        {"projection", "equirectangular: row 0 the zenith, the middle column north, columns clockwise", 0, {0.0}},
        {"sunAzimuth", NULL, 1, {azimuth < 0.0 ? azimuth + 360.0 : azimuth}},
        {"sunElevation", NULL, 1, {bolan_degrees(atan2((double)sun.z, hypot((double)sun.x, (double)sun.y)))}},
        vector("sunDirection", sun),
        vector("sunIrradiance", light->sun_irradiance),
        vector("skyIrradiance", light->sky_irradiance)};
    const bolan_exr_part part = {.width = width,
                                 .height = height,
                                 .channels = channels,
                                 .channel_count = 3,
                                 .attributes = attributes,
                                 .attribute_count = sizeof attributes / sizeof *attributes};
    const bolan_result result = bolan_exr_write_parts(path, &part, 1);
    bolan_release(planes, bytes);
    return result;
}
