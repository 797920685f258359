"""A trial of the gait's table: a series of its trials of one seed at one level, played by the program `gaitway-measure`."""

from __future__ import annotations

import json
import subprocess
import tempfile
import threading
from functools import lru_cache
from pathlib import Path
from typing import IO

from gaitway.sweep.canonical import Json, files_hash
from gaitway.sweep.complaint import InputError, UnfitWorkerError
from gaitway.sweep.robot_trial import place_of
from gaitway.sweep.trial import kind_of

SERIES = ("row", "level", "seed", "first", "count", "seconds")
SUBJECT = ("robot", "config", "quick", "fingerprint")
TRIES = 2  # a process that is killed is worth another one
LAST_WORDS = 2000


class GaitSeries:
    """What a worker and the client have in common about the series of the gait's table."""

    measures = ("outcomes",)

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._idle: list[Player] = []

    @lru_cache(maxsize=None)  # noqa: B019: one instance lives as long as the process
    def code(self) -> str:
        """Libraries, robot and configuration are in each description's fingerprint, which the program makes of what it loads."""
        return files_hash({"gait_series.py": Path(__file__), "gaitway-measure": program()})

    def probe(self) -> str:
        """The robot's: the program has the same simulator."""
        return kind_of("robot").probe()

    def expected_s(self, description: Json) -> float:
        return kind_of("robot").expected_s(description)

    def check(self, description: Json) -> None:
        if missing := [name for name in (*SUBJECT, *SERIES) if name not in description]:
            raise ValueError(f"a series of the gait's table has no {missing[0]}")

    def run(self, description: Json) -> Json:
        """UnfitWorkerError for whatever keeps it from being played: an outcome is stored, a failure is not."""
        self.check(description)
        trouble = UnfitWorkerError()
        for _ in range(TRIES):
            player = self._player(description)
            try:
                outcomes = player.play(description)
            except UnfitWorkerError as error:
                player.end()
                trouble = error
                continue
            with self._lock:
                self._idle.append(player)
            return {"outcomes": outcomes}
        raise trouble

    def _player(self, description: Json) -> Player:
        """One that waits, if it has that robot; those of others end."""
        wanted = {name: description[name] for name in SUBJECT}
        with self._lock:
            while self._idle:
                player = self._idle.pop()
                if player.subject == wanted:
                    return player
                player.end()
        return Player(wanted)


class Player:
    """A process that plays one series after the other. It ends with whoever made it."""

    def __init__(self, subject: Json) -> None:
        """UnfitWorkerError where the robot is not there, or is another than the client's."""
        self.subject = subject
        line = [str(program()), "measure", "gait", "--plays-series", *(["--quick"] if subject["quick"] else [])]
        for what in ("robot", "config"):
            place = place_of(what, subject[what])
            if not place.exists():
                raise UnfitWorkerError(f"has no {what} {subject[what]}. Share the folder, or copy it there")
            line += [f"--{what}", str(place)]
        self._errors: IO[bytes] = tempfile.TemporaryFile()  # noqa: SIM115: it lives as long as the process
        try:
            self._process = subprocess.Popen(line, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=self._errors)
        except OSError as error:
            raise UnfitWorkerError(f"cannot run {line[0]}: {error.strerror}") from error
        if self._hear()["fingerprint"] != subject["fingerprint"]:
            self.end()
            raise UnfitWorkerError(
                f"its robot {subject['robot']}, configuration {subject['config']}, plug-ins or libraries are others than the "
                "client's. Share the folders, or copy them there, and install the same wheel"
            )

    def play(self, series: Json) -> list[Json]:
        """The outcomes, up to the one that decides."""
        assert self._process.stdin
        try:
            self._process.stdin.write(json.dumps({name: series[name] for name in SERIES}).encode() + b"\n")
            self._process.stdin.flush()
        except OSError:
            pass  # it has died: what it leaves behind says why
        reply = self._hear()
        if "error" in reply:
            where = f"row {series['row']}, level {series['level']}, seed {series['seed']}"
            raise UnfitWorkerError(f"cannot play the trials of {where}: {reply['error']}")
        outcomes: list[Json] = reply["outcomes"]
        if not 0 < len(outcomes) <= series["count"]:
            raise UnfitWorkerError(f"gave {len(outcomes)} outcomes of {series['count']} trials")
        return outcomes

    def end(self) -> None:
        self._process.kill()
        self._process.communicate()

    def _hear(self) -> Json:
        assert self._process.stdout
        line = self._process.stdout.readline()
        try:
            message: Json = json.loads(line)
            return message
        except ValueError:  # cut off, or nothing: it has died
            self.end()
        self._errors.seek(0)
        words = self._errors.read()[-LAST_WORDS:].decode(errors="replace").strip()
        code = self._process.returncode
        how = f"signal {-code}" if code < 0 else f"code {code}"
        raise UnfitWorkerError(f"{program()} ended with {how}{': ' if words else ''}{words}")


def program() -> Path:
    """InputError where the package was built without the programs."""
    from gaitway import _native

    place = Path(_native.installation_root()) / "bin" / "gaitway-measure"
    if not place.exists():
        raise InputError(f"{place} is missing: this package was built without the programs")
    return place


def shipped_or_path(what: str, path: str) -> str:
    """A robot's folder or a configuration as a description has it: each computer has the shipped ones elsewhere."""
    name = Path(path).name if what == "robot" else Path(path).stem
    return name if place_of(what, name).resolve() == Path(path).resolve() else path
