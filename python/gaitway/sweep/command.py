"""`gaitway sweep`: reads a sweep file, runs what of it is not known yet, and writes tables and plots."""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path

from .check import check_values
from .complaint import EXIT_FINE
from .engine import Engine
from .place import pool_at
from .plan import plan
from .program import Parser, run_program
from .progress import Progress
from .results import PartialTable, prepare_folder, write_results, write_whole
from .store import open_store
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
    parser = Parser("gaitway sweep", "Run trials over robots, configurations, parameters and seeds, here or on a cluster.", EXAMPLES)
    parser.add_argument("file", type=Path, help="the sweep file (YAML)")
    parser.add_argument("--out", type=Path, default=Path("out/sweep"), metavar="DIR", help="folder for the results (default out/sweep)")
    parser.add_argument("--plan", action="store_true", help="say what would run, and end")
    return run_program(parser, arguments, _run)


def _run(options: argparse.Namespace) -> int:
    sweep = read_sweep(options.file)
    store = open_store(options.store)
    check_values(sweep, store)
    pool = pool_at(options.on)
    if options.plan:
        print(plan(sweep, store, options.on))
        return EXIT_FINE
    prepare_folder(options.out)
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
