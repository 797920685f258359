"""`gaitway sweep` as people use it: results, what is known, a plan, a worker that dies, bad input, exit codes."""

from __future__ import annotations

import csv
import json
import os
import pathlib
import signal
import subprocess
import sys
import time

import pytest
from loopback_cluster import SweepRun, stored

from gaitway.sweep import command

SWEEP = "trial: rehearsal\nseeds: 1..15\nparameters: {rounds: [10, 20]}\n"
SLOW = "trial: rehearsal\nseeds: 1..30\nparameters: {sleep_s: [0.1]}\n"


@pytest.fixture
def file(tmp_path: pathlib.Path) -> pathlib.Path:
    place = tmp_path / "sweep.yaml"
    place.write_text(SWEEP)
    return place


def test_a_repeated_sweep_runs_nothing_and_says_the_same(file: pathlib.Path, tmp_path: pathlib.Path) -> None:
    for out, ran in (("first", 30), ("second", 0)):
        run = SweepRun(file, "local:2", tmp_path / out, tmp_path / "store")
        assert run.finish() == 0, run.log.read_text()
        assert run.account()["ran"] == ran
        assert ("worker" in run.log.read_text()) == (ran > 0), "nothing is to be run: nobody is called"
    assert (tmp_path / "first/results.csv").read_bytes() == (tmp_path / "second/results.csv").read_bytes()
    rows = list(csv.DictReader((tmp_path / "first/results.csv").open()))
    assert [int(row["trial"]) for row in rows] == list(range(30))
    assert "| 10 | 15 |" in (tmp_path / "first/results.md").read_text()
    assert json.loads((tmp_path / "first/progress.json").read_text())["ended"] is True
    assert not (tmp_path / "first/partial.csv").exists()


def test_a_local_worker_that_is_killed_is_replaced(tmp_path: pathlib.Path) -> None:
    slow = tmp_path / "slow.yaml"
    slow.write_text(SLOW)
    run = SweepRun(slow, "local:2", tmp_path / "out", tmp_path / "store")
    run.wait_for(3)
    children = pathlib.Path(f"/proc/{run.process.pid}/task/{run.process.pid}/children").read_text().split()
    workers = [int(child) for child in children if "spawn_main" in pathlib.Path(f"/proc/{child}/cmdline").read_text()]
    os.kill(workers[0], signal.SIGKILL)
    assert run.finish() == 0, run.log.read_text()
    assert "has gone" in run.log.read_text()
    assert stored(tmp_path / "store") == 30


def test_local_workers_end_with_their_client(tmp_path: pathlib.Path) -> None:
    slow = tmp_path / "slow.yaml"
    slow.write_text(SLOW)
    run = SweepRun(slow, "local:2", tmp_path / "out", tmp_path / "store")
    run.wait_for(3)
    children = pathlib.Path(f"/proc/{run.process.pid}/task/{run.process.pid}/children").read_text().split()
    run.process.kill()
    run.process.wait()
    end = time.monotonic() + 20
    while any(pathlib.Path(f"/proc/{child}").exists() for child in children):
        assert time.monotonic() < end, "workers live on"
        time.sleep(0.05)


def test_a_plan_runs_nothing(file: pathlib.Path, tmp_path: pathlib.Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert command.main([str(file), "--plan", "--store", str(tmp_path / "store"), "--out", str(tmp_path / "out")]) == 0
    said = capsys.readouterr().out
    assert said.startswith("30 trials: 15 seed")
    assert "nothing was run" in said
    assert stored(tmp_path / "store") == 0
    assert not (tmp_path / "out").exists()


def test_a_plan_of_a_million_trials_is_quick(tmp_path: pathlib.Path, capsys: pytest.CaptureFixture[str]) -> None:
    place = tmp_path / "sweep.yaml"
    place.write_text("trial: rehearsal\nseeds: 1..1000\nparameters: {rounds: {from: 1, to: 1000, steps: 1000}, sleep_s: [1]}\n")
    began = time.process_time()
    assert command.main([str(place), "--plan", "--store", str(tmp_path / "store")]) == 0
    assert time.process_time() - began < 5.0
    said = capsys.readouterr().out
    assert said.startswith("1000000 trials: 1000 seed, 1000 points of 2 parameters")
    assert "about 0 of them are known; the others take about 277:5" in said


@pytest.mark.parametrize(
    ("arguments", "complaint"),
    [
        (["none.yaml"], "none.yaml: No such file"),
        (["FILE", "--on", "ray://here"], "--on ray://here: is no place for trials. There are: local, local:N"),
        (["FILE", "--on", "local:0"], "--on local:0"),
        (["FILE", "--out", "/proc/none"], "--out /proc/none"),
        (["FILE", "--patience", "nan"], "--patience nan"),
        (["FILE", "--on", "local:²"], "--on local:²: is no place for trials"),
        (["FILE", "--on", "ray://here", "--plan"], "--on ray://here: is no place for trials"),
        (["FILE", "--store", "/proc/sys"], "--store /proc/sys: "),
        (["f" * 300], "File name too long"),
        (["WRONG"], "parameters.rounds[1]: '-1' cannot run: rounds = -1: must be a number, 1 to 1e+09"),
    ],
)
def test_bad_input_ends_with_1(
    arguments: list[str], complaint: str, file: pathlib.Path, tmp_path: pathlib.Path, capsys: pytest.CaptureFixture[str]
) -> None:
    wrong = tmp_path / "wrong.yaml"
    wrong.write_text("trial: rehearsal\nseeds: 1..3\nparameters: {rounds: [5, -1]}\n")
    line = ["--store", str(tmp_path / "store"), *({"FILE": str(file), "WRONG": str(wrong)}.get(word, word) for word in arguments)]
    assert command.main(line) == 1
    assert complaint in capsys.readouterr().err
    assert stored(tmp_path / "store") == 0


def test_a_trial_that_nobody_can_run_is_a_result(tmp_path: pathlib.Path) -> None:
    place = tmp_path / "sweep.yaml"
    place.write_text("trial: rehearsal\nseeds: 1..3\nparameters: {error_share: [0, 1]}\n")
    run = SweepRun(place, "local:1", tmp_path / "out", tmp_path / "store")
    assert run.finish() == 0, run.log.read_text()
    rows = list(csv.DictReader((tmp_path / "out/results.csv").open()))
    assert [bool(row["error"]) for row in rows] == [False] * 3 + [True] * 3


def test_no_scheduler_is_said_in_time(file: pathlib.Path, tmp_path: pathlib.Path) -> None:
    run = SweepRun(file, "dask://127.0.0.1:9", tmp_path / "out", tmp_path / "store", "--patience", "2")
    assert run.finish() == 3
    assert "no scheduler answers at tcp://127.0.0.1:9" in run.log.read_text()


def start(*arguments: str, before: str = "") -> subprocess.Popen[str]:
    """As `gaitway sweep` of a wheel begins. `before`: Python that runs first."""
    code = f"import sys; sys.argv = ['gaitway-sweep', *{list(arguments)!r}]\n{before}\nfrom gaitway import _start; sys.exit(_start.sweep())"
    return subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def test_what_is_not_installed_is_told_in_a_line() -> None:
    process = start("any.yaml", before="sys.modules['yaml'] = None")
    out, err = process.communicate(timeout=60)
    assert (process.returncode, out) == (1, "")
    assert err == "gaitway sweep: sweep files need PyYAML. Install the wheel with it: pip install 'gaitway-….whl[sweep]'\n"


INTERRUPTED = """
import importlib, os, signal
def instead(name, real=importlib.import_module):
    os.kill(os.getpid(), signal.SIGINT)
    return real(name)
importlib.import_module = instead
"""


def test_an_interrupt_before_anything_is_under_way_is_no_traceback() -> None:
    process = start("--help", before=INTERRUPTED)
    assert process.communicate(timeout=60) == ("", "")
    assert process.returncode == -signal.SIGINT


def test_an_interrupt_of_a_script_does_not_end_what_it_runs_in_the_background() -> None:
    process = start("--help", before=f"{INTERRUPTED}\nsignal.signal(signal.SIGINT, signal.SIG_IGN)")
    out, err = process.communicate(timeout=60)
    assert (process.returncode, err) == (0, "")
    assert out.startswith("usage: gaitway sweep")


def test_a_mean_says_of_how_many_trials_it_is(tmp_path: pathlib.Path) -> None:
    place = tmp_path / "sweep.yaml"
    place.write_text("trial: rehearsal\nseeds: 1..20\nparameters: {error_share: [0.5]}\n")
    run = SweepRun(place, "local:1", tmp_path / "out", tmp_path / "store")
    assert run.finish() == 0, run.log.read_text()
    failed = run.account()["with_error"]
    assert 0 < failed < 20
    assert f" ({20 - failed} of 20) | {failed} |" in (tmp_path / "out/results.md").read_text()


def test_an_interrupt_while_workers_begin_is_the_clients(tmp_path: pathlib.Path) -> None:
    slow = tmp_path / "slow.yaml"
    slow.write_text("trial: rehearsal\nseeds: 1..300\nparameters: {sleep_s: [0.1]}\n")
    run = SweepRun(slow, "local:2", tmp_path / "out", tmp_path / "store", own_group=True)
    children = pathlib.Path(f"/proc/{run.process.pid}/task/{run.process.pid}/children")
    end = time.monotonic() + 60

    def loading(child: str) -> bool:
        """Its interpreter runs, and it has not got as far as its requests."""
        process = pathlib.Path("/proc") / child
        return "spawn_main" in (process / "cmdline").read_text() and "lib-dynload" in (process / "maps").read_text()

    while not any(map(loading, children.read_text().split())):
        assert time.monotonic() < end and run.process.poll() is None, run.log.read_text()
        time.sleep(0.001)
    os.killpg(run.process.pid, signal.SIGINT)  # as a terminal does
    assert run.finish() == 3
    assert "Traceback" not in run.log.read_text()
    assert "interrupted. What has run is stored" in run.log.read_text()
