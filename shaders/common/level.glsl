// SPDX-License-Identifier: MIT
// Levels of detail of trilinear fetches. From medium quality down a fetch reads one level over three quarters of an
// octave, and blends two over the rest. Of a whole level software OpenGL reads one, for half the cost.
const float LEVEL_BLEND = 0.25; // share of an octave

float fetched_level(float level) {
#if defined(TAPS) && TAPS <= 2
    float whole = floor(level);
    return whole + clamp((level - whole - 0.5) / LEVEL_BLEND + 0.5, 0.0, 1.0);
#else
    return level;
#endif
}
