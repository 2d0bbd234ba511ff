# SPDX-License-Identifier: MIT
"""Bolan: water. Simulate a sea, ask where its surface is, draw it.

    import bolan
    sea = bolan.Sea(bolan.SeaState.from_wind(12.0, 225.0, 300e3))
    sea.step(2.5)
    print(sea.heights([[0.0, 0.0], [40.0, -15.0]]))

Metres, seconds, x east, y north, z up; winds and waves are named by the compass direction they come from [deg].
The package calls the shared library libbolan_all; docs/python.md is its manual.
"""
from . import record
from ._arrays import Field
from ._library import (ArgumentError, BolanWarning, ClosedError, Error, FileError, FormatError, GLError, MisuseError,
                       OutOfMemoryError, StaleError, UnsupportedError, memory_in_use, set_threads, threads, version)
from ._structs import Partition, SpectrumOptions, WaveSystem, WaveTrainDesc
from .render import Renderer, SkyLight, export_sky, write_exr, write_png
from .sea import Cascade, Sea, SeaDesc, Water, WaveLayer
from .spectra import Contents, MeasuredSpectrum, SeaState, contents
from .world import Camera, Pose, Scene, World, scene_names

__version__ = "0.2.0"
__all__ = [name for name in dir() if not name.startswith("_") and name not in ("render", "sea", "spectra", "world")]
