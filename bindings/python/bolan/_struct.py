# SPDX-License-Identifier: MIT
"""Plain structs of the library as Python objects: their fields are attributes over the memory of the struct."""
import keyword

from ._library import ArgumentError, c_name, ffi, lib, text

_TUPLES = ("bolan_vec2", "bolan_vec3", "bolan_vec4", "bolan_dvec2", "bolan_dvec3")
_classes = {}  # the Python class of each C struct


def _fields(pointer):
    """The fields of the struct under a pointer."""
    return dict(ffi.typeof(pointer).item.fields)


def _field_name(name):
    """The field of an attribute: lambda_ stands for lambda, which is a word of Python."""
    return name[:-1] if name.endswith("_") and keyword.iskeyword(name[:-1]) else name


def _attribute_name(field):
    return field + "_" if keyword.iskeyword(field) else field


def _enum_names(kind):
    """Names of an enum by value: those of the library's table, or its enumerators less their common beginning."""
    if c_name(kind) in _enum_cache:
        return _enum_cache[c_name(kind)]
    table = getattr(lib, c_name(kind) + "_names", None)
    values = sorted(kind.elements)
    if table is not None:
        names = {i: text(table[i]) for i in values if i < len(table) - 1}
    else:
        enumerators = [kind.elements[i] for i in values]
        common = min(len(_shared(name, enumerators)) for name in enumerators)
        names = {i: kind.elements[i][common:].lower().replace("_", "-") for i in values}
    _enum_cache[c_name(kind)] = names
    return names


_enum_cache = {}


def _shared(name, others):
    """The words at the beginning of a name that all others have."""
    size = max((i + 1 for i, c in enumerate(name) if c == "_" and all(o.startswith(name[:i + 1]) for o in others)),
               default=0)
    return name[:size]


def enum_value(kind, given, what):
    """Value of an enum by name, or by number."""
    kind = ffi.typeof(kind) if isinstance(kind, str) else kind
    names = _enum_names(kind)
    for value, name in names.items():
        if given == name or (given == value and not isinstance(given, bool)):
            return value
    raise ArgumentError(f"{what} is {given!r}; expected one of {', '.join(names.values())}")


def enum_name(kind, value):
    return _enum_names(ffi.typeof(kind)).get(value, str(value))


def parameters(kind):
    """The table of ranges and defaults of a struct; None where it has none."""
    table = getattr(lib, kind.removesuffix("_desc") + "_params", None)
    return None if table is None else ffi.addressof(table)


class Struct:
    """A plain struct. Made with the library's defaults; keywords set fields. Structs inside it are views."""

    _type = None

    def __init_subclass__(cls, **rest):
        super().__init_subclass__(**rest)
        if "_type" in cls.__dict__ or cls._type:
            _classes[cls._type] = cls

    def __init__(self, **fields):
        if self._type is None:
            raise TypeError("a Struct is made by its subclasses")
        default = getattr(lib, self._type + "_default", None)
        self._begin(ffi.new(self._type + " *") if default is None else ffi.new(self._type + " *", default()), [])
        if default is None and parameters(self._type) is not None:
            lib.bolan_params_default(parameters(self._type), self._c)
        self.update(**fields)

    def _begin(self, pointer, keep):
        keep.append(pointer)
        object.__setattr__(self, "_c", pointer)
        object.__setattr__(self, "_keep", keep)  # what the pointers in the struct, or the struct, need to live

    @classmethod
    def _view(cls, pointer, keep):
        made = object.__new__(cls)
        made._begin(pointer, keep)
        return made

    @classmethod
    def _of(cls, value, keep=()):
        """A copy of a struct that the library returned."""
        return cls._view(ffi.new(cls._type + " *", value), list(keep))

    def copy(self):
        """Another struct with the same values."""
        return type(self)._view(ffi.new(ffi.typeof(self._c), self._c[0]), list(self._keep))

    def update(self, **fields):
        """Sets fields by keyword."""
        for name, value in fields.items():
            setattr(self, name, value)

    def as_dict(self):
        """The fields, those of structs inside too, as a dict."""
        return {name: _plain(getattr(self, name)) for name in map(_attribute_name, _fields(self._c))}

    def __dir__(self):
        return [*map(_attribute_name, _fields(self._c)), *super().__dir__()]

    def __repr__(self):
        return f"{type(self).__name__}({', '.join(f'{k}={v!r}' for k, v in self.as_dict().items())})"

    def __eq__(self, other):
        return type(other) is type(self) and self.as_dict() == other.as_dict()

    __hash__ = None

    def __getattr__(self, name):
        name = _field_name(name)
        described = _fields(self._c).get(name)
        if described is None:
            raise AttributeError(f"{type(self).__name__} has no field {name}")
        return self._read(name, described.type)

    def _read(self, name, kind):
        if kind.kind == "struct":
            return self._inside(kind, ffi.addressof(self._c[0], name))
        value = getattr(self._c, name)
        if kind.kind == "enum":
            return _enum_names(kind).get(value, value)
        if kind.kind == "array":
            if kind.item.cname == "char":
                return ffi.string(value).decode("utf-8", "replace")
            return tuple(self._inside(kind.item, ffi.addressof(value, i)) if kind.item.kind == "struct" else value[i]
                         for i in range(self._length(name, kind)))
        if kind.kind == "pointer" and kind.item.cname == "char":
            return text(value)
        return value

    def _length(self, name, kind):
        """How many elements of a list are in use: its count where the struct has one."""
        fields = _fields(self._c)
        for count in (name.removesuffix("s") + "_count", name.removesuffix("es") + "_count"):
            if count in fields:
                return min(getattr(self._c, count), kind.length)
        return kind.length

    def _inside(self, kind, pointer):
        if c_name(kind) in _TUPLES:
            return tuple(getattr(pointer, field) for field, _ in kind.fields)
        made = object.__new__(_classes.get(c_name(kind), Struct))
        object.__setattr__(made, "_c", pointer)
        object.__setattr__(made, "_keep", self._keep)  # the same list: what is set through the view lives as long
        return made

    def __setattr__(self, name, value):
        if isinstance(getattr(type(self), name, None), property):
            return object.__setattr__(self, name, value)
        name = _field_name(name)
        described = _fields(self._c).get(name)
        if described is None:
            raise AttributeError(f"{type(self).__name__} has no field {name}")
        what = f"{c_name(ffi.typeof(self._c).item)}.{name}"
        try:
            self._write(name, described.type, value, what)
        except (TypeError, OverflowError) as error:
            raise ArgumentError(f"{what} is {value!r}; expected {_expected(described.type)}") from error

    def _write(self, name, kind, value, what):
        if kind.kind == "enum":
            value = enum_value(kind, value, what)
        elif kind.kind == "struct" and c_name(kind) not in _TUPLES:
            return self._write_struct(name, kind, value, what)
        elif kind.kind == "array" and kind.item.cname == "char":
            value = value.encode() if isinstance(value, str) else bytes(value)
            if len(value) >= kind.length or b"\0" in value:
                raise ArgumentError(f"{what} has {len(value)} bytes; expected at most {kind.length - 1}, and no NUL")
        elif kind.kind in ("array", "struct"):
            value = tuple(value)
            size = kind.length if kind.kind == "array" else len(kind.fields)
            if len(value) != size:
                raise ArgumentError(f"{what} has {len(value)} values; expected {size}")
        elif kind.cname == "_Bool" and not isinstance(value, bool):
            raise TypeError
        setattr(self._c, name, value)

    def _write_struct(self, name, kind, value, what):
        if isinstance(value, dict):
            return getattr(self, name).update(**value)
        if not isinstance(value, Struct) or ffi.typeof(value._c).item is not kind:
            raise ArgumentError(f"{what} is {value!r}; expected {c_name(kind)} or a dict of its fields")
        setattr(self._c, name, value._c[0])
        if value._keep is not self._keep:
            self._keep.extend(value._keep)


def _plain(value):
    if isinstance(value, Struct):
        return value.as_dict()
    if isinstance(value, tuple):
        return tuple(_plain(item) for item in value)
    return value


def _expected(kind):
    if kind.cname == "_Bool":
        return "True or False"
    if kind.kind == "primitive":
        return "a number" if kind.cname in ("double", "float") else f"a whole number that fits {kind.cname}"
    return c_name(kind)
