// SPDX-License-Identifier: MIT
// Defaults of the sources of ground.
#include "bolan/ground.h"

#include <string.h>

bolan_ground_generator bolan_ground_generator_default(void) {
    bolan_ground_generator generator;
    memset(&generator, 0, sizeof generator);
    bolan_params_default(&bolan_ground_generator_params, &generator);
    return generator;
}

bolan_raster_desc bolan_raster_desc_default(void) {
    bolan_raster_desc desc;
    memset(&desc, 0, sizeof desc);
    bolan_params_default(&bolan_raster_params, &desc);
    return desc;
}
