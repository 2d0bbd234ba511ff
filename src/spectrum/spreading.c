// SPDX-License-Identifier: MIT
// Directional spreading. Sources:
// - cos-2s: Longuet-Higgins, Cartwright & Smith (1963); its exponent: Mitsuyasu et al., J. Phys. Oceanogr. 5 (1975);
//   Hasselmann, Dunckel & Ewing, J. Phys. Oceanogr. 10 (1980).
// - sech^2: Donelan, Hamilton & Hui, Phil. Trans. R. Soc. A 315 (1985), eq. 9.3; above 1.6 wp Banner, J. Phys.
//   Oceanogr. 20 (1990), eq. 5.
// - 1 + Delta cos 2 th: Elfouhaily et al., J. Geophys. Res. 102 (1997), eq. 49.
// - The swell parameter: C. Horvath, "Empirical directional wave spectra for computer graphics", DigiPro (2015), eq.
//   44-45, renormalised here over the whole circle.
#include "bolan/math.h"
#include "spectrum/portable.h"
#include "spectrum/spectrum_eval.h"

// Horvath's factor |cos(th/2)|^{2 s_xi} has the form of cos-2s, so there the exponents just add.
static double swell_exponent(const spectrum_system *system, double omega) {
    return system->swell_s > 0.0 ? system->swell_s * portable_tanh(system->peak_omega / omega) : 0.0;
}

static double cos2s_exponent(const spectrum_system *system, double omega) {
    double s = system->s;
    const double r = omega / system->peak_omega;
    if (system->spreading == BOLAN_SPREADING_HASSELMANN)
        s = r <= 1.0 ? 6.97 * portable_pow(r, 4.06) : 9.77 * portable_pow(r, system->s_tail_power);
    if (system->spreading == BOLAN_SPREADING_MITSUYASU) s *= portable_pow(r, r <= 1.0 ? 5.0 : system->s_tail_power);
    return s + swell_exponent(system, omega);
}

// cos^{2s}(th/2) by cos^2(th/2) = (1 + cos th) / 2.
static double half_angle_power(double cosine, double s) {
    const double base = 0.5 * (1.0 + cosine);
    return base > 1e-300 ? portable_exp(s * portable_log(base)) : (s > 0.0 ? 0.0 : 1.0);
}

static double cos2_spreading(double cosine, double swell_s) {
    if (cosine <= 0.0) return 0.0;
    if (!(swell_s > 0.0)) return 2.0 / BOLAN_PI * cosine * cosine;
    return cosine * cosine * half_angle_power(cosine, swell_s) *
           portable_exp(-bolan_spectrum_cos2_swell_log_norm(swell_s));
}

// ---- spreadings that are no power of cos ----------------------------------------------------------------------------

// b of sech^2(b th).
static double sech_width(double r) {
    if (r < 0.56) return 1.24;
    if (r < 0.95) return 2.61 * portable_pow(r, 1.3);
    if (r < 1.6) return 2.28 * portable_pow(r, -1.3);
    return portable_exp(PORTABLE_LN10 * (-0.4 + 0.8393 * portable_pow(r, -1.134))); // exp(-0.567 ln r^2)
}

// The shape at one frequency before Horvath's factor; it integrates to 1 by itself.
typedef struct spread_shape {
    bool sech;
    double b, level; // sech: level sech^2(b th)
    double delta;    // else (1 + delta cos 2 th) / pi on the half circle
    double reach;    // [rad] 0 beyond
} spread_shape;

static spread_shape shape_at(const spectrum_system *system, double omega) {
    if (system->spreading == BOLAN_SPREADING_ELFOUHAILY)
        return (spread_shape){.delta = bolan_spectrum_elfouhaily_delta(&system->elfouhaily, omega),
                              .reach = 0.5 * BOLAN_PI};
    const double b = sech_width(omega / system->peak_omega);
    return (spread_shape){.sech = true, .b = b, .level = 0.5 * b / portable_tanh(b * BOLAN_PI), .reach = BOLAN_PI};
}

static double shape_value(const spread_shape *shape, double cosine, double theta) {
    if (!shape->sech) return cosine > 0.0 ? (1.0 + shape->delta * (2.0 * cosine * cosine - 1.0)) / BOLAN_PI : 0.0;
    const double e = portable_exp(-2.0 * shape->b * theta), sum = 1.0 + e; // sech^2 x = 4 e^-2x / (1 + e^-2x)^2
    return shape->level * 4.0 * e / (sum * sum);
}

// The integrals over the circle of shape times cos^{2s}(th/2), and of that times cos th: Gauss-Legendre over half of
// the reach. Error < 4e-5, where s is near 0 and the power has its notch at 180 degrees.
static void integrate(const spread_shape *shape, double s, double *whole, double *cosine_part) {
    static const double rule[10][2] = {
        {0.99312859918509488, 0.017614007139152264}, {0.96397192727791381, 0.04060142980038705},
        {0.91223442825132595, 0.06267204833410904},  {0.83911697182221889, 0.083276741576704741},
        {0.7463319064601508, 0.10193011981724048},   {0.63605368072651502, 0.11819453196151831},
        {0.51086700195082713, 0.1316886384491765},   {0.37370608871541955, 0.1420961093183819},
        {0.2277858511416451, 0.14917298647260382},   {0.076526521133497338, 0.15275338713072598}};
    *whole = *cosine_part = 0.0;
    for (int i = 0; i < 20; i++) {
        const double *node = rule[i / 2];
        const double theta = 0.5 * shape->reach * (i % 2 ? 1.0 + node[0] : 1.0 - node[0]);
        double sine, cosine;
        bolan_sincos(theta, &sine, &cosine);
        const double factor = s > 0.0 ? half_angle_power(cosine, s) : 1.0;
        const double part = shape->reach * node[1] * factor * shape_value(shape, cosine, theta); // both halves
        *whole += part;
        *cosine_part += part * cosine;
    }
}

static double shape_spreading(const spectrum_system *system, double omega, double cosine) {
    const spread_shape shape = shape_at(system, omega);
    const double s = swell_exponent(system, omega);
    const double theta = portable_angle(sqrt(fmax(1.0 - cosine * cosine, 0.0)), cosine);
    const double value = shape_value(&shape, cosine, theta);
    if (!(s > 0.0) || !(value > 0.0)) return value;
    double whole, cosine_part;
    integrate(&shape, s, &whole, &cosine_part);
    return value * half_angle_power(cosine, s) / whole;
}

// ---- all ------------------------------------------------------------------------------------------------------------

static bool is_shape(const spectrum_system *system) {
    return system->spreading == BOLAN_SPREADING_DONELAN_BANNER || system->spreading == BOLAN_SPREADING_ELFOUHAILY;
}

double bolan_spectrum_system_spreading(const spectrum_system *system, double omega, double cosine) {
    if (system->spreading == BOLAN_SPREADING_COS2) return cos2_spreading(cosine, swell_exponent(system, omega));
    if (is_shape(system)) return shape_spreading(system, omega, cosine);
    const double s = cos2s_exponent(system, omega);
    return bolan_spectrum_cos2s_norm(s) * half_angle_power(cosine, s);
}

double bolan_spectrum_system_mean_cosine(const spectrum_system *system, double omega) {
    const double swell_s = swell_exponent(system, omega);
    if (is_shape(system)) {
        double whole, cosine_part;
        const spread_shape shape = shape_at(system, omega);
        integrate(&shape, swell_s, &whole, &cosine_part);
        return cosine_part / whole;
    }
    if (system->spreading != BOLAN_SPREADING_COS2) {
        const double s = cos2s_exponent(system, omega);
        return s / (s + 1.0);
    }
    if (!(swell_s > 0.0)) return 8.0 / (3.0 * BOLAN_PI);
    enum { STEPS = 64 }; // the midpoint rule: the integrand and its slope vanish at both ends
    double sum = 0.0;
    for (int i = 0; i < STEPS; i++) {
        double sine, cosine;
        bolan_sincos(((i + 0.5) / STEPS - 0.5) * BOLAN_PI, &sine, &cosine);
        sum += cosine * cos2_spreading(cosine, swell_s);
    }
    return sum * BOLAN_PI / STEPS;
}
