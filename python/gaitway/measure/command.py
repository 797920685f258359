"""`gaitway-measure-on PLACE`: has the trials played that `gaitway measure gait --on PLACE` asks for.

That program starts this one, and is at the other end of standard input and output: lines of JSON, as
tools/measure/trials_elsewhere.hpp lists them. It asks for series of trials while others run; after each result it says
when all that came of it has been asked for.
"""

from __future__ import annotations

import argparse
import heapq
import itertools
import json
import os
import queue
import sys
import threading
from collections.abc import Iterator
from pathlib import Path
from typing import IO

from gaitway.sweep.canonical import Json
from gaitway.sweep.complaint import EXIT_BAD_INPUT, EXIT_FINE, EXIT_NOT_DONE, SweepError
from gaitway.sweep.engine import Engine
from gaitway.sweep.place import HELP, pool_at
from gaitway.sweep.store import default_folder, open_store
from gaitway.sweep.trial import Trial, key_of, kind_of

from .gait_series import SERIES, program, shipped_or_path

KIND = "gait"
READ_AT_ONCE = 65536
EXIT_NOT_MEASURED = 6  # of `gaitway measure gait`, whose 3 means that a floor does not hold


class ClientGone(Exception):
    """Nobody wants results any more."""


class Measurement:
    """The program that measures, as it is heard and told."""

    def __init__(self, asks: int, results: IO[bytes]) -> None:
        self._asks, self._results = asks, results
        self._lines: queue.SimpleQueue[bytes] = queue.SimpleQueue()
        self._reader = threading.Thread(target=self._read, name="asks", daemon=True)  # so that the other end never waits
        self._wanted: list[tuple[int, int]] = []  # rank and id: what decides comes before what a failure would make vain
        self._series: dict[int, Json] = {}
        self._ids: dict[int, int] = {}  # by the trial's number
        self._told, self._heard = 0, -1  # results
        self._closed = False
        self._workers = self._stored = 0

    def begin(self) -> Json:
        """What is measured."""
        self._reader.start()
        return self._next_message()

    def trials(self, subject: Json) -> Iterator[Trial | None]:
        """None while nothing is wanted; more may be when results have been told."""
        code = kind_of(KIND).code()
        for number in itertools.count():
            while not (series := self._most_wanted()):
                if self._closed:
                    return
                yield None
            description = {**subject, **{name: series[name] for name in SERIES}}
            self._ids[number] = series["id"]
            yield Trial(number, description, {}, key_of(KIND, code, description))

    def answer(self, engine: Engine, trial: Trial, text: str) -> None:
        known, self._stored = engine.tally.stored > self._stored, engine.tally.stored
        result = json.loads(text)
        self._told += 1
        self._send({"id": self._ids.pop(trial.number), "ran": not known, "outcomes": result["outcomes"]})

    def look(self, engine: Engine) -> None:
        while not self._lines.empty():
            self._take(self._next_message())
        if (workers := len(engine.crew.admitted())) != self._workers:
            self._workers = workers
            self._send({"workers": workers})

    def tell(self, news: str) -> None:
        self._send({"news": news})

    def give_up(self, error: str, exit_code: int) -> None:
        self._send({"error": error, "exit_code": exit_code})

    def _most_wanted(self) -> Json | None:
        while not self._lines.empty() or not (self._series or self._closed or self._heard == self._told):
            self._take(self._next_message())
        while self._wanted:
            _, one = heapq.heappop(self._wanted)
            if series := self._series.pop(one, None):
                return series
        return None

    def _take(self, message: Json) -> None:
        if "id" in message:
            self._series[message["id"]] = message
            heapq.heappush(self._wanted, (message["rank"], message["id"]))
        elif "withdrawn" in message:
            for one in message["withdrawn"]:
                self._series.pop(one, None)
        elif "heard" in message:
            self._heard = message["heard"]
        else:
            self._closed = message["closed"]

    def _next_message(self) -> Json:
        line = self._lines.get()
        if not line:
            raise ClientGone
        message: Json = json.loads(line)
        return message

    def _read(self) -> None:
        rest = b""
        while text := os.read(self._asks, READ_AT_ONCE):
            *lines, rest = (rest + text).split(b"\n")
            for line in lines:
                self._lines.put(line)
        self._lines.put(b"")

    def _send(self, message: Json) -> None:
        try:
            self._results.write(json.dumps(message).encode() + b"\n")
            self._results.flush()
        except OSError as error:
            raise ClientGone from error


def main(arguments: list[str] | None = None) -> int:
    options = _parse(arguments)
    measurement = Measurement(os.dup(0), os.fdopen(os.dup(1), "wb"))
    os.dup2(2, 1)  # whatever else is printed
    try:
        subject = measurement.begin()
        try:
            _run(options, measurement, subject)
            return EXIT_FINE
        except SweepError as error:
            exit_code = EXIT_NOT_MEASURED if error.exit_code == EXIT_NOT_DONE else error.exit_code
            measurement.give_up(str(error), exit_code)
            return exit_code
    except (ClientGone, KeyboardInterrupt):
        return EXIT_NOT_MEASURED


class _Parser(argparse.ArgumentParser):
    def error(self, message: str) -> None:  # type: ignore[override]
        print(f"gaitway-measure-on: {message}. It is started by gaitway measure gait --on PLACE", file=sys.stderr)
        raise SystemExit(EXIT_BAD_INPUT)


def _parse(arguments: list[str] | None) -> argparse.Namespace:
    parser = _Parser(prog="gaitway-measure-on", description="What gaitway measure gait --on PLACE starts.")
    parser.add_argument("place", help=HELP)
    parser.add_argument("--store", type=Path, metavar="DIR", help=f"where what ran is kept (default {default_folder()})")
    parser.add_argument("--patience", type=float, default=60.0, metavar="S", help="wait so long where no worker is there (default 60)")
    return parser.parse_args(arguments)


def _run(options: argparse.Namespace, measurement: Measurement, subject: Json) -> None:
    pool = pool_at(options.place)
    store = open_store(options.store)
    program()
    described = {**subject, **{what: shipped_or_path(what, subject[what]) for what in ("robot", "config")}}
    with pool:
        engine = Engine(KIND, pool, store, patience_s=options.patience, tell=measurement.tell)
        engine.run(
            measurement.trials(described),
            lambda trial, text: measurement.answer(engine, trial, text),
            lambda: measurement.look(engine),
        )
    if agreed := engine.second_runs.agreed:
        measurement.tell(f"{agreed} series of trials ran a second time elsewhere, with equal results")
    if not_twice := engine.tally.not_run_twice:
        measurement.tell(f"{not_twice} series of trials should have run on two workers, but there was only one")


if __name__ == "__main__":
    sys.exit(main())
