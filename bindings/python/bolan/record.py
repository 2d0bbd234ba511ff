# SPDX-License-Identifier: MIT
"""Records of buoys: heights at equal steps of time."""
from typing import Optional

import numpy

from . import _arrays, _structs
from ._library import ArgumentError, call, check, documented, ffi, lib
from .sea import finite


def _series(values, what, like=None):
    values = _arrays.read(values, "f4", (None if like is None else len(like),), what)
    if not numpy.isfinite(values).all():
        raise ArgumentError(f"{what} holds a number that is not finite")
    return values


def _rate(rate):
    rate = finite(rate, "rate")
    if rate <= 0:
        raise ArgumentError(f"rate is {rate}; expected samples a second, above 0")
    return rate


@documented("bolan_record_waves")
def waves(heave, rate: float) -> numpy.ndarray:
    """The waves of heave, (n,) float32 [m]: a record array with height, period and crest."""
    heave, kind = _series(heave, "heave"), "bolan_record_wave"
    out = numpy.empty(len(heave) // 2 + 1, _arrays.dtype_of(kind))
    count = call(lib.bolan_record_waves, _arrays.pointer("float", heave), len(heave), _rate(rate), len(out),
                 _arrays.pointer(kind, out, writeable=True))
    return out[:count]


@documented("bolan_record_measure")
def measure(heave, rate: float) -> _structs.RecordStatistics:
    """Heights, periods and moments of heave, (n,) float32 [m]."""
    heave, out = _series(heave, "heave"), ffi.new("bolan_record_statistics *")
    check(lib.bolan_record_measure, _arrays.pointer("float", heave), len(heave), _rate(rate), out)
    return _structs.RecordStatistics._of(out[0])


@documented("bolan_record_spectrum")
def spectrum(heave, rate: float, segment: int, east=None, north=None,
             out: Optional[numpy.ndarray] = None) -> numpy.ndarray:
    """The spectrum of a buoy, series (n,) float32 [m]: a record array with frequency, density ... spread."""
    heave, kind = _series(heave, "heave"), "bolan_record_band"
    if (east is None) != (north is None):
        raise ArgumentError("east and north belong together; expected both or neither")
    aside = [ffi.NULL if values is None else _arrays.pointer("float", _series(values, what, heave))
             for values, what in ((east, "east"), (north, "north"))]
    if not isinstance(segment, int) or not 16 <= segment <= 4096 or segment % 4:
        raise ArgumentError(f"segment is {segment!r}; expected a multiple of 4, 16..4096")
    out = _arrays.written(out, _arrays.dtype_of(kind), (segment // 2 - 1,))
    check(lib.bolan_record_spectrum, _arrays.pointer("float", heave), *aside, len(heave), _rate(rate), segment,
          _arrays.pointer(kind, out, writeable=True))
    return out
