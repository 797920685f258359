"""mypy finds nothing in the package, something in a program that misuses it, and stubs that say what the module has."""

import os
import pathlib
import subprocess
import sys

PACKAGE = pathlib.Path(__file__).parents[2] / "python" / "gaitway"

WRONG = """
import gaitway

robot = gaitway.Robot(seed="three")
robot.walk("fast")
robot.no_such()
walks: str = robot.time_s
"""


def mypy(*arguments, **environment):
    return subprocess.run([sys.executable, "-m", *arguments], capture_output=True, text=True, check=False,
                          env={**os.environ, **environment})


def test_the_package_is_typed(tmp_path):
    result = mypy("mypy", "--strict", "--cache-dir", tmp_path, PACKAGE, MYPYPATH="")
    assert result.returncode == 0, result.stdout
    program = tmp_path / "program.py"
    program.write_text(WRONG)
    result = mypy("mypy", "--strict", "--cache-dir", tmp_path, program, MYPYPATH=str(PACKAGE.parent))
    assert result.returncode == 1
    assert [int(line.split(":")[1]) for line in result.stdout.splitlines() if ": error:" in line] == [4, 5, 6, 7], result.stdout


def test_stubs_are_the_module(tmp_path):
    allowed = tmp_path / "allowed"  # names of types that the module has no object for
    allowed.write_text("gaitway._native.RawField\ngaitway._native.RawTopic\ngaitway._native.View.__buffer__\n")
    result = mypy("mypy.stubtest", "gaitway._native", "--ignore-positional-only", "--ignore-missing-stub", "--allowlist", allowed)
    assert result.returncode == 0, result.stdout
