"""One round of each fault: what dies, what is known then, and what becomes of the sweep. Run by faults_test.py, and again and
again by `python tests/python/sweep/faults.py --rounds 20 --away 30 [FAULT...]`.

worker, scheduler, client: kill -9. stopped: a worker hangs. network: a worker goes on computing, and nothing of it arrives.
disk: a worker's is full.
"""

from __future__ import annotations

import argparse
import contextlib
import pathlib
import signal
import statistics
import sys
import tempfile
import time
from collections.abc import Iterator
from dataclasses import dataclass

import conftest  # noqa: F401  where it runs by itself, it finds the package, too
import namespaces
from loopback_cluster import Cluster, CutCluster, FullCluster, SweepRun, stored

from gaitway.sweep.store import Store

FAULTS = ("worker", "scheduler", "client", "stopped", "network", "disk")
TRIALS = 80
SWEEP = f"""
trial: rehearsal
seeds: 1..{TRIALS // 2}
parameters: {{rounds: [20, 40], sleep_s: [0.04]}}
"""


@dataclass(frozen=True)
class Figures:
    """`again`: trials that a worker had and another one got. `rerun`: ran although their results were stored.

    `alone`: trials that a worker brought to its disk while nobody could hear of it.
    """

    seconds: float
    again: int
    rerun: int
    identical: bool
    exit_code: int
    words: str
    alone: int = 0


@contextlib.contextmanager
def cluster_for(fault: str, folder: pathlib.Path) -> Iterator[Cluster]:
    with contextlib.ExitStack() as stack:
        if fault == "network":
            yield stack.enter_context(CutCluster(folder, stack.enter_context(namespaces.Cable())))
        else:
            yield stack.enter_context(FullCluster(folder) if fault == "disk" else Cluster(folder))


def local_results(folder: pathlib.Path) -> bytes:
    file = folder / "sweep.yaml"
    file.write_text(SWEEP)
    run = SweepRun(file, "local:2", folder / "local", folder / "local_store")
    assert run.finish() == 0, run.log.read_text()
    return (run.out / "results.csv").read_bytes()


def one_round(fault: str, cluster: Cluster, folder: pathlib.Path, local: bytes, away_s: float) -> Figures:
    """The cluster is whole when it begins, and may lack workers when it ends."""
    folder.mkdir(parents=True)
    file = folder / "sweep.yaml"
    file.write_text(SWEEP)
    store = folder / "store"
    cluster.make_whole()
    on = f"dask://{cluster.address}"
    began = time.monotonic()
    if isinstance(cluster, CutCluster):
        cluster.far_store.unlink(missing_ok=True)
        (folder / "far").mkdir()
        cluster.far_store.symlink_to(folder / "far")
    run = SweepRun(file, on, folder / "out", store, enter=cluster.enter)
    run.wait_for(10)
    before = alone = 0
    if fault == "worker":
        cluster.workers[0].kill()
        cluster.workers[0].wait()
        cluster.make_whole()
    elif fault == "scheduler":
        cluster.scheduler.kill()
        cluster.scheduler.wait()
        reported = run.known()
        assert stored(store) >= reported
        for worker in cluster.workers:
            worker.wait(60)  # without their scheduler they end by themselves
        cluster.make_whole()
    elif fault == "client":
        reported = run.known()
        run.process.kill()
        run.process.wait()
        before = stored(store)
        assert before >= reported
        run = SweepRun(file, on, folder / "out", store, enter=cluster.enter)
    elif fault == "stopped":
        cluster.workers[0].send_signal(signal.SIGSTOP)
        time.sleep(away_s)
        cluster.workers[0].send_signal(signal.SIGCONT)
    elif fault == "network" and isinstance(cluster, CutCluster):
        while not stored(folder / "far"):  # it takes part
            time.sleep(0.01)
        cluster.cable.cut()
        alone = -stored(folder / "far")
        time.sleep(away_s)
        alone += stored(folder / "far")
        cluster.cable.mend()
    exit_code = run.finish()
    seconds, words = time.monotonic() - began, run.log.read_text()
    if exit_code != 0:
        return Figures(seconds, 0, 0, False, exit_code, words, alone)
    account = run.account()
    ran, again = int(str(account["ran"])), int(str(account["given_to_another_worker"]))
    identical = (run.out / "results.csv").read_bytes() == local and stored(store) == TRIALS
    if isinstance(cluster, FullCluster):
        identical = identical and is_refused_as_full(run, cluster)
    return Figures(seconds, again, max(0, ran + before - TRIALS), identical, exit_code, words, alone)


def is_refused_as_full(run: SweepRun, cluster: FullCluster) -> bool:
    """By name; and what is on its disk is whole."""
    [why] = run.account()["refused_workers"].values()  # type: ignore[attr-defined]
    there = Store(cluster.small_disk)
    files = [file for file in there.folder.rglob("*") if file.is_file()]
    whole = [file for file in files if file.suffix == ".json" and there.find(file.parent.name + file.stem) is not None]
    return f"process {cluster.full_worker.pid}" in why and "the disk is full" in why and files == whole != []


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=20)
    parser.add_argument("--away", type=float, default=30.0, metavar="S", help="so long a worker is cut off")
    parser.add_argument("faults", nargs="*", metavar="FAULT", default=FAULTS, help=f"of {', '.join(FAULTS)} (default: all)")
    options = parser.parse_args()
    if {"network", "disk"} & set(options.faults) and (why := namespaces.missing()):
        parser.error(why)
    bad = 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        local = local_results(folder)
        for fault in options.faults:
            rounds: list[Figures] = []
            with cluster_for(fault, folder / f"cluster_{fault}") as cluster:
                for number in range(options.rounds):
                    rounds.append(one_round(fault, cluster, folder / f"{fault}{number}", local, options.away))
                    print(f"{fault} {number + 1}: {'identical' if rounds[-1].identical else 'NOT identical'}", file=sys.stderr, flush=True)
            failed = [one for one in rounds if not one.identical or one.rerun]
            bad += len(failed)
            again = [one.again for one in rounds]
            alone = f", {statistics.fmean(one.alone for one in rounds):.1f} ran while nobody heard of it" if fault == "network" else ""
            print(
                f"{fault}: {len(rounds) - len(failed)} of {len(rounds)} identical with local, {statistics.fmean(again):.1f} trials "
                f"given to another worker ({max(again)} at most), {sum(one.rerun for one in rounds)} of the stored ones ran again"
                f"{alone}, {statistics.median(one.seconds for one in rounds):.1f} s a round", flush=True,
            )
            for one in failed:
                print(one, flush=True)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
