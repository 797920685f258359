"""--on: where trials run."""

from __future__ import annotations

import os
import re

from .complaint import InputError
from .dask_pool import DaskPool
from .local_pool import LocalPool
from .pool import Pool

HELP = "where trials run: local (a process a core), local:N, or dask://HOST:PORT, a Dask scheduler's address"

MOST_LOCAL = 1024  # processes


def pool_at(place: str) -> Pool:
    """InputError for what is no place."""
    kind, separator, rest = place.partition(":")
    if kind == "local" and not separator:
        return LocalPool(os.cpu_count() or 1)
    if kind == "local" and re.fullmatch("[0-9]{1,4}", rest) and 1 <= int(rest) <= MOST_LOCAL:
        return LocalPool(int(rest))
    if place.startswith("dask://") and len(place) > len("dask://"):
        return DaskPool(place.removeprefix("dask://"))
    raise InputError(f"--on {place}: is no place for trials. There are: local, local:N (1 to {MOST_LOCAL}), dask://HOST:PORT")
