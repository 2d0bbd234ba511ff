# SPDX-License-Identifier: MIT
"""The examples run and say what is so; the README's lines too; a batch is as fast as C."""
import pathlib
import re
import subprocess
import sys
import time

import numpy
import pytest

import bolan
from bolan._library import ffi, lib
from conftest import SOURCE

EXAMPLES = pathlib.Path(SOURCE, "bindings/python/examples")


def run(tmp_path, *command):
    ran = subprocess.run([sys.executable, *map(str, command)], cwd=tmp_path, capture_output=True, text=True)
    assert ran.returncode == 0, ran.stderr
    return ran.stdout


def test_every_example_is_tested():
    assert sorted(p.name for p in EXAMPLES.glob("*.py")) == ["buoy.py", "dataset.py", "floating_body.py", "heights.py"]


def test_buoy(tmp_path):
    pytest.importorskip("matplotlib", reason="python3-matplotlib is not installed")
    said = run(tmp_path, EXAMPLES / "buoy.py")
    third, hm0, tz = map(float, re.findall(r"([\d.]+) (?:m|s)\b", said))
    expected = bolan.SeaState.from_wind(12.0, 225.0, 300e3).add_swell(1.5, 14.0, 300.0).summary()
    assert hm0 == pytest.approx(expected.hs, rel=0.15) and 0.85 < third / hm0 < 1.02
    assert tz == pytest.approx(expected.tm02, rel=0.25)
    assert (tmp_path / "buoy.png").stat().st_size > 5000


def test_heights(tmp_path):
    said = run(tmp_path, EXAMPLES / "heights.py")
    hs = float(re.search(r"Hs ([\d.]+) m", said)[1])
    assert hs == pytest.approx(bolan.SeaState.from_beaufort(6, 225.0).summary().hs, rel=0.05)


def test_dataset(tmp_path, renderer):
    run(tmp_path, EXAMPLES / "dataset.py")
    winds = set()
    for i in range(3):
        part = numpy.load(tmp_path / f"sea_{i:03}.npz")
        assert part["rgb"].shape == part["linear"].shape == (180, 320, 3)
        assert (part["water"] == numpy.isfinite(part["distance"])).all() and 0.5 < part["water"].mean() < 1.0
        winds.add(float(part["wind"]))
    assert len(winds) == 3


def test_floating_body(tmp_path):
    said = run(tmp_path, EXAMPLES / "floating_body.py")
    x, over = map(float, re.findall(r"([+-][\d.]+) m", said))
    assert abs(x) < 5.0 and abs(over) < 0.7


def test_readme_lines_run(tmp_path):
    code = re.search(r"^```python\n(.*?)^```", pathlib.Path(SOURCE, "README.md").read_text(), re.M | re.S)[1]
    (tmp_path / "readme.py").write_text(code)
    assert len(re.findall(r"-?\d\.\d+", run(tmp_path, "readme.py"))) >= 2


def test_manual_blocks_run(tmp_path):
    blocks = re.findall(r"^```python\n(.*?)^```", pathlib.Path(SOURCE, "docs/python.md").read_text(), re.M | re.S)
    assert len(blocks) >= 4
    (tmp_path / "manual.py").write_text("\n".join(blocks))
    run(tmp_path, "manual.py")


def test_a_batch_is_as_fast_as_c():
    # The function of the library called straight, against the package: processor time, the best of 7 by turns.
    xy = numpy.random.default_rng(1).uniform(-5000.0, 5000.0, (100000, 2))
    heights = numpy.empty(len(xy), "f4")
    with bolan.Sea(resolution=64) as sea:
        water = ffi.new("bolan_water *", lib.bolan_water_default())
        water.sea = sea._get()
        points, out = ffi.cast("bolan_dvec2 *", xy.ctypes.data), ffi.cast("float *", heights.ctypes.data)

        def cost(call):
            began = time.thread_time()
            call()
            return time.thread_time() - began
        sea.heights(xy)
        turns = [(cost(lambda: lib.bolan_query_heights(water, points, len(xy), out)),
                  cost(lambda: sea.heights(xy, out=heights)))
                 for _ in range(7)]
    straight, package = map(min, zip(*turns))
    assert straight / package >= 0.9
