// SPDX-License-Identifier: MIT
// Text of users in messages: cut between characters, and without control characters. A terminal executes escape
// sequences, so file names and words of an input must be escaped first.
#include "bolan/base.h"

#include <stdio.h>
#include <string.h>

// The bytes of the UTF-8 character that begins at `p`, and its code; 0 where no valid character begins. The text ends
// in NUL, which is no continuation byte.
static size_t utf8_character(const unsigned char *p, uint32_t *code) {
    static const uint32_t smallest[5] = {0, 0, 0x80, 0x800, 0x10000};
    const size_t length = p[0] < 0x80 ? 1 : p[0] >= 0xF0 && p[0] < 0xF8 ? 4 : p[0] >= 0xE0 ? 3 : 2;
    if (p[0] >= 0xF8 || (p[0] >= 0x80 && p[0] < 0xC0)) return 0;
    *code = length == 1 ? p[0] : p[0] & (0x7Fu >> length);
    for (size_t i = 1; i < length; i++) {
        if ((p[i] & 0xC0) != 0x80) return 0;
        *code = *code << 6 | (p[i] & 0x3Fu);
    }
    const bool surrogate = *code >= 0xD800 && *code <= 0xDFFF;
    return *code >= smallest[length] && *code <= 0x10FFFF && !surrogate ? length : 0;
}

// C0, DEL, C1, and the characters that break lines or turn the direction of the text.
static bool is_control(uint32_t code) {
    return code < 0x20 || (code >= 0x7F && code <= 0x9F) || (code >= 0x2028 && code <= 0x202E) ||
           (code >= 0x2066 && code <= 0x2069);
}

// The rest of the text is the beginning of one character that was cut.
static bool is_cut(const unsigned char *p) {
    const size_t wanted = p[0] >= 0xF0 && p[0] < 0xF8 ? 4 : p[0] >= 0xE0 ? 3 : p[0] >= 0xC0 ? 2 : 0;
    size_t left = 0;
    while (left < wanted && p[left] && (left == 0 || (p[left] & 0xC0) == 0x80)) left++;
    return left < wanted && !p[left];
}

size_t bolan_text_fit(const char *text, size_t most) {
    BOLAN_ASSERT(text);
    size_t length = 0;
    while (length < most && text[length]) length++;
    if (!text[length]) return length;
    const size_t full = length;
    while (length > 0 && full - length < 3 && ((unsigned char)text[length] & 0xC0) == 0x80) length--;
    return ((unsigned char)text[length] & 0xC0) == 0x80 ? full : length; // no UTF-8: any byte may be the last
}

void bolan_text_escape(const char *text, char *out, size_t capacity) {
    BOLAN_ASSERT(text && out && capacity > 0);
    size_t used = 0;
    for (const unsigned char *p = (const unsigned char *)text; *p;) {
        char piece[12];
        uint32_t code = 0;
        const size_t length = utf8_character(p, &code);
        if (length == 0 && is_cut(p)) break;
        if (length > 0 && !is_control(code)) {
            memcpy(piece, p, length);
            piece[length] = '\0';
        } else if (length == 1 && (code == '\n' || code == '\t')) {
            snprintf(piece, sizeof piece, "\\%c", code == '\n' ? 'n' : 't');
        } else if (length <= 1) {
            snprintf(piece, sizeof piece, "\\x%02x", (unsigned)*p);
        } else {
            snprintf(piece, sizeof piece, "\\u%04x", (unsigned)code);
        }
        const size_t more = strlen(piece);
        if (used + more >= capacity) break;
        memcpy(out + used, piece, more);
        used += more;
        p += length > 0 ? length : 1;
    }
    out[used] = '\0';
}
