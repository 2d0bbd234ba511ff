# SPDX-License-Identifier: MIT
"""run.py TEST-FILE: runs one file of tests by pytest. Exits 77 where a package is missing, and says so."""
import importlib
import os
import sys

NEEDED = {"numpy": "python3-numpy", "cffi": "python3-cffi", "pytest": "python3-pytest"}

missing = []
for module, package in NEEDED.items():
    try:
        importlib.import_module(module)
    except ImportError:
        missing.append(package)
if missing:
    print(f"skipped: the tests of the Python package need {' and '.join(missing)}")
    sys.exit(77)

import pytest  # noqa: E402

folder = os.path.dirname(os.path.abspath(__file__))
sys.exit(pytest.main(["-q", "-p", "no:cacheprovider", "--rootdir", folder, os.path.join(folder, sys.argv[1])]))
