"""A Dask cluster on this computer whose parts are processes that a test may kill, stop and start again by their ids."""

from __future__ import annotations

import contextlib
import json
import os
import pathlib
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Sequence

import namespaces

# As docs/sweeps.md advises: what Dask does by itself takes a fifth of the processor time then.
QUIET = {"DASK_DISTRIBUTED__WORKER__PROFILE__ENABLED": "False", "DASK_DISTRIBUTED__ADMIN__TICK__INTERVAL": "500ms"}
PACKAGE = pathlib.Path(__file__).resolve().parents[3] / "python"


def free_port() -> int:
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        return one.getsockname()[1]


def environment(**more: str) -> dict[str, str]:
    """The package of this tree, unless another one is in the path already."""
    path = os.environ.get("PYTHONPATH") or str(PACKAGE)
    return {**os.environ, "PYTHONPATH": path, "DASK_DISTRIBUTED__DASHBOARD__LINK": "", **QUIET, **more}


class Cluster:
    """`scheduler`, `workers`: processes, which may be replaced. `enter`: before each command, also of a client."""

    def __init__(self, folder: pathlib.Path, host: str = "127.0.0.1", enter: Sequence[str] = ()) -> None:
        self.folder, self.host, self.port, self.enter = folder, host, free_port(), enter
        self.address = f"{host}:{self.port}"
        self.processes: list[subprocess.Popen[bytes]] = []
        self.scheduler = self.start_scheduler()
        self.workers: list[subprocess.Popen[bytes]] = []

    def start_scheduler(self) -> subprocess.Popen[bytes]:
        self.scheduler = self._start(self.enter, "scheduler", "--host", self.host, "--port", str(self.port), "--no-dashboard")
        return self.scheduler

    def start_worker(self, *, host: str = "", enter: Sequence[str] = (), **more: str) -> subprocess.Popen[bytes]:
        """Where the scheduler is, unless it is told otherwise."""
        worker = self._start(
            enter or self.enter, "worker", f"tcp://{self.address}", "--host", host or self.host, "--nthreads", "1", "--no-nanny",
            "--no-dashboard", "--local-directory", str(self.folder / "scratch"), **more,
        )
        self.workers.append(worker)
        return worker

    def wait_for_workers(self, count: int, timeout_s: float = 60.0) -> None:
        """Until the scheduler knows so many."""
        end = time.monotonic() + timeout_s
        while (self.folder / "worker.log").read_bytes().count(b"Registered to:") < count:
            assert time.monotonic() < end, (self.folder / "worker.log").read_text()
            time.sleep(0.05)

    def make_whole(self) -> None:
        """A scheduler and two workers, whatever has died."""
        if self.scheduler.poll() is not None:
            self.start_scheduler()
        self.workers = [worker for worker in self.workers if worker.poll() is None]
        while len(self.workers) < 2:
            self.start_worker()

    def _start(self, enter: Sequence[str], what: str, *arguments: str, **more: str) -> subprocess.Popen[bytes]:
        self.folder.mkdir(parents=True, exist_ok=True)
        with (self.folder / f"{what}.log").open("ab") as log:
            process = subprocess.Popen(
                [*enter, sys.executable, "-m", "dask", what, *arguments],
                env=environment(**more), stdout=log, stderr=log,
            )
        self.processes.append(process)
        return process

    def __enter__(self) -> Cluster:
        return self

    def __exit__(self, *_: object) -> None:
        for process in self.processes:
            with contextlib.suppress(ProcessLookupError):
                process.send_signal(signal.SIGCONT)
                process.kill()
        for process in self.processes:
            process.wait()


class CutCluster(Cluster):
    """Its first worker is at the other end of a cable. It keeps what it ran in `far_store`, a link that may be set anew."""

    def __init__(self, folder: pathlib.Path, cable: namespaces.Cable) -> None:
        super().__init__(folder, namespaces.NEAR, cable.near)
        self.cable, self.far_store = cable, folder / "far_store"
        self.far_worker: subprocess.Popen[bytes] | None = None

    def make_whole(self) -> None:
        if self.far_worker is None or self.far_worker.poll() is not None:
            self.far_worker = self.start_worker(host=namespaces.FAR, enter=self.cable.far, GAITWAY_SWEEP_STORE=str(self.far_store))
        super().make_whole()


class FullCluster(Cluster):
    """Its first worker has a disk of its own, too small for what it runs."""

    def __init__(self, folder: pathlib.Path, kibibytes: int = 48) -> None:
        super().__init__(folder)
        self._small = folder / "small_disk"
        self.full_worker = self.start_worker(
            enter=namespaces.with_small_disk(self._small, kibibytes), GAITWAY_SWEEP_STORE=str(self._small)
        )

    @property
    def small_disk(self) -> pathlib.Path:
        """As its worker sees it."""
        return pathlib.Path(f"/proc/{self.full_worker.pid}/root{self._small}")


class SweepRun:
    """A sweep as a process of its own, with its folder. `enter`: before the command."""

    def __init__(
        self, file: pathlib.Path, on: str, out: pathlib.Path, store: pathlib.Path, *options: str, enter: Sequence[str] = (),
        own_group: bool = False,
    ) -> None:
        self.out = out
        out.mkdir(parents=True, exist_ok=True)
        self.log = out / "log.txt"
        with self.log.open("ab") as log:
            self.process = subprocess.Popen(
                [*enter, sys.executable, "-X", "faulthandler", "-m", "gaitway.sweep.command", str(file), "--on", on, "--out", str(out),
                 "--store", str(store), *options],
                env=environment(), stdout=log, stderr=log, start_new_session=own_group,
            )

    def known(self) -> int:
        """Whole lines of the partial table."""
        with contextlib.suppress(FileNotFoundError):
            return max(0, (self.out / "partial.csv").read_bytes().count(b"\n") - 1)
        return 0

    def wait_for(self, trials: int, timeout_s: float = 60.0) -> None:
        end = time.monotonic() + timeout_s
        while self.known() < trials:
            if time.monotonic() > end or self.process.poll() is not None:
                raise AssertionError(f"{self.known()} of {trials} trials: {self.log.read_text()}")
            time.sleep(0.02)

    def finish(self, timeout_s: float = 120.0) -> int:
        try:
            return self.process.wait(timeout_s)
        except subprocess.TimeoutExpired:
            self.process.send_signal(signal.SIGABRT)  # its log then says what each thread did
            self.process.wait()
            raise AssertionError(f"the sweep does not end: {self.log.read_text()}") from None

    def account(self) -> dict[str, object]:
        return json.loads((self.out / "sweep.json").read_text())


def stored(store: pathlib.Path) -> int:
    return sum(1 for _ in store.glob("??/*.json"))
