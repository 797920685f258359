"""`gaitway sweep`: reads a sweep file, runs what of it is not known yet, and writes tables and plots."""

from __future__ import annotations

import argparse
import itertools
import json
import signal
import sys
from pathlib import Path
from types import FrameType

from .complaint import EXIT_BAD_INPUT, EXIT_FINE, EXIT_NOT_DONE, InputError, SweepError
from .engine import Engine
from .place import HELP, pool_at
from .progress import Progress, clock
from .results import PartialTable, prepare_folder, write_results, write_whole
from .store import Store, default_folder, open_store
from .sweep_file import Sweep, read_sweep
from .trial import kind_of

EXAMPLES = """\
Examples:
  gaitway sweep gains.yaml                                on this computer, into out/sweep
  gaitway sweep gains.yaml --plan                         what would run, and for how long
  gaitway sweep gains.yaml --on dask://10.0.0.5:8786      on a cluster: dask scheduler, and dask workers with Gaitway
  gaitway sweep gains.yaml --on local:1 --out out/gains

gains.yaml:
  robots: [humanoid22]                                    # shipped ones, or folders
  seeds: 1..20
  seconds: 12
  scenario:
    - {at_s: 1, walk: [0.2, 0, 0]}
    - {at_s: 6, push: {direction: [0, 1, 0], impulse_Ns: $push}}
  parameters:
    push: [0.8, 1.2, 1.6]
    stability.ankle_roll_rate: {from: 0.03, to: 0.08, steps: 6}
  measures: [survived, mean_speed_m_s, lateral_drift_m]

What is known already is not run: a sweep that was interrupted goes on by the same command. While it runs, partial.csv
and progress.json in --out can be read; at the end results.csv, results.md, and results.parquet and results.png where
pyarrow and matplotlib are there.
Exit code: 0 each trial has a result; 1 the input was bad and nothing ran; 3 trials are missing (no workers, interrupted);
4 results could not be written; 5 two workers gave two results for one trial."""


def main(arguments: list[str] | None = None) -> int:
    options = _parse(arguments)
    signal.signal(signal.SIGTERM, _interrupt)
    try:
        return _run(options)
    except SweepError as error:
        print(f"gaitway sweep: {error}", file=sys.stderr)
        return error.exit_code
    except KeyboardInterrupt:
        print("gaitway sweep: interrupted. What has run is stored; the same command goes on from there", file=sys.stderr)
        return EXIT_NOT_DONE


def _interrupt(_number: int, _frame: FrameType | None) -> None:
    raise KeyboardInterrupt


class _Parser(argparse.ArgumentParser):
    def error(self, message: str) -> None:  # type: ignore[override]
        print(f"gaitway sweep: {message}. See gaitway sweep --help", file=sys.stderr)
        raise SystemExit(EXIT_BAD_INPUT)


def _parse(arguments: list[str] | None) -> argparse.Namespace:
    parser = _Parser(
        prog="gaitway sweep",
        description="Run trials over robots, configurations, parameters and seeds, here or on a cluster.",
        epilog=EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("file", type=Path, help="the sweep file (YAML)")
    parser.add_argument("--on", default="local", metavar="PLACE", help=HELP)
    parser.add_argument("--out", type=Path, default=Path("out/sweep"), metavar="DIR", help="folder for the results (default out/sweep)")
    parser.add_argument("--store", type=Path, metavar="DIR", help=f"where each trial's result is kept (default {default_folder()})")
    parser.add_argument("--plan", action="store_true", help="say what would run, and end")
    parser.add_argument("--patience", type=float, default=60.0, metavar="S", help="wait so long where no worker is there (default 60)")
    return parser.parse_args(arguments)


def _run(options: argparse.Namespace) -> int:
    if not 0 <= options.patience < 1e9:
        raise InputError(f"--patience {options.patience}: must be 0 or more seconds")
    sweep = read_sweep(options.file)
    store = open_store(options.store)
    _check_first(sweep, options.file)
    if options.plan:
        print(_plan(sweep, store, options.on))
        return EXIT_FINE
    prepare_folder(options.out)
    pool = pool_at(options.on)
    progress = Progress(len(sweep), options.out)
    with pool, PartialTable(sweep, options.out) as table:
        engine = Engine(sweep.kind, pool, store, patience_s=options.patience, tell=progress.tell)
        try:
            engine.run(sweep.trials(), table.add, lambda: progress.look(engine, table))
        finally:
            progress.look(engine, table, last=True)
    left_out = write_results(sweep, store, options.out)
    write_whole(options.out / "sweep.json", json.dumps(_account(sweep, engine, table), indent=1) + "\n")
    print(_words(engine, table, options.out, left_out))
    return EXIT_FINE


def _check_first(sweep: Sweep, file: Path) -> None:
    """What is wrong with all trials is told before any runs."""
    for trial in itertools.islice(sweep.trials(), 1):
        try:
            kind_of(sweep.kind).check(trial.description)
        except ValueError as error:
            raise InputError(f"{file}: its first trial cannot run: {error}") from error


def _plan(sweep: Sweep, store: Store, on: str) -> str:
    kind = kind_of(sweep.kind)
    known, seconds, first = 0, 0.0, None
    for trial in sweep.trials():
        first = first or trial
        if store.has(trial.key):
            known += 1
        else:
            seconds += kind.expected_s(trial.description)
    lines = [f"{len(sweep)} trials: {', '.join(f'{len(values)} {name}' for name, values in sweep.axes.items())}"]
    lines[0] += f", {len(sweep.design)} points of {len(sweep.design.parameters)} parameters"
    lines.append(f"{known} of them are known; the others take about {clock(seconds)} on one core like this computer's")
    if first:
        lines.append(f"the first: {json.dumps(first.row)}")
    lines.append(f"would run on {on}; nothing was run")
    return "\n".join(lines)


def _account(sweep: Sweep, engine: Engine, table: PartialTable) -> dict[str, object]:
    """sweep.json: what it took. Differs from run to run."""
    tally = engine.tally
    return {
        "trials": len(sweep),
        "code": kind_of(sweep.kind).code(),
        "ran": tally.ran,
        "were_stored": tally.stored,
        "with_error": table.failed,
        "given_to_another_worker": tally.given_again,
        "run_twice_and_equal": engine.second_runs.agreed,
        "not_run_twice_for_want_of_a_second_worker": tally.not_run_twice,
        "trial_seconds": round(tally.trial_s, 3),
        "by_worker": tally.by_worker,
        "refused_workers": engine.crew.refused,
    }


def _words(engine: Engine, table: PartialTable, out: Path, left_out: list[str]) -> str:
    tally = engine.tally
    lines = [f"{tally.ran} trials ran, {tally.stored} were known; {table.failed} of all have an error"]
    if engine.second_runs.agreed:
        lines.append(f"{engine.second_runs.agreed} ran a second time elsewhere, with equal results")
    if tally.not_run_twice:
        lines.append(f"{tally.not_run_twice} should have run on two workers, but there was only one")
    lines += [f"left out: {what}" for what in left_out]
    return "\n".join([*lines, f"results: {out / 'results.md'}"])


if __name__ == "__main__":
    sys.exit(main())
