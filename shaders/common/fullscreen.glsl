// SPDX-License-Identifier: MIT
// One triangle over the whole target, without buffers. A pass's vertex shader is: void main() { fullscreen(0.5); }
#ifdef VERTEX
out vec2 uv; // 0..1, (0,0) at the lower left

// depth: clip z of the triangle (w = 1); its window depth is that, or half of it plus 0.5 without clip control.
void fullscreen(float clip_depth) {
    vec2 corner = vec2(gl_VertexID == 1 ? 2.0 : 0.0, gl_VertexID == 2 ? 2.0 : 0.0);
    uv = corner;
    gl_Position = vec4(corner * 2.0 - 1.0, clip_depth, 1.0);
}
#endif
#ifdef FRAGMENT
in vec2 uv;
#endif
