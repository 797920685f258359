"""The package of this tree, where no built one is in the path."""

import importlib.util
import pathlib
import sys

if importlib.util.find_spec("gaitway") is None:
    sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "python"))
