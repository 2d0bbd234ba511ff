// SPDX-License-Identifier: MIT
// The parameters of sea states.
#include "params/rows.h"
#include "spectrum/measured.h"

#define STRUCT bolan_sea_state
static const bolan_param sea_state_rows[] = {
    NUMBER(wind_speed, .key = "wind.speed", .option = "wind", .low = 0, .high = 70, .unit = "m/s", .label = "wind",
           .usual_high = 40, .digits = 1,
           .help = "wind speed 10 m up: makes the wind sea, the short waves and the foam; swells stay"),
    HEADING(wind_from_deg, .key = "wind.from", .option = "wind-from", .label = "wind from", .usual_high = 360,
            .help = "where the wind comes from, compass degrees"),
    NUMBER(depth, .key = "depth", .option = "depth", .low = 0.1, .high = BOLAN_DEEP, .unit = "m",
           .fallback = BOLAN_DEEP, .help = "water depth for the waves: their dispersion, and the spectrum `tma`"),
    NUMBER(current_x, .key = "current.east", .low = -5, .high = 5, .unit = "m/s",
           .help = "uniform current to the east, on which the waves ride"),
    NUMBER(current_y, .key = "current.north", .low = -5, .high = 5, .unit = "m/s",
           .help = "uniform current to the north"),
    NAME(frame, .key = "current.spectrum", .names = bolan_spectrum_frame_names, .high = BOLAN_SPECTRUM_FRAMES - 1,
         .help =
             "observer of the spectrum: in the moving `water`, on the `ground` in the current, or in `still` "
             "water from which the waves run into the current; see [sea states](sea-states.md#current)"),
};
#undef STRUCT
const bolan_param_table bolan_sea_state_params = TABLE("bolan_sea_state", sea_state_rows);

#define STRUCT bolan_wave_system
static const bolan_param wave_system_rows[] = {
    NAME(kind, .key = "shape", .names = bolan_spectrum_kind_names, .high = BOLAN_SPECTRUM_KINDS - 1,
         .fallback = BOLAN_SPECTRUM_JONSWAP, .help = "shape in frequency; see [sea states](sea-states.md)"),
    NUMBER(hs, .key = "hs", .low = 0, .high = SPECTRUM_MAX_HS, .unit = "m", .rules = BOLAN_PARAM_REQUIRED,
           .help = "significant wave height"),
    NUMBER(peak_omega, .low = SPECTRUM_PEAK_OMEGA_MIN, .high = SPECTRUM_PEAK_OMEGA_MAX, .fallback = 1, .unit = "rad/s",
           .help = "angular frequency of the peak"),
    NUMBER(gamma, .key = "gamma", .low = 1, .high = 10, .fallback = 3.3,
           .help = "peak enhancement of `jonswap`, `tma` and `torsethaugen`; larger: a narrower peak"),
    NUMBER(lambda, .key = "lambda", .low = 0.1, .high = 10, .rules = BOLAN_PARAM_OR_ZERO, .otherwise = "1",
           .help = "shape of `ochi-hubble`; larger: a narrower peak and a steeper tail"),
    HEADING(from_deg, .key = "from", .otherwise = "the wind's", .help = "where the waves come from, compass degrees"),
    NAME(spreading, .key = "spreading", .names = bolan_spreading_kind_names, .high = BOLAN_SPREADING_KINDS - 1,
         .fallback = BOLAN_SPREADING_HASSELMANN, .help = "shape in direction"),
    NUMBER(spread_s, .key = "spread", .low = 0, .high = 200, .fallback = 10,
           .help = "exponent of `cos2s`; larger: longer crests"),
    NUMBER(wind_speed, .key = "wind", .low = 0, .high = 70, .unit = "m/s",
           .otherwise = "as fast as the waves at the peak",
           .help = "the wind that raised a wind sea, for the shapes and spreadings that depend on it"),
    NUMBER(swell, .key = "swell", .low = 0, .high = 1, .help = "Horvath's swell parameter; larger: longer crests"),
};
#undef STRUCT
const bolan_param_table bolan_wave_system_params = TABLE("bolan_wave_system", wave_system_rows);
