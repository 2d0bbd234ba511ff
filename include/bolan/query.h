// SPDX-License-Identifier: MIT
/// @file query.h
/// Tier 2. Questions at fixed world points: height and normal of the surface that is drawn, choppy displacement
/// inverted; velocity, acceleration and pressure of the water at the surface and below it.
#ifndef BOLAN_QUERY_H
#define BOLAN_QUERY_H

#include "bolan/math.h"
#include "bolan/water.h"

#ifdef __cplusplus
extern "C" {
#endif

/// The surface at one world point.
/// Where choppy water folds, several parcels stand at the point; the highest parcel that is found is returned.
typedef struct bolan_query_point {
    /// Height of the surface above the datum [m].
    float height;
    /// Unit normal, z >= 0.
    bolan_vec3 normal;
    /// Jacobian of the horizontal map at the parcel found; below 0 the surface is folded.
    float jacobian;
    /// Horizontal distance between the point and the parcel [m]: below 1e-3 where the Jacobian is above 0.2.
    float residual;
} bolan_query_point;

/// Computes heights and normals at @p count world points @p xy [m].
///
/// The fields of the sea are read by cubic splines, as images read them: this is the surface that is drawn.
/// A sum of waves is summed at the point itself. The layers of the water are added at the rest point of the parcel.
///
/// Over a ground each cascade is attenuated by the depth under the rest point of the parcel.
/// The attenuations are bolan_coast_attenuations() of 4 sqrt(variance) of the cascades.
/// A sum of waves is attenuated as one cascade, and each layer by itself.
/// The lift of the mean falls with the square of the attenuation.
/// The normal includes how the attenuation varies in space.
/// On dry land the height is the level of the water.
/// Points that are not finite give the level and a vertical normal.
///
/// Positions are reduced in double, so that the accuracy 1e6 m from the origin is that near the origin.
/// Each result depends on its point alone, never on batch, threads or instruction set.
/// Uses the task hook for large batches. Allocates nothing.
/// Cannot fail; a water that is not valid is misuse.
/// Thread-safe between steps of the sea. A thread that queries while another steps takes a fork: bolan_sea_fork().
BOLAN_API void bolan_query_surface(const bolan_water *water, const bolan_dvec2 *xy, uint32_t count,
                                   bolan_query_point *out);
/// Like bolan_query_surface(), for heights alone [m above the datum].
/// @param height receives count floats.
BOLAN_API void bolan_query_heights(const bolan_water *water, const bolan_dvec2 *xy, uint32_t count, float *height);

/// A parcel of the surface, known by its rest point.
typedef struct bolan_parcel {
    /// From the rest point on the mean water to the parcel [m]: it is found at x0 + x, y0 + y, level + z.
    bolan_vec3 displacement;
    /// Unit normal of the displaced surface, z >= 0.
    bolan_vec3 normal;
    /// Jacobian of the horizontal map; below 0 the surface is folded.
    float jacobian;
} bolan_parcel;
/// Where the parcels of @p count rest points @p rest [m] are: the vertices of a mesh of the surface.
///
/// Waves, layers and attenuation over a ground are those of bolan_query_surface(), which finds the same parcel at its
/// place, or a higher one where the water folds.
/// @p spacing[i] >= 0 [m]: the distance of point i to its neighbours in a mesh, for which the waves are low-passed as
/// by bolan_sea_sample_grid(), so that nothing aliases. Layers keep all their waves. NULL or 0: no low-pass.
/// Points that are not finite give no displacement and a vertical normal.
/// Uses the task hook for large batches. Allocates nothing. Cannot fail; a water that is not valid is misuse.
/// Thread-safe as bolan_query_surface().
BOLAN_API void bolan_query_parcels(const bolan_water *water, const bolan_dvec2 *rest, const float *spacing,
                                   uint32_t count, bolan_parcel *out);

/// The foam at @p count world points @p xy [m]: bolan_sea_sample.foam of the parcel that bolan_query_heights() finds
/// there.
/// Points that are not finite give 0. Otherwise like bolan_query_parcels().
BOLAN_API void bolan_query_foam(const bolan_water *water, const bolan_dvec2 *xy, uint32_t count, float *foam);

// ---- the moving water -----------------------------------------------------------------------------------------------

/// At which depth the waves of linear theory are taken for a point at height z over the mean level, under a surface at
/// height eta over it. Linear theory ends at the mean level; H is the depth of the sea.
typedef enum bolan_stretching {
    /// At z; above the mean level at the mean level, so that the flow is constant up to the crest. With a sea of
    /// order 2 along the tangent instead.
    BOLAN_STRETCH_NONE,
    /// At H (z - eta) / (H + eta): the surface is where linear theory has the mean level (Wheeler 1970).
    BOLAN_STRETCH_WHEELER,
} bolan_stretching;

/// Options of a question about moving water.
typedef struct bolan_question {
    /// Waves shorter than this are left out [m], 0..1e5; 0 (default): none.
    /// The filter is 1 - (1 - e^{-kl})^4 on the amplitude, with l = 0.29258 of this wavelength: it keeps half of a wave
    /// of this length, 87 % of one twice and 98 % of one four times as long, 10 % of one half and 0.3 % of one a
    /// quarter as long.
    double least_wavelength;
    /// Default BOLAN_STRETCH_NONE.
    bolan_stretching stretching;
} bolan_question;
/// The defaults named above the fields. Thread-safe.
BOLAN_API bolan_question bolan_question_default(void);

/// The water at one world point, over the ground.
/// With a sea of order 1 these are the values of linear theory whatever the choppiness, which moves parcels in place
/// only. With a sea of order 2 they are those of second-order theory, of which flow.h has the equations.
typedef struct bolan_kinematics {
    /// Orbital velocity of the waves, and the current of the sea [m/s].
    bolan_vec3 velocity;
    /// Of the parcel that is at the point [m/s2]: with order 2 it includes (velocity . grad) velocity.
    bolan_vec3 acceleration;
    /// Dynamic pressure [Pa]: what the waves add to the hydrostatic pressure of still water, density g (level - z) for
    /// water of BOLAN_SEA_WATER_DENSITY. Both together are 0 at the surface; a gauge of depth measures both.
    float pressure;
    /// The point is in the water. If not, all else is 0.
    bool wet;
} bolan_kinematics;
/// The water at @p count world points @p xyz [m].
///
/// With a sea of order 1 a parcel at rest at (x0, y0, s) is found at x0 + choppiness D(x0, y0, s), horizontally; s is
/// by the question's stretching. Below the surface folds are not searched: where the water folds the answer belongs to
/// one of the parcels. A point is wet up to a millimetre above the surface, and above the ground of the water. The
/// surface is that of bolan_query_heights(), or with a least wavelength that of bolan_query_motion().
/// With a sea of order 2 the point itself is asked, of waves that longer waves have carried there (flow.h). Without
/// stretching the flow above the mean level is continued along the tangent there, so that the velocity at the surface
/// is that of the surface, and the pressure there is 0, to second order. With stretching the heights of long waves do
/// not carry short ones.
/// Waves are attenuated over the ground as for bolan_query_surface(); what pairs of waves make, with the square.
/// Wave layers are added, by linear theory with their own period and depth; the gradient of their edges is ignored.
///
/// @p water needs a flow at the time of its sea: water->flow, bolan_flow_step(). A water without a flow is misuse.
/// @p question NULL: the default.
/// Uses the task hook for large batches. Allocates nothing. Cannot fail. Points that are not finite are dry.
/// Thread-safe between steps of sea and flow.
BOLAN_API void bolan_query_below(const bolan_water *water, const bolan_question *question, const bolan_dvec3 *xyz,
                                 uint32_t count, bolan_kinematics *out);

/// The water at a list of levels under the same places: @p count places @p xy [m] at @p levels heights @p z [m above
/// the datum], in any order. Writes place i at level l to out[l * count + i].
/// Each answer is that of bolan_query_below() at (x, y, z), bit for bit; the surface over a place is looked for once.
/// Otherwise like bolan_query_below().
BOLAN_API void bolan_query_levels(const bolan_water *water, const bolan_question *question, const bolan_dvec2 *xy,
                                  uint32_t count, const double *z, uint32_t levels, bolan_kinematics *out);

/// The surface and its motion at one world point.
typedef struct bolan_surface_motion {
    /// Of the surface above the datum [m].
    float height;
    /// How fast the height at this point rises [m/s]: what a wave staff measures.
    float rise;
    /// Unit normal, z >= 0.
    bolan_vec3 normal;
    /// Of the water at the surface, as in bolan_kinematics [m/s], [m/s2].
    bolan_vec3 velocity, acceleration;
} bolan_surface_motion;
/// Height, normal and motion of the surface at @p count world points @p xy [m], without the waves that the question
/// leaves out: a long hull does not feel ripples. The rest point is that of bolan_query_surface(); with a least
/// wavelength, and over a sum of waves, folds are not searched.
/// The flow has tables of its own: its heights agree with those of bolan_query_surface() within their interpolation.
/// Otherwise like bolan_query_below(). On dry land the height is the level and nothing moves.
BOLAN_API void bolan_query_motion(const bolan_water *water, const bolan_question *question, const bolan_dvec2 *xy,
                                  uint32_t count, bolan_surface_motion *out);

// ---- lines ----------------------------------------------------------------------------------------------------------

/// A part of a straight line in the world.
typedef struct bolan_ray {
    /// Where it begins [m].
    bolan_dvec3 origin;
    /// Where it goes; of any length but 0.
    bolan_dvec3 direction;
    /// How far [m], 0..1e7.
    double length;
} bolan_ray;
/// Where a ray meets the surface.
typedef struct bolan_ray_hit {
    /// It does, from above or from below. If not, all else is 0.
    bool hit;
    /// From the origin [m].
    double distance;
    /// The place [m].
    bolan_dvec3 point;
} bolan_ray_hit;
/// The first places at which @p count rays meet the surface, of flat earth.
/// The surface is that of bolan_query_heights(), or of bolan_query_motion() where the question has a least wavelength.
/// The place is within 1 mm of the surface along the vertical. A crest that the ray cuts by less than 5 mm may be
/// passed over, and so may one that is steeper than 8 standard deviations of slope, or 2.5. A ray that is not finite,
/// or has no direction, hits nothing. A least wavelength needs a flow, as for bolan_query_below(). @p question NULL:
/// the default. Uses the task hook. Allocates nothing. Cannot fail. Thread-safe as bolan_query_surface().
BOLAN_API void bolan_query_rays(const bolan_water *water, const bolan_question *question, const bolan_ray *rays,
                                uint32_t count, bolan_ray_hit *out);

/// A crest on a line.
typedef struct bolan_crest {
    /// From the beginning of the line [m].
    double distance;
    /// Of the surface above the datum [m].
    float height;
} bolan_crest;
/// The crests, local maxima of the height, along the line from @p from to @p to, in order; its ends do not count.
/// @p step [m], 0.001..1e4: heights are compared this far apart and maxima refined to a thousandth of it. Crests nearer
/// to one another than two steps may count as one.
/// Writes at most @p capacity crests to @p out and returns how many there are. A line of more than 1e7 steps is misuse.
/// Otherwise like bolan_query_rays().
BOLAN_API uint32_t bolan_query_crests(const bolan_water *water, const bolan_question *question, bolan_dvec2 from,
                                      bolan_dvec2 to, double step, uint32_t capacity, bolan_crest *out);

#ifdef __cplusplus
}
#endif
#endif
