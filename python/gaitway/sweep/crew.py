"""Which workers are there, and which of them may run trials."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from enum import Enum, auto

from .complaint import NoWorkersError
from .pool import Member

GRACE_S = 5.0  # after all that are there were refused: another may be about to come


class _Standing(Enum):
    joining = auto()
    admitted = auto()
    refused = auto()


class Crew:
    """A newcomer joins, and is admitted or refused by what it says of itself. A name that goes never comes back."""

    def __init__(self, patience_s: float, tell: Callable[[str], None]) -> None:
        self._patience_s, self._tell = patience_s, tell
        self._members: Mapping[str, Member] = {}
        self._standing: dict[str, _Standing] = {}
        self._alone_since: float | None = None
        self.refused: dict[str, str] = {}  # why

    def look(self, members: Mapping[str, Member]) -> tuple[list[str], list[str]]:
        """Newcomers, and those that have gone."""
        self._members = members
        gone = [name for name in self._standing if name not in members]
        for name in gone:
            if self._standing.pop(name) is not _Standing.refused:
                self._tell(f"worker {name} has gone")
        new = [name for name in members if name not in self._standing]
        self._standing.update(dict.fromkeys(new, _Standing.joining))
        return new, gone

    def admit(self, name: str, says: str) -> None:
        if self._standing.get(name) is _Standing.joining:
            self._standing[name] = _Standing.admitted
            self._tell(f"worker {name} ({says})")

    def refuse(self, name: str, why: str) -> None:
        if name not in self.refused:
            self._tell(f"worker {name} is refused: {why}")
        self.refused[name] = why
        if name in self._standing:
            self._standing[name] = _Standing.refused

    def admitted(self) -> dict[str, Member]:
        return {
            name: self._members[name] for name, one in self._standing.items() if one is _Standing.admitted
        }

    def member(self, name: str) -> Member | None:
        return self._members.get(name)

    def require_somebody(self, trouble: str) -> None:
        """NoWorkersError when nobody has been there, who may run trials, for too long."""
        standings = set(self._standing.values())
        if standings & {_Standing.admitted, _Standing.joining}:
            self._alone_since = None
            return
        now = time.monotonic()
        self._alone_since = self._alone_since or now
        if now - self._alone_since > (min(GRACE_S, self._patience_s) if standings else self._patience_s):
            why = "".join(f"\n  {name} is refused: {why}" for name, why in self.refused.items())
            raise NoWorkersError(
                f"no workers: {trouble or 'nobody may run these trials'}. What has run is stored, and the same command "
                f"goes on from there{why}"
            )
