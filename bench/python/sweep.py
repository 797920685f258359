"""What a sweep costs beside its trials, what a second worker is worth, and what very many trials take.

    PYTHONPATH=build/release/lib/python python bench/python/sweep.py [--check]
    PYTHONPATH=build/release/lib/python python bench/python/sweep.py --trials 100000

One worker and two take turns, and the median of the rounds' ratios counts. `beside`: what workers had in time less what their trials took, a trial;
it grows with all that the computer does otherwise. `processor`: of client, workers and scheduler together, for a trial that costs nothing.
--check: exit code 1 where a target is missed. --trials: so many that cost nothing over two Dask workers, with the memory of each process over time.
"""

from __future__ import annotations

import argparse
import contextlib
import json
import multiprocessing
import os
import pathlib
import signal
import statistics
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tests/python/sweep"))

from loopback_cluster import Cluster, SweepRun

from gaitway.sweep.dask_pool import DaskPool
from gaitway.sweep.engine import Engine
from gaitway.sweep.local_pool import LocalPool
from gaitway.sweep.pool import Pool
from gaitway.sweep.store import Store
from gaitway.sweep.sweep_file import read_sweep

TICKS_PER_S = os.sysconf("SC_CLK_TCK")
PAGE_MB = os.sysconf("SC_PAGE_SIZE") / 1e6
KINDS = {  # trials of a round, sweep file
    "robot": (48, "seeds: {first}..{last}\nseconds: 2\n"),
    "rehearsal": (1000, "trial: rehearsal\nseeds: {first}..{last}\nparameters: {{rounds: [1]}}\n"),
}


@dataclass
class Place:
    """Where trials run: an engine that is used again and again, and the processes whose time it takes."""

    engine: Engine
    workers: int
    processes: Callable[[], list[int]]
    cluster: list[int]  # those that take time also while there is nothing to do

    @contextlib.contextmanager
    def awake(self) -> Iterator[None]:
        """Outside of this a cluster is stopped, so that it takes nothing from the other place."""
        self.signal(signal.SIGCONT)
        try:
            yield
        finally:
            self.signal(signal.SIGSTOP)

    def signal(self, number: signal.Signals) -> None:
        for process in self.cluster:
            os.kill(process, number)


@dataclass(frozen=True)
class Round:
    trials: int
    seconds: float
    trial_s: float  # of all trials, as their workers saw it
    processor_s: float  # of all processes

    def beside_ms(self, workers: int) -> float:
        return (workers * self.seconds - self.trial_s) / self.trials * 1e3


def processor_s(processes: list[int]) -> float:
    fields = [pathlib.Path(f"/proc/{process}/stat").read_text().rpartition(") ")[2].split() for process in processes]
    return sum(int(one[11]) + int(one[12]) for one in fields) / TICKS_PER_S


def memory_mb(process: int) -> float:
    return int(pathlib.Path(f"/proc/{process}/statm").read_text().split()[1]) * PAGE_MB


@contextlib.contextmanager
def places(kind: str, on: str, folder: pathlib.Path) -> Iterator[dict[int, Place]]:
    """With one worker, and with two."""
    with contextlib.ExitStack() as stack:
        made: dict[int, Place] = {}
        for workers in (1, 2):
            if on == "dask":
                cluster = stack.enter_context(Cluster(folder / f"cluster{workers}"))
                for _ in range(workers):
                    cluster.start_worker()
                cluster.wait_for_workers(workers)
                pool: Pool = DaskPool(cluster.address)
                processes = [process.pid for process in cluster.processes]
                here = lambda processes=processes: [os.getpid(), *processes]  # noqa: E731
            else:
                pool, processes = LocalPool(workers), []
                here = lambda: [os.getpid(), *(child.pid for child in multiprocessing.active_children() if child.pid)]  # noqa: E731
            stack.enter_context(pool)
            made[workers] = Place(Engine(kind, pool, Store(folder / f"store_{kind}_{on}_{workers}")), workers, here, processes)
            stack.callback(made[workers].signal, signal.SIGCONT)  # before its client says good-bye
        yield made


def run(place: Place, kind: str, number: int, folder: pathlib.Path, trials: int) -> Round:
    """Of trials that no other round has."""
    file = folder / "sweep.yaml"
    file.write_text(KINDS[kind][1].format(first=number * 1_000_000 + 1, last=number * 1_000_000 + trials))
    sweep = read_sweep(file)
    with place.awake():
        before, trial_s = processor_s(place.processes()), place.engine.tally.trial_s
        began = time.perf_counter()
        place.engine.run(sweep.trials(), lambda trial, text: None)
        seconds = time.perf_counter() - began
        return Round(trials, seconds, place.engine.tally.trial_s - trial_s, processor_s(place.processes()) - before)


def compare(kind: str, on: str, rounds: int, folder: pathlib.Path) -> tuple[float, float]:
    """Prints, and returns, what two workers are worth and what a trial costs beside it, in ms."""
    trials = KINDS[kind][0]
    with places(kind, on, folder) as made:
        for place in made.values():
            warm_up = 1000
            while warm_up == 1000 or len(place.engine.crew.admitted()) < place.workers:
                run(place, kind, warm_up, folder, 2 * place.workers)
                warm_up += 1
        played = [{workers: run(place, kind, number, folder, trials) for workers, place in made.items()} for number in range(1, rounds + 1)]
    gain = statistics.median(one[1].seconds / one[2].seconds for one in played)
    beside = {workers: statistics.median(one[workers].beside_ms(workers) for one in played) for workers in (1, 2)}
    processor_ms = statistics.median(one[2].processor_s / trials * 1e3 for one in played)
    trial_ms = statistics.median(one[2].trial_s / trials * 1e3 for one in played)
    print(
        f"{kind:9} {on:5} {trial_ms:8.2f} ms a trial; two workers {gain:.2f} x one; beside the trial {beside[1]:.2f} ms with one worker, "
        f"{beside[2]:.2f} ms with two; processor {processor_ms:.2f} ms a trial; {rounds} rounds of {trials}", flush=True,
    )
    return gain, beside[2]


def many(trials: int, folder: pathlib.Path) -> int:
    """How fast, and with how much memory, as JSON lines."""
    file = folder / "sweep.yaml"
    file.write_text(KINDS["rehearsal"][1].format(first=1, last=trials))
    with Cluster(folder / "cluster") as cluster:
        cluster.start_worker()
        cluster.start_worker()
        cluster.wait_for_workers(2)
        began, shown = time.monotonic(), 0.0
        sweep = SweepRun(file, f"dask://{cluster.address}", folder / "out", folder / "store")
        watched = {"client": sweep.process.pid, "scheduler": cluster.scheduler.pid, "worker": cluster.workers[0].pid}
        while sweep.process.poll() is None:
            time.sleep(0.2)
            progress = folder / "out/progress.json"
            if time.monotonic() - shown < 10 or not progress.exists():
                continue
            shown = time.monotonic()
            state = json.loads(progress.read_text())
            with contextlib.suppress(FileNotFoundError, IndexError):
                figures = {f"{name}_MB": round(memory_mb(process)) for name, process in watched.items()}
                figures |= {f"{name}_processor_s": round(processor_s([process])) for name, process in watched.items()}
                print(json.dumps({"s": round(shown - began), "done": state["done"], "ended": state["ended"], **figures}), flush=True)
        state = json.loads(progress.read_text())
        rate = state["done"] / state["seconds"]
        print(f"{state['done']} trials in {state['seconds']} s, {rate:.0f} a second; with all tables {time.monotonic() - began:.0f} s", flush=True)
    return 0 if sweep.process.returncode == 0 and rate >= 500 else 1


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rounds", type=int, default=7)
    parser.add_argument("--only", choices=list(KINDS), help="one kind of trial")
    parser.add_argument("--trials", type=int, metavar="N")
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    signal.signal(signal.SIGTERM, signal.default_int_handler)  # not without ending its clusters
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        if options.trials:
            return many(options.trials, folder)
        figures = {
            (kind, on): compare(kind, on, options.rounds, folder / f"{kind}_{on}")
            for kind in KINDS if options.only in (None, kind) for on in ("local", "dask") if not (folder / f"{kind}_{on}").mkdir()
        }
    met = all(gain >= 1.8 for (kind, _), (gain, _) in figures.items() if kind == "robot") and all(
        beside_ms <= 5 for _, beside_ms in figures.values()
    )
    return 0 if met or not options.check else 1


if __name__ == "__main__":
    sys.exit(main())
