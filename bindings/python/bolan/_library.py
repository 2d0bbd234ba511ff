# SPDX-License-Identifier: MIT
"""The shared library: where it is found, how it is called, and how it says what is wrong."""
import ctypes.util
import logging
import os
import pathlib
import threading
import warnings
from contextlib import contextmanager

from ._abi import ffi

VERSION = "0.2"  # major and minor version of the library that these declarations belong to
NAME = "bolan_all"

log = logging.getLogger("bolan")


# ---- exceptions ----------------------------------------------------------------------------------------------------

class Error(Exception):
    """Something that the library refused. The text is the library's own sentence.

    id is the number of the message (BOLAN_LOG_... of base.h, docs/errors.md), or None where the package refused."""

    def __init__(self, sentence, id=None):
        super().__init__(sentence)
        self.id = id


class ArgumentError(Error, ValueError):
    """A field or argument is outside its range, of another type or shape, or not finite."""


class OutOfMemoryError(Error, MemoryError):
    """There is no memory for it."""


class FileError(Error, OSError):
    """A file could not be opened, read or written."""


class FormatError(Error, ValueError):
    """The content of a file does not match its format."""


class UnsupportedError(Error, NotImplementedError):
    """Valid, but not supported by this build or this machine."""


class GLError(Error, RuntimeError):
    """OpenGL: no context, a shader did not compile, a target is incomplete."""


class MisuseError(Error, AssertionError):
    """The library's check of a caller failed."""


class ClosedError(Error, ValueError):
    """The object is closed."""


class StaleError(Error, ValueError):
    """The array shows fields of a time that has passed."""


class BolanWarning(UserWarning):
    """The library went on, with something missing, replaced or lowered."""


# ---- the library ---------------------------------------------------------------------------------------------------

def _candidates():
    given = os.environ.get("BOLAN_LIBRARY")
    if given:
        return [given]  # what is asked for, or nothing
    beside = pathlib.Path(__file__).parent / f"lib{NAME}.so"
    names = [str(beside)] if beside.exists() else []
    return names + [name for name in (f"lib{NAME}.so.{VERSION}", ctypes.util.find_library(NAME)) if name]


def _open():
    reasons = []
    for name in _candidates():
        try:
            library = ffi.dlopen(name)
        except OSError as error:
            reasons.append(str(error))
            continue
        try:
            found = ffi.string(library.bolan_version()).decode()
        except (AttributeError, ffi.error) as error:
            raise ImportError(f"{name} is not libbolan_all: {error}") from None
        if found.rsplit(".", 1)[0] != VERSION:
            raise ImportError(f"{name} is version {found} of the library; expected {VERSION}")
        return library
    raise ImportError(f"lib{NAME}.so is not found: {'; '.join(reasons)}. Set BOLAN_LIBRARY to its path, put it beside "
                      "the package, or install it.")


lib = _open()

_heard = threading.local()  # .said: what the library said to this thread during the present call


def _note(kind, number, sentence):
    said = getattr(_heard, "said", None)
    if said is not None:
        said.append((kind, number, sentence))
    else:  # a thread of the library's own, or a call without anybody who could catch an exception
        log.log({lib.BOLAN_LOG_WARNING: logging.WARNING, lib.BOLAN_LOG_INFO: logging.INFO}.get(kind, logging.ERROR),
                "%s", sentence)


@ffi.callback("void(void *, bolan_log_level, bolan_log_id, const char *)")
def _on_log(_user, level, number, sentence):
    _note(level, number, ffi.string(sentence).decode("utf-8", "replace"))


@ffi.callback("void(void *, const char *, const char *, int)")
def _on_misuse(_user, expression, file, line):
    text = ffi.string(expression).decode("utf-8", "replace")
    _note("misuse", None, f"misuse: {text} does not hold ({ffi.string(file).decode()}:{line})")


def _install_hooks():
    hooks = ffi.new("bolan_hooks *", lib.bolan_get_hooks())
    hooks.log = _on_log
    hooks.assert_failed = _on_misuse
    lib.bolan_set_hooks(hooks)


_install_hooks()

_CLASSES = {lib.BOLAN_ERROR_ARGUMENT: ArgumentError, lib.BOLAN_ERROR_MEMORY: OutOfMemoryError,
            lib.BOLAN_ERROR_IO: FileError, lib.BOLAN_ERROR_FORMAT: FormatError,
            lib.BOLAN_ERROR_UNSUPPORTED: UnsupportedError, lib.BOLAN_ERROR_GL: GLError}


def _hear(function, arguments):
    """Calls, and returns the result with what the library said. cffi releases the GIL meanwhile."""
    said = _heard.said = []
    try:
        return function(*arguments), said
    finally:
        _heard.said = None


def _tell(said):
    """Passes on what is no error: warnings as BolanWarning, the rest to the logger "bolan"."""
    for kind, _, sentence in said:
        if kind == "misuse":
            raise MisuseError(sentence)
    for kind, _, sentence in said:
        if kind == lib.BOLAN_LOG_INFO:
            log.info("%s", sentence)
    for kind, _, sentence in said:
        if kind == lib.BOLAN_LOG_WARNING:
            warnings.warn(sentence, BolanWarning, stacklevel=4)


def check(function, *arguments):
    """Calls a function that returns a bolan_result, and raises what it reports."""
    result, said = _hear(function, arguments)
    errors = [(number, sentence) for kind, number, sentence in said if kind == lib.BOLAN_LOG_ERROR]
    if result != lib.BOLAN_OK:
        number, sentence = errors[-1] if errors else (None, ffi.string(lib.bolan_result_string(result)).decode())
        raise _CLASSES.get(result, Error)(sentence, number)
    _tell(said)


def call(function, *arguments, error=Error):
    """Calls a function that cannot fail; what it refuses nevertheless is raised as error."""
    result, said = _hear(function, arguments)
    for kind, number, sentence in said:
        if kind == lib.BOLAN_LOG_ERROR:
            raise error(sentence, number)
    _tell(said)
    return result


def c_name(kind):
    """Name of a C type without its tag."""
    return kind.cname.removeprefix("struct ").removeprefix("enum ")


def text(pointer):
    """A C string; None for NULL."""
    return None if pointer == ffi.NULL else ffi.string(pointer).decode("utf-8", "replace")


def path_bytes(path):
    try:
        made = os.fsencode(path)
    except TypeError:
        raise ArgumentError(f"path is {path!r}; expected a path") from None
    if b"\0" in made:
        raise ArgumentError(f"path is {path!r}; expected no NUL in it")
    return made


# ---- objects -------------------------------------------------------------------------------------------------------

class Gate:
    """Many readers or one writer. A reader that comes while a writer waits lets it go first."""

    def __init__(self):
        self._free = threading.Condition(threading.Lock())
        self._readers = 0
        self._writing = False
        self._waiting = 0

    @contextmanager
    def read(self):
        with self._free:
            while self._writing or self._waiting:
                self._free.wait()
            self._readers += 1
        try:
            yield
        finally:
            with self._free:
                self._readers -= 1
                self._free.notify_all()

    @contextmanager
    def write(self):
        with self._free:
            self._waiting += 1
            while self._writing or self._readers:
                self._free.wait()
            self._waiting -= 1
            self._writing = True
        try:
            yield
        finally:
            with self._free:
                self._writing = False
                self._free.notify_all()


# Functions of bolan_io are not thread-safe.
files = threading.RLock()


def _destroyer(kind):
    destroy, new, holder = getattr(lib, kind + "_destroy"), ffi.new, f"{kind} **"  # bound: they outlive the module

    def release(pointer):
        destroy(new(holder, pointer))
    return release


class Pointer:
    """An object of the library, in raw. It is destroyed when nothing in Python refers to raw any more: a call that
    runs on another thread keeps it, and so do arrays over its memory."""

    def __init__(self, kind, create, *arguments):
        """create(*arguments, kind **out) returns a bolan_result."""
        out = ffi.new(f"{kind} **")
        check(create, *arguments, out)
        self.raw = ffi.gc(out[0], _destroyer(kind))


class Closable:
    """An object with close() that is a context manager. After close() every use raises ClosedError."""

    _pointer = None

    def __enter__(self):
        self._get()
        return self

    def __exit__(self, *_):
        self.close()

    def close(self):
        """Lets the object go. A second close() does nothing."""
        self._pointer = None

    @property
    def closed(self) -> bool:
        """Whether close() was called."""
        return self._pointer is None

    def _get(self):
        pointer = self._pointer
        if pointer is None:
            raise ClosedError(f"this {type(self).__name__} is closed")
        return pointer.raw


def documented(*names):
    """Appends the headers' comments of C functions to the docstring of a Python function or class."""
    from ._docs import DOCS

    def append(thing):
        own = (thing.__doc__ or "").rstrip()
        thing.__doc__ = own + "".join(f"\n\n{name}():\n{DOCS[name]}" for name in names)
        return thing
    return append


def version() -> str:
    """Version of the library, "major.minor.patch"."""
    return text(lib.bolan_version())


def memory_in_use() -> int:
    """Memory that the library holds now [bytes]."""
    return lib.bolan_memory_in_use()


@documented("bolan_set_threads")
def set_threads(count: int) -> None:
    """Sets the threads of the library's pool, 1..64, or 0 for one each processor. Call it while no other thread is in
    the library."""
    if not isinstance(count, int) or not 0 <= count <= 64:
        raise ArgumentError(f"threads is {count!r}; expected a whole number from 0 to 64")
    call(lib.bolan_set_threads, count)


def threads() -> int:
    """How many workers a parallel loop may use now."""
    return lib.bolan_threads()
