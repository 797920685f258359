"""--on: where trials run."""

from __future__ import annotations

import os

from .complaint import InputError
from .dask_pool import DaskPool
from .local_pool import LocalPool
from .pool import Pool

HELP = "where trials run: local (a process a core), local:N, or dask://HOST:PORT, a Dask scheduler's address"


def pool_at(place: str) -> Pool:
    """InputError for what is no place."""
    kind, separator, rest = place.partition(":")
    if kind == "local" and not separator:
        return LocalPool(os.cpu_count() or 1)
    if kind == "local" and rest.isdigit() and 1 <= int(rest) <= 1024:
        return LocalPool(int(rest))
    if place.startswith("dask://") and len(place) > len("dask://"):
        return DaskPool(place.removeprefix("dask://"))
    raise InputError(f"--on {place}: is no place for trials. There are: local, local:N (1 to 1024), dask://HOST:PORT")
