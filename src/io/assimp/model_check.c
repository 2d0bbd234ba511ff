// SPDX-License-Identifier: MIT
// Model files before assimp sees them. Its importers recurse into brackets and nodes, take quadratic time for long
// numbers and large polygons, and trust counts: each is bounded here.
#include "io/assimp/model_file.h"
#include "io/file.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

enum { MOST_DIGITS = 64, MOST_CORNERS = 1024, DEEPEST = 128, HEAD = 1024 };
enum { MOST_MATERIAL_FILES = 64, MATERIAL_FILE_LIMIT = 1 << 20 };

bolan_result bolan_model_refuse(const char *path, const char *what) {
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_MODEL_LIMIT, "%s: %s", path, what);
    return BOLAN_ERROR_FORMAT;
}

static bolan_result refuse_line(const char *path, size_t line, const char *what) {
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_MODEL_LIMIT, "%s:%zu: %s", path, line, what);
    return BOLAN_ERROR_FORMAT;
}

static bool ends_with(const char *path, const char *suffix) {
    const size_t length = strlen(path), tail = strlen(suffix);
    if (length < tail) return false;
    for (size_t i = 0; i < tail; i++)
        if ((path[length - tail + i] | 32) != (suffix[i] | 32)) return false;
    return true;
}

// ---- text -----------------------------------------------------------------------------------------------------------

static bolan_result check_digits(const char *path, const file_text *t) {
    size_t line = 1, run = 0;
    for (size_t i = 0; i < t->size; i++) {
        const char c = t->data[i];
        line += c == '\n';
        run = c >= '0' && c <= '9' ? run + 1 : 0;
        if (run > MOST_DIGITS) return refuse_line(path, line, "a number has more than 64 digits");
    }
    return BOLAN_OK;
}

// Corners of the faces of an OBJ file: cutting a polygon into triangles takes the square of their number.
static bolan_result check_faces(const char *path, const file_text *t) {
    size_t line = 1;
    const char *at = t->data, *end = t->data + t->size;
    for (; at < end; line++) {
        const char *stop = memchr(at, '\n', (size_t)(end - at));
        if (!stop) stop = end;
        while (at < stop && (*at == ' ' || *at == '\t')) at++;
        size_t words = 0;
        for (const char *c = at + 1; *at == 'f' && c < stop; c++) words += (c[-1] == ' ' || c[-1] == '\t') && *c > ' ';
        if (words > MOST_CORNERS) return refuse_line(path, line, "a face has more than 1024 corners");
        at = stop + 1;
    }
    return BOLAN_OK;
}

// The material files that an OBJ file names: the library opens and reads them too.
static bolan_result check_materials(const char *path, const file_text *t) {
    int files = 0;
    for (const char *at = t->data; (at = strstr(at, "mtllib ")); at++) {
        char name[BOLAN_PATH_MAX], file[BOLAN_PATH_MAX];
        if (at > t->data && at[-1] != '\n') continue;
        if (++files > MOST_MATERIAL_FILES) return bolan_model_refuse(path, "it names more than 64 material files");
        const char *start = at + strlen("mtllib ");
        snprintf(name, sizeof name, "%.*s", (int)(strcspn(start, "\r\n") & 0xffff), start);
        file_text text;
        struct stat s;
        if (!bolan_file_resolve(path, name, file) || stat(file, &s) != 0) continue; // read without colours
        if (!S_ISREG(s.st_mode)) return bolan_model_refuse(file, "is not a file; expected materials (MTL)");
        bolan_result result = bolan_file_read(file, MATERIAL_FILE_LIMIT, &text);
        if (result) return result;
        result = check_digits(file, &text);
        bolan_file_release(&text);
        if (result) return result;
    }
    return BOLAN_OK;
}

// Brackets, and elements of XML.
static bolan_result check_depth(const char *path, const file_text *t) {
    size_t line = 1;
    int brackets = 0, elements = 0;
    for (size_t i = 0; i < t->size; i++) {
        const char c = t->data[i], next = t->data[i + 1]; // a NUL stands behind the text
        line += c == '\n';
        brackets += (c == '{' || c == '[' || c == '(') - (c == '}' || c == ']' || c == ')');
        const bool opens = c == '<' && ((next | 32) >= 'a' && (next | 32) <= 'z');
        elements += opens - (c == '<' && next == '/') - (c == '/' && next == '>');
        if (brackets < 0) brackets = 0;
        if (elements < 0) elements = 0;
        if (brackets > DEEPEST || elements > DEEPEST)
            return refuse_line(path, line, "brackets or elements are nested more than 128 deep");
    }
    return BOLAN_OK;
}

// The counts of a PLY header, for which the importer allocates.
static bolan_result check_ply(const char *path, const file_text *t) {
    const char *end = strstr(t->data, "end_header");
    for (const char *at = t->data; (at = strstr(at, "\nelement ")) && at < end;) {
        at += strlen("\nelement ");
        at += strcspn(at, " \n");
        uint64_t count = 0;
        for (at += *at == ' '; *at >= '0' && *at <= '9' && count <= t->size; at++)
            count = 10 * count + (uint64_t)(*at - '0');
        if (count > t->size) return bolan_model_refuse(path, "its header counts more elements than it has bytes");
    }
    return BOLAN_OK;
}

static bolan_result check_text(const char *path, const file_text *t, model_format format) {
    if (ends_with(path, ".ply") && check_ply(path, t)) return BOLAN_ERROR_FORMAT;
    if (memchr(t->data, '\0', t->size < HEAD ? t->size : HEAD)) return BOLAN_OK; // binary
    if (check_digits(path, t)) return BOLAN_ERROR_FORMAT;
    if (format != MODEL_OBJ) return check_depth(path, t);
    const bolan_result result = check_faces(path, t);
    return result ? result : check_materials(path, t);
}

// ---- the file -------------------------------------------------------------------------------------------------------

static uint32_t word_at(const char *data) {
    const unsigned char *b = (const unsigned char *)data;
    return (uint32_t)b[0] | (uint32_t)b[1] << 8 | (uint32_t)b[2] << 16 | (uint32_t)b[3] << 24;
}

// GLB (glTF 2.0, 4.4): magic, version, length; then chunks, the first of which is JSON.
static bolan_result check_glb(const char *path, const file_text *t) {
    if (t->size < 20 || word_at(t->data + 4) != 2 || memcmp(t->data + 16, "JSON", 4) != 0)
        return bolan_model_refuse(path, "it is no GLB of version 2 that begins with JSON");
    const size_t size = word_at(t->data + 12);
    if (size > t->size - 20) return bolan_model_refuse(path, "its JSON is longer than the file");
    return bolan_model_gltf_check(path, t->data + 20, size);
}

static bool begins_like_json(const file_text *t) {
    size_t i = t->size >= 3 && memcmp(t->data, "\xef\xbb\xbf", 3) == 0 ? 3 : 0;
    while (i < t->size && strchr(" \t\r\n", t->data[i]) && t->data[i]) i++;
    return i < t->size && (t->data[i] == '{' || t->data[i] == '[');
}

static bolan_result check_kind(const char *path) {
    struct stat s;
    if (stat(path, &s) == 0 && S_ISREG(s.st_mode)) return BOLAN_OK;
    const bool there = stat(path, &s) == 0;
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_FILE_OPEN, "%s: %s%s", path,
              there ? "is not a file; expected a model (OBJ, glTF)" : "cannot be read: ", there ? "" : strerror(errno));
    return BOLAN_ERROR_IO;
}

bolan_result bolan_model_file_check(const char *path, model_format *format) {
    file_text text;
    bolan_result result = check_kind(path);
    if (!result) result = bolan_file_read(path, MODEL_FILE_LIMIT, &text);
    if (result) return result;
    const bool glb = text.size >= 4 && memcmp(text.data, "glTF", 4) == 0;
    const bool json = ends_with(path, ".gltf") || ends_with(path, ".glb") || begins_like_json(&text);
    *format = glb || json ? MODEL_GLTF : ends_with(path, ".obj") ? MODEL_OBJ : MODEL_OTHER;
    if (glb)
        result = check_glb(path, &text);
    else
        result = json ? bolan_model_gltf_check(path, text.data, text.size) : check_text(path, &text, *format);
    bolan_file_release(&text);
    return result;
}
