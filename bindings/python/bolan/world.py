# SPDX-License-Identifier: MIT
"""Scenes, and worlds made of them: a scene with all that it refers to, and its water."""
from contextlib import contextmanager
from typing import NamedTuple, Optional, Sequence, Tuple

from . import _structs
from ._library import ArgumentError, Closable, Gate, Pointer, call, check, documented, ffi, files, lib, path_bytes, text
from .sea import FlowOf, Questions, Sea, finite


class Camera(_structs.Camera):
    __doc__ = _structs.Camera.__doc__


class Scene(_structs.Scene):
    __doc__ = _structs.Scene.__doc__

    @classmethod
    @documented("bolan_scene_load")
    def load(cls, name_or_path) -> "Scene":
        """Reads a built-in scene by name, or a YAML file."""
        scene = cls()
        with files:
            check(lib.bolan_scene_load, path_bytes(name_or_path), scene._c)
        return scene

    @classmethod
    @documented("bolan_scene_parse")
    def parse(cls, yaml: str, name: str = "scene") -> "Scene":
        """Reads a scene from YAML text. name is used in messages."""
        scene, data = cls(), yaml.encode() if isinstance(yaml, str) else bytes(yaml)
        with files:
            check(lib.bolan_scene_parse, path_bytes(name), data, len(data), scene._c)
        return scene

    @documented("bolan_scene_set_wind")
    def set_wind(self, wind_speed: float, from_deg: float) -> "Scene":
        """Gives the scene another wind, and returns it."""
        call(lib.bolan_scene_set_wind, self._c, finite(wind_speed, "wind_speed"), finite(from_deg, "from_deg"))
        return self

    @documented("bolan_scene_set_technique")
    def set_technique(self, name: str) -> "Scene":
        """Gives the scene the technique of that name, and returns it."""
        technique = lib.bolan_technique_find(str(name).encode())
        if technique == ffi.NULL:
            names = [text(n) for n in lib.bolan_technique_names if n != ffi.NULL]
            raise ArgumentError(f"technique is {name!r}; expected one of {', '.join(names)}")
        call(lib.bolan_scene_set_technique, self._c, technique)
        return self

    @documented("bolan_scene_camera_at")
    def camera_at(self, time: float) -> Camera:
        """The camera at a time of its path [s]."""
        return Camera._of(call(lib.bolan_scene_camera_at, self._c, finite(time, "time")))

    @documented("bolan_scene_validate")
    def validate(self) -> None:
        """Raises ArgumentError at the first field out of its range."""
        check(lib.bolan_scene_validate, self._c)


def scene_names() -> Tuple[str, ...]:
    """Names of the built-in scenes."""
    names, index = [], 0
    while True:
        name = lib.bolan_scene_builtin_name(index)
        if name == ffi.NULL:
            return tuple(names)
        names.append(text(name))
        index += 1


class Pose(NamedTuple):
    """Place of an object [m], and its unit axes (right, ahead, up) in the world."""
    origin: Tuple[float, float, float]
    x: Tuple[float, float, float]
    y: Tuple[float, float, float]
    z: Tuple[float, float, float]


def _whole(value, name):
    if not isinstance(value, int) or not 0 <= value < 1 << 32:
        raise ArgumentError(f"{name} is {value!r}; expected whole numbers")
    return value


def _fill_grid(grid, rectangle, spacing):
    if len(rectangle) != 4:
        raise ArgumentError(f"rectangle is {rectangle!r}; expected (west, south, east, north)")
    west, south, east, north = (finite(v, "rectangle") for v in rectangle)
    grid.__setattr__("from", (west, south))
    grid.to, grid.spacing = (east, north), finite(spacing, "spacing")


class World(Closable, Questions):
    """A scene with all that it refers to, and its water at the scene's time.

    World("island") loads a built-in scene or a file, World(scene) what a Scene refers to. Threads of Python may share
    a world: questions run beside each other, and a step waits for them."""

    def __init__(self, scene):
        with files:
            if isinstance(scene, _structs.Scene):
                self._pointer = Pointer("bolan_world", lib.bolan_world_load_scene, scene._c)
            else:
                self._pointer = Pointer("bolan_world", lib.bolan_world_load, path_bytes(scene))
        self._gate = Gate()
        self._flow = FlowOf()

    @contextmanager
    def _asked(self, moving):
        with (self._gate.write() if moving else self._gate.read()):
            world = self._get()  # held to the end of the question
            water = ffi.new("bolan_water *", lib.bolan_world_water(world)[0])
            if moving:
                water.flow = self._flow.now(water.sea)
            yield water

    @documented("bolan_world_step")
    def step(self, time: float) -> None:
        """Steps the sea to a time [s]. The camera stays: set_camera(camera_at(time)) moves it on its path."""
        time = finite(time, "time")
        with self._gate.write():
            call(lib.bolan_world_step, self._get(), time)

    @documented("bolan_world_settle")
    def settle(self, time: float) -> None:
        """Like step(), with the foam of a sea that has run."""
        time = finite(time, "time")
        with self._gate.write():
            call(lib.bolan_world_settle, self._get(), time)

    @property
    def time(self) -> float:
        """The present time [s]."""
        with self._gate.read():
            world = self._get()
            return lib.bolan_sea_time(lib.bolan_world_water(world).sea)

    @property
    def scene(self) -> Scene:
        """A copy of the scene at the present time."""
        with self._gate.read():
            world = self._get()
            return Scene._of(lib.bolan_world_scene(world)[0])

    @documented("bolan_world_set_scene")
    def set_scene(self, scene: Scene) -> None:
        """Replaces the scene by one that refers to the same things."""
        if not isinstance(scene, _structs.Scene):
            raise ArgumentError(f"scene is {scene!r}; expected a Scene")
        with self._gate.write():
            check(lib.bolan_world_set_scene, self._get(), scene._c)

    @documented("bolan_world_set_camera")
    def set_camera(self, camera: _structs.Camera) -> None:
        """Replaces the scene's camera."""
        if not isinstance(camera, _structs.Camera):
            raise ArgumentError(f"camera is {camera!r}; expected a Camera")
        with self._gate.write():
            call(lib.bolan_world_set_camera, self._get(), camera._c)

    @documented("bolan_world_camera_at")
    def camera_at(self, time: float) -> Camera:
        """The scene's camera at a time of its path [s], out of the ground."""
        with self._gate.read():
            return Camera._of(call(lib.bolan_world_camera_at, self._get(), finite(time, "time")))

    @documented("bolan_sea_fork")
    def fork_sea(self) -> Sea:
        """The waves of the world as a Sea of its own, at time 0."""
        with self._gate.read():
            world = self._get()
            return Sea.__new__(Sea)._begin(Pointer("bolan_sea", lib.bolan_sea_fork, lib.bolan_world_water(world).sea))

    @documented("bolan_export_mesh")
    def export_mesh(self, path, rectangle: Optional[Sequence[float]] = None, spacing: float = 0.5,
                    size: Tuple[int, int] = (1280, 720), ground: bool = False,
                    origin: Sequence[float] = (0.0, 0.0, 0.0), frames: int = 1, fps: float = 30.0) -> None:
        """Writes the water as a mesh, .ply, .obj or .glb.

        The vertices are those of the camera's grid for a picture of that size, or of a rectangle (west, south, east,
        north) [m] at a spacing [m]. Several frames are an animation, and the world is left at the last."""
        desc = ffi.new("bolan_export_mesh_desc *", lib.bolan_export_mesh_desc_default())
        if rectangle is not None:
            desc.vertices = lib.BOLAN_EXPORT_RECTANGLE
            _fill_grid(desc.grid, rectangle, spacing)
        desc.width, desc.height = _whole(size[0], "size"), _whole(size[1], "size")
        desc.ground = bool(ground)
        desc.origin.x, desc.origin.y, desc.origin.z = (finite(v, "origin") for v in origin)
        self._export(lib.bolan_export_mesh, desc, path, frames, fps)

    @documented("bolan_export_fields")
    def export_fields(self, path, rectangle: Optional[Sequence[float]] = None, spacing: float = 0.5,
                      half: bool = False, frames: int = 1, fps: float = 30.0) -> None:
        """Writes the fields of every cascade, or the surface over a rectangle (west, south, east, north) [m] at a
        spacing [m], as .exr or .nc. Several frames are the time dimension of .nc."""
        desc = ffi.new("bolan_export_fields_desc *", lib.bolan_export_fields_desc_default())
        if rectangle is not None:
            desc.resampled = True
            _fill_grid(desc.grid, rectangle, spacing)
        desc.half = bool(half)
        self._export(lib.bolan_export_fields, desc, path, frames, fps)

    def _export(self, function, desc, path, frames, fps):
        desc.frames.count, desc.frames.fps = _whole(frames, "frames"), finite(fps, "fps")
        with self._gate.write(), files:
            check(function, self._get(), desc, path_bytes(path))

    @documented("bolan_world_object_pose")
    def object_pose(self, index: int) -> Pose:
        """The pose of an object of the scene at the present time."""
        with self._gate.read():
            world = self._get()
            count = lib.bolan_world_scene(world).object_count
            if not isinstance(index, int) or not 0 <= index < count:
                raise ArgumentError(f"object is {index!r}; the scene has {count}")
            pose = call(lib.bolan_world_object_pose, world, index)
        return Pose(*((v.x, v.y, v.z) for v in (pose.origin, pose.x, pose.y, pose.z)))
