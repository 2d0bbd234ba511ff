# SPDX-License-Identifier: MIT
"""Sea states against published numbers, and files of spectra."""
import gc
import math
import pathlib

import numpy
import pytest

import bolan
from conftest import SOURCE

SPECTRA = pathlib.Path(SOURCE, "tests/data/spectra")


def test_fully_developed_sea_is_pierson_and_moskowitz():
    # Pierson & Moskowitz 1964: S = 0.0081 g^2 w^-5 exp(-0.74 (g/(U w))^4), U at 19.5 m = 1.026 U10.
    u = 1.026 * 10.0
    state = bolan.SeaState.from_wind(10.0, 270.0)
    theta = numpy.linspace(0, 2 * math.pi, 720, endpoint=False)
    for omega in (0.7, 0.9, 1.3, 2.0):
        expected = 0.0081 * 9.81**2 * omega**-5 * math.exp(-0.74 * (9.81 / (u * omega))**4)
        assert state.density(omega, theta).sum() * 2 * math.pi / 720 == pytest.approx(expected, rel=0.01)
    summary = state.summary()
    assert summary.hs == pytest.approx(0.209 * u * u / 9.81, rel=0.005)
    assert summary.tp == pytest.approx(2 * math.pi * u / (0.877 * 9.81), rel=0.005)
    assert summary.from_deg == pytest.approx(270.0, abs=0.1)


def test_waves_go_where_the_wind_blows_to():
    state = bolan.SeaState.from_wind(10.0, 270.0)  # from the west: to the east, mathematical angle 0
    assert state.density(0.9, 0.0) > 100 * max(state.density(0.9, math.pi), 1e-9)


def test_swell_and_wind_sea_are_parts():
    state = bolan.SeaState.from_wind(8.0, 200.0).add_swell(3.0, 16.0, 300.0, spread_s=50.0)
    wind, swell = state.partitions()
    assert wind.wind_sea and not swell.wind_sea
    assert (swell.hs, swell.tp) == (pytest.approx(3.0, rel=0.05), pytest.approx(16.0, rel=0.03))
    assert swell.from_deg == pytest.approx(300.0, abs=2.0)
    assert state.summary().hs**2 == pytest.approx(bolan.SeaState.from_wind(8.0, 200.0).summary().hs**2 + 9.0, rel=1e-3)


def test_scales():
    assert bolan.SeaState.from_beaufort(6, 0.0).wind_speed == pytest.approx(0.836 * 6**1.5)
    assert bolan.SeaState.from_douglas(5, 0.0).summary().hs == pytest.approx((2.5 + 4.0) / 2, rel=0.01)


def test_families_add_their_height():
    for state in (bolan.SeaState().add_ochi_hubble(4.0, 0, 90.0), bolan.SeaState().add_torsethaugen(4.0, 10.0, 90.0)):
        assert len(state.systems) == 2
        assert state.summary().hs == pytest.approx(4.0, rel=0.01)
    for state in (bolan.SeaState.from_phillips(10, 0), bolan.SeaState.from_donelan(10, 0, 1e5),
                  bolan.SeaState.from_elfouhaily(10, 0, 1e5)):
        assert state.summary().hs > 0.5


def test_shallow_water_limits_the_height():
    state = bolan.SeaState(depth=2.0).add_swell(3.0, 10.0, 0.0)
    assert state.limit().by_depth == pytest.approx(0.6 * 2.0 / 3.0, rel=0.01)  # Hs at most 0.6 of the depth


def test_spectrum_comes_back_from_a_file(tmp_path):
    state = bolan.SeaState.from_wind(11.0, 250.0, 1e5)
    state.save(tmp_path / "sea.spec")
    grid = state.sample()
    back = bolan.MeasuredSpectrum.load(tmp_path / "sea.spec")
    assert back.density.shape == grid.density.shape
    assert abs(back.density - grid.density).max() <= 1e-7 * grid.density.max()
    step = 2 * math.pi / len(grid.theta)
    m0 = numpy.trapz(grid.density.sum(axis=1) * step, grid.omega)
    assert 4 * math.sqrt(m0) == pytest.approx(state.summary().hs, rel=0.02)
    parsed = bolan.MeasuredSpectrum.parse((tmp_path / "sea.spec").read_bytes(), "sea.spec")
    assert (parsed.density == back.density).all()
    for suffix in ("csv", "png"):
        state.save(tmp_path / f"sea.{suffix}", title="a sea")
        assert (tmp_path / f"sea.{suffix}").stat().st_size > 1000
    with pytest.raises(bolan.ArgumentError, match="suffix|expected"):
        state.save(tmp_path / "sea.txt")


def test_buoy_becomes_a_sea():
    measured = bolan.MeasuredSpectrum.load("builtin:synthetic-bimodal")
    state = bolan.SeaState(measured=measured)
    assert state.measured is measured
    expected = state.summary().hs
    gc.collect()
    held = bolan.memory_in_use()
    measured.close()
    del measured
    assert bolan.memory_in_use() == held
    with bolan.Sea(state, resolution=64) as sea:  # the spectrum lives on in the sea state
        assert sea.summary.hs == pytest.approx(expected, rel=1e-6)


def test_contents_of_a_file():
    path = next(p for p in sorted(SPECTRA.rglob("*.spec")) if p.is_file())
    held = bolan.contents(path)
    assert held.format and held.frequency_count >= 2 and len(held.records) >= 1
    assert held.hs[0] <= held.hs[1]


def test_arrays_are_read_only_and_outlive_the_spectrum():
    with bolan.SeaState.from_wind(10.0, 0.0).sample() as spectrum:
        density = spectrum.density
        total = density.sum()
        with pytest.raises(ValueError, match="read-only"):
            density[0, 0] = 1.0
    assert density.sum() == total > 0
    with pytest.raises(bolan.ClosedError):
        spectrum.omega
