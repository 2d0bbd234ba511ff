# SPDX-License-Identifier: MIT
"""The sea and questions about its surface and the water below it."""
import math
from contextlib import contextmanager
from typing import NamedTuple, Optional, Sequence, Tuple

import numpy

from . import _arrays, _structs
from ._library import ArgumentError, Closable, Gate, Pointer, call, documented, ffi, lib, text
from ._struct import enum_name, enum_value
from .spectra import SeaState


def finite(value, what):
    """A finite number, or ArgumentError."""
    try:
        value = float(value)
    except (TypeError, ValueError):
        value = math.nan
    if not math.isfinite(value):
        raise ArgumentError(f"{what} is not a finite number")
    return value


class Questions:
    """Questions at world points. Sea, Water and World have them.

    Arrays of points are float64, contiguous, and read where they lie; lists are converted. out= takes an array that
    is filled in place of a new one."""

    @contextmanager
    def _asked(self, moving):
        """Gives the bolan_water, with the flow where the question is about moving water."""
        raise NotImplementedError

    def _ask(self, function, kind, columns, points, out, dtype, question=(), moving=False):
        what = "xy" if columns == 2 else "xyz"
        points = _arrays.read(points, "f8", (None, columns), what)
        out = _arrays.written(out, dtype, (len(points),))
        with self._asked(moving) as water:
            call(function, water, *question, _arrays.pointer(f"bolan_dvec{columns}", points), len(points),
                 _arrays.pointer(kind, out, writeable=True))
        return out

    @documented("bolan_query_heights")
    def heights(self, xy, out: Optional[numpy.ndarray] = None) -> numpy.ndarray:
        """Heights of the surface at xy, (n, 2) float64 [m]: (n,) float32 [m]."""
        return self._ask(lib.bolan_query_heights, "float", 2, xy, out, numpy.dtype("f4"))

    @documented("bolan_query_surface")
    def surface(self, xy, out: Optional[numpy.ndarray] = None) -> numpy.ndarray:
        """The surface at xy, (n, 2) float64 [m]: a record array with height, normal, jacobian and residual."""
        kind = "bolan_query_point"
        return self._ask(lib.bolan_query_surface, kind, 2, xy, out, _arrays.dtype_of(kind))

    @documented("bolan_query_below")
    def below(self, xyz, least_wavelength: float = 0.0, stretching: str = "none",
              out: Optional[numpy.ndarray] = None) -> numpy.ndarray:
        """The water at xyz, (n, 3) float64 [m]: a record array with velocity, acceleration, pressure and wet."""
        kind = "bolan_kinematics"
        return self._ask(lib.bolan_query_below, kind, 3, xyz, out, _arrays.dtype_of(kind),
                         (_question(least_wavelength, stretching),), moving=True)

    @documented("bolan_query_levels")
    def levels(self, xy, z, least_wavelength: float = 0.0, stretching: str = "none",
               out: Optional[numpy.ndarray] = None) -> numpy.ndarray:
        """The water at every height z [m] under every place xy, (n, 2) float64: like below(), of shape (levels, n)."""
        xy, z = _arrays.read(xy, "f8", (None, 2), "xy"), _arrays.read(z, "f8", (None,), "z")
        out = _arrays.written(out, _arrays.dtype_of("bolan_kinematics"), (len(z), len(xy)))
        question = _question(least_wavelength, stretching)
        with self._asked(True) as water:
            call(lib.bolan_query_levels, water, question, _arrays.pointer("bolan_dvec2", xy), len(xy),
                 _arrays.pointer("double", z), len(z), _arrays.pointer("bolan_kinematics", out, writeable=True))
        return out

    @documented("bolan_query_motion")
    def motion(self, xy, least_wavelength: float = 0.0, stretching: str = "none",
               out: Optional[numpy.ndarray] = None) -> numpy.ndarray:
        """The surface and its motion at xy: a record array with height, rise, normal, velocity and acceleration."""
        kind = "bolan_surface_motion"
        return self._ask(lib.bolan_query_motion, kind, 2, xy, out, _arrays.dtype_of(kind),
                         (_question(least_wavelength, stretching),), moving=True)

    @documented("bolan_query_rays")
    def rays(self, origins, directions, length: float, least_wavelength: float = 0.0,
             out: Optional[numpy.ndarray] = None) -> numpy.ndarray:
        """Where rays meet the surface; origins and directions (n, 3) float64: hit, distance and point."""
        origins = _arrays.read(origins, "f8", (None, 3), "origins")
        directions = _arrays.read(directions, "f8", (len(origins), 3), "directions")
        rays = numpy.empty(len(origins), _arrays.dtype_of("bolan_ray"))
        rays["origin"], rays["direction"], rays["length"] = origins, directions, finite(length, "length")
        out = _arrays.written(out, _arrays.dtype_of("bolan_ray_hit"), (len(origins),))
        question = _question(least_wavelength, "none")
        with self._asked(question.least_wavelength > 0) as water:
            call(lib.bolan_query_rays, water, question, _arrays.pointer("bolan_ray", rays), len(rays),
                 _arrays.pointer("bolan_ray_hit", out, writeable=True))
        return out

    @documented("bolan_query_crests")
    def crests(self, start, end, step: float, least_wavelength: float = 0.0) -> numpy.ndarray:
        """The crests along a line from start to end, (x, y) each [m]: a record array with distance and height."""
        ends = _arrays.read([start, end], "f8", (2, 2), "start and end")
        step, span = finite(step, "step"), float(numpy.hypot(*(ends[1] - ends[0])))
        if not (1e-3 <= step <= 1e4 and numpy.isfinite(span) and span / step <= 1e7):
            raise ArgumentError(f"step is {step} m over a line of {span} m; expected 0.001..1e4, and at most 1e7 steps")
        question = _question(least_wavelength, "none")
        first, last = (ffi.new("bolan_dvec2 *", tuple(end))[0] for end in ends.tolist())
        with self._asked(question.least_wavelength > 0) as water:
            # No more maxima than every second step.
            out = numpy.empty(int(span / step) // 2 + 2, _arrays.dtype_of("bolan_crest"))
            count = call(lib.bolan_query_crests, water, question, first, last, step, len(out),
                         _arrays.pointer("bolan_crest", out, writeable=True))
        return out[:min(count, len(out))]


def _question(least_wavelength, stretching):
    length = finite(least_wavelength, "least_wavelength")
    if not 0 <= length <= 1e5:
        raise ArgumentError(f"least_wavelength is {length}; expected 0..1e5 m")
    return ffi.new("bolan_question *", (length, enum_value("bolan_stretching", stretching, "stretching")))


class FlowOf:
    """The flow of a sea, made at the first question about moving water."""

    def __init__(self):
        self._flow = None

    def now(self, sea):
        """The bolan_flow at the time of the sea. The caller holds the sea alone."""
        if self._flow is None or lib.bolan_flow_sea_id(self._flow.raw) != lib.bolan_sea_id(sea):
            self._flow = Pointer("bolan_flow", lib.bolan_flow_create, sea)
        else:
            call(lib.bolan_flow_step, self._flow.raw, sea)
        return self._flow.raw


class SeaDesc(_structs.SeaDesc):
    __doc__ = _structs.SeaDesc.__doc__


class Cascade:
    """One cascade of a sea at its present time: numbers, and fields as read-only arrays of shape (n, n).

    The fields are views of the library's memory. A step of the sea ends them: see Field."""

    _TEXELS = ("dx", "dy", "height", "dxy")  # fields of bolan_sea_texel, in its order
    _PLANES = ("slope_x", "slope_y", "dxx", "dyy", "foam")
    _NUMBERS = ("n", "length", "angle", "k_min", "k_max", "variance", "mss", "origin_x", "origin_y")
    n: int
    length: float
    angle: float
    k_min: float
    k_max: float
    variance: float
    mss: float
    origin_x: float
    origin_y: float
    height: numpy.ndarray
    dx: numpy.ndarray
    dy: numpy.ndarray
    slope_x: numpy.ndarray
    slope_y: numpy.ndarray
    dxx: numpy.ndarray
    dyy: numpy.ndarray
    dxy: numpy.ndarray
    foam: numpy.ndarray

    def __init__(self, sea, view):
        serial = lib.bolan_sea_serial(sea._get())
        for name in self._NUMBERS:
            setattr(self, name, getattr(view, name))
        for i, name in enumerate(self._TEXELS):
            texels = ffi.cast("float *", view.displacement)
            part = (slice(None), slice(view.n), i)
            setattr(self, name, _arrays.field(texels, (view.n, view.pitch, 4), "f4", sea, serial, part))
        for name in self._PLANES:
            setattr(self, name, _arrays.field(getattr(view, name), (view.n, view.n), "f4", sea, serial))


Cascade.__doc__ += "\n\n" + (_structs.CascadeView.__doc__ or "")


class Component(NamedTuple):
    """One wave of a sum: wave vector [rad/m], frequency [rad/s], phase [rad], amplitude and drift [m]."""
    kx: float
    ky: float
    omega: float
    phase: float
    amplitude: float
    drift: float


@documented("bolan_sea_create")
class Sea(Closable, Questions):
    """A sea, at time 0. Keywords set fields of SeaDesc: Sea(state, seed=3, resolution=128).

    Threads of Python may share a sea: questions run beside each other, and a step waits for them. A thread that needs
    another time takes a fork()."""

    def __init__(self, sea_state: Optional[SeaState] = None, desc: Optional[_structs.SeaDesc] = None, **fields):
        desc = SeaDesc() if desc is None else desc.copy()
        if sea_state is not None:
            desc.sea_state = sea_state
        desc.update(**fields)
        self._begin(Pointer("bolan_sea", lib.bolan_sea_create, desc._c))

    def _begin(self, pointer):
        self._pointer = pointer
        self._gate = Gate()
        self._flow = FlowOf()
        return self

    @documented("bolan_sea_fork")
    def fork(self) -> "Sea":
        """The same waves at a time of their own; shares the spectrum and all tables."""
        return Sea.__new__(Sea)._begin(Pointer("bolan_sea", lib.bolan_sea_fork, self._get()))

    def close(self) -> None:
        """Lets the sea go. Arrays over its fields raise ClosedError from now on."""
        super().close()

    @contextmanager
    def _asked(self, moving):
        with (self._gate.write() if moving else self._gate.read()):
            sea = self._get()  # held to the end of the question
            water = ffi.new("bolan_water *", lib.bolan_water_default())
            water.sea = sea
            if moving:
                water.flow = self._flow.now(sea)
            yield water

    @documented("bolan_sea_step")
    def step(self, time: float) -> None:
        """Moves the sea to a time [s], in any order. Arrays over its fields are stale from now on."""
        time = finite(time, "time")
        with self._gate.write():
            call(lib.bolan_sea_step, self._get(), time)

    @documented("bolan_sea_settle")
    def settle(self, time: float) -> None:
        """Like step(), with the foam of a sea that has run."""
        time = finite(time, "time")
        with self._gate.write():
            call(lib.bolan_sea_settle, self._get(), time)

    @property
    def time(self) -> float:
        """Time of the last step [s]."""
        return lib.bolan_sea_time(self._get())

    @property
    def id(self) -> int:
        """Number of the sea; forks share it."""
        return lib.bolan_sea_id(self._get())

    @property
    def serial(self) -> int:
        """Number of the present fields; equal numbers mean equal fields."""
        return lib.bolan_sea_serial(self._get())

    @property
    def form(self) -> str:
        """What the fields are made of: "cascades", "cosines" or "exp-cosines"."""
        return enum_name("bolan_wave_form", lib.bolan_sea_form(self._get()))

    @property
    def desc(self) -> SeaDesc:
        """A copy of the desc that the sea was made from, defaults resolved."""
        return SeaDesc._of(lib.bolan_sea_get_desc(self._get())[0])

    @property
    def summary(self) -> _structs.SeaSummary:
        """Height, periods, direction and spread of the sea state, as far as the water can carry it."""
        return _structs.SeaSummary._of(lib.bolan_sea_get_summary(self._get())[0])

    @property
    def record_time(self) -> str:
        """When the measured spectrum was taken, ISO 8601; "" where that is not known."""
        return text(lib.bolan_sea_record_time(self._get()))

    @property
    def bounds(self) -> Tuple[float, float]:
        """Vertical and horizontal bounds that the surface does not leave [m]."""
        out = ffi.new("double[2]")
        lib.bolan_sea_bounds(self._get(), out, out + 1)
        return out[0], out[1]

    @property
    def cascade_count(self) -> int:
        """How many cascades the sea has; 0 of a sum of waves."""
        return lib.bolan_sea_cascade_count(self._get())

    @documented("bolan_sea_cascade")
    def cascade(self, index: int) -> Cascade:
        """The fields of a cascade at the present time; 0 is the one of the longest waves."""
        with self._gate.read():
            sea, count = self._get(), self.cascade_count
            if not isinstance(index, int) or not 0 <= index < count:
                raise ArgumentError(f"cascade is {index!r}; expected 0..{count - 1}" if count else
                                    "a sum of waves has no cascades")
            return Cascade(self, call(lib.bolan_sea_cascade, sea, index))

    def components(self) -> Sequence[Component]:
        """The waves of a sum, the longest first; empty of a sea of cascades."""
        sea = self._get()
        waves = (lib.bolan_sea_get_component(sea, i) for i in range(lib.bolan_sea_component_count(sea)))
        return tuple(Component(w.kx, w.ky, w.omega, w.phase, w.amplitude, w.drift) for w in waves)

    @documented("bolan_sea_sample_rest")
    def sample(self, points, spacing=None, out: Optional[numpy.ndarray] = None) -> numpy.ndarray:
        """The sea at points at rest, (n, 2) float64 [m]: a record array with height, dx, dy, slopes, jacobian and foam.

        With spacing, (n,) float32 [m], it is low-passed for a grid: bolan_sea_sample_grid()."""
        kind = "bolan_sea_sample"
        points = _arrays.read(points, "f8", (None, 2), "points")
        if not numpy.isfinite(points).all():
            raise ArgumentError("points holds a number that is not finite")
        out = _arrays.written(out, _arrays.dtype_of(kind), (len(points),))
        where, answers = _arrays.pointer("bolan_dvec2", points), _arrays.pointer(kind, out, writeable=True)
        with self._gate.read():
            if spacing is None:
                call(lib.bolan_sea_sample_rest, self._get(), where, len(points), answers)
            else:
                spacing = _arrays.read(spacing, "f4", (len(points),), "spacing")
                if not (spacing >= 0).all():
                    raise ArgumentError("spacing holds a number below 0 or none")
                call(lib.bolan_sea_sample_grid, self._get(), where, _arrays.pointer("float", spacing), len(points),
                     answers)
        return out

    @documented("bolan_sea_measure")
    def measure(self) -> _structs.SeaStatistics:
        """Statistics of the surface at the present time."""
        with self._gate.read():
            return _structs.SeaStatistics._of(call(lib.bolan_sea_measure, self._get()))

    @documented("bolan_sea_hash")
    def hash(self) -> str:
        """Digest of every field at the present time, 16 hexadecimal digits."""
        out = ffi.new("char[17]")
        with self._gate.read():
            call(lib.bolan_sea_hash, self._get(), out)
        return text(out)


class WaveLayer(Closable):
    """A wave train that is added to a sea. Keywords set fields of WaveTrainDesc."""

    def __init__(self, desc: Optional[_structs.WaveTrainDesc] = None, **fields):
        desc = _structs.WaveTrainDesc() if desc is None else desc.copy()
        desc.update(**fields)
        self._pointer = Pointer("bolan_wave_layer", lib.bolan_wave_layer_create_train, desc._c)


class Water(Questions):
    """A sea with a level, and wave trains that are added to it. It borrows the sea's time."""

    def __init__(self, sea: Sea, level: float = 0.0, layers: Sequence[WaveLayer] = ()):
        layers = tuple(layers)
        if not isinstance(sea, Sea) or not all(isinstance(layer, WaveLayer) for layer in layers):
            raise ArgumentError("Water takes a Sea, and layers that are WaveLayer")
        if len(layers) > 8:
            raise ArgumentError(f"there are {len(layers)} layers; expected at most 8")
        self.sea, self.level, self.layers = sea, finite(level, "level"), layers

    @contextmanager
    def _asked(self, moving):
        with self.sea._asked(moving) as water:
            held = [layer._get() for layer in self.layers]  # to the end of the question
            layers = ffi.new("bolan_wave_layer *[]", held)
            water.level = finite(self.level, "level")
            water.layers, water.layer_count = layers, len(held)
            yield water
