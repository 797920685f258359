"""The wheel stands alone: in a fresh environment without any of the build's variables the robot walks, and nothing is loaded
from outside but what every Debian with Python has."""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import venv

import numpy
import pytest

TREE = pathlib.Path(__file__).parents[2]
ON_EVERY_MACHINE = re.compile(r"^(ld-linux.*|lib(c|m|dl|rt|pthread|resolv|util|gcc_s|stdc\+\+|z|crypto|ssl|lzma|expat|ffi|python3.*)\.so.*)$")


@pytest.fixture(scope="module")
def installed(tmp_path_factory):
    folder = tmp_path_factory.mktemp("wheel")
    stage = folder / "stage" / "gaitway"
    for component in ([], ["--component", "python"]):
        subprocess.run([os.environ["GAITWAY_CMAKE"], "--install", os.environ["GAITWAY_BUILD"], "--prefix", stage, "--strip", *component],
                       check=True, capture_output=True)
    subprocess.run([sys.executable, TREE / "python" / "packaging" / "make_wheel.py", TREE, folder / "stage", folder], check=True)
    shutil.rmtree(folder / "stage")
    (wheel,) = folder.glob("*.whl")
    venv.create(folder / "venv", with_pip=False)
    python = folder / "venv" / "bin" / "python"
    subprocess.run([sys.executable, "-m", "pip", "--python", python, "install", "--quiet", "--no-deps", "--no-index",
                    "--disable-pip-version-check", wheel], check=True)
    yield folder
    shutil.rmtree(folder)


def run(installed, program, *arguments, **environment):
    """With an empty environment, but for what is given."""
    return subprocess.run([installed / "venv" / "bin" / program, *arguments], env=environment, cwd=installed, check=True,
                          capture_output=True, text=True)


def test_the_command_walks(installed):
    run(installed, "gaitway", "run", "--seconds", "4", "--seed", "3", "--out", "out", "--quiet", "--no-pictures")
    summary = json.loads((installed / "out" / "summary.json").read_text())
    assert summary["ended"]
    code = ("import gaitway\nrobot = gaitway.Robot(seed=3)\nrobot.run(1.0)\nrobot.walk(0.15)\nrobot.run(3.0)\nprint(robot.digest)\n"
            "print(*sorted({line.split(None, 5)[5].strip() for line in open('/proc/self/maps') if '.so' in line}), sep='\\n')")
    told = run(installed, "python", "-c", code, PYTHONPATH=str(pathlib.Path(numpy.__file__).parents[1])).stdout.splitlines()
    assert told[0] == summary["digest"]
    site = str(installed / "venv")
    outside = [line for line in told[1:] if line.startswith("/") and not line.startswith((site, sys.base_prefix, "/memfd:"))
               and "site-packages" not in line and not ON_EVERY_MACHINE.match(pathlib.Path(line).name)]
    assert [line for line in outside if "lib-dynload" not in line] == []


def test_every_program_has_its_libraries(installed):
    (package,) = (installed / "venv").glob("lib/python3*/site-packages/gaitway")
    programs = [file for file in (package / "bin").iterdir()]
    assert {"gaitway", "gaitway-measure", "gaitway-serve", "main_controller", "gaitway_python_child"} <= {file.name for file in programs}
    for file in [*programs, *(package / "lib" / "gaitway").glob("*.so*"), *package.glob("_native*.so")]:
        listing = subprocess.run(["ldd", file], check=True, capture_output=True, text=True, env={"PATH": "/usr/bin:/bin"}).stdout
        for line in listing.splitlines():
            name, arrow, place = line.strip().partition(" => ")
            if arrow and not ON_EVERY_MACHINE.match(name):
                assert place.startswith(str(package)), f"{file.name}: {line}"


def test_programs_of_python_are_found_beside_the_interpreter(installed):
    libraries = str(pathlib.Path(numpy.__file__).parents[1])
    (installed / "sweep.yaml").write_text("seeds: 1..3\nseconds: 1\n")
    assert "3 trials" in run(installed, "gaitway", "sweep", "sweep.yaml", "--plan", "--store", "store", PYTHONPATH=libraries).stdout


def test_other_commands_and_missing_arguments(installed):
    assert run(installed, "gaitway", "--version").stdout == "0.1.0\n"
    assert "boxes" in run(installed, "gaitway", "world", "list").stdout
    failed = subprocess.run([installed / "venv" / "bin" / "gaitway", "run", "--config", "no_such"], env={}, check=False, capture_output=True)
    assert failed.returncode == 1


def test_the_wheel_holds_what_it_should(installed):
    (package,) = (installed / "venv").glob("lib/python3*/site-packages/gaitway")
    assert (package / "py.typed").exists() and (package / "_native.pyi").exists()
    assert (package / "share" / "gaitway" / "urdf" / "humanoid22" / "motions").is_dir()
    assert not (package / "include").exists() and not list((package / "lib" / "gaitway").glob("*.a"))
    (info,) = package.parent.glob("gaitway-*.dist-info")
    metadata = (info / "METADATA").read_text()
    assert "Provides-Extra: gym" in metadata and "Requires-Dist: numpy" in metadata
