// SPDX-License-Identifier: MIT
// Float images: OpenEXR, through its C library.
//
// Each part is of scan lines in blocks of 16 lines, each compressed by itself (ZIP). The encoder takes,
// for each channel of the header, a pointer to the block's first line. The file is built in memory, because the encoder
// writes its table of blocks last and a pipe cannot seek; then it is written like every other file.
#include "io/file.h"

#include <openexr.h>
#include <string.h>

enum { LARGEST_SIDE = BOLAN_IMAGE_MOST_SIDE, MOST_CHANNELS = 64, MOST_PARTS = 16 };

typedef bolan_exr_part picture;

// Errors are reported once, by bolan_exr_write().
static void ignore_message(exr_const_context_t context, exr_result_t code, const char *message) {
    (void)context, (void)code, (void)message;
}

static const float *find_plane(const picture *p, const char *name) {
    for (uint32_t i = 0; i < p->channel_count; i++)
        if (strcmp(p->channels[i].name, name) == 0) return p->channels[i].pixels;
    return NULL;
}

static exr_result_t add_attribute(exr_context_t file, int part, const bolan_exr_attribute *a) {
    const exr_attr_v3f_t v = {.x = (float)a->number[0], .y = (float)a->number[1], .z = (float)a->number[2]};
    if (a->text) return exr_attr_set_string(file, part, a->name, a->text);
    return a->count == 3 ? exr_attr_set_v3f(file, part, a->name, &v)
                         : exr_attr_set_double(file, part, a->name, a->number[0]);
}

static exr_result_t add_part(exr_context_t file, const picture *p) {
    int part = 0;
    const exr_pixel_type_t type = p->half ? EXR_PIXEL_HALF : EXR_PIXEL_FLOAT;
    exr_result_t result = exr_add_part(file, p->name ? p->name : "", EXR_STORAGE_SCANLINE, &part);
    if (result == EXR_ERR_SUCCESS)
        result =
            exr_initialize_required_attr_simple(file, part, (int32_t)p->width, (int32_t)p->height, EXR_COMPRESSION_ZIP);
    for (uint32_t i = 0; i < p->channel_count && result == EXR_ERR_SUCCESS; i++)
        result = exr_add_channel(file, part, p->channels[i].name, type, EXR_PERCEPTUALLY_LOGARITHMIC, 1, 1);
    for (uint32_t i = 0; i < p->attribute_count && result == EXR_ERR_SUCCESS; i++)
        result = add_attribute(file, part, &p->attributes[i]);
    return result;
}

static void point_at_line(exr_encode_pipeline_t *encoder, const picture *p, uint32_t y) {
    for (int c = 0; c < encoder->channel_count; c++) {
        exr_coding_channel_info_t *channel = &encoder->channels[c];
        const float *plane = find_plane(p, channel->channel_name);
        channel->encode_from_ptr = (const uint8_t *)(plane + (size_t)y * p->width);
        channel->user_pixel_stride = (int32_t)sizeof(float);
        channel->user_line_stride = (int32_t)(p->width * sizeof(float));
        channel->user_bytes_per_element = (int16_t)sizeof(float);
        channel->user_data_type = EXR_PIXEL_FLOAT;
    }
}

static exr_result_t write_blocks(exr_context_t file, int part, const picture *p, exr_encode_pipeline_t *encoder) {
    int32_t lines = 0;
    exr_result_t result = exr_get_scanlines_per_chunk(file, part, &lines);
    bool first = true;
    for (uint32_t y = 0; y < p->height && result == EXR_ERR_SUCCESS; y += (uint32_t)lines) {
        exr_chunk_info_t block;
        result = exr_write_scanline_chunk_info(file, part, (int)y, &block);
        if (result != EXR_ERR_SUCCESS) break;
        result = first ? exr_encoding_initialize(file, part, &block, encoder)
                       : exr_encoding_update(file, part, &block, encoder);
        if (result != EXR_ERR_SUCCESS) break;
        point_at_line(encoder, p, y);
        if (first) result = exr_encoding_choose_default_routines(file, part, encoder);
        if (result == EXR_ERR_SUCCESS) result = exr_encoding_run(file, part, encoder);
        first = false;
    }
    return result;
}

typedef struct memory {
    uint8_t *data;
    size_t size, capacity;
} memory;

static bool grow(memory *m, size_t size) {
    if (size <= m->capacity) return true;
    const size_t capacity = size + size / 2 + 65536;
    uint8_t *data = bolan_enlarge(m->data, m->capacity, capacity);
    if (!data) return false;
    m->data = data;
    m->capacity = capacity;
    return true;
}

static int64_t write_to_memory(exr_const_context_t file, void *user, const void *bytes, uint64_t size, uint64_t at,
                               exr_stream_error_func_ptr_t report) {
    memory *m = user;
    if (!grow(m, (size_t)(at + size))) return report(file, EXR_ERR_OUT_OF_MEMORY, "no memory"), -1;
    memcpy(m->data + at, bytes, (size_t)size);
    if (at + size > m->size) m->size = (size_t)(at + size);
    return (int64_t)size;
}

static exr_result_t write_parts(exr_context_t file, const picture *parts, uint32_t count) {
    exr_result_t result = EXR_ERR_SUCCESS;
    for (uint32_t i = 0; i < count && result == EXR_ERR_SUCCESS; i++) result = add_part(file, &parts[i]);
    if (result == EXR_ERR_SUCCESS) result = exr_write_header(file);
    for (uint32_t i = 0; i < count && result == EXR_ERR_SUCCESS; i++) {
        exr_encode_pipeline_t encoder = EXR_ENCODE_PIPELINE_INITIALIZER;
        result = write_blocks(file, (int)i, &parts[i], &encoder);
        exr_encoding_destroy(file, &encoder);
    }
    return result;
}

static exr_result_t write_file(const char *path, const picture *parts, uint32_t count, memory *m) {
    exr_context_initializer_t initializer = EXR_DEFAULT_CONTEXT_INITIALIZER;
    initializer.error_handler_fn = ignore_message;
    initializer.user_data = m;
    initializer.write_fn = write_to_memory;
    exr_context_t file = NULL;
    exr_result_t result = exr_start_write(&file, path, EXR_WRITE_FILE_DIRECTLY, &initializer);
    if (result != EXR_ERR_SUCCESS) return result;
    result = write_parts(file, parts, count);
    const exr_result_t closed = exr_finish(&file);
    return result == EXR_ERR_SUCCESS ? closed : result;
}

static bolan_result check(const char *path, const picture *p) {
    bool good = p->width >= 1 && p->width <= LARGEST_SIDE && p->height >= 1 && p->height <= LARGEST_SIDE &&
                (uint64_t)p->width * p->height <= BOLAN_IMAGE_MOST_PIXELS && p->channel_count >= 1 &&
                p->channel_count <= MOST_CHANNELS;
    for (uint32_t i = 0; i < p->channel_count && good; i++)
        good = p->channels[i].name && p->channels[i].pixels && p->channels[i].name[0] != '\0' &&
               find_plane(p, p->channels[i].name) == p->channels[i].pixels;
    if (good) return BOLAN_OK;
    bolan_log(
        BOLAN_LOG_ERROR, BOLAN_LOG_BAD_ARGUMENT,
        "%s: a picture of %ux%u with %u channels; expected 1 to %d each way, and 1 to %d channels with different names",
        path, (unsigned)p->width, (unsigned)p->height, (unsigned)p->channel_count, LARGEST_SIDE, MOST_CHANNELS);
    return BOLAN_ERROR_ARGUMENT;
}

bolan_result bolan_exr_write_parts(const char *path, const bolan_exr_part *parts, uint32_t count) {
    BOLAN_ASSERT(path && parts);
    bolan_result written = BOLAN_OK;
    if (count < 1 || count > MOST_PARTS) {
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_BAD_ARGUMENT, "%s: %u parts; expected 1 to %d", path, (unsigned)count,
                  MOST_PARTS);
        return BOLAN_ERROR_ARGUMENT;
    }
    for (uint32_t i = 0; i < count && !written; i++) written = check(path, &parts[i]);
    if (written) return written;
    memory m = {NULL, 0, 0};
    const exr_result_t result = write_file(path, parts, count, &m);
    if (result == EXR_ERR_SUCCESS) {
        written = bolan_file_write(path, m.data, m.size);
    } else {
        // Writing to memory fails only when memory is short, whatever error the library names.
        bolan_log(BOLAN_LOG_ERROR, BOLAN_LOG_OUT_OF_MEMORY, "%s: no memory to compress the picture: %s", path,
                  exr_get_default_error_message(result));
        written = BOLAN_ERROR_MEMORY;
    }
    bolan_release(m.data, m.capacity);
    return written;
}

bolan_result bolan_exr_write(const char *path, uint32_t width, uint32_t height, const bolan_exr_channel *channels,
                             uint32_t count) {
    BOLAN_ASSERT(path && channels);
    const bolan_exr_part part = {.width = width, .height = height, .channels = channels, .channel_count = count};
    return bolan_exr_write_parts(path, &part, 1);
}
