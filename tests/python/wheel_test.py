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
sys.path.insert(0, str(TREE / "python" / "packaging"))
import licences  # noqa: E402
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


def dist_info(installed):
    (info,) = (installed / "venv").glob("lib/python3*/site-packages/gaitway-*.dist-info")
    return info


def test_everything_bundled_has_its_licence(installed):
    info = dist_info(installed)
    headers = (info / "METADATA").read_text().partition("\n\n")[0]
    files = re.findall(r"^License-File: (.+)$", headers, re.MULTILINE)
    assert "LICENSE" in files and "NOTICE" in files
    assert all((info / "licenses" / file).stat().st_size > 0 for file in files)
    known = {one["name"]: one for one in json.loads((info / "licenses" / "third_party" / "third_party.json").read_text())}
    bundled = {file.name for file in (info.parent / "gaitway" / "lib" / "gaitway").glob("*.so*") if not file.name.startswith("libgaitway_")}
    assert {"liborocos-kdl.so.1.5", "libmujoco.so.4.0.0"} <= bundled
    assert bundled == {name for name in known if ".so" in name}
    notice, (expression,) = (info / "licenses" / "NOTICE").read_text(), re.findall(r"^License-Expression: (.+)$", headers, re.MULTILINE)
    for name, one in known.items():
        assert one["texts"] and {f"third_party/{text}" for text in one["texts"]} <= set(files)
        assert any(line.startswith(f"{name} ") and one["licence"] in line for line in notice.splitlines())
        assert set(one["licence"].split(" AND ")) <= set(expression.split(" AND ")) & set(licences.PERMITTED)
    assert "GNU LESSER GENERAL PUBLIC LICENSE" in (info / "licenses" / "third_party" / "LGPL-2.1.txt").read_text()


def test_no_sparse_solver_of_the_gpl_is_in_it(installed):
    """What Ceres is used for works without, as it does in the build."""
    package = dist_info(installed).parent / "gaitway"
    for file in [*(package / "bin").iterdir(), *(package / "lib" / "gaitway").rglob("*.so*")]:
        assert not re.search("cholmod|spqr|cxsparse|suitesparse", file.name)
        assert not re.search("cholmod|spqr|cxsparse|suitesparse",
                             subprocess.run(["readelf", "-d", file], check=True, capture_output=True, text=True).stdout)
    built = [os.environ["GAITWAY_COMMAND"], "motion", "plan", "squat"]
    planned = run(installed, "gaitway", "motion", "plan", "squat").stdout
    assert planned == subprocess.run(built, check=True, capture_output=True, text=True).stdout and planned.count("\n") > 100
    run(installed, "gaitway", "calibrate", "--simulate", "--rounds", "1", "--record", "poses.yaml", "--out", "simulated.yaml", "--quiet")
    again = ["calibrate", "--measurements", installed / "poses.yaml", "--quiet", "--out"]
    run(installed, "gaitway", *again, installed / "of_wheel.yaml")
    subprocess.run([os.environ["GAITWAY_COMMAND"], *again, installed / "of_build.yaml"], check=True)
    of_wheel, of_build = (re.sub("^made: .*", "", (installed / name).read_text(), flags=re.MULTILINE)
                          for name in ("of_wheel.yaml", "of_build.yaml"))
    assert of_wheel == of_build and "deviation" in of_wheel


def test_what_may_not_be_packaged_is_refused_by_name(tmp_path, monkeypatch):
    def refused(library, tells):
        (found,) = [line.split(" => ")[1] for line in subprocess.run(["ldconfig", "-p"], check=True, capture_output=True, text=True,
                                                                      env={"PATH": "/usr/sbin:/sbin:/usr/bin"}).stdout.splitlines()
                    if line.split()[0] == library]
        with pytest.raises(SystemExit, match=tells):
            licences.write(tmp_path, {library: pathlib.Path(found).resolve()}, tmp_path)

    refused("libspqr.so.2", "libspqr.so.2 is under GPL-2.0-or-later, which this package does not carry")
    monkeypatch.delitem(licences.OF_SOURCE, "fmtlib")
    refused("libfmt.so.9", "libfmt.so.9 comes from Debian's fmtlib, whose licence is not in licences.py")
    stray = tmp_path / "libstray.so.1"
    stray.write_bytes(b"")
    with pytest.raises(SystemExit, match="libstray.so.1: no Debian package has"):
        licences.write(tmp_path, {"libstray.so.1": stray}, tmp_path)
    with pytest.raises(SystemExit, match="libmujoco.so.4.0.0: its licences are not in .*./dev setup"):
        licences.write(tmp_path, {"libmujoco.so.4.0.0": stray}, tmp_path / "nowhere")


def test_programs_of_python_are_found_beside_the_interpreter(installed):
    libraries = str(pathlib.Path(numpy.__file__).parents[1])
    (installed / "sweep.yaml").write_text("seeds: 1..3\nseconds: 1\n")
    assert "3 trials" in run(installed, "gaitway", "sweep", "sweep.yaml", "--plan", "--store", "store", PYTHONPATH=libraries).stdout
    measured = run(installed, "gaitway", "measure", "gait", "--quick", "--seeds", "1", "--rows", "push_front", "--on", "local:1",
                   "--store", "store", "--out", "gait", PYTHONPATH=libraries).stdout
    assert "0 known from gait/trials.jsonl or the store" in measured


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
