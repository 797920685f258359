"""The comparison with the peers: what its rounds come to, what is said of a peer that is not there, and which input it refuses.

No timing: that is for `./dev bench --peers` on a quiet machine.
"""

from __future__ import annotations

import json
import pathlib
import subprocess
import sys
from collections.abc import Callable
from typing import Any

import pytest

FOLDER = pathlib.Path(__file__).resolve().parents[2] / "bench/peers"
sys.path.insert(0, str(FOLDER))

import compare  # noqa: E402
from contest import Contest, MeasurementError, NotHereError, Place, counters, json_of  # noqa: E402
from ratios import Pair, Row, figure, table  # noqa: E402


def row(*pairs: tuple[float, float]) -> Row:
    return Row("a leg", "KDL", "µs", [Pair(ours, peer) for ours, peer in pairs])


def test_a_ratio_is_ours_over_the_peers_of_the_same_round() -> None:
    # The machine was three times as slow in the second round: the ratios stay, those of the medians would not.
    measured = row((1.0, 2.0), (3.0, 6.0), (1.0, 4.0))
    assert measured.median == 0.5
    assert measured.spread == (0.25, 0.5)
    assert measured.cells() == ["a leg", "KDL", "1.00 µs", "4.00 µs", "0.500", "0.250 to 0.500", ""]


def test_a_quicker_peer_is_told() -> None:
    assert row((3.0, 2.0)).cells()[4] == "1.50"


@pytest.mark.parametrize(("value", "text"), [(0.0123456, "0.0123"), (0.5, "0.500"), (1.0, "1.00"), (56.78, "56.8"), (99.99, "100"), (0.09999, "0.100"), (123.4, "123")])
def test_figures_have_three_digits(value: float, text: str) -> None:
    assert figure(value) == text


@pytest.mark.parametrize(("ours", "peer"), [(0.0, 1.0), (1.0, 0.0), (-1.0, 1.0), (float("nan"), 1.0), (1.0, float("inf"))])
def test_a_ratio_of_nothing_is_refused(ours: float, peer: float) -> None:
    with pytest.raises(ValueError, match="above zero"):
        Pair(ours, peer)


class Played(Contest):
    """Does in each round what it is given."""

    name = about = "played"

    def __init__(self, place: Place, name: str, log: list[str], rounds: list[Callable[[], Pair]]) -> None:
        super().__init__(place)
        self.name, self._log, self._rounds = name, log, rounds

    def play(self) -> None:
        self._log.append(self.name)
        self.add("row", Row(self.name, "peer", "s"), self._rounds.pop(0)())


def fails(error: Exception) -> Callable[[], Pair]:
    def play() -> Pair:
        raise error

    return play


@pytest.fixture
def place(tmp_path: pathlib.Path) -> Place:
    return Place(FOLDER.parents[1], tmp_path, tmp_path)


def test_rows_take_turns_and_a_failure_ends_its_own_alone(place: Place) -> None:
    log: list[str] = []
    contests = [Played(place, "a", log, [lambda: Pair(1, 2), fails(MeasurementError("it fell"))]),
                Played(place, "b", log, [lambda: Pair(1, 2)] * 3),
                Played(place, "c", log, [fails(NotHereError("apt-get install it"))] * 3),
                Played(place, "d", log, [fails(RuntimeError("a worker died"))])]
    compare.play_all(contests, 3)
    assert log == ["a", "b", "c", "d", "a", "b", "c", "b", "c"]
    rows = [found for contest in contests for found in contest.rows.values()]
    assert [found.broken for found in rows] == ["it fell", "", "", "RuntimeError: a worker died"]
    assert len(rows[1].pairs) == 3
    lines = table(rows).splitlines()[2:]
    assert "| failed: it fell |" in lines[0]
    assert "| 0.500 | 0.500 to 0.500 |" in lines[1]
    assert "| not available here: apt-get install it |" in lines[2]


def run(*arguments: str | pathlib.Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run([sys.executable, FOLDER / "compare.py", *arguments], capture_output=True, text=True, check=False)


@pytest.mark.parametrize(("arguments", "said"), [
    (["--rows", "leg-ik,nothing"], "there is no row 'nothing'; there are leg-ik, loading, topics, wake-up, jitter, chain, vectors"),
    (["--rounds", "0"], "'0' is not a whole number from 1 to 1000"),
    (["--rounds", "five"], "'five' is not a whole number"),
    (["--json", "/no/such/folder/x.json"], "/no/such/folder/x.json: there is no such folder"),
    (["--quick"], "unrecognized arguments: --quick"),
])
def test_bad_input_is_refused_before_anything_is_measured(arguments: list[str], said: str) -> None:
    refused = run(*arguments)
    assert refused.returncode == 1
    assert said in refused.stderr
    assert refused.stdout == ""


def test_help_and_plan() -> None:
    told = run("--help")
    assert told.returncode == 0
    assert all(name in told.stdout for name in compare.CONTESTS)
    planned = run("--plan", "--rows", "topics,chain", "--rounds", "2")
    assert (planned.returncode, planned.stdout) == (0, "2 rounds of topics, chain\n")


# A program that prints what a benchmark would.
PROGRAM = """#!/bin/sh
cat <<'END'
{}
END
exit {}
"""


def program(folder: pathlib.Path, name: str, printed: Any, code: int = 0) -> pathlib.Path:
    path = folder / name
    path.write_text(PROGRAM.format(printed if isinstance(printed, str) else json.dumps(printed), code))
    path.chmod(0o755)
    return path


def test_the_whole_of_it_with_a_peer_that_is_missing(tmp_path: pathlib.Path) -> None:
    program(tmp_path, "topic_peers", {"64 B": {"gaitway": {"ns": 30.0}, "seqlock": {"ns": 15.0}}})
    done = run("--rows", "topics", "--rounds", "2", "--bin", tmp_path, "--json", tmp_path / "out.json")
    assert done.returncode == 0, done.stderr
    assert "| topic of 64 B: write and read | raw seqlock | 30.0 ns | 15.0 ns | 2.00 | 2.00 to 2.00 |  |" in done.stdout
    assert "| iceoryx 2.0 |  |  |  |  | not available here: not there when this was configured" in done.stdout
    assert "round 2 of 2: topics" in done.stderr
    written = json.loads((tmp_path / "out.json").read_text())
    assert written["rounds"] == 2
    assert [found["ratio_median"] for found in written["rows"]] == [2.0, None]
    assert len(written["rows"][0]["rounds"]) == 2
    assert {"processor", "cores", "kernel", "date", "load_before", "load_after"} <= set(written["machine"])


def test_a_measurement_that_fails_is_told_and_counts(tmp_path: pathlib.Path) -> None:
    program(tmp_path, "topic_peers", "iceoryx: 3 of 10 values were read as written", 1)
    done = run("--rows", "topics", "--rounds", "1", "--bin", tmp_path)
    assert done.returncode == 3
    assert "failed: topic_peers ended with 1: iceoryx: 3 of 10 values were read as written" in done.stdout
    done = run("--rows", "wake-up", "--rounds", "1", "--bin", tmp_path / "nowhere")
    assert done.returncode == 3
    assert "core_bench is not there: build the target benchmarks" in done.stdout


def test_counters_of_a_benchmark(tmp_path: pathlib.Path) -> None:
    found = counters(program(tmp_path, "one", {"benchmarks": [{"name": "x", "p50_us": 3.5, "ratio": 2}]}), "x")
    assert (found["p50_us"], found["ratio"]) == (3.5, 2.0)
    with pytest.raises(NotHereError, match="class_loader was not there"):
        counters(program(tmp_path, "skipped", {"benchmarks": [{"name": "x", "error_occurred": True, "error_message": "class_loader was not there"}]}), "x")
    with pytest.raises(MeasurementError, match="0 benchmarks 'x'"):
        counters(program(tmp_path, "none", {"benchmarks": []}), "x")
    with pytest.raises(MeasurementError, match="no JSON"):
        json_of([program(tmp_path, "text", "segmentation fault")])


def test_it_is_typed(tmp_path: pathlib.Path) -> None:
    checked = subprocess.run([sys.executable, "-m", "mypy", "--strict", "--cache-dir", tmp_path, *sorted(FOLDER.glob("*.py"))],
                             capture_output=True, text=True, check=False, cwd=FOLDER.parents[1])
    assert checked.returncode == 0, checked.stdout
