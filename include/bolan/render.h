// SPDX-License-Identifier: MIT
/// @file render.h
/// Tier 4, library bolan_render. Draws worlds, or the water alone, with OpenGL 3.3 core or OpenGL ES 3.0 in the
/// caller's context, or in one of render_context.h.
///
/// **State.** Each function here that touches your context leaves this state as it found it, whatever it was, unless
/// bolan_renderer_desc::restore says otherwise:
/// - framebuffer bindings, program, vertex array;
/// - buffers bound for vertices, uniforms, pixels and queries, uniform slots 0 to 4;
/// - with BOLAN_BACKEND_COMPUTE or BOLAN_PIXELS_COMPUTE the bindings of a storage buffer and of a buffer for indirect
///   dispatches, storage buffer slots 0 to 3 and image units 0 to 3;
/// - the active texture unit, and textures (2D, 3D, 2D array) and samplers of units 0 to 28;
/// - viewports, scissors and depth ranges of all viewports (arrays of them on desktop OpenGL);
/// - blend switch, function and equation, and colour mask, of each draw buffer; logic op, dither, sRGB switch;
/// - depth test, function, mask, clear value and clamp, clip control, clip distances, depth bounds test, stencil test,
///   function and operations;
/// - cull face, front face, polygon mode (both of the compatibility profile's), offset, smoothing and stipple, line
///   width, provoking vertex;
/// - sample coverage, sample mask, sample shading, alpha to coverage and to one, alpha test, rasterizer discard,
///   primitive restart, clear colour, colour clamping, pixel store, pixel transfer;
/// - transform feedback, which is paused meanwhile. OpenGL 3.3 without ARB_transform_feedback2 cannot pause it: end it
///   before.
///
/// **Errors of OpenGL.** No function asks for the error flag: an error of yours that is pending stays for you to find.
/// What a function refuses it logs, and it leaves no error behind, unless the driver itself runs out of memory.
///
/// **Queries.** A query of yours that is open goes on and counts what is drawn here.
/// Call nothing between glBeginConditionalRender() and glEndConditionalRender(): OpenGL does not tell whether it would
/// draw.
/// A program that you deleted while it is in use is lost.
///
/// **Threads.** All calls of one renderer belong on the thread where its context is current.
///
/// **Frames.** The calls of a frame (prepare, draw, read, show) return nothing. What they refuse they leave undone, and
/// the log says why, once.
#ifndef BOLAN_RENDER_H
#define BOLAN_RENDER_H

#include "bolan/render_context.h"
#include "bolan/scene.h"
#include "bolan/tiles.h"
#include "bolan/water.h"
#include "bolan/world.h"

#ifdef __cplusplus
extern "C" {
#endif

// ---- the renderer ---------------------------------------------------------------------------------------------------

/// The programs, tables and targets that draw in one context.
typedef struct bolan_renderer bolan_renderer;

/// How a renderer is made.
typedef struct bolan_renderer_desc {
    /// Default MEDIUM.
    bolan_quality quality;
    /// Default AUTO.
    /// COMPUTE takes OpenGL 4.3, or OpenGL ES 3.1 with EXT_texture_view or OES_texture_view.
    bolan_backend backend;
    /// Default AUTO. COMPUTE takes what BOLAN_BACKEND_COMPUTE takes.
    bolan_pixels pixels;
    /// Most vertices of the water on BOLAN_SURFACE_PROJECTED, 1024..1000000, whatever the quality and the size of the
    /// image. 0 (default): as the quality has it. Raised: smaller triangles, down to what the quality asks for.
    uint32_t max_vertices;
    /// What calls of this renderer do with your state; default BOLAN_RESTORE_FULL.
    /// FULL asks OpenGL some hundreds of questions in each call: a driver with a thread of its own makes you wait.
    /// DECLARED and NONE ask none. In exchange:
    /// - textures of units 0 to 28 and uniform slots 0 to 4 stay as the call leaves them, and sampler objects of these
    ///   units are unbound; with BOLAN_BACKEND_COMPUTE or BOLAN_PIXELS_COMPUTE also storage buffers and images of slots
    ///   0 to 3 and the buffer for indirect dispatches stay;
    /// - no transform feedback is active in a call;
    /// - the names of your framebuffers and textures are checked when they first come, and not again: change
    ///   bolan_renderer_desc::restore to FULL while you look for a wrong name;
    /// - after a bolan_host with `stencil_mask` the functions and operations of the stencil are OpenGL's initial ones.
    /// Creating, reloading, and reading back ask in any case.
    bolan_restore restore;
    /// Folder from which shaders are read, and again by bolan_renderer_reload(). NULL (default): the built-in shaders.
    /// Copied; at most 1023 characters.
    const char *shader_directory;
    /// True: the path without clip control is taken also where the context has it, for tests. Default false.
    bool no_clip_control;
    /// True: GPU timers are used also on software OpenGL, where their times mean little, for tests. Default false.
    bool force_timers;
    /// True: the driver's debug messages are logged while a call of this renderer runs. A callback of yours gets them
    /// too, and is the only one again afterwards. False (default): debug output is left alone.
    bool debug;
} bolan_renderer_desc;

/// The defaults named above.
/// Thread-safe.
BOLAN_API bolan_renderer_desc bolan_renderer_desc_default(void);

/// Makes a renderer in the current context.
/// @param out receives the renderer; NULL after an error.
/// Errors: GL (no context, one older than OpenGL 3.3 or OpenGL ES 3.0, a shader that does not compile), ARGUMENT (a
/// field out of range), UNSUPPORTED (OpenGL ES without float targets; BOLAN_BACKEND_COMPUTE or BOLAN_PIXELS_COMPUTE
/// in a context without compute shaders), MEMORY.
BOLAN_API bolan_result bolan_renderer_create(const bolan_renderer_desc *desc, bolan_renderer **out);

/// With BOLAN_RESTORE_DECLARED: your state when a call begins, which is put back when it ends.
/// Call it whenever the state at the place of your frame where Bolan is called has changed. Copied.
/// Until the first call it is bolan_gl_state_default().
BOLAN_API void bolan_renderer_declare_state(bolan_renderer *renderer, const bolan_gl_state *state);

/// Returns the backend that the renderer uses: CPU or COMPUTE.
/// Thread-safe.
BOLAN_API bolan_backend bolan_renderer_backend(const bolan_renderer *renderer);

/// Returns what the renderer shades pixels with: FRAGMENT or COMPUTE.
/// Thread-safe.
BOLAN_API bolan_pixels bolan_renderer_pixels(const bolan_renderer *renderer);

/// Releases the renderer.
/// The context must be current. Without one the log says so, and only the memory of the CPU is released: that of the
/// GPU goes with its context.
/// NULL-safe; NULLs the pointer.
BOLAN_API void bolan_renderer_destroy(bolan_renderer **renderer);

/// Compiles all shaders again from shader_directory, those of its view caches too.
/// Errors: GL (a shader that does not compile; the old programs stay).
BOLAN_API bolan_result bolan_renderer_reload(bolan_renderer *renderer);

// ---- light from your engine -----------------------------------------------------------------------------------------

/// Sky and sun of yours, in place of Bolan's.
/// Radiance and irradiance are in units of yours, which the linear output has too.
typedef struct bolan_environment {
    /// GL name of a complete cube map of linear radiance, without the sun's disc; its first level is read.
    /// 0 (default): Bolan's own sky and sun, and the other fields have no effect.
    uint32_t cube;

    /// Change this number whenever the contents of `cube` have changed: the environment map of the water is made anew.
    uint64_t serial;

    /// From the world to the axes of the cube map: a rotation.
    /// Default the identity: the face +x looks east, +y north, +z up.
    bolan_mat4 turn;

    /// Unit vector to the sun.
    bolan_vec3 sun_direction;

    /// Irradiance of the sun at the sea, on a surface that faces it; 0: no sun.
    bolan_vec3 sun_irradiance;

    /// Irradiance of the sky on a horizontal surface.
    /// A negative x (default -1): the integral over the upper half of the cube.
    bolan_vec3 sky_irradiance;
} bolan_environment;

/// The defaults named above.
/// Thread-safe.
BOLAN_API bolan_environment bolan_environment_default(void);

/// Who adds the haze between the eye and the water.
typedef enum bolan_haze_kind {
    /// Bolan: its clear air over a round earth, of the visibility of bolan_sky.
    BOLAN_HAZE_AIR,
    /// Bolan, by the numbers of bolan_haze.
    BOLAN_HAZE_GIVEN,
    /// Nobody, or you after the water.
    BOLAN_HAZE_NONE,
} bolan_haze_kind;

/// Haze: light L from a distance d arrives as L e^(-extinction d) + radiance (1 - e^(-extinction d)).
typedef struct bolan_haze {
    /// Default BOLAN_HAZE_AIR.
    bolan_haze_kind kind;
    /// Radiance of endless haze, >= 0; for BOLAN_HAZE_GIVEN.
    bolan_vec3 radiance;
    /// Extinction [1/m], >= 0; for BOLAN_HAZE_GIVEN.
    bolan_vec3 extinction;
} bolan_haze;

// ---- a step: prepared once, drawn from any number of views ----------------------------------------------------------

/// How the water and the world are lit and shaded.
typedef struct bolan_lighting {
    /// Sun, air and clouds.
    bolan_sky sky;
    /// Exposure over the automatic one [stops], -10..10; default 0.
    double exposure;
    /// The surface and the optics are read; `waves` must be the wave model of the sea.
    bolan_technique technique;
    /// Shading options.
    bolan_look look;
    /// Sky and sun of yours; default: Bolan's.
    bolan_environment environment;
    /// Haze between the eye and the water; default: Bolan's air.
    bolan_haze haze;
} bolan_lighting;

/// The sky, technique and shading options of bolan_scene_default().
/// Thread-safe.
BOLAN_API bolan_lighting bolan_lighting_default(void);

/// The sky, technique and shading options of @p scene.
/// Thread-safe.
BOLAN_API bolan_lighting bolan_lighting_from_scene(const bolan_scene *scene);

/// Seas whose fields a renderer keeps on the GPU.
/// The fields of a further sea take the place of those that were prepared the longest time ago.
#define BOLAN_KEPT_SEAS 4

/// Takes a step of the water: uploads its fields unless those of the same serial are on the GPU already.
/// An unchanged step uploads nothing: see bolan_frame_statistics::uploads.
/// The fields of the last BOLAN_KEPT_SEAS seas stay on the GPU, so that several waters may take turns in each frame.
/// Every view that is drawn until the next call shows this step.
/// @p water and what it points to are borrowed until then.
/// No current context, a sea that is NULL or of another wave model than `lighting.technique.waves`, a number out of
/// range: nothing is prepared, and the log says why, once.
BOLAN_API void bolan_renderer_prepare(bolan_renderer *renderer, const bolan_water *water,
                                      const bolan_lighting *lighting);

/// Compiles the programs that views of this water with this lighting can need, whatever their eye: over the open sea
/// and over ground, in a world and in a host's frame, with and without bounds.
/// Without this call each of them is compiled by the first view that can need it.
/// @param progress is called after each program; may be NULL. @p user is handed to it.
/// Errors: GL (no current context, a shader that does not compile), ARGUMENT (as bolan_renderer_prepare() refuses),
/// MEMORY.
BOLAN_API bolan_result bolan_renderer_compile(bolan_renderer *renderer, const bolan_water *water,
                                              const bolan_lighting *lighting, bolan_progress *progress, void *user);

// ---- a view ---------------------------------------------------------------------------------------------------------

/// What belongs to one eye: tables of the sky, clouds, the tree of the ground, the shore map.
/// Views whose eyes are far apart need one each, or they make these anew for each picture.
/// Its programs are the renderer's: a cache costs memory and no compilation.
/// Belongs to its renderer and to its context.
typedef struct bolan_view_cache bolan_view_cache;

/// Makes an empty cache.
/// @param out receives the cache; NULL after an error.
/// Errors: GL, MEMORY.
BOLAN_API bolan_result bolan_view_cache_create(bolan_renderer *renderer, bolan_view_cache **out);

/// Releases the cache.
/// The context must be current. Call it before the renderer is destroyed.
/// NULL-safe; NULLs the pointer.
BOLAN_API void bolan_view_cache_destroy(bolan_view_cache **cache);

/// What is written into the framebuffer.
typedef enum bolan_output {
    /// Tone-mapped, encoded as sRGB by the shader; default.
    BOLAN_OUTPUT_SRGB,
    /// Tone-mapped, and the framebuffer encodes sRGB itself (GL_FRAMEBUFFER_SRGB is switched on meanwhile).
    BOLAN_OUTPUT_SRGB_FRAMEBUFFER,
    /// Linear radiance without tone map and dither, relative to a sun irradiance of 1 in space at normal incidence.
    BOLAN_OUTPUT_LINEAR,
} bolan_output;

/// Guard band of a tile [px], and what its corners are multiples of.
#define BOLAN_TILE_STEP 64

/// One picture of a step: eye, frustum and target. Axes of the camera: x right, y up; it looks along -z, or along +z
/// where the last row of the projection is 0 0 1 0.
typedef struct bolan_view {
    /// Place of the eye in the world [m], z above the datum. It is never moved.
    bolan_dvec3 eye;
    /// World to camera: a rotation; its translation is ignored, since the eye is `eye`. Column-major.
    bolan_mat4 view;
    /// Camera to clip: any perspective, off-centre, standard or reversed, finite or infinite. Of the whole picture
    /// where `tile` is set. Bolan keeps a depth buffer of its own, so that the z row matters only to a host's depth.
    bolan_mat4 projection;
    /// True: clip depth of `projection` is [0,1], as glClipControl(GL_ZERO_TO_ONE) has it. False (default): [-1,1].
    bool zero_to_one;
    /// GL name; 0 (default) is the window. Complete, with a colour buffer that holds no integers.
    uint32_t framebuffer;
    /// Lower left corner of the rectangle that is drawn [px]; default 0, 0.
    uint32_t x, y;
    /// Its size [px], 1..16384; default 1280 x 720.
    uint32_t width, height;
    /// Moves the picture right and up by parts of a pixel; default 0, 0.
    /// Geometry and footprints are those of the view without it, and motion vectors leave it out.
    bolan_vec2 jitter;
    /// Motion vectors, for temporal antialiasing or an upscaler of yours.
    struct bolan_view_motion {
        /// GL name of a framebuffer: red and green of its first colour buffer, of floats, receive the motion of each
        /// pixel of the view's rectangle; blue and alpha are undefined. 0 (default): none.
        /// The vector points from where a pixel's surface stands in this image to where it stood in the one before
        /// [px of this view], x right, y up. Both places are those without jitter: a still world has 0.
        /// - bolan_renderer_draw_world() writes every pixel, bolan_renderer_draw_water() those that show its water.
        ///   bolan_host::stencil_mask and the depth of the framebuffer have no effect on it.
        /// - Water of the wave models FFT and TEXTURES moves with its parcels, waves and current included.
        ///   Wave layers, sums of cosines, the surface QUAD, and water seen from below have the camera's motion alone.
        /// - Objects move by their poses of both steps, land and sky by the camera alone.
        /// - What is reflected or refracted has the motion of the water's surface.
        ///
        /// The first view that asks for it compiles programs.
        uint32_t framebuffer;
        /// The view of the frame before: its eye, view and projection are read. Borrowed for the call.
        /// NULL (default): the camera has not moved.
        const struct bolan_view *before;
        /// Time of the sea in the frame before [s]; default 0.
        /// A renderer keeps the last two steps of each sea, from the first view with motion on.
        /// At a time that is neither of those, water and objects have the camera's motion alone.
        double time;
    } motion;
    /// True: temporal antialiasing; not with `accumulate`. Default false.
    /// Each view has a jitter of its own, besides `jitter`, and is blended with the views before it that were drawn
    /// with the same `cache`; motion vectors bring those to their places.
    /// The image is a function of the sequence of views. Display values are blended, as by `samples`, so that a glint
    /// does not outshine its pixel. While nothing changes the image tends to that of 64 samples.
    /// Only bolan_renderer_draw_world() blends. BOLAN_OUTPUT_LINEAR and bolan_renderer_read_linear() have the last view
    /// alone.
    bool temporal;
    /// This picture is the rectangle at x, y (from the lower left) of a whole picture of that size [px]; default all
    /// 0: it is the whole.
    /// Sky and water of tiles are those of the whole to one level of 255.
    /// Reflections of land and objects, refraction, glow and half-rate shading read the image round a pixel: overlap
    /// the tiles by a guard band of BOLAN_TILE_STEP, twice that with glow (from BOLAN_QUALITY_HIGH on), and cut it off.
    /// Let x and y be multiples of BOLAN_TILE_STEP. A reflection of what stands outside tile and guard is that of the
    /// sky.
    struct bolan_view_tile {
        uint32_t x, y, whole_width, whole_height;
    } tile;
    /// Supersampling: pictures with shifted pixels that are averaged, 1..256; default 1.
    uint32_t samples;
    /// True: the samples of this view are added to those of the views before it, and the mean of all is written, for
    /// an image that gets finer while nothing changes. Default false.
    /// Shifts go on where the last view left off: 64 views of one sample show what one view of 64 samples shows.
    /// The first view after one without it, of another size, another output or a host begins anew, and so must you
    /// after any change: draw one view without it. A renderer holds one such sum, of 64 bytes a pixel.
    /// Distances and surfaces that are read back are those of the last sample, not of the pixels' middles.
    bool accumulate;
    /// Default BOLAN_OUTPUT_SRGB.
    bolan_output output;
    /// False (default): the picture is a function of step and view alone, whatever was drawn before.
    /// True: new clouds and new ground are made over several frames, so that a moving eye never waits; until they are
    /// done the old ones are shown. Exposure and light of the sky are those of an earlier frame, unless the sun has
    /// turned by more than 1 degree since: no frame waits for the GPU to measure them. For windows.
    bool progressive;
    /// True: bolan_renderer_draw_world() draws all but the water. False (default): the water too.
    bool without_water;
    /// NULL (default): the renderer's own.
    bolan_view_cache *cache;
} bolan_view;

/// The defaults named above, 10 m over the datum, looking north with a vertical field of view of 50 degrees.
/// Thread-safe.
BOLAN_API bolan_view bolan_view_default(void);

/// The view of @p camera into a picture of that size, into the window.
/// Thread-safe.
BOLAN_API bolan_view bolan_view_from_camera(const bolan_camera *camera, uint32_t width, uint32_t height);

// ---- a whole world --------------------------------------------------------------------------------------------------

/// Prepares the step of @p world and draws all of it, sky, ground, objects and water, from @p view.
/// An unchanged step is not uploaded again, so that any number of views may follow.
/// The view's rectangle of the first draw buffer is overwritten with sky, land, objects and water, alpha 1. Depth and
/// stencil of your framebuffer are neither read nor written, and nothing outside the rectangle is touched.
/// The eye is never moved: bolan_world_clear_eye() keeps one out of the waves.
/// After the first frames nothing is allocated unless the size, the ground or the sea changes.
/// A view or framebuffer that cannot be drawn, no current context: nothing is drawn, and the log says why, once.
BOLAN_API void bolan_renderer_draw_world(bolan_renderer *renderer, const bolan_world *world, const bolan_view *view);

// ---- into a host's frame --------------------------------------------------------------------------------------------

/// Most corners of bolan_host::bounds.
#define BOLAN_MAX_BOUNDS 64

/// A host's frame, as it stands in the view's rectangle before the water is drawn.
typedef struct bolan_host {
    /// GL name of a 2D texture with the scene's linear radiance. 0 (default), with `depth` 0: nothing is seen through
    /// the water or reflected in it, and the depth buffer of the framebuffer alone hides it.
    uint32_t color;
    /// GL name of a 2D texture with the scene's window depth, made with the view's projection and a depth range of
    /// [0,1]. Both may be attached to the view's framebuffer.
    uint32_t depth;
    /// Samples a pixel of `color` and `depth`; 0 (default) or 1: 2D textures.
    /// More: multisampled 2D textures, of which the farthest sample of a pixel is read, so that the water reaches under
    /// every edge of the host's objects. OpenGL ES 3.0 has none: there draw with resolved copies, whose edges may show
    /// what stood behind the water.
    uint32_t samples;
    /// Lower left corner of the view's rectangle in these textures and the mask [px]; default 0, 0.
    uint32_t x, y;
    /// The host's radiance over Bolan's, where the sun's irradiance in space is 1 at normal incidence; 0 (default): 1.
    /// With bolan_lighting::environment Bolan's radiance is the host's.
    double radiance;
    /// GL name of a 2D texture: no water where its red is above 0.5, as inside a hull. 0 (default): water everywhere.
    uint32_t mask;
    /// No water where the framebuffer's stencil equals `stencil` in the bits of `stencil_mask`, sample by sample.
    /// The stencil is read and not written. A `stencil_mask` of 0 (default): the stencil has no effect.
    uint8_t stencil, stencil_mask;
    /// GL name of a 2D depth texture of the host's objects as the sun sees them; 0 (default): none.
    /// Where it holds less than a place's own depth, the light of the sun is missing on the water and in it.
    /// BOLAN_OPTICS_PHYSICAL alone reads it; with another optics it is refused.
    uint32_t shadow;
    /// From the world relative to the eye [m] to the map: x and y in [0,1] across it, z its depth, from 0 nearest the
    /// sun. What falls outside the map is lit.
    bolan_mat4 shadow_matrix;
    /// Subtracted from a place's depth, against shadows of the map's own steps; default 0.
    float shadow_bias;
    /// Corners of the polygon in which the water lies, in the world [m], in either sense; borrowed for the call.
    /// The surface is cut where it crosses the sides.
    const bolan_dvec2 *bounds;
    /// 3..BOLAN_MAX_BOUNDS, or 0 (default): the water has no end.
    uint32_t bounds_count;
} bolan_host;

/// The defaults named above.
/// Thread-safe.
BOLAN_API bolan_host bolan_host_default(void);

/// Draws the prepared water, and nothing else, into the view's rectangle.
/// The water is tested against the depth of the view's framebuffer, sample by sample, and writes depth there, in the
/// convention of the view's projection: less-or-equal, or greater-or-equal where depth is reversed.
/// The host's scene is refracted, absorbed and mirrored (screen-space) through its two textures.
/// @p host may be NULL: the defaults.
/// bolan_view::samples is not used: draw with `jitter`, or into a multisampled framebuffer, where each sample has its
/// own test and the water one colour a pixel.
/// Several waters: prepare one and draw it, then the next.
/// No step prepared, a view, texture or polygon that is none, no current context: nothing is drawn, and the log says
/// why, once.
BOLAN_API void bolan_renderer_draw_water(bolan_renderer *renderer, const bolan_view *view, const bolan_host *host);

// ---- baked light ----------------------------------------------------------------------------------------------------

/// Whether the last frame showed something that was baked for another light.
/// Only the optics MIRROR bakes: loops of its waves with the light on the bottom.
/// It bakes them when a frame with another sea, water or mode is prepared, and again when the sun has turned by 8
/// degrees. A view with bolan_view.progressive never bakes for the sun: it keeps the old light, and this returns true.
BOLAN_API bool bolan_renderer_needs_baking(const bolan_renderer *renderer);

/// Lets the next view bake, which takes up to some seconds.
BOLAN_API void bolan_renderer_bake(bolan_renderer *renderer);

// ---- reading back ---------------------------------------------------------------------------------------------------

/// Reads radiance and distance of the last view.
/// @param rgb linear radiance before the tone map, relative to a sun irradiance of 1 in space at normal incidence; the
/// mean over the view's samples. width * height * 3 floats, or NULL.
/// @param distance from the eye along the view axis, at the middle of the pixel [m]; infinity is the sky.
/// width * height floats, or NULL.
/// Row 0 is at the top.
/// Before the first view, or without a context, the buffers are left alone, logged once.
/// Allocates only where the view is larger than all that were read before.
BOLAN_API void bolan_renderer_read_linear(bolan_renderer *renderer, float *rgb, float *distance);

/// What stands at a pixel.
typedef enum bolan_label {
    BOLAN_LABEL_SKY,
    BOLAN_LABEL_WATER,
    /// Water that foams: its Jacobian, bolan_query_point::jacobian, is below bolan_sea_foam_threshold().
    BOLAN_LABEL_FOAM,
    /// The ground, dry or seen without water before it.
    BOLAN_LABEL_LAND,
    /// The first object of the scene; object i is BOLAN_LABEL_OBJECT + i.
    BOLAN_LABEL_OBJECT,
} bolan_label;

/// Where bolan_renderer_read_surfaces() writes: width * height elements each, row 0 at the top, or NULL.
typedef struct bolan_surfaces {
    /// bolan_label, or BOLAN_LABEL_OBJECT + index of an object.
    uint32_t *label;
    /// Unit normal in world axes; 0 at the sky. Of water: bolan_query_surface() at the place of the pixel, where the
    /// picture's own normal is low-passed to the pixel. Of land: the map that shades it. Of objects: their vertices'.
    bolan_vec3 *normal;
    /// Velocity of the water at the surface, by bolan_query_motion() [m/s]; 0 at sky, land and objects. Needs `flow`.
    bolan_vec3 *motion;
    /// The flow at the time of the world's sea: bolan_flow_step(). NULL where `motion` is.
    const bolan_flow *flow;
} bolan_surfaces;

/// Reads what stands at the middle of each pixel of the last view, which bolan_renderer_draw_world() has drawn of
/// @p world and @p view. Draws land and objects once more, without light, into a target of its own; no picture changes.
/// The eye is above the level of the water. Water that is seen before land is water, however shallow.
/// The places are those of a flat earth; within 1 km of the eye its curvature moves them by less than 0.1 m of height.
/// Before such a view, of another size, with `motion` and without `flow`, or from below the level, the buffers are left
/// alone, logged once. Allocates.
BOLAN_API void bolan_renderer_read_surfaces(bolan_renderer *renderer, const bolan_world *world, const bolan_view *view,
                                            const bolan_surfaces *out);

/// Draws the sky of the prepared step as an equirectangular map, for an eye at @p eye [m], and reads it.
/// Column i looks to the compass direction 360 ((i + 0.5) / width - 0.5) degrees, row j to the elevation
/// 180 (0.5 - (j + 0.5) / height). Clouds are in it, the sun's disc is not; directions below the horizon have the
/// radiance of the horizon.
/// @param width, height of the map, at most what OpenGL can; its detail is that of the clouds of the quality.
/// @param rgb receives width * height * 3 floats, row 0 the zenith, in the units of bolan_renderer_read_linear().
/// @param light receives sun and sky at the sea.
/// Compiles a program and allocates: not for every frame.
/// Errors: ARGUMENT (no prepared step, a size), GL, MEMORY.
BOLAN_API bolan_result bolan_renderer_read_sky(bolan_renderer *renderer, bolan_dvec3 eye, uint32_t width,
                                               uint32_t height, float *rgb, bolan_sky_light *light);

/// Reads the 8-bit image of @p framebuffer, row 0 at the top: width * height * 3 bytes.
/// A framebuffer that is not complete, has several samples a pixel or holds integers: @p rgb is left alone, logged
/// once.
BOLAN_API void bolan_renderer_read_rgb8(bolan_renderer *renderer, uint32_t framebuffer, uint32_t width, uint32_t height,
                                        uint8_t *rgb);

// ---- the fields of the sea in programs of yours ---------------------------------------------------------------------

/// Texture units that bolan_renderer_bind_fields() fills, from its `first_unit` on.
#define BOLAN_FIELDS_UNITS 4

/// The text of shaders/include/bolan_fields.glsl: functions that give displacement, slope, normal, Jacobian and foam of
/// the sea at a point, for GLSL 330 core and 300 es.
/// Put it into your shader below its version line.
/// It is also installed, as share/bolan/shaders/bolan_fields.glsl.
/// Static storage. Thread-safe.
BOLAN_API const char *bolan_fields_glsl(void);

/// Sets the samplers and the uniform block of bolan_fields.glsl in your linked @p program: 4 texture units from
/// @p first_unit on, and the uniform buffer slot @p slot.
/// Call it once after linking, not in each frame.
/// Errors: ARGUMENT (no linked program, one that uses no fields, units or a slot that the context has not; logged).
/// Leaves all other state as it was.
BOLAN_API bolan_result bolan_renderer_link_fields(bolan_renderer *renderer, uint32_t program, uint32_t first_unit,
                                                  uint32_t slot);

/// Binds the fields of @p water, its layers among them, for all programs linked with these units and this slot.
/// @p water must be valid: bolan_water_is_valid(). @p origin: the world point that positions in your shader are
/// relative to, usually your eye; it is reduced in double.
/// Uploads once for each bolan_sea_serial(); a second call for another origin costs one small buffer.
/// The texture bindings and the slot stay as set here, and sampler objects of these units are unbound.
/// All other state is left as it was. Later draws of this renderer keep them.
/// Allocates nothing after the first call unless the size of the sea changes.
BOLAN_API void bolan_renderer_bind_fields(bolan_renderer *renderer, const bolan_water *water, bolan_dvec3 origin,
                                          uint32_t first_unit, uint32_t slot);

// ---- measuring ------------------------------------------------------------------------------------------------------

/// Most passes of a frame.
#define BOLAN_MAX_PASSES 16

/// What a frame was made of.
typedef struct bolan_frame_statistics {
    /// How many entries of `passes` are filled.
    uint32_t pass_count;
    /// Name of each pass, and its time [ms] while bolan_renderer_measure_passes() is on; else 0. With several samples,
    /// of one of them. `gl_calls`: the OpenGL functions that it called.
    struct {
        const char *name;
        double ms;
        uint32_t gl_calls;
    } passes[BOLAN_MAX_PASSES];
    /// Samples a pixel of which the last view wrote the mean: bolan_view::samples, or with bolan_view::accumulate all.
    uint32_t samples;
    /// Triangles that were submitted.
    uint32_t triangles;
    /// Triangles of the water.
    uint32_t water_triangles;
    /// Shader programs compiled by this renderer since it was created. It rises when a frame of another technique, sea
    /// or ground is prepared, and stays while only the view changes.
    uint32_t programs;
    /// Uploads to textures of this renderer since it was created: fields of seas, maps of the ground, tables. They stay
    /// while the step and the eye stay, and on the open sea while the step stays.
    uint32_t uploads;
    /// Bytes of those uploads.
    uint64_t upload_bytes;
    /// OpenGL functions called since the last preparation of a step began, saving and restoring your state included.
    uint32_t gl_calls;
    /// Of those, the ones that want an answer (glGet..., glIs..., reading back, glFinish()): a driver with a thread of
    /// its own makes the caller wait for it. glGetString() is not among them.
    uint32_t gl_questions;
    /// Bytes that the last synthesis by compute shaders moved at least, each table and image once; 0 with the CPU's.
    /// Over bolan_renderer_memory_rate() it is the time below which no synthesis can be.
    uint64_t sea_bytes;
} bolan_frame_statistics;

/// Switches measuring the time of each pass on or off; default off.
/// GPU timestamps are used where there are any: they disturb no query of yours, are some frames old when they come, and
/// are never waited for. Without them (software OpenGL, OpenGL ES) glFinish() after each pass slows the frame.
BOLAN_API void bolan_renderer_measure_passes(bolan_renderer *renderer, bool on);

/// The statistics of the last finished frame.
BOLAN_API bolan_frame_statistics bolan_renderer_statistics(const bolan_renderer *renderer);

/// Returns the rate at which the GPU copies memory, read and written bytes together [bytes/s]: the mean of @p repeats
/// copies of 64 MB. 0 where there is no memory for them.
BOLAN_API double bolan_renderer_memory_rate(bolan_renderer *renderer, uint32_t repeats);

/// The yardstick of the benchmarks: a full-screen pass of 6 bilinear RGBA16F fetches at this size.
/// Returns the mean time of @p repeats passes [ms].
BOLAN_API double bolan_renderer_yardstick(bolan_renderer *renderer, uint32_t width, uint32_t height, uint32_t repeats);

#ifdef __cplusplus
}
#endif
#endif
