"""One tuning from the first candidate to the verdict, on any engine and any subject."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Protocol

from gaitway.sweep.canonical import Json
from gaitway.sweep.complaint import InputError
from gaitway.sweep.engine import Engine
from gaitway.sweep.trial import Trial

from .measures import compare, cost
from .numbers import GaitNumber, parameters
from .search import Candidate, search
from .verdict import Verdict


class Tried(Protocol):
    """Who is tuned: trials of given parameters and robots, and what each was told."""

    def trials(self, parameters: Json, seeds: Iterable[int]) -> Iterator[Trial]: ...

    def told(self, trial: Trial) -> Json: ...


@dataclass(frozen=True)
class Plan:
    """`training` and `held_out` are seeds of robots, and have none in common."""

    numbers: tuple[GaitNumber, ...]
    generations: int
    population: int
    seed: int
    training: range
    held_out: range

    def check(self) -> None:
        """InputError."""
        both = set(self.training) & set(self.held_out)
        if both:
            raise InputError(f"seed {min(both)} is both for training and for the verdict: choose others, with none in common")
        if len(self.training) < 1 or len(self.held_out) < 2:
            raise InputError("a search needs one seed at least, and a verdict two")

    def about(self) -> Json:
        """What the costs of a search depend on, besides the trials' own hash."""
        return {
            "numbers": [number.parameter for number in self.numbers],
            "training": [self.training.start, self.training.stop],
        }


@dataclass(frozen=True)
class Tuned:
    parameters: dict[str, str]
    training_cost: float
    verdict: Verdict


def tune(plan: Plan, tried: Tried, engine: Engine, state: Path, tell: Callable[[str], None]) -> Tuned:
    """Goes on from `state`, if it is there. Raises SweepError."""
    plan.check()
    trials = list(tried.trials({}, plan.training))
    usual = _results(engine, tried, [trials])[0]

    def evaluate(generation: int, candidates: list[Candidate]) -> list[float]:
        lists = [list(tried.trials(parameters(plan.numbers, one), plan.training)) for one in candidates]
        costs = [cost(usual, one) for one in _results(engine, tried, lists)]
        tell(f"generation {generation + 1} of {plan.generations}: costs {min(costs):+.3f} to {max(costs):+.3f} (the default gait: 0)")
        return costs

    about = {**plan.about(), "trials": trials[0].key}
    found = search(len(plan.numbers), plan.generations, plan.population, plan.seed, about, state, evaluate)
    centre = list(tried.trials(parameters(plan.numbers, found.centre), plan.training))
    centre_cost = cost(usual, _results(engine, tried, [centre])[0])
    chosen, training_cost = (found.centre, centre_cost) if centre_cost < found.best_cost else (found.best, found.best_cost)
    values = parameters(plan.numbers, chosen) if training_cost < 0 else {}
    both = _results(engine, tried, [list(tried.trials(one, plan.held_out)) for one in ({}, values)])
    return Tuned(values, training_cost, Verdict(compare(both[0], both[1])))


def _results(engine: Engine, tried: Tried, lists: Sequence[list[Trial]]) -> list[list[dict[str, Any]]]:
    """Of all of them at once, so that no worker waits for the end of a list. A trial that is in two lists runs once."""
    texts: dict[str, str] = {}
    engine.run({trial.key: trial for trials in lists for trial in trials}.values(), lambda trial, text: texts.__setitem__(trial.key, text))
    return [[{**json.loads(texts[trial.key]), **tried.told(trial)} for trial in trials] for trials in lists]
