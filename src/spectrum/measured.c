// SPDX-License-Identifier: MIT
// Measured spectra: recognising the format, and bringing what a parser found to one regular grid.
//
//     parser ──► spectrum_grid ──► sort directions ──► constant step ──► [m2 s/rad per rad] ──► + tail
//                (hertz, any order)                 (energy conserved)
#include "spectrum/measured.h"

#include "bolan/math.h"
#include "spectrum/text.h"

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

bool spectrum_grid_allocate(spectrum_grid *grid) {
    const size_t bytes = grid_bytes(grid);
    grid->hertz = bolan_allocate(bytes);
    if (!grid->hertz) return out_of_memory(bytes);
    grid->to = grid->hertz + grid->frequency_count;
    grid->energy = grid->to + grid->direction_count;
    return true;
}

void spectrum_grid_release(spectrum_grid *grid) {
    if (grid->hertz) bolan_release(grid->hertz, grid_bytes(grid));
    grid->hertz = NULL;
}

// ---- directions -----------------------------------------------------------------------------------------------------

typedef struct direction {
    double to;        // [0, 2 pi)
    double low, high; // the sector that this bin stands for
    uint32_t column;  // in the file
} direction;

static int by_angle(const void *a, const void *b) {
    const double x = ((const direction *)a)->to, y = ((const direction *)b)->to;
    return (x > y) - (x < y);
}

static double gap_after(const direction *directions, uint32_t count, uint32_t i) {
    return i + 1 < count ? directions[i + 1].to - directions[i].to
                         : directions[0].to + 2.0 * BOLAN_PI - directions[i].to;
}

// Sorts; gives each bin half of the gap to its neighbours, but no more than half the smallest gap times two, so that a
// file that covers only a sector does not leak into the rest of the circle. Returns the smallest gap.
static double sort_directions(const spectrum_grid *grid, direction *directions) {
    const uint32_t count = grid->direction_count;
    for (uint32_t j = 0; j < count; j++) {
        const double turns = grid->to[j] / (2.0 * BOLAN_PI);
        const double to = (turns - floor(turns)) * 2.0 * BOLAN_PI;
        directions[j] = (direction){.to = to < 2.0 * BOLAN_PI ? to : 0.0, .column = j};
    }
    qsort(directions, count, sizeof *directions, by_angle);
    double smallest = HUGE_VAL;
    for (uint32_t j = 0; j < count; j++) smallest = fmin(smallest, gap_after(directions, count, j));
    for (uint32_t j = 0; j < count; j++) {
        const uint32_t next = (j + 1) % count;
        const double half = 0.5 * fmin(gap_after(directions, count, j), 2.0 * smallest);
        directions[j].high = directions[j].to + half;
        directions[next].low = directions[next].to - half;
    }
    return smallest;
}

static bool is_regular(const direction *directions, uint32_t count) {
    const double step = 2.0 * BOLAN_PI / count;
    for (uint32_t j = 0; j < count; j++) // files round their directions: accept a fiftieth of a step
        if (fabs(directions[j].to - directions[0].to - j * step) > 0.02 * step) return false;
    return true;
}

// Adds one file bin to the regular bins it overlaps, in proportion: the sum over the circle is kept.
static void spread_bin(const direction *bin, const double *column, uint32_t stride, bolan_measured_spectrum *m) {
    const double step = m->direction_step, origin = m->theta[0] - 0.5 * step;
    const int first = (int)floor((bin->low - origin) / step), last = (int)floor((bin->high - origin) / step);
    for (int t = first; t <= last; t++) {
        const double low = fmax(bin->low, origin + t * step), high = fmin(bin->high, origin + (t + 1) * step);
        if (!(high > low)) continue;
        const int count = (int)m->direction_count, target = ((t % count) + count) % count;
        for (uint32_t i = 0; i < m->frequency_count; i++)
            m->density[i * m->direction_count + (uint32_t)target] += column[(size_t)i * stride] * (high - low) / step;
    }
}

static void fill_directions(const spectrum_grid *grid, const direction *directions, bolan_measured_spectrum *m) {
    const bool regular = m->direction_count == grid->direction_count && is_regular(directions, m->direction_count);
    for (uint32_t j = 0; j < m->direction_count; j++) m->theta[j] = directions[0].to + j * m->direction_step;
    for (uint32_t j = 0; j < grid->direction_count; j++) {
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
    return m;
}

static bolan_result check_energy(const char *name, const spectrum_grid *grid) {
    double largest = 0.0;
    for (size_t i = 0; i < grid_cells(grid->frequency_count, grid->direction_count); i++)
        largest = fmax(largest, grid->energy[i]);
    if (largest > 0.0) return BOLAN_OK;
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SPECTRUM_NO_ENERGY,
              "%s: the record%s%s has no energy at any frequency; expected at least one density above 0", name,
              grid->time[0] ? " of " : "", grid->time);
    return BOLAN_ERROR_FORMAT;
}

bolan_result spectrum_measured_build(const char *name, const spectrum_grid *grid, bolan_measured_spectrum **out) {
    if (check_energy(name, grid)) return BOLAN_ERROR_FORMAT;
    direction directions[SPECTRUM_MAX_DIRECTIONS];
    const double smallest = sort_directions(grid, directions);
    if (!(smallest > 1e-4)) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SPECTRUM_SYNTAX,
                  "%s: two directions are the same; expected distinct directions", name);
        return BOLAN_ERROR_FORMAT;
    }
    const double ideal = fmin(round(2.0 * BOLAN_PI / smallest), SPECTRUM_MAX_DIRECTIONS);
    const uint32_t count = is_regular(directions, grid->direction_count) ? grid->direction_count : (uint32_t)ideal;
    bolan_measured_spectrum *m = allocate_measured(grid, count);
    if (!m) return BOLAN_ERROR_MEMORY;
    fill_directions(grid, directions, m);
    for (uint32_t i = 0; i < m->frequency_count; i++) m->omega[i] = 2.0 * BOLAN_PI * grid->hertz[i];
    for (size_t i = 0; i < grid_cells(m->frequency_count, m->direction_count); i++)
        m->density[i] /= 2.0 * BOLAN_PI; // S(w) dw = S(f) df
    add_tail(m);
    *out = m;
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

double spectrum_measured_density(const bolan_measured_spectrum *m, double omega, double theta, bool with_tail) {
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

bolan_spectrum_texts bolan_spectrum_texts_default(void) {
    const bolan_spectrum_texts texts = {.from_deg = 270.0, .spread_s = 10.0};
    return texts;
}

// NDBC tables begin with a header such as "YYYY MM DD hh", "YY MM DD hh" or "#YY  MM DD hh mm".
static bool is_ndbc(text_word first) {
    return text_equals(first, "YY") || text_equals(first, "YYYY") || text_equals(first, "#YY") ||
           text_equals(first, "#YYYY");
}

static bolan_result parse_any(const bolan_spectrum_texts *texts, uint32_t record, spectrum_grid *grid) {
    text_cursor cursor = text_open(&texts->density);
    text_word first;
    if (!text_next_word(&cursor, &first)) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SPECTRUM_EMPTY, "%s: the text is empty; expected a SWAN or NDBC spectrum",
                  cursor.name);
        return BOLAN_ERROR_FORMAT;
    }
    if (text_equals(first, "SWAN")) return spectrum_parse_swan(texts, record, grid);
    if (is_ndbc(first)) return spectrum_parse_ndbc(texts, record, grid);
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_SPECTRUM_UNKNOWN_FORMAT,
              "%s:%u: the format is not known; expected \"SWAN\" (SWAN) or \"YYYY MM DD hh\" (NDBC) at the start",
              cursor.name, (unsigned)first.line);
    return BOLAN_ERROR_FORMAT;
}

bolan_result bolan_measured_spectrum_parse(const bolan_spectrum_texts *texts, uint32_t record,
                                           bolan_measured_spectrum **out) {
    BOLAN_ASSERT(texts && out);
    *out = NULL;
    const bool direction_ok = texts->from_deg >= -360.0 && texts->from_deg <= 360.0;
    if (!direction_ok || !(texts->spread_s >= 0.0 && texts->spread_s <= 200.0)) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_RANGE, "bolan_spectrum_texts: %s is %g; expected %s",
                  direction_ok ? "spread_s" : "from_deg", direction_ok ? texts->spread_s : texts->from_deg,
                  direction_ok ? "0 to 200" : "-360 to 360 degrees");
        return BOLAN_ERROR_ARGUMENT;
    }
    spectrum_grid grid = {0};
    bolan_result result = parse_any(texts, record, &grid);
    if (!result) result = spectrum_measured_build(texts->density.name ? texts->density.name : "spectrum", &grid, out);
    spectrum_grid_release(&grid);
    return result;
}

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
    };
    return view;
}
