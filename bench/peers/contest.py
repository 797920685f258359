"""What all comparisons have in common: rows, and a way to play one round of them."""

from __future__ import annotations

import json
import pathlib
import subprocess
from abc import ABC, abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from ratios import Pair, Row

LONGEST_PROGRAM_S = 600


class NotHereError(Exception):
    """A peer is not on this machine; says why, and what would bring it."""


class MeasurementError(Exception):
    """Something that is there did not do what was measured."""


@dataclass(frozen=True)
class Place:
    """Where things are, for all contests."""

    source: pathlib.Path  # the root of the tree
    programs: pathlib.Path  # the built ones
    scratch: pathlib.Path  # a folder for this run alone


class Contest(ABC):
    """Rows that are measured together."""

    name: str  # as --rows takes it
    about: str

    def __init__(self, place: Place) -> None:
        self.place = place
        self.rows: dict[str, Row] = {}

    @abstractmethod
    def play(self) -> None:
        """One round: adds a pair to each row, by `add`, or says that it is missing, by `miss`."""

    def add(self, key: str, row: Row, pair: Pair) -> None:
        self.rows.setdefault(key, row).pairs.append(pair)

    def miss(self, key: str, row: Row, why: str) -> None:
        self.rows.setdefault(key, row).missing = why

    def program(self, name: str) -> pathlib.Path:
        path = self.place.programs / name
        if not path.exists():
            raise MeasurementError(f"{path} is not there: build the target benchmarks (./dev bench --peers does)")
        return path


def run_program(command: list[str | pathlib.Path], seconds: float = LONGEST_PROGRAM_S) -> str:
    """Its stdout. Raises MeasurementError with what it said, where it fails or does not end."""
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=seconds, check=False)
    except subprocess.TimeoutExpired as error:
        raise MeasurementError(f"{pathlib.Path(command[0]).name} did not end within {seconds:.0f} s") from error
    if done.returncode != 0:
        said = (done.stderr.strip() or done.stdout.strip()).splitlines()[-3:]
        raise MeasurementError(f"{pathlib.Path(command[0]).name} ended with {done.returncode}: {' '.join(said)}")
    return done.stdout


def json_of(command: list[str | pathlib.Path]) -> Any:
    text = run_program(command)
    try:
        return json.loads(text)
    except json.JSONDecodeError as error:
        raise MeasurementError(f"{pathlib.Path(command[0]).name} printed no JSON: {error}") from error


def counters(program: pathlib.Path, benchmark: str, *options: str) -> Mapping[str, float]:
    """The counters of one Google benchmark, run once. Raises NotHereError with the reason of one that was skipped."""
    runs = json_of([program, "--benchmark_format=json", f"--benchmark_filter=^{benchmark}(/|$)", *options]).get("benchmarks", [])
    if len(runs) != 1:
        raise MeasurementError(f"{program.name} has {len(runs)} benchmarks '{benchmark}' where one is wanted")
    if runs[0].get("error_occurred"):
        raise NotHereError(str(runs[0].get("error_message")))
    return {name: float(value) for name, value in runs[0].items() if isinstance(value, (int, float))}
