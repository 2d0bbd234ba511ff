// SPDX-License-Identifier: MIT
// Spindrift: spray that the wind tears off breaking crests. Around the eye lie rings of cells, each ring with cells
// twice as wide as those of the ring inside it; a cell has a few veils of spray. A veil starts where its cell's water
// breaks, goes with the wind and thins out, then starts elsewhere in the cell. Where and when follows from the cell and
// the time alone, so spray is a function of time.
#ifndef BOLAN_SHARED_SPRAY
#define BOLAN_SHARED_SPRAY
#include "shared/language.glsl"

#define SPRAY_RINGS 4
#define SPRAY_CELL 4.0      // side of a cell of the innermost ring [m]; WORLD_WRAP is a multiple of the widest block
#define SPRAY_SIDE 8        // cells along a side of a block
#define SPRAY_REACH 2       // blocks of a ring to each side of the eye's
#define SPRAY_VEILS 3       // of a cell
#define SPRAY_BLOCKS 100    // at most: (2 SPRAY_REACH + 1)^2 SPRAY_RINGS
#define SPRAY_LIFE 1.6      // of a veil [s]
#define SPRAY_LIVES 4096.0  // after so many the veils repeat
#define SPRAY_HIGH 150.0    // [m] an eye so high sees none
#define SPRAY_FLIES 80.0    // from its crest to the farthest edge of a veil [m]: drift in 70 m/s, and half its length

// How much of the spray of a hurricane there is. "Edges of crests begin to break into spindrift" is Beaufort's force 8,
// "spray may affect visibility" force 9 (WMO): it begins in force 8 and is seen from 9 on, 20.8 m/s. The mass of spray
// goes with about the cube of the wind (Andreas 1998).
#define SPINDRIFT_BEGINS 18.5 // [m/s]
#define SPINDRIFT_ALL 33.0
SHARED real spindrift_share(real wind_speed) {
    real t = clamp((wind_speed - SPINDRIFT_BEGINS) / (SPINDRIFT_ALL - SPINDRIFT_BEGINS), 0.0, 1.0);
    real speed = wind_speed / SPINDRIFT_ALL;
    return min(speed * speed * speed, 1.0) * t * (2.0 - t);
}
#endif
