"""A trial: a pure function of a small JSON description. What the engine knows of one, and of its kind."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from importlib import import_module
from typing import Protocol

from .canonical import Json, canonical, text_hash

KINDS = {
    "robot": "gaitway.sweep.robot_trial:RobotTrials",
    "rehearsal": "gaitway.sweep.rehearsal:Rehearsals",
    "gait": "gaitway.measure.gait_series:GaitSeries",
}


class TrialKind(Protocol):
    """What a worker and the client have in common about one kind of trial. Made without arguments."""

    @property
    def measures(self) -> tuple[str, ...]:
        """What a result has, in the order of a table's columns."""

    def code(self) -> str:
        """Hash of everything in this installation that a result depends on."""

    def probe(self) -> str:
        """Digest of a short run that is always the same: equal on all computers whose results may be mixed."""

    def check(self, description: Json) -> None:
        """ValueError where run() could only fail; quickly."""

    def run(self, description: Json) -> Json:
        """The result; equal to the bit wherever code() and probe() are equal.

        UnfitWorkerError where this computer cannot run it, ValueError where nobody can: that is a result, too.
        """

    def expected_s(self, description: Json) -> float:
        """Roughly how long run() takes here."""


@lru_cache(maxsize=None)
def kind_of(name: str) -> TrialKind:
    """KeyError for a kind that there is not."""
    module, _, kind = KINDS[name].partition(":")
    made: TrialKind = getattr(import_module(module), kind)()
    return made


@dataclass(frozen=True)
class Trial:
    """`row` is what stands for it in the results' table."""

    number: int
    description: Json
    row: Json
    key: str

    @property
    def is_run_twice(self) -> bool:
        """One in a hundred, and the first: so that no sweep goes without."""
        return self.number == 0 or int(self.key[:8], 16) % 100 == 0


def key_of(kind: str, code: str, description: Json) -> str:
    """Under which a result is stored."""
    return text_hash(canonical({"kind": kind, "code": code, "trial": description}))
