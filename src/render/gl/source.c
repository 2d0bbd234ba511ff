// SPDX-License-Identifier: MIT
// Shader sources: found by stem, #include resolved, the version line and precision put in front.
#include "source.h"
#include "../shader_source.h"
#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// The file goes into the line number: Mesa forgets the file number of #line in some of its messages.
enum { DIRECTORY_MAX = 1024, LINES_PER_FILE = 10000, USUAL_BYTES = 128 * 1024 }; // the last: of most shaders
// "": the embedded sources. Each thread has its own, since each may draw in a context of its own.
static _Thread_local char shader_directory[DIRECTORY_MAX];

void bolan_gl_program_set_directory(const char *directory) {
    snprintf(shader_directory, sizeof shader_directory, "%s", directory ? directory : "");
}

// ---- finding a file -----------------------------------------------------------------------------------------------

static const char *find_embedded(const char *path) {
    for (unsigned i = 0; i < bolan_shader_source_count; i++) {
        if (strcmp(bolan_shader_sources[i].path, path) == 0) return bolan_shader_sources[i].text;
    }
    return NULL;
}

static bolan_result read_whole(FILE *file, const char **out, size_t *size) {
    if (fseek(file, 0, SEEK_END) != 0) return BOLAN_OK;
    const long length = ftell(file);
    if (length < 0 || fseek(file, 0, SEEK_SET) != 0) return BOLAN_OK;
    char *text = bolan_allocate((size_t)length + 1);
    if (!text) return BOLAN_ERROR_MEMORY;
    if (fread(text, 1, (size_t)length, file) != (size_t)length) {
        bolan_release(text, (size_t)length + 1);
        return BOLAN_OK;
    }
    *size = (size_t)length + 1;
    *out = text;
    return BOLAN_OK;
}

// The text of a file, NULL where there is none; *owned is its allocated size, 0 when it is embedded.
static bolan_result load(const char *path, const char **text, size_t *owned) {
    *owned = 0;
    *text = NULL;
    if (!shader_directory[0]) {
        *text = find_embedded(path);
        return BOLAN_OK;
    }
    char full[DIRECTORY_MAX + 2 * SOURCE_NAME];
    snprintf(full, sizeof full, "%s/%s", shader_directory, path);
    FILE *file = fopen(full, "rb");
    if (!file) return BOLAN_OK;
    const bolan_result result = read_whole(file, text, owned);
    fclose(file);
    return result;
}

// ---- putting it together ------------------------------------------------------------------------------------------

static bool append(shader_text *s, const char *text, size_t length) {
    if (s->size + length + 1 > s->capacity) {
        const size_t needed = (s->size + length + 1) * 2, capacity = needed > USUAL_BYTES ? needed : USUAL_BYTES;
        char *grown = bolan_enlarge(s->text, s->capacity, capacity);
        if (!grown) return false;
        s->text = grown;
        s->capacity = capacity;
    }
    memcpy(s->text + s->size, text, length);
    s->size += length;
    s->text[s->size] = '\0';
    return true;
}

#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
static bool
append_format(shader_text *s, const char *format, ...) {
    char line[256];
    va_list arguments;
    va_start(arguments, format);
    const int n = vsnprintf(line, sizeof line, format, arguments);
    va_end(arguments);
    return n >= 0 && (size_t)n < sizeof line && append(s, line, (size_t)n);
}

static bool append_prologue(shader_text *s, const char *stage, const char *defines, bool es) {
    static const char es_head[] = "precision highp float;\nprecision highp int;\nprecision highp sampler2D;\n"
                                  "precision highp sampler3D;\nprecision highp sampler2DArray;\n#define BOLAN_ES 1\n";
    const bool compute = strcmp(stage, "COMPUTE") == 0;
    const char *version = es ? compute ? "310 es" : "300 es" : compute ? "430 core" : "330 core";
    bool ok = append_format(s, "#version %s\n", version);
    if (es) ok = ok && append(s, es_head, sizeof es_head - 1);
    if (es && compute) ok = ok && append_format(s, "precision highp image2D;\nprecision highp image2DArray;\n");
    ok = ok && append_format(s, "#define %s 1\n", stage);
    for (const char *d = defines; ok && d && *d;) {
        const size_t length = strcspn(d, "\n");
        ok = append_format(s, "#define %.*s\n", (int)length, d);
        d += length + (d[length] == '\n');
    }
    return ok;
}

// `#include "path"` -> path. The line ends at `length`.
static bool parse_include(const char *line, size_t length, char path[SOURCE_NAME]) {
    char copy[160];
    if (length >= sizeof copy) return false;
    memcpy(copy, line, length);
    copy[length] = '\0';
    return sscanf(copy, " #include \"%47[^\"]\"", path) == 1;
}

static void note_unit(shader_text *s, const char *line, size_t length) {
    char copy[160], name[SOURCE_NAME];
    int unit = 0;
    if (length >= sizeof copy) return;
    memcpy(copy, line, length);
    copy[length] = '\0';
    if (sscanf(copy, " #pragma unit %47s %d", name, &unit) != 2) return;
    BOLAN_ASSERT(s->unit_count < SOURCE_MAX_UNITS); // a sampler left out would read unit 0
    memcpy(s->units[s->unit_count].name, name, sizeof name);
    s->units[s->unit_count++].unit = unit;
}

// The number of a file that is in the text already; file_count of one that is not.
static uint32_t number_of(const shader_text *s, const char *path) {
    uint32_t i = 0;
    while (i < s->file_count && strcmp(s->files[i], path) != 0) i++;
    return i;
}

// Files of shaders/shared/ have include guards, for C too, and may be asked for inside an #ifdef that is not taken:
// their text is put wherever they are included.
static bool is_guarded(const char *path) { return strncmp(path, "shared/", 7) == 0; }

static bolan_result out_of_memory(const char *path) {
    bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "no memory for the shader %s", path);
    return BOLAN_ERROR_MEMORY;
}

static bolan_result missing(const char *path, const char *from, uint32_t line) {
    const char *where = shader_directory[0] ? shader_directory : "the built-in shaders";
    if (from) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_GL_SHADER, "%s:%u: there is no shader file %s in %s", from, line, path,
                  where);
    } else {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_GL_SHADER, "there is no shader file %s in %s", path, where);
    }
    return BOLAN_ERROR_GL;
}

static bolan_result append_file(shader_text *s, const char *path, const char *from, uint32_t from_line);

static bolan_result append_lines(shader_text *s, const char *text, const char *path, uint32_t number) {
    uint32_t line = 1;
    if (!append_format(s, "#line %u\n", number * LINES_PER_FILE + 1)) return out_of_memory(path);
    while (*text) {
        const size_t length = strcspn(text, "\n");
        char include[SOURCE_NAME];
        bool ok = true;
        if (parse_include(text, length, include)) {
            const bolan_result result = append_file(s, include, path, line);
            if (result != BOLAN_OK) return result;
            ok = append_format(s, "#line %u\n", number * LINES_PER_FILE + line + 1);
        } else {
            note_unit(s, text, length);
            ok = append(s, text, length) && append(s, "\n", 1);
        }
        if (!ok) return out_of_memory(path);
        text += length + (text[length] == '\n');
        line++;
    }
    return BOLAN_OK;
}

static bolan_result append_file(shader_text *s, const char *path, const char *from, uint32_t from_line) {
    const uint32_t number = number_of(s, path);
    if (number < s->file_count && !is_guarded(path)) return BOLAN_OK;
    size_t owned = 0;
    const char *text = NULL;
    if (load(path, &text, &owned) != BOLAN_OK) return out_of_memory(path);
    if (!text) return missing(path, from, from_line);
    bolan_result result = BOLAN_ERROR_GL;
    if (number == SOURCE_MAX_FILES) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_GL_SHADER, "%s: more than %d files in one shader", path, SOURCE_MAX_FILES);
    } else {
        if (number == s->file_count) snprintf(s->files[s->file_count++], SOURCE_NAME, "%s", path);
        result = append_lines(s, text, path, number);
    }
    if (owned) bolan_release((void *)(uintptr_t)text, owned);
    return result;
}

bolan_result bolan_shader_text_build(const char *stem, const char *stage, const char *defines, bool es,
                                     shader_text *out) {
    *out = (shader_text){0};
    char path[SOURCE_NAME];
    snprintf(path, sizeof path, "%s.glsl", stem);
    if (!append_prologue(out, stage, defines, es)) {
        bolan_shader_text_free(out);
        return out_of_memory(path);
    }
    const bolan_result result = append_file(out, path, NULL, 0);
    if (result != BOLAN_OK) bolan_shader_text_free(out);
    return result;
}

void bolan_shader_text_free(shader_text *s) {
    bolan_release(s->text, s->capacity);
    s->text = NULL;
    s->size = s->capacity = 0;
}

// ---- messages -----------------------------------------------------------------------------------------------------

// Drivers write "0:LINE(COLUMN): ..." (Mesa), "0(LINE) : ..." (NVIDIA) or "ERROR: 0:LINE: ..." (others).
static bool parse_place(const char *message, unsigned *line, const char **rest) {
    while (*message && !isdigit((unsigned char)*message) && *message != '\n') message++;
    char *end = NULL;
    (void)strtoul(message, &end, 10);
    if (end == message || (*end != ':' && *end != '(')) return false;
    const char *number = end + 1;
    *line = (unsigned)strtoul(number, &end, 10);
    if (end == number) return false;
    *rest = end + strspn(end, "0123456789(): ");
    return true;
}

void bolan_shader_text_log(const shader_text *s, const char *stage, const char *messages) {
    while (*messages) {
        const size_t length = strcspn(messages, "\n");
        unsigned line = 0;
        const char *rest = NULL;
        const bool placed = length > 0 && parse_place(messages, &line, &rest) && rest < messages + length;
        if (placed && line / LINES_PER_FILE < s->file_count) {
            bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_GL_SHADER, "%s:%u: %.*s", s->files[line / LINES_PER_FILE],
                      line % LINES_PER_FILE, (int)(messages + length - rest), rest);
        } else if (length > 0) {
            bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_GL_SHADER, "%s (%s): %.*s", s->file_count ? s->files[0] : "", stage,
                      (int)length, messages);
        }
        messages += length + (messages[length] == '\n');
    }
}
