// SPDX-License-Identifier: MIT
// Haze that the host gives: the same in all directions and at all heights.
void given_haze(float d, out vec3 transmittance, out vec3 inscatter) {
    transmittance = exp(-given_haze_extinction * d);
    inscatter = given_haze_radiance * (1.0 - transmittance);
}
