// SPDX-License-Identifier: MIT
// The outputs of water_shape.glsl, as the passes that shade the shape read them.
#pragma unit surface_rest 16
#pragma unit surface_fields 17
uniform highp sampler2D surface_rest;
uniform sampler2DArray surface_fields; // a layer for each of the first two outputs
