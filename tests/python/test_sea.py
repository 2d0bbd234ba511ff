# SPDX-License-Identifier: MIT
"""Seas: time, forks, fields, questions against linear theory, and the bits of the program."""
import gc
import math
import os
import subprocess

import numpy
import pytest

import bolan
from bolan import record

G = 9.81


def train(**fields):
    """Waves 2 m high and 100 m long that come from the west; a crest stands at x = 0 at time 0."""
    return bolan.WaveLayer(**{"from_deg": 270.0, "length": 100.0, "height": 2.0, **fields})


def test_time_and_direction_of_a_wave_train(calm):
    water, k = bolan.Water(calm, level=0.5, layers=[train()]), 2 * math.pi / 100.0
    x = numpy.linspace(-80.0, 80.0, 33)
    xy = numpy.column_stack([x, numpy.full(33, 7.0)])
    for time in (0.0, 1.3):
        calm.step(time)
        expected = 0.5 + numpy.cos(k * x - math.sqrt(G * k) * time)
        assert abs(water.heights(xy) - expected).max() < 2e-3
    surface = water.surface(xy)
    slope = -surface["normal"][:, 0] / surface["normal"][:, 2]
    assert abs(slope + k * numpy.sin(k * x - math.sqrt(G * k) * 1.3)).max() < 1e-3


def test_water_moves_as_airy_has_it(calm):
    k, water = 2 * math.pi / 100.0, bolan.Water(calm, layers=[train()])
    omega, decay = math.sqrt(G * k), math.exp(-k * 10.0)
    under = water.below([[0.0, 0.0, -10.0], [25.0, 0.0, -10.0], [0.0, 0.0, 30.0]])
    assert under["wet"].tolist() == [True, True, False]
    assert under["velocity"][0] == pytest.approx([omega * decay, 0.0, 0.0], abs=2e-3)  # forward under a crest
    assert under["velocity"][1] == pytest.approx([0.0, 0.0, omega * decay], abs=2e-3)  # up before it
    assert under["acceleration"][0] == pytest.approx([0.0, 0.0, -omega**2 * decay], abs=2e-3)
    assert under["pressure"][0] == pytest.approx(1026.0 * G * decay, rel=2e-3)
    motion = water.motion([[25.0, 0.0]])
    assert motion["rise"][0] == pytest.approx(omega, rel=2e-2)


def test_rays_and_crests_of_a_train(calm):
    water = bolan.Water(calm, layers=[train()])
    hit = water.rays([[0.0, 0.0, 21.0], [0.0, 0.0, 21.0]], [[0.0, 0.0, -3.0], [0.0, 0.0, 1.0]], 100.0)
    assert hit["hit"].tolist() == [True, False]
    assert hit["distance"][0] == pytest.approx(20.0, abs=2e-3) and hit["point"][0][2] == pytest.approx(1.0, abs=2e-3)
    assert not water.rays([[0.0, 0.0, 21.0]], [[0.0, 0.0, -3.0]], 19.0)["hit"][0]
    crests = water.crests((-150.0, 0.0), (250.0, 0.0), 1.0)
    assert crests["distance"] == pytest.approx([50.0, 150.0, 250.0, 350.0], abs=0.01)
    assert crests["height"] == pytest.approx(1.0, abs=1e-3)


def test_heights_have_the_variance_of_the_spectrum(sea):
    xy = numpy.random.default_rng(1).uniform(-2e4, 2e4, (40000, 2))
    assert 4 * sea.heights(xy).std() == pytest.approx(sea.summary.hs, rel=0.05)
    assert sea.measure().hs == pytest.approx(sea.summary.hs, rel=0.05)


def test_a_settled_sea_has_the_foam_of_one_that_has_run():
    points = numpy.random.default_rng(11).uniform(-300, 300, (2000, 2))
    with bolan.Sea(bolan.SeaState.from_wind(18.0, 225.0), resolution=64) as sea:
        sea.step(40.0)
        young = sea.sample(points)
        sea.settle(40.0)
        assert sea.sample(points)["foam"].mean() > 1.2 * young["foam"].mean() > 0
        assert (sea.sample(points)["height"] == young["height"]).all() and sea.time == 40.0


def test_least_wavelength_and_stretching_reach_the_library(sea):
    xy = numpy.random.default_rng(10).uniform(-500, 500, (500, 2))
    assert sea.motion(xy, least_wavelength=1000.0)["height"].var() < 0.1 * sea.motion(xy)["height"].var()
    below = numpy.column_stack([xy, numpy.full(500, -2.0)])
    assert sea.below(below, least_wavelength=1000.0)["velocity"].var() < 0.1 * sea.below(below)["velocity"].var()
    assert (sea.below(below, stretching="wheeler")["velocity"] != sea.below(below)["velocity"]).any()
    under = sea.levels(below[:, :2].copy(), [-1.0, -7.0])
    points = below.copy()
    points[:, 2] = -7.0
    assert under.shape == (2, len(below)) and under[1].tobytes() == sea.below(points).tobytes()
    assert len(sea.crests((0, 0), (900, 0), 1.0, least_wavelength=60.0)) < len(sea.crests((0, 0), (900, 0), 1.0))
    down, ray = [[0.0, 0.0, 50.0]], [[0.0, 0.0, -1.0]]
    assert sea.rays(down, ray, 99.0, least_wavelength=1000.0)["distance"][0] == pytest.approx(
        50.0 - sea.motion([[0.0, 0.0]], least_wavelength=1000.0)["height"][0], abs=2e-3)
    assert sea.rays(down, ray, 99.0)["distance"][0] == pytest.approx(50.0 - sea.heights([[0.0, 0.0]])[0], abs=2e-3)


def test_the_flow_is_at_the_time_of_the_sea(sea):
    where, other = [[0.0, 0.0, -3.0], [40.0, 0.0, -3.0]], sea.fork()
    first = sea.below(where)
    sea.step(2.0)
    other.step(2.0)
    assert sea.below(where).tobytes() == other.below(where).tobytes() != first.tobytes()


def test_fields_are_those_of_samples(sea):
    sea.step(3.0)
    points = numpy.random.default_rng(2).uniform(-500, 500, (20000, 2))
    variance = sum(float(sea.cascade(i).slope_x.var()) for i in range(sea.cascade_count))
    assert sum(sea.cascade(i).variance for i in range(sea.cascade_count)) == pytest.approx(
        sea.sample(points)["height"].var(), rel=0.25)
    assert variance > 0.2 * sum(sea.cascade(i).mss for i in range(sea.cascade_count)) / 2
    field = sea.cascade(0)
    assert field.height.shape == (64, 64) and not field.height.flags.writeable
    assert field.length > sea.cascade(1).length
    coarse = sea.sample(points, spacing=numpy.full(len(points), 200.0, "f4"))
    assert coarse["height"].var() < 0.3 * sea.sample(points)["height"].var()


USES = {"index": lambda f: f[0, 0], "add": lambda f: f + 1, "mean": lambda f: f.mean(), "function": numpy.mean,
        "copy": lambda f: f.copy(), "text": repr, "list": lambda f: f.tolist(), "iteration": list,
        "slice": lambda f: f[1:3], "reduce": numpy.add.reduce, "stack": lambda f: numpy.stack([f, f]),
        "astype": lambda f: f.astype("f8"), "bytes": lambda f: f.tobytes()}


@pytest.mark.parametrize("use", USES)
def test_a_step_ends_views_of_fields(sea, use):
    sea.step(1.0)
    field = sea.cascade(0).height
    part = field[2:5]
    USES[use](field), USES[use](part)
    sea.step(1.0)  # the same time: the same fields
    USES[use](field)
    kept = field.copy()
    sea.step(2.0)
    for stale in (field, part):
        with pytest.raises(bolan.StaleError, match="stepped to 2.0 s"):
            USES[use](stale)
    assert type(kept) is numpy.ndarray and kept.mean() == pytest.approx(0.0, abs=1e-6)
    field = sea.cascade(0).height
    sea.close()
    with pytest.raises(bolan.ClosedError):
        USES[use](field)


def test_memory_of_a_closed_sea_stays_while_an_array_needs_it():
    sea = bolan.Sea(resolution=64)
    plain = numpy.asarray(sea.cascade(0).height)
    expected = plain.copy()
    held = bolan.memory_in_use()
    sea.close()
    gc.collect()
    assert bolan.memory_in_use() == held
    assert (plain == expected).all()
    del plain
    gc.collect()
    assert bolan.memory_in_use() < held


def test_a_fork_shows_the_same_waves(sea):
    xy = numpy.random.default_rng(3).uniform(-100, 100, (50, 2))
    other = sea.fork()
    sea.step(7.0)
    assert other.time == 0.0 and (other.heights(xy) != sea.heights(xy)).any()
    other.step(7.0)
    assert other.heights(xy).tobytes() == sea.heights(xy).tobytes() and other.hash() == sea.hash()
    assert other.id == sea.id and other.serial != sea.serial
    sea.close()
    assert other.heights(xy).shape == (50,)


def test_out_is_filled_where_it_lies(sea):
    xy = numpy.random.default_rng(4).uniform(-100, 100, (10, 2))
    everything = numpy.full(30, numpy.nan, "f4")
    out = everything[10:20]
    assert sea.heights(xy, out=out) is out
    assert (everything[10:20] == sea.heights(xy)).all() and numpy.isnan(everything[[9, 20]]).all()
    records = numpy.empty(10, sea.surface(xy).dtype)
    assert sea.surface(xy, out=records) is records and (records["height"] == out).all()
    assert sea.heights(numpy.empty((0, 2))).shape == (0,) and sea.heights([]).shape == (0,)


def test_sums_of_waves_have_components():
    state = bolan.SeaState.from_wind(8, 270)
    with bolan.Sea(state, waves="cosines", cosines={"frequencies": 5, "directions": 3}) as sea:
        waves = sea.components()
        assert sea.form == "cosines" and len(waves) == 15 and sea.cascade_count == 0
        sea.step(2.0)
        height = sum(w.amplitude * math.cos(w.kx * 3.0 + w.ky * -4.0 - w.omega * 2.0 + w.phase) for w in waves)
        lifted = sea.sample([[3.0, -4.0]])["height"][0] - height
        assert 0 <= lifted < 0.2  # the lift, a constant
        assert sea.sample([[3.0, -4.0]])["height"][0] - lifted == pytest.approx(height, abs=1e-5)
        with pytest.raises(bolan.ArgumentError, match="no cascades"):
            sea.cascade(0)


def test_descs_are_defaults_and_keywords():
    with bolan.Sea(seed=2**64 - 1, resolution=32, choppiness=0.5, fft={"cascade_count": 2}) as sea:
        desc = sea.desc
        assert (desc.seed, desc.resolution, desc.choppiness, desc.fft.cascade_count) == (2**64 - 1, 32, 0.5, 2)
        assert desc.waves == "fft" and sea.cascade_count == 2
        assert desc.sea_state.wind_speed == 8.0 and desc.sea_state.wind_from_deg == 240.0
        assert desc == desc.copy() and desc != bolan.SeaDesc()


def test_threads_change_no_bit(sea):
    xy = numpy.random.default_rng(5).uniform(-1000, 1000, (20000, 2))
    sea.step(4.0)
    one = sea.heights(xy)
    bolan.set_threads(2)
    try:
        assert bolan.threads() == 2
        assert sea.heights(xy).tobytes() == one.tobytes()
    finally:
        bolan.set_threads(1)


@pytest.mark.skipif("BOLAN" not in os.environ, reason="the program is not built")
def test_numbers_are_those_of_the_program(tmp_path):
    xy = numpy.random.default_rng(6).uniform(-3000, 3000, (500, 2))
    points = tmp_path / "points.csv"
    points.write_text("".join(f"{x!r},{y!r}\n" for x, y in xy.tolist()))
    csv = subprocess.run([os.environ["BOLAN"], "query", "storm", "--time", "10", "--points", str(points), "--columns",
                          "height,normal,jacobian,velocity"], capture_output=True, text=True, check=True).stdout
    theirs = numpy.array([line.split(",") for line in csv.splitlines()[1:]])
    with bolan.World("storm") as world:
        world.step(10.0)
        surface, motion = world.surface(xy), world.motion(xy)
    ours = numpy.column_stack([surface["height"], surface["normal"], surface["jacobian"], motion["velocity"]])
    digits = [7, 7, 7, 7, 6, 6, 6, 6]  # of the program's columns
    different = [(a, float(b)) for row, mine in zip(theirs, ours) for a, b, n in zip(row, mine, digits)
                 if float(a) != float(f"{float(b):.{n}g}")]
    assert len(theirs) == 500 and not different


def test_a_buoy_record_has_the_height_and_period_of_the_sea():
    sea = bolan.Sea(bolan.SeaState.from_wind(12.0, 290.0, 300e3), resolution=64)
    series = numpy.empty((2048, 3), "f4")
    for i in range(len(series)):
        sea.step(i / 2)
        at = sea.sample([[0.0, 0.0]])
        series[i] = at["height"][0], at["dx"][0], at["dy"][0]
    heave, east, north = (numpy.ascontiguousarray(column) for column in series.T)
    measured = record.measure(heave, 2.0)
    assert measured.hm0 == pytest.approx(sea.summary.hs, rel=0.15)
    assert measured.h_third == pytest.approx(0.95 * measured.hm0, rel=0.08)  # Longuet-Higgins 1952, and finite bands
    bands = record.spectrum(heave, 2.0, 256, east, north)
    peak = bands[bands["density"].argmax()]
    assert 1 / peak["frequency"] == pytest.approx(sea.summary.tp, rel=0.2)
    assert peak["direction_from"] == pytest.approx(290.0, abs=25.0)


def test_record_of_a_sine():
    time = numpy.arange(4000) / 4.0
    heave = (1.5 * numpy.sin(2 * math.pi * time / 8.0)).astype("f4")
    measured = record.measure(heave, 4.0)
    assert (measured.h_third, measured.tz) == (pytest.approx(3.0, rel=1e-3), pytest.approx(8.0, rel=1e-3))
    assert measured.hm0 == pytest.approx(4 * 1.5 / math.sqrt(2), rel=1e-3)
    waves = record.waves(heave, 4.0)
    assert len(waves) in (124, 125) and waves["crest"] == pytest.approx(1.5, rel=1e-3)
    bands = record.spectrum(heave, 4.0, 256)
    assert bands[bands["density"].argmax()]["frequency"] == pytest.approx(1 / 8.0)
    assert bands["density"].sum() * 4.0 / 256 == pytest.approx(1.5**2 / 2, rel=0.02)
