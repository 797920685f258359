"""The search: CMA-ES that can be ended at any time and goes on to the bit from its file.

The file holds the costs of each generation. The candidates follow from them and the seed, so it is played again up to where it was.
"""

from __future__ import annotations

import json
import math
import os
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from gaitway.sweep.canonical import Json
from gaitway.sweep.complaint import InputError, ResultsError

Candidate = list[float]
Evaluate = Callable[[int, list[Candidate]], list[float]]  # generation, candidates -> costs


@dataclass(frozen=True)
class Found:
    """The candidate of the least cost so far, and the centre of the search."""

    best: Candidate
    best_cost: float
    centre: Candidate


def search(dimensions: int, generations: int, population: int, seed: int, about: Json, file: Path, evaluate: Evaluate) -> Found:
    """`about`: what the costs depend on; a file that is about something else is refused. InputError, ResultsError."""
    costs = _known(file, {**about, "population": population, "seed": seed})
    strategy = _strategy(dimensions, population, seed)
    best, best_cost = [0.0] * dimensions, 0.0  # the default gait, which costs nothing
    for generation in range(generations):
        candidates = [[float(value) for value in one] for one in strategy.ask()]
        if generation == len(costs):
            costs.append(evaluate(generation, candidates))
            _write(file, {**about, "population": population, "seed": seed}, costs)
        strategy.tell(candidates, costs[generation])
        for candidate, cost in zip(candidates, costs[generation], strict=True):
            if cost < best_cost:
                best, best_cost = candidate, cost
    return Found(best, best_cost, [float(value) for value in strategy.result.xfavorite])


def _strategy(dimensions: int, population: int, seed: int) -> Any:
    try:
        import cma
        import numpy
    except ImportError as error:
        raise InputError(f"gaitway tune needs the package '{error.name}'. pip install 'gaitway[tune]'") from error
    draw = numpy.random.RandomState(seed).randn  # its own, so that nobody else's draws change it
    options = {"popsize": population, "seed": numpy.nan, "randn": draw, "verbose": -9, "tolfun": 0, "tolx": 0}
    return cma.CMAEvolutionStrategy([0.0] * dimensions, 1.0, options)


def _known(file: Path, about: Json) -> list[list[float]]:
    try:
        state = json.loads(file.read_text())
        before = dict(state["about"])
        if different := [name for name in about if before.get(name) != about[name]]:
            raise InputError(
                f"{file}: is of another search: '{different[0]}' was {before.get(different[0])} and is "
                f"{about[different[0]]}. Remove it to begin anew, or choose another --out"
            )
        return [_costs(one, about["population"]) for one in state["costs"]]
    except FileNotFoundError:
        return []
    except InputError:
        raise
    except (OSError, ValueError, TypeError, KeyError, RecursionError) as error:
        raise InputError(f"{file}: cannot be read: {type(error).__name__}: {error}. Remove it to begin anew") from error


def _costs(generation: Any, population: int) -> list[float]:
    """ValueError, TypeError where it has not a finite cost for each candidate."""
    costs = [float(one) for one in generation]
    if len(costs) != population or not all(map(math.isfinite, costs)):
        raise ValueError(f"{population} finite costs are a generation, not {generation}")
    return costs


def _write(file: Path, about: Json, costs: Sequence[Sequence[float]]) -> None:
    beside = file.with_name(f".{file.name}.part")
    try:
        with beside.open("w", encoding="utf-8") as state:
            json.dump({"about": about, "costs": costs}, state, indent=1)
            state.flush()
            os.fsync(state.fileno())
        beside.rename(file)
    except OSError as error:
        raise ResultsError(f"{file}: {error.strerror}. Make room; what has run is stored") from error
