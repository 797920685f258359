"""The gait's numbers that a search may change, in units of the robot's body, so that one list suits bodies of any size."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from gaitway.sweep.complaint import InputError


@dataclass(frozen=True)
class GaitNumber:
    """`usual`: the default, in `unit`s. The search goes by factors: `spread` is one standard deviation of its first steps."""

    parameter: str
    usual: float
    unit: str
    lowest: float
    highest: float
    spread: float = 0.1

    def at(self, x: float) -> float:
        """0 is the default."""
        value = self.usual * math.exp(self.spread * x)
        return float(f"{min(max(value, self.lowest), self.highest):.6g}")

    def text(self, x: float) -> str:
        return f"{self.at(x)!r} {self.unit}" if self.unit != "1" else repr(self.at(x))


NUMBERS = (
    GaitNumber("trajectory.step_time", 1.67, "T", 1.2, 2.5, 0.06),
    GaitNumber("trajectory.double_support_share", 0.10, "1", 0.05, 0.30),
    GaitNumber("trajectory.lift", 0.0833, "h", 0.04, 0.14),
    GaitNumber("trajectory.zmp_inward", 0.0278, "h", 0.005, 0.06),
    GaitNumber("trajectory.absorb", 2.09, "T", 1.2, 3.5),
    GaitNumber("trajectory.response_lag", 0.104, "T", 0.02, 0.25),
    GaitNumber("trajectory.swing_moment", 0.00424, "s^2", 0.002, 0.007),
    GaitNumber("stability.ankle_pitch_rate", 0.157, "T", 0.08, 0.25),
    GaitNumber("stability.ankle_roll_rate", 0.313, "T", 0.1, 0.45),
    GaitNumber("stability.heading_gain", 0.19, "1/T", 0.05, 0.5),
)


def by_names(names: Sequence[str]) -> tuple[GaitNumber, ...]:
    """InputError for one that there is not, or that is named twice."""
    known = {number.parameter: number for number in NUMBERS}
    unknown = [name for name in names if name not in known]
    if unknown:
        raise InputError(f"--numbers '{unknown[0]}': is no number that can be tuned. There are: {', '.join(known)}")
    if twice := [name for place, name in enumerate(names) if name in names[:place]]:
        raise InputError(f"--numbers '{twice[0]}': stands there twice. Leave one out")
    return tuple(known[name] for name in names)


def parameters(numbers: Sequence[GaitNumber], x: Sequence[float]) -> dict[str, str]:
    return {number.parameter: number.text(one) for number, one in zip(numbers, x, strict=True)}
