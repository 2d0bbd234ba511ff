# SPDX-License-Identifier: MIT
"""The generated files are those that the public headers give now."""
import pathlib
import sys

import pytest

import bolan
from bolan import _structs
from bolan._library import ffi, lib
from conftest import SOURCE

PACKAGE = pathlib.Path(SOURCE, "bindings/python/bolan")
sys.path.insert(0, str(PACKAGE.parent))
import generate  # noqa: E402

made = generate.generate(pathlib.Path(SOURCE, "include"))


@pytest.mark.parametrize("name", sorted(made))
def test_generated_file_is_up_to_date(name):
    assert (PACKAGE / name).read_text() == made[name], \
        "stale: bindings/python/generate.py include bindings/python/bolan"


def test_every_declared_name_is_in_the_library():
    missing = []
    for name in dir(lib):
        try:
            getattr(lib, name)
        except AttributeError:
            missing.append(name)
    assert not missing and len(dir(lib)) > 250


def test_every_public_function_is_declared():
    text = made["_declarations.h"]
    functions, structs, fields = generate.read_comments(pathlib.Path(SOURCE, "include"))
    assert len(functions) > 200 and len(structs) > 70 and len(fields) > 450
    inline = {"bolan_radians", "bolan_degrees", "bolan_v3", "bolan_dv3"}
    assert [name for name in functions if name not in inline and f"{name}(" not in text] == []


def test_comments_reach_the_docstrings():
    assert "The fork shares the spectrum and all tables with sea" in bolan.Sea.fork.__doc__
    assert "Cannot fail; a water that is not valid is misuse." in bolan.Sea.surface.__doc__
    assert "Significant wave height 4 sqrt(m0) [m], 0..40; default 0." in bolan.WaveSystem.__doc__
    assert "Vertical field of view [deg], 1..150; default 50." in _structs.Camera.__doc__
    for name in bolan.__all__:
        assert getattr(bolan, name).__doc__, name


def test_structs_have_the_fields_of_the_header():
    for name, cls in vars(_structs).items():
        if isinstance(cls, type) and getattr(cls, "_type", None):
            fields = [field for field, _ in ffi.typeof(cls._type).fields]
            assert [name.rstrip("_") for name in cls.__annotations__] == fields, cls


def test_a_field_named_like_a_word_of_python():
    system = bolan.WaveSystem(lambda_=2.5)
    assert system.lambda_ == 2.5 and "lambda_" in dir(system) and system.as_dict()["lambda_"] == 2.5
