"""Runs trials on a pool of workers, whatever dies meanwhile.

Trials are taken one after the other from an iterator, which may wait for results before it has more: a few requests are
with each worker, and nothing grows with what is still to come. A trial whose result is stored is not run. One in a hundred
runs on two workers.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from itertools import chain

from .canonical import Json
from .complaint import ResultsError, TrialError
from .crew import Crew
from .pool import Pool, Report
from .second_runs import FirstRun, SecondRuns
from .store import Kept, Store
from .trial import Trial
from .work import request_of

REQUEST_S = 0.25  # so long a request of short trials takes
MOST_IN_REQUEST = 200
MOST_STORED_AT_ONCE = 2000  # read from the store before reports are looked at
POLL_S = 0.2
DEADLY = 5  # workers that died running a trial: it is the trial's fault then

_NOTHING: Iterator[Trial | None] = iter(())
Sink = Callable[[Trial, str], None]  # told each trial's result once, in the order in which they become known


@dataclass
class Tally:
    """What became of the trials so far."""

    stored: int = 0  # were known before
    ran: int = 0
    given_again: int = 0  # were with a worker that has gone
    not_run_twice: int = 0  # of those that should have been, for want of a second worker
    trial_s: float = 0.0  # of those that ran
    by_worker: dict[str, int] = field(default_factory=dict)


@dataclass(frozen=True)
class _Request:
    worker: str
    trials: list[Trial]
    again: bool


class Engine:
    """Of one kind of trial and one pool; run() may be called again and again."""

    def __init__(
        self,
        kind: str,
        pool: Pool,
        store: Store,
        *,
        patience_s: float = 60.0,
        tell: Callable[[str], None] = lambda _: None,
    ) -> None:
        """`patience_s`: so long it waits where nobody is there. `tell`: news for people."""
        self._kind, self._pool, self._store = kind, pool, store
        self.tally = Tally()
        self.crew = Crew(patience_s, tell)
        self.second_runs = SecondRuns(store)
        self._in_flight: dict[int, _Request] = {}
        self._again: deque[Trial] = deque()
        self._deaths: dict[str, int] = {}  # by trial, of the few that met any
        self._mean_s: float | None = None  # of a trial

    def run(self, trials: Iterable[Trial | None], sink: Sink, look: Callable[[], None] = lambda: None) -> None:
        """Until each trial has its result. `look` is called a few times a second. Raises SweepError.

        `trials` says None where there is none now, and may be more as soon as `sink` has been told of those that run.
        """
        fresh = self._not_stored(trials, sink)
        try:
            fresh = self._from_first(fresh, look)
            more = fresh is not _NOTHING
            if not (more or self.second_runs.wanted):
                return  # without a worker
            self._store.require_writable()
            while True:
                self._look_for_workers()
                more = self._hand_out(fresh, more)
                if not (more or self._in_flight or self._again):
                    if not self.second_runs.possible(self.crew.admitted()):
                        break
                self.crew.require_somebody(self._pool.trouble())
                reads_on = more and not self._in_flight and bool(self.crew.admitted())
                for report in self._pool.poll(0.0 if reads_on else POLL_S):
                    self._take(report, sink)
                look()
        finally:
            for ticket in self._in_flight:
                self._pool.abandon(ticket)
            self._in_flight.clear()
            self._again.clear()
            self.tally.not_run_twice += self.second_runs.give_up()

    def _not_stored(self, trials: Iterable[Trial | None], sink: Sink) -> Iterator[Trial | None]:
        """None from time to time while it reads what is stored, so that reports don't wait."""
        for number, trial in enumerate(trials, 1):
            if trial is None:
                yield None
                continue
            text = self._store.find(trial.key)
            if text is None:
                yield trial
                continue
            self.tally.stored += 1
            self.second_runs.want(FirstRun(trial, text, None, ""))
            sink(trial, text)
            if number % MOST_STORED_AT_ONCE == 0:
                yield None

    def _from_first(self, fresh: Iterator[Trial | None], look: Callable[[], None]) -> Iterator[Trial | None]:
        """The same, from the first on that is to be run; _NOTHING where there is none."""
        known = -1
        for trial in fresh:
            if trial is not None or self.tally.stored == known:
                return chain([trial], fresh)
            known = self.tally.stored
            look()
        return _NOTHING

    def _look_for_workers(self) -> None:
        new, gone = self.crew.look(self._pool.members())
        for name in gone:
            for ticket in [ticket for ticket, request in self._in_flight.items() if request.worker == name]:
                self._pool.abandon(ticket)
                self._lose(ticket, died=True)
        for name in new:
            self._send(name, [], again=False)

    # Who gets what.

    def _hand_out(self, fresh: Iterator[Trial | None], more: bool) -> bool:
        """Whether there may be more of them."""
        held: dict[str, int] = {}
        for request in self._in_flight.values():
            held[request.worker] = held.get(request.worker, 0) + 1
        for depth in range(max((member.queue for member in self.crew.admitted().values()), default=0)):
            for name, member in self.crew.admitted().items():
                if held.get(name, 0) > depth or member.queue <= depth:
                    continue
                if second := self.second_runs.next_for(name):
                    self._send(name, [second], again=True)
                    continue
                trials: list[Trial] = []
                while len(trials) < self._request_size() and (self._again or more):
                    if self._again:
                        trials.append(self._again.popleft())
                        continue
                    try:
                        trial = next(fresh)
                    except StopIteration:
                        more = False
                        break
                    if trial is None:
                        break
                    trials.append(trial)
                if trials:
                    self._send(name, trials, again=False)
        return more

    def _request_size(self) -> int:
        if self._mean_s is None:
            return 1
        return max(1, min(MOST_IN_REQUEST, int(REQUEST_S / max(self._mean_s, 1e-6))))

    def _send(self, worker: str, trials: list[Trial], *, again: bool) -> None:
        described: list[Json] = [{"key": trial.key, "description": trial.description} for trial in trials]
        request = request_of(self._kind, self._store.folder, described, again=again)
        self._in_flight[self._pool.submit(worker, request)] = _Request(worker, trials, again)

    # What comes of it.

    def _take(self, report: Report, sink: Sink) -> None:
        if report.ticket not in self._in_flight:
            return
        if report.reply is None and report.error is None:
            self._lose(report.ticket, died=report.died)
            return
        request = self._in_flight[report.ticket]
        if report.error is not None:
            if request.trials:
                raise TrialError(f"worker {request.worker}, trial {request.trials[0].number}: {report.error}")
            self._refuse(report.ticket, f"cannot run Gaitway's trials: {report.error}")
        elif refusal := (report.reply or {}).get("refused"):
            self._refuse(report.ticket, f"{(report.reply or {})['worker']}: {refusal}")
        else:
            del self._in_flight[report.ticket]
            self._accept(request, report.reply or {}, sink)

    def _accept(self, request: _Request, reply: Json, sink: Sink) -> None:
        says = reply["worker"]
        self.crew.admit(request.worker, says)
        if request.again:
            self.second_runs.compare(request.trials[0].key, reply["results"][0]["text"], request.worker, says)
            return
        self._keep(reply["results"])
        for trial, result in zip(request.trials, reply["results"], strict=True):
            if result["ran"]:
                self._count(request.worker, result["seconds"])
            else:
                self.tally.stored += 1
            self.second_runs.want(FirstRun(trial, result["text"], request.worker if result["ran"] else None, says))
            sink(trial, result["text"])

    def _keep(self, results: list[Json]) -> None:
        """Where workers and client share a folder it is there already."""
        missing = [Kept(one["key"], one["text"]) for one in results if not self._store.has(one["key"])]
        try:
            self._store.keep_all(missing)
        except OSError as error:
            raise ResultsError(f"{self._store.folder}: {error.strerror}. Make room, or choose another --store") from error

    def _count(self, worker: str, seconds: float) -> None:
        self.tally.ran += 1
        self.tally.trial_s += seconds
        self.tally.by_worker[worker] = self.tally.by_worker.get(worker, 0) + 1
        self._mean_s = seconds if self._mean_s is None else 0.9 * self._mean_s + 0.1 * seconds

    def _refuse(self, ticket: int, why: str) -> None:
        """All that is with that worker goes to others."""
        worker = self._in_flight[ticket].worker
        self.crew.refuse(worker, why)
        for one in [one for one, request in self._in_flight.items() if request.worker == worker]:
            self._pool.abandon(one)
            self._give_again(self._in_flight.pop(one))

    def _lose(self, ticket: int, *, died: bool) -> None:
        request = self._in_flight[ticket]
        older = sum(1 for one, other in self._in_flight.items() if other.worker == request.worker and one < ticket)
        member = self.crew.member(request.worker)
        if died and request.trials and older < (member.at_once if member else 1):  # it ran, the others waited
            self._note_death(request.trials)
        del self._in_flight[ticket]
        self._give_again(request)

    def _note_death(self, trials: list[Trial]) -> None:
        for trial in trials:
            self._deaths[trial.key] = self._deaths.get(trial.key, 0) + 1
        if len(trials) == 1 and self._deaths[trials[0].key] >= DEADLY:
            raise TrialError(f"trial {trials[0].number} has ended {DEADLY} workers that ran it: {trials[0].description}")
        if len(trials) > 1:
            self._mean_s = None  # one in a request from now on, which shows who it is

    def _give_again(self, request: _Request) -> None:
        if request.again:
            self.second_runs.lost(request.trials[0].key)
            return
        self.tally.given_again += len(request.trials)
        self._again.extendleft(reversed(request.trials))
