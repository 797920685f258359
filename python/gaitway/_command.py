"""The command `gaitway` of an installed wheel: the program that lies in the package, in the place of this one."""

from __future__ import annotations

import os
import pathlib
import sys


def main() -> None:
    program = pathlib.Path(__file__).resolve().parent / "bin" / "gaitway"
    if not program.exists():
        sys.exit(f"gaitway: {program} is missing: this package was built without the programs")
    os.execv(program, [str(program), *sys.argv[1:]])
