# SPDX-License-Identifier: MIT
"""Exports: what is written is what a query answers, read by other means than those that wrote it."""
import struct

import numpy
import pytest

import bolan


def read_ply(path):
    """Vertices of a binary PLY as a record array."""
    head, body = path.read_bytes().split(b"end_header\n", 1)
    lines = head.decode().split("\n")
    count = next(int(line.split()[2]) for line in lines if line.startswith("element vertex"))
    names = [line.split()[-1] for line in lines if line.startswith("property float")]
    return numpy.frombuffer(body, [(name, "<f4") for name in names], count)


def test_a_mesh_is_the_queried_surface(tmp_path):
    with bolan.World("open-sea") as world:
        world.export_mesh(tmp_path / "sea.ply", rectangle=(-20.0, -10.0, 20.0, 30.0), spacing=1.0)
        got = read_ply(tmp_path / "sea.ply")
        assert len(got) == 41 * 41
        asked = world.heights(numpy.stack([got["x"], got["y"]], axis=1).astype("f8"))
        assert numpy.abs(got["z"] - asked).max() < 1e-3  # a fold in the water: parcels hold their own place
        assert got["z"].std() > 0.1
        assert abs(got["y"].mean() - 10.0) < 1.0  # not turned, not mirrored


def test_fields_have_a_time(tmp_path):
    with bolan.World("open-sea") as world:
        began = world.time
        world.export_fields(tmp_path / "sea.nc", rectangle=(0.0, 0.0, 8.0, 4.0), spacing=1.0, frames=2, fps=4.0)
        data = (tmp_path / "sea.nc").read_bytes()
        assert data[:4] == b"CDF\x02"
        assert struct.unpack(">I", data[4:8])[0] == 2  # records
        assert world.time == pytest.approx(began + 0.25)


def test_the_sky_has_its_sun(tmp_path):
    with bolan.World("open-sea") as world, bolan.Renderer("low") as renderer:
        with pytest.raises(bolan.GLError):
            renderer.sky((64, 32))
        renderer.draw(world, (64, 36))
        rgb, light = renderer.sky((64, 32))
        assert rgb.shape == (32, 64, 3) and (rgb > 0.0).all()
        assert numpy.linalg.norm(light.sun_direction) == pytest.approx(1.0, abs=1e-5)
        bright = numpy.unravel_index(rgb[:16].sum(axis=2).argmax(), (16, 64))  # about the sun, azimuth 205
        assert abs(360.0 * ((bright[1] + 0.5) / 64 - 0.5) % 360.0 - 205.0) < 40.0
        bolan.export_sky(tmp_path / "sky.exr", rgb, light)
        assert (tmp_path / "sky.exr").read_bytes()[:4] == b"\x76\x2f\x31\x01"


def test_what_cannot_be_written_is_refused(tmp_path):
    with bolan.World("open-sea") as world:
        with pytest.raises(bolan.ArgumentError):
            world.export_mesh(tmp_path / "sea.stl")
        with pytest.raises(bolan.ArgumentError):
            world.export_mesh(tmp_path / "sea.ply", rectangle=(0.0, 0.0, 1.0))
        with pytest.raises(bolan.ArgumentError):
            world.export_mesh(tmp_path / "sea.ply", ground=True)  # there is none
        assert not list(tmp_path.iterdir())
