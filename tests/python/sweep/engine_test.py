"""The engine against workers that are made up: who gets what, who is refused, and what two different results mean."""

from __future__ import annotations

import itertools
import pathlib
from collections import deque
from collections.abc import Callable, Iterator
from typing import Any

import pytest

from gaitway.sweep.complaint import DisagreementError, NoWorkersError, ResultsError, TrialError
from gaitway.sweep.engine import MOST_IN_REQUEST, Engine
from gaitway.sweep.pool import Member, Report
from gaitway.sweep.second_runs import MOST_WAITING, FirstRun, SecondRuns
from gaitway.sweep.store import Store
from gaitway.sweep.trial import Trial, key_of, kind_of
from gaitway.sweep.work import perform

Json = dict[str, Any]
Answer = Callable[[Json], Report | Json | None]


class MadeUpPool:
    """`workers`: what each makes of a request; None: it dies of it."""

    def __init__(self, **workers: Callable[[Json], Json | None]) -> None:
        self.workers = dict(workers)
        self._waiting: deque[tuple[int, str, Json]] = deque()
        self._tickets = itertools.count(1)
        self.most_waiting = 0
        self.sent: list[tuple[str, Json]] = []
        self.timeouts_s: list[float] = []

    def members(self) -> dict[str, Member]:
        return {name: Member(at_once=1, queue=2) for name in self.workers}

    def submit(self, worker: str, request: Json) -> int:
        ticket = next(self._tickets)
        self.sent.append((worker, request))
        self._waiting.append((ticket, worker, request))
        self.most_waiting = max(self.most_waiting, sum(len(one["trials"]) for _, _, one in self._waiting))
        return ticket

    def poll(self, timeout_s: float) -> list[Report]:
        self.timeouts_s.append(timeout_s)
        if not self._waiting:
            return []
        ticket, worker, request = self._waiting.popleft()
        if worker not in self.workers:
            return []
        reply = self.workers[worker](request)
        if reply is None:
            del self.workers[worker]
            return []
        return [Report(ticket, reply)]

    def abandon(self, ticket: int) -> None:
        pass

    def trouble(self) -> str:
        return ""

    def __enter__(self) -> MadeUpPool:
        return self

    def __exit__(self, *_: object) -> None:
        pass


def trials(count: int) -> list[Trial]:
    code = kind_of("rehearsal").code()
    described = [{"seed": seed, "rounds": 1} for seed in range(count)]
    return [Trial(n, one, {"trial": n}, key_of("rehearsal", code, one)) for n, one in enumerate(described)]


def run(pool: MadeUpPool, store: Store, count: int, **options: Any) -> tuple[Engine, dict[int, str]]:
    results: dict[int, str] = {}
    engine = Engine("rehearsal", pool, store, **options)
    engine.run(iter(trials(count)), lambda trial, text: results.__setitem__(trial.number, text))
    return engine, results


@pytest.fixture
def store(tmp_path: pathlib.Path) -> Store:
    return Store(tmp_path / "store")


def test_each_trial_runs_once_and_some_on_two_workers(store: Store) -> None:
    pool = MadeUpPool(a=perform, b=perform)
    engine, results = run(pool, store, 500)
    assert sorted(results) == list(range(500))
    assert engine.tally.ran == 500
    wanted = sum(trial.is_run_twice for trial in trials(500))
    assert engine.second_runs.agreed == wanted >= 1
    again = [(worker, request["trials"][0]["key"]) for worker, request in pool.sent if request["again"]]
    first = {trial["key"]: worker for worker, request in pool.sent if not request["again"] for trial in request["trials"]}
    assert len(again) == wanted
    assert all(first[key] != worker for worker, key in again)


def test_what_is_stored_does_not_run(store: Store) -> None:
    _, before = run(MadeUpPool(a=perform, b=perform), store, 50)
    pool = MadeUpPool(a=perform, b=perform)
    engine, results = run(pool, store, 60)
    assert (engine.tally.stored, engine.tally.ran) == (50, 10)
    assert {n: results[n] for n in before} == before


def test_few_trials_are_out_at_a_time(store: Store) -> None:
    pool = MadeUpPool(a=perform, b=perform)
    run(pool, store, 5000)
    assert pool.most_waiting <= 2 * 2 * MOST_IN_REQUEST


def test_what_comes_next_may_depend_on_results(store: Store) -> None:
    results: dict[int, str] = {}

    def one_after_the_other() -> Iterator[Trial | None]:
        for trial in trials(20):
            yield trial
            while trial.number not in results:
                yield None

    for ran in (20, 0):
        pool = MadeUpPool(a=perform, b=perform)
        results.clear()
        engine = Engine("rehearsal", pool, store)
        engine.run(one_after_the_other(), lambda trial, text: results.__setitem__(trial.number, text))
        assert sorted(results) == list(range(20))
        assert engine.tally.ran == ran
        assert pool.most_waiting <= 2  # the second is a second run


def test_whoever_waits_for_workers_takes_no_processor_time(store: Store) -> None:
    pool = MadeUpPool()
    with pytest.raises(NoWorkersError):
        run(pool, store, 3, patience_s=0.1)
    assert min(pool.timeouts_s) > 0


def test_a_broken_file_in_the_store_runs_again(store: Store) -> None:
    run(MadeUpPool(a=perform), store, 3)
    victim = sorted(store.folder.glob("??/*.json"))[0]
    victim.write_bytes(victim.read_bytes()[:-20])
    engine, results = run(MadeUpPool(a=perform), store, 3)
    assert (engine.tally.stored, engine.tally.ran, len(results)) == (2, 1, 3)


def test_what_cannot_be_read_in_the_store_is_named(store: Store) -> None:
    [trial] = trials(1)
    place = store.folder / trial.key[:2] / f"{trial.key[2:]}.json"
    place.mkdir(parents=True)
    with pytest.raises(ResultsError, match=trial.key[2:]):
        store.find(trial.key)
    place.rmdir()
    place.write_text("[" * 200_000)
    assert store.find(trial.key) is None


def test_a_worker_that_computes_otherwise_is_refused_by_name(store: Store) -> None:
    def other(request: Json) -> Json:
        return perform({**request, "identity": {**request["identity"], "probe": "0123456789abcdef"}})

    engine, results = run(MadeUpPool(good=perform, bad=other), store, 20)
    assert len(results) == 20
    assert set(engine.tally.by_worker) == {"good"}
    assert list(engine.crew.refused) == ["bad"]
    assert "probe digest" in engine.crew.refused["bad"]


def test_a_worker_of_another_version_says_so(store: Store) -> None:
    def old(request: Json) -> Json:
        return perform({**request, "versions": {**request["versions"], "gaitway": "0.0.1"}})

    with pytest.raises(NoWorkersError, match=r"old is refused: .*version skew: gaitway is .* and 0\.0\.1 at the client"):
        run(MadeUpPool(old=old), store, 3, patience_s=0.2)


def test_two_results_for_a_trial_end_the_sweep_and_name_both(store: Store) -> None:
    def lies(request: Json) -> Json:
        reply = perform(request)
        for result in reply["results"]:
            result["text"] = '{"digest":"0","value":0}'
        reply["worker"] = "liar, process 1"
        return reply

    # Its lies go into its own store only.
    with pytest.raises(DisagreementError) as error:
        run(MadeUpPool(honest=perform, liar=lies), store, 40)
    assert "honest" in str(error.value) and "liar" in str(error.value)
    assert error.value.exit_code == 5


def test_a_trial_that_ends_its_workers_is_named(store: Store) -> None:
    def mortal(request: Json) -> Json | None:
        return None if any(trial["description"]["seed"] == 7 for trial in request["trials"]) else perform(request)

    pool = MadeUpPool(**{f"w{n}": mortal for n in range(40)})
    with pytest.raises(TrialError, match="trial 7 has ended 5 workers"):
        run(pool, store, 10)


def test_a_lone_worker_says_that_nothing_was_compared(store: Store) -> None:
    engine, _ = run(MadeUpPool(a=perform), store, 20)
    assert engine.second_runs.agreed == 0
    assert engine.tally.not_run_twice == sum(trial.is_run_twice for trial in trials(20))


def test_what_waits_for_a_second_worker_does_not_grow_with_the_sweep(store: Store) -> None:
    seconds = SecondRuns(store)
    wanted = [trial for trial in trials(150_000) if trial.is_run_twice]
    assert len(wanted) > MOST_WAITING
    for trial in wanted:
        seconds.want(FirstRun(trial, "{}", "a", "a"))
    taken = 0
    while seconds.next_for("b"):
        taken += 1
    assert taken == MOST_WAITING
    assert seconds.give_up() == len(wanted)


def test_nobody_comes(store: Store) -> None:
    with pytest.raises(NoWorkersError, match="What has run is stored"):
        run(MadeUpPool(), store, 3, patience_s=0.1)


def test_a_full_disk_at_a_worker_is_its_own_trouble(store: Store, monkeypatch: pytest.MonkeyPatch) -> None:
    """/dev/full is full."""
    def full(request: Json) -> Json:
        with monkeypatch.context() as patch:
            patch.setattr(Store, "keep_soon", _on_a_full_disk)
            return perform(request)

    engine, results = run(MadeUpPool(a=perform, full=full), store, 30)
    assert len(results) == 30
    assert "the disk is full" in engine.crew.refused["full"]


def _on_a_full_disk(_store: Store, _result: object) -> None:
    with open("/dev/full", "wb", buffering=0) as disk:
        disk.write(b"0")
