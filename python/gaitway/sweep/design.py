"""Which values the parameters of a sweep take: all combinations, or points drawn at random with a seed."""

from __future__ import annotations

import itertools
import math
import random
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, Literal

Point = tuple[Any, ...]  # a value for each parameter, in their order


@dataclass(frozen=True)
class Values:
    """Some values, one after the other."""

    values: tuple[Any, ...]

    def at(self, share: float) -> Any:
        """`share` in [0, 1)."""
        return self.values[int(share * len(self.values))]


@dataclass(frozen=True)
class Range:
    """`steps` of them in a grid, both ends included; anything in it where points are drawn. `unit` may be empty."""

    lowest: float
    highest: float
    steps: int | None
    logarithmic: bool
    unit: str

    def at(self, share: float) -> Any:
        """`share` in [0, 1]."""
        if self.logarithmic:
            low, high = math.log(self.lowest), math.log(self.highest)
            number = math.exp(low + share * (high - low))
        else:
            number = self.lowest + share * (self.highest - self.lowest)
        number = float(f"{number:.12g}")  # 0.3, not 0.30000000000000004
        return f"{number!r} {self.unit}" if self.unit else number

    def grid(self) -> list[Any]:
        steps = self.steps or 1
        return [self.at(step / (steps - 1) if steps > 1 else 0.0) for step in range(steps)]


@dataclass(frozen=True)
class Design:
    """`ways`: how to come to the points; `count` and `seed` where they are drawn."""

    way: Literal["grid", "random", "latin_hypercube"]
    parameters: dict[str, Values | Range]
    count: int = 0
    seed: int = 0

    def __len__(self) -> int:
        if self.way != "grid":
            return self.count
        return math.prod(len(_grid(one)) for one in self.parameters.values())

    def points(self) -> Iterator[Point]:
        """Always the same ones, in the same order."""
        if self.way == "grid":
            yield from itertools.product(*(_grid(one) for one in self.parameters.values()))
        elif self.way == "random":
            for number in range(self.count):
                draw = random.Random(f"{self.seed} {number}")
                yield tuple(one.at(draw.random()) for one in self.parameters.values())
        else:
            yield from self._latin_hypercube()

    def _latin_hypercube(self) -> Iterator[Point]:
        """Each parameter's range is cut into `count` slices, each of which has one point."""
        slices: list[list[int]] = []
        for name in self.parameters:
            order = list(range(self.count))
            random.Random(f"{self.seed} {name}").shuffle(order)
            slices.append(order)
        for number in range(self.count):
            draw = random.Random(f"{self.seed} {number}")
            yield tuple(
                one.at((order[number] + draw.random()) / self.count)
                for one, order in zip(self.parameters.values(), slices, strict=True)
            )


def _grid(parameter: Values | Range) -> list[Any]:
    return list(parameter.values) if isinstance(parameter, Values) else parameter.grid()
