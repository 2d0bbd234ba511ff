// SPDX-License-Identifier: MIT
// The fine waves of a sea of cascades (bolan_sea_fine()): capillary-gravity waves whose slopes pixels near the eye
// resolve. The table of unresolved slopes counts them as roughness; what a pixel keeps of them is taken from there.
#ifdef WAVES_CASCADES
#pragma unit fine_map 26
uniform sampler2D fine_map; // slope x, slope y

// Adds the fine waves to the slope of a pixel, and takes what it shows of their variance from its roughness. The block
// of the optics has fine_tile, fine_slopes, fine_widest and fine_texel.
void add_fine(sea_place place, footprint f, float gust, float depth, inout vec2 slope, inout vec3 roughness) {
    if (f.minor < fine_widest) {
        float taps = clamp(ceil(f.major * exp2(-fine_texel)), 1.0, float(TAPS));
        float lod = derivative_level(fetched_width(f, taps) - fine_texel);
        vec2 at = fine_tile.xy + vec2(along_tile(place.at.x, place.at.y, fine_tile.z, fine_tile.w),
                                      across_tile(place.at.x, place.at.y, fine_tile.z, fine_tile.w));
        vec2 a = f.axis * (fetched_length(f) / taps);
        vec2 along = vec2(along_tile(a.x, a.y, fine_tile.z, fine_tile.w),
                          across_tile(a.x, a.y, fine_tile.z, fine_tile.w));
        vec2 sum = vec2(0.0);
        for (int i = 0; i < TAP_COUNT(taps); ++i)
            sum += textureLod(fine_map, at + along * tap_place(i, taps), lod).xy;
        float keep = gust;
#ifdef LAND
        keep *= clamp(2.0 * depth, 0.0, 1.0); // no waves run where there is no water
#endif
        slope += keep * unwarped(place, sum / float(TAP_COUNT(taps)));
        roughness -= keep * keep * (1.0 - slope_texel(f).w) * fine_slopes;
    }
}
#endif
