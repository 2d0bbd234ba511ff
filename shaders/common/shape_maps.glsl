// SPDX-License-Identifier: MIT
// The output of water_shape.glsl, as the passes that shade the shape read it.
#pragma unit surface_shape 16
uniform highp usampler2D surface_shape;
