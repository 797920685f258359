"""Sweep files: what they mean, and that each mistake is told with file, line, field, value, rule and remedy."""

from __future__ import annotations

import pathlib

import pytest

from gaitway.sweep.complaint import InputError
from gaitway.sweep.design import Design, Range, Values
from gaitway.sweep.sweep_file import read_sweep


def written(folder: pathlib.Path, text: str) -> pathlib.Path:
    file = folder / "sweep.yaml"
    file.write_text(text)
    return file


def test_seeds_are_combined_with_each_point(tmp_path: pathlib.Path) -> None:
    sweep = read_sweep(written(tmp_path, """
trial: rehearsal
seeds: 3..5
parameters: {rounds: {from: 10, to: 30, steps: 3}, sleep_s: [0, 0.5]}
"""))
    trials = list(sweep.trials())
    assert len(sweep) == len(trials) == 18
    assert [trial.number for trial in trials] == list(range(18))
    assert [trial.row["seed"] for trial in trials[:4]] == [3, 4, 5, 3]
    assert {trial.row["rounds"] for trial in trials} == {10.0, 20.0, 30.0}
    assert len({trial.key for trial in trials}) == 18


@pytest.mark.parametrize("way", ["random", "latin_hypercube"])
def test_drawn_points_are_the_same_again_and_others_with_another_seed(tmp_path: pathlib.Path, way: str) -> None:
    def points(seed: int) -> list[float]:
        text = f"trial: rehearsal\nseeds: [1]\nparameters: {{rounds: {{from: 1, to: 101}}}}\ndesign: {{{way}: 50, seed: {seed}}}\n"
        return [trial.row["rounds"] for trial in read_sweep(written(tmp_path, text)).trials()]

    assert points(1) == points(1)
    assert points(1) != points(2)
    assert all(1 <= point <= 101 for point in points(1))


@pytest.mark.parametrize("name", ["trial", "seed", "mismatch", "error"])
def test_a_parameter_does_not_take_a_columns_name(tmp_path: pathlib.Path, name: str) -> None:
    with pytest.raises(InputError, match="column"):
        read_sweep(written(tmp_path, f"trial: rehearsal\nseeds: [1]\nparameters: {{{name}: [1, 2]}}\n"))


def test_a_latin_hypercube_has_a_point_in_each_slice() -> None:
    design = Design("latin_hypercube", {"a": Range(0, 40, None, False, ""), "b": Values(("x", "y"))}, 40, 7)
    points = list(design.points())
    assert sorted(int(a) for a, _ in points) == list(range(40))
    assert sum(b == "x" for _, b in points) == 20


def test_a_logarithmic_grid_and_units() -> None:
    assert [Range(0.01, 1, 3, True, "").nth(number) for number in range(3)] == [0.01, 0.1, 1.0]
    assert [Range(0.02, 0.04, 3, False, "s").nth(number) for number in range(3)] == ["0.02 s", "0.03 s", "0.04 s"]


@pytest.mark.parametrize(
    ("text", "complaint"),
    [
        ("", "is empty"),
        ("trial: rehearsal\n", r"sweep.yaml:1: has no 'seeds'. Add"),
        ("trial: rehearsal\nseeds: 5..2\n", r"sweep.yaml:2: seeds: '5..2' must be FIRST..LAST"),
        ("trial: rehearsal\nseeds: [1, 1]\n", r":2: seeds\[1\]: '1' stands here twice. .* leave it out"),
        ("trial: rehearsal\nseeds: [-1]\n", r":2: seeds\[0\]: '-1' must be a whole number"),
        ("trial: rehearsal\nseed: [1]\n", r":2: seed: 'seed' is unknown. Did you mean 'seeds'\?"),
        ("trial: rehersal\nseeds: [1]\n", r":1: trial: 'rehersal' is no kind of trial. There are: robot, rehearsal"),
        ("trial: rehearsal\nseeds: [1]\nparameters:\n  rounds: [1, .nan]\n", r":4: parameters.rounds\[1\]: '.nan' is not a finite"),
        ("trial: rehearsal\nseeds: [1]\nparameters:\n  rounds: {from: .inf, to: 3, steps: 2}\n", r":4: parameters.rounds.from: '.inf'"),
        ("trial: rehearsal\nseeds: [1]\nparameters:\n  rounds: {from: 4, to: 3, steps: 2}\n", r":4: parameters.rounds.to: '3' must be above"),
        ("trial: rehearsal\nseeds: [1]\nparameters:\n  rounds: {from: 1, to: 3}\n", r":4: parameters.rounds: has no 'steps'"),
        ("trial: rehearsal\nseeds: [1]\nseeds: [2]\n", r":3: seeds: 'seeds' stands here twice"),
        ("trial: rehearsal\nseeds: 0..99999999\n", r"has 100000000 trials, 10000000 at most"),
        ("trial: [\n", "is no YAML"),
    ],
)
def test_a_mistake_is_told_with_its_place(tmp_path: pathlib.Path, text: str, complaint: str) -> None:
    with pytest.raises(InputError, match=complaint):
        read_sweep(written(tmp_path, text))
