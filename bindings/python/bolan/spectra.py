# SPDX-License-Identifier: MIT
"""Sea states as directional spectra: winds, swells, and measured or forecast spectra of files."""
import math
import os
from typing import NamedTuple, Optional, Sequence, Tuple

import numpy

from . import _arrays, _structs
from ._library import ArgumentError, Closable, Pointer, call, check, documented, ffi, files, lib, path_bytes, text


def _number(value, what):
    try:
        return float(value)
    except (TypeError, ValueError):
        raise ArgumentError(f"{what} is {value!r}; expected a number") from None


class MeasuredSpectrum(Closable):
    """A measured or forecast spectrum on a grid of frequencies and directions. Immutable; threads may share it."""

    def __init__(self, pointer):
        self._pointer = pointer

    @classmethod
    @documented("bolan_spectrum_load", "bolan_spectrum_options_default")
    def load(cls, path, options: Optional[_structs.SpectrumOptions] = None, **fields) -> "MeasuredSpectrum":
        """Reads a file; docs/formats.md has the formats. Keywords set fields of SpectrumOptions."""
        options = _options(options, fields)
        with files:
            return cls(Pointer("bolan_measured_spectrum", _load, path_bytes(path), options._c))

    @classmethod
    @documented("bolan_measured_spectrum_parse")
    def parse(cls, data: bytes, name: str = "data", options: Optional[_structs.SpectrumOptions] = None,
              **fields) -> "MeasuredSpectrum":
        """Reads one record of the bytes of a file. name is used in messages."""
        options = _options(options, fields)
        buffer, label = ffi.from_buffer(data), ffi.new("char[]", path_bytes(name))
        texts = ffi.new("bolan_spectrum_texts *")
        texts.density.name, texts.density.data, texts.density.size = label, buffer, len(buffer)
        return cls(Pointer("bolan_measured_spectrum", lib.bolan_measured_spectrum_parse, texts, options._c))

    def _view(self):
        return call(lib.bolan_measured_spectrum_view, self._get())

    @property
    def omega(self) -> numpy.ndarray:
        """Angular frequencies [rad/s], read-only."""
        view = self._view()
        return _arrays.view(view.omega, (view.frequency_count,), "f8", self._pointer)

    @property
    def theta(self) -> numpy.ndarray:
        """Directions that the waves go to, mathematical angles [rad], read-only."""
        view = self._view()
        return _arrays.view(view.theta, (view.direction_count,), "f8", self._pointer)

    @property
    def density(self) -> numpy.ndarray:
        """Variance density [m2 s/rad per rad] by frequency and direction, read-only."""
        view = self._view()
        return _arrays.view(view.density, (view.frequency_count, view.direction_count), "f8", self._pointer)

    @property
    def time(self) -> str:
        """Time of the record in ISO 8601; "" where the file gives none."""
        return text(self._view().time)

    @property
    def place(self) -> Optional[Tuple[float, float]]:
        """Longitude and latitude [deg], or x and y [m], of the record; None where the file gives none."""
        place = self._view().place
        return (place.x, place.y) if place.known else None


def _load(path, options, out):
    return lib.bolan_spectrum_load(path, options, out)


def _options(options, fields):
    options = _structs.SpectrumOptions() if options is None else options.copy()
    options.update(**fields)
    return options


class SeaState(_structs.SeaState):
    __doc__ = _structs.SeaState.__doc__

    @classmethod
    @documented("bolan_sea_state_from_wind")
    def from_wind(cls, wind_speed: float, from_deg: float, fetch: float = math.inf) -> "SeaState":
        """A JONSWAP wind sea. wind_speed [m/s], from_deg where the wind comes from [compass deg], fetch [m]."""
        return cls._of(call(lib.bolan_sea_state_from_wind, _number(wind_speed, "wind_speed"),
                            _number(from_deg, "from_deg"), _number(fetch, "fetch")))

    @classmethod
    @documented("bolan_sea_state_from_donelan")
    def from_donelan(cls, wind_speed: float, from_deg: float, fetch: float = math.inf) -> "SeaState":
        """A wind sea after Donelan, Hamilton & Hui."""
        return cls._of(call(lib.bolan_sea_state_from_donelan, wind_speed, from_deg, fetch))

    @classmethod
    @documented("bolan_sea_state_from_elfouhaily")
    def from_elfouhaily(cls, wind_speed: float, from_deg: float, fetch: float = math.inf) -> "SeaState":
        """A wind sea after Elfouhaily et al."""
        return cls._of(call(lib.bolan_sea_state_from_elfouhaily, wind_speed, from_deg, fetch))

    @classmethod
    @documented("bolan_sea_state_from_phillips")
    def from_phillips(cls, wind_speed: float, from_deg: float) -> "SeaState":
        """The wind sea of a Phillips spectrum."""
        return cls._of(call(lib.bolan_sea_state_from_phillips, wind_speed, from_deg))

    @classmethod
    @documented("bolan_sea_state_from_beaufort")
    def from_beaufort(cls, beaufort: float, from_deg: float) -> "SeaState":
        """The fully developed wind sea of a Beaufort number, 0..12."""
        return cls._of(call(lib.bolan_sea_state_from_beaufort, beaufort, from_deg))

    @classmethod
    @documented("bolan_sea_state_from_douglas")
    def from_douglas(cls, degree: int, from_deg: float) -> "SeaState":
        """The sea of a Douglas degree, 0..9."""
        return cls._of(call(lib.bolan_sea_state_from_douglas, degree, from_deg))

    @property
    def measured(self) -> Optional[MeasuredSpectrum]:
        """A spectrum that is added to the systems, or None. Set it; reading gives what was set to this object."""
        return next((kept for kept in reversed(self._keep) if isinstance(kept, MeasuredSpectrum)), None) \
            if self._c.measured else None

    @measured.setter
    def measured(self, spectrum: Optional[MeasuredSpectrum]):
        if spectrum is not None and not isinstance(spectrum, MeasuredSpectrum):
            raise ArgumentError(f"measured is {spectrum!r}; expected a MeasuredSpectrum or None")
        self._c.measured = ffi.NULL if spectrum is None else spectrum._get()
        if spectrum is not None:
            self._keep.extend([spectrum, spectrum._pointer])  # the latter lives on where the former is closed

    @documented("bolan_sea_state_add_system")
    def add_system(self, system: _structs.WaveSystem) -> "SeaState":
        """Adds a wind sea or a swell, and returns the sea state."""
        if not isinstance(system, _structs.WaveSystem):
            raise ArgumentError(f"system is {system!r}; expected a WaveSystem")
        check(lib.bolan_sea_state_add_system, self._c, system._c)
        return self

    @documented("bolan_sea_state_add_swell")
    def add_swell(self, hs: float, tp: float, from_deg: float, spread_s: float = 25.0) -> "SeaState":
        """Adds a swell, and returns the sea state."""
        check(lib.bolan_sea_state_add_swell, self._c, hs, tp, from_deg, spread_s)
        return self

    @documented("bolan_sea_state_add_ochi_hubble")
    def add_ochi_hubble(self, hs: float, member: int, from_deg: float) -> "SeaState":
        """Adds the two peaks of Ochi & Hubble, and returns the sea state."""
        check(lib.bolan_sea_state_add_ochi_hubble, self._c, hs, member, from_deg)
        return self

    @documented("bolan_sea_state_add_torsethaugen")
    def add_torsethaugen(self, hs: float, tp: float, from_deg: float) -> "SeaState":
        """Adds the two peaks of Torsethaugen & Haver, and returns the sea state."""
        check(lib.bolan_sea_state_add_torsethaugen, self._c, hs, tp, from_deg)
        return self

    @documented("bolan_sea_state_validate")
    def validate(self) -> None:
        """Raises ArgumentError at the first field out of its range."""
        check(lib.bolan_sea_state_validate, self._c)

    @documented("bolan_sea_state_summary")
    def summary(self) -> _structs.SeaSummary:
        """Height, periods, direction and spread of the sea."""
        self.validate()
        return _structs.SeaSummary._of(call(lib.bolan_sea_state_summary, self._c))

    @documented("bolan_sea_state_limit")
    def limit(self) -> _structs.SeaLimit:
        """Factors on the height with which water of this depth can carry the waves."""
        self.validate()
        return _structs.SeaLimit._of(call(lib.bolan_sea_state_limit, self._c))

    @documented("bolan_sea_state_density")
    def density(self, omega, theta) -> numpy.ndarray:
        """S(omega, theta) [m2 s/rad per rad]; the arguments are broadcast against each other."""
        self.validate()
        omega, theta = numpy.broadcast_arrays(numpy.asarray(omega, "f8"), numpy.asarray(theta, "f8"))
        density = lib.bolan_sea_state_density
        values = [density(self._c, w, t) for w, t in zip(omega.ravel().tolist(), theta.ravel().tolist())]
        return numpy.array(values).reshape(omega.shape)

    @documented("bolan_sea_state_partition")
    def partitions(self) -> Tuple[_structs.Partition, ...]:
        """Wind seas, then swells, each by falling height."""
        self.validate()
        out, count = ffi.new("bolan_partition[8]"), ffi.new("uint32_t *")
        check(lib.bolan_sea_state_partition, self._c, out, count)
        return tuple(_structs.Partition._of(out[i]) for i in range(count[0]))

    @documented("bolan_measured_spectrum_sample")
    def sample(self) -> MeasuredSpectrum:
        """The sea as a spectrum on a grid."""
        self.validate()
        return MeasuredSpectrum(Pointer("bolan_measured_spectrum", lib.bolan_measured_spectrum_sample, self._c))

    @documented("bolan_spectrum_save")
    def save(self, path, title: str = "") -> None:
        """Writes the spectrum: .png a plot, .csv a table, .spec SWAN."""
        self.validate()
        with files:
            check(lib.bolan_spectrum_save, path_bytes(path), self._c, title.encode())


class Record(NamedTuple):
    """A record in time of a file of spectra."""
    seconds: float
    time: str


class Place(NamedTuple):
    """A location of a file of spectra."""
    x: float
    y: float
    name: str


class Contents(NamedTuple):
    """What a file of spectra holds."""
    format: str
    title: str
    records: Sequence[Record]
    places: Sequence[Place]
    spherical: bool
    frequency_count: int
    direction_count: int
    has_moments: bool
    hs: Tuple[float, float]
    tp: Tuple[float, float]


@documented("bolan_spectrum_contents_load")
def contents(path) -> Contents:
    """Lists what a file of spectra holds."""
    with files:
        pointer = Pointer("bolan_spectrum_contents", lib.bolan_spectrum_contents_load, path_bytes(path))
    c = pointer.raw
    return Contents(text(c.format), text(c.title),
                    tuple(Record(r.seconds, text(r.time)) for r in c.records[0:c.record_count]),
                    tuple(Place(p.x, p.y, text(p.name)) for p in c.places[0:c.place_count]) if c.place_count else (),
                    c.spherical, c.frequency_count, c.direction_count, c.has_moments, (c.hs_min, c.hs_max),
                    (c.tp_min, c.tp_max))
