"""mypy finds nothing in the package, something in a program that misuses it, and stubs that say what the module has."""

import ast
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


def declared(stub):
    """{class.function: names of its arguments} of a stub, but for errors and operators that types bring along."""
    found = {}

    def look(nodes, prefix):
        for node in nodes:
            if isinstance(node, ast.ClassDef):
                found[prefix + node.name] = None
                look(node.body, prefix + node.name + ".")
            elif isinstance(node, ast.FunctionDef) and (not node.name.startswith("__") or node.name == "__init__"):
                found[prefix + node.name] = [argument.arg for argument in (*node.args.posonlyargs, *node.args.args)]

    look(ast.parse(stub).body, "")
    return {name: arguments for name, arguments in found.items() if not name.endswith("Error.__init__")}


def test_stubs_are_the_module(tmp_path):
    generated = tmp_path / "generated.pyi"
    subprocess.run([sys.executable, "-m", "nanobind.stubgen", "-q", "-m", "gaitway._native", "-o", generated], check=True)
    ours, theirs = declared((PACKAGE / "_native.pyi").read_text()), declared(generated.read_text())
    assert len(ours) > 40
    assert ours == theirs
