// SPDX-License-Identifier: MIT
// The reflection of rough water towards an observer: means over the visible facets of the Fresnel reflectance, of the
// visibility of the reflected ray past other waves, and of its direction. Needs common/slopes.glsl.
//
// Waves hide one another on two scales. The waves of the mesh stand in a ray's way by their height: Smith's function
// for a point of known height, P(lower)^L (Bourlier, Berginc & Saillard 2002). The waves that the mesh lacks have all
// lengths, and a facet shares the slope of the longer ones with its neighbourhood: motion_hidden(). A facet that leans
// towards the observer, and is therefore visible, leans away from a low sun and a low sky on the far side.
#include "shared/fresnel.glsl"
#include "shared/microfacets.glsl"

// Step of motion_hidden() in the rms slope of the sea: that of five or six independent scales, each of which hides as
// Smith's function says. The same value gives the low sun's glitter and the reflected sky of the path tracer
// (tests/reference). One scale (a large step) gives 4 times the glitter at 2 degrees below the horizon, two 2 times.
const float LENGTH_STEP = 0.1;

// The sea round a place.
struct surroundings {
    vec2 plane;      // slope of the mesh
    vec3 covariance; // of the slopes that the mesh lacks: xx, xy, yy
    vec3 mesh;       // of the slopes of the mesh
    float log_lower; // log2 of the share of the mesh that is lower than this place
    float step;      // of motion_hidden(), as a slope
};

// `height`: over the mean water, in standard deviations of the sea's; `total`: slope covariance of all waves.
surroundings surroundings_of(vec2 plane, vec3 covariance, vec3 total, float height) {
    vec3 mesh = max(total - covariance, vec3(0.0, -1.0, 0.0));
    mesh.y = clamp(mesh.y, -sqrt(mesh.x * mesh.z), sqrt(mesh.x * mesh.z));
    return surroundings(plane, covariance, mesh, log2(max(normal_cdf(height), 1e-4)),
                        LENGTH_STEP * sqrt(0.5 * (total.x + total.z)));
}

// 1 over a standard deviation, finite for none.
float per_deviation(float variance) { return inversesqrt(max(variance, 1e-8)); }

// Share of rays of that elevation [tangent] which no wave of the mesh stops. per_slope: 1 over the rms slope of those
// along the ray.
float clear_of_mesh(surroundings s, float elevation, float per_slope) {
    return exp2(s.log_lower * smith_ratio(elevation * per_slope));
}

// Elevation of an observer who sees the plane, though it may turn away from him.
float elevation_in_sight(float u, float step) { return max(u, 0.05 - step); }

// Slope of a place whose texture fetches resolve more than the mesh: these find any slope alike, but an observer sees
// those that lean towards him more often. The part beyond the mesh's plane is moved and narrowed as the visible part of
// a Gaussian is. `whole`: facets over the mesh's plane; `unresolved`: slope covariance that the texture fetches lack.
vec2 seen_slope(vec3 v, vec2 slope, surroundings s, visible_facets whole, vec3 unresolved) {
    vec2 h = normalize(level_part(v));
    float share = clamp(1.0 - slope_variance(h, unresolved) / max(slope_variance(h, s.covariance), 1e-8), 0.0, 1.0);
    float tilt = dot(s.plane - slope, h), kept = 1.0 - whole.narrow;
    return slope - h * (share * whole.shift + tilt * (sqrt(1.0 - share * (1.0 - kept * kept)) - 1.0));
}

struct rough_reflection {
    float reflectance; // mean over the visible facets, also those whose rays are not clear
    float clear;       // of that, the part whose rays are clear
    float tilt;        // mean slope towards the observer of the facets with clear rays, over the mean slope
    float spread;      // its rms about that
};

// Reflectance of a facet that has slope s towards the observer and mean square slope across2; facing: its cosine before
// its normal is brought to length 1.
float facet_fresnel(float facing, float s, float across2, float index) {
    return fresnel(clamp(facing * inversesqrt(1.0 + s * s + across2), 0.0, 1.0), index);
}

// Places between the tilt whose ray is the lowest that can be clear and the tilt beyond which there are no facets;
// closer at the low end, where the clear share rises as a square root does. Twenty change the result by less than 3 %.
const int CLEAR_STEPS = 4;
const float LAST_TILT = 2.3, TILT_RANGE = 4.6;             // [rms of the visible tilts]
const float CLEAR_WEIGHT = 2.034 / float(CLEAR_STEPS); // the weights of a whole Gaussian have the sum 1

// v: towards the observer. slope, seen: mean slope and facets of the pixel. One-dimensional, along the view.
rough_reflection reflection_of(vec3 v, vec2 slope, visible_facets seen, surroundings near, float index) {
    vec2 level = level_part(v);
    float flat_length = length(level);
    vec2 h = level / flat_length, aside = vec2(h.y, -h.x);
    float along = dot(slope, h), across = dot(slope, aside), across2 = across * across + seen.across * seen.across;
    float plane = dot(near.plane, h), observer = v.z / flat_length - plane; // elevations over the mesh's plane
    float per_local = per_deviation(slope_variance(h, near.covariance)), step = near.step * per_local;
    float above = elevation_in_sight(observer * per_local, step);
    float per_mesh = per_deviation(slope_variance(h, near.mesh));
    vec3 offset, weight;
    facet_nodes(seen, offset, weight);
    vec3 tilts = along - seen.shift - offset * seen.sigma;
    vec3 leans = (plane - tilts) * per_local; // towards the observer, over the mesh's plane
    weight *= 1.0 - vec3(motion_hidden(above, leans.x, step), motion_hidden(above, leans.y, step),
                         motion_hidden(above, leans.z, step));
    float visible = weight.x + weight.y + weight.z;
    float reflectance = dot(weight, vec3(facet_fresnel(v.z - flat_length * tilts.x, tilts.x, across2, index),
                                         facet_fresnel(v.z - flat_length * tilts.y, tilts.y, across2, index),
                                         facet_fresnel(v.z - flat_length * tilts.z, tilts.z, across2, index)));
    // half the angle from the view to the lowest ray, which clears the horizon and the mesh's plane
    float cosine = plane < 0.0 ? inversesqrt(1.0 + plane * plane) : 1.0;
    float lowest = along + (max(-plane, 0.0) * cosine - v.z) / (cosine + flat_length);
    float last = seen.shift + LAST_TILT * seen.sigma, range = clamp(last - lowest, 0.0, TILT_RANGE * seen.sigma);
    float per_facet = (1.0 - seen.narrow) / seen.sigma, sum = 1e-9, first = 1e-9 * last, second = 1e-9 * last * last;
    for (int i = 0; i < CLEAR_STEPS; ++i) {
        float x = (float(i) + 0.5) / float(CLEAR_STEPS), tilt = last - range * (1.0 - x * x), s = along - tilt;
        float up2 = 1.0 / (1.0 + s * s + across2), facing = max(v.z - flat_length * s, 0.0);
        float z = clamp(2.0 * facing * up2 - v.z, -0.999, 0.999), ray = z * inversesqrt(1.0 - z * z);
        float lean = (plane - s) * per_local, w = (ray + plane) * per_local;
        float both = motion_between_fast(above, w, lean, step, motion_hidden(above, lean, step),
                                    motion_hidden(w, -lean, step));
        float clear = x * normal_pdf(tilt * per_facet) * facing * facet_fresnel(facing, s, across2, index) *
                      both * motion_lit_fast(w, step) * clear_of_mesh(near, ray, per_mesh);
        sum += clear;
        first += clear * tilt;
        second += clear * tilt * tilt;
    }
    float mean = first / sum, variance = max(second / sum - mean * mean, 0.02 * seen.sigma * seen.sigma);
    reflectance /= max(visible, 1e-6);
    float clear = sum * CLEAR_WEIGHT * range * per_facet / (seen.area * max(visible, 1e-6));
    return rough_reflection(reflectance, min(clear, reflectance), mean, sqrt(variance));
}

// Two blurred texture fetches that stand for a lobe of that rms along the view and across it. x: their blur, y: half
// their distance. Two Gaussians make two images where that is above the blur; at 1.14 times it, the dip between the two
// is 3 % of the peaks.
vec2 fetches_of(float along, float across) {
    float blur = clamp(across, 0.66 * along, along);
    return vec2(blur, sqrt(max(along * along - blur * blur, 0.0)));
}

// Mean reflectance of rough water seen level, from the slope variance along the view: what a ray that another wave
// stops meets there. Within 8 % of the sums over facets at 1 degree in tests/data/light/mean_fresnel.csv.
float level_reflectance(float variance) { return 1.0 / (1.0 + 11.5 * sqrt(max(variance, 0.0))); }

// Share of the facets of slope `facet` in sight of the observer that also see a distant light at `to`; above 1 where
// the facets of that slope are seen more often than others. `whole`: facets over the mesh's plane. Sights to opposite
// sides bound the motion from both; sights across one another are independent; the lower of two to one side counts.
float lit_share(vec3 v, vec3 to, vec2 facet, surroundings near, visible_facets whole) {
    vec2 hv = level_part(v), hto = level_part(to), off = facet - near.plane;
    float flat_v = length(hv), flat_to = length(hto);
    hv /= flat_v, hto /= flat_to;
    vec2 along_v = slope_along(hv, near.covariance);
    float variance_v = max(dot(along_v, hv), 1e-8), per_v = inversesqrt(variance_v);
    float per_to = per_deviation(slope_variance(hto, near.covariance)), turn = dot(along_v, hto) * per_v * per_to;
    float step = near.step * per_v;
    float observer = elevation_in_sight((v.z / flat_v - dot(near.plane, hv)) * per_v, step);
    float light = (to.z / flat_to - dot(near.plane, hto)) * per_to;
    float tilt_v = -dot(off, hv) * per_v, tilt_to = -dot(off, hto) * per_to;
    float hidden_v = motion_hidden(observer, tilt_v, step), hidden_to = motion_hidden(light, tilt_to, step);
    float apart = (1.0 - hidden_v) * (1.0 - hidden_to);
    float opposite = motion_between_exact(observer, light, 0.5 * (tilt_v - tilt_to), step, hidden_v, hidden_to);
    float area = facing_exact(light).area, seen = whole.area * per_v / flat_v; // in deviations
    float both = mix(apart, turn < 0.0 ? opposite : 1.0 - max(hidden_v, hidden_to), turn * turn);
    float per_mesh = per_deviation(slope_variance(hto, near.mesh));
    return both * seen / motion_area_exact(observer, seen, step) * max(light, 0.0) /
           motion_area_exact(light, area, step) * clear_of_mesh(near, to.z / flat_to, per_mesh);
}

const float LEAST_DENSITY = 1e-6; // of facets, whose light is no longer seen

// Radiance of the reflected sun for an irradiance of 1. `seen`: facets of the pixel, of mean slope `slope` and
// covariance `unresolved`.
float sun_glint(vec3 v, vec3 to_sun, vec2 slope, vec3 unresolved, visible_facets seen, surroundings near,
                visible_facets whole, float index) {
    vec3 middle = normalize(v + to_sun);
    vec2 facet = -middle.xy / max(middle.z, 1e-3), off = facet - slope;
    float density = slope_density(off.x, off.y, unresolved.x, unresolved.y, unresolved.z);
    if (density < LEAST_DENSITY) return 0.0;
    return glint_radiance(density, fresnel(clamp(dot(v, middle), 0.0, 1.0), index), middle.z, seen.area,
                          lit_share(v, to_sun, facet, near, whole));
}
