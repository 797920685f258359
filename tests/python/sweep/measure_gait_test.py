"""`gaitway measure gait --on PLACE`: the table and each trial's outcome are those of a measurement without it, to the byte,
wherever the trials ran and whatever died; what is stored does not run again."""

from __future__ import annotations

import json
import os
import pathlib
import re
import signal
import subprocess
import time
from collections.abc import Iterator

import pytest

from gaitway.measure.gait_series import GaitSeries, Player, program, shipped_or_path
from gaitway.sweep.complaint import UnfitWorkerError
from loopback_cluster import Cluster, environment, stored

TABLE = ("--quick", "--seeds", "2", "--rows", "push_front,push_side")
RESULTS = ("gait.json", "gait.md", "gait.html")


class Measurement:
    """`gaitway measure gait` as a process of its own."""

    def __init__(self, out: pathlib.Path, *options: str) -> None:
        self.out, self.log = out, out.with_suffix(".log")
        with self.log.open("ab") as log:
            self.process = subprocess.Popen(
                [os.environ["GAITWAY_COMMAND"], "measure", "gait", *TABLE, "--out", str(out), *options],
                env=environment(), stdout=log, stderr=log,
            )

    def finish(self, timeout_s: float = 200.0) -> int:
        try:
            return self.process.wait(timeout_s)
        except subprocess.TimeoutExpired:
            self.process.kill()
            raise AssertionError(f"the measurement does not end: {self.words()}") from None

    def words(self) -> str:
        return self.log.read_text()

    def count(self) -> tuple[int, int]:
        """Trials that ran, and that were known."""
        found = re.findall(r"(\d+) trials run, (\d+) known", self.words())
        assert found, self.words()
        return int(found[-1][0]), int(found[-1][1])

    def outcomes(self) -> dict[str, str]:
        lines = (self.out / "trials.jsonl").read_text().splitlines()
        return {json.loads(line)["key"]: line for line in lines}


def children_of(process: int) -> list[int]:
    return [int(child) for child in pathlib.Path(f"/proc/{process}/task/{process}/children").read_text().split()]


def wait_for(store: pathlib.Path, results: int, measurement: Measurement) -> None:
    end = time.monotonic() + 100
    while stored(store) < results:
        assert time.monotonic() < end and measurement.process.poll() is None, measurement.words()
        time.sleep(0.02)


@pytest.fixture(scope="module")
def here(tmp_path_factory: pytest.TempPathFactory) -> Measurement:
    measurement = Measurement(tmp_path_factory.mktemp("here") / "out", "--jobs", "2")
    assert measurement.finish() in (0, 3), measurement.words()
    return measurement


@pytest.fixture
def cluster(tmp_path: pathlib.Path) -> Iterator[Cluster]:
    with Cluster(tmp_path / "cluster") as one:
        yield one


def assert_equal(measurement: Measurement, here: Measurement) -> None:
    for name in RESULTS:
        assert (measurement.out / name).read_bytes() == (here.out / name).read_bytes()
    mine, theirs = measurement.outcomes(), here.outcomes()
    both = mine.keys() & theirs.keys()  # what is given up when a level is decided depends on who was how fast
    assert len(both) >= 8
    assert {key: mine[key] for key in both} == {key: theirs[key] for key in both}


def test_a_client_that_is_killed_goes_on_and_what_is_stored_does_not_run_again(here: Measurement, tmp_path: pathlib.Path) -> None:
    store = tmp_path / "store"
    options = ("--on", "local:2", "--store", str(store))
    killed = Measurement(tmp_path / "out", *options)
    wait_for(store, 2, killed)
    [trial_program] = children_of(killed.process.pid)
    workers = children_of(trial_program)
    killed.process.kill()
    killed.process.wait()
    end = time.monotonic() + 30
    while any(pathlib.Path(f"/proc/{one}").exists() for one in (trial_program, *workers)):
        assert time.monotonic() < end, "they live on"
        time.sleep(0.05)

    resumed = Measurement(tmp_path / "out", *options)
    assert resumed.finish() == here.process.returncode, resumed.words()
    assert resumed.count()[1] >= 2
    assert "ran a second time elsewhere, with equal results" in resumed.words()
    assert_equal(resumed, here)

    repeated = Measurement(tmp_path / "anew", *options)
    assert repeated.finish() == here.process.returncode, repeated.words()
    assert repeated.count()[0] == 0
    assert_equal(repeated, here)


def test_a_worker_of_a_cluster_that_is_killed_costs_what_it_ran(here: Measurement, cluster: Cluster, tmp_path: pathlib.Path) -> None:
    for _ in range(2):
        cluster.start_worker()
    cluster.wait_for_workers(2)
    store = tmp_path / "store"
    measurement = Measurement(tmp_path / "out", "--on", f"dask://{cluster.address}", "--store", str(store))
    wait_for(store, 2, measurement)
    os.kill(cluster.workers[0].pid, signal.SIGKILL)
    cluster.start_worker()
    assert measurement.finish() == here.process.returncode, measurement.words()
    assert "has gone" in measurement.words()
    assert_equal(measurement, here)


@pytest.mark.parametrize(
    ("options", "exit_code", "complaint"),
    [
        (("--on", "ray://here"), 1, "--on ray://here: is no place for trials. There are: local, local:N"),
        (("--on", "local:0"), 1, "--on local:0"),
        (("--on", "local:1", "--store", "/proc/none"), 1, "--store /proc/none"),
        (("--on", "local:1", "--rows", "push_frnt"), 1, "no row 'push_frnt'. Did you mean 'push_front'"),
        (("--on", "dask://127.0.0.1:9", "--patience", "1"), 6, "no scheduler answers at tcp://127.0.0.1:9"),
    ],
)
def test_what_goes_wrong_is_told(options: tuple[str, ...], exit_code: int, complaint: str, tmp_path: pathlib.Path) -> None:
    measurement = Measurement(tmp_path / "out", *options)
    assert measurement.finish() == exit_code, measurement.words()
    assert complaint in measurement.words()
    assert not (tmp_path / "out" / "gait.json").exists()


def description(**more: object) -> dict[str, object]:
    """Of one short trial."""
    robot = shipped_or_path("robot", str(program().parents[1] / "share/gaitway/urdf/humanoid22"))
    assert robot == "humanoid22"
    subject = {"robot": robot, "config": "walk", "quick": True, "fingerprint": fingerprint()}
    return {**subject, "row": "push_front", "level": 0.5, "seed": 3, "first": 0, "count": 1, "seconds": 6.1, **more}


def fingerprint() -> str:
    line = [program(), "measure", "gait", "--quick", "--plays-series"]
    hello = subprocess.run(line, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, check=True).stdout
    return json.loads(hello)["fingerprint"]


def test_a_worker_with_another_robot_or_without_it_is_unfit() -> None:
    trials = GaitSeries()
    with pytest.raises(UnfitWorkerError, match="its robot humanoid22, configuration walk, plug-ins or libraries are others"):
        trials.run(description(fingerprint="0123456789abcdef"))
    with pytest.raises(UnfitWorkerError, match="has no robot /nowhere"):
        trials.run(description(robot="/nowhere"))
    with pytest.raises(UnfitWorkerError, match=r"cannot play the trials of row push_north.*no row 'push_north'"):
        trials.run(description(row="push_north"))
    with pytest.raises(UnfitWorkerError, match=r"trials 1 to 2: a seed of 'push_front' has 1"):
        trials.run(description(first=1))


def test_a_playing_process_that_is_killed_is_replaced_once(monkeypatch: pytest.MonkeyPatch) -> None:
    made: list[Player] = []
    play = Player.play

    def mortal(player: Player, series: dict[str, object]) -> list[dict[str, object]]:
        made.append(player)
        if len(made) == 1:
            player._process.kill()
        return play(player, series)

    monkeypatch.setattr(Player, "play", mortal)
    trials = GaitSeries()
    [outcome] = trials.run(description())["outcomes"]
    assert outcome["fell"] is False
    assert len(made) == 2
    made.clear()
    monkeypatch.setattr("gaitway.measure.gait_series.TRIES", 1)
    with pytest.raises(UnfitWorkerError, match="gaitway-measure ended with signal 9"):
        trials.run(description())
