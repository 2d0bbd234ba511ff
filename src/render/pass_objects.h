// SPDX-License-Identifier: MIT
// The insides of the pass of objects: pass_objects.c (places and drawing), object_meshes.c (what is on the GPU) and
// casters.c (shadows).
#ifndef BOLAN_RENDER_PASS_OBJECTS_H
#define BOLAN_RENDER_PASS_OBJECTS_H

#include "frame.h"

#include "bolan/world.h"

enum { CASTER_FLOATS = 3 * 4, MAX_CASTERS = 32 }; // twins of caster[] in common/object_shadow.glsl

enum { ABOVE, ACROSS, BELOW, CLASSES }; // the paper's three classes (section 2.2), of triangles

// What a program is for: models that lie flat or things; the main view, a picture's whole triangles, cut ones, and both
// where they may lie under the water.
enum { MAIN, WHOLE, CUT, WET_WHOLE, WET_CUT, KINDS };

// A model on the GPU.
typedef struct gpu_model {
    uint64_t id; // 0: empty
    gl_buffer vertices, indices;
    gl_mesh mesh;
    uint32_t index_count;
    float period; // of its grain [m]
    bool flat;    // lies like ground
    bool wanted;  // by this frame
} gpu_model;

// The indices of a still object that stands in the water, its triangles sorted by class.
typedef struct sorted {
    uint64_t id; // of the model; 0: empty
    float place[4];
    gl_buffer indices;
    gl_mesh mesh;
    uint32_t counts[CLASSES];
} sorted;

// Where an object stood in the last two steps.
typedef struct motion {
    uint64_t id;              // of its model; 0: none
    double time, time_before; // of the sea; NAN: none
    double scale, scale_before;
    bolan_pose pose, before;
} motion;

// An object as it stands in this frame.
typedef struct placed {
    const gpu_model *gpu;
    const gl_mesh *mesh;
    uint32_t counts[CLASSES]; // indices
    float rows[12];           // model to eye-relative world
    bolan_vec3 low, high;     // of its box in the model
    double lowest, highest;   // of its box, above the water level [m]
    float nearest;            // about as near as it comes to the eye [m]
    int caster;               // its own, or -1
    float wet[2];             // heights over the water level between which it is wet [m]
    uint32_t index;           // in the scene
} placed;

struct pass_objects {
    gl_program programs[2][KINDS]; // [flat]
    gpu_model models[BOLAN_MAX_OBJECTS];
    sorted sorted[BOLAN_MAX_OBJECTS];  // by the scene's order
    motion motions[BOLAN_MAX_OBJECTS]; // likewise
    uint64_t places;                   // a hash of where they stand
    placed objects[BOLAN_MAX_OBJECTS]; // the nearest first: what they hide is not shaded
    uint32_t count;
    float casters[MAX_CASTERS * CASTER_FLOATS];
    uint32_t caster_count;
};

// The model on the GPU; NULL: it is not there.
gpu_model *bolan_object_mesh_find(pass_objects *p, uint64_t id);
// Likewise; a place that this frame does not want is given to a new one. NULL when there is no memory.
gpu_model *bolan_object_mesh_keep(pass_objects *p, const bolan_model *model);
// Which of the object's indices are of which class: by triangles where it stands still in the water, else as a whole.
void bolan_object_mesh_sort(sorted *s, placed *o, const bolan_model *model, bool floats, float eye_over_water);
void bolan_object_meshes_free(pass_objects *p);

#endif
