"""What a sweep leaves in its folder: a table that grows while it runs, and at the end the same in order, and summed up.

Nothing that differs from run to run is in results.csv: it is equal to the byte wherever and however the trials ran.
"""

from __future__ import annotations

import csv
import errno
import itertools
import json
import os
import statistics
from array import array
from collections.abc import Callable, Iterable, Iterator
from contextlib import AbstractContextManager, contextmanager, suppress
from dataclasses import dataclass
from io import TextIOWrapper
from pathlib import Path
from types import TracebackType
from typing import Any, NamedTuple, Self

from .canonical import Json
from .complaint import InputError, ResultsError
from .store import Store
from .sweep_file import Sweep
from .trial import Trial, kind_of

ROWS_IN_MARKDOWN = 200
ROWS_AT_ONCE = 10_000
MOST_GROUPS = 10_000
Row = dict[str, Any]


def prepare_folder(folder: Path) -> None:
    """InputError where nothing can be written."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        probe = folder / ".writable"
        probe.write_text("")
        probe.unlink()
    except OSError as error:
        raise InputError(f"--out {folder}: {error.strerror}. Choose another folder") from error


@contextmanager
def _writing(place: Path) -> Iterator[None]:
    try:
        yield
    except OSError as error:
        remedy = "Make room" if error.errno in (errno.ENOSPC, errno.EDQUOT) else "Choose another --out"
        raise ResultsError(f"{place}: {error.strerror}. {remedy}; the trials' results are stored, and not run again") from error


def write_whole(place: Path, text: str) -> None:
    """Readers see the old one or the new one. ResultsError."""
    with _writing(place):
        beside = place.with_name(f".{place.name}.part")
        beside.write_text(text, encoding="utf-8")
        beside.rename(place)


def measures_of(sweep: Sweep) -> list[str]:
    return list(sweep.measures or kind_of(sweep.kind).measures)


def row_of(sweep: Sweep, trial: Trial, text: str) -> Row:
    """A measure that a trial has not is None."""
    result: Json = json.loads(text)
    return {**trial.row, **{name: result.get(name) for name in measures_of(sweep)}, "error": result.get("error")}


class PartialTable(AbstractContextManager["PartialTable"]):
    """partial.csv: a whole line as soon as a trial is known, in the order in which they come."""

    def __init__(self, sweep: Sweep, folder: Path) -> None:
        self._sweep, self._place = sweep, folder / "partial.csv"
        self.failed = 0

    def __enter__(self) -> Self:
        with _writing(self._place):
            self._file: TextIOWrapper = self._place.open("w", encoding="utf-8", newline="")
            self._writer = csv.DictWriter(self._file, [*self._sweep.columns, *measures_of(self._sweep), "error"])
            self._writer.writeheader()
            self._file.flush()
        return self

    def add(self, trial: Trial, text: str) -> None:
        row = row_of(self._sweep, trial, text)
        self.failed += row["error"] is not None
        with _writing(self._place):
            self._writer.writerow(row)

    def flush(self) -> None:
        with _writing(self._place):
            self._file.flush()

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        with suppress(OSError):
            self._file.close()


def stored_rows(sweep: Sweep, store: Store) -> Iterator[Row]:
    """In the order of the sweep. ResultsError where one is gone."""
    for trial in sweep.trials():
        text = store.find(trial.key)
        if text is None:
            raise ResultsError(f"{store.folder}: the result of trial {trial.number} is gone. Run the sweep again")
        yield row_of(sweep, trial, text)


def write_results(sweep: Sweep, store: Store, folder: Path) -> list[str]:
    """results.csv, results.md, and results.parquet and results.png where their packages are there; what was left out."""
    summary = Summary(sweep)
    _write_csv(sweep, summary.watch(stored_rows(sweep, store)), folder / "results.csv")
    write_whole(folder / "results.md", markdown(sweep, summary.groups))
    optional: list[tuple[str, Callable[[], None]]] = [
        ("results.parquet", lambda: _write_parquet(sweep, summary, stored_rows(sweep, store), folder / "results.parquet")),
        ("results.png", lambda: _plot(sweep, summary.groups, folder)),
    ]
    left_out = []
    for name, write in optional:
        try:
            with _writing(folder / name):
                write()
        except ImportError as error:
            left_out.append(f"{name} (needs the package '{error.name}')")
    with suppress(OSError):
        (folder / "partial.csv").unlink()
    return left_out


def _write_csv(sweep: Sweep, rows: Iterable[Row], place: Path) -> None:
    with _writing(place):
        beside = place.with_name(f".{place.name}.part")
        with beside.open("w", encoding="utf-8", newline="") as file:
            writer = csv.DictWriter(file, [*sweep.columns, *measures_of(sweep), "error"], lineterminator="\n")
            writer.writeheader()
            writer.writerows(rows)
            file.flush()
            os.fsync(file.fileno())
        beside.rename(place)


class Figure(NamedTuple):
    """Over the `trials` that have the measure."""

    mean: float
    deviation: float
    trials: int


@dataclass(frozen=True)
class Group:
    """The seeds of one point, with figures of each measure that is a number for some."""

    row: Row  # without trial and seed
    trials: int
    errors: int
    figures: dict[str, Figure]


class Summary:
    """What is learned of the rows while they pass by: `groups`, of the first points, and the types of each column."""

    def __init__(self, sweep: Sweep) -> None:
        self._names = [name for name in sweep.columns if name not in ("trial", "seed")]
        self._measures, self._seeds = measures_of(sweep), len(sweep.axes["seed"])
        self.groups: list[Group] = []
        self.types: dict[str, set[type]] = {name: set() for name in [*sweep.columns, *self._measures, "error"]}

    def watch(self, rows: Iterable[Row]) -> Iterator[Row]:
        """The same rows; a number of each is kept until its group is whole."""
        values: dict[str, array[float]] = {}
        errors = count = 0
        for row in rows:
            for name, value in row.items():
                self.types[name].add(type(value))
            for measure in self._measures if len(self.groups) < MOST_GROUPS else ():
                if isinstance(row[measure], bool | int | float):
                    values.setdefault(measure, array("d")).append(float(row[measure]))
            errors += row["error"] is not None
            count += 1
            if count == self._seeds:
                if len(self.groups) < MOST_GROUPS:
                    self.groups.append(Group({name: row[name] for name in self._names}, count, errors, _figures(values)))
                values, errors, count = {}, 0, 0
            yield row


def _figures(values: dict[str, array[float]]) -> dict[str, Figure]:
    return {
        name: Figure(statistics.fmean(some), statistics.stdev(some) if len(some) > 1 else 0.0, len(some)) for name, some in values.items()
    }


def markdown(sweep: Sweep, groups: list[Group]) -> str:
    names = [name for name in sweep.columns if name not in ("trial", "seed")]
    measures = [name for name in measures_of(sweep) if any(name in group.figures for group in groups)]
    lines = [
        f"# {len(sweep)} trials",
        "",
        f"Mean ± standard deviation over {len(sweep.axes['seed'])} seeds"
        + (f", the first {ROWS_IN_MARKDOWN} points; all are in results.csv." if len(groups) > ROWS_IN_MARKDOWN else "."),
        "",
        "| " + " | ".join([*names, "trials", *measures, "errors"]) + " |",
        "|" + "---|" * (len(names) + len(measures) + 2),
    ]
    for group in groups[:ROWS_IN_MARKDOWN]:
        figures = [_figure(group.figures.get(measure), group.trials) for measure in measures]
        cells = [*(f"{group.row[name]}" for name in names), str(group.trials), *figures, str(group.errors or "")]
        lines.append("| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |")
    return "\n".join(lines) + "\n"


def _figure(figure: Figure | None, trials: int) -> str:
    if figure is None:
        return ""
    return f"{figure.mean:.4g} ± {figure.deviation:.2g}" + (f" ({figure.trials} of {trials})" if figure.trials < trials else "")


def _write_parquet(sweep: Sweep, summary: Summary, rows: Iterator[Row], place: Path) -> None:
    import pyarrow
    from pyarrow import parquet

    def type_of(name: str) -> Any:
        types = summary.types[name] - {type(None)}
        if name in ("trial", "seed"):
            return pyarrow.uint64()
        if name == "error" or not types <= {bool, int, float}:
            return pyarrow.string()
        return pyarrow.bool_() if types == {bool} else pyarrow.float64()

    beside = place.with_name(f".{place.name}.part")
    chunk = list(itertools.islice(rows, ROWS_AT_ONCE))
    names = [*sweep.columns, *measures_of(sweep), "error"]
    schema = pyarrow.schema([(name, type_of(name)) for name in names])
    with parquet.ParquetWriter(beside, schema) as writer:
        while chunk:
            columns = [[_as(schema.field(name).type, row[name], pyarrow) for row in chunk] for name in names]
            arrays = [pyarrow.array(column, schema.field(name).type) for name, column in zip(names, columns, strict=True)]
            writer.write_table(pyarrow.Table.from_arrays(arrays, schema=schema))
            chunk = list(itertools.islice(rows, ROWS_AT_ONCE))
    beside.rename(place)


def _as(column: Any, value: Any, pyarrow: Any) -> Any:
    if value is None:
        return None
    if column == pyarrow.string():
        return str(value)
    return float(value) if column == pyarrow.float64() else value


def _plot(sweep: Sweep, groups: list[Group], folder: Path) -> None:
    """Each measure over the first column that changes; a line for each value of the second one."""
    from .plot import plot

    plot(groups, [name for name in measures_of(sweep) if any(name in group.figures for group in groups)], folder / "results.png")
