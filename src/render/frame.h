// SPDX-License-Identifier: MIT
// One frame as the passes see it, and the passes. frame.c reads as the list of passes of a frame.
//
//   atmosphere tables -> clouds -> environment map        (only when sun, haze or altitude changed)
//   sea textures, shore depth map                         (upload)
//   terrain + sea bed, objects                             HDR colour + reversed-Z depth
//   copy of colour and depth                               what the physical optics sees through the water
//   the world mirrored, the world refracted                what the mirror and phong optics look up
//   water
//   sky, where nothing stands before it
//   tone map -> the caller's framebuffer
//
// All positions on the GPU are relative to the eye, in world axes (x east, y north, z up).
#ifndef BOLAN_FRAME_H
#define BOLAN_FRAME_H

#include "bolan/render.h"
#include "gl/gl.h"
#include "view.h"
#include "water_block.h"

// Texture units are fixed; shaders name them by `#pragma unit`. A unit of the first table means one thing in every
// program. The units of the second table belong to the pass or the optics that draws: it binds its inputs there before
// its own draw call, and expects nothing on them.
enum {
    UNIT_TRANSMITTANCE = 0, // 2D RGBA16F  transmittance of the atmosphere, see common/atmosphere.glsl
    UNIT_SKY_VIEW = 1,      // 2D RGBA16F  sky radiance round the eye
    UNIT_ENVIRONMENT = 2,   // 2D RGBA16F  upper hemisphere with clouds, mip-mapped by roughness
    UNIT_SCENE_COLOR = 3,   // 2D  what lies behind the water
    UNIT_SCENE_DEPTH = 4,   // 2D  its reversed-Z depth
    UNIT_SHORE = 5,         // 2D array R16F  elevation around the eye, nested levels
    UNIT_SLOPE_TABLE = 6,   // 3D  unresolved slope covariance
    UNIT_FOAM_DETAIL = 7,   // 2D  tiled foam structure
    UNIT_DISPLACEMENT = 8,  // 2D array RGBA16F, a layer per cascade
    UNIT_SLOPES = 9,        // 2D array RGBA16F, or the first packed cascade
    UNIT_FOLD = 10,         // 2D array RG16F  dxy, foam memory
    UNIT_TERRAIN = 11,      // 2D RGBA16F  map of a chunk of the ground
    UNIT_TERRAIN2 = 12,     // 2D  noise of the ground
    UNIT_CLOUDS = 13,       // 2D  panorama of the clouds
    UNIT_AERIAL = 14,       // 3D  aerial perspective
    UNIT_CASCADES = 20,     // 20-22: 2D RGBA16F  packed cascades after the first
    UNIT_HALF_RATE = 23,    // 2D  input of the passes of half_rate.c, which run while an optics has its own bound
    UNIT_WAVE_TABLE = 27,   // 2D RGBA32F  the waves of a sum
};
enum {
    UNIT_OWN = 15,              // 15-19: inputs of a pass
    UNIT_REFRACTION_DEPTH = 15, // 2D  images of planar_views.c and their depths
    UNIT_REFLECTION = 16,
    UNIT_REFRACTION = 17,
    UNIT_REFLECTION_DEPTH = 24,
    UNIT_RIPPLES = 18,       // 2D  slopes of ripples, or of a tile
    UNIT_TILE = 19,          // 2D RGBA8  the water's own texture, light on the bottom
    UNIT_GLINT = 25,         // 2D R8  the sun on a slide
    UNIT_CAUSTICS = 24,      // array RGBA16F  caustics of the drawn waves: caustics.h
    UNIT_WINDOW = 25,        // 2D  what stands above an eye in the water: below.h
    UNIT_RIPPLE_SLOPES = 26, // 2D  slopes of the finer tile
    UNIT_FINE = 26,          // 2D  slopes of the fine waves
};

// A step: what the caller gave to prepare, and what every view of it shares.
typedef struct frame {
    const gl_caps *caps;
    struct sea_compute *compute; // which makes the fields of cascades; NULL: the CPU does
    bool compute_pixels;         // BOLAN_PIXELS_COMPUTE
    gl_timing timing;
    bolan_quality quality;
    bolan_water water;
    const bolan_sea *sea;       // the water's
    const bolan_ground *ground; // the water's, or NULL
    double level;               // the water's
    bolan_lighting lighting;
    // The rest of the world, when Bolan draws it; NULL where a host does.
    const bolan_scene *scene; // its objects are read
    const bolan_model *const *models;
    const bolan_tiles *tiles;
    bool behind; // something may be seen through the water or mirrored in it: ground, objects, a host's scene
    bool hosted; // it is a host's scene
    const bolan_host *host; // whose frame is drawn; NULL: the world's
    bool motion;            // views with motion vectors are drawn: fields and poses of the step before are kept
    uint32_t bounds_count;  // corners of the polygon in which the water lies, while a host's frame is drawn; 0: no end
    // What follows from those.
    double time;
    bolan_vec3 sun_direction;
    double wind_to;        // the wind blows there [rad, counter-clockwise from east]
    bolan_dvec2 surf_wave; // of the bores: cycles per metre, the way they run
    double surf_periods;   // time in their periods
    struct frame_caustics {
        bolan_vec2 turn, travel;
        float strength;
    } caustics;                // set by the optics mirror and physical
    const gl_buffer *foam_law; // of sea_compute.h, which has the memory of this step's foam; NULL: the CPU has it
    frame_block block;
} frame;

// Fills what follows from the rest, and the block: the one function that writes the block Frame.
void bolan_frame_fill(frame *f);
// frame_block::radiance_unit for a sun whose direction has that z.
float bolan_radiance_unit(float sun_height);
// Sub-pixel shifts of a sample: the R2 sequence (Roberts 2018), centred; the first is the pixel's middle.
bolan_vec2 bolan_sample_shift(uint32_t i);
// How far the water has moved with its current since time 0 [m], now and at a time [s]; 0 without a sea.
bolan_dvec2 bolan_frame_drift(const frame *f);
bolan_dvec2 bolan_frame_drift_at(const frame *f, double time);
// How far bubbles and small nets of foam, and eddies of foam, have moved over the water with the wind since time 0 [m],
// and windrows [tiles of them]. With a loop they move through whole tiles of their noise, so that they close it too.
bolan_dvec2 bolan_frame_foam_drift(const frame *f);
bolan_dvec2 bolan_frame_eddy_drift(const frame *f);
double bolan_frame_windrow_drift(const frame *f);
// Place of an eye in the tile of wind streaks, for a wind that blows there. scale: frame_block.streak_scale.
bolan_vec2 bolan_frame_streaks(bolan_dvec3 eye, double wind_to, bolan_vec2 scale);
// x modulo period, in [0, period): in double, so that a shader never sees a large coordinate.
float bolan_reduced(double x, double period);

// Period [s] and length [m] of the waves at the peak of the sea's spectrum, in deep water; a calm has those of an 8 s
// swell.
double bolan_sea_peak_period(const bolan_sea_summary *sea);
double bolan_sea_peak_length(const bolan_sea_summary *sea);
// Significant height of the waves that break on a shore [m]: within what surf is drawn for.
double bolan_sea_surf_height(const bolan_sea_summary *sea);

// Every pass: create once, draw per frame, free. prepare() may run before targets are bound and fills textures it owns.
typedef struct pass_sky pass_sky;         // atmosphere tables, sky, clouds, environment map; sets sun_light, sky_light
typedef struct pass_ground pass_ground;   // land and sea bed; the shore map
typedef struct pass_objects pass_objects; // the scene's objects
typedef struct pass_water pass_water;
typedef struct pass_tonemap pass_tonemap;
struct temporal; // of temporal.h

// Shares the programs of `from`, which must live longer; NULL: makes its own. compute: BOLAN_PIXELS_COMPUTE.
bolan_result bolan_pass_sky_create(const gl_caps *caps, bool compute, const pass_sky *from, pass_sky **out);
// Takes the programs of `from` again, which has reloaded them, and makes its tables anew.
void bolan_pass_sky_share(pass_sky *p, const pass_sky *from);
void bolan_pass_sky_prepare(pass_sky *p,
                            render_view *v); // tables (when stale), sun_light, sky_light, exposure; binds its units
// Draws the prepared sky as an equirectangular map and reads it, from the lowest row up.
bolan_result bolan_pass_sky_map(pass_sky *p, uint32_t width, uint32_t height, float *rgba);
// Where the depth is 0, nothing drawn. own: into v->hdr, with v->hdr_depth.
void bolan_pass_sky_draw(pass_sky *p, const render_view *v, bool own);
void bolan_pass_sky_draw_over(pass_sky *p,
                              const render_view *v); // after the water: clouds below a high eye; reads UNIT_SCENE_DEPTH
bolan_result bolan_pass_sky_reload(pass_sky *p);
void bolan_pass_sky_destroy(pass_sky **p);

bolan_result bolan_pass_ground_create(const gl_caps *caps, const pass_ground *from, pass_ground **out); // as the sky
void bolan_pass_ground_share(pass_ground *p, const pass_ground *from);
void bolan_pass_ground_prepare(pass_ground *p, render_view *v); // chunks of this view, shore map; binds its units
void bolan_pass_ground_draw(pass_ground *p, render_view *v);
// With the program surfaces.glsl, in the place of its own.
void bolan_pass_ground_draw_surfaces(pass_ground *p, render_view *v, const gl_program *program);
bolan_result bolan_pass_ground_reload(pass_ground *p);
void bolan_pass_ground_destroy(pass_ground **p);

bolan_result bolan_pass_objects_create(const gl_caps *caps, pass_objects **out);
void bolan_pass_objects_prepare(pass_objects *p, render_view *v); // places of this frame; uploads what is new
// Sets the casters of shadows in a program that includes common/object_shadow.glsl.
void bolan_casters_use(const render_view *v, const gl_program *program);
// Those alone whose shadow may meet a ball round an eye-relative place, but for one (-1: none). None that are narrower
// than `least` [m].
void bolan_casters_use_near(const render_view *v, const gl_program *program, bolan_vec3 middle, float radius,
                            float least, int but);
void bolan_pass_objects_draw(
    pass_objects *p,
    render_view *v); // one side of the clip plane; reads UNIT_TERRAIN2 (the terrain pass's noise)
// With the program surfaces.glsl, in the place of its own; object i has the label `first` + i.
void bolan_pass_objects_draw_surfaces(pass_objects *p, render_view *v, const gl_program *program, uint32_t first);
// Motion vectors: the same with OBJECT and MOTION, by the poses at that time of the sea.
void bolan_pass_objects_draw_motion(pass_objects *p, render_view *v, const gl_program *program, double time_before);
// Changes whenever an object has moved.
uint64_t bolan_pass_objects_places(const pass_objects *p);
bolan_result bolan_pass_objects_reload(pass_objects *p);
void bolan_pass_objects_destroy(pass_objects **p);

// Draws the world for the water's optics, into the view's target: land and objects and, where `sky`, the sky behind.
typedef struct world_drawer {
    void (*draw)(void *user, render_view *v, bool sky);
    void *user;
} world_drawer;

bolan_result bolan_pass_water_create(bolan_quality quality, uint32_t max_vertices, pass_water **out);
// Compiles every program that views of this step can need, in a world and in a host's frame, with and without bounds.
bolan_result bolan_pass_water_compile(pass_water *p, const frame *f, bolan_progress *progress, void *user);
void bolan_pass_water_prepare(pass_water *p, frame *f);    // uploads the fields of a new serial
void bolan_pass_water_view(pass_water *p, render_view *v); // the surface of a view
bool bolan_pass_water_looks_through(const frame *f);       // its optics fetches what lies behind the water
bool bolan_pass_water_mirrors(const frame *f);             // its optics fetches planar views
// Puts the depth of two triangles first, so that nothing behind them is shaded.
void bolan_pass_water_cover(pass_water *p, render_view *v);
// Draws the planar views, where its optics has any: before bolan_pass_water_draw().
void bolan_pass_water_behind(pass_water *p, render_view *v, const world_drawer *world);
// Shades the water into the view; reads UNIT_SCENE_COLOR and UNIT_SCENE_DEPTH.
void bolan_pass_water_draw(pass_water *p, render_view *v);
// What flies over the water, after the sky.
void bolan_pass_water_draw_over(pass_water *p, render_view *v);
// Uses the program of motion.glsl that follows the parcels, with its textures and uniforms of the waves. NULL: they
// are not followed, for this view or from that time of the sea.
const gl_program *bolan_pass_water_use_motion(pass_water *p, render_view *v, double time_before);
// What is seen through water by an eye in it or at the waterline; after the sky.
void bolan_pass_water_draw_below(pass_water *p, render_view *v);
// The medium of a view from there, and what follows from it: its near plane.
void bolan_pass_water_place(const frame *f, render_view *v);
// Whether an eye below the mean water sees two triangles, and the water round it by bolan_pass_water_draw_body().
bool bolan_pass_water_has_body(const frame *f);
// The water round an eye in it, where the depth is 0.
void bolan_pass_water_draw_body(pass_water *p, const frame *f);
bool bolan_pass_water_needs_baking(const pass_water *p, const frame *f); // and was not asked to
bolan_result bolan_pass_water_reload(pass_water *p);
void bolan_pass_water_destroy(pass_water **p);

bolan_result bolan_pass_tonemap_create(bool compute, pass_tonemap **out); // compute: BOLAN_PIXELS_COMPUTE
// Before the samples of a view. Returns how many samples of earlier views stay in the sums.
uint32_t bolan_pass_tonemap_begin(pass_tonemap *p, const bolan_view *to);
// Into the rectangle of `to`; blended with the images before it where `history`, NULL for none, is of a temporal view.
// `sample` is that of this view.
void bolan_pass_tonemap_draw(pass_tonemap *p, const render_view *v, const bolan_view *to, const gl_texture *hdr_color,
                             uint32_t sample, struct temporal *history);
// Of a picture of several samples: the sum of their radiance, width * height * 4 floats, row 0 at the bottom. Returns
// how many were added up; 0: the picture had one sample, and @p rgba is untouched.
uint32_t bolan_pass_tonemap_read_sum(const pass_tonemap *p, float *rgba);
// Samples a pixel of the last picture.
uint32_t bolan_pass_tonemap_samples(const pass_tonemap *p);
// The last picture had no sums: a host's.
void bolan_pass_tonemap_forget(pass_tonemap *p);
bolan_result bolan_pass_tonemap_reload(pass_tonemap *p);
void bolan_pass_tonemap_destroy(pass_tonemap **p);

// The shore map: a texture array of SHORE_LEVELS square levels of elevation above the water level [m], centred near the
// eye, each four times as wide as the one before. Level l covers the square from (west, south), eye-relative, of side
// `size`.
#define SHORE_LEVELS 4
#define SHORE_SIZE 256
typedef struct shore_map {
    gl_texture texture;
    float level[SHORE_LEVELS][4];
    bool present;
} shore_map; // level: west, south, size, texel (eye-relative [m])
const shore_map *bolan_pass_ground_shore(
    const pass_ground *p); // members shore_level and shore_present of the block Water: see common/shore.glsl
void bolan_shore_map_fill(const shore_map *s, water_block *b);

#endif
