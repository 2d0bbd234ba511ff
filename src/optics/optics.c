// SPDX-License-Identifier: MIT
// Optical coefficients of sea water for Jerlov's water types.
//
// Kd, the diffuse attenuation of downward irradiance, is known for each type. Its parts are computed in this order:
//   pure sea water   a_w (Pope & Fry, Appl. Opt. 36, 1997), b_w = 0.00288 (l / 500 nm)^-4.32 (Morel 1974), bb_w = b_w/2
//   particles        b_p = 0.30 C^0.62 (550 nm / l) (Gordon & Morel 1983), C = chlorophyll [mg/m3] of the type; of this
//                    the share 0.002 + 0.02 (0.5 - 0.25 log10 C) (550 nm / l) is scattered back in the open ocean
//                    (Morel, J. Geophys. Res. 93, 1988, eq. 10), and 0.0183 (Petzold 1972) in coastal water, which
//                    holds minerals
//   absorption       a = mu_d Kd - bb, the mean cosine of downwelling light mu_d = 0.9 (Kirk 2011, section 6.7), but
//                    not below that of pure water
//   deep colour      Gordon et al., J. Geophys. Res. 93, 1988, eq. 8: u = bb / (a + bb), r = 0.0949 u + 0.0794 u^2 just
//                    under the surface, through which Lee et al. (Appl. Opt. 37, 1998) let 0.52 r / (1 - 1.7 r)
#include "bolan/optics.h"

enum { TYPES = BOLAN_JERLOV_TYPES };

#define MEAN_COSINE 0.9
#define PETZOLD_BACKSCATTER_SHARE 0.0183

typedef struct type_data {
    double kd[3];       // at 650, 550, 450 nm [1/m]
    double chlorophyll; // [mg/m3]
} type_data;

// Kd: Austin & Petzold, Opt. Eng. 25 (1986) for I to 1C; Jerlov, Marine Optics (1976), table XXVII for 3C to 9C.
// Chlorophyll: Morel 1988, table 2, for I to III. For coastal types no relation is published: each has about twice the
// chlorophyll of the type before, so that scattering grows with attenuation.
static const type_data types[TYPES] = {
    {{0.3559, 0.0640, 0.0176}, 0.01}, {{0.3601, 0.0674, 0.0257}, 0.05}, {{0.3652, 0.0715, 0.0355}, 0.1},
    {{0.3837, 0.0863, 0.0714}, 0.5},  {{0.4181, 0.1139, 0.1381}, 1.75}, {{0.4525, 0.1415, 0.2048}, 3.0},
    {{0.46, 0.19, 0.39}, 6.0},        {{0.54, 0.30, 0.56}, 12.0},       {{0.63, 0.46, 0.89}, 20.0},
    {{0.76, 0.63, 1.60}, 40.0},
};

static const double wavelengths[3] = {650.0, 550.0, 450.0}; // [nm]
static const double pure_absorption[3] = {0.340, 0.0565, 0.00922};
static const double pure_scattering[3] = {0.000927, 0.001908, 0.004540};

static double backscatter_share(bolan_jerlov type, double ratio) {
    if (type >= BOLAN_JERLOV_1C) return PETZOLD_BACKSCATTER_SHARE;
    return 0.002 + 0.02 * (0.5 - 0.25 * log10(types[type].chlorophyll)) * ratio;
}

static double remote_sensing_reflectance(double absorption, double backscatter) {
    const double u = backscatter / (absorption + backscatter);
    const double under = u * (0.0949 + 0.0794 * u);
    return 0.52 * under / (1.0 - 1.7 * under);
}

bolan_water_optics bolan_water_optics_from_jerlov(bolan_jerlov type) {
    BOLAN_ASSERT((int)type >= 0 && (int)type < TYPES);
    if ((int)type < 0 || (int)type >= TYPES) type = BOLAN_JERLOV_IB;
    float kd[3], a[3], b[3], bb[3], deep[3];
    for (int i = 0; i < 3; i++) {
        const double ratio = 550.0 / wavelengths[i];
        const double particles = 0.30 * pow(types[type].chlorophyll, 0.62) * ratio;
        const double back = 0.5 * pure_scattering[i] + backscatter_share(type, ratio) * particles;
        const double absorbed = fmax(MEAN_COSINE * types[type].kd[i] - back, pure_absorption[i]);
        kd[i] = (float)types[type].kd[i];
        a[i] = (float)absorbed;
        b[i] = (float)(pure_scattering[i] + particles);
        bb[i] = (float)back;
        deep[i] = (float)remote_sensing_reflectance(absorbed, back);
    }
    const bolan_water_optics optics = {
        .kd = {kd[0], kd[1], kd[2]},
        .absorption = {a[0], a[1], a[2]},
        .scattering = {b[0], b[1], b[2]},
        .backscatter = {bb[0], bb[1], bb[2]},
        .deep = {deep[0], deep[1], deep[2]},
        .index = 1.34f,
    };
    return optics;
}

// ---- names ----------------------------------------------------------------------------------------------------------

const char *const bolan_jerlov_names[BOLAN_JERLOV_TYPES + 1] = {"I",  "IA", "IB", "II", "III", "1C",
                                                                "3C", "5C", "7C", "9C", NULL};

static char upper(char c) { return c >= 'a' && c <= 'z' ? (char)(c - 'a' + 'A') : c; }

static bool same_name(const char *a, const char *b) {
    while (*a && upper(*a) == upper(*b)) a++, b++;
    return upper(*a) == upper(*b);
}

int bolan_jerlov_from_name(const char *name) {
    for (int i = 0; i < TYPES; i++)
        if (same_name(bolan_jerlov_names[i], name)) return i;
    return -1;
}

const char *bolan_jerlov_name(bolan_jerlov type) {
    return (int)type >= 0 && (int)type < TYPES ? bolan_jerlov_names[type] : "?";
}
