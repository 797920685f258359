"""What the rounds of a comparison come to: of each row the median ratio and its spread, as a table and as JSON."""

from __future__ import annotations

import math
import statistics
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any


@dataclass(frozen=True)
class Pair:
    """One row in one round: what the project took, and what the peer took in the same seconds."""

    ours: float
    peer: float
    remark: str = ""

    def __post_init__(self) -> None:
        if not (0.0 < self.ours < math.inf and 0.0 < self.peer < math.inf):
            raise ValueError(f"{self.ours} beside {self.peer}: both must be above zero and finite")

    @property
    def ratio(self) -> float:
        return self.ours / self.peer


@dataclass
class Row:
    """A comparison with one peer."""

    what: str
    peer: str
    unit: str
    pairs: list[Pair] = field(default_factory=list)
    missing: str = ""  # why it is not available here
    broken: str = ""  # what went wrong, of something that is here

    @property
    def median(self) -> float:
        return statistics.median(pair.ratio for pair in self.pairs)

    @property
    def spread(self) -> tuple[float, float]:
        ratios = [pair.ratio for pair in self.pairs]
        return min(ratios), max(ratios)

    def cells(self) -> list[str]:
        if self.broken or self.missing or not self.pairs:
            why = f"failed: {self.broken}" if self.broken else f"not available here: {self.missing or 'no round was played'}"
            return [self.what, self.peer, "", "", "", "", why.replace("|", "/").replace("\n", " ")]
        ours, peer = (statistics.median(values) for values in zip(*((p.ours, p.peer) for p in self.pairs), strict=True))
        lowest, highest = self.spread
        return [self.what, self.peer, f"{figure(ours)} {self.unit}", f"{figure(peer)} {self.unit}", figure(self.median),
                f"{figure(lowest)} to {figure(highest)}", self.pairs[-1].remark]

    def as_json(self) -> dict[str, Any]:
        measured = bool(self.pairs) and not (self.broken or self.missing)
        return {
            "what": self.what, "peer": self.peer, "unit": self.unit,
            "ratio_median": self.median if measured else None,
            "ratio_spread": list(self.spread) if measured else None,
            "rounds": [{"ours": pair.ours, "peer": pair.peer, "ratio": pair.ratio, "remark": pair.remark} for pair in self.pairs],
            "not_available": self.missing or None, "failed": self.broken or None,
        }


def figure(value: float) -> str:
    """Three significant digits, without an exponent."""
    rounded = float(f"{value:.3g}")
    return f"{rounded:.{max(0, 2 - math.floor(math.log10(rounded)))}f}"


def table(rows: Sequence[Row]) -> str:
    """Markdown. A ratio is ours / peer, of times: below 1 the project is quicker, above 1 the peer."""
    lines = ["| what | peer | ours | the peer's | ours / peer, median | spread | |", "|---|---|---|---|---|---|---|"]
    lines += ["| " + " | ".join(row.cells()) + " |" for row in rows]
    return "\n".join(lines)
