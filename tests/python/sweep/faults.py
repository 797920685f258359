"""One round of each fault: what dies, what is known then, and what becomes of the sweep. Run by faults_test.py, and again and
again by `python tests/python/sweep/faults.py --rounds 20 --away 30`.
"""

from __future__ import annotations

import argparse
import pathlib
import signal
import statistics
import sys
import tempfile
import time
from dataclasses import dataclass

from loopback_cluster import Cluster, SweepRun, stored

TRIALS = 80
SWEEP = f"""
trial: rehearsal
seeds: 1..{TRIALS // 2}
parameters: {{rounds: [20, 40], sleep_s: [0.04]}}
"""


@dataclass(frozen=True)
class Figures:
    """`again`: trials that a worker had and another one got. `rerun`: ran although their results were stored."""

    seconds: float
    again: int
    rerun: int
    identical: bool
    exit_code: int
    words: str


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
    run = SweepRun(file, on, folder / "out", store)
    run.wait_for(10)
    before = 0
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
        run = SweepRun(file, on, folder / "out", store)
    elif fault == "cut_off":
        cluster.workers[0].send_signal(signal.SIGSTOP)
        time.sleep(away_s)
        cluster.workers[0].send_signal(signal.SIGCONT)
    exit_code = run.finish()
    seconds, words = time.monotonic() - began, run.log.read_text()
    if exit_code != 0:
        return Figures(seconds, 0, 0, False, exit_code, words)
    account = run.account()
    ran, again = int(str(account["ran"])), int(str(account["given_to_another_worker"]))
    identical = (run.out / "results.csv").read_bytes() == local and stored(store) == TRIALS
    return Figures(seconds, again, max(0, ran + before - TRIALS), identical, exit_code, words)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=20)
    parser.add_argument("--away", type=float, default=30.0, metavar="S", help="so long a worker is cut off")
    options = parser.parse_args()
    bad = 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        local = local_results(folder)
        for fault in ("worker", "scheduler", "client", "cut_off"):
            with Cluster(folder / f"cluster_{fault}") as cluster:
                rounds = [
                    one_round(fault, cluster, folder / f"{fault}{number}", local, options.away) for number in range(options.rounds)
                ]
            failed = [one for one in rounds if not one.identical or one.rerun]
            bad += len(failed)
            again = [one.again for one in rounds]
            print(
                f"{fault}: {len(rounds) - len(failed)} of {len(rounds)} identical with local, {statistics.fmean(again):.1f} trials "
                f"given to another worker ({max(again)} at most), none of the stored ones ran again, "
                f"{statistics.median(one.seconds for one in rounds):.1f} s a round", flush=True,
            )
            for one in failed:
                print(one, flush=True)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
