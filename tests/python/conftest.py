"""What the tests of the Python package share: one robot's figures, and where the built command is."""

import os
import pathlib

import pytest


@pytest.fixture(scope="session")
def command():
    """The `gaitway` of the same build."""
    return pathlib.Path(os.environ["GAITWAY_COMMAND"])
