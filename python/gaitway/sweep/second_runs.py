"""The trials that run twice, on two workers, whose results must be equal to the bit."""

from __future__ import annotations

import itertools
from collections import deque
from collections.abc import Collection
from dataclasses import dataclass

from .complaint import DisagreementError
from .store import Store
from .trial import Trial

MOST_WAITING = 1000  # where there is no second worker for them: of more, that none was there is counted, and no more


@dataclass(frozen=True)
class FirstRun:
    """`worker` and `says`: its name and its own words of itself; None: an earlier sweep stored the result."""

    trial: Trial
    text: str
    worker: str | None
    says: str


class SecondRuns:
    """Those that wait for another worker, and what came of the others."""

    def __init__(self, store: Store) -> None:
        self._store = store
        self._waiting: deque[FirstRun] = deque()
        self._running: dict[str, FirstRun] = {}
        self._dropped = 0
        self.agreed = 0

    def want(self, first: FirstRun) -> None:
        if not first.trial.is_run_twice or self._store.was_run_twice(first.trial.key):
            return
        if len(self._waiting) < MOST_WAITING:
            self._waiting.append(first)
        else:
            self._dropped += 1

    @property
    def wanted(self) -> bool:
        """Whether any waits for a second worker."""
        return bool(self._waiting)

    def next_for(self, worker: str) -> Trial | None:
        for first in list(itertools.islice(self._waiting, 16)):
            if first.worker != worker:
                self._waiting.remove(first)
                self._running[first.trial.key] = first
                return first.trial
        return None

    def possible(self, workers: Collection[str]) -> bool:
        """Whether any that waits can run on one of them."""
        return any(first.worker != worker for first in self._waiting for worker in workers)

    def lost(self, key: str) -> None:
        """The worker has gone: another one."""
        self._waiting.appendleft(self._running.pop(key))

    def compare(self, key: str, text: str, worker: str, says: str) -> None:
        """DisagreementError, and then the result is stored no longer."""
        first = self._running.pop(key)
        if first.text == text:
            self.agreed += 1
            self._store.note_run_twice(key)
            return
        self._store.forget(key)
        before = f"{first.worker} ({first.says})" if first.worker else "the worker that stored it before"
        raise DisagreementError(
            f"trial {first.trial.number} has two results: {before} says {first.text}, {worker} ({says}) says {text}. "
            "One of the two computes wrongly. Find out which by more sweeps without one of them; remove its store, and "
            "this client's, since results of it may be in both"
        )

    def give_up(self) -> int:
        """How many have not run twice."""
        left = len(self._waiting) + len(self._running) + self._dropped
        self._dropped = 0
        self._waiting.clear()
        self._running.clear()
        return left
