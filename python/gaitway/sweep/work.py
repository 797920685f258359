"""What a worker does, wherever it runs: says what it is, and runs trials, each stored before it is reported.

Requests and replies are dictionaries of plain values, so that versions that differ can still tell each other so.
"""

from __future__ import annotations

import errno
import os
import platform
import socket
import time
from collections.abc import Callable
from functools import lru_cache
from pathlib import Path

from .canonical import Json, canonical
from .complaint import UnfitWorkerError
from .store import Kept, Store
from .trial import KINDS, kind_of

PROTOCOL = 1


def versions() -> Json:
    """What must be the same on both sides before a hash is worth comparing."""
    return {"gaitway": _version(), "sweep protocol": PROTOCOL, "machine": platform.machine()}


def _version() -> str:
    """A package without its simulator can still rehearse."""
    try:
        from gaitway import __version__
    except ImportError:
        return "without simulator"
    return str(__version__)


@lru_cache(maxsize=None)
def identity(kind: str) -> Json:
    """Of this process: its code, and what a short run comes to on this computer."""
    trials = kind_of(kind)
    return {"code": trials.code(), "probe": trials.probe()}


def request_of(kind: str, store: Path | None, trials: list[Json], *, again: bool = False) -> Json:
    """`trials`: [{"key", "description"}]; none: only admission. `again`: run even what is stored, store nothing."""
    return {
        "kind": kind,
        "versions": versions(),
        "identity": identity(kind),
        "store": None if store is None else str(store),
        "trials": trials,
        "again": again,
    }


def perform(request: Json, before_storing: Callable[[], None] | None = None) -> Json:
    """{"worker", "results"}, or {"worker", "refused"}: why this worker must run nothing of this sweep.

    `before_storing` is called when all trials of the request have run: others may run while the disk works.
    """
    me = f"{socket.gethostname()}, process {os.getpid()}"
    try:
        admit(request)
        return {"worker": me, "results": _run_all(request, before_storing)}
    except UnfitWorkerError as error:
        return {"worker": me, "refused": str(error)}


def admit(request: Json) -> None:
    """UnfitWorkerError with the first difference."""
    wanted, mine = request["versions"], versions()
    for name in wanted:
        if mine.get(name) != wanted[name]:
            raise UnfitWorkerError(
                f"version skew: {name} is {mine.get(name)} here and {wanted[name]} at the client. Install the same wheel"
            )
    if request["kind"] not in KINDS:
        raise UnfitWorkerError(f"does not know trials of the kind '{request['kind']}'. Install the same wheel")
    for name, meaning in (("code", "its programs and plug-ins are others"), ("probe", "the same run ends elsewhere")):
        here, there = identity(request["kind"])[name], request["identity"][name]
        if here != there:
            raise UnfitWorkerError(f"{name} digest is {here[:16]} here and {there[:16]} at the client: {meaning}")


def store_folder(request: Json) -> Path | None:
    """This computer's own choice comes before the client's."""
    chosen = os.environ.get("GAITWAY_SWEEP_STORE") or request["store"]
    return Path(chosen) if chosen else None


@lru_cache(maxsize=8)
def _store(folder: Path) -> Store:
    return Store(folder)


def _run_all(request: Json, before_storing: Callable[[], None] | None) -> list[Json]:
    folder = store_folder(request)
    try:
        store = _store(folder) if folder and request["trials"] and not request["again"] else None
        results, waiting = [], []
        for trial in request["trials"]:
            found = store.find(trial["key"]) if store else None
            results.append(_run(request["kind"], trial) if found is None else _reply(trial["key"], found, 0.0, False))
            if store and found is None:
                waiting.append(store.keep_soon(Kept(trial["key"], results[-1]["text"])))
        if before_storing:
            before_storing()
        for one in waiting:
            one.result()
        return results
    except OSError as error:
        full = error.errno in (errno.ENOSPC, errno.EDQUOT)
        reason = "the disk is full. Make room" if full else f"{error.strerror}. Let it be writable"
        raise UnfitWorkerError(f"cannot store results in {folder}: {reason}, or set GAITWAY_SWEEP_STORE there") from error


def _run(kind: str, trial: Json) -> Json:
    began = time.perf_counter()
    try:
        text = canonical(kind_of(kind).run(trial["description"]))
    except ValueError as error:
        text = canonical({"error": str(error)})
    except OSError as error:
        raise UnfitWorkerError(f"cannot run the trial: {error}") from error
    return _reply(trial["key"], text, time.perf_counter() - began, True)


def _reply(key: str, text: str, seconds: float, ran: bool) -> Json:
    return {"key": key, "text": text, "seconds": seconds, "ran": ran}
