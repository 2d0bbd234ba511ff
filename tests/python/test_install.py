# SPDX-License-Identifier: MIT
"""pip installs the package without a network and without a compiler, and it finds the library."""
import importlib.util
import os
import pathlib
import shutil
import subprocess
import sys

import pytest

from conftest import SOURCE

LIBRARY = pathlib.Path(os.environ["BOLAN_LIBRARY"])


@pytest.fixture(scope="module")
def installed(tmp_path_factory):
    for module in ("pip", "setuptools", "wheel"):
        if importlib.util.find_spec(module) is None:
            pytest.skip(f"python3-{module} is not installed")
    folder = tmp_path_factory.mktemp("install")
    shutil.copytree(pathlib.Path(SOURCE, "bindings/python"), folder / "source")
    environment = {**os.environ, "CC": "/there/is/no/compiler", "PIP_CONFIG_FILE": os.devnull}
    subprocess.run([sys.executable, "-m", "pip", "install", "-q", "--no-index", "--no-build-isolation", "--no-deps",
                    "--target", folder / "site", folder / "source"], env=environment, check=True)
    return folder / "site"


def said(code, site, **environment):
    kept = {k: v for k, v in os.environ.items() if k not in ("BOLAN_LIBRARY", "PYTHONPATH", "LD_LIBRARY_PATH")}
    return subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, cwd=site.parent,
                          env={**kept, "PYTHONPATH": str(site), **environment})


CODE = "import bolan; print(bolan.__file__, bolan.version(), bolan.SeaState.from_wind(8, 0).summary().hs > 1)"


def test_everything_is_there(installed):
    names = sorted(path.name for path in (installed / "bolan").iterdir() if path.name != "__pycache__")
    sources = sorted(path.name for path in pathlib.Path(SOURCE, "bindings/python/bolan").iterdir()
                     if path.name != "__pycache__")
    assert names == sources and "py.typed" in names


def test_without_a_library_it_says_where_it_looked(installed):
    ran = said(CODE, installed)
    if ran.returncode == 0:
        pytest.skip("a libbolan_all is installed on this system")
    assert "libbolan_all.so is not found" in ran.stderr and "Set BOLAN_LIBRARY to its path" in ran.stderr


def test_library_of_the_environment(installed):
    assert said(CODE, installed, BOLAN_LIBRARY=str(LIBRARY)).stdout.endswith("0.2.0 True\n")


def test_library_of_the_system(installed, tmp_path):
    shutil.copy(LIBRARY, tmp_path / "libbolan_all.so.0.2")
    assert said(CODE, installed, LD_LIBRARY_PATH=str(tmp_path)).stdout.endswith("0.2.0 True\n")


def test_library_beside_the_package(installed):
    shutil.copy(LIBRARY, installed / "bolan" / "libbolan_all.so")
    ran = said(CODE, installed)
    (installed / "bolan" / "libbolan_all.so").unlink()
    assert ran.stdout == f"{installed}/bolan/__init__.py 0.2.0 True\n"
