"""`gaitway tune`: finds a gait's numbers for one robot, and says what they bought on robots that the search has never seen."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import Any

from gaitway.sweep.check import complaint
from gaitway.sweep.complaint import EXIT_FINE, InputError
from gaitway.sweep.engine import Engine
from gaitway.sweep.place import pool_at
from gaitway.sweep.program import Parser, run_program
from gaitway.sweep.results import prepare_folder, write_whole
from gaitway.sweep.robot_trial import found, nearest, place_of
from gaitway.sweep.store import open_store

from .numbers import NUMBERS, by_names, parameters
from .tuning import Plan, Tuned, tune
from .verdict import report, tuned_config
from .walks import Body, Subject

EXAMPLES = """\
Examples:
  gaitway tune --robot humanoid22                           hours on two cores; may be interrupted, and goes on
  gaitway tune --robot my_robot --on dask://10.0.0.5:8786   on a cluster
  gaitway tune --robot humanoid22 --size small --out out/t  a small one, that says whether it works
  gaitway tune --robot humanoid22 --numbers trajectory.lift,trajectory.absorb

Beside the robot's description (or in --out): tuned.yaml, a configuration for --config; tuned.md, what it bought, measure by
measure, also where nothing was won; tuning.json, from where an interrupted search goes on.
Exit code: 0 better than the default gait on held-out robots in one measure at least, worse in none; 6 it is not, and
tuned.md says why; 1 the input was bad; 3 not finished; 4 results could not be written; 5 two workers disagreed."""

EXIT_NOT_BETTER = 6
SIZES = {  # generations, population, seeds of the search, seeds of the verdict, seconds of a trial
    "small": (2, 3, 1, 2, 3.5),
    "usual": (30, 12, 8, 60, 12.0),
}
MOST_GENERATIONS = 100_000
FIRST_HELD_OUT = 100_001


def main(arguments: list[str] | None = None) -> int:
    what = "Tune the gait's dimensionless numbers of a robot by CMA-ES, on trials of robots with deviations."
    parser = Parser("gaitway tune", what, EXAMPLES)
    parser.add_argument("--robot", required=True, help="a shipped robot, or a folder")
    parser.add_argument("--config", default="walk", help="what is tuned: a shipped configuration or a file (default walk)")
    parser.add_argument("--out", type=Path, metavar="DIR", help="default: the robot's folder; of a shipped one out/tune/ROBOT")
    parser.add_argument("--size", choices=list(SIZES), default="usual", help="how long it searches, and on how many robots")
    parser.add_argument("--numbers", help=f"what is tuned, with commas (default: {len(NUMBERS)} numbers)")
    parser.add_argument("--generations", type=int, metavar="N", help="in the place of the size's")
    parser.add_argument("--seed", type=int, default=1, help="of the search (default 1)")
    return run_program(parser, arguments, _run)


def _run(options: argparse.Namespace) -> int:
    robot, config = found("robot", options.robot, Path()), found("config", options.config, Path())
    if robot is None or config is None:
        what, name = ("robot", options.robot) if robot is None else ("config", options.config)
        raise InputError(f"--{what} {name}: is neither a shipped one nor a path. {nearest(what, name)}")
    plan, seconds = _plan(options)
    store = open_store(options.store)
    subject = Subject(robot, config, _body(robot), seconds)
    _check(plan, subject)
    folder = options.out or (Path(robot) if "/" in robot else Path("out/tune") / robot)
    prepare_folder(folder)
    with pool_at(options.on) as pool:
        engine = Engine("robot", pool, store, patience_s=options.patience, tell=_tell)
        tuned = tune(plan, subject, engine, folder / "tuning.json", _tell)
    text = _write(folder, robot, config, plan, tuned, seconds, engine)
    print(text)
    return EXIT_FINE if tuned.verdict.reached else EXIT_NOT_BETTER


def _plan(options: argparse.Namespace) -> tuple[Plan, float]:
    """And the seconds of a trial. InputError."""
    for name, lowest, highest in (("generations", 1, MOST_GENERATIONS), ("seed", 0, 2**32 - 1)):
        value = getattr(options, name)
        if value is not None and not lowest <= value <= highest:
            raise InputError(f"--{name} {value}: must be {lowest} to {highest}")
    generations, population, training, held_out, seconds = SIZES[options.size]
    numbers = by_names(options.numbers.split(",")) if options.numbers is not None else NUMBERS
    plan = Plan(
        numbers, options.generations or generations, population, options.seed, range(1, training + 1),
        range(FIRST_HELD_OUT, FIRST_HELD_OUT + held_out),
    )
    return plan, seconds


def _check(plan: Plan, subject: Subject) -> None:
    """InputError where this robot does not walk with this configuration, or the configuration has not all that is tuned."""
    usual = parameters(plan.numbers, [0.0] * len(plan.numbers))
    for what, given in (("", {}), (" and the numbers that are tuned", usual)):
        for trial in subject.trials(given, plan.training[:1]):
            if why := complaint("robot", trial.description):
                raise InputError(f"--robot {subject.robot} --config {subject.config}{what}: cannot run: {why}")


def _write(folder: Path, robot: str, config: str, plan: Plan, tuned: Tuned, seconds: float, engine: Engine) -> str:
    how: dict[str, Any] = {
        "verdict trials": 3 * len(plan.held_out),
        "search": f"CMA-ES, {plan.generations} generations of {plan.population}, seed {plan.seed}, {len(plan.numbers)} numbers",
        "robots of the search": f"seeds {plan.training.start} to {plan.training.stop - 1}",
        "robots of the verdict": f"seeds {plan.held_out.start} to {plan.held_out.stop - 1}, none of them in the search",
        "trials": f"three of {seconds:g} s for each robot: straight ahead, sideways in a turn, pushed twice",
        "cost on the robots of the search": f"{tuned.training_cost:+.3f} (the default gait: 0)",
        "trials that ran": engine.tally.ran,
        "trials that were known": engine.tally.stored,
    }
    begun = parameters(plan.numbers, [0.0] * len(plan.numbers))
    text = report(Path(robot).name, tuned.verdict, begun, tuned.parameters, how)
    base = place_of("config", config).read_text(encoding="utf-8")
    head = f"{Path(config).stem} with numbers tuned for {Path(robot).name}: {tuned.verdict.words}.\nWhat they bought: tuned.md."
    write_whole(folder / "tuned.yaml", tuned_config(base, tuned.parameters, head))
    write_whole(folder / "tuned.md", text)
    return text


def _body(robot: str) -> Body:
    from gaitway import PluginError, Robot

    try:
        with Robot(robot) as one:
            return Body(one.hip_height_m, one.mass_kg)
    except (PluginError, ValueError) as error:
        raise InputError(f"--robot {robot}: {error}") from error


def _tell(news: str) -> None:
    print(f"gaitway tune: {news}", file=sys.stderr, flush=True)


if __name__ == "__main__":
    sys.exit(main())
