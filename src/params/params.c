// SPDX-License-Identifier: MIT
// Reads, writes and checks the fields that rows describe.
#include "bolan/params.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define SIXTY_FOUR_BITS 0x1p64

const bolan_param *bolan_param_find(const bolan_param_table *table, const char *field) {
    BOLAN_ASSERT(table && field);
    for (uint32_t i = 0; i < table->count; i++)
        if (strcmp(table->params[i].field, field) == 0) return &table->params[i];
    return NULL;
}

// ---- fields ---------------------------------------------------------------------------------------------------------

static uint64_t read_whole(const bolan_param *p, const void *field) {
    uint32_t small = 0;
    uint64_t large = 0;
    if (p->size == sizeof large) return memcpy(&large, field, sizeof large), large;
    memcpy(&small, field, sizeof small);
    return small;
}

static void write_whole(const bolan_param *p, void *field, uint64_t value) {
    const uint32_t small = (uint32_t)value;
    if (p->size == sizeof value) {
        memcpy(field, &value, sizeof value);
    } else {
        memcpy(field, &small, sizeof small);
    }
}

double bolan_param_get(const bolan_param *p, const void *desc) {
    BOLAN_ASSERT(p && desc);
    const char *field = (const char *)desc + p->offset;
    double number;
    int name;
    switch (p->kind) {
    case BOLAN_PARAM_NUMBER: return memcpy(&number, field, sizeof number), number;
    case BOLAN_PARAM_WHOLE:
    case BOLAN_PARAM_SET: return (double)read_whole(p, field);
    case BOLAN_PARAM_FLAG: return *field != 0;
    case BOLAN_PARAM_NAME: return memcpy(&name, field, sizeof name), (double)name;
    case BOLAN_PARAM_TEXT: {
        const char *end = memchr(field, '\0', p->size);
        return (double)(end ? (size_t)(end - field) : p->size);
    }
    }
    return 0.0;
}

void bolan_param_set(const bolan_param *p, void *desc, double value) {
    BOLAN_ASSERT(p && desc);
    char *field = (char *)desc + p->offset;
    const bool flag = value != 0.0;
    const int name = p->kind == BOLAN_PARAM_NAME ? (int)value : 0;
    switch (p->kind) {
    case BOLAN_PARAM_NUMBER: memcpy(field, &value, sizeof value); break;
    case BOLAN_PARAM_WHOLE:
    case BOLAN_PARAM_SET: write_whole(p, field, value < SIXTY_FOUR_BITS ? (uint64_t)value : UINT64_MAX); break;
    case BOLAN_PARAM_FLAG: memcpy(field, &flag, sizeof flag); break;
    case BOLAN_PARAM_NAME: memcpy(field, &name, sizeof name); break;
    case BOLAN_PARAM_TEXT: break;
    }
}

void bolan_params_default(const bolan_param_table *table, void *desc) {
    BOLAN_ASSERT(table && desc);
    for (uint32_t i = 0; i < table->count; i++) {
        const bolan_param *p = &table->params[i];
        bolan_param_set(p, desc, p->fallback);
        if (p->kind == BOLAN_PARAM_TEXT) memset((char *)desc + p->offset, 0, p->size);
    }
}

// ---- ranges ---------------------------------------------------------------------------------------------------------

static bool is_power_of_two(double value) {
    int exponent;
    return frexp(value, &exponent) == 0.5;
}

bool bolan_param_accepts(const bolan_param *p, double value) {
    BOLAN_ASSERT(p);
    if (p->kind == BOLAN_PARAM_TEXT) return value < (double)p->size;
    if ((p->rules & BOLAN_PARAM_OR_ZERO) && value == 0.0) return true;
    if ((p->rules & BOLAN_PARAM_OR_NAN) && isnan(value)) return true;
    if ((p->rules & BOLAN_PARAM_POWER_OF_TWO) && !is_power_of_two(value)) return false;
    const double measure = p->rules & BOLAN_PARAM_EITHER_SIGN ? fabs(value) : value;
    return measure >= p->low && measure <= p->high; // false for what is not a number
}

static double factor_of(const bolan_param *p) { return p->factor > 0.0 ? p->factor : 1.0; }

// One field counts from @p low to @p high in units of @p unit.
static void describe_range(const bolan_param *p, double factor, const char *unit, char *out, size_t capacity) {
    const bool either = (p->rules & BOLAN_PARAM_EITHER_SIGN) != 0;
    if (isinf(p->low)) {
        snprintf(out, capacity, "any");
        return;
    }
    bolan_format(out, capacity, "%.10g to %.10g%s%s%s", p->low / factor, p->high / factor, unit ? " " : "",
                 unit ? unit : "", either ? ", or its negative" : "");
}

static void join_names(const bolan_param *p, const char *before, char *out, size_t capacity) {
    size_t used = (size_t)snprintf(out, capacity, "%s", before);
    for (uint32_t i = 0; p->names[i] && used < capacity; i++)
        used += (size_t)snprintf(out + used, capacity - used, "%s%s", i ? ", " : "", p->names[i]);
}

void bolan_param_expected(const bolan_param *p, char *out, size_t capacity) {
    BOLAN_ASSERT(p && out && capacity > 0);
    char range[96];
    switch (p->kind) {
    case BOLAN_PARAM_NUMBER:
        describe_range(p, factor_of(p), p->factor > 0.0 ? p->factor_unit : p->unit, range, sizeof range);
        snprintf(out, capacity, isinf(p->low) ? "a number" : "a number from %s", range);
        break;
    case BOLAN_PARAM_WHOLE:
        bolan_format(out, capacity, "a %s from %.0f to %llu",
                     p->rules & BOLAN_PARAM_POWER_OF_TWO ? "power of two" : "whole number", p->low,
                     p->high < SIXTY_FOUR_BITS ? (unsigned long long)p->high : (unsigned long long)UINT64_MAX);
        break;
    case BOLAN_PARAM_FLAG: snprintf(out, capacity, "true or false"); break;
    case BOLAN_PARAM_NAME: join_names(p, "", out, capacity); break;
    case BOLAN_PARAM_SET: join_names(p, "all, none, or some of ", out, capacity); break;
    case BOLAN_PARAM_TEXT: snprintf(out, capacity, "a text of 1 to %u characters", (unsigned)p->size - 1); break;
    }
}

// ---- validation -----------------------------------------------------------------------------------------------------

static bolan_result refuse_text(const bolan_param *p, const char *where) {
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_BAD_ARGUMENT, "%s%s is not ended; expected fewer than %u characters", where,
              p->field, (unsigned)p->size);
    return BOLAN_ERROR_ARGUMENT;
}

static bolan_result refuse(const bolan_param *p, double value, const char *where) {
    char expected[256];
    bolan_log_id id = BOLAN_LOG_BAD_ARGUMENT;
    bolan_param_expected(p, expected, sizeof expected);
    if (p->kind == BOLAN_PARAM_NUMBER) describe_range(p, 1.0, p->unit, expected, sizeof expected);
    if (p->kind == BOLAN_PARAM_NAME || p->kind == BOLAN_PARAM_SET)
        bolan_format(expected, sizeof expected, "%.10g to %.10g", p->low, p->high);
    if (p->kind == BOLAN_PARAM_NUMBER || p->kind == BOLAN_PARAM_WHOLE)
        id = isfinite(value) ? BOLAN_LOG_OUT_OF_RANGE : BOLAN_LOG_NOT_FINITE;
    if (isfinite(value))
        bolan_log(BOLAN_LOG_ERROR, id, "%s%s is %.10g; expected %s", where, p->field, value, expected);
    else
        bolan_log(BOLAN_LOG_ERROR, id, "%s%s is not a finite number; expected %s", where, p->field, expected);
    return BOLAN_ERROR_ARGUMENT;
}

bolan_result bolan_params_validate(const bolan_param_table *table, const void *desc, const char *where) {
    BOLAN_ASSERT(table && desc && where);
    for (uint32_t i = 0; i < table->count; i++) {
        const bolan_param *p = &table->params[i];
        const double value = bolan_param_get(p, desc);
        if (bolan_param_accepts(p, value)) continue;
        return p->kind == BOLAN_PARAM_TEXT ? refuse_text(p, where) : refuse(p, value, where);
    }
    return BOLAN_OK;
}

// ---- text -----------------------------------------------------------------------------------------------------------

typedef struct word {
    const char *text;
    size_t size;
} word;

static char lower(char c) { return c >= 'A' && c <= 'Z' ? (char)(c - 'A' + 'a') : c; }

static bool equals(word a, const char *name) {
    for (size_t i = 0; i < a.size; i++)
        if (name[i] == '\0' || lower(a.text[i]) != lower(name[i])) return false;
    return name[a.size] == '\0';
}

// -1 where there is no such name.
static int index_of(const char *const *names, word w) {
    for (int i = 0; names[i]; i++)
        if (equals(w, names[i])) return i;
    return -1;
}

static bool parse_number(const bolan_param *p, word w, void *desc) {
    double value = 0.0;
    if (!bolan_parse_number(w.text, w.size, &value)) return false;
    const double factor = factor_of(p), measure = p->rules & BOLAN_PARAM_EITHER_SIGN ? fabs(value) : value;
    if (!(measure >= p->low / factor && measure <= p->high / factor)) return false;
    bolan_param_set(p, desc, value * factor);
    return true;
}

// Digits alone, read as an integer: a double would round numbers beyond 2^53.
static bool parse_whole(const bolan_param *p, word w, void *desc) {
    uint64_t value = 0;
    for (size_t i = 0; i < w.size; i++) {
        const char c = w.text[i];
        if (c < '0' || c > '9' || value > (UINT64_MAX - (uint64_t)(c - '0')) / 10) return false;
        value = 10 * value + (uint64_t)(c - '0');
    }
    const bool power = value != 0 && (value & (value - 1)) == 0;
    if (w.size == 0 || (double)value < p->low || (double)value > p->high) return false;
    if ((p->rules & BOLAN_PARAM_POWER_OF_TWO) && !power) return false;
    write_whole(p, (char *)desc + p->offset, value);
    return true;
}

static bool parse_flag(const bolan_param *p, word w, void *desc) {
    static const char *const words[] = {"false", "true", "no", "yes", "off", "on", NULL};
    const int i = index_of(words, w);
    if (i >= 0) bolan_param_set(p, desc, i % 2);
    return i >= 0;
}

static bool parse_name(const bolan_param *p, word w, void *desc) {
    const int i = index_of(p->names, w);
    if (i >= 0) bolan_param_set(p, desc, p->low + i);
    return i >= 0;
}

static size_t skip_blanks(word w, size_t at) {
    while (at < w.size && w.text[at] == ' ') at++;
    return at;
}

// Words separated by one comma or by blanks; an empty list is refused.
static bool parse_set(const bolan_param *p, word w, void *desc) {
    double bits = 0.0;
    const bool all = equals(w, "all"), none = equals(w, "none");
    for (size_t at = skip_blanks(w, 0); !all && !none;) {
        size_t end = at;
        while (end < w.size && w.text[end] != ',' && w.text[end] != ' ') end++;
        const int i = index_of(p->names, (word){w.text + at, end - at});
        if (i < 0) return false;
        bits = (double)((uint32_t)bits | 1u << i);
        end = skip_blanks(w, end);
        if (end == w.size) break;
        at = skip_blanks(w, end + (w.text[end] == ','));
    }
    bolan_param_set(p, desc, all ? p->high : bits);
    return true;
}

static bool parse_text(const bolan_param *p, word w, void *desc) {
    if (w.size == 0 || w.size >= p->size || memchr(w.text, '\0', w.size)) return false;
    char *field = (char *)desc + p->offset;
    memcpy(field, w.text, w.size);
    memset(field + w.size, 0, p->size - w.size);
    return true;
}

bool bolan_param_parse(const bolan_param *p, const char *text, size_t size, void *desc) {
    BOLAN_ASSERT(p && desc && (text || size == 0));
    const word w = {text, size};
    switch (p->kind) {
    case BOLAN_PARAM_NUMBER: return parse_number(p, w, desc);
    case BOLAN_PARAM_WHOLE: return parse_whole(p, w, desc);
    case BOLAN_PARAM_FLAG: return parse_flag(p, w, desc);
    case BOLAN_PARAM_NAME: return parse_name(p, w, desc);
    case BOLAN_PARAM_SET: return parse_set(p, w, desc);
    case BOLAN_PARAM_TEXT: return parse_text(p, w, desc);
    }
    return false;
}
