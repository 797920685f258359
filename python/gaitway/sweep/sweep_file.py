"""The sweep file: which trials a sweep consists of. Read, checked, and turned into trials one after the other.

Robots, configurations, scenarios, worlds, mismatches and seeds are combined with each point of the parameters.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

from .canonical import Json, canonical
from .design import Design, Range, Values
from .source import Source
from .trial import Trial, key_of, kind_of

FIELDS = (
    "trial", "robots", "configs", "seeds", "seconds", "mismatch", "worlds", "world_seed", "conditions", "scenario",
    "scenarios", "parameters", "design", "measures",
)
CONDITIONS = "$conditions"  # their place; no parameter has such a name
RESERVED = ("trial", "robot", "config", "world", "scenario", "mismatch", "seed", "error")
REHEARSAL_FIELDS = ("trial", "seeds", "parameters", "design", "measures")
FIELDS_OF = {"robot": FIELDS, "rehearsal": REHEARSAL_FIELDS}
MOST_TRIALS = 10_000_000
MOST_SEED = 2**64 - 1
LONGEST_S = 86400.0
VARIABLE = re.compile(r"\$[A-Za-z_]\w*")
SEEDS = re.compile(r"\s*([0-9]{1,20})\s*\.\.\s*([0-9]{1,20})\s*")
Taken = dict[str, Sequence[Any]]


@dataclass(frozen=True)
class Sweep:
    """`axes`: what is combined besides the points, by the column's name; one value alone has no column.

    `places`: where the file names the values of an axis or a parameter, one each; of a range where its ends stand.
    """

    kind: str
    axes: Taken
    design: Design
    constant: Json  # of every trial
    scenarios: dict[str, list[Json]]
    measures: tuple[str, ...]  # empty: all that the trials have
    root: Source
    places: Mapping[str, Sequence[Source]]

    def __len__(self) -> int:
        return self.count

    @property
    def count(self) -> int:
        """Of trials; nothing is made for it."""
        return self.design.count * math.prod(length(values) for values in self.axes.values())

    @cached_property
    def columns(self) -> list[str]:
        """Of the results' table, before the measures."""
        named = [name for name, values in self.axes.items() if len(values) > 1 and name != "seed"]
        return ["trial", *named, *map(self.design.heading, self.design.parameters), "seed"]

    def trials(self) -> Iterator[Trial]:
        """The seeds of a point follow one another."""
        return map(self.trial, range(self.count))

    def trial(self, number: int) -> Trial:
        axes: Json = {}
        left, place = divmod(number, length(self.axes["seed"]))
        axes["seed"] = self.axes["seed"][place]
        left, place = divmod(left, self.design.count)
        parameters = dict(zip(self.design.parameters, self.design.point(place), strict=True))
        for name in [name for name in reversed(self.axes) if name != "seed"]:
            left, place = divmod(left, length(self.axes[name]))
            axes[name] = self.axes[name][place]
        return self.trial_of(number, axes, parameters)

    def trial_of(self, number: int, axes: Json, parameters: Json) -> Trial:
        """Whether or not it is one of the sweep's."""
        kind = kind_of(self.kind)
        description = self._description(axes, parameters)
        told = {self.design.heading(name): self.design.number(name, value) for name, value in parameters.items()}
        row = {"trial": number, **axes, **told}
        return Trial(number, description, {name: row.get(name) for name in self.columns}, key_of(self.kind, kind.code(), description))

    def axes_of_first(self) -> Json:
        return {name: values[0] for name, values in self.axes.items()}

    def parameters_of_first(self) -> Json:
        return dict(zip(self.design.parameters, self.design.point(0), strict=True))

    def is_optional(self, parameter: str) -> bool:
        """Whether a trial can be described without it: it is no variable of the scenario."""
        return self.kind == "rehearsal" or "." in parameter

    def _description(self, axes: Json, parameters: Json) -> Json:
        if self.kind == "rehearsal":
            return {"seed": axes["seed"], **parameters}
        from .robot_trial import describe

        variables = {name: value for name, value in parameters.items() if "." not in name}
        return describe(
            **self.constant,
            robot=axes["robot"],
            config=axes["config"],
            world=axes["world"],
            mismatch=axes["mismatch"],
            seed=axes["seed"],
            parameters={name: value for name, value in parameters.items() if "." in name},
            events=_filled_in(self.scenarios[axes["scenario"]], variables),
        )


def length(values: Sequence[Any]) -> int:
    """Also of a range that len() has no number for."""
    return values.stop - values.start if isinstance(values, range) else len(values)


def read_sweep(file: Path) -> Sweep:
    """InputError with file, line, field, value, rule and remedy."""
    root = Source.read(file)
    kind = root.fields().get("trial")
    name = kind.text() if kind else "robot"
    if kind and name not in FIELDS_OF:
        kind.refuse("is no kind of trial", f"There are: {', '.join(FIELDS_OF)}")
    fields = root.fields(FIELDS_OF[name])
    if "seeds" not in fields:
        root.refuse("has no 'seeds'", "Add for example 'seeds: 1..10'")
    design = _design(fields)
    measures = _measures(fields, name)
    for parameter, source in _parameter_sources(fields).items():
        if parameter in RESERVED:
            source.refuse("is the name of a column that each table has", "Choose another name")
        if parameter in kind_of(name).measures:
            source.refuse("is the name of a measure, which has a column of its own", "Choose another name")
    if name == "rehearsal":
        axes: Taken = {"seed": _seeds(fields["seeds"])}
        sweep = Sweep(name, axes, design, {}, {}, measures, root, _places(fields))
    else:
        sweep = _robot_sweep(root, fields, design, measures, file.parent)
    if sweep.count > MOST_TRIALS:
        root.refuse(f"has {sweep.count} trials, {MOST_TRIALS} at most", "Take fewer steps or seeds, or draw points at random")
    return sweep


def _robot_sweep(root: Source, fields: dict[str, Source], design: Design, measures: tuple[str, ...], beside: Path) -> Sweep:
    from .robot_trial import check_parameter, found, nearest

    if "seconds" not in fields:
        root.refuse("has no 'seconds'", "Say how long a trial is, for example 'seconds: 20'")
    for name, source in _parameter_sources(fields).items():
        if "." in name and (why := check_parameter(name)):
            source.refuse(why)

    def named(field: str, what: str, usual: str | None) -> Sequence[str | None]:
        return _distinct(fields[field], lambda one: _named(one, what, beside, found, nearest)) if field in fields else (usual,)

    axes: Taken = {
        "robot": named("robots", "robot", "humanoid22"),
        "config": named("configs", "config", "walk"),
        "world": named("worlds", "world", None),
        "mismatch": _distinct(fields["mismatch"], lambda one: one.number(0, 10)) if "mismatch" in fields else (1.0,),
        "seed": _seeds(fields["seeds"]),
    }
    seconds = fields["seconds"].number(0.08, LONGEST_S)
    scenarios = _scenarios(fields, seconds)
    axes["scenario"] = tuple(scenarios)
    _check_variables(fields, seconds)
    constant: Json = {"seconds": seconds}
    constant["world_seed"] = fields["world_seed"].whole(0, MOST_SEED) if "world_seed" in fields else None
    constant["conditions"] = fields["conditions"].plain() if "conditions" in fields else None
    return Sweep("robot", axes, design, constant, scenarios, measures, root, _places(fields))


def _places(fields: dict[str, Source]) -> dict[str, Sequence[Source]]:
    """By the column's name."""
    places: dict[str, Sequence[Source]] = {}
    for field, column in (("robots", "robot"), ("configs", "config"), ("worlds", "world"), ("mismatch", "mismatch")):
        if field in fields:
            places[column] = fields[field].items()
    if "scenario" in fields:
        places["scenario"] = [fields["scenario"]]
    if "scenarios" in fields:
        places["scenario"] = list(fields["scenarios"].fields().values())
    if "conditions" in fields:
        places[CONDITIONS] = [fields["conditions"]]
    for name, source in _parameter_sources(fields).items():
        places[name] = [source.fields()[end] for end in ("from", "to")] if source.is_map else source.items()
    return places


def _parameter_sources(fields: dict[str, Source]) -> dict[str, Source]:
    return fields["parameters"].fields() if "parameters" in fields else {}


def _distinct(source: Source, read: Callable[[Source], Any]) -> tuple[Any, ...]:
    """The values of a list, each as `read` takes it; refuses one that stands there twice."""
    values: dict[Any, Any] = {}
    for one in source.items():
        value = read(one)
        is_number = isinstance(value, int | float) and not isinstance(value, bool)
        key = value if is_number else canonical(value)  # 10 and 10.0 are one value
        if key in values:
            one.refuse("stands here twice", "The second would be the same trials once more; leave it out")
        values[key] = value
    return tuple(values.values())


def _measures(fields: dict[str, Source], kind: str) -> tuple[str, ...]:
    known = kind_of(kind).measures

    def read(one: Source) -> str:
        if one.text() not in known:
            one.refuse("is no measure", f"There are: {', '.join(known)}")
        return one.text()

    return _distinct(fields["measures"], read) if "measures" in fields else ()


def _named(source: Source, what: str, beside: Path, found: Callable[[str, str, Path], str | None],
           nearest: Callable[[str, str], str]) -> str | None:
    """The name of a shipped one, or a path as seen from the sweep's file; None: the world without a name."""
    if what == "world" and source.text() in ("", "null", "none", "~"):
        return None
    path = found(what, source.text(), beside)
    if path is None:
        source.refuse(f"is no {what}: neither a shipped one nor a path from here", nearest(what, source.text()))
    return path


def _seeds(source: Source) -> tuple[int, ...] | range:
    """1..20, or a list."""
    if not source.is_list and ".." in source.text():
        ends = SEEDS.fullmatch(source.text())
        first, last = (int(end) for end in ends.groups()) if ends else (1, 0)
        if first > last:
            source.refuse("must be FIRST..LAST, whole numbers", "For example 1..20")
        if last > MOST_SEED:
            source.refuse(f"must be at most {MOST_SEED}")
        return range(first, last + 1)
    return _distinct(source, lambda one: one.whole(0, MOST_SEED))


def _scenarios(fields: dict[str, Source], seconds: float) -> dict[str, list[Json]]:
    if "scenario" in fields and "scenarios" in fields:
        fields["scenario"].refuse("stands beside 'scenarios'", "Move it into 'scenarios', under a name")
    if "scenarios" in fields:
        if not fields["scenarios"].fields():
            fields["scenarios"].refuse("has none", "Give one, or leave it out")
        return {name: _events(one, seconds) for name, one in fields["scenarios"].fields().items()}
    return {"": _events(fields["scenario"], seconds)} if "scenario" in fields else {"": [{"at_s": 1.0, "walk": [0.15, 0.0, 0.0]}]}


def _events(source: Source, seconds: float) -> list[Json]:
    if not source.is_list:
        source.refuse("must be a list of events", "For example [{at_s: 1, walk: [0.2, 0, 0]}]")
    events: list[Json] = []
    for one in source.items():
        parts = one.fields()
        if "at_s" not in parts or len(parts) != 2:
            one.refuse("must have 'at_s' and one action", "For example {at_s: 1, walk: [0.2, 0, 0]}")
        if not parts["at_s"].text().startswith("$"):
            _check_time(parts["at_s"], parts["at_s"].number(0, LONGEST_S), seconds)
        events.append(one.plain())
    return events


def _check_variables(fields: dict[str, Source], seconds: float) -> None:
    """A variable of a scenario is a parameter without a dot; the other way round, too."""
    sources = _parameter_sources(fields)
    written = [fields[name] for name in ("scenario", "scenarios") if name in fields]
    used: set[str] = set()
    for one in [scalar for source in written for scalar in source.scalars() if VARIABLE.search(scalar.text())]:
        name = one.text()[1:]
        if not VARIABLE.fullmatch(one.text()):
            one.refuse("is more than a variable", "A variable stands alone, for example $push")
        if name not in sources:
            one.refuse("is a variable that 'parameters' has not", f"Add {name} there")
        used.add(name)
        if one.field.endswith(".at_s"):
            _check_times(one.field, sources[name], seconds)
    for name, source in sources.items():
        if "." not in name and name not in used:
            source.refuse("is neither PLUGIN.PARAMETER nor used in a scenario", f"Write ${name} where its value belongs")


def _check_times(field: str, source: Source, seconds: float) -> None:
    """Of a variable that says when something happens."""
    parts = source.fields() if source.is_map else {}
    if "unit" in parts:
        parts["unit"].refuse(f"is a unit, and {field} is a number of seconds", "Leave it out")
    for one in [parts["from"], parts["to"]] if parts else source.items():
        value = one.plain()
        if isinstance(value, bool) or not isinstance(value, int | float) or not 0 <= value <= LONGEST_S:
            one.refuse(f"must be a number of seconds, 0 to {LONGEST_S:g}: it is {field}")
        _check_time(one, value, seconds)


def _check_time(source: Source, at_s: float, seconds: float) -> None:
    """As `gaitway run` does."""
    if at_s >= seconds:
        source.refuse(f"must be before the end of the trial at {seconds:g} s, or it never happens")


def _filled_in(value: Any, variables: Json) -> Any:
    """With their values in the place of variables."""
    if isinstance(value, dict):
        return {name: _filled_in(one, variables) for name, one in value.items()}
    if isinstance(value, list):
        return [_filled_in(one, variables) for one in value]
    if isinstance(value, str) and VARIABLE.fullmatch(value):
        return variables[value[1:]]
    return value


def _design(fields: dict[str, Source]) -> Design:
    source = fields.get("design")
    ways = ("grid", "random", "latin_hypercube")
    if source is None or not source.is_map:
        if source is not None and source.text() != "grid":
            source.refuse("must be grid, {random: COUNT, seed: N} or {latin_hypercube: COUNT, seed: N}")
        return Design("grid", _parameters(fields, drawn=False))
    parts = source.fields((*ways[1:], "seed"))
    chosen = [way for way in ways[1:] if way in parts]
    if len(chosen) != 1:
        source.refuse("must have either 'random' or 'latin_hypercube'")
    if "parameters" not in fields:
        source.refuse("needs 'parameters' to draw", "Add some, or leave 'design' out")
    way = chosen[0]
    count = parts[way].whole(1, MOST_TRIALS)
    seed = parts["seed"].whole(0, MOST_SEED) if "seed" in parts else 1
    return Design("random" if way == "random" else "latin_hypercube", _parameters(fields, drawn=True), count, seed)


def _parameters(fields: dict[str, Source], *, drawn: bool) -> dict[str, Values | Range]:
    return {name: _values(one, drawn=drawn) for name, one in _parameter_sources(fields).items()}


def _values(source: Source, *, drawn: bool) -> Values | Range:
    if not source.is_map:
        return Values(_distinct(source, Source.plain))
    parts = source.fields(("from", "to", "steps", "scale", "unit"))
    if "from" not in parts or "to" not in parts:
        source.refuse("must have 'from' and 'to'", "For example {from: 0.02, to: 0.04, steps: 5}, or a list of values")
    logarithmic = "scale" in parts and parts["scale"].text() != "linear"
    if logarithmic and parts["scale"].text() != "logarithmic":
        parts["scale"].refuse("must be linear or logarithmic")
    lowest = parts["from"].number(1e-300 if logarithmic else -1e300, 1e300)
    highest = parts["to"].number(-1e300, 1e300)
    if highest <= lowest:
        parts["to"].refuse(f"must be above 'from', which is {lowest:g}")
    if drawn and "steps" in parts:
        parts["steps"].refuse("means nothing where points are drawn", "Leave it out, or take the design grid")
    if not drawn and "steps" not in parts:
        source.refuse("has no 'steps'", "Say how many values a grid shall take, for example steps: 5")
    steps = parts["steps"].whole(2, MOST_TRIALS) if "steps" in parts else None
    taken = Range(lowest, highest, steps, logarithmic, parts["unit"].text() if "unit" in parts else "")
    if taken.at(0.0) == taken.at(1.0) or (steps and (taken.nth(0) == taken.nth(1) or taken.nth(steps - 2) == taken.nth(steps - 1))):
        source.refuse("has steps of which two are one value", "Take fewer steps, or a wider range")
    return taken
