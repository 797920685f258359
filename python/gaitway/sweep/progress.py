"""How far a sweep is: a line on the terminal that rewrites itself, and progress.json for everybody else."""

from __future__ import annotations

import json
import sys
import time
from pathlib import Path
from typing import TextIO

from .engine import Engine
from .results import PartialTable, write_whole

SHOW_S = 1.0
SHOW_IN_LOG_S = 15.0  # where the output is no terminal


class Progress:
    """`look` is called often and does something once a second."""

    def __init__(self, total: int, folder: Path, stream: TextIO = sys.stderr) -> None:
        self._total, self._place, self._stream = total, folder / "progress.json", stream
        self._began = time.monotonic()
        self._shown = self._began
        self._written = 0.0
        self._on_line = False

    def tell(self, news: str) -> None:
        self._clear()
        print(f"gaitway sweep: {news}", file=self._stream, flush=True)

    def look(self, engine: Engine, table: PartialTable, *, last: bool = False) -> None:
        now = time.monotonic()
        if now - self._written < SHOW_S and not last:
            return
        self._written = now
        table.flush()
        state = self.state(engine, table)
        write_whole(self._place, json.dumps({**state, "ended": last}, indent=1) + "\n")
        terminal = self._stream.isatty()
        if now - self._shown >= (SHOW_S if terminal else SHOW_IN_LOG_S):
            self._shown = now
            left = "" if state["seconds_left"] is None else f", {clock(state['seconds_left'])} left"
            line = f"{state['done']} of {self._total} trials{left}, {state['workers']} workers, {table.failed} with an error"
            print(f"\r\033[K{line}" if terminal else line, end="" if terminal else "\n", file=self._stream, flush=True)
            self._on_line = terminal
        if last:
            self._clear()

    def state(self, engine: Engine, table: PartialTable) -> dict[str, int | float | None]:
        done = engine.tally.ran + engine.tally.stored
        elapsed_s = time.monotonic() - self._began
        rate = engine.tally.ran / elapsed_s if elapsed_s > 0 else 0.0
        return {
            "trials": self._total,
            "done": done,
            "were_stored": engine.tally.stored,
            "with_error": table.failed,
            "workers": len(engine.crew.admitted()),
            "seconds": round(elapsed_s, 1),
            "seconds_left": round((self._total - done) / rate, 1) if rate > 0 else None,
        }

    def _clear(self) -> None:
        if self._on_line:
            print("\r\033[K", end="", file=self._stream, flush=True)
            self._on_line = False


def clock(seconds: float) -> str:
    minutes, rest = divmod(round(seconds), 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours}:{minutes:02}:{rest:02} h" if hours else f"{minutes}:{rest:02} min"
