# SPDX-License-Identifier: MIT
"""What the tests share."""
import os

import pytest

import bolan

SOURCE = os.environ["BOLAN_SOURCE_DIR"]


@pytest.fixture
def calm():
    """A sea without a wave."""
    with bolan.Sea(bolan.SeaState(), resolution=32) as sea:
        yield sea


@pytest.fixture
def sea():
    """A small sea of a wind."""
    with bolan.Sea(bolan.SeaState.from_wind(12.0, 225.0, 300e3), resolution=64) as sea:
        yield sea


@pytest.fixture(scope="session")
def renderer():
    """A renderer, where there is OpenGL."""
    try:
        made = bolan.Renderer("low")
    except bolan.GLError as error:
        if os.environ.get("BOLAN_REQUIRE_GL") == "1":
            raise
        pytest.skip(f"there is no OpenGL here: {error}")
    yield made
    made.close()
