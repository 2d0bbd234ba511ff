// SPDX-License-Identifier: MIT
// Members of the uniform block Optics of the physical optics, written by src/render/water_physical.c.
vec4 fine_tile;               // of the fine waves: the eye in the tile [0,1), cos, sin of its angle over its side [1/m]
vec3 fine_slopes;             // their slope covariance xx, xy, yy
float streak_excess;          // quantile of the share under streaks (below -999: there are none)
vec3 water_scattering;        // [1/m]
float jacobian_variance;      // of all scales
float fine_widest;            // pixels wider than that show none of them [m], 0: there are none
float fine_texel;             // log2 of a texel [m]
float breaking_jacobian;      // Jacobian below which crests break (below -999: nothing foams)
float slopes_beyond_cascades; // slope variance of the waves that no cascade has
float fresh_edge;             // variance that softens the edge of fresh foam; the threshold allows for it
float old_edge;               // likewise of old foam, as a share of the memory's variance
float old_foam_memory;        // foam memory where old foam begins (above 999: there is none)
float memory_variance;
float spray_time;             // in lives of a veil of spray, modulo SPRAY_LIVES
