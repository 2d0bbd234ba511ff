// SPDX-License-Identifier: MIT
// See systems.h.
#include "systems.h"

#include <stdio.h>

static const char *kind_of(const bolan_partition *p) { return p->wind_sea ? "wind sea" : "swell"; }

bool systems_print_table(const bolan_sea_state *sea_state) {
    bolan_partition list[BOLAN_MAX_PARTITIONS];
    uint32_t count;
    if (bolan_sea_state_partition(sea_state, list, &count)) return false;
    if (count > 0) printf("\n  system        Hs m    Tp s   from deg   spread deg\n");
    for (uint32_t i = 0; i < count; i++)
        printf("  %-10s %7.3g %7.3g %10.1f %12.1f\n", kind_of(&list[i]), list[i].hs, list[i].tp, list[i].from_deg,
               list[i].spread_deg);
    return true;
}

bool systems_print_json(const bolan_sea_state *sea_state) {
    bolan_partition list[BOLAN_MAX_PARTITIONS];
    uint32_t count;
    if (bolan_sea_state_partition(sea_state, list, &count)) return false;
    printf("[");
    for (uint32_t i = 0; i < count; i++)
        printf("%s{\"kind\": \"%s\", \"hs\": %.9g, \"tp\": %.9g, \"from\": %.9g, \"spread\": %.9g}", i ? ", " : "",
               kind_of(&list[i]), list[i].hs, list[i].tp, list[i].from_deg, list[i].spread_deg);
    printf("]");
    return true;
}
