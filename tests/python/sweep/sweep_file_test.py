"""Sweep files: what they mean, and that each mistake is told with file, line, field, value, rule and remedy."""

from __future__ import annotations

import pathlib
import time

import pytest

from gaitway.sweep.check import check_values
from gaitway.sweep.complaint import InputError
from gaitway.sweep.design import Design, Range, Values
from gaitway.sweep.store import Store
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


def test_a_column_has_numbers_below_the_unit_of_all_of_them(tmp_path: pathlib.Path) -> None:
    sweep = read_sweep(written(tmp_path, """
trial: rehearsal
seeds: [1]
parameters:
  range: {from: 0.02, to: 0.04, steps: 3, unit: s}
  list: ["3 mm", "1.5e1 mm"]
  several: ["3 mm", "1 cm"]
  word: [slow, fast]
  wide: {from: 0.1, to: 0.2, steps: 2, unit: 1 / s}
  close: [-1e-3rad/s, 2rad/s]
  one_number: [1 mm, 1.0 mm]
  no_unit: ["1 0", "2 0"]
  infinite: [1e999 s, 1 s]
"""))
    assert sweep.columns == ["trial", "range [s]", "list [mm]", "several", "word", "wide [1 / s]", "close [rad/s]", "one_number", "no_unit",
                             "infinite", "seed"]
    last = sweep.trial(sweep.count - 1)
    assert list(last.row.values())[1:-1] == [0.04, 15.0, "1 cm", "fast", 0.2, 2.0, "1.0 mm", "2 0", "1 s"]
    assert last.description["range"] == "0.04 s"


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
        ("trial: rehearsal\nseeds: 1..²\n", r":2: seeds: '1..²' must be FIRST..LAST"),
        ("trial: rehearsal\nseeds: 1..99999999999999999999\n", r":2: seeds: '1..99999999999999999999' must be at most 18446744073709551615"),
        ("trial: rehearsal\nseeds: 0..18446744073709551615\n", r"has 18446744073709551616 trials, 10000000 at most. Take fewer steps"),
        (f"trial: rehearsal\nseeds: [{'9' * 400}]\n", r":2: seeds\[0\]: '9{80}… \(400 characters\)' is a whole number of more than 64 bits"),
        (f"trial: rehearsal\nseeds: [{'9' * 5000}]\n", r":2: seeds\[0\]: .* has 5000 characters, a number has 1000 at most"),
        ("trial: rehearsal\nseeds: [1]\nparameters: {rounds: [1e400]}\n", r":3: parameters.rounds\[0\]: '1e400' is not a finite number"),
        ("trial: rehearsal\nseeds: [1]\nparameters: {day: [2026-11-29]}\n", r":3: parameters.day\[0\]: '2026-11-29' is a date to YAML. Put it"),
        ("trial: rehearsal\nseeds: [1]\nparameters: {x: [!!binary aGk=]}\n", r":3: parameters.x\[0\]: 'aGk=' is a binary"),
        ("trial: rehearsal\nseeds: [1]\nparameters: {x: [!!int abc]}\n", r":3: parameters.x\[0\]: 'abc' cannot be read as int"),
        ("trial: rehearsal\nseeds: [1]\nparameters: {x: !!set {a}}\n", r":3: parameters.x: is a set"),
        ('trial: rehearsal\nseeds: [1]\nparameters: {x: ["\\ud800"]}\n', r":3: parameters.x\[0\]: .* holds what is no character"),
        ("trial: rehearsal\nseeds: [1]\n[1]: 2\n", r":3: must be a name"),
        (f"trial: {'[' * 30}{']' * 30}\n", r":1: trial[\[0\]]*: is nested too deep, 20 lists"),
        (f"trial: {'[' * 5000}{']' * 5000}\n", r"sweep.yaml: is nested too deep"),
        ("a: &a [1]\nb: &b [*a, *b]\n", r":1: b[\[\]01]*: '1' is nested too deep"),
        ("\n".join(f"{n}: &{n} [{', '.join([f'*{chr(ord(n) - 1)}' if n > 'a' else '1'] * 9)}]" for n in "abcdefg"), r"has more than 200000 values"),
        ("trial: rehearsal\nseeds: [1]\nmeasures: [value, value]\n", r":3: measures\[1\]: 'value' stands here twice. .* leave it out"),
        ("trial: rehearsal\nseeds: [1]\nmeasures: [speed]\n", r":3: measures\[0\]: 'speed' is no measure. There are: value, digest"),
        ("trial: rehearsal\nseeds: [1]\nparameters: {rounds: [10, 1e1]}\n", r":3: parameters.rounds\[1\]: '1e1' stands here twice"),
        ("trial: rehearsal\nseeds: [1]\nparameters: {rounds: [1e1, 10.0]}\n", r":3: parameters.rounds\[1\]: '10.0' stands here twice"),
        ("trial: rehearsal\nseeds: [1]\nparameters: {value: [1]}\n", r":3: parameters.value: is the name of a measure"),
        ("trial: rehearsal\nseeds: [1]\nparameters: {x: {from: 1, to: 1.000000000001, steps: 99}}\n", r":3: parameters.x: has steps of which two"),
    ],
)
def test_a_mistake_is_told_with_its_place(tmp_path: pathlib.Path, text: str, complaint: str) -> None:
    with pytest.raises(InputError, match=complaint):
        read_sweep(written(tmp_path, text))


def test_a_huge_grid_is_counted_at_once(tmp_path: pathlib.Path) -> None:
    """Its ranges are never expanded: 10^7 values each would take minutes."""
    axis = "{from: 0, to: 1, steps: 10000000}"
    began = time.process_time()
    with pytest.raises(InputError, match=r"has 1000000000000000000000 trials, 10000000 at most. Take fewer steps or seeds"):
        read_sweep(written(tmp_path, f"trial: rehearsal\nseeds: [1]\nparameters: {{a: {axis}, b: {axis}, c: {axis}}}\n"))
    assert time.process_time() - began < 1.0


@pytest.mark.parametrize("design", ["grid", "{random: 7, seed: 3}", "{latin_hypercube: 7, seed: 3}"])
def test_any_trial_is_known_without_those_before_it(tmp_path: pathlib.Path, design: str) -> None:
    steps = ", steps: 3" if design == "grid" else ""
    text = f"trial: rehearsal\nseeds: 1..4\nparameters: {{a: {{from: 0, to: 1{steps}}}, b: [x, y]}}\ndesign: {design}\n"
    sweep = read_sweep(written(tmp_path, text))
    trials = list(sweep.trials())
    assert [sweep.trial(number) for number in range(sweep.count)] == trials
    assert len({trial.key for trial in trials}) == sweep.count
    if design == "grid":
        assert [trial.row for trial in trials[:9:4]] == [
            {"trial": 0, "a": 0.0, "b": "x", "seed": 1}, {"trial": 4, "a": 0.0, "b": "y", "seed": 1}, {"trial": 8, "a": 0.5, "b": "x", "seed": 1}
        ]


def test_numbers_are_numbers_as_people_write_them(tmp_path: pathlib.Path) -> None:
    text = "trial: rehearsal\nseeds: [1]\nparameters:\n  a: [1e-3, 2.5e6, -1E3, .5e1, '1e-3', 1e-3 s]\n  rounds: {from: 1e0, to: 1e3, steps: 2}\n"
    sweep = read_sweep(written(tmp_path, text))
    assert [sweep.trial(2 * number).row["a"] for number in range(6)] == [0.001, 2.5e6, -1000.0, 5.0, "1e-3", "1e-3 s"]
    assert [sweep.trial(number).row["rounds"] for number in range(2)] == [1.0, 1000.0]


def test_each_value_is_tried_before_anything_runs(tmp_path: pathlib.Path) -> None:
    store = Store(tmp_path / "store")

    def check(text: str) -> None:
        check_values(read_sweep(written(tmp_path, f"trial: rehearsal\nseeds: 1..9\nparameters:\n{text}\n")), store)

    check("  rounds: [1, 2]\n  sleep_s: {from: 0, to: 1, steps: 1000}")
    with pytest.raises(InputError, match=r":5: parameters.rounds\[2\]: '-3' cannot run: rounds = -3: must be a number, 1 to 1e\+09"):
        check("  rounds: [1, 2,\n    -3]")
    with pytest.raises(InputError, match=r":4: parameters.rounds\[0\]: 'two' cannot run: rounds = 'two'"):
        check("  rounds: [two]")
    with pytest.raises(InputError, match=r":5: parameters.sleep_s.to: '1e9' cannot run: sleep_s = 1000000000.0"):
        check("  rounds: [1]\n  sleep_s: {from: 0, to: 1e9, steps: 1000}")
    with pytest.raises(InputError, match=r":4: parameters.rounds.from: '-5' cannot run"):
        check("  rounds: {from: -5, to: 5, steps: 3}")
