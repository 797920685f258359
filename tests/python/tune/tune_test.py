"""Tuning, on trials that are made up: it finds a better gait, goes on to the bit, and says so when nothing was won."""

from __future__ import annotations

import itertools
import json
import pathlib
from collections import deque
from collections.abc import Iterable, Iterator
from typing import Any

import pytest

from gaitway.sweep import trial as trial_module
from gaitway.sweep.complaint import InputError
from gaitway.sweep.engine import Engine
from gaitway.sweep.pool import Member, Report
from gaitway.sweep.store import Store
from gaitway.sweep.trial import Trial, key_of
from gaitway.sweep.work import perform
from gaitway.tune import command
from gaitway.tune.numbers import NUMBERS, by_names
from gaitway.tune.tuning import Plan, tune
from gaitway.tune.verdict import report, tuned_config

Json = dict[str, Any]
TOLD = 0.3


class MadeUpWalks:
    """Walks the better, the nearer lift is to 0.07; the robot's seed adds a little of its own."""

    measures = ("survived",)
    best_lift = 0.07

    def code(self) -> str:
        return "1"

    def probe(self) -> str:
        return "1"

    def check(self, description: Json) -> None:
        pass

    def expected_s(self, description: Json) -> float:
        return 0.0

    def run(self, description: Json) -> Json:
        lift = float(description["parameters"].get("trajectory.lift", "0.0833 h").split()[0])
        own = 0.001 * (description["seed"] * 7919 % 11)
        return {
            "survived": True,
            "mean_speed_m_s": TOLD + 0.01 + own + abs(lift - self.best_lift),
            "mean_side_speed_m_s": 0.0,
            "heading_drift_rad": own,
            "tilt_rms_rad": 0.02 + own,
        }


class NothingToWin(MadeUpWalks):
    best_lift = 0.0833


class Tried:
    def trials(self, parameters: Json, seeds: Iterable[int]) -> Iterator[Trial]:
        for number, seed in enumerate(seeds):
            description = {"seed": seed, "parameters": parameters}
            yield Trial(number, description, {}, key_of("made_up", "1", description))

    def told(self, trial: Trial) -> Json:
        return {"told_m_s": TOLD, "told_side_m_s": 0.0}


class Here:
    """A worker in this process."""

    def __init__(self) -> None:
        self._replies: deque[Report] = deque()
        self._tickets = itertools.count(1)

    def members(self) -> dict[str, Member]:
        return {"here": Member(1, 2)}

    def submit(self, worker: str, request: Json) -> int:
        self._replies.append(Report(next(self._tickets), perform(request)))
        return self._replies[-1].ticket

    def poll(self, timeout_s: float) -> list[Report]:
        return [self._replies.popleft()] if self._replies else []

    def abandon(self, ticket: int) -> None:
        pass

    def trouble(self) -> str:
        return ""

    def __enter__(self) -> Here:
        return self

    def __exit__(self, *_: object) -> None:
        pass


@pytest.fixture
def made_up(monkeypatch: pytest.MonkeyPatch) -> Iterator[pytest.MonkeyPatch]:
    monkeypatch.setitem(trial_module.KINDS, "made_up", f"{__name__}:MadeUpWalks")
    trial_module.kind_of.cache_clear()
    yield monkeypatch
    trial_module.kind_of.cache_clear()


def plan(generations: int = 8, **changed: Any) -> Plan:
    numbers = by_names(["trajectory.lift", "trajectory.absorb"])
    usual = {"numbers": numbers, "generations": generations, "population": 6, "seed": 1, "training": range(1, 4), "held_out": range(101, 111)}
    return Plan(**{**usual, **changed})


def engine(folder: pathlib.Path) -> Engine:
    return Engine("made_up", Here(), Store(folder))


def test_it_finds_what_there_is_to_win(made_up: object, tmp_path: pathlib.Path) -> None:
    tuned = tune(plan(), Tried(), engine(tmp_path / "store"), tmp_path / "state.json", lambda _: None)
    assert tuned.training_cost < 0
    assert abs(float(tuned.parameters["trajectory.lift"].split()[0]) - 0.07) < 0.005
    assert tuned.verdict.reached
    by_name = {one.measure: one for one in tuned.verdict.comparisons}
    assert by_name["speed error, m/s"].verdict == "better"
    assert by_name["tilt, rad RMS"].verdict == "no difference shown"


def test_an_interrupted_search_goes_on_to_the_bit(made_up: object, tmp_path: pathlib.Path) -> None:
    whole = tune(plan(), Tried(), engine(tmp_path / "a"), tmp_path / "a.json", lambda _: None)
    tune(plan(3), Tried(), engine(tmp_path / "b"), tmp_path / "b.json", lambda _: None)
    told: list[str] = []
    resumed = tune(plan(), Tried(), engine(tmp_path / "c"), tmp_path / "b.json", told.append)
    assert resumed == whole
    assert (tmp_path / "a.json").read_bytes() == (tmp_path / "b.json").read_bytes()
    assert len(told) == 5  # three generations were not run again


def test_where_nothing_is_won_it_says_so(made_up: pytest.MonkeyPatch, tmp_path: pathlib.Path) -> None:
    made_up.setitem(trial_module.KINDS, "made_up", f"{__name__}:NothingToWin")
    trial_module.kind_of.cache_clear()
    tuned = tune(plan(2), Tried(), engine(tmp_path / "store"), tmp_path / "state.json", lambda _: None)
    assert not tuned.verdict.reached
    assert "keep the default gait" in report("r", tuned.verdict, {}, tuned.parameters, {"verdict trials": 10})


def test_a_robot_is_never_both_for_the_search_and_the_verdict(made_up: object, tmp_path: pathlib.Path) -> None:
    with pytest.raises(InputError, match="seed 3 is both for training and for the verdict"):
        tune(plan(held_out=range(3, 9)), Tried(), engine(tmp_path / "store"), tmp_path / "state.json", lambda _: None)


def test_the_file_of_another_search_is_refused(made_up: object, tmp_path: pathlib.Path) -> None:
    state = tmp_path / "state.json"
    tune(plan(1), Tried(), engine(tmp_path / "store"), state, lambda _: None)
    with pytest.raises(InputError, match="is of another search: 'seed' was 1 and is 2"):
        tune(plan(1, seed=2), Tried(), engine(tmp_path / "store"), state, lambda _: None)
    state.write_text(json.dumps({"costs": ""})[:5])
    with pytest.raises(InputError, match="Remove it to begin anew"):
        tune(plan(1), Tried(), engine(tmp_path / "store"), state, lambda _: None)


@pytest.mark.parametrize("costs", [5, [[1.0]], [["a"] * 6], [[1e999] * 6], [None], {}, None])
def test_a_file_whose_costs_are_none_is_refused(made_up: object, tmp_path: pathlib.Path, costs: object) -> None:
    state = tmp_path / "state.json"
    tune(plan(1), Tried(), engine(tmp_path / "store"), state, lambda _: None)
    about = json.loads(state.read_text())["about"]
    state.write_text(json.dumps({"about": about, "costs": costs} if costs != {} else [about]))
    with pytest.raises(InputError, match=r"state.json: cannot be read: .* Remove it to begin anew"):
        tune(plan(1), Tried(), engine(tmp_path / "store"), state, lambda _: None)


@pytest.mark.parametrize(
    ("arguments", "complaint"),
    [
        (["--generations", "0"], "--generations 0: must be 1 to 100000"),
        (["--seed", "-1"], "--seed -1: must be 0 to 4294967295"),
        (["--seed", "4294967296"], "--seed 4294967296: must be 0 to"),
        (["--numbers", "trajectory.lift,trajectory.lift"], "--numbers 'trajectory.lift': stands there twice"),
        (["--numbers", ""], "--numbers '': is no number that can be tuned. There are: trajectory.step_time"),
        (["--robot", "r" * 300], f"--robot {'r' * 300}: is neither a shipped one nor a path"),
        (["--config", "HERE"], "lacks.yaml:1: plugins = a list of 0: must be a list"),
        (["--on", "local:²"], "--on local:²: is no place for trials"),
        (["--store", "/proc/none"], "--store /proc/none: "),
        (["--patience", "-1"], "--patience -1.0: must be 0 or more"),
        (["--size", "huge"], "gaitway tune: argument --size: invalid choice"),
    ],
)
def test_bad_input_ends_with_1(arguments: list[str], complaint: str, tmp_path: pathlib.Path, capsys: pytest.CaptureFixture[str]) -> None:
    lacks = tmp_path / "lacks.yaml"
    lacks.write_text("plugins: []\n")
    line = [str(lacks) if word == "HERE" else word for word in arguments]
    usual = ["--robot", "humanoid22", "--out", str(tmp_path / "out"), "--store", str(tmp_path / "store"), "--size", "small"]
    try:
        code = command.main([*usual, *line])
    except SystemExit as end:
        code = int(str(end.code))
    assert code == 1
    assert complaint in capsys.readouterr().err
    assert not list((tmp_path / "store").glob("??/*"))


def test_the_configuration_has_the_numbers_and_all_that_was_there() -> None:
    base = "plugins:\n  - {name: zmp}\n  - {name: trajectory, library: a.so, parameters: {lift: 25 mm, absorb: 0.4 s}}\n"
    text = tuned_config(base, {"trajectory.lift": "0.08 h"}, "what it is")
    assert text.startswith("# what it is\n")
    assert "lift: 0.08 h" in text and "absorb: 0.4 s" in text and "library: a.so" in text
    with pytest.raises(InputError, match="no plug-in 'stability'"):
        tuned_config(base, {"stability.heading_gain": "1 1/T"}, "")


@pytest.mark.parametrize("number", NUMBERS, ids=lambda number: number.parameter)
def test_numbers_begin_at_the_default_and_keep_their_limits(number: Any) -> None:
    assert number.at(0.0) == pytest.approx(number.usual)
    assert number.lowest <= number.at(-50) < number.at(0) < number.at(50) <= number.highest
