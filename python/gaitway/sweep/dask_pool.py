"""Workers of a Dask cluster. Dask carries requests and knows who is there; who gets what is the engine's matter.

Each request is bound to one worker, so that two runs of a trial are on two, and a worker that is refused gets nothing.
A scheduler that goes away takes the requests with it; as soon as one answers at the address, workers are there again.
"""

from __future__ import annotations

import asyncio
import itertools
import json
import logging
import queue
import threading
import time
from collections.abc import Mapping
from contextlib import suppress
from types import TracebackType
from typing import Any, Self
from uuid import uuid4

from .canonical import Json, canonical
from .complaint import InputError
from .pool import Member, Report
from .work import perform

PINNED = "2025.11.0"  # client, scheduler and workers
LOOK_S = 0.5  # at who is there
SILENCE_S = 40.0  # of a scheduler that has gone; longer than a network's ordinary break of half a minute
CONNECT_S = 5.0


def perform_on_dask(request: str) -> Json:
    """Runs on a worker: while a request's results are brought to the disk, the worker's thread takes the next one.

    A request comes as a text, which takes a fifth of the memory: a scheduler keeps the last thousand that it sent to each worker.
    """
    from distributed import secede

    return perform(json.loads(request), before_storing=secede)


class DaskPool:
    """`address`: of the scheduler, HOST:PORT, or tls://HOST:PORT where Dask's configuration has the keys."""

    def __init__(self, address: str) -> None:
        try:
            import distributed
        except ImportError as error:
            raise InputError(
                f"--on dask://…: needs the package 'distributed'. pip install 'gaitway[dask]' (or distributed=={PINNED})"
            ) from error
        self._distributed = distributed
        self._address = address if "://" in address else f"tcp://{address}"
        self._members: dict[str, Member] = {}
        self._trouble = f"no scheduler answers at {self._address}"
        self._reports: queue.SimpleQueue[Report] = queue.SimpleQueue()
        self._tickets = itertools.count(1)
        self._tasks: dict[int, asyncio.Task[None]] = {}
        self._abandoned: set[int] = set()
        self._client: Any = None
        self._loop = asyncio.new_event_loop()
        self._thread = threading.Thread(target=self._loop.run_forever, name="dask", daemon=True)

    def members(self) -> Mapping[str, Member]:
        return dict(self._members) if self._is_connected(self._client) else {}

    def submit(self, worker: str, request: Json) -> int:
        ticket = next(self._tickets)
        self._loop.call_soon_threadsafe(self._begin, ticket, worker, request)
        return ticket

    def poll(self, timeout_s: float) -> list[Report]:
        reports: list[Report] = []
        with suppress(queue.Empty):
            reports.append(self._reports.get(timeout=timeout_s))
            while True:
                reports.append(self._reports.get_nowait())
        fresh = [report for report in reports if report.ticket not in self._abandoned]
        self._abandoned.difference_update(report.ticket for report in reports)
        return fresh

    def abandon(self, ticket: int) -> None:
        self._abandoned.add(ticket)
        self._loop.call_soon_threadsafe(self._end, ticket)

    def trouble(self) -> str:
        return self._trouble

    def __enter__(self) -> Self:
        logging.getLogger("distributed.client").setLevel(logging.CRITICAL)  # what it would say, trouble() says
        self._thread.start()
        self._connection = asyncio.run_coroutine_threadsafe(self._stay_connected(), self._loop)
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        asyncio.run_coroutine_threadsafe(self._close(), self._loop).result()
        self._loop.call_soon_threadsafe(self._loop.stop)
        self._thread.join()
        self._loop.close()

    # In the loop's thread from here on.

    async def _stay_connected(self) -> None:
        from distributed.comm.core import CommClosedError

        while True:
            client = self._connect()
            try:
                await client
                self._client = client
                await self._look(client)
            except (OSError, TimeoutError, CommClosedError) as error:
                self._trouble = f"no scheduler answers at {self._address}: {error}"
            finally:
                self._client = None
                self._members = {}
                for task in list(self._tasks.values()):
                    task.cancel()
                await client.close()
            await asyncio.sleep(LOOK_S)

    def _connect(self) -> Any:
        make: Any = self._distributed.Client
        return make(self._address, asynchronous=True, timeout=CONNECT_S)

    async def _look(self, client: Any) -> None:
        """Until the scheduler has gone."""
        heard = time.monotonic()
        while client.status == "running":
            asked = asyncio.ensure_future(client.nthreads())
            while not asked.done():
                await asyncio.wait({asked}, timeout=LOOK_S)
                silent = time.monotonic() - heard > SILENCE_S
                if not asked.done() and (silent or client.status != "running"):
                    asked.cancel()
                    raise TimeoutError(f"silent for {time.monotonic() - heard:.0f} s")
            threads: dict[str, int] = asked.result()
            heard = time.monotonic()
            self._trouble = "" if threads else f"the scheduler at {self._address} has no workers"
            self._members = {name: Member(at_once=count, queue=2 * count) for name, count in threads.items()}
            await asyncio.sleep(LOOK_S)
        self._trouble = f"the scheduler at {self._address} has gone"

    def _begin(self, ticket: int, worker: str, request: Json) -> None:
        self._tasks[ticket] = self._loop.create_task(self._follow(ticket, worker, request))

    def _end(self, ticket: int) -> None:
        if task := self._tasks.get(ticket):
            task.cancel()

    async def _follow(self, ticket: int, worker: str, request: Json) -> None:
        report, client = Report(ticket), self._client
        try:
            if not self._is_connected(client):
                await asyncio.sleep(LOOK_S)  # until members() knows it, too
            else:
                future = client.submit(
                    perform_on_dask,
                    canonical(request),
                    key=f"gaitway-{uuid4().hex}",
                    pure=False,
                    workers=[worker],
                    allow_other_workers=False,
                )
                report = Report(ticket, reply=await future)
        except (asyncio.CancelledError, self._distributed.CancelledError, self._distributed.KilledWorker, OSError):
            pass  # the worker has gone, or the scheduler
        except Exception as error:  # the trial's, or of a client whose scheduler has gone meanwhile
            if self._is_connected(client):
                report = Report(ticket, error=f"{type(error).__name__}: {error}")
        finally:
            del self._tasks[ticket]
            self._reports.put(report)

    def _is_connected(self, client: Any) -> bool:
        return client is not None and client is self._client and client.status == "running"

    async def _close(self) -> None:
        self._connection.cancel()
        for task in list(self._tasks.values()):
            task.cancel()
        while len(asyncio.all_tasks()) > 1:  # but this one
            await asyncio.sleep(0.01)
