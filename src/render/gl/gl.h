// SPDX-License-Identifier: MIT
// The whole of OpenGL that the passes see: textures, targets, buffers, programs, state, timers. Names of GL itself stay
// in this folder. Every object is a plain struct owned by the pass that made it; free functions accept zeroed structs.
#ifndef BOLAN_GL_H
#define BOLAN_GL_H

#include "bolan/base.h"
#include "bolan/math.h"
#include "bolan/render_context.h"

// What this context can do beyond GL 3.3 core / GLES 3.0.
typedef struct gl_caps {
    bool es;             // OpenGL ES
    bool compatibility;  // desktop: the compatibility profile, with the fixed functions' state
    bool software;       // llvmpipe, softpipe, swrast
    bool clip_control;   // reversed-Z with [0, 1] clip depth
    bool compute;        // compute shaders, storage buffers, images, and views of textures
    bool timestamps;     // the GPU's clock can be asked
    bool timers;         // and its answers are worth having: not on software GL
    bool bind_units;     // a texture is bound to a unit in one call
    bool float_linear;   // linear filtering of 32F
    bool color_float;    // RGBA16F is renderable (ES 3.0: an extension)
    bool debug;          // KHR_debug
    bool feedback_pause; // transform feedback can be paused
    bool sample_mask, sample_shading, fixed_restart, depth_bounds, query_buffer; // state that a host may have set
    bool buffer_masks;                           // each draw buffer has its own blend switch and colour mask
    bool buffer_blends;                          // and its own blend function and equation
    bool viewport_arrays;                        // each viewport has its own rectangle, scissor and depth range
    int draw_buffers, viewports, clip_distances; // their numbers, at most those of gl_saved
    float max_anisotropy;                        // 1 when absent
    int max_texture_size;
} gl_caps;
gl_caps bolan_gl_get_caps(void); // needs a context that bolan_gl_check_context() accepts
bool bolan_gl_has_context(void); // one is current on this thread
// OK: a context is current, and it is GL 3.3 or ES 3.0 at least. Else GL, and the log says for `whom` what is missing.
bolan_result bolan_gl_check_context(const char *whom);

// Calls of OpenGL by this thread so far.
typedef struct gl_calls {
    uint32_t count;
    uint32_t questions; // of those, the ones that want an answer: a driver with a thread of its own waits for it
} gl_calls;
gl_calls bolan_gl_calls(void);

// ---- textures ----
typedef enum gl_format {
    GL_FMT_R8,
    GL_FMT_RG8,
    GL_FMT_RGBA8,
    GL_FMT_R16F,
    GL_FMT_RG16F,
    GL_FMT_RGBA16F,
    GL_FMT_R32F,
    GL_FMT_RGBA32F,
    GL_FMT_RGBA32UI, // whole numbers: never filtered, cleared by bolan_gl_target_clear_integers()
    GL_FMT_R11G11B10F,
    GL_FMT_DEPTH32F
} gl_format;
typedef enum gl_filter {
    GL_FILTER_NEAREST,
    GL_FILTER_LINEAR,
    GL_FILTER_MIPMAP,
    GL_FILTER_MIPMAP_NEAREST
} gl_filter; // MIPMAP: trilinear; MIPMAP_NEAREST: bilinear in the nearest level
typedef enum gl_wrap {
    GL_WRAP_CLAMP,
    GL_WRAP_REPEAT,
    GL_WRAP_REPEAT_CLAMP
} gl_wrap; // REPEAT_CLAMP: s repeats, t clamps
typedef struct gl_texture {
    uint32_t id, target;
    uint32_t width, height, depth, levels;
    gl_format format;
    bool storage; // compute shaders can write it
} gl_texture;
typedef struct gl_texture_desc {
    gl_format format;
    uint32_t width, height;
    uint32_t depth; // 0: 2D; else 3D, or an array when `array`
    bool array;
    uint32_t levels; // 0: full chain when the filter is a mipmap one, else 1
    bool storage;    // a 2D texture or an array that compute shaders write: only where caps.compute
    gl_filter filter;
    gl_wrap wrap;
    float anisotropy; // 0 or 1: none
} gl_texture_desc;
bolan_result bolan_gl_texture_create(const gl_texture_desc *desc, gl_texture *out);
// Uploads a whole level: floats for *16F/*32F, bytes for *8. `half`: the data are halfs already. layer: -1 all (2D,
// 3D), else one layer/slice.
void bolan_gl_texture_upload(gl_texture *t, uint32_t level, int layer, const void *data, bool half);
void bolan_gl_texture_generate_mipmaps(gl_texture *t);
// A layer of an array with storage as a 2D texture that shares its texels, sampled as `desc` says; free it like others.
void bolan_gl_texture_layer(const gl_texture *array, uint32_t layer, const gl_texture_desc *desc, gl_texture *out);
// Calls of bolan_gl_texture_upload() by this thread so far, and the bytes that they sent.
typedef struct gl_uploads {
    uint32_t count;
    uint64_t bytes;
} gl_uploads;
gl_uploads bolan_gl_uploads(void);
uint32_t bolan_gl_textures_made(void);                          // by this thread so far
void bolan_gl_texture_bind(const gl_texture *t, uint32_t unit); // nothing for a texture that was not made
void bolan_gl_texture_free(gl_texture *t);

// ---- programs ----
// Source is found by stem ("sky" -> shaders/sky.glsl), compiled twice with VERTEX / FRAGMENT defined, "#version 330
// core" or "#version 300 es" + precision put before it, and #include "common/x.glsl" resolved. `defines`: "A 1\nB 2\n"
// or NULL. The uniform block Frame is bound to slot 0. A file is included once per shader. "#pragma unit NAME N" in any
// file sets the sampler NAME to texture unit N, so a pass that includes it need not.
enum { GL_PROGRAM_UNIFORMS = 24, GL_UNIFORM_NAME = 28 };
typedef struct gl_program {
    uint32_t id;
    bool compute;
    char stem[32];
    char defines[160];
    // Uniforms outside the blocks, found when the program is linked.
    struct {
        char name[GL_UNIFORM_NAME];
        int32_t location;
    } uniforms[GL_PROGRAM_UNIFORMS];
    uint32_t uniform_count;
} gl_program;
void bolan_gl_program_set_directory(const char *directory); // NULL: the embedded sources
bolan_result bolan_gl_program_create(const char *stem, const char *defines, gl_program *out);
// A compute shader, compiled with COMPUTE defined, as "430 core" or "310 es": only where caps.compute.
bolan_result bolan_gl_program_create_compute(const char *stem, const char *defines, gl_program *out);
bolan_result bolan_gl_program_reload(gl_program *p); // keeps the old one on failure
uint32_t bolan_gl_programs_compiled(void);           // by this thread so far, for statistics
void bolan_gl_program_use(const gl_program *p);
void bolan_gl_program_int(const gl_program *p, const char *name, int value); // samplers too: the unit
void bolan_gl_program_float(const gl_program *p, const char *name, float value);
void bolan_gl_program_vec2(const gl_program *p, const char *name, float x, float y);
void bolan_gl_program_vec4(const gl_program *p, const char *name, bolan_vec4 v);
void bolan_gl_program_vec4_array(const gl_program *p, const char *name, const float *xyzw, uint32_t count);
void bolan_gl_program_free(gl_program *p);

// ---- targets: framebuffers over our own textures ----
typedef struct gl_target {
    uint32_t id;
    uint32_t width, height;
    gl_texture color; // the first, which the target does not own; id 0: it has none
} gl_target;
// colour may be NULL (count 0); depth may be NULL. layer: slice of a 3D/array texture, the next one for each further
// colour; -1 for 2D; level 0..
bolan_result bolan_gl_target_create(const gl_texture *const *color, uint32_t count, const gl_texture *depth, int layer,
                                    uint32_t level, gl_target *out);
void bolan_gl_target_bind(const gl_target *t); // binds and sets the viewport
void bolan_gl_target_bind_part(const gl_target *t, uint32_t x, uint32_t y, uint32_t width,
                               uint32_t height); // draws go there only
void bolan_gl_target_bind_external(uint32_t framebuffer, uint32_t x, uint32_t y, uint32_t width,
                                   uint32_t height); // the caller's
// From now on only the lowest rows of a target are drawn and cleared, at their own places; 0: all of it.
void bolan_gl_clip_rows(uint32_t rows);
void bolan_gl_target_clear_color(float r, float g, float b, float a);
void bolan_gl_target_clear_integers(void); // the first colour, to 0
void bolan_gl_target_clear_depth(float depth);
void bolan_gl_target_copy_color(const gl_target *from, const gl_target *to);
void bolan_gl_target_copy_depth(const gl_target *from, const gl_target *to); // same size and format
void bolan_gl_target_show(const gl_target *from, uint32_t framebuffer, uint32_t width,
                          uint32_t height);                                            // the caller's, scaled
void bolan_gl_target_read_float(const gl_target *t, uint32_t attachment, float *rgba); // bottom row first
// Top row first. rgba: width * height * 4 bytes of scratch memory.
void bolan_gl_read_rgb8(uint32_t framebuffer, uint32_t width, uint32_t height, uint8_t *rgba, uint8_t *rgb);
void bolan_gl_target_free(gl_target *t);
// What a framebuffer of the caller's is wanted for.
typedef enum gl_purpose { GL_TO_DRAW, GL_TO_READ, GL_TO_COPY } gl_purpose;
// NULL: it will do. Else why not, as the end of a sentence about it. Binds it.
const char *bolan_gl_framebuffer_problem(uint32_t framebuffer, gl_purpose purpose);

// The first color of a target on its way to the CPU, without waiting: see readback.c.
typedef struct gl_readback {
    uint32_t id;
    size_t bytes;
    void *fence; // NULL: nothing is under way
} gl_readback;
bool bolan_gl_readback_is_possible(void);
// Starts a copy, in the place of one that is under way. Leaves the target bound.
void bolan_gl_readback_begin(gl_readback *r, const gl_target *t);
bool bolan_gl_readback_is_under_way(const gl_readback *r);
// True: the copy has come, as from bolan_gl_target_read_float(). False: not yet, or none is under way.
bool bolan_gl_readback_end(gl_readback *r, float *rgba);
void bolan_gl_readback_cancel(gl_readback *r);
void bolan_gl_readback_free(gl_readback *r);

// Reads depth textures, on ES too. What that takes is made at the first reading and kept while the size stays.
typedef struct gl_depth_reader {
    gl_program program;
    gl_texture copy;
    gl_target target;
} gl_depth_reader;
// Bottom row first, a depth in the first of each four floats. Leaves its own target bound.
bolan_result bolan_gl_depth_read(gl_depth_reader *r, const gl_texture *depth, float *rgba);
void bolan_gl_depth_reader_free(gl_depth_reader *r);

// ---- buffers and meshes ----
typedef enum gl_usage { GL_USAGE_STATIC, GL_USAGE_STREAM } gl_usage;
typedef struct gl_buffer {
    uint32_t id;
    size_t size;
    uint32_t kind;
    gl_usage usage;
} gl_buffer;
typedef enum gl_buffer_kind {
    GL_BUFFER_VERTEX,
    GL_BUFFER_INDEX,
    GL_BUFFER_UNIFORM,
    GL_BUFFER_STORAGE // of compute shaders
} gl_buffer_kind;
bolan_result bolan_gl_buffer_create(gl_buffer_kind kind, gl_usage usage, size_t size, const void *data, gl_buffer *out);
void bolan_gl_buffer_update(gl_buffer *b, size_t offset, size_t size,
                            const void *data); // offset 0 orphans a STREAM buffer
void bolan_gl_buffer_bind_uniform(const gl_buffer *b, uint32_t slot);
void bolan_gl_buffer_copy(const gl_buffer *from, size_t from_offset, gl_buffer *to, size_t to_offset, size_t size);
void bolan_gl_buffer_free(gl_buffer *b);
// Memory for uniform blocks that change from draw to draw: see ring.c.
enum { GL_RING_REGIONS = 3 };
typedef struct gl_ring {
    uint32_t id;
    uint32_t filling; // the region that is filled now
    size_t region;    // bytes of each
    size_t used;      // of that region
    size_t alignment; // of what is put
    uint8_t *mapped;  // NULL: it cannot stay mapped
    void *fences[GL_RING_REGIONS];
} gl_ring;
// Bytes that were put into a ring: they stay until as much as two regions is put after them.
typedef struct gl_range {
    uint32_t buffer;
    size_t offset, size; // size 0: nothing was put
} gl_range;
bolan_result bolan_gl_ring_create(size_t region, gl_ring *out);
gl_range bolan_gl_ring_put(gl_ring *r, const void *data, size_t bytes);
void bolan_gl_range_bind_uniform(const gl_range *range, uint32_t slot);
// The GPU copies bytes of a buffer that it wrote over a part of the range.
void bolan_gl_range_patch(const gl_range *to, size_t to_offset, const gl_buffer *from, size_t from_offset, size_t size);
void bolan_gl_ring_free(gl_ring *r);

// Float attributes, interleaved: components[i] floats at location i. Indices are uint32.
typedef struct gl_mesh {
    uint32_t vao;
} gl_mesh;
bolan_result bolan_gl_mesh_create(const gl_buffer *vertices, const gl_buffer *indices, const uint8_t *components,
                                  uint32_t attributes, uint32_t stride, gl_mesh *out);
// Adds the interleaved floats of another buffer, from location `first` on.
void bolan_gl_mesh_attach(gl_mesh *m, const gl_buffer *vertices, uint32_t first, const uint8_t *components,
                          uint32_t attributes, uint32_t stride);
// Likewise of floats that each instance has once.
void bolan_gl_mesh_attach_instances(gl_mesh *m, const gl_buffer *instances, uint32_t first, const uint8_t *components,
                                    uint32_t attributes, uint32_t stride);
void bolan_gl_mesh_draw(const gl_mesh *m, uint32_t first_index, uint32_t index_count);
void bolan_gl_mesh_draw_instances(const gl_mesh *m, uint32_t index_count, uint32_t instances);
void bolan_gl_mesh_draw_lines(const gl_mesh *m, uint32_t index_count); // two indices a line, one pixel wide
void bolan_gl_mesh_free(gl_mesh *m);
void bolan_gl_draw_fullscreen(void); // 3 vertices from gl_VertexID, no buffers: see common/fullscreen.glsl

// ---- compute: only where caps.compute ----
enum { GL_STORAGE_SLOTS = 4, GL_IMAGES = 4 }; // that every context with compute shaders has
// The caller's bindings of storage buffers and images, which bolan_gl_save() leaves alone.
typedef struct gl_compute_saved {
    int32_t buffer, arguments, slot[GL_STORAGE_SLOTS];
    int64_t offset[GL_STORAGE_SLOTS], size[GL_STORAGE_SLOTS];
    struct {
        int32_t name, level, layered, layer, access, format;
    } image[GL_IMAGES];
} gl_compute_saved;
void bolan_gl_compute_begin(gl_compute_saved *s);
void bolan_gl_compute_end(const gl_compute_saved *s);
void bolan_gl_storage_bind(const gl_buffer *b, uint32_t slot);
// Binds all layers of a level, to be written.
void bolan_gl_image_bind(const gl_texture *t, uint32_t level, uint32_t slot);
void bolan_gl_dispatch(uint32_t x, uint32_t y, uint32_t z);
// The numbers of groups stand in the buffer that is bound, three whole numbers from `offset` on, a multiple of 4.
void bolan_gl_arguments_bind(const gl_buffer *b);
void bolan_gl_dispatch_indirect(size_t offset);
// What is written before can be read after: storage buffers by shaders; they, also as arguments of a dispatch; textures
// by shaders; all by everything.
typedef enum gl_barrier { GL_BARRIER_STORAGE, GL_BARRIER_ARGUMENTS, GL_BARRIER_TEXTURES, GL_BARRIER_ALL } gl_barrier;
void bolan_gl_wait_for(gl_barrier what);

// ---- state ----
typedef struct gl_state {
    bool depth_test, depth_write, cull_back, color_write;
    enum { GL_BLEND_NONE, GL_BLEND_ALPHA, GL_BLEND_ADD, GL_BLEND_PREMULTIPLIED, GL_BLEND_MULTIPLY } blend;
    bool depth_equal, depth_less;
} gl_state; // depth test: greater-or-equal (reversed-Z), or equal, or less-or-equal
void bolan_gl_set_state(const gl_state *s);
void bolan_gl_set_clip_zero_to_one(bool on); // only where caps.clip_control
void bolan_gl_set_framebuffer_srgb(
    bool on); // desktop: let an sRGB framebuffer encode what is written; on ES it always does

// The caller's state: see saved.c.
enum { GL_UNIFORM_SLOTS = 5 }; // of the blocks Frame, View, Water, Optics and Bounds
enum { GL_SAVED_UNITS = 29, GL_SAVED_BUFFERS = 8, GL_SAVED_VIEWPORTS = 16, GL_SAVED_CLIPS = 8, GL_SAVED_SLOTS = 32 };
typedef struct gl_saved {
    const gl_caps *caps;
    bolan_restore restore;
    const bolan_gl_state *declared;
    int32_t draw_framebuffer, read_framebuffer, program, vertex_array, array_buffer;
    int32_t uniform_buffer, uniform_slot[GL_UNIFORM_SLOTS], pixel_pack, pixel_unpack, query_buffer;
    int64_t uniform_offset[GL_UNIFORM_SLOTS], uniform_size[GL_UNIFORM_SLOTS];
    int32_t active_unit, textures[GL_SAVED_UNITS][3], samplers[GL_SAVED_UNITS];
    struct {
        bool blend;
        uint8_t mask[4];
        int32_t factors[4], equations[2];
    } buffers[GL_SAVED_BUFFERS];
    struct {
        bool scissor;
        float rectangle[4];
        int32_t box[4];
        double depth[2];
    } viewports[GL_SAVED_VIEWPORTS];
    bool toggles[GL_SAVED_SLOTS], clips[GL_SAVED_CLIPS], feedback;
    int32_t cull_mode, front_face, depth_function, polygon_mode[2], provoking, clip_origin, clip_depth, clamp[3];
    uint8_t depth_mask;
    double depth_clear;
    float color_clear[4], line_width, transfer[GL_SAVED_SLOTS];
    int32_t pixel_store[GL_SAVED_SLOTS];
    struct { // the caller's, while `on`; of the caller's debug output
        bool on, output, synchronous;
        void *callback, *user;
    } debug;
} gl_saved;
// `debug`: until bolan_gl_restore() the driver's messages are logged, and handed on to the caller's callback. Both need
// a context; *s must stay where it is in between.
void bolan_gl_save(gl_saved *s, const gl_caps *caps, bool debug);
void bolan_gl_restore(const gl_saved *s);
// Begins and ends a call that treats the caller's state as `restore` says: bolan_gl_save() and bolan_gl_restore(), or
// without a question. `declared` may be NULL but for BOLAN_RESTORE_DECLARED. Nobody else may call OpenGL in between:
// what would change nothing is not called. `empty`: a mesh without buffers, zeroed before the first call, for
// bolan_gl_draw_fullscreen(); the caller frees it.
void bolan_gl_enter(gl_saved *s, const gl_caps *caps, bolan_restore restore, const bolan_gl_state *declared, bool debug,
                    gl_mesh *empty);
void bolan_gl_leave(const gl_saved *s);
// Between the two: the state may be asked for, and what is asked for is put back.
bool bolan_gl_may_ask(void);

// Names of the caller's that were checked and need not be again.
enum { GL_KNOWN_NAMES = 32 };
typedef enum gl_known_kind {
    GL_KNOWN_NOTHING,
    GL_KNOWN_FRAMEBUFFER, // can be drawn into
    GL_KNOWN_STENCIL,     // a framebuffer that has one
    GL_KNOWN_2D,
    GL_KNOWN_MULTISAMPLED,
    GL_KNOWN_CUBE
} gl_known_kind;
typedef struct gl_known {
    struct {
        uint32_t kind, name;
    } entries[GL_KNOWN_NAMES];
    uint32_t next;
} gl_known;
// The last GL_KNOWN_NAMES stay.
void bolan_gl_know(gl_known *k, gl_known_kind kind, uint32_t name);
bool bolan_gl_knows(const gl_known *k, gl_known_kind kind, uint32_t name);

// Leaves out what the stencil of a framebuffer excludes: see bolan_host::stencil. What is set comes back with end().
typedef struct gl_stencil {
    int32_t function[2], reference[2], mask[2], operations[2][3]; // front, back
} gl_stencil;
void bolan_gl_stencil_begin(gl_stencil *saved, uint8_t reference, uint8_t mask);
void bolan_gl_stencil_end(const gl_stencil *saved);
bool bolan_gl_has_stencil(uint32_t framebuffer);

// ---- textures and programs of the host's ----
typedef struct gl_sampler {
    uint32_t id;
} gl_sampler;
// Without levels, clamped, no comparison, linear or nearest: whatever the texture itself says.
void bolan_gl_sampler_create(gl_sampler *out, bool linear);
void bolan_gl_sampler_free(gl_sampler *s);
bool bolan_gl_is_cube(uint32_t name); // a cube map of this context
// Binds the host's cube map, and returns what was bound; bolan_gl_cube_unbind() puts that back, without a sampler.
uint32_t bolan_gl_cube_bind(uint32_t name, const gl_sampler *sampler, uint32_t unit);
void bolan_gl_cube_unbind(uint32_t before, uint32_t unit);
bool bolan_gl_is_2d(uint32_t name);           // a 2D texture of this context
bool bolan_gl_is_multisampled(uint32_t name); // a multisampled one; false on ES
// Binds a multisampled texture, and returns what was bound; bolan_gl_multisampled_unbind() puts that back.
uint32_t bolan_gl_multisampled_bind(uint32_t name, uint32_t unit);
void bolan_gl_multisampled_unbind(uint32_t before, uint32_t unit);
void bolan_gl_guest_texture_bind(uint32_t name, uint32_t unit, const gl_sampler *sampler); // 2D; NULL: no sampler

// NULL: this context has `count` texture units from `first` on, and this uniform buffer slot. Else the reason.
const char *bolan_gl_guest_slots(uint32_t count, uint32_t first, uint32_t slot);
// NULL: the sampler names are set to units from `first` on, the block to `slot`. Else the reason why not. Leaves the
// program in use as it was.
const char *bolan_gl_guest_link(uint32_t program, const char *block, const char *const *samplers, uint32_t count,
                                uint32_t first, uint32_t slot);
// Binds textures to units from `first` on, without sampler objects, and a uniform buffer to `slot`, for the host: they
// stay. Textures that were not made are left out. Leaves the active unit and the generic buffer binding as they were.
void bolan_gl_guest_bind(const gl_texture *const *textures, uint32_t count, uint32_t first, const gl_buffer *block,
                         uint32_t slot);

// ---- timers: the GPU's clock read at both ends, or the CPU's between two glFinish() ----
// Unlike GL_TIME_ELAPSED, timestamps do not collide with a query that the caller has open.
enum { GL_TIMER_SLOTS = 4 }; // frames that a result may take to come
typedef struct gl_timer {
    uint32_t query[GL_TIMER_SLOTS][2];
    bool pending[GL_TIMER_SLOTS], running;
    int next, oldest;
    double ms;
    double cpu_start;
} gl_timer;
typedef enum gl_timing { GL_TIMING_OFF, GL_TIMING_GPU, GL_TIMING_FINISH } gl_timing;
void bolan_gl_timer_begin(gl_timer *t, gl_timing how);
void bolan_gl_timer_end(gl_timer *t, gl_timing how); // ms: the last result that has come; 0 while there is none
void bolan_gl_timer_free(gl_timer *t);
void bolan_gl_finish(void);
#endif
