"""What a gait is judged by, and how two gaits compare on the same robots."""

from __future__ import annotations

import math
import statistics
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

Results = Sequence[Mapping[str, Any]]  # of the same trials, in the same order
WORSE_WEIGHT = 5.0  # of what is lost against what is won elsewhere
MOST_WON = 0.5  # by one measure: nothing is bought with the others
SURE = 2.0  # standard errors


@dataclass(frozen=True)
class Measure:
    """Less is better. `of` a trial's result; `least`: the smallest figure by which a difference is divided."""

    name: str
    least: float
    column: str
    wanted: str = ""  # the trial's own column that it should be equal to

    def of(self, result: Mapping[str, Any]) -> float:
        if "error" in result:
            return math.inf
        if self.column == "survived":
            return 0.0 if result["survived"] else 1.0
        wanted = float(result[self.wanted]) if self.wanted else 0.0
        done = result[self.column]
        return abs((0.0 if done is None else float(done)) - wanted)  # a speed that never was: it fell before


MEASURES = (
    Measure("falls", 0.05, "survived"),
    Measure("speed error, m/s", 0.005, "mean_speed_m_s", "told_m_s"),
    Measure("side speed error, m/s", 0.005, "mean_side_speed_m_s", "told_side_m_s"),
    Measure("heading drift, rad", 0.01, "heading_drift_rad"),
    Measure("tilt, rad RMS", 0.005, "tilt_rms_rad"),
)


@dataclass(frozen=True)
class Comparison:
    """Means over the trials; `difference` is tuned less usual, with its standard error, trial by trial."""

    measure: str
    usual: float
    tuned: float
    difference: float
    standard_error: float

    @property
    def verdict(self) -> str:
        if self.difference < -SURE * self.standard_error:
            return "better"
        return "worse" if self.difference > SURE * self.standard_error else "no difference shown"


def compare(usual: Results, tuned: Results) -> list[Comparison]:
    """Trials of which one could not run count as worse without end."""
    comparisons = []
    for measure in MEASURES:
        before, after = [measure.of(one) for one in usual], [measure.of(one) for one in tuned]
        both = [b - a for a, b in zip(before, after, strict=True)]
        error = statistics.stdev(both) / math.sqrt(len(both)) if len(both) > 1 and all(map(math.isfinite, both)) else 0.0
        comparisons.append(
            Comparison(measure.name, statistics.fmean(before), statistics.fmean(after), statistics.fmean(both), error)
        )
    return comparisons


def cost(usual: Results, tuned: Results) -> float:
    """0 for the default gait; below it is better. A candidate that cannot run costs most."""
    whole = 0.0
    for measure in MEASURES:
        before = statistics.fmean(measure.of(one) for one in usual)
        after = statistics.fmean(measure.of(one) for one in tuned)
        change = (after - before) / max(before, measure.least)
        if not math.isfinite(change):
            return 1e3
        whole += WORSE_WEIGHT * change if change > 0 else max(change, -MOST_WON)
    return whole
