"""Workers of a Dask cluster: which are refused, by name, and what they keep where no folder is shared."""

from __future__ import annotations

import pathlib
from collections.abc import Iterator

import pytest

from loopback_cluster import Cluster, SweepRun, stored

SWEEP = "trial: rehearsal\nseeds: 1..60\nparameters: {sleep_s: [0.02]}\n"


@pytest.fixture
def cluster(tmp_path: pathlib.Path) -> Iterator[Cluster]:
    with Cluster(tmp_path / "cluster") as one:
        yield one


@pytest.fixture
def file(tmp_path: pathlib.Path) -> pathlib.Path:
    place = tmp_path / "sweep.yaml"
    place.write_text(SWEEP)
    return place


def package_with(folder: pathlib.Path, old: str, new: str) -> str:
    """A copy of the package whose rehearsals compute otherwise, for one worker's PYTHONPATH."""
    import shutil

    import gaitway.sweep

    shutil.copytree(pathlib.Path(gaitway.sweep.__file__).parents[1], folder / "gaitway", symlinks=False)
    place = folder / "gaitway/sweep/rehearsal.py"
    text = place.read_text()
    assert old in text
    place.write_text(text.replace(old, new))
    return str(folder)


def test_a_worker_of_other_code_is_refused_and_the_others_do_its_work(cluster: Cluster, file: pathlib.Path, tmp_path: pathlib.Path) -> None:
    cluster.start_worker()
    cluster.start_worker(PYTHONPATH=package_with(tmp_path / "other", "hashlib.sha256(digest)", "hashlib.sha256(digest + b'!')"))
    cluster.wait_for_workers(2)
    run = SweepRun(file, f"dask://{cluster.address}", tmp_path / "out", tmp_path / "store")
    assert run.finish() == 0, run.log.read_text()
    account = run.account()
    [refusal] = account["refused_workers"].values()  # type: ignore[attr-defined]
    assert f"process {cluster.workers[1].pid}: code digest is" in refusal
    assert len(account["by_worker"]) == 1  # type: ignore[arg-type]


def test_each_worker_keeps_its_own_results_and_the_client_all(cluster: Cluster, file: pathlib.Path, tmp_path: pathlib.Path) -> None:
    for name in ("a", "b"):
        cluster.start_worker(GAITWAY_SWEEP_STORE=str(tmp_path / name))
    run = SweepRun(file, f"dask://{cluster.address}", tmp_path / "out", tmp_path / "store")
    assert run.finish() == 0, run.log.read_text()
    assert stored(tmp_path / "store") == 60
    assert stored(tmp_path / "a") + stored(tmp_path / "b") == 60


def test_a_worker_that_cannot_store_is_refused_by_name(cluster: Cluster, file: pathlib.Path, tmp_path: pathlib.Path) -> None:
    cluster.start_worker(GAITWAY_SWEEP_STORE="/dev/full/store")
    run = SweepRun(file, f"dask://{cluster.address}", tmp_path / "out", tmp_path / "store", "--patience", "3")
    assert run.finish() == 3
    words = run.log.read_text()
    assert f"process {cluster.workers[0].pid}: cannot store results in /dev/full/store" in words
    assert "GAITWAY_SWEEP_STORE" in words
