# SPDX-License-Identifier: MIT
# Made by bindings/python/generate.py from include/bolan/*.h. Do not edit.
"""The plain structs of the C headers. Fields read and write the memory of the struct."""
from typing import Any, Optional, Tuple

from ._struct import Struct


class BeaufortRow(Struct):
    """A class of the Beaufort wind scale.

    Fields:
    force:
    wind_min: Bounds of the wind speed at 10 m [m/s]; the last class has no upper bound: HUGE_VAL.
    wind_max: Bounds of the wind speed at 10 m [m/s]; the last class has no upper bound: HUGE_VAL.
    wave_height: Probable wave height on the open sea [m].
    name:
    """
    _type = "bolan_beaufort_row"
    force: int
    wind_min: float
    wind_max: float
    wave_height: float
    name: Optional[str]


class BoundWeights(Struct):
    """Weights [1/m] of the bound waves of a cascade, all 0 with order 1. With eta_c and D_c the height and displacement of
cascade c at a rest point (choppiness not applied), parcels stand higher by

    sum over c of  eta_c (height eta_c + H_c) + D_c . (drift D_c + G_c),
    H_c = sum over longer cascades l of  height_long_l eta_l,   G_c = sum of  drift_long_l D_l.

Where shallow water attenuates cascades, eta_c and D_c are the attenuated ones.

    Fields:
    height: Of a cascade with itself.
    drift: Of a cascade with itself.
    height_long: Of a cascade with every shorter one.
    drift_long: Of a cascade with every shorter one.
    """
    _type = "bolan_bound_weights"
    height: float
    drift: float
    height_long: float
    drift_long: float


class Camera(Struct):
    """The eye and its lens.

    Fields:
    position: Position [m], z above mean sea level; x, y +-1e7, z -1000..1e6; default (0, 0, 3).
    heading_deg: Compass direction of the view [deg], -360..360; default 0: north.
    pitch_deg: Elevation of the view direction [deg], -90..90, positive upwards; default 0.
    roll_deg: Roll [deg], -180..180, positive clockwise; default 0.
    fov_deg: Vertical field of view [deg], 1..150; default 50.
    """
    _type = "bolan_camera"
    position: Tuple[float, ...]
    heading_deg: float
    pitch_deg: float
    roll_deg: float
    fov_deg: float


class CameraKey(Struct):
    """The camera at a time of its path.

    Fields:
    time: Time [s], +-1e9.
    camera: The camera at that time.
    """
    _type = "bolan_camera_key"
    time: float
    camera: "Camera"


class CascadeView(Struct):
    """One cascade, read-only.
The pointers are valid while the sea lives. What they point to is of the present time until the next step; call
bolan_sea_cascade() again after it.
Sample (i, j) of a field is at [j * n + i], of displacement at [j * pitch + i]. It lies at tile coordinates
(i, j) * length / n. A rest point is read at
(x, y) = bolan_sea_place_read(); from there to the tile: rotate by -angle, u = x cos(angle) + y sin(angle),
v = -x sin(angle) + y cos(angle).
Height, dx and dy are coefficients of cubic B-splines: the field at a sample is the mean of 3 x 3 with weights
(1, 4, 1)/6 each way. The other fields are read by linear interpolation, which leaves them the slope variance of the
waves.

    Fields:
    n: Samples along a side.
    length: Side of the tile [m].
    angle: Rotation of the tile against the world, counter-clockwise [rad].
    k_min: Ring of wave numbers [rad/m]: k_min <= |k| < k_max.
    k_max: Ring of wave numbers [rad/m]: k_min <= |k| < k_max.
    variance: Expected variance of the height, the discrete sum over the ring [m2].
    mss: Expected slope variance of the ring.
    bound: Of its bound waves.
    origin_x: Where sample (0, 0) lies in the world [m]: the tile drifts from the world origin with the current.
        bolan_sea_place_read() has taken it off.
    origin_y: Where sample (0, 0) lies in the world [m]: the tile drifts from the world origin with the current.
        bolan_sea_place_read() has taken it off.
    displacement: Rows of @c pitch samples, n of each and then its first BOLAN_CASCADE_GUARD again. As many of the first rows
        follow row n - 1. So the 4 x 4 samples of a spline never wrap round: they begin at a column and a row below n.
    pitch: Samples from one row of @c displacement to the next: n + BOLAN_CASCADE_GUARD.
    slope_x: Gradient of the height, by the place read.
    slope_y: Gradient of the height, by the place read.
    dxx: dDx/dx, dDy/dy, by the place read.
    dyy: dDx/dx, dDy/dy, by the place read.
    foam: Foam memory, 0..3: recent peak of -(dxx + dyy) * choppiness, decaying.
    displacement_half: n * n * 4 halfs to upload as RGBA16F: dx, dy, height, dxy.
    slope_half: n * n * 4 halfs: slope_x, slope_y, dxx, dyy.
    foam_half: n * n halfs: foam.
    """
    _type = "bolan_cascade_view"
    n: int
    length: float
    angle: float
    k_min: float
    k_max: float
    variance: float
    mss: float
    bound: "BoundWeights"
    origin_x: float
    origin_y: float
    displacement: Any
    pitch: int
    slope_x: Any
    slope_y: Any
    dxx: Any
    dyy: Any
    foam: Any
    displacement_half: Any
    slope_half: Any
    foam_half: Any


class Crest(Struct):
    """A crest on a line.

    Fields:
    distance: From the beginning of the line [m].
    height: Of the surface above the datum [m].
    """
    _type = "bolan_crest"
    distance: float
    height: float


class DouglasRow(Struct):
    """A class of the Douglas sea scale.

    Fields:
    degree:
    hs_min: Bounds of the significant wave height [m]; the last class has no upper bound: HUGE_VAL.
    hs_max: Bounds of the significant wave height [m]; the last class has no upper bound: HUGE_VAL.
    name:
    """
    _type = "bolan_douglas_row"
    degree: int
    hs_min: float
    hs_max: float
    name: Optional[str]


class Environment(Struct):
    """Sky and sun of yours, in place of Bolan's.
Radiance and irradiance are in units of yours, which the linear output has too.

    Fields:
    cube: GL name of a complete cube map of linear radiance, without the sun's disc; its first level is read.
        0 (default): Bolan's own sky and sun, and the other fields have no effect.
    serial: Change this number whenever the contents of `cube` have changed: the environment map of the water is made anew.
    turn: From the world to the axes of the cube map: a rotation.
        Default the identity: the face +x looks east, +y north, +z up.
    sun_direction: Unit vector to the sun.
    sun_irradiance: Irradiance of the sun at the sea, on a surface that faces it; 0: no sun.
    sky_irradiance: Irradiance of the sky on a horizontal surface.
        A negative x (default -1): the integral over the upper half of the cube.
    """
    _type = "bolan_environment"
    cube: int
    serial: int
    turn: "Mat4"
    sun_direction: Tuple[float, ...]
    sun_irradiance: Tuple[float, ...]
    sky_irradiance: Tuple[float, ...]


class ExportFieldsDesc(Struct):
    """How fields are written.

    Fields:
    resampled: False (default): the fields of each cascade at its samples. True: the surface over `grid`.
    grid: The points of the world that are asked, where resampled.
    half: EXR: halfs in the place of floats. Default false.
    frames: More than one: the time dimension of NetCDF. An EXR has one.
    """
    _type = "bolan_export_fields_desc"
    resampled: bool
    grid: "ExportGrid"
    half: bool
    frames: "ExportFrames"


class ExportFrames(Struct):
    """Frames of an export that has several.

    Fields:
    count: How many, 1..100000; default 1: the present time of the world, which is not stepped.
        More: the world is settled at its present time, stepped from frame to frame, and left at the last.
    fps: Frames a second, 0.001..1000; default 30.
    progress: Called after each part of the work; default NULL. @c user is handed to it.
    user:
    """
    _type = "bolan_export_frames"
    count: int
    fps: float
    progress: Any
    user: Any


class ExportGrid(Struct):
    """A rectangle of points in the world, at a spacing: from its south-west corner on, as many as fit.

    Fields:
    from: South-west and north-east corner [m], +-1e7; default -128, -128 and 128, 128.
    to: South-west and north-east corner [m], +-1e7; default -128, -128 and 128, 128.
    spacing: Distance of neighbours [m], 0.001..1e5; default 0.5.
        2..65536 points along each side, and at most 2^28 in all.
    """
    _type = "bolan_export_grid"
    from_: Tuple[float, ...]
    to: Tuple[float, ...]
    spacing: float


class ExportMeshDesc(Struct):
    """How a mesh is made.

    Fields:
    vertices: Default BOLAN_EXPORT_VIEW.
    grid: RECTANGLE: the rest points of the vertices.
    width: VIEW: the picture that the grid is for [px], 16..65536; default 1280 x 720.
    height: VIEW: the picture that the grid is for [px], 16..65536; default 1280 x 720.
    most_vertices: VIEW: most vertices, 1024..10000000; default 200000. The grid is coarsened to fit.
    ground: The ground too, as a mesh of its own over the same points. Default false.
        A world without ground: ARGUMENT.
    origin: The place of the world that is the origin of the file [m]; default 0, 0, 0.
        Positions are floats: beyond 8 km from the origin they are rounded to more than half a millimetre, with one
        warning (EXPORT_PRECISION).
    frames: More than one: an animation, in .glb alone.
    """
    _type = "bolan_export_mesh_desc"
    vertices: str
    grid: "ExportGrid"
    width: int
    height: int
    most_vertices: int
    ground: bool
    origin: Tuple[float, ...]
    frames: "ExportFrames"


class ExrAttribute(Struct):
    """An attribute in the header of an EXR part: text, a number or a vector.

    Fields:
    name: Its name, such as "sunDirection".
    text: Text; NULL: numbers.
    count: 1 (a double) or 3 (a vector of floats); of text 0.
    number:
    """
    _type = "bolan_exr_attribute"
    name: Optional[str]
    text: Optional[str]
    count: int
    number: Tuple[float, ...]


class ExrChannel(Struct):
    """One channel of an EXR image.

    Fields:
    name: Name of the channel, such as "R".
    pixels: width * height values, row 0 at the top.
    """
    _type = "bolan_exr_channel"
    name: Optional[str]
    pixels: Any


class ExrPart(Struct):
    """A part of an EXR image.

    Fields:
    name: Its name, which no other part has; NULL in an image of one part.
    width:
    height:
    channels: 1..64 channels.
    channel_count:
    attributes:
    attribute_count:
    half: The file holds 16-bit floats, to the nearest.
    """
    _type = "bolan_exr_part"
    name: Optional[str]
    width: int
    height: int
    channels: Any
    channel_count: int
    attributes: Any
    attribute_count: int
    half: bool


class FrameStatistics(Struct):
    """What a frame was made of.

    Fields:
    pass_count: How many entries of `passes` are filled.
    passes: Name of each pass, and its time [ms] while bolan_renderer_measure_passes() is on; else 0. With several samples,
        of one of them. `gl_calls`: the OpenGL functions that it called.
    samples: Samples a pixel of which the last view wrote the mean: bolan_view::samples, or with bolan_view::accumulate all.
    triangles: Triangles that were submitted.
    water_triangles: Triangles of the water.
    programs: Shader programs compiled by this renderer since it was created. It rises when a frame of another technique, sea
        or ground is prepared, and stays while only the view changes.
    uploads: Uploads to textures of this renderer since it was created: fields of seas, maps of the ground, tables. They stay
        while the step and the eye stay, and on the open sea while the step stays.
    upload_bytes: Bytes of those uploads.
    gl_calls: OpenGL functions called since the last preparation of a step began, saving and restoring your state included.
    gl_questions: Of those, the ones that want an answer (glGet..., glIs..., reading back, glFinish()): a driver with a thread of
        its own makes the caller wait for it. glGetString() is not among them.
    sea_bytes: Bytes that the last synthesis by compute shaders moved at least, each table and image once; 0 with the CPU's.
        Over bolan_renderer_memory_rate() it is the time below which no synthesis can be.
    """
    _type = "bolan_frame_statistics"
    pass_count: int
    passes: Tuple[Struct, ...]
    samples: int
    triangles: int
    water_triangles: int
    programs: int
    uploads: int
    upload_bytes: int
    gl_calls: int
    gl_questions: int
    sea_bytes: int


class GlInfo(Struct):
    """Properties of a context.

    Fields:
    renderer: What the driver says of itself: static strings, "" without a context.
    vendor: What the driver says of itself: static strings, "" without a context.
    version: What the driver says of itself: static strings, "" without a context.
    shading_language: What the driver says of itself: static strings, "" without a context.
    software: The renderer runs on the CPU.
    clip_control: The context has clip control: see bolan_renderer_desc::no_clip_control.
    compute: The context has what the compute backend needs: see bolan_renderer_desc::backend.
    max_picture: Largest image that the context can draw at once [px], each way; a view has at most 16384. 0 without a context.
    """
    _type = "bolan_gl_info"
    renderer: Optional[str]
    vendor: Optional[str]
    version: Optional[str]
    shading_language: Optional[str]
    software: bool
    clip_control: bool
    compute: bool
    max_picture: int


class GlState(Struct):
    """State of a context, in numbers and names of OpenGL.
What has no field here is in OpenGL's initial state.

    Fields:
    draw_framebuffer: Default 0.
    read_framebuffer: Default 0.
    program: Default 0.
    vertex_array: Default 0.
    array_buffer: Bound to GL_ARRAY_BUFFER and GL_UNIFORM_BUFFER; default 0.
    uniform_buffer: Bound to GL_ARRAY_BUFFER and GL_UNIFORM_BUFFER; default 0.
    active_unit: The active texture unit, from 0; default 0.
    samplers: True: sampler objects may be bound to units 0 to 28. A call unbinds them. Default false.
    viewport: x, y, width, height; default all 0. With a width of 0 the viewport is not put back.
    scissor_test: GL_SCISSOR_TEST; default false.
    scissor_box: x, y, width, height; default all 0. With a width of 0 the box is not put back.
    depth_test: GL_DEPTH_TEST; default false.
    depth_mask: Default true.
    depth_function: Default GL_LESS.
    depth_clear: Default 1.
    blend: GL_BLEND of all draw buffers; default false.
    blend_function: Source and destination of colour, then of alpha; default GL_ONE, GL_ZERO, GL_ONE, GL_ZERO.
    color_mask: Of all draw buffers; default true.
    color_clear: Default 0.
    cull_face: GL_CULL_FACE; default false.
    cull_mode: Default GL_BACK.
    front_face: Default GL_CCW.
    stencil_test: GL_STENCIL_TEST; default false.
    framebuffer_srgb: GL_FRAMEBUFFER_SRGB, which OpenGL ES has not; default false.
    dither: GL_DITHER; default true.
    clip_upper_left: Clip control: origin at the upper left; default false.
    clip_zero_to_one: Clip control: clip depth in [0,1]; default false.
    """
    _type = "bolan_gl_state"
    draw_framebuffer: int
    read_framebuffer: int
    program: int
    vertex_array: int
    array_buffer: int
    uniform_buffer: int
    active_unit: int
    samplers: bool
    viewport: Tuple[int, ...]
    scissor_test: bool
    scissor_box: Tuple[int, ...]
    depth_test: bool
    depth_mask: bool
    depth_function: int
    depth_clear: float
    blend: bool
    blend_function: Tuple[int, ...]
    color_mask: Tuple[bool, ...]
    color_clear: Tuple[float, ...]
    cull_face: bool
    cull_mode: int
    front_face: int
    stencil_test: bool
    framebuffer_srgb: bool
    dither: bool
    clip_upper_left: bool
    clip_zero_to_one: bool


class GroundDesc(Struct):
    """How a ground is made of a grid.

    Fields:
    field: The elevations; copied.
    detail: Strength of the procedural detail below the grid's spacing, 0..2; default 1. 0 leaves the data alone.
    seed: Seed of the detail; default 1.
    edge_elevation: Elevation far outside the grid [m], +-1e6; default -4000. The rim of the grid blends to it.
    """
    _type = "bolan_ground_desc"
    field: "Heightfield"
    detail: float
    seed: int
    edge_elevation: float


class GroundExtent(Struct):
    """Extent of the data that a ground was made from.

    Fields:
    west: The rectangle of the data [m].
    south: The rectangle of the data [m].
    east: The rectangle of the data [m].
    north: The rectangle of the data [m].
    lowest: The lowest and highest elevation of the data [m].
    highest: The lowest and highest elevation of the data [m].
    step: The spacing of the data [m]; the coarser of the two.
    """
    _type = "bolan_ground_extent"
    west: float
    south: float
    east: float
    north: float
    lowest: float
    highest: float
    step: float


class GroundGenerator(Struct):
    """A generator of ground by name, and its parameters.
A generator ignores the parameters that it has no use for.
The core has no generator; content.h has some.

    Fields:
    name: Name of the generator; default "". See bolan_content_ground_name().
    seed: Which ground of this kind; default 7.
    radius: Radius of the land [m], 200..20000; default 2200.
    peak: Height of the summit [m], 10..3000; default 620.
    sea_floor: Elevation of the sea bed far out [m], -11000..-20; default -900.
    lagoon_from_deg: Compass side where sandy shallows lie [deg], -360..360; default 225.
    """
    _type = "bolan_ground_generator"
    name: str
    seed: int
    radius: float
    peak: float
    sea_floor: float
    lagoon_from_deg: float


class GroundSource(Struct):
    """The ground of a scene, by description.

    Fields:
    kind: Which of the members below is used; default NONE.
    generator: For GENERATED.
    raster: For RASTER. An empty path is the global relief ETOPO5, where it is installed.
    shown_by_object: True: an object of the scene shows the ground, so the ground itself is not drawn; default false.
        The water still takes its depth and its shore from the ground.
    """
    _type = "bolan_ground_source"
    kind: str
    generator: "GroundGenerator"
    raster: "RasterDesc"
    shown_by_object: bool


class Haze(Struct):
    """Haze: light L from a distance d arrives as L e^(-extinction d) + radiance (1 - e^(-extinction d)).

    Fields:
    kind: Default BOLAN_HAZE_AIR.
    radiance: Radiance of endless haze, >= 0; for BOLAN_HAZE_GIVEN.
    extinction: Extinction [1/m], >= 0; for BOLAN_HAZE_GIVEN.
    """
    _type = "bolan_haze"
    kind: str
    radiance: Tuple[float, ...]
    extinction: Tuple[float, ...]


class Heightfield(Struct):
    """A regular grid of elevations in local metres.
Sample (i, j) is at (west + i * step_x, south + j * step_y); row 0 is in the south.
All samples lie within +-1e8 m of the origin.

    Fields:
    width: Number of samples each way, 2..32768.
    height: Number of samples each way, 2..32768.
    west: Position of sample (0, 0) [m east, m north of the scene's origin].
    south: Position of sample (0, 0) [m east, m north of the scene's origin].
    step_x: Spacing of the samples [m], 1e-3..1e7.
    step_y: Spacing of the samples [m], 1e-3..1e7.
    elevation: elevation[j * width + i] [m above mean sea level], width * height values within +-1e6.
    """
    _type = "bolan_heightfield"
    width: int
    height: int
    west: float
    south: float
    step_x: float
    step_y: float
    elevation: Any


class Hooks(Struct):
    """Process-wide hooks.
A NULL member keeps the built-in behaviour.

    Fields:
    user: First argument of every hook.
    allocate: Memory of size bytes, aligned to align, a power of two of at most 64; NULL on failure.
    release: Releases memory of allocate().
        size is the size that allocate() was called with.
    log: Receives one sentence.
        Default: prints one line on stderr.
    assert_failed: Called on misuse.
        Default: prints the expression and aborts.
    parallel: Runs parallel loops on the task system of the caller.
        Default: the built-in pool, see bolan_set_threads().
    parallel_workers: Number of workers that parallel can use at once, at least 1.
        0 is misuse and counts as 1.
    get_proc_address: Returns the address of the OpenGL function name, such as "glClear"; NULL where there is none.
        Called once for each function that bolan_render uses, on the thread of the first call into bolan_render, with a
        context current.
        Default: libepoxy; a library that was built without it needs the hook.
    """
    _type = "bolan_hooks"
    user: Any
    allocate: Any
    release: Any
    log: Any
    assert_failed: Any
    parallel: Any
    parallel_workers: int
    get_proc_address: Any


class Host(Struct):
    """A host's frame, as it stands in the view's rectangle before the water is drawn.

    Fields:
    color: GL name of a 2D texture with the scene's linear radiance. 0 (default), with `depth` 0: nothing is seen through
        the water or reflected in it, and the depth buffer of the framebuffer alone hides it.
    depth: GL name of a 2D texture with the scene's window depth, made with the view's projection and a depth range of
        [0,1]. Both may be attached to the view's framebuffer.
    samples: Samples a pixel of `color` and `depth`; 0 (default) or 1: 2D textures.
        More: multisampled 2D textures, of which the farthest sample of a pixel is read, so that the water reaches under
        every edge of the host's objects. OpenGL ES 3.0 has none: there draw with resolved copies, whose edges may show
        what stood behind the water.
    x: Lower left corner of the view's rectangle in these textures and the mask [px]; default 0, 0.
    y: Lower left corner of the view's rectangle in these textures and the mask [px]; default 0, 0.
    radiance: The host's radiance over Bolan's, where the sun's irradiance in space is 1 at normal incidence; 0 (default): 1.
        With bolan_lighting::environment Bolan's radiance is the host's.
    mask: GL name of a 2D texture: no water where its red is above 0.5, as inside a hull. 0 (default): water everywhere.
    stencil: No water where the framebuffer's stencil equals `stencil` in the bits of `stencil_mask`, sample by sample.
        The stencil is read and not written. A `stencil_mask` of 0 (default): the stencil has no effect.
    stencil_mask: No water where the framebuffer's stencil equals `stencil` in the bits of `stencil_mask`, sample by sample.
        The stencil is read and not written. A `stencil_mask` of 0 (default): the stencil has no effect.
    shadow: GL name of a 2D depth texture of the host's objects as the sun sees them; 0 (default): none.
        Where it holds less than a place's own depth, the light of the sun is missing on the water and in it.
        BOLAN_OPTICS_PHYSICAL alone reads it; with another optics it is refused.
    shadow_matrix: From the world relative to the eye [m] to the map: x and y in [0,1] across it, z its depth, from 0 nearest the
        sun. What falls outside the map is lit.
    shadow_bias: Subtracted from a place's depth, against shadows of the map's own steps; default 0.
    bounds: Corners of the polygon in which the water lies, in the world [m], in either sense; borrowed for the call.
        The surface is cut where it crosses the sides.
    bounds_count: 3..BOLAN_MAX_BOUNDS, or 0 (default): the water has no end.
    """
    _type = "bolan_host"
    color: int
    depth: int
    samples: int
    x: int
    y: int
    radiance: float
    mask: int
    stencil: int
    stencil_mask: int
    shadow: int
    shadow_matrix: "Mat4"
    shadow_bias: float
    bounds: Any
    bounds_count: int


class IoFeatures(Struct):
    """Formats that this build reads or writes.
A function of a format that is left out logs one sentence and returns UNSUPPORTED.

    Fields:
    rasters: bolan_raster_load(), by GDAL.
    models: bolan_model_load(), by assimp.
    exr: bolan_exr_write(), by OpenEXR.
    gzip: Spectra packed by gzip, by zlib.
    netcdf4: Spectra in NetCDF-4, by netCDF-C. NetCDF-3 needs no library.
    """
    _type = "bolan_io_features"
    rasters: bool
    models: bool
    exr: bool
    gzip: bool
    netcdf4: bool


class Kinematics(Struct):
    """The water at one world point, over the ground.
With a sea of order 1 these are the values of linear theory whatever the choppiness, which moves parcels in place
only. With a sea of order 2 they are those of second-order theory, of which flow.h has the equations.

    Fields:
    velocity: Orbital velocity of the waves, and the current of the sea [m/s].
    acceleration: Of the parcel that is at the point [m/s2]: with order 2 it includes (velocity . grad) velocity.
    pressure: Dynamic pressure [Pa]: what the waves add to the hydrostatic pressure of still water, density g (level - z) for
        water of BOLAN_SEA_WATER_DENSITY. Both together are 0 at the surface; a gauge of depth measures both.
    wet: The point is in the water. If not, all else is 0.
    """
    _type = "bolan_kinematics"
    velocity: Tuple[float, ...]
    acceleration: Tuple[float, ...]
    pressure: float
    wet: bool


class Lighting(Struct):
    """How the water and the world are lit and shaded.

    Fields:
    sky: Sun, air and clouds.
    exposure: Exposure over the automatic one [stops], -10..10; default 0.
    technique: The surface and the optics are read; `waves` must be the wave model of the sea.
    look: Shading options.
    environment: Sky and sun of yours; default: Bolan's.
    haze: Haze between the eye and the water; default: Bolan's air.
    """
    _type = "bolan_lighting"
    sky: "Sky"
    exposure: float
    technique: "Technique"
    look: "Look"
    environment: "Environment"
    haze: "Haze"


class Look(Struct):
    """Shading options.

    Fields:
    paper: Follow the technique's paper to the letter, also where a better way is known; default false.
    effects: Bits of bolan_effect; default all.
    show: What is drawn of the water; default PICTURE.
    distortion: Factor on how far waves bend reflections and refractions (MIRROR, PHONG), 0..4; default 1.
    blend: Share of reflection and refraction over the water's own texture (MIRROR; lerpScale of the paper), 0..1;
        default 0.85.
    ambient: Strength of ambient light (PHONG, LIT; Ka of the papers), 0..2; default 1.
    diffuse: Strength of diffuse light (PHONG, LIT; Kd of the papers), 0..2; default 0.05.
    specular: Strength of specular light (PHONG, LIT; Ks of the papers), 0..4; default 1.
    shininess: Exponent of the highlight (PHONG, LIT), 1..4096; default 300. Raised: smaller and sharper.
    """
    _type = "bolan_look"
    paper: bool
    effects: int
    show: str
    distortion: float
    blend: float
    ambient: float
    diffuse: float
    specular: float
    shininess: float


class Mat4(Struct):
    """Column-major: m[4 * column + row].

    Fields:
    m:
    """
    _type = "bolan_mat4"
    m: Tuple[float, ...]


class MeasuredPlace(Struct):
    """Where a spectrum was taken.

    Fields:
    known: The text gives a place. If not, all else is 0.
    spherical: x and y are longitude and latitude [deg], else east and north of some origin [m].
    x: The place.
    y: The place.
    """
    _type = "bolan_measured_place"
    known: bool
    spherical: bool
    x: float
    y: float


class MeasuredView(Struct):
    """Read-only view: frequencies [rad/s], directions (mathematical, TO) [rad] ascending with constant step 2 pi /
direction_count, density[frequency * direction_count + direction] [m2 s/rad per rad].

    Fields:
    frequency_count:
    direction_count:
    record_count:
    omega:
    theta:
    density:
    time: Time of the record in ISO 8601 ("2020-06-08T03:50Z"); "" when the text gives none.
    place: Place of the record; of an interpolated one, of the earlier record.
    """
    _type = "bolan_measured_view"
    frequency_count: int
    direction_count: int
    record_count: int
    omega: Any
    theta: Any
    density: Any
    time: Optional[str]
    place: "MeasuredPlace"


class ModelDesc(Struct):
    """A model file.

    Fields:
    path: Path of the file, which must be given; read during the call only.
    up: Which axis of the file points up; default Y.
    offset: Subtracted from the coordinates of the file, in its axes and units, +-1e8; default 0.
        The coordinates are floats before the subtraction: around 5e6 (UTM) they are rounded to half a metre.
        For fine models subtract the offset in the file.
    """
    _type = "bolan_model_desc"
    path: Optional[str]
    up: str
    offset: Tuple[float, ...]


class ModelView(Struct):
    """The arrays of a model, read-only; valid while the model lives.

    Fields:
    vertex_count: Number of vertices, 3..67108864; number of indices, a multiple of 3 up to 67108864.
    index_count: Number of vertices, 3..67108864; number of indices, a multiple of 3 up to 67108864.
    positions: Positions of the vertices [m].
    normals: Unit normals of the vertices.
    colors: Linear albedo in x, y, z, 0..1; in w the share of the sky that is open above the vertex, 0..1.
    indices: Triangles, counter-clockwise from outside.
    """
    _type = "bolan_model_view"
    vertex_count: int
    index_count: int
    positions: Any
    normals: Any
    colors: Any
    indices: Any


class Nested(Struct):
    """All levels of a view.

    Fields:
    cells: Cells along a side, and number of levels.
    levels: Cells along a side, and number of levels.
    centre: The point that the levels lie round [m].
    least_spacing: Smallest spacing of any vertex [m]. It varies smoothly with the eye's height, so that detail does not pop.
    level: The levels; 0 is the coarsest.
    """
    _type = "bolan_nested"
    cells: int
    levels: int
    centre: Tuple[float, ...]
    least_spacing: float
    level: Tuple["NestedLevel", ...]


class NestedDesc(Struct):
    """How nested grids are made. n stands for `cells`.

    Fields:
    cells: Cells along a side of every level, a multiple of 4, 4..256; default 32. Raised: finer everywhere.
    levels: Number of levels, 1..BOLAN_NESTED_MAX_LEVELS; default 6. Raised by one: twice as fine at the middle.
    spacing: Spacing d_0 of the coarsest level [m], > 0, rounded to float; default 0.
        0: the smallest power of two for which the coarsest level reaches to half a pixel below the horizon.
        For an eye at 10 m, the finest of 6 levels of 32 cells then has a spacing of 16 m, and of 10 levels 1 m.
    """
    _type = "bolan_nested_desc"
    cells: int
    levels: int
    spacing: float


class NestedLevel(Struct):
    """The place of one level: vertex (i, j) stands at (x0 + i d, y0 + j d), d the spacing.

    Fields:
    x0: Place of vertex (0, 0) in the world, and the spacing d [m].
    y0: Place of vertex (0, 0) in the world, and the spacing d [m].
    spacing: Place of vertex (0, 0) in the world, and the spacing d [m].
    hole_i: The next finer level covers the cells [hole_i, hole_i + n/2) x [hole_j, hole_j + n/2).
        The finest level has no hole: (0, 0).
    hole_j: The next finer level covers the cells [hole_i, hole_i + n/2) x [hole_j, hole_j + n/2).
        The finest level has no hole: (0, 0).
    """
    _type = "bolan_nested_level"
    x0: float
    y0: float
    spacing: float
    hole_i: int
    hole_j: int


class Object(Struct):
    """A model and where it stands.

    Fields:
    model: "builtin:NAME" (see bolan_content_model_name()), or the path of a model file: OBJ, glTF.
    position: Position of the model's origin [m]; x, y +-1e7, z -11000..10000.
    heading_deg: Compass direction of the model's +y axis [deg], -360..360.
    scale: Scale of the model, 1e-3..1e3.
    floats: True: the object rides on the waves, and position.z is its height above the water under it.
    up: Which axis of a model file points up; default Y.
    offset: Subtracted from a file's coordinates, in the file's axes and units, +-1e8; default 0.
    """
    _type = "bolan_object"
    model: str
    position: Tuple[float, ...]
    heading_deg: float
    scale: float
    floats: bool
    up: str
    offset: Tuple[float, ...]


class Param(Struct):
    """One parameter.

    Fields:
    field: The member of the struct, such as "cosines.frequencies".
    key: The key in scene files, dotted where maps are nested, such as "clouds.cover". NULL: scene files do not have it.
        Neighbouring rows with one key are the components of one list of numbers, such as a position.
    option: The long option of the command line without its dashes. NULL: no option.
    unit: The unit of the field, such as "m/s". NULL: none.
    help: What the parameter is, in one sentence without a full stop.
    otherwise: What is used where the parameter is not given and the default does not say, such as "the whole raster".
        NULL: the default.
    names: Names of NAME and SET, NULL at the end; for TEXT the names that documentation lists, or NULL.
    kind: The type of the field.
    rules: Bits of bolan_param_rule.
    offset: Where the field lies in the struct, and its size [bytes].
    size: Where the field lies in the struct, and its size [bytes].
    low: The range of the field, ends included.
    high: The range of the field, ends included.
    fallback: The default; a TEXT has always "".
    factor: Units of the field in one unit of the key and the option: 1000 where a key in km sets a field in m.
        0: key and option have the unit of the field.
    factor_unit: The unit of the key and the option where `factor` is set, such as "km".
    label: The label in a panel. NULL: the last part of the field's name.
    usual_low: The range of a slider, in units of the key; 0 and 0: the whole range.
    usual_high: The range of a slider, in units of the key; 0 and 0: the whole range.
    digits: Digits behind the point that a slider shows.
    """
    _type = "bolan_param"
    field: Optional[str]
    key: Optional[str]
    option: Optional[str]
    unit: Optional[str]
    help: Optional[str]
    otherwise: Optional[str]
    names: Any
    kind: str
    rules: int
    offset: int
    size: int
    low: float
    high: float
    fallback: float
    factor: float
    factor_unit: Optional[str]
    label: Optional[str]
    usual_low: float
    usual_high: float
    digits: int


class ParamGroup(Struct):
    """A table at a place in a larger struct, under a map of a scene file.

    Fields:
    field: The member of the larger struct, such as "terrain.island"; "" for the struct itself.
    help: For a list, or a map without keys: what it is, for documentation. NULL: none.
    key: The map of a scene file, dotted; "" for the document itself.
    offset: Where the member lies in the larger struct [bytes]; for a list, where its first element lies.
    table: The parameters of the member, or of one element of a list.
    capacity: Most elements of a list; 0 where the member is no list.
    stride: Distance of two elements of a list, and where the uint32_t with their number lies [bytes].
    count_offset: Distance of two elements of a list, and where the uint32_t with their number lies [bytes].
    """
    _type = "bolan_param_group"
    field: Optional[str]
    help: Optional[str]
    key: Optional[str]
    offset: int
    table: Any
    capacity: int
    stride: int
    count_offset: int


class ParamTable(Struct):
    """The parameters of one struct.

    Fields:
    type: The struct, "bolan_sea_desc".
    params: The rows.
    count: Number of rows.
    """
    _type = "bolan_param_table"
    type: Optional[str]
    params: Any
    count: int


class Parcel(Struct):
    """A parcel of the surface, known by its rest point.

    Fields:
    displacement: From the rest point on the mean water to the parcel [m]: it is found at x0 + x, y0 + y, level + z.
    normal: Unit normal of the displaced surface, z >= 0.
    jacobian: Jacobian of the horizontal map; below 0 the surface is folded.
    """
    _type = "bolan_parcel"
    displacement: Tuple[float, ...]
    normal: Tuple[float, ...]
    jacobian: float


class Partition(Struct):
    """A part of a sea: one wind sea or one swell.

    Fields:
    wind_sea: The wind drives it; otherwise it is a swell.
    hs: Significant height 4 sqrt(m0) of the part [m].
    tp: Period of the peak of its S(w) [s].
    from_deg: Mean direction FROM, compass [deg].
    spread_deg: Circular spread sqrt(2 (1 - r1)) [deg].
    """
    _type = "bolan_partition"
    wind_sea: bool
    hs: float
    tp: float
    from_deg: float
    spread_deg: float


class Points(Struct):
    """A growable list of points.

    Fields:
    count: Number of points.
    points: The points [m].
    capacity: Points that the memory holds.
    """
    _type = "bolan_points"
    count: int
    points: Any
    capacity: int


class Pose(Struct):
    """Place and axes of a model in the world.

    Fields:
    origin: Position of the model's origin [m].
    x: Unit axes of the model (right, ahead, up) in world axes.
    y: Unit axes of the model (right, ahead, up) in world axes.
    z: Unit axes of the model (right, ahead, up) in world axes.
    """
    _type = "bolan_pose"
    origin: Tuple[float, ...]
    x: Tuple[float, ...]
    y: Tuple[float, ...]
    z: Tuple[float, ...]


class QueryPoint(Struct):
    """The surface at one world point.
Where choppy water folds, several parcels stand at the point; the highest parcel that is found is returned.

    Fields:
    height: Height of the surface above the datum [m].
    normal: Unit normal, z >= 0.
    jacobian: Jacobian of the horizontal map at the parcel found; below 0 the surface is folded.
    residual: Horizontal distance between the point and the parcel [m]: below 1e-3 where the Jacobian is above 0.2.
    """
    _type = "bolan_query_point"
    height: float
    normal: Tuple[float, ...]
    jacobian: float
    residual: float


class Question(Struct):
    """Options of a question about moving water.

    Fields:
    least_wavelength: Waves shorter than this are left out [m], 0..1e5; 0 (default): none.
        The filter is 1 - (1 - e^{-kl})^4 on the amplitude, with l = 0.29258 of this wavelength: it keeps half of a wave
        of this length, 87 % of one twice and 98 % of one four times as long, 10 % of one half and 0.3 % of one a
        quarter as long.
    stretching: Default BOLAN_STRETCH_NONE.
    """
    _type = "bolan_question"
    least_wavelength: float
    stretching: str


class RasterDesc(Struct):
    """A raster of elevations, and what overrules the statements of the file: see bolan_raster_load() of io.h.

    Fields:
    path: Any file that GDAL reads, or a name with a prefix of GDAL's (NETCDF:f.nc:z, HDF5:..., GTIFF_DIR:2:f.tif).
        Default "".
    variable: Name of the variable or of the band.
        Default "": the one that is an elevation by its standard_name, name or unit.
    band: Number of the band, 1..65535.
        Default 0: the only band, or the one that is an elevation by its name.
    crs: Coordinates of the file: "metres", "degrees", or a CRS that PROJ knows ("EPSG:32604", WKT).
        Default "": the file's.
    latitude: Place of the scene's origin [deg], latitude +-90, longitude +-360.
        Default NAN: the centre of the raster.
    longitude: Place of the scene's origin [deg], latitude +-90, longitude +-360.
        Default NAN: the centre of the raster.
    radius: Half side of the square that is read [m], 100..5e6; default 150000.
    vertical_scale: Metres upwards per unit of the raster, +-(1e-3..1e3), negative for depths.
        Default NAN: by the unit and the sign that the file states.
        Scale and offset of the file apply first.
    nodata_value: The number that stands for no-data, as in the file.
        Default NAN: what the file declares.
    nodata: What a sample without a value is; default AUTO.
    zero: What an elevation of exactly 0 is; default AUTO.
    """
    _type = "bolan_raster_desc"
    path: str
    variable: str
    band: int
    crs: str
    latitude: float
    longitude: float
    radius: float
    vertical_scale: float
    nodata_value: float
    nodata: str
    zero: str


class Ray(Struct):
    """A part of a straight line in the world.

    Fields:
    origin: Where it begins [m].
    direction: Where it goes; of any length but 0.
    length: How far [m], 0..1e7.
    """
    _type = "bolan_ray"
    origin: Tuple[float, ...]
    direction: Tuple[float, ...]
    length: float


class RayHit(Struct):
    """Where a ray meets the surface.

    Fields:
    hit: It does, from above or from below. If not, all else is 0.
    distance: From the origin [m].
    point: The place [m].
    """
    _type = "bolan_ray_hit"
    hit: bool
    distance: float
    point: Tuple[float, ...]


class RecordBand(Struct):
    """One band of a spectrum.

    Fields:
    frequency: [Hz]
    density: Of the variance of the heave [m2/Hz].
    a1: First Fourier coefficients of the directions that the waves go to, mathematical angles: mean of cos, sin, cos 2,
        sin 2.
    b1: First Fourier coefficients of the directions that the waves go to, mathematical angles: mean of cos, sin, cos 2,
        sin 2.
    a2: First Fourier coefficients of the directions that the waves go to, mathematical angles: mean of cos, sin, cos 2,
        sin 2.
    b2: First Fourier coefficients of the directions that the waves go to, mathematical angles: mean of cos, sin, cos 2,
        sin 2.
    direction_from: Mean direction that the waves come from [compass deg], and circular spread sqrt(2 (1 - r1)) [deg].
    spread: Mean direction that the waves come from [compass deg], and circular spread sqrt(2 (1 - r1)) [deg].
    """
    _type = "bolan_record_band"
    frequency: float
    density: float
    a1: float
    b1: float
    a2: float
    b2: float
    direction_from: float
    spread: float


class RecordStatistics(Struct):
    """Statistics of a record.

    Fields:
    mean: Mean of the samples [m].
    hm0: 4 standard deviations of the samples [m].
    skewness: Of the samples: 0 and 3 for a Gaussian sea.
    kurtosis: Of the samples: 0 and 3 for a Gaussian sea.
    waves: Number of waves.
    h_mean: Mean height of all waves, of the highest third and of the highest tenth, and the greatest [m].
    h_third: Mean height of all waves, of the highest third and of the highest tenth, and the greatest [m].
    h_tenth: Mean height of all waves, of the highest third and of the highest tenth, and the greatest [m].
    h_max: Mean height of all waves, of the highest third and of the highest tenth, and the greatest [m].
    crest_max: Highest crest over the mean [m].
    tz: Mean period of all waves, and of the highest third [s].
    t_third: Mean period of all waves, and of the highest third [s].
    """
    _type = "bolan_record_statistics"
    mean: float
    hm0: float
    skewness: float
    kurtosis: float
    waves: int
    h_mean: float
    h_third: float
    h_tenth: float
    h_max: float
    crest_max: float
    tz: float
    t_third: float


class RecordWave(Struct):
    """One wave of a record, from an up-crossing of the mean to the next.

    Fields:
    height: From the lowest to the highest sample between the crossings [m].
    period: Between the crossings, which are interpolated between samples [s].
    crest: Of the highest sample over the mean [m].
    """
    _type = "bolan_record_wave"
    height: float
    period: float
    crest: float


class RendererDesc(Struct):
    """How a renderer is made.

    Fields:
    quality: Default MEDIUM.
    backend: Default AUTO.
        COMPUTE takes OpenGL 4.3, or OpenGL ES 3.1 with EXT_texture_view or OES_texture_view.
    pixels: Default AUTO. COMPUTE takes what BOLAN_BACKEND_COMPUTE takes.
    max_vertices: Most vertices of the water on BOLAN_SURFACE_PROJECTED, 1024..1000000, whatever the quality and the size of the
        image. 0 (default): as the quality has it. Raised: smaller triangles, down to what the quality asks for.
    restore: What calls of this renderer do with your state; default BOLAN_RESTORE_FULL.
        FULL asks OpenGL some hundreds of questions in each call: a driver with a thread of its own makes you wait.
        DECLARED and NONE ask none. In exchange:
        - textures of units 0 to 28 and uniform slots 0 to 4 stay as the call leaves them, and sampler objects of these
          units are unbound; with BOLAN_BACKEND_COMPUTE or BOLAN_PIXELS_COMPUTE also storage buffers and images of slots
          0 to 3 and the buffer for indirect dispatches stay;
        - no transform feedback is active in a call;
        - the names of your framebuffers and textures are checked when they first come, and not again: change
          bolan_renderer_desc::restore to FULL while you look for a wrong name;
        - after a bolan_host with `stencil_mask` the functions and operations of the stencil are OpenGL's initial ones.
        Creating, reloading, and reading back ask in any case.
    shader_directory: Folder from which shaders are read, and again by bolan_renderer_reload(). NULL (default): the built-in shaders.
        Copied; at most 1023 characters.
    no_clip_control: True: the path without clip control is taken also where the context has it, for tests. Default false.
    force_timers: True: GPU timers are used also on software OpenGL, where their times mean little, for tests. Default false.
    debug: True: the driver's debug messages are logged while a call of this renderer runs. A callback of yours gets them
        too, and is the only one again afterwards. False (default): debug output is left alone.
    """
    _type = "bolan_renderer_desc"
    quality: str
    backend: str
    pixels: str
    max_vertices: int
    restore: str
    shader_directory: Optional[str]
    no_clip_control: bool
    force_timers: bool
    debug: bool


class Scene(Struct):
    """Everything that is drawn, except what lies in files: see bolan_world.

    Fields:
    name: Name of a built-in scene, or the file that the scene was read from.
    description: One sentence; "" for none.
    technique: Default bolan_technique_ocean. See bolan_scene_set_technique().
    look: Shading options.
    sea: The sea. sea.sea_state.measured stays NULL; sea.waves is the technique's.
    fetch: Fetch of the wind sea [m], 100..1e7; default 2e5. See bolan_scene_set_wind().
    wind_spectrum: Spectrum of the wind sea; default JONSWAP. See bolan_scene_set_wind().
    wind_sea: Whether the wind raises a wind sea; default true. False: the sea has the systems of sea.sea_state alone, and the
        wind roughens them. See bolan_scene_set_wind().
    spectrum_path: A measured spectrum file; "" for none.
    spectrum: What is read from the spectrum file, and what replaces missing directions and spreads.
    camera: The camera where there is no path.
    camera_key_count: Number of keys, 0..BOLAN_MAX_CAMERA_KEYS; default 0: the camera does not move.
    camera_keys: The path of the camera, times ascending. See bolan_scene_camera_at().
    train_count: Number of wave trains, 0..BOLAN_MAX_WAVE_LAYERS; default 0.
    trains: Wave trains that are added to the waves of the sea.
    sky: Sun, air and clouds.
    water: The water's colour and level.
    terrain: Where the ground comes from; default none.
    tiles_path: A folder of baked tiles for the mirror optics, see bolan_tiles_load(); "" for none.
    object_count: Number of objects, 0..BOLAN_MAX_OBJECTS; default 0.
    objects: The objects.
    time: Time of the scene [s], +-1e9; default 0.
    exposure: Exposure over the automatic one [stops], -10..10; default 0.
    """
    _type = "bolan_scene"
    name: str
    description: str
    technique: "Technique"
    look: "Look"
    sea: "SeaDesc"
    fetch: float
    wind_spectrum: str
    wind_sea: bool
    spectrum_path: str
    spectrum: "SpectrumOptions"
    camera: "Camera"
    camera_key_count: int
    camera_keys: Tuple["CameraKey", ...]
    train_count: int
    trains: Tuple["WaveTrainDesc", ...]
    sky: "Sky"
    water: "Seawater"
    terrain: "GroundSource"
    tiles_path: str
    object_count: int
    objects: Tuple["Object", ...]
    time: float
    exposure: float


class SeaBytes(Struct):
    """Memory of a sea [bytes].

    Fields:
    tables: Of the spectrum and all tables, which forks share.
    fields: Of the fields, which every sea and every fork has.
    """
    _type = "bolan_sea_bytes"
    tables: int
    fields: int


class SeaClock(Struct):
    """What a synthesis of your own needs of the present time, besides the modes.
The foam memory has a tick every 0.25 s about. With pinch = min(max(-(dxx + dyy) choppiness, 0), 3), it is
F(k) = max(tick_keep F(k - 1) - tick_lose, pinch at tick k), and the foam is
max(keep F(tick) - lose, pinch at the present time).
Foam drifts with the wind over the water: sample x of F(k) is the foam that stands at x + bolan_sea_foam_drift(k),
and F(tick) is read at x - bolan_sea_foam_drift(now), bilinearly between its samples.

    Fields:
    shown: Time of the waves [s]: that of the last step, reduced by the loop.
    tick: Number of the last tick.
    now: Number of the present time: `tick`, and the part of a tick since.
    first_tick: F(first_tick) is 0.
    foam_from: Number that changes when the memory is lost, by a jump in time or by bolan_sea_settle().
    keep: Of the last tick, what is left now.
    lose: Of the last tick, what is left now.
    tick_keep: Of a tick, what is left at the next one.
    tick_lose: Of a tick, what is left at the next one.
    """
    _type = "bolan_sea_clock"
    shown: float
    tick: float
    now: float
    first_tick: float
    foam_from: float
    keep: float
    lose: float
    tick_keep: float
    tick_lose: float


class SeaComponent(Struct):
    """One wave of a sum. At rest point x and time t, with th = k.x - omega t + phase:
COSINES: eta = amplitude cos th, D = -drift k/|k| sin th, drift = amplitude coth(|k| depth).
EXP_COSINES: eta = amplitude (e^{s (cos th - 1)} - mean) * 2 / (1 - e^{-2s}), mean = e^{-s} I0(s), which has zero
mean and the range 2 amplitude. D = 0, because the crests are sharp already: choppiness does nothing, and the
Jacobian is 1.

    Fields:
    kx: Wave vector [rad/m]; points where the wave goes.
    ky: Wave vector [rad/m]; points where the wave goes.
    omega: Frequency over the ground [rad/s]; < 0 where the current carries the wave back.
    phase: Phase at the world origin and time 0 [rad], 0..2 pi.
    amplitude: Amplitude [m].
    drift: Amplitude of the horizontal displacement, choppiness not applied [m]; 0 with EXP_COSINES.
    """
    _type = "bolan_sea_component"
    kx: float
    ky: float
    omega: float
    phase: float
    amplitude: float
    drift: float


class SeaDesc(Struct):
    """How a sea is made.

The fields that more than one model reads mean the same in each of them, so that another model shows the same sea
state, seed and current. What one model alone reads stands in the struct of that model; the other models ignore it,
but every field must be in its range whatever the model.

    Fields:
    waves: The model that makes the waves.
        Default BOLAN_WAVES_FFT.
    sea_state: What the wind and swell are.
        Default: wind 8 m/s from 240 degrees, fetch 200 km.
        It is kept as given where the sea is limited; bolan_sea_get_summary() describes the limited sea.
    seed: Which sea of this sea state.
        Any value; default 1.
    cpu: Which kernels compute the fields.
        Default BOLAN_CPU_AUTO; a set that this machine lacks counts as AUTO.
        The fields have the same bits with every set.
    choppiness: Factor on the horizontal displacement.
        0..2; default 1, linear theory.
        Raised: sharper crests, which fold sooner. EXP_COSINE has no horizontal displacement.
    order: Order of the surface in the steepness of the waves, of FFT and TEXTURES.
        1..2; default 1, a linear sea, symmetric about its level.
        2: with the bound waves of second order, which make crests higher and sharper than troughs are deep
        (Longuet-Higgins 1963; Sharma & Dean 1981): see bolan_bound_weights.
        Sums of waves have order 1 alone: one warning says so (SEA_ORDER). Waves too high for the theory in their depth
        have lower bound waves, with one warning (SEA_BOUND_LIMITED).
    loop_period: Time after which every field repeats [s], bit for bit.
        10..1e6, or 0 (default): no repetition.
        Frequencies are rounded to multiples of 1 / period; from 200 s on the rounding is not visible.
        With FFT and a current there is no loop: refused.
        TEXTURES has its own period, textures.period.
    resolution: Samples along the side of a tile, of FFT and TEXTURES.
        A power of two, 32..1024; default 256.
        Raised: shorter waves with the same number of tiles, and pixels nearer to the exact slopes; time and memory grow
        with its square. From 128 on all resolutions show the same waves.
    length: Side of the largest tile [m], of FFT and TEXTURES.
        10..1e5, or 0 (default): 16 peak wavelengths and at least 12 of the longest swell that matters, rounded up in
        quarters of an octave; of TEXTURES 7 and 5.
        Raised: more waves at the peak, which return to a point later; the shortest wave is longer.
    foam_decay: e-folding time of the foam memory [s], of FFT and TEXTURES.
        0.1..60; default 9: whitecaps last for 1 to 3 s on the water that they began on.
        Raised: longer streaks behind crests.
    fft: BOLAN_WAVES_FFT.
    textures: BOLAN_WAVES_TEXTURES: one tile, and a loop of still frames.
    cosines: BOLAN_WAVES_COSINES: frequencies x directions waves.
    exp_cosine: BOLAN_WAVES_EXP_COSINE: waves exp(s cos).
    """
    _type = "bolan_sea_desc"
    waves: str
    sea_state: "SeaState"
    seed: int
    cpu: str
    choppiness: float
    order: int
    loop_period: float
    resolution: int
    length: float
    foam_decay: float
    fft: Struct
    textures: Struct
    cosines: Struct
    exp_cosine: Struct


class SeaFineView(Struct):
    """The fine waves of a sea of model FFT: capillary-gravity waves from the last cascade's ring down to 1 cm, of which
pixels near the eye read the slopes.
They have most of the slope variance that Cox & Munk state for the wind and the cascades lack. Their height is a
millimetre, which queries leave out, as they do the slopes.
Sample (i, j) is at [j * n + i]. It lies at tile coordinates (i, j) * length / n, as that of a bolan_cascade_view.

    Fields:
    n: Samples along a side; 0: there are none, and the rest is 0.
    length: Side of the tile [m], and its rotation against the world, counter-clockwise [rad].
    angle: Side of the tile [m], and its rotation against the world, counter-clockwise [rad].
    k_min: Ring of wave numbers [rad/m].
    k_max: Ring of wave numbers [rad/m].
    slopes: Expected slope covariance xx, xy, yy.
    slope_x: Gradient of the height by the place read, to be read linearly.
    slope_y: Gradient of the height by the place read, to be read linearly.
    slope_half: n * n * 4 halfs to upload as RGBA16F: slope_x, slope_y, and two fields without a use.
    """
    _type = "bolan_sea_fine_view"
    n: int
    length: float
    angle: float
    k_min: float
    k_max: float
    slopes: Tuple[float, ...]
    slope_x: Any
    slope_y: Any
    slope_half: Any


class SeaLimit(Struct):
    """Factors on the height, in (0, 1], with which water of this depth can carry the waves; 1: nothing is too high.
bolan_sea_create() applies the smaller factor to all waves and warns.

    Fields:
    by_depth: Depth: Hs <= 0.6 depth (waves that break over a flat beach have Hrms = 0.42 depth: Thornton & Guza 1982).
    by_steepness: Steepness: the sum over the systems of (Hs / (0.142 L tanh(2 pi depth / L)))^2 is at most 1.
        L is the wave length at the peak of the system.
        So the significant wave of a lone system is at most as steep as the steepest single wave (Miche 1944).
        The energies of several systems add. A measured spectrum counts as one system.
    """
    _type = "bolan_sea_limit"
    by_depth: float
    by_steepness: float


class SeaLoop(Struct):
    """How a sea repeats in time.

    Fields:
    period: Time after which every field repeats [s]; 0: never.
    frames: Number of still frames in the period; 0 where the sea moves continuously.
    frame: The frame that the fields show, 0..frames - 1; 0 where there are no frames.
    """
    _type = "bolan_sea_loop"
    period: float
    frames: int
    frame: int


class SeaMode(Struct):
    """Most waves that a mode has.
Modes (i, j) with |i| and |j| below have several waves; others have one, part 0.
One wave of a mode (i, j) of a cascade, wave vector 2 pi (i, j) / length in the axes of the tile.
A mode near the origin is the sum of several waves with one wave vector: its cell of the spectrum is wide, and each
wave has the frequency of a slice of the cell.
At time t, with c + i s = e^{2 pi i turns t}, the amplitude of the height is
h = (a[0] c + a[1] s) + i (a[2] c + a[3] s).
It stands for -(i, j) as well, whose amplitude is the conjugate.

    Fields:
    a: a of the formula above [m].
    inverse_k: coth(|k| depth) / |k| [m]; D = i k inverse_k h.
    cubic: Divisor of a field that a cubic B-spline reads, and of one that is read linearly: planes are h, D or their
        derivatives over these.
    linear: Divisor of a field that a cubic B-spline reads, and of one that is read linearly: planes are h, D or their
        derivatives over these.
    turns: Frequency [1/s]; 0: there is no such wave.
    """
    _type = "bolan_sea_mode"
    a: Tuple[float, ...]
    inverse_k: float
    cubic: float
    linear: float
    turns: float


class SeaSample(Struct):
    """The sea at one rest point: all bands summed (cascades by cubic splines), choppiness and lift applied.

    Fields:
    height: Displacement of the parcel: (x, y, z) = (x0 + dx, y0 + dy, height) [m].
    dx: Displacement of the parcel: (x, y, z) = (x0 + dx, y0 + dy, height) [m].
    dy: Displacement of the parcel: (x, y, z) = (x0 + dx, y0 + dy, height) [m].
    slope_x: Slope of the surface dz/dx, dz/dy *after* displacement.
        Where |jacobian| < 0.1, the slope for |jacobian| = 0.1.
    slope_y: Slope of the surface dz/dx, dz/dy *after* displacement.
        Where |jacobian| < 0.1, the slope for |jacobian| = 0.1.
    jacobian: Jacobian of the horizontal map; < 0 where the surface folds.
    foam: Sum of the foam memories, >= 0.
        Sums of waves have no memory: the present -(dDx/dx + dDy/dy) choppiness where it is > 0.
    """
    _type = "bolan_sea_sample"
    height: float
    dx: float
    dy: float
    slope_x: float
    slope_y: float
    jacobian: float
    foam: float


class SeaState(Struct):
    """A sea: wave systems, or a measured spectrum, over water of one depth, with the local wind that roughens it.

    Fields:
    system_count: Number of systems, 0..8.
    systems: The wind seas and swells; their energies add.
    measured: A spectrum that is added to the systems, or NULL.
        Borrowed; it must live until bolan_sea_create() has returned.
    depth: Depth of the water for dispersion and TMA [m], 0.1..BOLAN_DEEP; default BOLAN_DEEP.
    wind_speed: U10 [m/s], 0..70; it roughens the short waves and makes foam.
    wind_from_deg: Where the wind comes FROM, compass [deg], -360..360.
    current_x: Uniform current, east and north [m/s], -5..5; default 0. The waves ride on it.
    current_y: Uniform current, east and north [m/s], -5..5; default 0. The waves ride on it.
    frame: The frame of the spectra of systems and of measured; default WATER. Without a current it makes no difference.
    """
    _type = "bolan_sea_state"
    system_count: int
    systems: Tuple["WaveSystem", ...]
    measured: Any
    depth: float
    wind_speed: float
    wind_from_deg: float
    current_x: float
    current_y: float
    frame: str


class SeaStatistics(Struct):
    """Statistics of the surface at the present time, as queries return and images show it: the JSON keys of `bolan
measure`. They are taken at 65536 places. At fixed points a parcel counts by the area that it covers, its Jacobian.

    Fields:
    hs: 4 sqrt(m0_field) [m].
    tp: Periods of the discrete spectrum that is synthesised [s]; of a measured spectrum, of the file.
        On a current: tp in the water, which goes with the length of the waves; tm02 and te over the ground.
    tm02: Periods of the discrete spectrum that is synthesised [s]; of a measured spectrum, of the file.
        On a current: tp in the water, which goes with the length of the waves; tm02 and te over the ground.
    te: Periods of the discrete spectrum that is synthesised [s]; of a measured spectrum, of the file.
        On a current: tp in the water, which goes with the length of the waves; tm02 and te over the ground.
    direction_from: Mean direction and spread of the realised amplitudes [deg]; of a measured spectrum, of the file.
    spread: Mean direction and spread of the realised amplitudes [deg]; of a measured spectrum, of the file.
    mss: Slope variance of the displaced surface at fixed points, and its up- and crosswind parts (of the mean direction
        when calm).
    mss_up: Slope variance of the displaced surface at fixed points, and its up- and crosswind parts (of the mean direction
        when calm).
    mss_cross: Slope variance of the displaced surface at fixed points, and its up- and crosswind parts (of the mean direction
        when calm).
    skewness: Of the height at fixed points; 0 and 3 for linear waves, with choppiness too.
    kurtosis: Of the height at fixed points; 0 and 3 for linear waves, with choppiness too.
    mean_level: Mean height at fixed points [m]; 0 but for sampling.
    jacobian_min: Over all parcels.
    jacobian_mean: Over all parcels.
    whitecap_fraction: Share of the parcels whose Jacobian is below the foam threshold.
    m0_spectrum: Variance of the limited sea state; of a measured spectrum over its own frequencies [m2].
    m0_field: Variance of the height at fixed points [m2].
    """
    _type = "bolan_sea_statistics"
    hs: float
    tp: float
    tm02: float
    te: float
    direction_from: float
    spread: float
    mss: float
    mss_up: float
    mss_cross: float
    skewness: float
    kurtosis: float
    mean_level: float
    jacobian_min: float
    jacobian_mean: float
    whitecap_fraction: float
    m0_spectrum: float
    m0_field: float


class SeaSummary(Struct):
    """Integral parameters of a sea state on its current, over the frequency in the water.
A calm has zeros, and the direction of the wind.

    Fields:
    m0: Variance of the sea state [m2]; of a measured spectrum over its own frequencies.
    hs: Significant wave height, 4 sqrt(m0) [m].
    tp: Period of the spectral peak [s].
    tm01: Mean periods m0/m1 and sqrt(m0/m2) [s].
    tm02: Mean periods m0/m1 and sqrt(m0/m2) [s].
    te: Energy period m-1/m0 [s].
    from_deg: Mean direction that the waves come FROM, compass [deg].
    spread_deg: Circular spread sqrt(2 (1 - r1)) [deg].
    """
    _type = "bolan_sea_summary"
    m0: float
    hs: float
    tp: float
    tm01: float
    tm02: float
    te: float
    from_deg: float
    spread_deg: float


class SeaTexel(Struct):
    """A sample of the displacement of a cascade: 16 bytes, so that the 4 x 4 samples of a spline are four rows of 64.

    Fields:
    dx: D, world east and north [m].
    dy: D, world east and north [m].
    height: eta [m].
    dxy: dDx/dy (= dDy/dx), by the place read.
    """
    _type = "bolan_sea_texel"
    dx: float
    dy: float
    height: float
    dxy: float


class SeaWarp(Struct):
    """The warped plane over which the tiles of a sea are read. A sea that is seen from afar would show its tiles, because
what is one tile away is the same. So a rest point x is read at x + sum of a w(k.x + phase), w a wave of period and
amplitude 1 made of two parabolas: with u = 2 fract(k.x + phase) - 1 it is 4 u (1 - |u|). That moves waves by a few
times their length, slowly. Distances and directions change by some per cent; frequencies, and everything at a
point, do not change.

    Fields:
    count: Waves of the warp; 0: the plane is even.
    wave:
    """
    _type = "bolan_sea_warp"
    count: int
    wave: Tuple[Struct, ...]


class Seawater(Struct):
    """The water's colour and its level.

    Fields:
    type: Optical type of the water; default IB.
    level: Mean water level above the ground's datum [m], -20..20; default 0.
    foam: Strength of the foam, 0..2; default 1.
    """
    _type = "bolan_seawater"
    type: str
    level: float
    foam: float


class Sky(Struct):
    """The sun, the air and the clouds.

    Fields:
    sun_azimuth_deg: Compass direction of the sun [deg], -360..360; default 220.
    sun_elevation_deg: Elevation of the sun [deg], -90..90; default 35. Below -18 it is night.
    visibility: Meteorological range at sea level [m], 500..300000; default 40000. Raised: less haze.
    cloud_cover: Share of the sky with clouds, 0..1; default 0.3.
    cloud_base: Height of the clouds' base [m], 100..12000; default 1200.
    cloud_seed: Which clouds; default 1.
    """
    _type = "bolan_sky"
    sun_azimuth_deg: float
    sun_elevation_deg: float
    visibility: float
    cloud_cover: float
    cloud_base: float
    cloud_seed: int


class SkyLight(Struct):
    """What sun and sky give at the sea, linear, in units of the irradiance of the sun in space at normal incidence.

    Fields:
    sun_direction: Unit vector to the sun.
    sun_irradiance: Irradiance of the sun on a surface that faces it; 0 below the horizon.
    sky_irradiance: Irradiance of the sky on a horizontal surface.
    """
    _type = "bolan_sky_light"
    sun_direction: Tuple[float, ...]
    sun_irradiance: Tuple[float, ...]
    sky_irradiance: Tuple[float, ...]


class SpectrumContents(Struct):
    """What a file of spectra holds.

    Fields:
    format: Short and long name of the format: "swan", "SWAN spectra".
    title: Short and long name of the format: "swan", "SWAN spectra".
    record_count: How many records, 1 or more.
    records: The records in the order of time, by which record counts.
    place_count: How many locations the first record has; 0: the file is of one place that it does not give.
    places:
    spherical: The places are longitudes and latitudes.
    frequency_count: Frequencies of the first spectrum that could be read, the lowest and the highest [Hz].
    lowest_hertz:
    highest_hertz:
    direction_count: Directions; 0: the file has none, or moments alone.
    has_moments: The bands have moments of the directions.
    read_count: How many spectra, of all records and locations, were read for the ranges below: at most 512, evenly chosen.
    unreadable_count: How many of those have no readable data.
    hs_min: Ranges of the significant height [m] and the peak period [s] of those that could be read; of the period without
        calms, 0 where all are.
    hs_max: Ranges of the significant height [m] and the peak period [s] of those that could be read; of the period without
        calms, 0 where all are.
    tp_min: Ranges of the significant height [m] and the peak period [s] of those that could be read; of the period without
        calms, 0 where all are.
    tp_max: Ranges of the significant height [m] and the peak period [s] of those that could be read; of the period without
        calms, 0 where all are.
    """
    _type = "bolan_spectrum_contents"
    format: Optional[str]
    title: Optional[str]
    record_count: int
    records: Any
    place_count: int
    places: Any
    spherical: bool
    frequency_count: int
    lowest_hertz: float
    highest_hertz: float
    direction_count: int
    has_moments: bool
    read_count: int
    unreadable_count: int
    hs_min: float
    hs_max: float
    tp_min: float
    tp_max: float


class SpectrumOptions(Struct):
    """What to read of a measured spectrum, and what stands in for what it lacks.

    Fields:
    record: Which record in time; 0 (default) is the earliest, whatever the order in the text. Unused where time is
        set.
    time: The date of the record, UTC: ISO 8601, "2018-01-01T06:00", seconds and Z optional. "" (default): by number. The
        nearest record within an hour is taken, with a warning where it is not that time; see interpolate.
    interpolate: A time between two records is interpolated between them; default false: the nearest record.
        The variance density is linear in time, so m0 is. Of a sea with one seed every wave keeps its phase, and its
        amplitude changes steadily. Both records must have the same frequencies and directions.
    location: Which location of a file with several, from 1. 0 (default): the one nearest to place, or the
        first, with a warning where there are several.
    place: Longitude and latitude [deg], or x and y [m], +-1e9; NAN (default): no place.
        A message names the location that is nearest and its distance.
    from_deg: Where the waves come FROM, compass [deg], -360..360, for a spectrum without directions. NAN (default): not
        known; 270 stands in, with a warning.
    spread_s: The exponent s of cos-2s, 0..200, for a spectrum without spreads. NAN (default): not known; 10 stands in, with a
        warning.
    """
    _type = "bolan_spectrum_options"
    record: int
    time: str
    interpolate: bool
    location: int
    place: Tuple[float, ...]
    from_deg: float
    spread_s: float


class SpectrumPlace(Struct):
    """A location.

    Fields:
    x: Longitude and latitude [deg], or x and y [m].
    y: Longitude and latitude [deg], or x and y [m].
    name: The file's name of it; "" where it gives none.
    """
    _type = "bolan_spectrum_place"
    x: float
    y: float
    name: str


class SpectrumRecord(Struct):
    """A record in time.

    Fields:
    seconds: Seconds since 1970; NAN where the file gives no time.
    time: The time in ISO 8601; "" where the file gives none.
    """
    _type = "bolan_spectrum_record"
    seconds: float
    time: str


class SpectrumText(Struct):
    """The bytes of one file. The formats are recognised by their content; docs/formats.md has a table of them.

- **SWAN** ("SWAN 1"), 2-D or 1-D. ZERO is a calm.
- **WAVEWATCH III**, point spectra as text ("'WAVEWATCH III SPECTRA'") or NetCDF (efth).
- **ERA5** and other models of ECMWF, NetCDF (d2fd, a common logarithm).
- **Datawell** .spt, **TRIAXYS** directional and non-directional, **Spotter** JSON, **OCTOPUS**.
- **CDIP** and **NDBC** in NetCDF (waveEnergyDensity, spectral_wave_density).
- **NDBC**, history and real time, a set of texts: pass the density; the direction texts are optional. Their rows
  are matched by time, their bands by frequency.

NetCDF is that of the classic layouts, CDF-1 and CDF-2.

Where a file has moments of the directions in place of the directions themselves, each band is spread by what is
known of it:
- alpha1, alpha2, r1, r2: the distribution of maximum entropy with these four moments (Kobune & Hashimoto 1986). It
  is never negative and keeps the reported direction and spread, where the plain Fourier sum is negative in every
  eighth bin. Moments that fit no distribution (noise): that sum, clipped and renormalised;
- alpha1, r1: cos-2s with s = r1 / (1 - r1);
- alpha1: cos-2s with spread_s;
- nothing: as the nearest lower band that has a direction, or the lowest that has one; where no band has one,
  from_deg.

Missing densities (999) between two others are interpolated; in a matrix they count as no energy. A row of
directions that is missing is replaced by the nearest within an hour. All that stands in for missing data is a
warning.

Directions may be in any order, also a sector of the circle, or with both 0 and 360. Where their step varies, the
density is linear between neighbours. Limits: 2..1000 frequencies of 1e-3..10 Hz, 3..720 directions,
Hs up to 40 m. Numbers are read independently of the locale; "nan" and "inf" are refused. A record or location that
is not asked for need not be readable, only its date.

    Fields:
    name: For messages: the file name. NDBC's history files name their quantity in it: 41004w2018.txt.
    data: The bytes; text need not end in NUL.
    size: How many.
    """
    _type = "bolan_spectrum_text"
    name: Optional[str]
    data: Optional[str]
    size: int


class SpectrumTexts(Struct):
    """The texts of one measurement.

    Fields:
    density: Any format above; of an NDBC set the density: history (w), or real-time .data_spec.
    swdir: NDBC alpha1, alpha2, r1, r2 (d, i, j, k); data NULL where absent.
    swdir2: NDBC alpha1, alpha2, r1, r2 (d, i, j, k); data NULL where absent.
    swr1: NDBC alpha1, alpha2, r1, r2 (d, i, j, k); data NULL where absent.
    swr2: NDBC alpha1, alpha2, r1, r2 (d, i, j, k); data NULL where absent.
    """
    _type = "bolan_spectrum_texts"
    density: "SpectrumText"
    swdir: "SpectrumText"
    swdir2: "SpectrumText"
    swr1: "SpectrumText"
    swr2: "SpectrumText"


class SurfaceDesc(Struct):
    """How fine the surface is.

    Fields:
    kind: The kind of surface; default PROJECTED.
    pixels_per_vertex: Distance of neighbouring vertices [pixels], 1..32; default 3. Raised: fewer triangles.
    max_vertices: Capacity of the caller's vertex buffer, >= 1024; default 200000. The grid is coarsened to fit.
    """
    _type = "bolan_surface_desc"
    kind: str
    pixels_per_vertex: float
    max_vertices: int


class SurfaceMotion(Struct):
    """The surface and its motion at one world point.

    Fields:
    height: Of the surface above the datum [m].
    rise: How fast the height at this point rises [m/s]: what a wave staff measures.
    normal: Unit normal, z >= 0.
    velocity: Of the water at the surface, as in bolan_kinematics [m/s], [m/s2].
    acceleration: Of the water at the surface, as in bolan_kinematics [m/s], [m/s2].
    """
    _type = "bolan_surface_motion"
    height: float
    rise: float
    normal: Tuple[float, ...]
    velocity: Tuple[float, ...]
    acceleration: Tuple[float, ...]


class SurfaceProjector(Struct):
    """The projector of bolan_surface_projected() for one view: a map from the unit square to mean water in closed form.
With it a vertex shader can place a static grid on the water (Ni, Zhang & Tan, after Johanson 2004).
The projector stands at the eye and is level.
It covers the water in view, enlarged by the bounds of the displacement, and no sky.

    Fields:
    visible: False: no water can be in view, and nothing needs to be drawn.
    height: Height of the eye over the water [m], at least 0.5; the rows are computed from it.
    above: Height of the eye over the water [m], without a lower bound.
    near_parameter: First value and length of the range of the row parameter s. Rows are even steps of s.
        The distance of a row is height * x(s); projected.c has x(s).
    range: First value and length of the range of the row parameter s. Rows are even steps of s.
        The distance of a row is height * x(s); projected.c has x(s).
    heading: Range of azimuths, clockwise from north: heading +- half [rad].
    half: Range of azimuths, clockwise from north: heading +- half [rad].
    guard: Rows nearer than this distance [m] are full circles, for waves that lean into the view.
    """
    _type = "bolan_surface_projector"
    visible: bool
    height: float
    above: float
    near_parameter: float
    range: float
    heading: float
    half: float
    guard: float


class SurfaceSize(Struct):
    """The size of a grid of vertices: vertices[row * columns + column].
Rows run from near to far, columns clockwise.
Both are zero when no water can be in view.
A cell is two triangles; bolan_surface_grid_indices() writes their indices.

    Fields:
    columns:
    rows:
    """
    _type = "bolan_surface_size"
    columns: int
    rows: int


class SurfaceVertex(Struct):
    """A vertex of mean water.

    Fields:
    x: Position relative to the eye, along the world's axes [m]. z includes the drop of the round earth.
    y: Position relative to the eye, along the world's axes [m]. z includes the drop of the round earth.
    z: Position relative to the eye, along the world's axes [m]. z includes the drop of the round earth.
    spacing: Distance to the neighbouring vertices [m]; of the two directions the larger.
        The geometry must not carry waves shorter than twice the spacing.
        Waves should fade out between eight and two times the spacing.
    stitch_x: NESTED: offset to the two neighbours [m]; they lie at -stitch and +stitch, and this vertex lies between them.
        A stitched vertex is displaced to the mean of its neighbours' displaced positions.
        Its x, y, z and spacing are already their means.
        (0, 0): the vertex is not stitched.
    stitch_y: NESTED: offset to the two neighbours [m]; they lie at -stitch and +stitch, and this vertex lies between them.
        A stitched vertex is displaced to the mean of its neighbours' displaced positions.
        Its x, y, z and spacing are already their means.
        (0, 0): the vertex is not stitched.
    """
    _type = "bolan_surface_vertex"
    x: float
    y: float
    z: float
    spacing: float
    stitch_x: float
    stitch_y: float


class SurfaceView(Struct):
    """The view that the surface must cover.

    Fields:
    eye: Position of the eye [m]; z above mean sea level.
    heading_deg: Attitude of the camera [deg]: heading by compass, pitch up, roll clockwise.
    pitch_deg: Attitude of the camera [deg]: heading by compass, pitch up, roll clockwise.
    roll_deg: Attitude of the camera [deg]: heading by compass, pitch up, roll clockwise.
    fov_y: Vertical field of view [rad], 0.001..2.8.
    aspect: Width over height of the view.
    pixel_height: Height of the view [pixels]; it sets the angular step of the grid.
    water_level: Height of mean water [m].
    vertical: Bounds of the vertical and horizontal displacement [m]; see bolan_sea_bounds().
    horizontal: Bounds of the vertical and horizontal displacement [m]; see bolan_sea_bounds().
    shift_x: Centre of an off-centre frustum, right of and above the camera's axis; default 0, 0.
        Unit: half widths of the view (x) and half heights (y).
    shift_y: Centre of an off-centre frustum, right of and above the camera's axis; default 0, 0.
        Unit: half widths of the view (x) and half heights (y).
    """
    _type = "bolan_surface_view"
    eye: Tuple[float, ...]
    heading_deg: float
    pitch_deg: float
    roll_deg: float
    fov_y: float
    aspect: float
    pixel_height: int
    water_level: float
    vertical: float
    horizontal: float
    shift_x: float
    shift_y: float


class Surfaces(Struct):
    """Where bolan_renderer_read_surfaces() writes: width * height elements each, row 0 at the top, or NULL.

    Fields:
    label: bolan_label, or BOLAN_LABEL_OBJECT + index of an object.
    normal: Unit normal in world axes; 0 at the sky. Of water: bolan_query_surface() at the place of the pixel, where the
        picture's own normal is low-passed to the pixel. Of land: the map that shades it. Of objects: their vertices'.
    motion: Velocity of the water at the surface, by bolan_query_motion() [m/s]; 0 at sky, land and objects. Needs `flow`.
    flow: The flow at the time of the world's sea: bolan_flow_step(). NULL where `motion` is.
    """
    _type = "bolan_surfaces"
    label: Any
    normal: Any
    motion: Any
    flow: Any


class Technique(Struct):
    """A way to make water: a wave model x a surface x an optics. Every mix works.

    Fields:
    name: The name that the command line and scene files use. Static storage.
    waves: The wave model.
    surface: The geometry.
    optics: The shading.
    wind_spectrum: A bolan_spectrum_kind: the spectrum that the technique makes of a wind. -1: the scene's own wind_spectrum.
    """
    _type = "bolan_technique"
    name: Optional[str]
    waves: str
    surface: str
    optics: str
    wind_spectrum: int


class TilesDesc(Struct):
    """How tiles are made.

    Fields:
    paper: Normal maps as the paper prints them, twice as steep as the water; default false.
    bump: Factor on the slopes of the normal maps, 0.01..100; default 1.
    color: Colour of the water's own texture, linear, each component 0..1; default a dark green-blue.
    sun: Unit direction to the sun, z > 0; default straight up.
    depth: Depth of the bottom that receives the caustics, under mean water [m], 0.05..200; default 0.
        0: the depth where these waves focus the light best, at most 2 m. Raised beyond it: the caustics blur.
    index: Refractive index of the water, 1.01..3; default 1.34.
    """
    _type = "bolan_tiles_desc"
    paper: bool
    bump: float
    color: Tuple[float, ...]
    sun: Tuple[float, ...]
    depth: float
    index: float


class TilesView(Struct):
    """A read-only view of tiles; valid while they live.

    Fields:
    n: Texels along a side, 8..1024.
    frames: Frames of the loop, 1..BOLAN_MAX_LOOP_FRAMES.
    length: Side of the tile [m].
    angle: Angle of the tile against the world, counter-clockwise [rad]; see bolan_cascade_view.
    period: Period of the loop [s].
    depth: Depth of the bottom that receives the caustics [m].
    paper: The normal maps are as the paper prints them.
    height: Heights: frames x n x n [m].
    normal: Normal maps: frames x n x n x 3 bytes, unit normal * 127.5 + 127.5.
    detail: The water's own texture, linear: frames x n x n x 3 bytes. Its mean is half of its brightest channel.
    caustics: Caustics: frames x n x n bytes.
    """
    _type = "bolan_tiles_view"
    n: int
    frames: int
    length: float
    angle: float
    period: float
    depth: float
    paper: bool
    height: Any
    normal: Any
    detail: Any
    caustics: Any


class View(Struct):
    """One picture of a step: eye, frustum and target. Axes of the camera: x right, y up; it looks along -z, or along +z
where the last row of the projection is 0 0 1 0.

    Fields:
    eye: Place of the eye in the world [m], z above the datum. It is never moved.
    view: World to camera: a rotation; its translation is ignored, since the eye is `eye`. Column-major.
    projection: Camera to clip: any perspective, off-centre, standard or reversed, finite or infinite. Of the whole picture
        where `tile` is set. Bolan keeps a depth buffer of its own, so that the z row matters only to a host's depth.
    zero_to_one: True: clip depth of `projection` is [0,1], as glClipControl(GL_ZERO_TO_ONE) has it. False (default): [-1,1].
    framebuffer: GL name; 0 (default) is the window. Complete, with a colour buffer that holds no integers.
    x: Lower left corner of the rectangle that is drawn [px]; default 0, 0.
    y: Lower left corner of the rectangle that is drawn [px]; default 0, 0.
    width: Its size [px], 1..16384; default 1280 x 720.
    height: Its size [px], 1..16384; default 1280 x 720.
    jitter: Moves the picture right and up by parts of a pixel; default 0, 0.
        Geometry and footprints are those of the view without it, and motion vectors leave it out.
    motion: Motion vectors, for temporal antialiasing or an upscaler of yours.
    temporal: True: temporal antialiasing; not with `accumulate`. Default false.
        Each view has a jitter of its own, besides `jitter`, and is blended with the views before it that were drawn
        with the same `cache`; motion vectors bring those to their places.
        The image is a function of the sequence of views. Display values are blended, as by `samples`, so that a glint
        does not outshine its pixel. While nothing changes the image tends to that of 64 samples.
        Only bolan_renderer_draw_world() blends. BOLAN_OUTPUT_LINEAR and bolan_renderer_read_linear() have the last view
        alone.
    tile: This picture is the rectangle at x, y (from the lower left) of a whole picture of that size [px]; default all
        0: it is the whole.
        Sky and water of tiles are those of the whole to one level of 255.
        Reflections of land and objects, refraction, glow and half-rate shading read the image round a pixel: overlap
        the tiles by a guard band of BOLAN_TILE_STEP, twice that with glow (from BOLAN_QUALITY_HIGH on), and cut it off.
        Let x and y be multiples of BOLAN_TILE_STEP. A reflection of what stands outside tile and guard is that of the
        sky.
    samples: Supersampling: pictures with shifted pixels that are averaged, 1..256; default 1.
    accumulate: True: the samples of this view are added to those of the views before it, and the mean of all is written, for
        an image that gets finer while nothing changes. Default false.
        Shifts go on where the last view left off: 64 views of one sample show what one view of 64 samples shows.
        The first view after one without it, of another size, another output or a host begins anew, and so must you
        after any change: draw one view without it. A renderer holds one such sum, of 64 bytes a pixel.
        Distances and surfaces that are read back are those of the last sample, not of the pixels' middles.
    output: Default BOLAN_OUTPUT_SRGB.
    progressive: False (default): the picture is a function of step and view alone, whatever was drawn before.
        True: new clouds and new ground are made over several frames, so that a moving eye never waits; until they are
        done the old ones are shown. Exposure and light of the sky are those of an earlier frame, unless the sun has
        turned by more than 1 degree since: no frame waits for the GPU to measure them. For windows.
    without_water: True: bolan_renderer_draw_world() draws all but the water. False (default): the water too.
    cache: NULL (default): the renderer's own.
    """
    _type = "bolan_view"
    eye: Tuple[float, ...]
    view: "Mat4"
    projection: "Mat4"
    zero_to_one: bool
    framebuffer: int
    x: int
    y: int
    width: int
    height: int
    jitter: Tuple[float, ...]
    motion: Struct
    temporal: bool
    tile: Struct
    samples: int
    accumulate: bool
    output: str
    progressive: bool
    without_water: bool
    cache: Any


class Water(Struct):
    """A water: its waves, its bed, its level and its colour.
It owns nothing; the objects that it points to must outlive its use.
Thread-safety: may be read by many threads between steps of its sea.

    Fields:
    sea: The waves. Must not be NULL where the water is queried or drawn. Default NULL.
    flow: The flow of that sea, for questions about moving water. Default NULL: such questions are misuse.
    ground: The ground under the water. Default NULL: deep water everywhere.
    level: Mean water level above the datum of the ground [m]; default 0.
    layers: Waves that are added to those of the sea: layer_count pointers, none NULL. Default NULL and 0.
    layer_count: Number of layers, 0..BOLAN_MAX_WAVE_LAYERS.
    optics: Colour, clarity and index of refraction; default Jerlov type IB.
    foam: Strength of the foam, 0..2; default 1.
    """
    _type = "bolan_water"
    sea: Any
    flow: Any
    ground: Any
    level: float
    layers: Any
    layer_count: int
    optics: "WaterOptics"
    foam: float


class WaterOptics(Struct):
    """Optical coefficients at red, green, blue = 650, 550, 450 nm.
They are consistent: kd = (absorption + backscatter) / 0.9 within 7 %.
Absorption is never below that of pure water.

    Fields:
    kd: Diffuse attenuation of downward irradiance, Kd [1/m].
    absorption: Absorption a [1/m].
    scattering: Scattering b [1/m].
    backscatter: Backscattering bb [1/m].
    deep: Radiance that leaves deep water, above the surface, per unit downward irradiance: Rrs [1/sr].
    index: Refractive index; 1.34.
    """
    _type = "bolan_water_optics"
    kd: Tuple[float, ...]
    absorption: Tuple[float, ...]
    scattering: Tuple[float, ...]
    backscatter: Tuple[float, ...]
    deep: Tuple[float, ...]
    index: float


class WaveLayerSample(Struct):
    """A layer's waves at one place.

    Fields:
    height: Added to the height of the surface [m].
    slope_x: Added to the slope of the surface, east and north.
    slope_y: Added to the slope of the surface, east and north.
    """
    _type = "bolan_wave_layer_sample"
    height: float
    slope_x: float
    slope_y: float


class WaveSystem(Struct):
    """One wind sea or swell. It is fixed by its height and peak; the helpers below derive these from wind and fetch.

    Fields:
    kind: Shape in frequency; default JONSWAP.
    hs: Significant wave height 4 sqrt(m0) [m], 0..40; default 0. Of TMA: before the depth factor.
    peak_omega: Peak angular frequency [rad/s], 0.1..50; default 1.
    gamma: Peak enhancement of JONSWAP, TMA and TORSETHAUGEN, 1..10; default 3.3. Raised: a narrower peak.
    lambda: Shape of OCHI_HUBBLE, 0.1..10, or 0 (default): 1. Raised: a narrower peak and a steeper tail.
    from_deg: Where the waves come FROM, compass [deg], -360..360.
    spreading: Shape in direction; default HASSELMANN.
    spread_s: Exponent s of COS2S, 0..200; default 10. Raised: longer crests.
    wind_speed: U10 [m/s], 0..70; default 0: U = cp, the phase speed g/wp at the peak.
        U/cp shapes DONELAN, ELFOUHAILY, HASSELMANN and MITSUYASU; U10 the short waves of ELFOUHAILY.
    swell: Swell parameter xi of Horvath, 0..1; default 0. Raised: longer crests.
    """
    _type = "bolan_wave_system"
    kind: str
    hs: float
    peak_omega: float
    gamma: float
    lambda_: float
    from_deg: float
    spreading: str
    spread_s: float
    wind_speed: float
    swell: float


class WaveTrainDesc(Struct):
    """A wave train: parallel waves of one length inside an area, after the Wave Control packet of CIGI 3.3 and 4.0.
The height at (x, y) is height / 2 * edges * cos(k . (x - centre) - omega time + phase).
The edges fall from 1 to 0 as smooth steps.
The area stands still while the crests run through it.
Parcels move up and down only.

    Fields:
    from_deg: Compass direction that the waves come FROM [deg], -360..360; default 0.
    length: Distance from crest to crest [m], 0.5..2000; default 100.
    period: Time from crest to crest [s], 0.1..1000, or 0 (default): the period of free waves of this length, by dispersion.
    height: Wave height from trough to crest [m], 0..40, and at most Miche's limit, 0.142 length tanh(2 pi depth / length);
        default 1.
    phase_deg: Phase at the centre at time 0 [deg], -360..360; default 0: a crest.
    centre: Middle of the area in world metres, +-1e7; default (0, 0).
    half_length: Half extents of the area along and across the direction of travel [m], 1..1e7; default 1e7: everywhere.
    half_width: Half extents of the area along and across the direction of travel [m], 1..1e7; default 1e7: everywhere.
    edge: Share of each half extent over which the edge falls, 0.01..1; default 0.5.
    depth: Depth for dispersion and Miche's limit [m], 0.1..BOLAN_DEEP; default BOLAN_DEEP.
    """
    _type = "bolan_wave_train_desc"
    from_deg: float
    length: float
    period: float
    height: float
    phase_deg: float
    centre: Tuple[float, ...]
    half_length: float
    half_width: float
    edge: float
    depth: float


class WorldAssets(Struct):
    """What a scene refers to, in memory.

    Fields:
    spectrum: The measured spectrum of scene->spectrum_path; NULL where there is none.
    ground: The ground of scene->terrain; NULL where there is none.
    tiles: The tiles of scene->tiles_path; NULL where there are none.
    model_count: Number of different models, 0..BOLAN_MAX_OBJECTS.
    models: The different models.
    object_models: The model of each object of the scene: one of `models`.
    """
    _type = "bolan_world_assets"
    spectrum: Any
    ground: Any
    tiles: Any
    model_count: int
    models: Tuple[Any, ...]
    object_models: Tuple[Any, ...]


class WorldDesc(Struct):
    """How a world is made.

    Fields:
    scene: The scene; copied. Must be given.
    assets: What the scene refers to: taken over and cleared, also when the creation fails.
        Default NULL: the scene refers to nothing.
    """
    _type = "bolan_world_desc"
    scene: Any
    assets: Any
