"""Which values the parameters of a sweep take: all combinations, or points drawn at random with a seed."""

from __future__ import annotations

import math
import random
import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Literal

Point = tuple[Any, ...]  # a value for each parameter, in their order
# 0.03 s, 1e-3 rad/s, 5deg, 0.2 1 / s
WITH_UNIT = re.compile(r"\s*([-+]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][-+]?[0-9]+)?)(?:\s+|(?![0-9.eE]))(?=.*[A-Za-zµ°%])(\S(?:.*\S)?)\s*")


@dataclass(frozen=True)
class Values:
    """Some values, one after the other."""

    values: tuple[Any, ...]

    @cached_property
    def unit(self) -> str:
        """The one of all of them; empty: they have none, or several."""
        read = [WITH_UNIT.fullmatch(value) if isinstance(value, str) else None for value in self.values]
        units = {one[2] if one else "" for one in read}
        numbers = {float(one[1]) for one in read if one}
        return units.pop() if len(units) == 1 and len(numbers) == len(self.values) and all(map(math.isfinite, numbers)) else ""

    @property
    def count(self) -> int:
        return len(self.values)

    def at(self, share: float) -> Any:
        """`share` in [0, 1)."""
        return self.values[int(share * len(self.values))]

    def nth(self, number: int) -> Any:
        """Of the grid."""
        return self.values[number]


@dataclass(frozen=True)
class Range:
    """`steps` of them in a grid, both ends included; anything in it where points are drawn. `unit` may be empty."""

    lowest: float
    highest: float
    steps: int | None
    logarithmic: bool
    unit: str

    @property
    def count(self) -> int:
        return self.steps or 1

    def at(self, share: float) -> Any:
        """`share` in [0, 1]."""
        if self.logarithmic:
            low, high = math.log(self.lowest), math.log(self.highest)
            number = math.exp(low + share * (high - low))
        else:
            number = self.lowest + share * (self.highest - self.lowest)
        number = float(f"{number:.12g}")  # 0.3, not 0.30000000000000004
        return f"{number!r} {self.unit}" if self.unit else number

    def nth(self, number: int) -> Any:
        """Of the grid."""
        return self.at(number / (self.count - 1) if self.count > 1 else 0.0)


@dataclass(frozen=True)
class Design:
    """`ways`: how to come to the points; `drawn` and `seed` where they are drawn."""

    way: Literal["grid", "random", "latin_hypercube"]
    parameters: dict[str, Values | Range]
    drawn: int = 0
    seed: int = 0

    @property
    def count(self) -> int:
        """Of points; nothing is made for it."""
        return self.drawn if self.way != "grid" else math.prod(one.count for one in self.parameters.values())

    def point(self, number: int) -> Point:
        """Always the same one. In a grid the last parameter changes first."""
        if self.way == "grid":
            values = []
            for one in reversed(self.parameters.values()):
                number, place = divmod(number, one.count)
                values.append(one.nth(place))
            return tuple(reversed(values))
        draw = random.Random(f"{self.seed} {number}")
        if self.way == "random":
            return tuple(one.at(draw.random()) for one in self.parameters.values())
        return tuple(
            one.at((order[number] + draw.random()) / self.drawn)
            for one, order in zip(self.parameters.values(), self._slices, strict=True)
        )

    def heading(self, parameter: str) -> str:
        """Of its column: with the unit that all its values have."""
        return self._headings[parameter]

    def number(self, parameter: str, value: Any) -> Any:
        """What stands below that heading."""
        read = WITH_UNIT.fullmatch(value) if self.parameters[parameter].unit else None
        return float(read[1]) if read else value

    def points(self) -> Iterator[Point]:
        return map(self.point, range(self.count))

    @cached_property
    def _headings(self) -> dict[str, str]:
        return {name: f"{name} [{one.unit}]" if one.unit else name for name, one in self.parameters.items()}

    @cached_property
    def _slices(self) -> list[list[int]]:
        """Of a Latin hypercube: each parameter's range is cut into slices, each of which has one point."""
        slices: list[list[int]] = []
        for name in self.parameters:
            order = list(range(self.drawn))
            random.Random(f"{self.seed} {name}").shuffle(order)
            slices.append(order)
        return slices
