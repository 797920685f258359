"""The sweep file: which trials a sweep consists of. Read, checked, and turned into trials one after the other.

Robots, configurations, scenarios, worlds, mismatches and seeds are combined with each point of the parameters.
"""

from __future__ import annotations

import itertools
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from .canonical import Json
from .design import Design, Range, Values
from .source import Source
from .trial import Trial, TrialKind, key_of, kind_of

FIELDS = (
    "trial", "robots", "configs", "seeds", "seconds", "mismatch", "worlds", "world_seed", "conditions", "scenario",
    "scenarios", "parameters", "design", "measures",
)
RESERVED = ("trial", "robot", "config", "world", "scenario", "mismatch", "seed", "error")
REHEARSAL_FIELDS = ("trial", "seeds", "parameters", "design", "measures")
FIELDS_OF = {"robot": FIELDS, "rehearsal": REHEARSAL_FIELDS}
MOST_TRIALS = 10_000_000
MOST_SEED = 2**64 - 1
LONGEST_S = 86400.0
VARIABLE = re.compile(r"\$[A-Za-z_]\w*")


@dataclass(frozen=True)
class Sweep:
    """`axes`: what is combined besides the points, by the column's name; one value alone has no column."""

    kind: str
    axes: dict[str, Sequence[Any]]
    design: Design
    constant: Json  # of every trial
    scenarios: dict[str, list[Json]]
    measures: tuple[str, ...]  # empty: all that the trials have

    def __len__(self) -> int:
        count = len(self.design)
        for values in self.axes.values():
            count *= len(values)
        return count

    @property
    def columns(self) -> list[str]:
        """Of the results' table, before the measures."""
        named = [name for name, values in self.axes.items() if len(values) > 1 and name != "seed"]
        return ["trial", *named, *self.design.parameters, "seed"]

    def trials(self) -> Iterator[Trial]:
        """The seeds of a point follow one another."""
        kind = kind_of(self.kind)
        code = kind.code()
        outer = [name for name in self.axes if name != "seed"]
        number = itertools.count()
        for chosen in itertools.product(*(self.axes[name] for name in outer)):
            for point in self.design.points():
                parameters = dict(zip(self.design.parameters, point, strict=True))
                for seed in self.axes["seed"]:
                    axes = {**dict(zip(outer, chosen, strict=True)), "seed": seed}
                    description = self._description(kind, axes, parameters)
                    row = {"trial": next(number), **axes, **parameters}
                    key = key_of(self.kind, code, description)
                    yield Trial(row["trial"], description, {name: row[name] for name in self.columns}, key)

    def _description(self, kind: TrialKind, axes: Json, parameters: Json) -> Json:
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
    measures = tuple(one.text() for one in fields["measures"].items()) if "measures" in fields else ()
    for parameter in design.parameters:
        if parameter in RESERVED:
            fields["parameters"].fields()[parameter].refuse("is the name of a column that each table has", "Choose another name")
    if name == "rehearsal":
        sweep = Sweep(name, {"seed": _seeds(fields["seeds"])}, design, {}, {}, measures)
    else:
        sweep = _robot_sweep(root, fields, design, measures, file.parent)
    if len(sweep) > MOST_TRIALS:
        root.refuse(f"has {len(sweep)} trials, {MOST_TRIALS} at most", "Take fewer steps, or draw points at random")
    return sweep


def _robot_sweep(root: Source, fields: dict[str, Source], design: Design, measures: tuple[str, ...], beside: Path) -> Sweep:
    from .robot_trial import MEASURES, check_parameter, found

    if "seconds" not in fields:
        root.refuse("has no 'seconds'", "Say how long a trial is, for example 'seconds: 20'")
    for measure, source in zip(measures, fields["measures"].items() if measures else [], strict=True):
        if measure not in MEASURES:
            source.refuse("is no measure", f"There are: {', '.join(MEASURES)}")
    for name in design.parameters:
        if "." in name and (why := check_parameter(name)):
            fields["parameters"].fields()[name].refuse(why)
    axes: dict[str, Sequence[Any]] = {
        "robot": _names(fields.get("robots"), "robot", "humanoid22", beside, found),
        "config": _names(fields.get("configs"), "config", "walk", beside, found),
        "world": _names(fields.get("worlds"), "world", None, beside, found),
        "mismatch": tuple(one.number(0, 10) for one in fields["mismatch"].items()) if "mismatch" in fields else (1.0,),
        "seed": _seeds(fields["seeds"]),
    }
    scenarios = _scenarios(fields)
    axes["scenario"] = tuple(scenarios)
    _check_variables(fields, scenarios, design)
    constant: Json = {"seconds": fields["seconds"].number(0.08, LONGEST_S)}
    constant["world_seed"] = fields["world_seed"].whole(0, MOST_SEED) if "world_seed" in fields else None
    constant["conditions"] = fields["conditions"].plain() if "conditions" in fields else None
    return Sweep("robot", axes, design, constant, scenarios, measures)


def _names(source: Source | None, what: str, usual: str | None, beside: Path, found: Any) -> tuple[str | None, ...]:
    """Names of shipped ones, or paths as seen from the sweep's file."""
    if source is None:
        return (usual,)
    names: list[str | None] = []
    for one in source.items():
        if what == "world" and one.text() in ("", "null", "none", "~"):
            names.append(None)
            continue
        path = found(what, one.text(), beside)
        if path is None:
            one.refuse(f"is no {what}: neither a shipped one nor a path from here")
        names.append(path)
    return tuple(names)


def _seeds(source: Source) -> tuple[int, ...] | range:
    """1..20, or a list."""
    if not source.is_list and ".." in source.text():
        ends = source.text().split("..")
        if len(ends) != 2 or not all(end.strip().isdigit() for end in ends) or int(ends[0]) > int(ends[1]):
            source.refuse("must be FIRST..LAST", "For example 1..20")
        if int(ends[1]) > MOST_SEED:
            source.refuse(f"must be at most {MOST_SEED}")
        return range(int(ends[0]), int(ends[1]) + 1)
    seeds = tuple(one.whole(0, MOST_SEED) for one in source.items())
    if len(set(seeds)) < len(seeds):
        source.refuse("has a seed twice", "The second would be the same robot once more; leave it out")
    return seeds


def _scenarios(fields: dict[str, Source]) -> dict[str, list[Json]]:
    if "scenario" in fields and "scenarios" in fields:
        fields["scenario"].refuse("stands beside 'scenarios'", "Move it into 'scenarios', under a name")
    if "scenarios" in fields:
        return {name: _events(one) for name, one in fields["scenarios"].fields().items()}
    return {"": _events(fields["scenario"])} if "scenario" in fields else {"": [{"at_s": 1.0, "walk": [0.15, 0.0, 0.0]}]}


def _events(source: Source) -> list[Json]:
    if not source.is_list:
        source.refuse("must be a list of events", "For example [{at_s: 1, walk: [0.2, 0, 0]}]")
    events: list[Json] = []
    for one in source.items():
        parts = one.fields()
        if "at_s" not in parts or len(parts) != 2:
            one.refuse("must have 'at_s' and one action", "For example {at_s: 1, walk: [0.2, 0, 0]}")
        if not parts["at_s"].text().startswith("$"):
            parts["at_s"].number(0, LONGEST_S)
        events.append(one.plain())
    return events


def _check_variables(fields: dict[str, Source], scenarios: dict[str, list[Json]], design: Design) -> None:
    """A variable of a scenario is a parameter without a dot; the other way round, too."""
    used = set(VARIABLE.findall(repr(scenarios)))
    given = {"$" + name for name in design.parameters if "." not in name}
    where = fields.get("scenario") or fields.get("scenarios") or fields.get("parameters")
    for name in sorted(used - given):
        if where:
            where.refuse(f"uses {name}, which 'parameters' has not", f"Add {name[1:]} there")
    for name in sorted(given - used):
        fields["parameters"].fields()[name[1:]].refuse(
            "is neither PLUGIN.PARAMETER nor used in a scenario", f"Write ${name[1:]} where its value belongs"
        )


def _filled_in(value: Any, variables: Json) -> Any:
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
    if "parameters" not in fields:
        return {}
    return {name: _values(one, drawn=drawn) for name, one in fields["parameters"].fields().items()}


def _values(source: Source, *, drawn: bool) -> Values | Range:
    if not source.is_map:
        return Values(tuple(one.plain() for one in source.items()))
    parts = source.fields(("from", "to", "steps", "scale", "unit"))
    if "from" not in parts or "to" not in parts:
        source.refuse("must have 'from' and 'to'", "For example {from: 0.02, to: 0.04, steps: 5}, or a list of values")
    logarithmic = "scale" in parts and parts["scale"].text() != "linear"
    if logarithmic and parts["scale"].text() != "logarithmic":
        parts["scale"].refuse("must be linear or logarithmic")
    lowest = parts["from"].number(1e-300 if logarithmic else -1e300)
    highest = parts["to"].number()
    if highest <= lowest:
        parts["to"].refuse(f"must be above 'from', which is {lowest:g}")
    if drawn and "steps" in parts:
        parts["steps"].refuse("means nothing where points are drawn", "Leave it out, or take the design grid")
    if not drawn and "steps" not in parts:
        source.refuse("has no 'steps'", "Say how many values a grid shall take, for example steps: 5")
    steps = parts["steps"].whole(2, MOST_TRIALS) if "steps" in parts else None
    return Range(lowest, highest, steps, logarithmic, parts["unit"].text() if "unit" in parts else "")
