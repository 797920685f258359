"""The frame of the programs that run trials (gaitway sweep, gaitway tune, gaitway measure gait --on): options, complaints, ends.

    parser = Parser("gaitway sweep", "Run trials over …", EXAMPLES)
    parser.add_argument("file", type=Path)
    return run_program(parser, arguments, run)      # run(options) -> exit code, raises SweepError

Its options have `on`, `store` and `patience`: pool_at(options.on), open_store(options.store), Engine(…, patience_s=options.patience).
"""

from __future__ import annotations

import argparse
import signal
import sys
from collections.abc import Callable
from pathlib import Path
from typing import NoReturn

from .complaint import EXIT_BAD_INPUT, EXIT_NOT_DONE, InputError, SweepError, UnfitWorkerError
from .place import HELP
from .store import default_folder

LONGEST_PATIENCE_S = 1e9


class Parser(argparse.ArgumentParser):
    """With the options that all of them have. A mistake in the command line ends the program as bad input."""

    def __init__(self, name: str, description: str, examples: str) -> None:
        super().__init__(
            prog=name, description=description, epilog=examples, formatter_class=argparse.RawDescriptionHelpFormatter
        )
        self.add_argument("--on", default="local", metavar="PLACE", help=HELP)
        self.add_argument("--store", type=Path, metavar="DIR", help=f"where each trial's result is kept (default {default_folder()})")
        self.add_argument("--patience", type=float, default=60.0, metavar="S", help="wait so long where no worker is there (default 60)")

    def error(self, message: str) -> NoReturn:
        print(f"{self.prog}: {message}. See {self.prog} --help", file=sys.stderr)
        raise SystemExit(EXIT_BAD_INPUT)


def run_program(parser: Parser, arguments: list[str] | None, run: Callable[[argparse.Namespace], int]) -> int:
    """The exit code. SIGTERM is an interrupt, as SIGINT is."""
    options = parser.parse_args(arguments)
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        if not 0 <= options.patience < LONGEST_PATIENCE_S:
            raise InputError(f"--patience {options.patience}: must be 0 or more seconds")
        return run(options)
    except SweepError as error:
        print(f"{parser.prog}: {error}", file=sys.stderr)
        return error.exit_code
    except UnfitWorkerError as error:
        print(f"{parser.prog}: this computer {error}", file=sys.stderr)
        return EXIT_BAD_INPUT
    except KeyboardInterrupt:
        print(f"{parser.prog}: interrupted. What has run is stored; the same command goes on from there", file=sys.stderr)
        return EXIT_NOT_DONE
