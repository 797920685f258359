"""Trials of the robot: the figures and the digest of `gaitway run`, and parameters that reach the plug-ins."""

from __future__ import annotations

import json
import os
import pathlib
import subprocess

import pytest

from gaitway.sweep.complaint import ImpossibleError, InputError
from gaitway.sweep.check import check_values
from gaitway.sweep.robot_trial import RobotTrials
from gaitway.sweep.store import Store
from gaitway.sweep.sweep_file import read_sweep


def trials_of(folder: pathlib.Path, text: str) -> list[dict[str, object]]:
    file = folder / "sweep.yaml"
    file.write_text(text)
    return [trial.description for trial in read_sweep(file).trials()]


def run_of(*arguments: str, folder: pathlib.Path) -> dict[str, object]:
    """Its summary."""
    subprocess.run([os.environ["GAITWAY_COMMAND"], "run", *arguments, "--quiet", "--no-pictures", "--out", str(folder)], check=False)
    return json.loads((folder / "summary.json").read_text())


def test_a_trial_is_a_run(tmp_path: pathlib.Path) -> None:
    [description] = trials_of(tmp_path, "seeds: [3]\nseconds: 5\n")
    result = RobotTrials().run(description)
    summary = run_of("--seed", "3", "--seconds", "5", folder=tmp_path / "run")
    assert result["digest"] == summary["digest"]
    for measure in ("distance_m", "mean_speed_m_s", "mean_side_speed_m_s", "lateral_drift_m", "heading_drift_rad", "commanded_m"):
        assert result[measure] == pytest.approx(summary[measure], abs=1e-9), measure
    assert result["handed_over"] == summary["batches"]["handed_over"]


def test_a_speed_that_was_never_measured_is_none(tmp_path: pathlib.Path) -> None:
    [description] = trials_of(tmp_path, "seeds: [3]\nseconds: 1.5\nscenario: [{at_s: 0.5, walk: [0.1, 0, 0]}]\n")
    result = RobotTrials().run(description)
    summary = run_of("--seconds", "1.5", "--walk", "0.1", "--seed", "3", folder=tmp_path / "run")
    for measures in (result, summary):
        assert (measures["mean_speed_m_s"], measures["mean_side_speed_m_s"]) == (None, None)


def test_parameters_and_variables_reach_the_robot(tmp_path: pathlib.Path) -> None:
    text = """
seeds: [1]
seconds: 2
scenario: [{at_s: 0.2, walk: [$speed, 0, 0]}]
parameters: {speed: [0.1, 0.2], trajectory.lift: [30 mm, 36 mm]}
"""
    kind = RobotTrials()
    assert len({str(kind.run(one)["digest"]) for one in trials_of(tmp_path, text)}) == 4


AT = "seeds: [1]\nseconds: 1\nscenario: [{at_s: $t, walk: [0.1, 0, 0]}]\n"


@pytest.mark.parametrize(
    ("text", "complaint"),
    [
        ("seeds: [1]\n", "has no 'seconds'"),
        ("seeds: [1]\nseconds: 1\nrobots: [humanoid23]\n", r":3: robots\[0\]: 'humanoid23' is no robot"),
        ("seeds: [1]\nseconds: 1\nmeasures: [speed]\n", r":3: measures\[0\]: 'speed' is no measure. There are: survived"),
        ("seeds: [1]\nseconds: 1\nparameters: {push: [1, 2]}\n", r"push: is neither PLUGIN.PARAMETER nor used in a scenario"),
        ("seeds: [1]\nseconds: 1\nscenario: [{at_s: 0, walk: [$v, 0, 0]}]\n", r":3: scenario\[0\].walk\[0\]: '\$v' is a variable that 'parameters' has not. Add v"),
        ("seeds: [1]\nseconds: 1\nscenario: [{at_s: 0, walk: [.nan, 0, 0]}]\n", r":3: scenario\[0\].walk\[0\]: '.nan' is not a finite"),
        (AT + "parameters:\n  t: [0.5, soon]\n", r":5: parameters.t\[1\]: 'soon' must be a number of seconds, 0 to 86400: it is scenario\[0\].at_s"),
        (AT + "parameters:\n  t: [0.5, 1]\n", r":5: parameters.t\[1\]: '1' must be before the end of the trial at 1 s, or it never happens"),
        ("seeds: [1]\nseconds: 1\nscenario: [{at_s: 1, walk: [0.1, 0, 0]}]\n", r":3: scenario\[0\].at_s: '1' must be before the end"),
        ("seeds: [1]\nseconds: 1\nconfigs: [wlk]\n", r":3: configs\[0\]: 'wlk' is no config.*Did you mean 'walk'\?"),
        (AT + "parameters:\n  t: [1e308]\n", r":5: parameters.t\[0\]: '1e308' must be a number of seconds"),
        (AT + "parameters:\n  t: {from: -1, to: 2, steps: 3}\n", r":5: parameters.t.from: '-1' must be a number of seconds"),
        (AT + "parameters:\n  t: {from: 1, to: 2, steps: 3, unit: s}\n", r":5: parameters.t.unit: 's' is a unit"),
        ("seeds: [1]\nseconds: 1\nscenario: [{at_s: 0, motion: $v fast}]\n", r":3: scenario\[0\].motion: '\$v fast' is more than a variable"),
        (f"seeds: [1]\nseconds: 1\nrobots: [{'r' * 300}]\n", r":3: robots\[0\]: 'r{80}… \(300 characters\)' is no robot"),
        ("seeds: [1]\nseconds: 1\nrobots: [humanoid22, humanoid22]\n", r":3: robots\[1\]: 'humanoid22' stands here twice"),
        ("seeds: [1]\nseconds: 1\nconfigs: [walk, walk]\n", r":3: configs\[1\]: 'walk' stands here twice"),
        ("seeds: [1]\nseconds: 1\nworlds: [null, boxes, ~]\n", r":3: worlds\[2\]: '~' stands here twice"),
        ("seeds: [1]\nseconds: 1\nmismatch: [1, 1.0]\n", r":3: mismatch\[1\]: '1.0' stands here twice"),
    ],
)
def test_a_mistake_is_told_with_its_place(tmp_path: pathlib.Path, text: str, complaint: str) -> None:
    with pytest.raises(InputError, match=complaint):
        trials_of(tmp_path, text)


def test_conditions_that_cannot_be_are_told_with_their_line(tmp_path: pathlib.Path) -> None:
    file = tmp_path / "sweep.yaml"
    file.write_text("seeds: [1]\nseconds: 1\nscenario: [{at_s: 0, stand: true}]\nconditions: {slope: 3}\n")
    with pytest.raises(InputError, match=r":4: conditions: cannot run: .*slope"):
        check_values(read_sweep(file), Store(tmp_path / "store"))


def test_a_parameter_that_there_is_not_is_told_before_anything_runs(tmp_path: pathlib.Path) -> None:
    [description] = trials_of(tmp_path, "seeds: [1]\nseconds: 1\nparameters: {trajectory.lft: [1]}\n")
    with pytest.raises(ValueError, match="lft"):
        RobotTrials().check(description)


@pytest.mark.parametrize(
    ("text", "complaint"),
    [
        ("parameters: {trajectory.lift: [25 mm, 5 m]}", r":4: parameters.trajectory.lift\[1\]: '5 m' cannot run: config/walk.yaml: parameter 'lift'"),
        ("parameters: {trajectory.lift: [abc]}", r":4: parameters.trajectory.lift\[0\]: 'abc' cannot run: .* must be a finite number"),
        ("scenario: [{at_s: 1, walk: [$v, 0, 0]}]\nparameters: {v: [0.1, 5]}", r":5: parameters.v\[1\]: '5' cannot run: the event at 1 s: "),
        ("scenario: [{at_s: 1, wlk: [1, 0, 0]}]", r":4: scenario: cannot run: the event at 1 s: .* Did you mean 'walk'"),
        ("worlds: [null, boxes]\nconditions: {slope_deg: [3, 0]}", r":4: worlds\[1\]: 'boxes' cannot run: the conditions slope_deg"),
    ],
)
def test_a_value_of_later_trials_is_told_before_anything_runs(tmp_path: pathlib.Path, text: str, complaint: str) -> None:
    file = tmp_path / "sweep.yaml"
    file.write_text(f"seeds: 1..3\nseconds: 2\nmismatch: [1]\n{text}\n")
    with pytest.raises(InputError, match=complaint):
        check_values(read_sweep(file), Store(tmp_path / "store"))


def test_values_that_nobody_can_run_together_are_a_result(tmp_path: pathlib.Path) -> None:
    """The leg cannot fold so far, but 0.2 m is no wrong lift: with the hips higher it would do."""
    file = tmp_path / "sweep.yaml"
    file.write_text("seeds: [1]\nseconds: 1\nparameters: {trajectory.lift: [25 mm, 0.2 m]}\n")
    sweep = read_sweep(file)
    check_values(sweep, Store(tmp_path / "store"))
    with pytest.raises(ImpossibleError, match="unreachable"):
        RobotTrials().run(sweep.trial(1).description)
