"""Whatever dies, the sweep's results are those of a run without trouble, to the byte, and what is stored is not run again."""

import pathlib
from collections.abc import Iterator

import pytest

import faults
import namespaces
from loopback_cluster import Cluster

MOST_GIVEN_AGAIN = 2 * 2 * 7  # two requests of a quarter of a second at each of two workers


@pytest.fixture(scope="module")
def local(tmp_path_factory: pytest.TempPathFactory) -> bytes:
    return faults.local_results(tmp_path_factory.mktemp("local"))


@pytest.fixture(scope="module")
def cluster(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Cluster]:
    with Cluster(tmp_path_factory.mktemp("cluster")) as one:
        yield one


@pytest.mark.parametrize("fault", ["worker", "stopped", "client", "scheduler"])
def test_only_what_runs_is_lost(fault: str, cluster: Cluster, local: bytes, tmp_path: pathlib.Path) -> None:
    figures = faults.one_round(fault, cluster, tmp_path / fault, local, away_s=3.0)
    assert figures.exit_code == 0, figures.words
    assert figures.identical, figures.words
    assert figures.rerun == 0
    assert figures.again <= MOST_GIVEN_AGAIN


@pytest.mark.parametrize("fault", ["network", "disk"])
def test_a_worker_that_is_cut_off_and_one_without_room(fault: str, local: bytes, tmp_path: pathlib.Path) -> None:
    if why := namespaces.missing():
        pytest.skip(why)
    alone = 0  # where the cut finds a worker between two requests, it has nothing to go on with: once more then
    with faults.cluster_for(fault, tmp_path / "cluster") as cluster:
        for number in range(1 if fault == "disk" else 4):
            figures = faults.one_round(fault, cluster, tmp_path / f"{fault}{number}", local, away_s=3.0)
            assert figures.exit_code == 0, figures.words
            assert figures.identical, figures.words
            assert figures.rerun == 0
            alone += figures.alone
            if alone:
                break
    assert alone or fault == "disk"
