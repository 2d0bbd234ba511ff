# SPDX-License-Identifier: MIT
"""numpy arrays to and from the library, without copies."""
import functools

import numpy

from ._library import ArgumentError, ClosedError, StaleError, c_name, ffi

_PRIMITIVES = {"float": "f4", "double": "f8", "_Bool": "?", "uint32_t": "u4", "uint64_t": "u8", "int": "i4",
               "uint16_t": "u2", "uint8_t": "u1"}
MOST = 2**32 - 1


@functools.lru_cache(maxsize=None)
def dtype_of(name):
    """The numpy dtype with the layout of a C struct; vectors are short axes."""
    return numpy.dtype(_dtype(ffi.typeof(name)))


def _dtype(kind):
    if kind.kind == "primitive":
        return _PRIMITIVES[kind.cname]
    parts = [_dtype(field.type) for _, field in kind.fields]
    if c_name(kind).startswith(("bolan_vec", "bolan_dvec")):
        return (parts[0], (len(parts),))
    return {"names": [name for name, _ in kind.fields], "formats": parts,
            "offsets": [field.offset for _, field in kind.fields], "itemsize": ffi.sizeof(kind)}


def _shape(shape):
    return "(" + ", ".join(map(str, shape)) + ("," if len(shape) == 1 else "") + ")"


def _found(array):
    layout = "" if array.flags.c_contiguous else ", not contiguous"
    return f"{array.dtype} of shape {_shape(array.shape)}{layout}"


def read(values, dtype, shape, what):
    """An array that the library may read. A numpy array is taken as it is or refused; a sequence is converted.

    shape holds numbers, and None for the one axis of any length."""
    expected = f"a contiguous array of {numpy.dtype(dtype)} of shape {_shape(['n' if s is None else s for s in shape])}"
    if not isinstance(values, numpy.ndarray):
        try:
            values = numpy.array(values, dtype=dtype)
        except (TypeError, ValueError):
            raise ArgumentError(f"{what} is {type(values).__name__}; expected {expected}") from None
        if values.size == 0 and values.ndim == 1:
            values = values.reshape([0 if s is None else s for s in shape])
    fits = values.ndim == len(shape) and all(s is None or s == v for s, v in zip(shape, values.shape))
    if values.dtype != dtype or not fits or not values.flags.c_contiguous or not values.dtype.isnative:
        raise ArgumentError(f"{what} is {_found(values)}; expected {expected}")
    if len(values) > MOST:
        raise ArgumentError(f"{what} has {len(values)} rows; expected at most {MOST}")
    if isinstance(values, Field):
        values = values.now()
    return values


def written(out, dtype, shape, what="out"):
    """The array that the library writes to: the caller's, checked, or a new one."""
    if out is None:
        return numpy.empty(shape, dtype)
    expected = f"a contiguous, writeable array of {numpy.dtype(dtype)} of shape {_shape(shape)}"
    if not isinstance(out, numpy.ndarray):
        raise ArgumentError(f"{what} is {type(out).__name__}; expected {expected}")
    if out.dtype != dtype or out.shape != tuple(shape) or not out.flags.c_contiguous or not out.flags.writeable:
        found = _found(out) + ("" if out.flags.writeable else ", read-only")
        raise ArgumentError(f"{what} is {found}; expected {expected}")
    return out


def pointer(kind, array, writeable=False):
    """The C array over the memory of a numpy array; it keeps the memory alive."""
    return ffi.from_buffer(f"{kind}[]", array, require_writable=writeable)


class _Memory:
    """Memory of the library for numpy: an array over it keeps its owner alive."""

    def __init__(self, address, shape, dtype, owner):
        self.owner = owner
        self.__array_interface__ = {"version": 3, "data": (int(ffi.cast("uintptr_t", address)), True),
                                    "shape": tuple(shape), "typestr": numpy.dtype(dtype).newbyteorder("=").str}


def view(address, shape, dtype, owner):
    """A read-only array over memory of the library. owner keeps that memory."""
    return numpy.asarray(_Memory(address, shape, dtype, owner))


class Field(numpy.ndarray):
    """A read-only array over a field of a sea at its present time.

    After the next step every use raises StaleError, after close() ClosedError: indexing, arithmetic, functions of
    numpy, copies. Take a copy() of what shall stay. numpy.asarray() of a Field is a plain array over the same
    memory, without that check; the memory itself lives as long as an array over it."""

    def __array_finalize__(self, other):
        self._fresh = getattr(other, "_fresh", None)

    def now(self):
        """The plain array, after the check."""
        if self._fresh is not None:
            self._fresh()
        return self.view(numpy.ndarray)

    def __getitem__(self, key):
        if self._fresh is not None:
            self._fresh()
        return super().__getitem__(key)

    def __array_ufunc__(self, ufunc, method, *inputs, **keywords):
        return getattr(ufunc, method)(*_plain(inputs), **_plain(keywords))

    def __array_function__(self, function, types, arguments, keywords):
        return function(*_plain(arguments), **_plain(keywords))

    def __repr__(self):
        return repr(self.now())

    def __str__(self):
        return str(self.now())

    def __iter__(self):
        return iter(self.now())

    def __float__(self):
        return float(self.now())


def _guarded(name):
    def method(self, *arguments, **keywords):
        return getattr(self.now(), name)(*arguments, **keywords)
    method.__name__ = name
    method.__doc__ = getattr(numpy.ndarray, name).__doc__
    return method


for _name in ("copy", "astype", "tolist", "tobytes", "item", "flatten", "dot", "mean", "sum", "std", "var", "min",
              "max",
              "argmin", "argmax", "nonzero", "argsort", "take", "cumsum", "ravel", "reshape", "transpose", "__copy__",
              "__deepcopy__", "__reduce__", "tofile", "dump", "dumps", "searchsorted", "compress", "choose", "repeat",
              "round", "clip", "ptp", "all", "any", "prod", "trace", "diagonal", "squeeze", "swapaxes"):
    setattr(Field, _name, _guarded(_name))


def _plain(values):
    """Fields inside arguments as plain arrays, after the check."""
    if isinstance(values, Field):
        return values.now()
    if isinstance(values, (tuple, list)):
        return type(values)(_plain(value) for value in values)
    if isinstance(values, dict):
        return {key: _plain(value) for key, value in values.items()}
    return values


def field(address, shape, dtype, sea, serial, part=...):
    """A Field of a sea: a part of an array, all of it unless `part` is an index."""
    array = view(address, shape, dtype, sea._pointer)[part].view(Field)

    def fresh():
        if sea.closed:
            raise ClosedError("this Sea is closed")
        if sea.serial != serial:
            raise StaleError(f"the array shows a time that has passed: the sea was stepped to {sea.time} s")
    array._fresh = fresh
    return array
