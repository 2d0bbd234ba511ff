# SPDX-License-Identifier: MIT
"""Pictures without a window: colour, linear radiance and distance as arrays."""
import threading
import weakref
from typing import NamedTuple, Optional, Tuple

import numpy

from . import _arrays, _structs
from ._library import (ArgumentError, ClosedError, Error, GLError, call, check, documented, ffi, files, lib, path_bytes,
                       text)
from ._struct import enum_name, enum_value, parameters
from .world import World

_left = {}  # what is to be released on a thread, where a renderer of it was collected on another one


class _Resources:
    """Context, renderer and target. They belong to one thread."""

    def __init__(self, api, desc):
        self.context, self.renderer = ffi.new("bolan_context **"), ffi.new("bolan_renderer **")
        self.target, self.size = ffi.new("bolan_target **"), None
        self.thread = threading.get_ident()
        check(lib.bolan_context_create, api, self.context)
        try:
            check(lib.bolan_renderer_create, desc, self.renderer)
        except Error:
            self.release()
            raise

    def release(self):
        """On their thread: now. On another: when their thread makes or uses a renderer the next time."""
        if self.thread != threading.get_ident():
            _left.setdefault(self.thread, []).append(self)
        elif self.context[0] != ffi.NULL:
            lib.bolan_context_make_current(self.context[0])
            lib.bolan_target_destroy(self.target)
            lib.bolan_renderer_destroy(self.renderer)
            lib.bolan_context_destroy(self.context)

    def sized(self, size):
        """The framebuffer of a target of this size."""
        if self.size != size:
            lib.bolan_target_destroy(self.target)
            self.size = None
            check(lib.bolan_target_create, *size, self.target)
            self.size = size
        return lib.bolan_target_framebuffer(self.target[0])


def _release_left():
    for resources in _left.pop(threading.get_ident(), ()):
        resources.release()


@documented("bolan_renderer_create")
class Renderer:
    """Draws worlds by OpenGL without a window, in a context of its own.

    It belongs to the thread that made it, whose current context it takes. quality: "low", "medium", "high", "ultra";
    backend: "auto", "cpu", "compute"; pixels: "auto", "fragment", "compute"; api: "core", "es"."""

    def __init__(self, quality: str = "medium", backend: str = "auto", api: str = "core",
                 pixels: str = "auto"):
        desc = ffi.new("bolan_renderer_desc *", lib.bolan_renderer_desc_default())
        desc.quality = enum_value("bolan_quality", quality, "quality")
        desc.backend = enum_value("bolan_backend", backend, "backend")
        desc.pixels = enum_value("bolan_pixels", pixels, "pixels")
        _release_left()
        self._resources = _Resources(enum_value("bolan_gl_api", api, "api"), desc)
        self._finalizer = weakref.finalize(self, self._resources.release)
        self._drawn: Optional[Tuple[int, int]] = None

    def __enter__(self):
        self._own()
        return self

    def __exit__(self, *_):
        self.close()

    def close(self) -> None:
        """Releases context and renderer. A second close() does nothing."""
        self._resources = None
        self._finalizer()

    @property
    def closed(self) -> bool:
        """Whether close() was called."""
        return self._resources is None

    def _own(self):
        """The resources, with their context current."""
        own = self._resources
        if own is None:
            raise ClosedError("this Renderer is closed")
        if own.thread != threading.get_ident():
            raise GLError("this Renderer belongs to the thread that made it; make another one on this thread")
        _release_left()
        lib.bolan_context_make_current(own.context[0])
        return own

    @property
    def info(self) -> dict:
        """What the driver says of itself."""
        self._own()
        info = call(lib.bolan_gl_get_info)
        return {"renderer": text(info.renderer), "vendor": text(info.vendor), "version": text(info.version),
                "software": info.software, "compute": info.compute, "max_picture": info.max_picture}

    @property
    def backend(self) -> str:
        """What makes the fields: "cpu" or "compute"."""
        return enum_name("bolan_backend", lib.bolan_renderer_backend(self._own().renderer[0]))

    @property
    def pixels(self) -> str:
        """What shades the pixels of water: "fragment" or "compute"."""
        return enum_name("bolan_pixels", lib.bolan_renderer_pixels(self._own().renderer[0]))

    @documented("bolan_renderer_draw_world")
    def draw(self, world: World, size: Tuple[int, int], camera: Optional[_structs.Camera] = None, samples: int = 1,
             out: Optional[numpy.ndarray] = None) -> numpy.ndarray:
        """Draws a world at its present time: (height, width, 3) uint8, sRGB, row 0 at the top.

        size is (width, height). The camera is the scene's, or another. linear() and distance() read the same
        picture."""
        own = self._own()
        width, height = _size(size)
        if not isinstance(world, World):
            raise ArgumentError(f"world is {world!r}; expected a World")
        if not isinstance(samples, int) or not 1 <= samples <= 256:
            raise ArgumentError(f"samples is {samples!r}; expected 1..256")
        if camera is not None and not isinstance(camera, _structs.Camera):
            raise ArgumentError(f"camera is {camera!r}; expected a Camera")
        out = _arrays.written(out, numpy.dtype("u1"), (height, width, 3))
        self._drawn = None
        with world._gate.read():
            pointer = world._get()
            camera = lib.bolan_world_scene(pointer).camera if camera is None else camera._c[0]
            holder = ffi.new("bolan_camera *", camera)
            # The renderer says once what it refuses, and then leaves the picture as it was.
            check(lib.bolan_params_validate, parameters("bolan_camera"), holder, b"camera")
            view = ffi.new("bolan_view *", lib.bolan_view_from_camera(holder, width, height))
            view.framebuffer, view.samples = own.sized((width, height)), samples
            call(lib.bolan_renderer_draw_world, own.renderer[0], pointer, view, error=GLError)
        call(lib.bolan_renderer_read_rgb8, own.renderer[0], view.framebuffer, width, height,
             _arrays.pointer("uint8_t", out, writeable=True), error=GLError)
        self._drawn = (width, height)
        return out

    def _read(self, channels, out, which):
        own = self._own()
        if self._drawn is None:
            raise GLError("there is no picture yet; draw() makes one")
        width, height = self._drawn
        out = _arrays.written(out, numpy.dtype("f4"), (height, width, channels)[:2 if channels == 1 else 3])
        arguments = [ffi.NULL, ffi.NULL]
        arguments[which] = _arrays.pointer("float", out, writeable=True)
        call(lib.bolan_renderer_read_linear, own.renderer[0], *arguments, error=GLError)
        return out

    @documented("bolan_renderer_read_linear")
    def linear(self, out: Optional[numpy.ndarray] = None) -> numpy.ndarray:
        """Linear radiance of the last picture, (height, width, 3) float32, row 0 at the top."""
        return self._read(3, out, 0)

    @documented("bolan_renderer_read_linear")
    def distance(self, out: Optional[numpy.ndarray] = None) -> numpy.ndarray:
        """Distance along the view axis in the last picture [m], (height, width) float32; infinity is the sky."""
        return self._read(1, out, 1)

    @documented("bolan_renderer_read_sky")
    def sky(self, size: Tuple[int, int] = (2048, 1024), eye=(0.0, 0.0, 2.0)) -> Tuple[numpy.ndarray, "SkyLight"]:
        """The sky of the last picture as an equirectangular map of linear radiance, (height, width, 3) float32, row 0
        the zenith and north in the middle, and the light of sun and sky. export_sky() writes both."""
        own = self._own()
        width, height = _size(size)
        if self._drawn is None:
            raise GLError("there is no picture yet; draw() makes one")
        out, light = numpy.empty((height, width, 3), "f4"), ffi.new("bolan_sky_light *")
        check(lib.bolan_renderer_read_sky, own.renderer[0], tuple(float(v) for v in eye), width, height,
              _arrays.pointer("float", out, writeable=True), light)
        return out, SkyLight(*((v.x, v.y, v.z) for v in
                               (light.sun_direction, light.sun_irradiance, light.sky_irradiance)))


class SkyLight(NamedTuple):
    """Unit vector to the sun; irradiance of the sun on a surface that faces it, of the sky on a horizontal one."""
    sun_direction: Tuple[float, float, float]
    sun_irradiance: Tuple[float, float, float]
    sky_irradiance: Tuple[float, float, float]


@documented("bolan_export_sky")
def export_sky(path, rgb: numpy.ndarray, light: SkyLight) -> None:
    """Writes a map of Renderer.sky() as .exr, with the sun in its header."""
    rgb = _arrays.read(rgb, "f4", (None, None, 3), "rgb")
    with files:
        check(lib.bolan_export_sky, path_bytes(path), rgb.shape[1], rgb.shape[0], _arrays.pointer("float", rgb),
              ffi.new("bolan_sky_light *", tuple(light)))


def _size(size):
    try:
        width, height = size
    except (TypeError, ValueError):
        width = height = None
    if not all(isinstance(side, int) and 1 <= side <= 16384 for side in (width, height)):
        raise ArgumentError(f"size is {size!r}; expected (width, height), 1..16384 each")
    return width, height


@documented("bolan_png_write")
def write_png(path, rgb: numpy.ndarray) -> None:
    """Writes (height, width, 3) uint8 as PNG."""
    rgb = _arrays.read(rgb, "u1", (None, None, 3), "rgb")
    with files:
        check(lib.bolan_png_write, path_bytes(path), rgb.shape[1], rgb.shape[0], _arrays.pointer("uint8_t", rgb))


@documented("bolan_exr_write")
def write_exr(path, **channels: numpy.ndarray) -> None:
    """Writes channels, (height, width) float32 each, as EXR: write_exr("x.exr", R=..., Z=...)."""
    if not channels:
        raise ArgumentError("there is no channel; expected 1..64")
    first = next(iter(channels.values()))
    shape = (None, None) if not isinstance(first, numpy.ndarray) or first.ndim != 2 else first.shape
    names = [ffi.new("char[]", name.encode()) for name in channels]
    planes = [_arrays.pointer("float", _arrays.read(plane, "f4", shape, name)) for name, plane in channels.items()]
    array = ffi.new("bolan_exr_channel[]", list(zip(names, planes)))
    with files:
        check(lib.bolan_exr_write, path_bytes(path), shape[1], shape[0], array, len(planes))
