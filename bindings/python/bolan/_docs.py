# SPDX-License-Identifier: MIT
# Made by bindings/python/generate.py from include/bolan/*.h. Do not edit.
"""Comments of the functions of the C headers."""

DOCS = {
    "bolan_allocate": """Allocates memory through the hooks: zero-filled, aligned to 64 bytes.
Returns NULL for size 0 and on failure.
Thread-safe if the hook is.""",
    "bolan_apparent_depth": """Apparent depth of the point of bolan_refraction_crossing(), vertically above its place [m].
It is the depth times bolan_refraction_k() at the angle of the path.""",
    "bolan_assert_failed": """Reports misuse to the assert hook; called by BOLAN_ASSERT().""",
    "bolan_beaufort_from_wind": """Returns the Beaufort force of a wind speed at 10 m [m/s], 0..12.""",
    "bolan_breaker_cover": """Fraction covered by crests that are breaking, the stage A of Monahan (1993): 3.16e-7 U10^3.2, at most
bolan_callaghan_cover().""",
    "bolan_callaghan_cover": """Fraction covered by whitecaps of all ages, by Callaghan et al. (2008): 3.18e-5 (U10 - 3.70)^3 up to about 10 m/s,
then 4.82e-6 (U10 + 1.98)^3; 0 up to 3.70 m/s.
It is limited to 0.95; the observed winds end at 23 m/s.""",
    "bolan_coast_attenuation": """Returns the share of the deep-water amplitude that a sea keeps in shallow water: f = tanh(0.6 depth / hs).
It is 1 in deep water and falls to 0 at the waterline; the local height stays below the breaking limit, 0.6 depth.
depth: depth of the water [m]; <= 0 gives 0.
hs: significant wave height of the sea in deep water [m].
Thread-safe.
Shared source: shaders/shared/attenuation.glsl.""",
    "bolan_coast_attenuations": """Computes the shares of count bands that together make one sea.
The share of a band is its bolan_coast_attenuation() times a factor common to all bands, so low bands keep more.
The common factor makes the local height of all bands that of one sea of their total height, below 0.6 depth.
band_hs: significant wave heights of the bands in deep water [m].
out: receives the shares.
Thread-safe.""",
    "bolan_compass_from_to_math": """Converts the compass direction that waves come FROM [deg] to the mathematical angle where they GO, [0, 2 pi) [rad].""",
    "bolan_content_create_ground": """Generates a ground.
The bits of the ground are a function of generator alone.

"island" is a volcanic island: eroded peaks in a horseshoe, cliffs and stacks to windward, sandy bays to leeward.
Shallows 1 m to 6 m deep lie behind a barrier reef on the side generator->lagoon_from_deg.
The land is centred on the origin of the scene.
The generation takes about a second and uses the task hook.

"pond" is a basin 90 m across in a meadow, 0.4 m to 4 m deep, with a sandy shelf in the south.
The pond has no parameters.

out: receives the ground, which the caller destroys; NULL on failure.
Errors: ARGUMENT (an unknown name, a parameter out of its range), MEMORY.
Thread-safe.""",
    "bolan_content_create_model": """Builds the model of that name.
name: one of bolan_content_model_name(), without "builtin:".
out: receives the model, which the caller destroys; NULL on failure.
Errors: ARGUMENT (an unknown name), MEMORY.
Thread-safe.""",
    "bolan_content_ground_name": """Returns the name of a generator of ground: "island", "pond".
Returns NULL past the last.
Static storage.
Thread-safe.""",
    "bolan_content_model_name": """Returns the name of a model: "boat", "house", "pond-ground" and so on.
Returns NULL past the last.
Static storage.
Thread-safe.""",
    "bolan_context_create": """Makes a context and makes it current on this thread.
out: receives the context; NULL after an error.
Errors: GL (the machine has none), MEMORY.""",
    "bolan_context_destroy": """Releases the context.
Destroy everything that was made in it before.
NULL-safe; NULLs the pointer.""",
    "bolan_context_make_current": """Makes the context current on this thread.""",
    "bolan_cox_munk": """Slope variance of a clean surface, upwind and crosswind, by Cox & Munk (1954): 3.16e-3 U and 0.003 + 1.92e-3 U.
The published errors are +- 0.004 and 0.002.
Below 0.72 m/s the constant 0.003 fades, so that a calm is flat.
wind_speed: U at 12.5 m [m/s].""",
    "bolan_cpu_best": """Returns the widest instruction set of this machine.
Thread-safe.""",
    "bolan_cpu_name": """Returns "auto", "scalar", "generic4", "avx2" or "avx512".
Static storage. Thread-safe.""",
    "bolan_douglas_from_hs": """Returns the Douglas degree of a significant wave height [m], 0..9.""",
    "bolan_earth_dip": """Returns the dip of the parabola's horizon seen from height h >= 0, as a tangent: sqrt(2 h / R).""",
    "bolan_earth_dip_exact": """Returns the dip of the sphere's horizon seen from height h >= 0, as an angle: acos(R / (R + h)).""",
    "bolan_earth_distance": """Returns the distance along the great circle between two places on the sphere, by the haversine formula.
Longitudes and latitudes are in degrees.""",
    "bolan_earth_drop": """Returns the depth of mean water below the tangent plane at level distance r, by the parabola r^2 / 2R.""",
    "bolan_earth_drop_exact": """Like bolan_earth_drop(), by the sphere: R - sqrt(R^2 - r^2).
|r| beyond R counts as R.""",
    "bolan_earth_horizon": """Returns the level distance to the horizon of the parabola from height h >= 0: sqrt(2 R h).""",
    "bolan_earth_horizon_exact": """Returns the straight distance from height h >= 0 to the horizon of the sphere: sqrt(h (2 R + h)).""",
    "bolan_earth_meets": """Returns the level distance at which a ray from height h >= 0 meets the parabola.
Returns HUGE_VAL where the ray passes over the horizon.
slope: tangent of the angle of the ray below level.""",
    "bolan_enlarge": """Moves memory of bolan_allocate() into an allocation of larger bytes, whose rest is zero, and releases the old.
size is the size of the old allocation, memory NULL: nothing is moved.
Returns NULL on failure, and leaves the old allocation as it is.
Thread-safe if the hook is.""",
    "bolan_environment_default": """The defaults named above.
Thread-safe.""",
    "bolan_export_fields": """Writes the fields of the waves of world: .exr, OpenEXR, or .nc, NetCDF-3 with 64-bit offsets and the conventions
CF-1.8.

Of cascades (a sea of form CASCADES): height, dx, dy, slope_x, slope_y, dxx, dyy, dxy, foam, as bolan_cascade_view
has them, at the samples: height, dx and dy are values of the spline, not its coefficients. In EXR each cascade is a
part "cascade0" ..., whose header has time, length, angle, k_min, k_max, variance and origin; in NetCDF the
variables are height_0(time, v_0, u_0) ..., with the same as attributes.

Resampled: height, normal_x, normal_y, normal_z, jacobian of bolan_query_surface(), velocity_x, velocity_y,
velocity_z of bolan_query_motion(), foam of bolan_query_foam(), at fixed points; in NetCDF height(time, y, x) and so
on, with CF standard names where there are any.

Times are seconds since the epoch of the scene, which CF wants as a date: it is named 1970-01-01.
Memory: one frame and, of .exr, the compressed file.
Errors: ARGUMENT (the suffix, a field out of range, cascades of a sum, several frames of .exr), FORMAT
(EXPORT_TOO_LARGE: more than 2^28 points), UNSUPPORTED (EXR in a build without it), IO, MEMORY.""",
    "bolan_export_fields_desc_default": """The defaults named above the fields. Thread-safe.""",
    "bolan_export_grid_size": """Points along x and along y; 0 and 0 where the grid is out of range.
Thread-safe.""",
    "bolan_export_mesh": """Writes the water of world as a mesh, in the format that the suffix of path names.

A vertex of the water is a parcel of bolan_query_parcels(), with its normal; its foam is that of bolan_sea_sample,
and its velocity that of bolan_query_motion() at its place, the current included. Triangles are counter-clockwise
seen from above. Vertices of the ground have its normal, no foam and no velocity.

| suffix | format | foam | velocity | water and ground |
|---|---|---|---|---|
| .ply | binary, little-endian | `foam` | `vx`, `vy`, `vz` | with ground: vertex property `part`, 0 and 1 |
| .obj | text | grey of the vertex, not clamped | none: EXPORT_LEFT_OUT warns | objects `water`, `ground` |
| .glb | glTF 2.0, binary | `_FOAM` | `_VELOCITY` | nodes `water`, `ground` |

An animation holds the mesh of the first frame and, for each other frame, a morph target of position and normal with
the weight 1 at its time; foam and velocity are those of the first frame. It is played with linear interpolation.
A scene whose technique draws another surface gets the projected grid, with one warning (EXPORT_LEFT_OUT).
Memory: a view's grid, and 16384 vertices or one row at a time; an animation holds its first frame.
Errors: ARGUMENT (the suffix, a field out of range, no water in view, several frames for another format, no ground),
FORMAT (EXPORT_TOO_LARGE: more than 4 GiB of .glb), IO, MEMORY.""",
    "bolan_export_mesh_desc_default": """The defaults named above the fields. Thread-safe.""",
    "bolan_export_sky": """Writes the sky as an equirectangular map, .exr: channels R, G, B of linear radiance, floats.

Column i looks to the compass direction 360 ((i + 0.5) / width - 0.5) degrees, row j to the elevation
180 (0.5 - (j + 0.5) / height). The sun's disc is not in the map, but in the header, as a light of its own:
sunDirection, the unit vector to it (x east, y north, z up); sunAzimuth, sunElevation [deg]; sunIrradiance, on a
surface that faces it; skyIrradiance, of the map on a horizontal surface. The unit is the irradiance of the sun in
space at normal incidence.
rgb: width * height * 3 floats, row 0 at the top, as bolan_renderer_read_sky() has them.
Errors: ARGUMENT (a size as of bolan_exr_write(), another suffix), UNSUPPORTED, IO, MEMORY.""",
    "bolan_exr_write": """Writes an EXR image of 32-bit floats, ZIP compressed.
The channels, 1..64, may stand in any order and must have different names.
Errors: ARGUMENT, IO, MEMORY (the file is encoded in memory first).""",
    "bolan_exr_write_parts": """Writes an EXR image of 1..16 parts; otherwise like bolan_exr_write().""",
    "bolan_fields_glsl": """The text of shaders/include/bolan_fields.glsl: functions that give displacement, slope, normal, Jacobian and foam of
the sea at a point, for GLSL 330 core and 300 es.
Put it into your shader below its version line.
It is also installed, as share/bolan/shaders/bolan_fields.glsl.
Static storage. Thread-safe.""",
    "bolan_file_check_writable": """Checks that a file can be written at path, so that long work fails before it starts.
Leaves nothing behind.
Errors: IO.""",
    "bolan_file_stream_close": """Gives the file its name, or removes it (keep false). NULL-safe, NULLs. IO where that fails; nothing is left.""",
    "bolan_file_stream_open": """Begins a file at path, as bolan_file_write() would write it: under a temporary name until it is closed.
A device or pipe is opened and written straight. Errors: IO, MEMORY; then *out is NULL.""",
    "bolan_file_stream_write": """Appends size bytes. IO where they cannot be written; then only bolan_file_stream_close() is left to do.""",
    "bolan_file_write": """Writes a whole file.
Symbolic links are followed, also to a name that does not exist yet.
A file that is replaced keeps its mode; hard links to it keep the old content.
A device or pipe is opened once and written straight.
Errors: IO, also for a file without write permission for anybody.""",
    "bolan_files_abandon": """Removes every unfinished file and folder of this library, and ends the ffmpeg processes.
For a signal handler that ends the program: async-signal-safe, from any thread.
Call _exit() next: a thread that begins a file afterwards waits for ever.""",
    "bolan_flow_create": """Creates the flow of a sea, at the time of the sea, and reserves all memory.
The flow keeps nothing of sea, which may be destroyed before it.
Uses the task hook. Errors: MEMORY. Then *out is NULL.
Thread-safe between steps of the sea.""",
    "bolan_flow_destroy": """NULL-safe; NULLs.""",
    "bolan_flow_sea_id": """The number of the sea that the flow belongs to: bolan_sea_id(). Thread-safe.""",
    "bolan_flow_size": """Bytes that the flow holds. Thread-safe.""",
    "bolan_flow_step": """Brings the flow to the time of sea, which is the sea of its creation or a fork of it.
A step to the time at which the flow stands does nothing. Allocates nothing. Uses the task hook. Never fails.
Queries must not run meanwhile.""",
    "bolan_flow_time": """The time of the flow [s]. Thread-safe between steps.""",
    "bolan_format": """Like snprintf(), with numbers in the C locale whatever locale the program has set: a decimal point, no grouping.
For all text that a machine reads.
Thread-safe.""",
    "bolan_format_number": """Writes value as "%.*g" does in the C locale with digits 1..12, several times as fast; -0 keeps its sign.
capacity is 32 at least. Returns the length. Thread-safe.""",
    "bolan_fresnel": """Fresnel reflectance of a dielectric for unpolarised light, exact.
cos_incident: 0..1.
eta: n_transmitted / n_incident: 1.34 from air into the sea, 1/1.34 from below.
Total reflection is included.""",
    "bolan_get_hooks": """Returns the hooks in force; a member is NULL where the built-in behaviour is in force.
A plug-in calls it to add its own hooks to the hooks of the host.
Thread-safe while no thread calls bolan_set_hooks().""",
    "bolan_gl_get_info": """The properties of the context that is current on this thread.""",
    "bolan_gl_state_default": """OpenGL's initial state: the defaults named above.
Thread-safe.""",
    "bolan_ground_bounds": """Bounds [m] of the elevations, at any resolution, in the square of side size [m] from (west, south).
The bounds are not tight. A call costs a few memory reads; for culling.
Thread-safe.""",
    "bolan_ground_create": """Makes a ground of a grid.
Between the nodes the data are interpolated by limited bicubic patches (C1, no overshoot; Fritsch & Carlson 1980).
Below twice the spacing the detail adds ridges and gullies that run down the slopes of the data.
out: receives the ground; NULL on failure.
Errors: ARGUMENT (the sentence names the field), MEMORY.""",
    "bolan_ground_desc_default": """The defaults named above the fields, and no grid.""",
    "bolan_ground_destroy": """Releases the ground.
NULL-safe; NULLs the pointer.""",
    "bolan_ground_elevation": """Elevation [m above mean sea level] at world (x, y) [m], low-passed for a grid of spacing resolution [m].
The data are low-passed where the spacing is coarser than theirs.
Detail of a wavelength below twice the spacing is left out; it fades in up to four times the spacing.
A resolution of 0 keeps everything.
The elevation is continuous in x, y and resolution, and finite everywhere.
Thread-safe.""",
    "bolan_ground_elevations": """Elevations at a regular grid: out[j * nx + i] is bolan_ground_elevation() at (west + i * step, south + j * step).
The spacing step [m] is the resolution.
Uses the task hook; the values are equal to those of single calls for any number of threads.
Thread-safe.""",
    "bolan_ground_generator_default": """The defaults named above the fields.""",
    "bolan_ground_get_extent": """The extent of the data.
Thread-safe.""",
    "bolan_ground_id": """A 64-bit hash of everything that the ground was created from: equal for equal grounds.
Thread-safe.""",
    "bolan_group_speed": """Group speed dw/dk [m/s] at wave number k > 0.""",
    "bolan_host_default": """The defaults named above.
Thread-safe.""",
    "bolan_image_read": """Reads an image of any format of stb_image as 8-bit RGB.
Release it with bolan_release(rgb, width * height * 3).
Errors: IO; FORMAT, also for a header with more pixels than the file can hold, or more than 16384 each way; MEMORY.""",
    "bolan_io_get_features": """Returns the formats of this build.
Thread-safe.""",
    "bolan_jerlov_from_name": """The type of a name ("I", "IA", "IB", "II", "III", "1C", "3C", "5C", "7C", "9C", in any case); -1 when unknown.""",
    "bolan_jerlov_name": """The name of a type, "IB".
Static storage.""",
    "bolan_k_from_omega": """The inverse, to 1e-12 relative (Guo 2002, eq. 13, as first guess, then Newton). omega [rad/s] >= 0. [rad/m]""",
    "bolan_lighting_default": """The sky, technique and shading options of bolan_scene_default().
Thread-safe.""",
    "bolan_lighting_from_scene": """The sky, technique and shading options of scene.
Thread-safe.""",
    "bolan_log": """Emits one log sentence, printf style, with numbers in the C locale.
For the modules of the library and for tools built on it.
Control characters and bytes that are not UTF-8 are escaped as by bolan_text_escape(), so that a sentence is one
line and no input can steer a terminal. A sentence ends after 2047 bytes. Thread-safe.""",
    "bolan_look_default": """The defaults named above the fields.""",
    "bolan_m4_identity": """Returns the identity matrix.""",
    "bolan_m4_inverse": """Returns the inverse of a regular matrix, computed in double.""",
    "bolan_m4_mul": """Returns a * b: b is applied first.""",
    "bolan_m4_mul_v4": """Returns a * v.""",
    "bolan_m4_projection": """Returns a reversed-Z projection with an infinite far plane.
Depth is near / distance: 1 at the near plane, 0 at infinity.
fov_y: vertical field of view [rad].
aspect: width / height.
near_m: distance of the near plane [m], > 0.
zero_to_one: true: clip depth is [0, 1] (clip control). False: it is [-1, 1]; window depth is the same.""",
    "bolan_m4_transpose": """Returns the transposed matrix, which is the inverse of a rotation.""",
    "bolan_m4_view": """Returns the rotation from world axes to camera axes.
Heading by compass, pitch up, roll clockwise, all in [deg].""",
    "bolan_math_to_compass_from": """Converts the mathematical angle where waves GO [rad] to the compass direction they come FROM, [0, 360) [deg].""",
    "bolan_measured_spectrum_destroy": """NULL-safe; NULLs the pointer.""",
    "bolan_measured_spectrum_parse": """Parses one record. The texts are not kept; options NULL: the defaults. On failure out is NULL and one sentence
with name and line is logged: FORMAT, also for a location without data or a sea that cannot be; MEMORY; or ARGUMENT
for options outside their ranges or beyond what the text holds.""",
    "bolan_measured_spectrum_sample": """Any sea as a spectrum on a grid, for tables, plots and files. A measured spectrum alone keeps its grid; a sea with
systems has 96 frequencies in a geometric row, from half of the lowest peak to eight times the highest and at least
over those of the measured spectrum, and 72 directions. Thread-safe.
Errors: MEMORY, FORMAT (a sea of more than 40 m). Then *out is NULL.""",
    "bolan_measured_spectrum_view": """Valid while the spectrum lives. Thread-safe.""",
    "bolan_memory_in_use": """Returns the memory that the library holds now [bytes].
Thread-safe.""",
    "bolan_model_bounds": """The least and the greatest coordinates of the vertices [m].
Thread-safe.""",
    "bolan_model_create": """Makes a model of a copy of the arrays.
out: receives the model; NULL on failure.
Errors: ARGUMENT (an index beyond the last vertex, a vertex that is not finite), MEMORY.""",
    "bolan_model_destroy": """Releases the model.
NULL-safe; NULLs the pointer.""",
    "bolan_model_get_view": """The arrays of the model.
Thread-safe.""",
    "bolan_model_id": """A 64-bit hash of all arrays: equal for equal models.
Thread-safe.""",
    "bolan_model_load": """Reads a model with the assimp library: OBJ, glTF 2.0 and the other formats of that library.
Node transforms are applied.
The albedo is the base colour of the material times the colour of the vertex, both taken as linear.
The sky is open above every vertex. Textures are not read.
A glTF mesh without normals gets flat normals (glTF 2.0, 3.7.2.1).
In other formats the normals are smooth, except at edges of 45 degrees and more.
Limits: 64 MiB, 8388608 vertices, nodes 64 deep.
Errors: IO; FORMAT (a glTF that requires an extension, no triangle, a vertex that is not finite or beyond 1e7 m);
ARGUMENT (offset); MEMORY.""",
    "bolan_monahan_cover": """Fraction covered by whitecaps, by Monahan & O'Muircheartaigh (1980): 3.84e-6 U10^3.41; 0 without wind.
It is limited to 0.95, reached at 38 m/s: the published winds end at 17 m/s, and a hurricane leaves water uncovered.""",
    "bolan_nested_desc_default": """The defaults named above the fields.""",
    "bolan_object_pose": """The pose of an object on water at the present time of its sea.
A floating object rests on the water under five points of its model: bow and stern give its pitch, the sides its
roll, and the mean its height.
Thread-safe between steps.""",
    "bolan_omega_from_k": """w(k): w^2 = (g k + (sigma/rho) k^3) tanh(k h). k wave number [rad/m] >= 0, depth [m] > 0. [rad/s]
Linear theory of gravity-capillary waves over a flat bottom.""",
    "bolan_optics_seen_from_below": """Whether the optics draws views from an eye under the water: PHYSICAL and MIRROR do.
A kind that is none: false.
Thread-safe.""",
    "bolan_parallel": """Runs task over [0, count) on the hook or the built-in pool, and waits for its end.
Loops do not nest: a loop started inside a task runs on the thread of that task.
Thread-safe.""",
    "bolan_parallel_fn": """Runs a whole parallel loop of count items in slices of at least grain, and returns when all are done.""",
    "bolan_param_accepts": """Returns whether value, in the unit of the field, lies in the range and obeys the rules.""",
    "bolan_param_expected": """Describes the values that bolan_param_parse() accepts, for messages: "a number from 0 to 70 m/s".
The text is cut to capacity bytes.""",
    "bolan_param_find": """Returns the row of the field field; NULL when there is none.""",
    "bolan_param_find_key": """Returns the first row with the dotted key path, such as "sky.clouds.cover" or, in a list, "objects.scale".
Returns NULL when there is none.
count: receives the number of rows that share the key.
group: receives the group of the rows; may be NULL.""",
    "bolan_param_get": """Returns the value of the field as a number.
A FLAG gives 0 or 1, a NAME or SET its stored number, a TEXT its length.""",
    "bolan_param_list_keys": """Appends the keys of the map map, "" for the document, to the text words, each once and separated by ", ".
The text is cut to capacity bytes.""",
    "bolan_param_parse": """Reads size bytes of text, the value of a key or an option, into the field.
Numbers are in units of the key.
Names may have any case.
A SET is a list of names, separated by commas or blanks, or "all" or "none".
Returns false where the text is no such value or outside the range; then nothing is changed or logged.""",
    "bolan_param_set": """Writes a number to the field, without a check of its range.
A TEXT stays as it is.""",
    "bolan_params_default": """Sets the fields of the table to their defaults; other fields stay as they are.""",
    "bolan_params_validate": """Checks every field of the table.
At the first wrong field it logs one sentence and returns ARGUMENT.
The sentence begins with where and names the field, the value and what was expected.""",
    "bolan_parse_number": """Reads a decimal number, [+-]digits[.digits][e[+-]digits], that fills all size bytes of text.
The number is correctly rounded and read in the C locale.
Returns false for anything else: blanks, "nan", "inf", hexadecimal, more than 400 bytes, or a number beyond the
range of a double. Thread-safe.""",
    "bolan_png_write": """Writes an 8-bit sRGB image of 3 channels, row 0 at the top, as PNG.
Width and height 1..BOLAN_IMAGE_MOST_SIDE, their product at most BOLAN_IMAGE_MOST_PIXELS.""",
    "bolan_points_close": """NULL-safe; NULLs.""",
    "bolan_points_destroy": """Releases the points and leaves an empty list.
NULL-safe.""",
    "bolan_points_load": """Like bolan_points_parse(), from a file.
Errors: also IO.""",
    "bolan_points_next": """Reads the next points: count receives how many, at most capacity, and 0 at the end. A point that has no z gets
NAN for it. Errors: IO; FORMAT with file and line, also for a file without a point: then nothing more is read.""",
    "bolan_points_open": """Opens a file of points, of the format of bolan_points_parse(), with lines of at most 65535 bytes.
Errors: IO, MEMORY; then *out is NULL.""",
    "bolan_points_parse": """Parses CSV of x,y[,z] [m].
A header line that begins with x is optional. Blank lines and # comments are skipped.
Numbers may stand in double quotes, separated by commas, semicolons or white space.
A number that is missing, not finite or beyond 1e8 m is refused with its line.""",
    "bolan_points_progress": """How much was read and how much there is [bytes]; size is 0 where that is not known, as of a pipe.""",
    "bolan_pond_elevation": """Returns the elevation of the pond's ground [m] at world (x, y) [m], before it is sampled on a grid.
Thread-safe.""",
    "bolan_progress": """Called after each step of work that takes a while: done of total steps.""",
    "bolan_query_below": """The water at count world points xyz [m].

With a sea of order 1 a parcel at rest at (x0, y0, s) is found at x0 + choppiness D(x0, y0, s), horizontally; s is
by the question's stretching. Below the surface folds are not searched: where the water folds the answer belongs to
one of the parcels. A point is wet up to a millimetre above the surface, and above the ground of the water. The
surface is that of bolan_query_heights(), or with a least wavelength that of bolan_query_motion().
With a sea of order 2 the point itself is asked, of waves that longer waves have carried there (flow.h). Without
stretching the flow above the mean level is continued along the tangent there, so that the velocity at the surface
is that of the surface, and the pressure there is 0, to second order. With stretching the heights of long waves do
not carry short ones.
Waves are attenuated over the ground as for bolan_query_surface(); what pairs of waves make, with the square.
Wave layers are added, by linear theory with their own period and depth; the gradient of their edges is ignored.

water needs a flow at the time of its sea: water->flow, bolan_flow_step(). A water without a flow is misuse.
question NULL: the default.
Uses the task hook for large batches. Allocates nothing. Cannot fail. Points that are not finite are dry.
Thread-safe between steps of sea and flow.""",
    "bolan_query_crests": """The crests, local maxima of the height, along the line from from to to, in order; its ends do not count.
step [m], 0.001..1e4: heights are compared this far apart and maxima refined to a thousandth of it. Crests nearer
to one another than two steps may count as one.
Writes at most capacity crests to out and returns how many there are. A line of more than 1e7 steps is misuse.
Otherwise like bolan_query_rays().""",
    "bolan_query_foam": """The foam at count world points xy [m]: bolan_sea_sample.foam of the parcel that bolan_query_heights() finds
there.
Points that are not finite give 0. Otherwise like bolan_query_parcels().""",
    "bolan_query_heights": """Like bolan_query_surface(), for heights alone [m above the datum].
height: receives count floats.""",
    "bolan_query_levels": """The water at a list of levels under the same places: count places xy [m] at levels heights z [m above
the datum], in any order. Writes place i at level l to out[l * count + i].
Each answer is that of bolan_query_below() at (x, y, z), bit for bit; the surface over a place is looked for once.
Otherwise like bolan_query_below().""",
    "bolan_query_motion": """Height, normal and motion of the surface at count world points xy [m], without the waves that the question
leaves out: a long hull does not feel ripples. The rest point is that of bolan_query_surface(); with a least
wavelength, and over a sum of waves, folds are not searched.
The flow has tables of its own: its heights agree with those of bolan_query_surface() within their interpolation.
Otherwise like bolan_query_below(). On dry land the height is the level and nothing moves.""",
    "bolan_query_parcels": """Where the parcels of count rest points rest [m] are: the vertices of a mesh of the surface.

Waves, layers and attenuation over a ground are those of bolan_query_surface(), which finds the same parcel at its
place, or a higher one where the water folds.
spacing[i] >= 0 [m]: the distance of point i to its neighbours in a mesh, for which the waves are low-passed as
by bolan_sea_sample_grid(), so that nothing aliases. Layers keep all their waves. NULL or 0: no low-pass.
Points that are not finite give no displacement and a vertical normal.
Uses the task hook for large batches. Allocates nothing. Cannot fail; a water that is not valid is misuse.
Thread-safe as bolan_query_surface().""",
    "bolan_query_rays": """The first places at which count rays meet the surface, of flat earth.
The surface is that of bolan_query_heights(), or of bolan_query_motion() where the question has a least wavelength.
The place is within 1 mm of the surface along the vertical. A crest that the ray cuts by less than 5 mm may be
passed over, and so may one that is steeper than 8 standard deviations of slope, or 2.5. A ray that is not finite,
or has no direction, hits nothing. A least wavelength needs a flow, as for bolan_query_below(). question NULL:
the default. Uses the task hook. Allocates nothing. Cannot fail. Thread-safe as bolan_query_surface().""",
    "bolan_query_surface": """Computes heights and normals at count world points xy [m].

The fields of the sea are read by cubic splines, as images read them: this is the surface that is drawn.
A sum of waves is summed at the point itself. The layers of the water are added at the rest point of the parcel.

Over a ground each cascade is attenuated by the depth under the rest point of the parcel.
The attenuations are bolan_coast_attenuations() of 4 sqrt(variance) of the cascades.
A sum of waves is attenuated as one cascade, and each layer by itself.
The lift of the mean falls with the square of the attenuation.
The normal includes how the attenuation varies in space.
On dry land the height is the level of the water.
Points that are not finite give the level and a vertical normal.

Positions are reduced in double, so that the accuracy 1e6 m from the origin is that near the origin.
Each result depends on its point alone, never on batch, threads or instruction set.
Uses the task hook for large batches. Allocates nothing.
Cannot fail; a water that is not valid is misuse.
Thread-safe between steps of the sea. A thread that queries while another steps takes a fork: bolan_sea_fork().""",
    "bolan_question_default": """The defaults named above the fields. Thread-safe.""",
    "bolan_raster_desc_default": """The defaults named above the fields.""",
    "bolan_raster_load": """Reads part of a raster, projected or geographic, of any format of GDAL, as elevations on a local grid.
The grid is in metres around (desc->latitude, longitude): azimuthal equidistant, x east, y north, +-radius.
The step of the grid is the resolution of the raster, or coarser where a side would need more than 4096 samples.
Longitudes may run -180..180 or 0..360.
Outside the raster its rim continues.

The metadata of the file are used, and the desc overrides them:
- which variable or band is the elevation: by CF standard_name, name, description, unit; several that may be:
  FORMAT, with their names;
- unit (of the band, else of the vertical CRS), scale and offset, and direction (CF `positive`, standard names of
  depths, a vertical CRS that counts down);
- no-data: the declared value, NaN, mask and alpha bands. Values below -12000 m or above 9000 m, which no place on
  Earth has, and a lone -9999 are no-data too, with a warning;
- coordinates: the CRS; a local CRS is metres. Without any: degrees where the step is below 0.5 and the numbers can
  be degrees, or where they span the globe, else metres, with a warning.

Where no-data or 0 stands for sea, the bed is nowhere above the data around it.
It falls off from the coast like a sandy beach (Dean 1991: 0.1 m^(1/3) distance^(2/3)), to 50 m.
One message of level INFO names what was chosen.
Errors: IO, FORMAT, ARGUMENT (a field of the desc; the place is outside), MEMORY.""",
    "bolan_record_exceedance": """Share of the waves that are higher than height [m]; 0 of no waves. Thread-safe.""",
    "bolan_record_measure": """Measures a record; heights and periods are 0 where there is no wave.
A gap of a real record must be filled or cut out before.
Errors: ARGUMENT (fewer than 2 samples, a rate that is not positive and finite, a sample that is not finite) and
MEMORY. Thread-safe.""",
    "bolan_record_spectrum": """Estimates the directional spectrum of a buoy that follows the surface, by Welch's method: segments of segment
samples that overlap by half, each less its mean, under a Hann window. Its coefficients are those of
Longuet-Higgins, Cartwright & Smith 1963 for the displacements of a buoy (Kuik, van Vledder & Holthuijsen 1988, eq.
3).
east:,north displacements [m]; NULL for both: no directions, and what belongs to them is 0.
segment: a multiple of 4, 16..4096, and at most count.
out: receives segment / 2 - 1 bands, of frequency i rate / segment for i = 1, 2 ...
Relative standard deviation of a density: about 1 / sqrt(number of segments).
Errors: ARGUMENT (as above, also where a sample is not finite), MEMORY. Thread-safe.""",
    "bolan_record_waves": """The waves of count heights heave [m], rate a second. Writes at most capacity waves to out and returns
how many there are. Thread-safe.""",
    "bolan_reflect": """The reflection i - 2 n (n . i) of a direction at a mirror.
i: direction that points towards the mirror.
n: unit normal of the mirror.
Source: Ma, Zhu & Gong 2006, eq. 1, with its sign corrected.""",
    "bolan_refraction_crossing": """Distance from the eye, in plan, at which the refracted path to a point under water crosses the surface [m].
The path is that of least time (Fermat).
Solved by Newton's method on the tangent of the angle in the air, which rises to the root without overshooting.
The shaders do four steps of it.
height: of the eye over the water [m], > 0.
depth: of the point under the water [m], >= 0.
distance: of the point in plan [m], >= 0.""",
    "bolan_refraction_k": """Apparent depth over depth of a point in water, seen from the air: cos theta / sqrt(index^2 - sin^2 theta).
theta: angle of the ray in the air from the vertical [rad], 0..pi/2.
index: refractive index, > 1.
Source: Ma, Zhu & Gong 2006, eq. 7 (with index 1.333).""",
    "bolan_refraction_k_paper": """The paper's approximation of bolan_refraction_k() by two straight lines, its eq. 8.
0.75 - 0.16 theta up to 0.8 rad, 1.26 - 0.8 theta beyond.
It differs from eq. 7 by at most 0.037 on the first line and 0.081 on the second, and by 22 % near the horizon.""",
    "bolan_release": """Releases memory of bolan_allocate().
size is the size that bolan_allocate() was called with.
NULL-safe.""",
    "bolan_renderer_backend": """Returns the backend that the renderer uses: CPU or COMPUTE.
Thread-safe.""",
    "bolan_renderer_bake": """Lets the next view bake, which takes up to some seconds.""",
    "bolan_renderer_bind_fields": """Binds the fields of water, its layers among them, for all programs linked with these units and this slot.
water must be valid: bolan_water_is_valid(). origin: the world point that positions in your shader are
relative to, usually your eye; it is reduced in double.
Uploads once for each bolan_sea_serial(); a second call for another origin costs one small buffer.
The texture bindings and the slot stay as set here, and sampler objects of these units are unbound.
All other state is left as it was. Later draws of this renderer keep them.
Allocates nothing after the first call unless the size of the sea changes.""",
    "bolan_renderer_compile": """Compiles the programs that views of this water with this lighting can need, whatever their eye: over the open sea
and over ground, in a world and in a host's frame, with and without bounds.
Without this call each of them is compiled by the first view that can need it.
progress: is called after each program; may be NULL. user is handed to it.
Errors: GL (no current context, a shader that does not compile), ARGUMENT (as bolan_renderer_prepare() refuses),
MEMORY.""",
    "bolan_renderer_create": """Makes a renderer in the current context.
out: receives the renderer; NULL after an error.
Errors: GL (no context, one older than OpenGL 3.3 or OpenGL ES 3.0, a shader that does not compile), ARGUMENT (a
field out of range), UNSUPPORTED (OpenGL ES without float targets; BOLAN_BACKEND_COMPUTE or BOLAN_PIXELS_COMPUTE
in a context without compute shaders), MEMORY.""",
    "bolan_renderer_declare_state": """With BOLAN_RESTORE_DECLARED: your state when a call begins, which is put back when it ends.
Call it whenever the state at the place of your frame where Bolan is called has changed. Copied.
Until the first call it is bolan_gl_state_default().""",
    "bolan_renderer_desc_default": """The defaults named above.
Thread-safe.""",
    "bolan_renderer_destroy": """Releases the renderer.
The context must be current. Without one the log says so, and only the memory of the CPU is released: that of the
GPU goes with its context.
NULL-safe; NULLs the pointer.""",
    "bolan_renderer_draw_water": """Draws the prepared water, and nothing else, into the view's rectangle.
The water is tested against the depth of the view's framebuffer, sample by sample, and writes depth there, in the
convention of the view's projection: less-or-equal, or greater-or-equal where depth is reversed.
The host's scene is refracted, absorbed and mirrored (screen-space) through its two textures.
host may be NULL: the defaults.
bolan_view::samples is not used: draw with `jitter`, or into a multisampled framebuffer, where each sample has its
own test and the water one colour a pixel.
Several waters: prepare one and draw it, then the next.
No step prepared, a view, texture or polygon that is none, no current context: nothing is drawn, and the log says
why, once.""",
    "bolan_renderer_draw_world": """Prepares the step of world and draws all of it, sky, ground, objects and water, from view.
An unchanged step is not uploaded again, so that any number of views may follow.
The view's rectangle of the first draw buffer is overwritten with sky, land, objects and water, alpha 1. Depth and
stencil of your framebuffer are neither read nor written, and nothing outside the rectangle is touched.
The eye is never moved: bolan_world_clear_eye() keeps one out of the waves.
After the first frames nothing is allocated unless the size, the ground or the sea changes.
A view or framebuffer that cannot be drawn, no current context: nothing is drawn, and the log says why, once.""",
    "bolan_renderer_link_fields": """Sets the samplers and the uniform block of bolan_fields.glsl in your linked program: 4 texture units from
first_unit on, and the uniform buffer slot slot.
Call it once after linking, not in each frame.
Errors: ARGUMENT (no linked program, one that uses no fields, units or a slot that the context has not; logged).
Leaves all other state as it was.""",
    "bolan_renderer_measure_passes": """Switches measuring the time of each pass on or off; default off.
GPU timestamps are used where there are any: they disturb no query of yours, are some frames old when they come, and
are never waited for. Without them (software OpenGL, OpenGL ES) glFinish() after each pass slows the frame.""",
    "bolan_renderer_memory_rate": """Returns the rate at which the GPU copies memory, read and written bytes together [bytes/s]: the mean of repeats
copies of 64 MB. 0 where there is no memory for them.""",
    "bolan_renderer_needs_baking": """Whether the last frame showed something that was baked for another light.
Only the optics MIRROR bakes: loops of its waves with the light on the bottom.
It bakes them when a frame with another sea, water or mode is prepared, and again when the sun has turned by 8
degrees. A view with bolan_view.progressive never bakes for the sun: it keeps the old light, and this returns true.""",
    "bolan_renderer_pixels": """Returns what the renderer shades pixels with: FRAGMENT or COMPUTE.
Thread-safe.""",
    "bolan_renderer_prepare": """Takes a step of the water: uploads its fields unless those of the same serial are on the GPU already.
An unchanged step uploads nothing: see bolan_frame_statistics::uploads.
The fields of the last BOLAN_KEPT_SEAS seas stay on the GPU, so that several waters may take turns in each frame.
Every view that is drawn until the next call shows this step.
water and what it points to are borrowed until then.
No current context, a sea that is NULL or of another wave model than `lighting.technique.waves`, a number out of
range: nothing is prepared, and the log says why, once.""",
    "bolan_renderer_read_linear": """Reads radiance and distance of the last view.
rgb: linear radiance before the tone map, relative to a sun irradiance of 1 in space at normal incidence; the
mean over the view's samples. width * height * 3 floats, or NULL.
distance: from the eye along the view axis, at the middle of the pixel [m]; infinity is the sky.
width * height floats, or NULL.
Row 0 is at the top.
Before the first view, or without a context, the buffers are left alone, logged once.
Allocates only where the view is larger than all that were read before.""",
    "bolan_renderer_read_rgb8": """Reads the 8-bit image of framebuffer, row 0 at the top: width * height * 3 bytes.
A framebuffer that is not complete, has several samples a pixel or holds integers: rgb is left alone, logged
once.""",
    "bolan_renderer_read_sky": """Draws the sky of the prepared step as an equirectangular map, for an eye at eye [m], and reads it.
Column i looks to the compass direction 360 ((i + 0.5) / width - 0.5) degrees, row j to the elevation
180 (0.5 - (j + 0.5) / height). Clouds are in it, the sun's disc is not; directions below the horizon have the
radiance of the horizon.
width:, height of the map, at most what OpenGL can; its detail is that of the clouds of the quality.
rgb: receives width * height * 3 floats, row 0 the zenith, in the units of bolan_renderer_read_linear().
light: receives sun and sky at the sea.
Compiles a program and allocates: not for every frame.
Errors: ARGUMENT (no prepared step, a size), GL, MEMORY.""",
    "bolan_renderer_read_surfaces": """Reads what stands at the middle of each pixel of the last view, which bolan_renderer_draw_world() has drawn of
world and view. Draws land and objects once more, without light, into a target of its own; no picture changes.
The eye is above the level of the water. Water that is seen before land is water, however shallow.
The places are those of a flat earth; within 1 km of the eye its curvature moves them by less than 0.1 m of height.
Before such a view, of another size, with `motion` and without `flow`, or from below the level, the buffers are left
alone, logged once. Allocates.""",
    "bolan_renderer_reload": """Compiles all shaders again from shader_directory, those of its view caches too.
Errors: GL (a shader that does not compile; the old programs stay).""",
    "bolan_renderer_statistics": """The statistics of the last finished frame.""",
    "bolan_renderer_yardstick": """The yardstick of the benchmarks: a full-screen pass of 6 bilinear RGBA16F fetches at this size.
Returns the mean time of repeats passes [ms].""",
    "bolan_result_string": """Returns a short English name of a result code, such as "format error".
Static storage. Thread-safe.""",
    "bolan_scene_builtin_name": """Returns the name of a built-in scene; NULL past the last.""",
    "bolan_scene_camera_at": """Returns the camera at time [s]: on the path through the keys, or scene->camera where there are no keys.
Before the first key and after the last the camera stands still.
The path is smooth and overshoots no key (monotone cubic pieces, Fritsch & Carlson 1980).
Headings turn the short way.""",
    "bolan_scene_default": """Returns a scene with every default: open sea, wind 8 m/s, camera 3 m up, sun 35 degrees high.""",
    "bolan_scene_load": """Reads a scene: the name of a built-in scene ("island"), or a path to a YAML file of at most 256 KiB.
Relative paths in the file are relative to the folder of the file.
On failure scene is untouched.
Errors: IO, or FORMAT with file, line and key (an unknown key, a value outside its range, text that is not YAML).""",
    "bolan_scene_parse": """Parses YAML text of size bytes.
name is used in messages.
Relative paths stay as they are.""",
    "bolan_scene_sea_desc": """Returns the desc of the scene's sea with the options of scene->look applied.
In paper mode the sea takes the choices of the papers: sharpness 1, equal width of frequencies.""",
    "bolan_scene_set_technique": """Gives the scene another technique.
The sea takes the wave model of the technique.
The wind sea is built anew where the technique changes its spectrum.""",
    "bolan_scene_set_wind": """Gives the scene another wind of wind_speed [m/s] FROM from_deg [deg].
The wind sea is built anew from the wind, scene->fetch, and the technique's spectrum or scene->wind_spectrum.
A Pierson-Moskowitz sea is fully developed whatever the fetch; a TMA sea takes the sea's depth. Other systems stay.
The wind sea is the first wave system, where that has a wind_speed above 0.
With a spectrum file, or without scene->wind_sea, the wind only roughens the waves that are there.
bolan_scene_validate() checks the values.""",
    "bolan_scene_validate": """Checks every field against its range.
Logs a sentence that names the first field out of range, and returns ARGUMENT.""",
    "bolan_sea_bounds": """Returns bounds that the surface does not leave, 6 standard deviations: vertical with the lift [m], horizontal with
the choppiness [m]. Thread-safe, also during a step.""",
    "bolan_sea_breaker_threshold": """Returns the Jacobian below which a crest is breaking: the quantile that covers bolan_breaker_cover() of the surface.
Where the sea has no foam memory, which would hold the older foam, it covers bolan_callaghan_cover().
-1e30 where nothing breaks. Thread-safe.""",
    "bolan_sea_cascade": """Returns cascade index; 0 is the one of the longest waves.""",
    "bolan_sea_cascade_count": """Returns the number of cascades: 1..BOLAN_MAX_CASCADES of form CASCADES, else 0. Thread-safe, also during a step.""",
    "bolan_sea_cascade_layout": """Like bolan_sea_cascade(), without the planes: the pointers are NULL, and no fields are made.""",
    "bolan_sea_component_count": """Returns the number of waves of a sum; 0 of form CASCADES. Thread-safe, also during a step.""",
    "bolan_sea_create": """Creates a sea: builds the spectrum tables and reserves all memory, so that no later call allocates.
The sea stands at time 0.
The desc is copied; a measured spectrum in it is not needed afterwards.
Uses the task hook; a sea steps on at most as many workers as there were at its creation.
Errors: ARGUMENT, with the field named in the log, and MEMORY. Then *out is NULL. Thread-safe.""",
    "bolan_sea_desc_default": """Returns the defaults named above the fields: a fresh breeze over the open sea. Thread-safe.""",
    "bolan_sea_destroy": """Destroys a sea. NULL-safe; sets the pointer to NULL.
The tables that forks share are released with the last of them.""",
    "bolan_sea_fields": """Makes the fields of the present time, unless they are made already. Every function that reads a field calls it.
It catches up with the ticks of the foam memory since the fields were made the last time, at most those of 5
foam_decay.
Call it after a step to choose the moment of the work, and before jobs of your own task system read the sea: a job
that waits for the fields must not run on a thread that is making them.
Uses the task hook. Thread-safe between steps.""",
    "bolan_sea_fine": """Returns the fine waves at the present time, which the first call after a step makes; bolan_sea_fields() does not.
The pointers are valid while the sea lives; what they point to is of the present time until the next step.
Thread-safe between steps. Source: Phillips 1958 (k^-4), Cox & Munk 1954 (variance), Lamb 1932 (dispersion).""",
    "bolan_sea_fine_layout": """Like bolan_sea_fine(), without the planes: the pointers are NULL, and nothing is made.""",
    "bolan_sea_foam_drift": """Returns how far foam has drifted over the water by a tick, along the axes of the tile of a cascade.
The unit is 2^-32 of the length of the tile, modulo that length, so that products with whole numbers are exact. The
speed is 3.1 % of the wind speed (Wu 1983). With a loop it is rounded to whole tiles in a loop, which it so closes.
tick is a number of a tick, or between two. Thread-safe, also during a step.""",
    "bolan_sea_foam_threshold": """Returns the Jacobian below which there is foam.
It is the quantile of the Jacobian that covers bolan_monahan_cover() of the surface for the wind; above 1 where more
than about half is covered.
-1e30 where nothing foams: without wind, without waves, and with EXP_COSINE.
Computed at creation. Thread-safe, also during a step.""",
    "bolan_sea_fork": """Creates a sea that shows the same waves as sea at another time, for example for a physics thread.
The fork shares the spectrum and all tables with sea, which are constant, and has fields and a foam memory of its
own. At equal times the fields of all forks have the same bits.
The fork stands at time 0, with an empty foam memory, whatever the time of sea.
It lives on its own: forks and their origin may be destroyed in any order, on any thread.
Its memory is that of the fields alone.
Errors: MEMORY. Then *out is NULL. Thread-safe, also during a step of sea.""",
    "bolan_sea_form": """Returns what the fields are read from. Thread-safe, also during a step.""",
    "bolan_sea_get_clock": """Returns the present clock; makes no fields.""",
    "bolan_sea_get_component": """Returns wave index of the sum; 0 is the longest. Thread-safe, also during a step.""",
    "bolan_sea_get_desc": """Returns the desc the sea was made from, defaults resolved; `measured` is NULL.
Valid while the sea lives. Thread-safe, also during a step.""",
    "bolan_sea_get_loop": """Returns how the sea repeats in time, and the present frame.""",
    "bolan_sea_get_summary": """Returns the integral parameters of the sea state, lowered by bolan_sea_state_limit(); of a measured spectrum too.
Computed at creation. Valid while the sea lives. Thread-safe, also during a step.""",
    "bolan_sea_get_warp": """Returns the warp of a sea. Thread-safe, also during a step.""",
    "bolan_sea_hash": """Writes a digest of every field at the present time, the foam memory excluded: 16 lower-case hex digits and NUL.
Of a sum, of the fields at 4096 places.
Equal for any thread count, any instruction set and any fork.""",
    "bolan_sea_id": """Returns the number of the sea: never 0, equal for all forks, and different for all other seas of this process.
Compare it, not the address, to tell whether something made from a sea still belongs to it.
Thread-safe, also during a step.""",
    "bolan_sea_lift": """Returns what band index adds to every height to keep the mean of the surface at the water level [m].
It is >= 0 with order 1. Bound waves have a mean of their own, which it takes away.
A band is a cascade, or all components of a sum (index 0).
spacing [m] is that of the grid that carries the waves; 0: a single point.
0 without choppiness and for EXP_COSINE, whose parcels do not move sideways. Thread-safe, also during a step.""",
    "bolan_sea_measure": """Measures the surface over the largest tile, or of a sum over 50 of its longest waves.
As slow as a step.""",
    "bolan_sea_mode_rows": """Returns how many rows of modes a cascade has: j = 0 .. rows - 1; the others are empty. Thread-safe, also during a
step.""",
    "bolan_sea_modes": """Copies waves part, 0 .. BOLAN_MODE_PARTS - 1, of row j of the modes of a cascade: out[0 .. n - 1], where entry
i holds -n/2 <= i < n/2 modulo n.
For a synthesis of your own, on a GPU. Row 0 holds both (i, 0) and (-i, 0). Thread-safe, also during a step.""",
    "bolan_sea_place_read": """Returns the place at which the cascades are read for the rest point (x, y).
gradient receives dplace/drest: xx, xy, yx, yy. Thread-safe, also during a step.""",
    "bolan_sea_record_time": """Returns when the measured spectrum was taken, ISO 8601; "" when it does not say or there is none.
Valid while the sea lives. Thread-safe, also during a step.""",
    "bolan_sea_sample_direct": """The oracle of bolan_sea_sample_rest(): the same quantities at one rest point and any time by the direct sum over
every mode, in double, with the same lift. The foam of the result is 0.
O(n^2) a point. Thread-safe, also during a step.""",
    "bolan_sea_sample_grid": """Like bolan_sea_sample_rest(), low-passed for a grid, so that nothing aliases. Uses the task hook.
spacing[i] >= 0 [m] is the distance of point i to its neighbours. NULL: no low-pass.
Waves fade out from 4 to 2 spacings of length.
A cascade is averaged over a square of two spacings by up to 4 x 4 texture fetches, and fades as a whole from 4 to 2
spacings of its longest wave: waves shorter than two spacings keep about 1/16 of their energy.
For sums this is the fast way to displace a mesh, by SIMD over the points.""",
    "bolan_sea_sample_rest": """Samples the sea at count rest points in world metres.
Sums of waves use the task hook.""",
    "bolan_sea_serial": """Returns the number of the present fields: never 0 and unique in this process, so that equal serials mean equal
fields. Every step and settle changes it, except a step to the time of the last step.""",
    "bolan_sea_settle": """Like bolan_sea_step(), with a full foam memory, so that a single image has the foam of a sea that has run.
Its fields are made by the ticks of 5 foam_decay before time. A tick costs about a quarter of a synthesis: 5 of
them for each second of foam_decay.""",
    "bolan_sea_size": """Returns the memory that a sea of this desc will hold, without creating it: exact with as many workers as now, since
fields include scratch memory for each. The creation borrows up to 1 MB more.
Both are 0 where the desc is not valid, with the field named in the log. Allocates nothing. Thread-safe.""",
    "bolan_sea_slope_table": """Texels of the slope table along log2(major): texel i is major = 2^(i/1.5 - 11) m, from 0.5 mm to 200 m.
Texels along minor/major: texel j is 2^-j.
Texels along the angle, periodic: texel l is l pi / 8.
Returns bolan_sea_unresolved_slopes() as a table to sample with linear filtering:
out[((l * ASPECT) + j) * MAJOR + i][4] = xx, xy, yy, and the share of their slope variance that the footprint
removes of the fine waves. Where they are drawn (bolan_sea_fine()), take off what they keep: slopes * (1 - share).
Computed at creation. Valid while the sea lives. Thread-safe, also during a step.""",
    "bolan_sea_state_add_ochi_hubble": """Members of Ochi & Hubble's family.
Adds the two peaks of Ochi & Hubble (1976) for one height, with cos-2s spreading of s = 10.
hs: significant height of the sum [m], 0..40. (In the paper's rounded table the squares of both heights add to
0.995..1.009 of hs^2; here to hs^2.)
member: 0 the most probable shape; 1..10 those of the 95 % confidence limit, as docs/sea-states.md lists them.
from_deg: where both peaks come FROM, compass [deg].
Errors: as bolan_sea_state_add_system().""",
    "bolan_sea_state_add_swell": """Adds a swell: JONSWAP with gamma 5 (Goda 2010: 3..10 for swell) and cos-2s spreading.
hs: significant height [m].
tp: peak period [s].
from_deg: where the swell comes FROM, compass [deg].
spread_s: exponent s of cos-2s; 25..75 is usual.
Errors: ARGUMENT with a sentence, when the list is full or a value is outside its range.
The sea state is then unchanged.""",
    "bolan_sea_state_add_system": """Adds a wind sea or swell to the sea.
Errors: ARGUMENT with a sentence, when the list is full or a field is outside its range.
The sea state is then unchanged.""",
    "bolan_sea_state_add_torsethaugen": """Adds the two peaks of Torsethaugen & Haver, "Simplified double peak spectral model for ocean waves" (ISOPE 2004).
Tp up to 6.6 hs^(1/3) is a wind sea with some swell; a longer Tp is a swell with some wind sea. The swell has cos-2s
spreading of s = 30, the wind sea of s = 10.
hs: significant height of the sum [m], 0..40.
tp: period of the higher peak [s], 1..60.
from_deg: where both peaks come FROM, compass [deg].
Errors: as bolan_sea_state_add_system().""",
    "bolan_sea_state_default": """A flat calm over deep water: no systems, no wind.""",
    "bolan_sea_state_density": """S(w, th) of the whole sea [m2 s/rad per rad], on its current: omega is the frequency in the water, sigma,
whatever the frame of the sea state. A measured spectrum is interpolated bilinearly, which conserves its m0, and is
0 outside its frequencies.""",
    "bolan_sea_state_from_beaufort": """The wind sea of a Beaufort number 0..12 (v = 0.836 B^1.5), fully developed. Other numbers are misuse.""",
    "bolan_sea_state_from_donelan": """A wind sea after Donelan, Hamilton & Hui (1985), with Donelan-Banner spreading.
U/cp = 11.6 (g F/U^2)^-0.23, at least 0.83: the fully developed sea. alpha = 0.006 (U/cp)^0.55,
S = alpha g^2 w^-4 / wp exp(-(wp/w)^4) gamma^r, gamma = 1.7 + 6 log10(U/cp) for U/cp above 1 and 1.7 below,
r = exp(-(w/wp - 1)^2 / (2 s^2)), s = 0.08 (1 + 4 (U/cp)^-3). gamma and s keep their values beyond U/cp = 5.
Arguments and limits are those of bolan_sea_state_from_wind().""",
    "bolan_sea_state_from_douglas": """The sea of a Douglas / WMO 3700 degree 0..9: Hs in the middle of the class (16 m for 9, which has no upper bound),
PM shape, and the wind that raises it. Other degrees are misuse.""",
    "bolan_sea_state_from_elfouhaily": """A wind sea after Elfouhaily, Chapron, Katsaros & Vandemark (1997), with the paper's spreading.
U/cp = 0.84 tanh((g F/U^2 / 2.2e4)^0.4)^-0.75 (eq. 37). The curvature spectrum of the short waves is multiplied by
the cut of the long ones, exp(-1.25 (kp/k)^2), as in the authors' programs; without it m0 has no limit.
Arguments and limits are those of bolan_sea_state_from_wind().""",
    "bolan_sea_state_from_phillips": """The wind sea of a Phillips spectrum, on the half plane that the wind blows to:
Psi(k) = 2 A exp(-1/(kL)^2) k^-4 cos^2(th) e^{-k^2 l^2}, L = U10^2/g, l = L/1000.
The printed form has no 2 and is equal for k and -k, so half of its energy runs against the wind.
Here all energy travels with the wind, with the same m0 = A pi L^2/2.
A = 0.0081/(2 pi) gives the tail of Pierson-Moskowitz and Hs = 0.18 U10^2/g.
In deep water the shape is that of Pierson-Moskowitz, with the peak at (4/5)^(1/4) g/U10.
Arguments and limits are those of bolan_sea_state_from_wind().""",
    "bolan_sea_state_from_wind": """A wind sea: JONSWAP by wind and fetch, limited to the fully developed Pierson-Moskowitz sea.
wind_speed: U10 [m/s], 0..70; a value outside is kept for bolan_sea_state_validate() to refuse.
from_deg: where the wind comes FROM, compass [deg].
fetch: [m] > 0; HUGE_VAL: no limit.

Growing sea (Hasselmann et al. 1973): alpha = 0.076 (U^2/(g F))^0.22, wp = 22 (g^2/(U F))^(1/3), gamma 3.3.
wp falls to the Pierson-Moskowitz peak 0.877 g / (1.026 U10); within 10 % of it gamma passes linearly into 1.
Hs grows with the fetch up to that of the fully developed sea, 0.209 (1.026 U10)^2 / g.
Hs arrives there at 0.63 of the fetch at which the peak arrives. Hs is at most 40 m.
No wind, no fetch, or a peak above 50 rad/s (ripples) give no system.""",
    "bolan_sea_state_limit": """The limits of a valid sea state. Integrates the whole spectrum: milliseconds. Thread-safe.""",
    "bolan_sea_state_partition": """Most parts of a sea; of more the smallest join their nearest.
Splits a sea into wind sea and swells, by a watershed of S(w, th) (Hanson & Phillips 2001; Portilla et al.
2009). The variances of the parts add up to that of the sea: of a measured spectrum exactly, of systems within 1 %.
With a wind, parts whose waves run slower than 1.5 wind_speed along it are one wind sea; without one, a part is wind
sea where its peak lies above that of Pierson-Moskowitz at its frequency.
out: the wind seas, then the swells, each by falling height.
count: receives how many; 0 of a calm.
Takes milliseconds. Thread-safe. Errors: MEMORY, FORMAT (a sea of more than 40 m); then count is 0.""",
    "bolan_sea_state_summary": """Integrates the whole spectrum: milliseconds. Thread-safe.""",
    "bolan_sea_state_validate": """Checks every field against its range; logs a sentence and returns ARGUMENT at the first that is not.""",
    "bolan_sea_state_wavenumber_density": """Psi(kx, ky) = S(w, th) (dw/dk) / k [m4]: variance density over wave vectors that point where the waves go, on the
current of the sea.
Includes the w^-5 tail that continues a measured spectrum above its last frequency, so that the synthesised sea
has short waves: level of its last band with energy, directions of its last three such bands. 0 at k = 0.""",
    "bolan_sea_step": """Moves the sea to time [s]: any finite value, backwards too.
Its fields are made when one of them is read: bolan_sea_fields().
Beyond 2^36 s, 2000 years, the time wraps round.
A step to the time of the last step does nothing. Never fails.""",
    "bolan_sea_tick_time": """Returns the time of the waves at a tick of the foam memory [s]. Thread-safe, also during a step.""",
    "bolan_sea_time": """Returns the time of the last step [s].
A sea of TEXTURES shows the frame of its loop at that time.
Thread-safe between steps, like every function below that says nothing else.""",
    "bolan_sea_unresolved_slopes": """Returns the slope covariance that a filter removes: what a pixel or a radar cell cannot resolve and must treat as
roughness.
The filter is a Gaussian footprint of standard deviations major, minor [m], whose major axis points along
angle (mathematical, rad). It keeps exp(-sigma^2 k^2) of the power of a wave.
Waves shorter than the last cascade are always removed: Cox & Munk's total for the wind less what the cascades hold.
With major = minor = 0 they alone are left.
out: xx, xy, yy.
Thread-safe, also during a step. Source: Bruneton, Neyret & Holzschuch 2010, section 4.""",
    "bolan_set_hooks": """Replaces the hooks; NULL restores the built-in behaviour.
Call it before anything is created and while no other thread is in the library, because memory must be released by
the hook that allocated it.
Not thread-safe.""",
    "bolan_set_threads": """Sets the number of threads of the built-in pool, the calling thread included.
1..64; default 1, where the library starts no thread. 0: one for each online processor.
The threads sleep between loops; 1 ends them.
Results never depend on the number of threads.
Not thread-safe.""",
    "bolan_sincos": """Sine and cosine of x [rad], |x| < 1e6, with an error below 2 ulp of 1.
The bits are the same with every machine, compiler and instruction set, because neither libm nor fused multiply-add
is used. Called wherever a result must be reproducible.""",
    "bolan_sincosf": """The float twin of bolan_sincos(), as the wide kernels compute it: |x| <= 8192, error < 2e-7.
The bits are the same everywhere too.""",
    "bolan_spectrum_companion": """How many tables NDBC publishes beside a density: swdir, swdir2, swr1, swr2.
Name of the file of table index, in the order of bolan_spectrum_texts, that belongs to the density path: for
NAME.data_spec (real time) NAME.swdir, .swdir2, .swr1, .swr2; for NAMEwYEAR.txt (history) the same name with d, i,
j, k. False, and out is "", where path is no name of that kind or capacity is too small. Reads no file.
Thread-safe.""",
    "bolan_spectrum_contents_destroy": """NULL-safe; NULLs the pointer.""",
    "bolan_spectrum_contents_load": """Lists what such a file holds. Errors: IO, UNSUPPORTED, and those of bolan_spectrum_contents_parse().""",
    "bolan_spectrum_contents_parse": """Lists what the texts hold. FORMAT with a sentence for what is no spectrum file, or where no spectrum of it can be
read; MEMORY.""",
    "bolan_spectrum_load": """Reads a measured spectrum file of at most 64 MiB, also packed by gzip; bolan/formats.h names the formats.
The tables of directions that NDBC publishes beside a density are used where they lie beside it: for NAME.data_spec
(real time) NAME.swdir, .swdir2, .swr1, .swr2; for NAMEwYEAR.txt (history) the same name with d, i, j, k.
A path that begins with "builtin:" names a shipped spectrum ("builtin:synthetic-bimodal").
options: NULL: the defaults.
Errors: IO, UNSUPPORTED (a packing that this build does not have), and those of bolan_measured_spectrum_parse().""",
    "bolan_spectrum_options_default": """The defaults named beside the fields.""",
    "bolan_spectrum_options_set_location": """Reads "2" or "174.67,-38.17" into location and place. False, and nothing changed or logged, if it is neither.""",
    "bolan_spectrum_options_set_record": """Reads "3" or "2018-01-01T06:00" into record and time. False, and nothing changed or logged, if it is neither.""",
    "bolan_spectrum_options_validate": """Checks every field against its range; logs a sentence and returns ARGUMENT at the first that is not.""",
    "bolan_spectrum_save": """Writes the spectrum of a sea in the form that the suffix of path names:
- .png: a polar plot of 960 x 720 with axes, scale, heights, periods and the parts of bolan_sea_state_partition();
- .csv: frequency [Hz], direction FROM [deg], density [m2/Hz/deg], a row a cell;
- .spec: SWAN text, which bolan_spectrum_load() reads back equal within 5e-8 of the largest density.
The grid is that of bolan_measured_spectrum_sample(). title stands above the plot.
Errors: ARGUMENT (another suffix), IO, MEMORY, FORMAT (a sea of more than 40 m). Then nothing is written.""",
    "bolan_spectrum_texts_default": """No text.""",
    "bolan_sun_position": """Position of the sun at unix_time [s since 1970-01-01 UTC] seen from latitude, longitude [deg, north and
east positive].
azimuth: receives the compass direction [deg].
elevation: receives the elevation [deg] without refraction.
Within 0.02 deg for the years 1950 to 2050.
Source: the Astronomical Almanac's low-precision sun (Michalsky, Solar Energy 40, 1988).""",
    "bolan_surface_desc_default": """The defaults named above the fields.""",
    "bolan_surface_grid_indices": """Writes the indices of a grid, 6 per cell, counter-clockwise seen from above.
Returns their number, (columns - 1) * (rows - 1) * 6.
out: receives the indices; NULL asks for the number alone.""",
    "bolan_surface_nested_indices": """Writes index list part of level as triangles, counter-clockwise seen from above, and returns their count.
The count is 0 where the finest level has no such part.
The T-strips are the outermost ring of cells of the level; the blocks lie between the ring and the hole.
The finest level is one block, part 0, with its ring.
All parts together have 2 n^2 triangles for the finest level and 2 (n^2 - n^2/4) for each other level.
out: receives the indices; NULL asks for the count alone.
Thread-safe.""",
    "bolan_surface_nested_normals": """Normals of the displaced mesh after the paper: the mean of the unit normals of the triangles round each vertex.
Where two levels meet, the triangles of both count.
A stitched vertex lies on the edge between its neighbours and has the mean of their normals.
Vertices inside a hole have normals that point up.
positions: displaced vertices, bolan_surface_nested_vertex_count() of them.
normals: receives as many unit vectors.
Thread-safe, allocates nothing.
Source: Liu, Xu & Chen 2009, section 3.""",
    "bolan_surface_nested_place": """Places the levels for a view.
The centre is the point of mean water in the middle of the view.
The centre is moved nearer where that point is too far for the finest level to be seen.
The bound is twice the distance of the nearest water in view (or twice the eye's height).
Every level stands on exact multiples of its own spacing and moves in steps of two spacings.
So no vertex moves over the water.
For n > 4 the place of a level depends on the centre and its spacing alone; for n = 4 the hole cannot move.
Levels whose cells would be smaller than two pixels are left out.
Values of desc outside their ranges are clamped.
Pure, thread-safe, the same on every machine.
Source: Liu, Xu & Chen 2009, section 1.""",
    "bolan_surface_nested_vertex_count": """Number of vertices: (n + 1)^2 for each level.""",
    "bolan_surface_nested_vertices": """Writes the vertices, level by level, row by row from the south-west: vertex (i, j) of a level is its (j (n + 1) +
i)th.
Each array has bolan_surface_nested_vertex_count() elements or is NULL.
view: may be NULL where only rest is asked for.
rest: receives world positions [m].
vertices: receives vertices relative to the eye.
visible: receives 1 where the view can show a triangle of the vertex, and 0 where no waves are needed.

Visibility is tested by two cross products in plan, widened by a cell and the bounds of the displacement (section
4). A view that is wide or looks down is tested by its four side planes.
Vertices inside a hole are written too; no triangle uses them.
The spacing of a vertex grows from d at the centre to 2 d at the border of its level.
So the spacing is continuous over the water and in time.
Where levels meet, both have the same position, spacing and visibility, bit for bit.
Odd vertices on the border of an inner level are stitched (section 2); their neighbours are never stitched.
Pure, thread-safe, allocates nothing.""",
    "bolan_surface_projected": """Writes the projected grid of a view.
vertices: receives the grid; its capacity is desc->max_vertices.
Pure, thread-safe, allocates nothing.""",
    "bolan_surface_projector_of": """The projector of a view.
Pure, thread-safe.""",
    "bolan_surface_projector_size": """The size of the projector's grid: angular steps of desc->pixels_per_vertex pixels, larger ones where
desc->max_vertices asks for it. 0 columns and rows where no water can be in view.
The cells along both sides are whole blocks of block x block cells, 1..BOLAN_SURFACE_MAX_BLOCK, so that a grid
can be drawn as instances of one block.
projector: that of view; its azimuths are widened by what columns that are snapped may fall short.
Pure, thread-safe.""",
    "bolan_surface_projector_uniforms": """The projector as the uniforms of a vertex shader; the twin is grid_point() in shaders/common/grid.glsl.
out: near_parameter, range, height, above, azimuth of the middle (snapped to the columns), half, guard, earth
radius.""",
    "bolan_surface_projector_vertices": """Writes the projector's grid of size, in the order of bolan_surface_projected().
size: columns and rows, each at least 2.
Pure, thread-safe.""",
    "bolan_surface_quad": """Writes the quad: a square round the point under the eye, on the flat plane of mean water.
A side is as long as the distance to the horizon.
Draw only what lies within half a side of the point under the eye; the corners lie outside.
Reason: farther out the flat plane stands above the horizon of the round earth.
vertices: south-west, south-east, north-west, north-east.
Pure, thread-safe.
Source: Ma, Zhu & Gong 2006, section 2.1.""",
    "bolan_system_density": """S(w) of one system [m2 s/rad], integrated over direction, in water of depth [m] (TMA only); 0 at omega <= 0.
JONSWAP is (5/16) Hs^2 wp^4 C(gamma) w^-5 exp(-1.25 (wp/w)^4) gamma^r. C, as the level of every other kind, is by
quadrature, so that 4 sqrt(m0) is Hs.
ELFOUHAILY, a function of wave number, is taken at the deep-water wave number of w.""",
    "bolan_system_spreading": """D(w, th) [1/rad]: theta is the angle from the system's mean direction [rad]. Integrates to 1, swell factor
included.""",
    "bolan_target_create": """Makes a target of width x height pixels, 1..16384 each, in the current context.
out: receives the target; NULL after an error.
Errors: ARGUMENT (another size), GL (no context, or one that is too old), MEMORY.""",
    "bolan_target_destroy": """Releases the target.
The context must be current. Without one, the log says so, and only the memory of the CPU is released.
NULL-safe; NULLs the pointer.""",
    "bolan_target_framebuffer": """The GL name of its framebuffer, for bolan_view::framebuffer.""",
    "bolan_target_show": """Copies the image into the whole of framebuffer (GL name; 0 is the window), which is width x height pixels.
Where the sizes differ the image is scaled with bilinear filtering.
A framebuffer that cannot be drawn into, or a size that is not 1..16384 each way: nothing is copied, logged once.""",
    "bolan_task_fn": """A slice of a parallel loop: processes the items [begin, end).
worker is in [0, workers) and unique among the slices that run at the same time, so it can index scratch memory.""",
    "bolan_technique_find": """The technique of that name; NULL when there is none.
Thread-safe.""",
    "bolan_techniques": """All techniques, the default first; count receives their number.
Static storage.
Thread-safe.""",
    "bolan_text_escape": """Copies text for a terminal.
Control characters (C0, DEL, C1, line breaks, changes of direction) and bytes that are not UTF-8 become escapes,
such as \\\\n, \\\\t, \\\\x1b or \\\\u009b. An incomplete character at the end is left out. The copy ends with the last
whole character that fits into capacity bytes, NUL included. Thread-safe.""",
    "bolan_text_fit": """Returns how many bytes of text fit into most without a cut inside a UTF-8 character; for "%.*s".
Thread-safe.""",
    "bolan_threads": """Returns the number of workers that a parallel loop may use now, >= 1.
Thread-safe.""",
    "bolan_tile_caustics": """Caustics on a flat bottom under a periodic n x n height tile, relative to flat water: the mean is 1.
Sunlight is refracted at each texel; the triangles between the points where it lands carry its light there.
Folded triangles count too. The shift of the whole pattern by a low sun is removed.
length: side of the tile [m].
depth: depth of the bottom under the mean of the tile [m].
sun: unit direction to the sun.
index: refractive index of the water.
light: receives n n floats.
Thread-safe.""",
    "bolan_tile_normals": """Normal map of a periodic n x n height tile.
T1 = (1, 0, s (h[x+1] - h[x-1])), T2 = (0, 1, s (h[y+1] - h[y-1])), N = T1 x T2; bytes N/|N| * 127.5 + 127.5.
s: factor on the differences [1/m]. The paper has 1 / texel size.
The true slope has half of that, since a difference spans two texels.
rgb: receives 3 n n bytes.
Thread-safe.
Source: Ma, Zhu & Gong 2006, section 2.3 (3).""",
    "bolan_tiles_bake": """Bakes the tiles of every frame of a sea of BOLAN_WAVES_TEXTURES.
The sea is stepped through its loop and back to its time.
Uses the task hook.
out: receives the tiles; NULL on failure.
Errors: ARGUMENT (the sentence names the field; or the sea has another wave model), MEMORY.""",
    "bolan_tiles_check_writable": """Checks that bolan_tiles_save() could write the folder.
Leaves nothing behind.
Errors: IO.""",
    "bolan_tiles_create": """Makes tiles of a copy of the arrays of a view, for example from files.
Errors: ARGUMENT, MEMORY.""",
    "bolan_tiles_desc_default": """The defaults named above the fields.
Thread-safe.""",
    "bolan_tiles_destroy": """Releases the tiles.
NULL-safe; NULLs the pointer.""",
    "bolan_tiles_frame": """The frame of the loop at time [s].
share: receives the weight of the next frame, 0..1.
Thread-safe.""",
    "bolan_tiles_get_view": """The arrays of the tiles.
Thread-safe.""",
    "bolan_tiles_load": """Reads a folder of bolan_tiles_save().
index.json must be one JSON object with the numbers that bolan_tiles_save() writes, each once, and nothing else.
Errors: IO; FORMAT, with the file and what is wrong in it; ARGUMENT; MEMORY.""",
    "bolan_tiles_save": """Writes tiles into the new folder folder, whole or not at all.
The folder holds index.json and, for each frame NNN from 000:
- height_NNN.pgm (16-bit grey: (value - 32768) * height_step metres);
- normal_NNN.png, detail_NNN.png, caustics_NNN.png.

Row 0 of an image is row 0 of the tile.
Errors: IO (the folder exists or cannot be written), MEMORY.""",
    "bolan_version": """Returns the version of the linked library, "major.minor.patch".
Static storage. Thread-safe.""",
    "bolan_video_check": """Checks that a film can be begun, so that long work fails before it starts.
Leaves nothing behind.
Errors: those of bolan_video_open().""",
    "bolan_video_close": """Ends the stream and waits for ffmpeg.
The file gets its name when ffmpeg has succeeded without a message and the container is complete.
keep: false: the film is discarded.
NULL-safe; NULLs the pointer.
Errors: IO, with the first line of ffmpeg's messages.""",
    "bolan_video_open": """Begins a film by starting the `ffmpeg` program: .mp4 (H.264, yuv420p) or .webm (VP9) by the suffix.
Width and height must be even; fps is 1..240.
Errors: UNSUPPORTED where ffmpeg is not installed; ARGUMENT, also for a device or pipe; MEMORY; IO, with the message
of ffmpeg.""",
    "bolan_video_write": """Appends a frame, rgb as for bolan_png_write().
Errors: IO when ffmpeg has ended; then call bolan_video_close().""",
    "bolan_view_cache_create": """Makes an empty cache.
out: receives the cache; NULL after an error.
Errors: GL, MEMORY.""",
    "bolan_view_cache_destroy": """Releases the cache.
The context must be current. Call it before the renderer is destroyed.
NULL-safe; NULLs the pointer.""",
    "bolan_view_default": """The defaults named above, 10 m over the datum, looking north with a vertical field of view of 50 degrees.
Thread-safe.""",
    "bolan_view_from_camera": """The view of camera into a picture of that size, into the window.
Thread-safe.""",
    "bolan_water_bounds": """Returns bounds that the surface does not leave [m]: those of bolan_sea_bounds() plus those of the layers.
Thread-safe.""",
    "bolan_water_default": """The defaults named above the fields.
Thread-safe.""",
    "bolan_water_is_valid": """Returns whether the water can be queried and drawn: it has a sea, and at most BOLAN_MAX_WAVE_LAYERS layers, none of
them NULL. Thread-safe.""",
    "bolan_water_optics_from_jerlov": """The coefficients of a water type; I is the clearest ocean, 9C a muddy estuary.
Sources:
- Kd: Austin & Petzold 1986 (I..1C), Jerlov 1976 (3C..9C);
- pure water: Pope & Fry 1997, Morel 1974;
- particles: after Gordon & Morel 1983;
- Rrs: Gordon et al. 1988.""",
    "bolan_wave_layer_bound": """Returns a bound of the magnitude of the height [m].
Thread-safe.""",
    "bolan_wave_layer_create_train": """Makes a layer of a wave train.
Errors: ARGUMENT (the sentence names the field, or the limit that the height exceeds), MEMORY.
out receives the layer, NULL after an error.""",
    "bolan_wave_layer_destroy": """Releases the layer.
NULL-safe; NULLs the pointer. No water may hold the layer any more.""",
    "bolan_wave_layer_sample_at": """Samples the waves of a layer over deep water at count places in world metres at time [s].
Thread-safe.""",
    "bolan_wave_system_default": """A system without height, and the defaults named above the fields.""",
    "bolan_wave_train_desc_default": """The defaults named above the fields.
Thread-safe.""",
    "bolan_world_assets_destroy": """Releases the assets and clears the struct.
NULL-safe.""",
    "bolan_world_camera_at": """The scene's camera at time [s]: see bolan_scene_camera_at().
A camera inside the ground is lifted: to 1.8 m above land, to 0.3 m above the sea bed.""",
    "bolan_world_clear_eye": """Returns eye, raised to 0.3 m above the surface where eye is lower, so that no wave covers the eye.
The physical optics draws views from everywhere, the waterline among them: no eye is raised there.
An eye below the level stays where the scene's optics draws such views: bolan_optics_seen_from_below().
Thread-safe between steps.""",
    "bolan_world_create": """Makes a world, whose sea is stepped to scene->time.
out: receives the world; NULL on failure, and then nothing is left in memory.
Errors: ARGUMENT (a field of the scene out of range, an object without a model), MEMORY.""",
    "bolan_world_desc_default": """The defaults named above the fields, and no scene.""",
    "bolan_world_destroy": """Releases the world and everything in it.
NULL-safe; NULLs the pointer.""",
    "bolan_world_load": """Loads a world: the scene of that name or path, see bolan_scene_load(), and all that it refers to.
out: receives the world; NULL on failure.
Errors: those of bolan_scene_load() and bolan_world_load_scene().""",
    "bolan_world_load_scene": """Loads what scene refers to and makes a world of both.
"builtin:" models and generated grounds come from bolan_content.
A raster with an empty path is the global relief ETOPO5 at the path of Debian's package ferret-datasets.
out: receives the world; NULL on failure.
Errors: IO, FORMAT, MEMORY, UNSUPPORTED (a format that this build does not have), ARGUMENT (a field of the scene out
of range, an unknown name of a model or a ground).""",
    "bolan_world_object_models": """The model of each object of the scene, scene->object_count pointers.""",
    "bolan_world_object_pose": """The pose of object index of the scene at the present time.
An index beyond the last object is misuse and gives a pose of zeros.""",
    "bolan_world_scene": """The scene at the present time.""",
    "bolan_world_sea_desc": """The desc of the scene's sea with its measured spectrum put in.
bolan_sea_create() makes the world's sea of it.
The spectrum belongs to the world.""",
    "bolan_world_set_camera": """Replaces the scene's camera.""",
    "bolan_world_set_scene": """Replaces the scene by a copy of scene, at the present time of the world.
Where the sea's desc differs, another sea takes the place of the present one, settled at the present time.
What the assets stand for must not differ: the terrain's source, spectrum_path and its options, tiles_path, and the
number and the models of objects. Objects may move.
Errors: ARGUMENT (a field out of range, or one that must not differ), MEMORY. The world then stays as it was.""",
    "bolan_world_settle": """Like bolan_world_step(), with the foam that a running sea would show at time: see bolan_sea_settle().""",
    "bolan_world_step": """Steps the sea to time [s] and sets the scene's time.
The foam remembers the last seconds where steps follow each other within 1 s: see bolan_sea_step().
The camera stays: see bolan_world_camera_at().""",
    "bolan_world_tiles": """The tiles of the mirror optics; NULL where the scene names none.""",
    "bolan_world_water": """The water at the present time, for queries and for drawing.""",
    "bolan_wrap_degrees": """Returns degrees reduced to [0, 360).""",
}
