// SPDX-License-Identifier: MIT
// Measured spectra: bringing what a reader found (src/formats) to one regular grid.
//
//     reader ──► spectrum_grid ──► sort directions ──► constant step ──► [m2 s/rad per rad] ──► + tail
//                (hertz, any order)                    (energy conserved)
#include "spectrum/measured.h"

#include "bolan/math.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static size_t grid_cells(uint32_t frequencies, uint32_t directions) { return (size_t)frequencies * directions; }

static size_t grid_bytes(const spectrum_grid *grid) {
    return sizeof(double) *
           (grid->frequency_count + grid->direction_count + grid_cells(grid->frequency_count, grid->direction_count));
}

static bool out_of_memory(size_t bytes) {
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY,
              "a measured spectrum needs %zu bytes, which could not be allocated", bytes);
    return false;
}

bool bolan_spectrum_grid_allocate(spectrum_grid *grid) {
    const size_t bytes = grid_bytes(grid);
    grid->hertz = bolan_allocate(bytes);
    if (!grid->hertz) return out_of_memory(bytes);
    grid->to = grid->hertz + grid->frequency_count;
    grid->energy = grid->to + grid->direction_count;
    return true;
}

bolan_result bolan_spectrum_grid_begin(spectrum_grid *grid, const double *hertz, uint32_t frequencies, const double *to,
                                       uint32_t directions) {
    grid->frequency_count = frequencies;
    grid->direction_count = directions;
    grid->own_directions = true;
    if (!bolan_spectrum_grid_allocate(grid)) return BOLAN_ERROR_MEMORY;
    memcpy(grid->hertz, hertz, frequencies * sizeof(double));
    memcpy(grid->to, to, directions * sizeof(double));
    return BOLAN_OK;
}

void bolan_spectrum_grid_release(spectrum_grid *grid) {
    if (grid->hertz) bolan_release(grid->hertz, grid_bytes(grid));
    grid->hertz = NULL;
}

// ---- directions -----------------------------------------------------------------------------------------------------

// Closer than this [rad] two directions of a file are the same: 0 and 360, or one that was rounded.
#define SAME_DIRECTION 1e-4

typedef struct direction {
    double to;        // [0, 2 pi)
    double low, high; // where its triangle begins and ends
    uint32_t column;  // in the file
} direction;

static int by_angle(const void *a, const void *b) {
    const double x = ((const direction *)a)->to, y = ((const direction *)b)->to;
    return (x > y) - (x < y);
}

static int by_size(const void *a, const void *b) {
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double gap_after(const direction *directions, uint32_t count, uint32_t i) {
    return i + 1 < count ? directions[i + 1].to - directions[i].to
                         : directions[0].to + 2.0 * BOLAN_PI - directions[i].to;
}

static bool same_columns(const spectrum_grid *grid, uint32_t a, uint32_t b) {
    for (uint32_t i = 0; i < grid->frequency_count; i++) {
        const double *row = grid->energy + (size_t)i * grid->direction_count;
        if (row[a] != row[b]) return false;
    }
    return true;
}

// Sorts, and drops directions that come twice with the same densities. Returns how many are left, 0 where two columns
// contradict each other.
static uint32_t sort_directions(const spectrum_grid *grid, direction *directions) {
    uint32_t count = grid->direction_count;
    for (uint32_t j = 0; j < count; j++) {
        const double turns = grid->to[j] / (2.0 * BOLAN_PI);
        const double to = (turns - floor(turns)) * 2.0 * BOLAN_PI;
        directions[j] = (direction){.to = to < 2.0 * BOLAN_PI ? to : 0.0, .column = j};
    }
    qsort(directions, count, sizeof *directions, by_angle);
    for (uint32_t j = 0; j < count && count > 1;) {
        const uint32_t next = (j + 1) % count;
        if (gap_after(directions, count, j) > SAME_DIRECTION) {
            j++;
            continue;
        }
        if (!same_columns(grid, directions[j].column, directions[next].column)) return 0;
        const uint32_t dropped = next > j ? next : j;
        memmove(directions + dropped, directions + dropped + 1, (count - dropped - 1) * sizeof *directions);
        count--;
    }
    return count;
}

// The gaps between neighbouring directions.
typedef struct direction_gaps {
    double smallest, median, largest, second; // [rad]; second: the largest but one
    uint32_t before_largest;                  // the direction that the largest gap follows
} direction_gaps;

static direction_gaps measure_gaps(const direction *directions, uint32_t count) {
    double sizes[SPECTRUM_MAX_DIRECTIONS];
    direction_gaps gaps = {.before_largest = 0};
    for (uint32_t j = 0; j < count; j++) {
        sizes[j] = gap_after(directions, count, j);
        if (sizes[j] > sizes[gaps.before_largest]) gaps.before_largest = j;
    }
    qsort(sizes, count, sizeof *sizes, by_size);
    gaps.smallest = sizes[0];
    gaps.median = sizes[(count - 1) / 2];
    gaps.largest = sizes[count - 1];
    gaps.second = sizes[count - 2];
    return gaps;
}

// A grid over a sector of the circle has one step and one gap: outside it there are no waves. Steps are rounded.
static bool is_sector(const direction_gaps *gaps) {
    return gaps->second < 1.02 * gaps->smallest && gaps->largest > 1.5 * gaps->second;
}

// Between two directions the density is linear, so that each bin is a triangle up to both neighbours: integrated over
// the circle, the trapezoid rule. At the rims of a sector it falls to 0 within a step.
static void set_widths(direction *directions, uint32_t count, const direction_gaps *gaps) {
    const double widest = is_sector(gaps) ? gaps->second : 2.0 * BOLAN_PI;
    for (uint32_t j = 0; j < count; j++) {
        const uint32_t next = (j + 1) % count;
        const double gap = fmin(gap_after(directions, count, j), widest);
        directions[j].high = directions[j].to + gap;
        directions[next].low = directions[next].to - gap;
    }
}

static void say_gap(const char *name, const direction *directions, uint32_t count, const direction_gaps *gaps,
                    spectrum_notes *notes) {
    if (is_sector(gaps) || gaps->largest <= 2.0 * gaps->median) return;
    const direction *before = &directions[gaps->before_largest];
    const direction *after = &directions[(gaps->before_largest + 1) % count];
    bolan_spectrum_note(
        notes, BOLAN_LOG_SPECTRUM_GAP,
        "%s: the directions have a gap of %.0f degrees, between waves from %.0f and from %.0f; across it the "
        "density is taken as linear",
        name, bolan_degrees(gaps->largest), bolan_math_to_compass_from(after->to),
        bolan_math_to_compass_from(before->to));
}

static bool is_regular(const direction *directions, uint32_t count) {
    const double step = 2.0 * BOLAN_PI / count;
    for (uint32_t j = 0; j < count; j++) // files round their directions: accept a fiftieth of a step
        if (fabs(directions[j].to - directions[0].to - j * step) > 0.02 * step) return false;
    return true;
}

// Directions of the regular grid for an irregular list: a step that divides the smallest gap, of 5 degrees or less.
static uint32_t regular_count(double smallest) {
    const double ideal = fmin(round(2.0 * BOLAN_PI / smallest), SPECTRUM_MAX_DIRECTIONS);
    return (uint32_t)fmin(ideal * ceil(72.0 / ideal), SPECTRUM_MAX_DIRECTIONS);
}

// The integral of a bin's triangle, of height 1, up to the angle x.
static double triangle_up_to(const direction *bin, double x) {
    const double rise = bin->to - bin->low, fall = bin->high - bin->to;
    if (x <= bin->low) return 0.0;
    if (x <= bin->to) return 0.5 * (x - bin->low) * (x - bin->low) / rise;
    const double left = fmax(bin->high - x, 0.0);
    return 0.5 * (rise + fall - left * left / fall);
}

// Adds one file bin to the regular bins it overlaps: the sum over the circle is kept.
static void spread_bin(const direction *bin, const double *column, uint32_t stride, bolan_measured_spectrum *m) {
    const double step = m->direction_step, origin = m->theta[0] - 0.5 * step;
    const int first = (int)floor((bin->low - origin) / step), last = (int)floor((bin->high - origin) / step);
    for (int t = first; t <= last; t++) {
        const double share =
            (triangle_up_to(bin, origin + (t + 1) * step) - triangle_up_to(bin, origin + t * step)) / step;
        const int count = (int)m->direction_count, target = ((t % count) + count) % count;
        for (uint32_t i = 0; i < m->frequency_count; i++)
            m->density[i * m->direction_count + (uint32_t)target] += column[(size_t)i * stride] * share;
    }
}

static void fill_directions(const spectrum_grid *grid, const direction *directions, uint32_t count,
                            bolan_measured_spectrum *m) {
    const bool regular = m->direction_count == count && is_regular(directions, count);
    for (uint32_t j = 0; j < m->direction_count; j++) m->theta[j] = directions[0].to + j * m->direction_step;
    for (uint32_t j = 0; j < count; j++) {
        const double *column = grid->energy + directions[j].column;
        if (!regular) spread_bin(&directions[j], column, grid->direction_count, m);
        for (uint32_t i = 0; regular && i < m->frequency_count; i++)
            m->density[i * m->direction_count + j] = column[(size_t)i * grid->direction_count];
    }
}

// ---- building -------------------------------------------------------------------------------------------------------

static double row_sum(const bolan_measured_spectrum *m, uint32_t row) {
    double sum = 0.0;
    for (uint32_t j = 0; j < m->direction_count; j++) sum += m->density[row * m->direction_count + j];
    return sum;
}

// The tail S(w, th) = T(th) w^-5 above the last frequency. Its level is that of the last band with energy; its
// directions are the mean of the last three such bands, because a single one is often a few rounded counts.
static void add_tail(bolan_measured_spectrum *m) {
    double level = 0.0, total = 0.0;
    for (uint32_t row = m->frequency_count, used = 0; row-- > 0 && used < 3;) {
        const double sum = row_sum(m, row);
        if (!(sum > 0.0)) continue;
        const double w = m->omega[row], scale = w * w * w * w * w;
        if (used++ == 0) level = sum * scale;
        total += sum * scale;
        for (uint32_t j = 0; j < m->direction_count; j++)
            m->tail[j] += m->density[row * m->direction_count + j] * scale;
    }
    for (uint32_t j = 0; j < m->direction_count && total > 0.0; j++) m->tail[j] *= level / total;
}

static bolan_measured_spectrum *allocate_measured(const spectrum_grid *grid, uint32_t directions) {
    const uint32_t frequencies = grid->frequency_count;
    const size_t header = (sizeof(bolan_measured_spectrum) + 63) / 64 * 64;
    const size_t doubles = frequencies + 2 * (size_t)directions + grid_cells(frequencies, directions);
    const size_t bytes = header + doubles * sizeof(double);
    bolan_measured_spectrum *m = bolan_allocate(bytes);
    if (!m) {
        out_of_memory(bytes);
        return NULL;
    }
    m->bytes = bytes;
    m->frequency_count = frequencies;
    m->direction_count = directions;
    m->record_count = grid->record_count;
    m->direction_step = 2.0 * BOLAN_PI / directions;
    m->omega = (double *)((char *)m + header);
    m->theta = m->omega + frequencies;
    m->tail = m->theta + directions;
    m->density = m->tail + directions;
    memcpy(m->time, grid->time, sizeof m->time);
    m->place = grid->place;
    return m;
}

double bolan_spectrum_trapezoid_weight(const double *x, uint32_t count, uint32_t i) {
    return 0.5 * (x[i + 1 < count ? i + 1 : i] - x[i > 0 ? i - 1 : 0]);
}

static bolan_result check_height(const char *name, const bolan_measured_spectrum *m) {
    double m0 = 0.0;
    for (uint32_t i = 0; i < m->frequency_count; i++)
        m0 += row_sum(m, i) * m->direction_step * bolan_spectrum_trapezoid_weight(m->omega, m->frequency_count, i);
    if (4.0 * sqrt(m0) <= SPECTRUM_MAX_HS) return BOLAN_OK;
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SPECTRUM_IMPOSSIBLE,
              "%s: the record%s%s has a significant wave height of %.4g m; expected at most %g m, which no sea exceeds",
              name, m->time[0] ? " of " : "", m->time, 4.0 * sqrt(m0), SPECTRUM_MAX_HS);
    return BOLAN_ERROR_FORMAT;
}

bolan_result bolan_spectrum_measured_build(const char *name, spectrum_grid *grid, bolan_measured_spectrum **out) {
    direction directions[SPECTRUM_MAX_DIRECTIONS];
    const uint32_t given = sort_directions(grid, directions);
    if (given < SPECTRUM_MIN_DIRECTIONS) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SPECTRUM_SYNTAX, "%s: %s; expected at least %d distinct directions", name,
                  given ? "too few directions are distinct" : "two directions are the same, with other densities",
                  SPECTRUM_MIN_DIRECTIONS);
        return BOLAN_ERROR_FORMAT;
    }
    const direction_gaps gaps = measure_gaps(directions, given);
    set_widths(directions, given, &gaps);
    bolan_measured_spectrum *m =
        allocate_measured(grid, is_regular(directions, given) ? given : regular_count(gaps.smallest));
    if (!m) return BOLAN_ERROR_MEMORY;
    fill_directions(grid, directions, given, m);
    for (uint32_t i = 0; i < m->frequency_count; i++) m->omega[i] = 2.0 * BOLAN_PI * grid->hertz[i];
    for (size_t i = 0; i < grid_cells(m->frequency_count, m->direction_count); i++)
        m->density[i] /= 2.0 * BOLAN_PI; // S(w) dw = S(f) df
    if (check_height(name, m)) {
        bolan_measured_spectrum_destroy(&m);
        return BOLAN_ERROR_FORMAT;
    }
    add_tail(m);
    say_gap(name, directions, given, &gaps, &grid->notes);
    *out = m;
    return BOLAN_OK;
}

// ---- two records ----------------------------------------------------------------------------------------------------

static bool same_values(const double *a, const double *b, uint32_t count) {
    for (uint32_t i = 0; i < count; i++)
        if (fabs(a[i] - b[i]) > 1e-9 * fmax(fabs(a[i]), 1.0)) return false;
    return true;
}

bolan_result bolan_spectrum_measured_blend(const char *name, bolan_measured_spectrum *a,
                                           const bolan_measured_spectrum *b, double share) {
    if (a->frequency_count != b->frequency_count || a->direction_count != b->direction_count ||
        !same_values(a->omega, b->omega, a->frequency_count) || !same_values(a->theta, b->theta, a->direction_count)) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SPECTRUM_SYNTAX,
                  "%s: the records of %s and %s have different frequencies or directions; expected the same, to "
                  "interpolate between them",
                  name, a->time, b->time);
        return BOLAN_ERROR_FORMAT;
    }
    for (size_t i = 0; i < grid_cells(a->frequency_count, a->direction_count); i++)
        a->density[i] = (1.0 - share) * a->density[i] + share * b->density[i];
    memset(a->tail, 0, a->direction_count * sizeof *a->tail);
    add_tail(a);
    return BOLAN_OK;
}

// ---- look-up --------------------------------------------------------------------------------------------------------

// The last row whose frequency is not above omega, which lies inside the file's range.
static uint32_t find_row(const bolan_measured_spectrum *m, double omega) {
    uint32_t low = 0, high = m->frequency_count - 1;
    while (high - low > 1) {
        const uint32_t middle = (low + high) / 2;
        if (m->omega[middle] <= omega)
            low = middle;
        else
            high = middle;
    }
    return low;
}

double bolan_spectrum_measured_density(const bolan_measured_spectrum *m, double omega, double theta, bool with_tail) {
    const uint32_t last = m->frequency_count - 1, n = m->direction_count;
    const bool above = omega > m->omega[last];
    if (omega < m->omega[0] || (above && !with_tail)) return 0.0;
    double t = (theta - m->theta[0]) / m->direction_step;
    if (t < 0.0) t += n;
    const uint32_t whole = (uint32_t)t, j0 = whole < n ? whole : 0, j1 = j0 + 1 < n ? j0 + 1 : 0;
    const double ft = t - whole;
    if (above) return (m->tail[j0] * (1.0 - ft) + m->tail[j1] * ft) / (omega * omega * omega * omega * omega);
    const uint32_t row = find_row(m, omega);
    const double fw = (omega - m->omega[row]) / (m->omega[row + 1] - m->omega[row]);
    const double *a = m->density + (size_t)row * n, *b = a + n;
    return (a[j0] * (1.0 - ft) + a[j1] * ft) * (1.0 - fw) + (b[j0] * (1.0 - ft) + b[j1] * ft) * fw;
}

// ---- public ---------------------------------------------------------------------------------------------------------

void bolan_measured_spectrum_destroy(bolan_measured_spectrum **spectrum) {
    if (!spectrum || !*spectrum) return;
    bolan_release(*spectrum, (*spectrum)->bytes);
    *spectrum = NULL;
}

bolan_measured_view bolan_measured_spectrum_view(const bolan_measured_spectrum *spectrum) {
    BOLAN_ASSERT(spectrum);
    const bolan_measured_view view = {
        .frequency_count = spectrum->frequency_count,
        .direction_count = spectrum->direction_count,
        .record_count = spectrum->record_count,
        .omega = spectrum->omega,
        .theta = spectrum->theta,
        .density = spectrum->density,
        .time = spectrum->time,
        .place = spectrum->place,
    };
    return view;
}
