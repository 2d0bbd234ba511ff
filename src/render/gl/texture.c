// SPDX-License-Identifier: MIT
// Textures: 2D, 3D and 2D arrays of the formats that GL 3.3 and ES 3.0 both have.
#include "gl_internal.h"

static const format_info formats[] = {
    [GL_FMT_R8] = {GL_R8, GL_RED, GL_UNSIGNED_BYTE, false, false, 1},
    [GL_FMT_RG8] = {GL_RG8, GL_RG, GL_UNSIGNED_BYTE, false, false, 2},
    [GL_FMT_RGBA8] = {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, false, false, 4},
    [GL_FMT_R16F] = {GL_R16F, GL_RED, GL_FLOAT, true, false, 1},
    [GL_FMT_RG16F] = {GL_RG16F, GL_RG, GL_FLOAT, true, false, 2},
    [GL_FMT_RGBA16F] = {GL_RGBA16F, GL_RGBA, GL_FLOAT, true, false, 4},
    [GL_FMT_R32F] = {GL_R32F, GL_RED, GL_FLOAT, false, true, 1},
    [GL_FMT_RGBA32F] = {GL_RGBA32F, GL_RGBA, GL_FLOAT, false, true, 4},
    [GL_FMT_RGBA32UI] = {GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT, false, true, 4},
    [GL_FMT_R11G11B10F] = {GL_R11F_G11F_B10F, GL_RGB, GL_FLOAT, false, false, 3},
    [GL_FMT_DEPTH32F] = {GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, false, false, 1},
};

const format_info *bolan_gl_format_info(gl_format format) {
    BOLAN_ASSERT((unsigned)format < sizeof formats / sizeof formats[0]);
    return &formats[format];
}

static bool is_mipmapped(gl_filter filter) { return filter == GL_FILTER_MIPMAP || filter == GL_FILTER_MIPMAP_NEAREST; }

static uint32_t full_chain(uint32_t width, uint32_t height, uint32_t depth) {
    uint32_t largest = width > height ? width : height;
    if (depth > largest) largest = depth;
    uint32_t levels = 1;
    while (largest >>= 1) levels++;
    return levels;
}

static uint32_t mip(uint32_t size, uint32_t level) { return size >> level ? size >> level : 1; }

static void bind_scratch(const gl_texture *t) {
    glActiveTexture(GL_TEXTURE0 + SCRATCH_UNIT);
    glBindTexture(t->target, t->id);
}

static void set_filter(const gl_texture *t, const gl_texture_desc *d) {
    gl_filter filter = d->filter;
    if (bolan_gl_format_info(d->format)->wide && bolan_gl_is_es() &&
        !bolan_gl_has_extension("GL_OES_texture_float_linear")) {
        filter = GL_FILTER_NEAREST;
    }
    if (d->format == GL_FMT_DEPTH32F && bolan_gl_is_es()) filter = GL_FILTER_NEAREST; // ES: depth is not filterable
    const GLint min_filter[] = {GL_NEAREST, GL_LINEAR, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR_MIPMAP_NEAREST};
    glTexParameteri(t->target, GL_TEXTURE_MIN_FILTER, min_filter[filter]);
    glTexParameteri(t->target, GL_TEXTURE_MAG_FILTER, filter == GL_FILTER_NEAREST ? GL_NEAREST : GL_LINEAR);
    glTexParameteri(t->target, GL_TEXTURE_BASE_LEVEL, 0);
    glTexParameteri(t->target, GL_TEXTURE_MAX_LEVEL, (GLint)t->levels - 1);
    if (d->anisotropy > 1.0f && is_mipmapped(d->filter) &&
        bolan_gl_has_extension("GL_EXT_texture_filter_anisotropic")) {
        glTexParameterf(t->target, GL_TEXTURE_MAX_ANISOTROPY_EXT, d->anisotropy);
    }
}

static void set_wrap(const gl_texture *t, gl_wrap wrap) {
    const GLint s = wrap == GL_WRAP_CLAMP ? GL_CLAMP_TO_EDGE : GL_REPEAT;
    const GLint other = wrap == GL_WRAP_REPEAT ? GL_REPEAT : GL_CLAMP_TO_EDGE;
    glTexParameteri(t->target, GL_TEXTURE_WRAP_S, s);
    glTexParameteri(t->target, GL_TEXTURE_WRAP_T, other);
    if (t->target == GL_TEXTURE_3D) glTexParameteri(t->target, GL_TEXTURE_WRAP_R, other);
}

static void allocate_levels(const gl_texture *t) {
    const format_info *f = bolan_gl_format_info(t->format);
    const GLint internal_format = (GLint)f->internal_format;
    if (t->storage) {
        const GLsizei w = (GLsizei)t->width, h = (GLsizei)t->height;
        BOLAN_ASSERT(t->target != GL_TEXTURE_3D);
        if (t->target == GL_TEXTURE_2D)
            glTexStorage2D(t->target, (GLsizei)t->levels, f->internal_format, w, h);
        else
            glTexStorage3D(t->target, (GLsizei)t->levels, f->internal_format, w, h, (GLsizei)t->depth);
        return;
    }
    for (uint32_t l = 0; l < t->levels; l++) {
        const GLsizei w = (GLsizei)mip(t->width, l), h = (GLsizei)mip(t->height, l);
        if (t->target == GL_TEXTURE_2D) {
            glTexImage2D(t->target, (GLint)l, internal_format, w, h, 0, f->format, f->type, NULL);
        } else {
            const GLsizei d = (GLsizei)(t->target == GL_TEXTURE_3D ? mip(t->depth, l) : t->depth);
            glTexImage3D(t->target, (GLint)l, internal_format, w, h, d, 0, f->format, f->type, NULL);
        }
    }
}

// Asked before, since a texture that GL refuses would leave an error behind.
static bool is_possible(const gl_texture *t) {
    const format_info *f = bolan_gl_format_info(t->format);
    const GLsizei w = (GLsizei)t->width, h = (GLsizei)t->height, d = (GLsizei)t->depth;
    GLint most = 0, got = 0;
    glGetIntegerv(t->target == GL_TEXTURE_3D ? GL_MAX_3D_TEXTURE_SIZE : GL_MAX_TEXTURE_SIZE, &most);
    if (w > most || h > most || (t->target == GL_TEXTURE_3D && d > most)) return false;
    if (bolan_gl_is_es()) return true; // which has no proxies
    if (t->target == GL_TEXTURE_2D) {
        glTexImage2D(GL_PROXY_TEXTURE_2D, 0, (GLint)f->internal_format, w, h, 0, f->format, f->type, NULL);
        glGetTexLevelParameteriv(GL_PROXY_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &got);
    } else {
        const GLenum proxy = t->target == GL_TEXTURE_3D ? GL_PROXY_TEXTURE_3D : GL_PROXY_TEXTURE_2D_ARRAY;
        glTexImage3D(proxy, 0, (GLint)f->internal_format, w, h, d, 0, f->format, f->type, NULL);
        glGetTexLevelParameteriv(proxy, 0, GL_TEXTURE_WIDTH, &got);
    }
    return got == w;
}

// Memory may still have run out. ES cannot be asked before 3.1.
static bool is_allocated(const gl_texture *t) {
    if (bolan_gl_is_es() && bolan_gl_version() < 31) return true;
    bool all = true;
    for (uint32_t l = 0; l < t->levels; l++) {
        GLint width = 0;
        glGetTexLevelParameteriv(t->target, (GLint)l, GL_TEXTURE_WIDTH, &width);
        all = all && width == (GLint)mip(t->width, l);
    }
    return all;
}

static _Thread_local uint32_t made; // by this thread
uint32_t bolan_gl_textures_made(void) { return made; }

bolan_result bolan_gl_texture_create(const gl_texture_desc *d, gl_texture *out) {
    BOLAN_ASSERT(d && out && d->width > 0 && d->height > 0);
    gl_texture t = {.width = d->width,
                    .height = d->height,
                    .depth = d->depth ? d->depth : 1,
                    .format = d->format,
                    .storage = d->storage};
    t.target = d->depth == 0 ? GL_TEXTURE_2D : d->array ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_3D;
    t.levels = d->levels ? d->levels : 1;
    if (!d->levels && is_mipmapped(d->filter)) {
        t.levels = full_chain(t.width, t.height, t.target == GL_TEXTURE_3D ? t.depth : 1);
    }
    if (!is_possible(&t)) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_GL_TARGET, "GL has no textures of %u x %u x %u texels of format %d",
                  t.width, t.height, t.depth, (int)t.format);
        return BOLAN_ERROR_GL;
    }
    glGenTextures(1, &t.id);
    bind_scratch(&t);
    set_filter(&t, d);
    set_wrap(&t, d->wrap);
    allocate_levels(&t);
    if (!is_allocated(&t)) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY,
                  "GL has no memory for a texture of %u x %u x %u texels, format %d", t.width, t.height, t.depth,
                  (int)t.format);
        bolan_gl_texture_free(&t);
        return BOLAN_ERROR_MEMORY;
    }
    *out = t;
    made++;
    return BOLAN_OK;
}

static _Thread_local gl_uploads uploads; // by this thread
gl_uploads bolan_gl_uploads(void) { return uploads; }

static void count_upload(const format_info *f, GLenum type, uint32_t texels) {
    const uint64_t channel = type == GL_UNSIGNED_BYTE ? 1 : type == GL_HALF_FLOAT ? 2 : 4;
    uploads.count++;
    uploads.bytes += channel * f->components * texels;
}

void bolan_gl_texture_upload(gl_texture *t, uint32_t level, int layer, const void *data, bool half) {
    BOLAN_ASSERT(t->id && data && level < t->levels);
    const format_info *f = bolan_gl_format_info(t->format);
    BOLAN_ASSERT(!half || f->half);
    const GLenum type = half ? GL_HALF_FLOAT : f->type;
    const GLsizei w = (GLsizei)mip(t->width, level), h = (GLsizei)mip(t->height, level);
    bind_scratch(t);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    const uint32_t all = t->target == GL_TEXTURE_3D ? mip(t->depth, level) : t->depth;
    count_upload(f, type, (uint32_t)w * (uint32_t)h * (layer < 0 ? all : 1));
    if (t->target == GL_TEXTURE_2D) {
        glTexSubImage2D(t->target, (GLint)level, 0, 0, w, h, f->format, type, data);
        return;
    }
    glTexSubImage3D(t->target, (GLint)level, 0, 0, layer < 0 ? 0 : layer, w, h, layer < 0 ? (GLsizei)all : 1, f->format,
                    type, data);
}

void bolan_gl_texture_generate_mipmaps(gl_texture *t) {
    bind_scratch(t);
    glGenerateMipmap(t->target);
}

void bolan_gl_texture_layer(const gl_texture *array, uint32_t layer, const gl_texture_desc *d, gl_texture *out) {
    gl_texture t = *array;
    t.target = GL_TEXTURE_2D;
    t.depth = 1;
    const GLenum format = bolan_gl_format_info(t.format)->internal_format;
    glGenTextures(1, &t.id);
    if (!bolan_gl_is_es()) {
        glTextureView(t.id, t.target, array->id, format, 0, t.levels, layer, 1);
    } else if (bolan_gl_has_extension("GL_EXT_texture_view")) {
        glTextureViewEXT(t.id, t.target, array->id, format, 0, t.levels, layer, 1);
    } else {
        glTextureViewOES(t.id, t.target, array->id, format, 0, t.levels, layer, 1);
    }
    bind_scratch(&t);
    set_filter(&t, d);
    set_wrap(&t, d->wrap);
    *out = t;
    made++;
}

void bolan_gl_texture_bind(const gl_texture *t, uint32_t unit) {
    BOLAN_ASSERT(unit < SCRATCH_UNIT);
    if (t->id) bolan_gl_bind_to_unit(unit, t->target, t->id);
}

void bolan_gl_texture_free(gl_texture *t) {
    if (t->id && bolan_gl_has_context()) glDeleteTextures(1, &t->id);
    *t = (gl_texture){0};
}
