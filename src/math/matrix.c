// SPDX-License-Identifier: MIT
// Matrices: column-major, column vectors; m[4 * column + row].
#include "bolan/math.h"
#include "math/sincos.h"

bolan_mat4 bolan_m4_identity(void) {
    const bolan_mat4 identity = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}};
    return identity;
}

bolan_vec4 bolan_m4_mul_v4(bolan_mat4 a, bolan_vec4 v) {
    const float *m = a.m;
    bolan_vec4 r;
    r.x = m[0] * v.x + m[4] * v.y + m[8] * v.z + m[12] * v.w;
    r.y = m[1] * v.x + m[5] * v.y + m[9] * v.z + m[13] * v.w;
    r.z = m[2] * v.x + m[6] * v.y + m[10] * v.z + m[14] * v.w;
    r.w = m[3] * v.x + m[7] * v.y + m[11] * v.z + m[15] * v.w;
    return r;
}

bolan_mat4 bolan_m4_mul(bolan_mat4 a, bolan_mat4 b) {
    bolan_mat4 r;
    for (int column = 0; column < 4; column++) {
        const float *c = &b.m[4 * column];
        const bolan_vec4 product = bolan_m4_mul_v4(a, (bolan_vec4){c[0], c[1], c[2], c[3]});
        r.m[4 * column + 0] = product.x;
        r.m[4 * column + 1] = product.y;
        r.m[4 * column + 2] = product.z;
        r.m[4 * column + 3] = product.w;
    }
    return r;
}

bolan_mat4 bolan_m4_transpose(bolan_mat4 a) {
    bolan_mat4 r;
    for (int column = 0; column < 4; column++) {
        for (int row = 0; row < 4; row++) r.m[4 * column + row] = a.m[4 * row + column];
    }
    return r;
}

// The 2x2 determinants of two neighbouring rows, for columns (0,1) (0,2) (0,3) (1,2) (1,3) (2,3).
static void row_pair_minors(const bolan_mat4 *a, int row, double minors[6]) {
    int next = 0;
    for (int i = 0; i < 4; i++) {
        for (int j = i + 1; j < 4; j++) {
            minors[next++] = (double)a->m[4 * i + row] * (double)a->m[4 * j + row + 1] -
                             (double)a->m[4 * j + row] * (double)a->m[4 * i + row + 1];
        }
    }
}

bolan_mat4 bolan_m4_inverse(bolan_mat4 a) {
    // Laplace expansion by pairs of rows, in double: s from rows 0 and 1, c from rows 2 and 3.
    double s[6], c[6], e[16];
    row_pair_minors(&a, 0, s);
    row_pair_minors(&a, 2, c);
    for (int i = 0; i < 16; i++) e[i] = (double)a.m[i];
    const double det = s[0] * c[5] - s[1] * c[4] + s[2] * c[3] + s[3] * c[2] - s[4] * c[1] + s[5] * c[0];
    const double adjugate[16] = {
        // column-major, as the matrices
        +e[5] * c[5] - e[9] * c[4] + e[13] * c[3],  -e[1] * c[5] + e[9] * c[2] - e[13] * c[1],
        +e[1] * c[4] - e[5] * c[2] + e[13] * c[0],  -e[1] * c[3] + e[5] * c[1] - e[9] * c[0],
        -e[4] * c[5] + e[8] * c[4] - e[12] * c[3],  +e[0] * c[5] - e[8] * c[2] + e[12] * c[1],
        -e[0] * c[4] + e[4] * c[2] - e[12] * c[0],  +e[0] * c[3] - e[4] * c[1] + e[8] * c[0],
        +e[7] * s[5] - e[11] * s[4] + e[15] * s[3], -e[3] * s[5] + e[11] * s[2] - e[15] * s[1],
        +e[3] * s[4] - e[7] * s[2] + e[15] * s[0],  -e[3] * s[3] + e[7] * s[1] - e[11] * s[0],
        -e[6] * s[5] + e[10] * s[4] - e[14] * s[3], +e[2] * s[5] - e[10] * s[2] + e[14] * s[1],
        -e[2] * s[4] + e[6] * s[2] - e[14] * s[0],  +e[2] * s[3] - e[6] * s[1] + e[10] * s[0],
    };
    bolan_mat4 r;
    for (int i = 0; i < 16; i++) r.m[i] = (float)(adjugate[i] / det);
    return r;
}

bolan_mat4 bolan_m4_view(double heading_deg, double pitch_deg, double roll_deg) {
    double sh, ch, sp, cp, sr, cr;
    bolan_sincos_inline(bolan_radians(heading_deg), &sh, &ch);
    bolan_sincos_inline(bolan_radians(pitch_deg), &sp, &cp);
    bolan_sincos_inline(bolan_radians(roll_deg), &sr, &cr);
    const double forward[3] = {sh * cp, ch * cp, sp};
    const double right[3] = {ch, -sh, 0.0};
    const double up[3] = {-sh * sp, -ch * sp, cp}; // right x forward
    bolan_mat4 r = bolan_m4_identity();
    for (int axis = 0; axis < 3; axis++) {
        // Rolled clockwise as seen from behind the camera: the right wing goes down.
        r.m[4 * axis + 0] = (float)(right[axis] * cr - up[axis] * sr);
        r.m[4 * axis + 1] = (float)(up[axis] * cr + right[axis] * sr);
        r.m[4 * axis + 2] = (float)-forward[axis];
    }
    return r;
}

bolan_mat4 bolan_m4_projection(double fov_y, double aspect, double near_m, int zero_to_one) {
    double s, c;
    bolan_sincos_inline(0.5 * fov_y, &s, &c);
    bolan_mat4 r = {{0}};
    r.m[0] = (float)(c / (s * aspect));
    r.m[5] = (float)(c / s);
    r.m[11] = -1.0f; // w = distance
    if (zero_to_one) {
        r.m[14] = (float)near_m; // z / w = near / distance
    } else {
        r.m[10] = 1.0f; // z / w = 2 near / distance - 1, and the window depth (z / w + 1) / 2 is near / distance again
        r.m[14] = (float)(2.0 * near_m);
    }
    return r;
}
