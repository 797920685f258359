"""Workers on this computer: a process each. One that dies is replaced by a new one, and they die with their client."""

from __future__ import annotations

import multiprocessing
import signal
import time
import traceback
from collections.abc import Mapping
from dataclasses import dataclass
from multiprocessing import resource_tracker
from multiprocessing.connection import Connection, wait
from multiprocessing.context import SpawnProcess
from types import TracebackType
from typing import Self

from .canonical import Json
from .pool import Member, Report
from .work import perform

LIFE_S = 2.0  # a worker that dies sooner is replaced only after that: no storm of processes


def _serve(requests: Connection) -> None:
    """Of a worker's process; ends when the client has gone."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is the client's
    signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGINT})
    while True:
        try:
            request: Json = requests.recv()
        except (EOFError, OSError):
            return
        try:
            answer: Json = {"reply": perform(request)}
        except Exception:
            answer = {"error": traceback.format_exc(limit=-4)}
        try:
            requests.send(answer)
        except OSError:
            return


@dataclass
class _Worker:
    process: SpawnProcess
    requests: Connection
    began: float
    ticket: int | None = None


class LocalPool:
    """`count` processes."""

    def __init__(self, count: int) -> None:
        self._count = count
        self._context = multiprocessing.get_context("spawn")
        self._workers: dict[str, _Worker] = {}
        self._started = 0
        self._tickets = 0
        self._not_before = 0.0

    def members(self) -> Mapping[str, Member]:
        while len(self._workers) < self._count and time.monotonic() >= self._not_before:
            self._start()
        return {name: Member(at_once=1, queue=1) for name in self._workers}

    def submit(self, worker: str, request: Json) -> int:
        self._tickets += 1
        self._workers[worker].ticket = self._tickets
        try:
            self._workers[worker].requests.send(request)
        except OSError:
            pass  # it has died: poll() finds its end
        return self._tickets

    def poll(self, timeout_s: float) -> list[Report]:
        by_end = {worker.requests: name for name, worker in self._workers.items()}
        ready = wait(list(by_end), timeout_s)
        return [report for end in ready if isinstance(end, Connection) and (report := self._receive(by_end[end]))]

    def abandon(self, ticket: int) -> None:
        for worker in self._workers.values():
            if worker.ticket == ticket:
                worker.ticket = None

    def trouble(self) -> str:
        return "the processes end as soon as they begin" if self._not_before else ""

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        for worker in self._workers.values():
            worker.requests.close()
            if worker.ticket is not None:
                worker.process.kill()
        for worker in self._workers.values():
            worker.process.join()
        self._workers.clear()

    def _start(self) -> None:
        self._started += 1
        here, there = self._context.Pipe()
        process = self._context.Process(target=_serve, args=(there,), daemon=True)
        resource_tracker.ensure_running()  # by itself it would come with the first process, and unblock what is blocked here
        before = signal.pthread_sigmask(signal.SIG_BLOCK, [])
        try:
            signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})  # in the process, until it ignores it
            process.start()
        finally:
            signal.pthread_sigmask(signal.SIG_SETMASK, before)
        there.close()
        self._workers[f"local-{self._started}"] = _Worker(process, here, time.monotonic())

    def _receive(self, name: str) -> Report | None:
        worker = self._workers[name]
        try:
            answer: Json | None = worker.requests.recv()
        except (EOFError, OSError):
            answer = None
            del self._workers[name]
            worker.requests.close()
            worker.process.join()
            self._not_before = max(self._not_before, worker.began + LIFE_S)
        ticket, worker.ticket = worker.ticket, None
        if ticket is None:
            return None
        return Report(ticket, died=True) if answer is None else Report(ticket, answer.get("reply"), answer.get("error"))
