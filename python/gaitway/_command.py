"""The command `gaitway` of an installed wheel: the program that lies in the package, in the place of this one."""

from __future__ import annotations

import os
import pathlib
import sys


def main() -> None:
    program = pathlib.Path(__file__).resolve().parent / "bin" / "gaitway"
    if not program.exists():
        sys.exit(f"gaitway: {program} is missing: this package was built without the programs")
    # What else came with the package, such as gaitway-sweep, lies beside this interpreter, whether or not the path says so.
    os.environ["PATH"] = os.pathsep.join([str(pathlib.Path(sys.executable).parent), os.environ.get("PATH", os.defpath)])
    os.environ.setdefault("GAITWAY_PYTHON", sys.executable)  # for plug-ins in Python
    os.execv(program, [str(program), *sys.argv[1:]])
