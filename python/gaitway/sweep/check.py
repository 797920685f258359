"""Before anything runs: each value that a sweep's file names is tried once, and told with its place where nobody can run it."""

from __future__ import annotations

from collections.abc import Iterator

from .canonical import Json
from .complaint import ImpossibleError
from .design import Range
from .source import Source
from .store import Store
from .sweep_file import CONDITIONS, Sweep
from .trial import Trial, kind_of

MOST_OF_A_LIST = 100  # values of one list; the others are found wrong when they run


def check_values(sweep: Sweep, store: Store) -> None:
    """Each in the first trial, in the place of what it has there. A trial that is stored is not tried. InputError."""
    first = sweep.trial(0)
    tried = {first.key}
    if not store.has(first.key) and (why := complaint(sweep.kind, first.description)):
        culprit(sweep, first).refuse(f"cannot run: {why}")
    for source, trial in others(sweep):
        if trial.key in tried or store.has(trial.key):
            continue
        tried.add(trial.key)
        if why := complaint(sweep.kind, trial.description, impossible=False):
            source.refuse(f"cannot run: {why}")


def complaint(kind: str, description: Json, *, impossible: bool = True) -> str:
    """Empty where it can run. `impossible`: also of what is wrong with no value by itself."""
    try:
        kind_of(kind).check(description)
    except ImpossibleError as error:
        return str(error) if impossible else ""
    except ValueError as error:
        return str(error)
    return ""


def others(sweep: Sweep) -> Iterator[tuple[Source, Trial]]:
    """The first trial with another value, and where this stands. Of a range its ends."""
    axes, point = sweep.axes_of_first(), sweep.parameters_of_first()
    for name, places in sweep.places.items():
        if name in axes:
            values = list(zip(places, sweep.axes[name], strict=True))[1:MOST_OF_A_LIST]
            yield from ((source, sweep.trial_of(0, {**axes, name: value}, point)) for source, value in values)
        elif name in sweep.design.parameters:
            taken = sweep.design.parameters[name]
            ends = [taken.at(0.0), taken.at(1.0)] if isinstance(taken, Range) else list(taken.values[:MOST_OF_A_LIST])
            yield from ((source, sweep.trial_of(0, axes, {**point, name: value})) for source, value in zip(places, ends, strict=False))


def culprit(sweep: Sweep, first: Trial) -> Source:
    """What the first trial can run without; the whole file, where there is no such thing."""
    axes, point = sweep.axes_of_first(), sweep.parameters_of_first()
    for name in point:
        rest = {other: value for other, value in point.items() if other != name}
        if sweep.is_optional(name) and not complaint(sweep.kind, sweep.trial_of(0, axes, rest).description):
            return sweep.places[name][0]
    if CONDITIONS in sweep.places and not complaint(sweep.kind, {**first.description, "conditions": None}):
        return sweep.places[CONDITIONS][0]
    without_events = {**first.description, "events": []}
    if "scenario" in sweep.places and not complaint(sweep.kind, without_events):
        return sweep.places["scenario"][0]
    return sweep.root
