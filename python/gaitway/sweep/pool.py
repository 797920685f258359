"""Workers as the engine sees them: who is there, a request to one of them, and what became of it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import TracebackType
from typing import Protocol, Self

from .canonical import Json


@dataclass(frozen=True)
class Member:
    """`at_once`: trials that it runs side by side. `queue`: requests that it may hold, those that run included."""

    at_once: int
    queue: int


@dataclass(frozen=True)
class Report:
    """Of one request: a reply, or `error` with what was raised, or neither: it is lost, `died`: with its worker."""

    ticket: int
    reply: Json | None = None
    error: str | None = None
    died: bool = False


class Pool(Protocol):
    """Used by one thread."""

    def members(self) -> Mapping[str, Member]:
        """Those that are there now, by a name that no later worker gets."""

    def submit(self, worker: str, request: Json) -> int:
        """The request's ticket. A worker works its requests off in their order."""

    def poll(self, timeout_s: float) -> list[Report]:
        """What has come since; waits so long for the first. Each ticket is reported once."""

    def abandon(self, ticket: int) -> None:
        """No report of it is wanted any more."""

    def trouble(self) -> str:
        """Why nobody is there, where that is known; otherwise empty."""

    def __enter__(self) -> Self: ...

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None: ...
