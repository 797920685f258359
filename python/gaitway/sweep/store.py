"""The results of trials in a folder: a file each, named by the trial's key, whole or not there.

A file is written beside its place, brought to the disk, and renamed. A kill leaves at most a file that is
in nobody's way; a loss of power, in addition, may take the newest renames back: those trials run again.
"""

from __future__ import annotations

import contextlib
import json
import os
import tempfile
import time
from collections.abc import Iterable
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from uuid import uuid4

from .canonical import text_hash
from .complaint import InputError, ResultsError

WRITERS = 16  # side by side: the disk then brings many files in one go
LEFT_OVER_S = 3600.0  # what a killed process began to write is removed after that


def default_folder() -> Path:
    """Of this user, on this computer: GAITWAY_SWEEP_STORE, or below the cache."""
    if chosen := os.environ.get("GAITWAY_SWEEP_STORE"):
        return Path(chosen)
    cache = os.environ.get("XDG_CACHE_HOME")
    return (Path(cache) if cache else Path.home() / ".cache") / "gaitway" / "trials"


def open_store(folder: Path | None) -> Store:
    """As --store says; None: the default folder. InputError where it cannot be made."""
    place = folder or default_folder()
    try:
        store = Store(place)
        store.remove_left_overs()
        return store
    except OSError as error:
        raise InputError(f"--store {place}: {error.strerror}. Choose another folder") from error


@dataclass(frozen=True)
class Kept:
    """A result as it goes into the store: `text` is its canonical JSON."""

    key: str
    text: str


class Store:
    """Any number of processes may use one folder at once."""

    def __init__(self, folder: Path) -> None:
        """OSError that names the folder where it cannot be made."""
        self.folder = folder
        folder.mkdir(parents=True, exist_ok=True)
        self._writers = ThreadPoolExecutor(WRITERS, thread_name_prefix="store")

    def require_writable(self) -> None:
        """InputError."""
        try:
            with tempfile.TemporaryFile(dir=self.folder):
                pass
        except OSError as error:
            raise InputError(f"--store {self.folder}: {error.strerror}. Choose another folder") from error

    def find(self, key: str) -> str | None:
        """A result's text. A file that is not what it says counts as missing, and is written anew."""
        try:
            kept = json.loads(self._place(key).read_bytes())
            text = kept["result"]
            json.loads(text)
            return text if kept["key"] == key and kept["check"] == text_hash(text) else None
        except (FileNotFoundError, ValueError, KeyError, TypeError, RecursionError):
            return None
        except OSError as error:
            raise ResultsError(f"{self._place(key)}: {error.strerror}. Remove it, or choose another --store") from error

    def has(self, key: str) -> bool:
        """Without a look into it."""
        return self._place(key).exists()

    def keep(self, key: str, text: str) -> None:
        """On the disk when it returns. OSError where the disk is full or the folder not writable."""
        place = self._place(key)
        place.parent.mkdir(exist_ok=True)
        beside = place.with_name(f".{key[:16]}.{uuid4().hex}.part")
        content = json.dumps({"key": key, "check": text_hash(text), "result": text}).encode()
        try:
            with beside.open("xb") as file:
                file.write(content)
                file.flush()
                os.fsync(file.fileno())
            beside.rename(place)
        except BaseException:
            with contextlib.suppress(OSError):
                beside.unlink()
            raise

    def keep_soon(self, result: Kept) -> Future[None]:
        """As keep(), beside others; its outcome is the future's."""
        return self._writers.submit(self.keep, result.key, result.text)

    def keep_all(self, results: Iterable[Kept]) -> None:
        """As keep(), for many at once; the first that fails raises, when all others are through."""
        waiting = [self.keep_soon(one) for one in results]
        errors = [error for one in waiting if (error := one.exception())]
        if errors:
            raise errors[0]

    def forget(self, key: str) -> None:
        self._place(key).unlink(missing_ok=True)
        self._mark(key).unlink(missing_ok=True)

    def was_run_twice(self, key: str) -> bool:
        return self._mark(key).exists()

    def note_run_twice(self, key: str) -> None:
        self._mark(key).parent.mkdir(exist_ok=True)
        self._mark(key).touch()

    def remove_left_overs(self) -> None:
        for part in self.folder.glob("??/.*.part"):
            with contextlib.suppress(OSError):
                if time.time() - part.stat().st_mtime > LEFT_OVER_S:
                    part.unlink()

    def _place(self, key: str) -> Path:
        return self.folder / key[:2] / f"{key[2:]}.json"

    def _mark(self, key: str) -> Path:
        return self.folder / key[:2] / f"{key[2:]}.twice"
