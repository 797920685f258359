"""Trials of the robot: the figures and the digest of `gaitway run`, and parameters that reach the plug-ins."""

from __future__ import annotations

import json
import os
import pathlib
import subprocess

import pytest

from gaitway.sweep.complaint import InputError
from gaitway.sweep.robot_trial import RobotTrials
from gaitway.sweep.sweep_file import read_sweep


def trials_of(folder: pathlib.Path, text: str) -> list[dict[str, object]]:
    file = folder / "sweep.yaml"
    file.write_text(text)
    return [trial.description for trial in read_sweep(file).trials()]


def test_a_trial_is_a_run(tmp_path: pathlib.Path) -> None:
    [description] = trials_of(tmp_path, "seeds: [3]\nseconds: 5\n")
    result = RobotTrials().run(description)
    out = tmp_path / "run"
    line = [os.environ["GAITWAY_COMMAND"], "run", "--seed", "3", "--seconds", "5", "--quiet", "--no-pictures", "--out", str(out)]
    assert subprocess.run(line, check=False).returncode == 0
    summary = json.loads((out / "summary.json").read_text())
    assert result["digest"] == summary["digest"]
    for measure in ("distance_m", "mean_speed_m_s", "mean_side_speed_m_s", "lateral_drift_m", "heading_drift_rad", "commanded_m"):
        assert result[measure] == pytest.approx(summary[measure], abs=1e-9), measure
    assert result["handed_over"] == summary["batches"]["handed_over"]


def test_parameters_and_variables_reach_the_robot(tmp_path: pathlib.Path) -> None:
    text = """
seeds: [1]
seconds: 2
scenario: [{at_s: 0.2, walk: [$speed, 0, 0]}]
parameters: {speed: [0.1, 0.2], trajectory.lift: [30 mm, 36 mm]}
"""
    kind = RobotTrials()
    assert len({str(kind.run(one)["digest"]) for one in trials_of(tmp_path, text)}) == 4


@pytest.mark.parametrize(
    ("text", "complaint"),
    [
        ("seeds: [1]\n", "has no 'seconds'"),
        ("seeds: [1]\nseconds: 1\nrobots: [humanoid23]\n", r":3: robots\[0\]: 'humanoid23' is no robot"),
        ("seeds: [1]\nseconds: 1\nmeasures: [speed]\n", r":3: measures\[0\]: 'speed' is no measure. There are: survived"),
        ("seeds: [1]\nseconds: 1\nparameters: {push: [1, 2]}\n", r"push: is neither PLUGIN.PARAMETER nor used in a scenario"),
        ("seeds: [1]\nseconds: 1\nscenario: [{at_s: 0, walk: [$v, 0, 0]}]\n", r":3: scenario\[0\].walk\[0\]: '\$v' is a variable that 'parameters' has not. Add v"),
        ("seeds: [1]\nseconds: 1\nscenario: [{at_s: 0, walk: [.nan, 0, 0]}]\n", r":3: scenario\[0\].walk\[0\]: '.nan' is not a finite"),
    ],
)
def test_a_mistake_is_told_with_its_place(tmp_path: pathlib.Path, text: str, complaint: str) -> None:
    with pytest.raises(InputError, match=complaint):
        trials_of(tmp_path, text)


def test_a_parameter_that_there_is_not_is_told_before_anything_runs(tmp_path: pathlib.Path) -> None:
    [description] = trials_of(tmp_path, "seeds: [1]\nseconds: 1\nparameters: {trajectory.lft: [1]}\n")
    with pytest.raises(ValueError, match="lft"):
        RobotTrials().check(description)
