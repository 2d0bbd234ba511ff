// SPDX-License-Identifier: MIT
// See tiles_index.h.
#include "io/tiles_index.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { VERSION, N, FRAMES, LENGTH, ANGLE, PERIOD, DEPTH, PAPER, HEIGHT_STEP, CAUSTICS, KEYS };

typedef struct key {
    const char *name;
    double low, high; // as for bolan_tiles_create()
    bool whole;
    const char *expected;
} key;

static const key keys[KEYS] = {
    [VERSION] = {"bolan_tiles", 1, 1, true, "1, the version of this format"},
    [N] = {"n", 8, 1024, true, "a power of two 8..1024"},
    [FRAMES] = {"frames", 1, BOLAN_MAX_LOOP_FRAMES, true, "1..64"},
    [LENGTH] = {"length", 0.01, 1e6, false, "0.01 to 1e6 m"},
    [ANGLE] = {"angle", -1e6, 1e6, false, "radians"},
    [PERIOD] = {"period", 0.01, 1e6, false, "0.01 to 1e6 s"},
    [DEPTH] = {"depth", 0.05, 200.0, false, "0.05 to 200 m"},
    [PAPER] = {"paper", 0, 1, true, "0 or 1"},
    // Waves of a nanometre to waves of 30 km.
    [HEIGHT_STEP] = {"height_step", 1e-14, 1.0, false, "1e-14 to 1 m"},
    [CAUSTICS] = {"caustics_range", BOLAN_CAUSTICS_RANGE, BOLAN_CAUSTICS_RANGE, false, "the range of this format"},
};

size_t bolan_tiles_index_print(const bolan_tiles_view *v, double step, char out[TILES_INDEX_CAPACITY]) {
    const double values[KEYS] = {
        [VERSION] = 1,        [N] = v->n,
        [FRAMES] = v->frames, [LENGTH] = v->length,
        [ANGLE] = v->angle,   [PERIOD] = v->period,
        [DEPTH] = v->depth,   [PAPER] = v->paper ? 1 : 0,
        [HEIGHT_STEP] = step, [CAUSTICS] = BOLAN_CAUSTICS_RANGE,
    };
    size_t size = 0;
    for (int i = 0; i < KEYS; i++)
        size += (size_t)bolan_format(out + size, TILES_INDEX_CAPACITY - size, "%s  \"%s\": %.17g", i ? ",\n" : "{\n",
                                     keys[i].name, values[i]);
    size += (size_t)bolan_format(out + size, TILES_INDEX_CAPACITY - size, "\n}\n");
    return size;
}

// ---- reading --------------------------------------------------------------------------------------------------------

typedef struct reader {
    const char *path, *next, *end;
    unsigned line;
} reader;

static bolan_result refuse(const char *path, unsigned line, const char *what) {
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_IMAGE_FORMAT, "%s:%u: %s", path, line, what);
    return BOLAN_ERROR_FORMAT;
}

static void skip_space(reader *r) {
    while (r->next < r->end && memchr(" \t\r\n", *r->next, 4)) r->line += *r->next++ == '\n';
}

// Skips blanks and the character `c`; false where another character stands there.
static bool take(reader *r, char c) {
    skip_space(r);
    if (r->next == r->end || *r->next != c) return false;
    r->next++;
    return true;
}

// "name": the number of the key; -1 for an unknown key, KEYS where there is no string.
static int take_key(reader *r) {
    if (!take(r, '"')) return KEYS;
    const char *begin = r->next;
    while (r->next < r->end && *r->next != '"' && *r->next != '\n') r->next++;
    const size_t length = (size_t)(r->next - begin);
    if (!take(r, '"')) return KEYS;
    for (int i = 0; i < KEYS; i++)
        if (strlen(keys[i].name) == length && memcmp(keys[i].name, begin, length) == 0) return i;
    return -1;
}

// JSON's numbers (RFC 8259, 6): no plus sign in front, a digit on both sides of the point, no zero before other digits.
static bool take_number(reader *r, double *value) {
    skip_space(r);
    const char *begin = r->next, *digits = begin;
    while (r->next < r->end && memchr("+-.0123456789eE", *r->next, 15)) r->next++;
    const size_t length = (size_t)(r->next - begin);
    if (!bolan_parse_number(begin, length, value) || *begin == '+') return false;
    digits += *begin == '-';
    const char *point = memchr(begin, '.', length);
    const bool leading = digits[0] == '0' && digits + 1 < r->next && digits[1] >= '0' && digits[1] <= '9';
    const bool bare = point && (point == digits || point + 1 == r->next || point[1] < '0' || point[1] > '9');
    return !leading && !bare;
}

static bolan_result read_object(reader *r, double values[KEYS], bool seen[KEYS]) {
    static const char no_json[] = "not JSON; expected one object of \"key\": number, as a folder of tiles has it";
    if (!take(r, '{')) return refuse(r->path, r->line, no_json);
    do {
        char sentence[96];
        const int k = take_key(r);
        if (k == KEYS) return refuse(r->path, r->line, no_json);
        if (k < 0) return refuse(r->path, r->line, "a key that the index of a folder of tiles does not have");
        snprintf(sentence, sizeof sentence, "\"%s\" is given twice; expected once", keys[k].name);
        if (seen[k]) return refuse(r->path, r->line, sentence);
        seen[k] = true;
        snprintf(sentence, sizeof sentence, "\"%s\" is no number; expected a number of JSON", keys[k].name);
        if (!take(r, ':') || !take_number(r, &values[k])) return refuse(r->path, r->line, sentence);
    } while (take(r, ','));
    if (!take(r, '}')) return refuse(r->path, r->line, no_json);
    skip_space(r);
    return r->next == r->end ? BOLAN_OK : refuse(r->path, r->line, "text behind the object; expected the end");
}

static bolan_result check(const reader *r, const double values[KEYS], const bool seen[KEYS]) {
    char sentence[128];
    for (int i = 0; i < KEYS; i++) {
        const key *k = &keys[i];
        snprintf(sentence, sizeof sentence, "no number \"%s\"; expected the index of a folder of tiles", k->name);
        if (!seen[i]) return refuse(r->path, r->line, sentence);
        const bool whole = !k->whole || values[i] == floor(values[i]);
        bolan_format(sentence, sizeof sentence, "\"%s\" is %g; expected %s", k->name, values[i], k->expected);
        if (!whole || values[i] < k->low || values[i] > k->high) return refuse(r->path, r->line, sentence);
    }
    const uint32_t n = (uint32_t)values[N];
    snprintf(sentence, sizeof sentence, "\"n\" is %u; expected %s", (unsigned)n, keys[N].expected);
    return (n & (n - 1)) == 0 ? BOLAN_OK : refuse(r->path, r->line, sentence);
}

bolan_result bolan_tiles_index_parse(const char *path, const char *text, size_t size, bolan_tiles_view *v,
                                     double *step) {
    reader r = {path, text, text + size, 1};
    double values[KEYS] = {0};
    bool seen[KEYS] = {false};
    if (read_object(&r, values, seen) || check(&r, values, seen)) return BOLAN_ERROR_FORMAT;
    *v = (bolan_tiles_view){.n = (uint32_t)values[N],
                            .frames = (uint32_t)values[FRAMES],
                            .length = values[LENGTH],
                            .angle = values[ANGLE],
                            .period = values[PERIOD],
                            .depth = values[DEPTH],
                            .paper = values[PAPER] != 0.0};
    *step = values[HEIGHT_STEP];
    return BOLAN_OK;
}
