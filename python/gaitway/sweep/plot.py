"""The picture of a sweep: each measure over the first parameter that changes, in the colours of the second."""

from __future__ import annotations

from collections import defaultdict
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .results import Group

MOST_LINES = 8
COLUMNS = 3


def plot(groups: list[Group], measures: list[str], place: Path) -> None:
    """Without a display. ImportError where matplotlib is not there."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    varied = [name for name in (groups[0].row if groups else {}) if len({str(group.row[name]) for group in groups}) > 1]
    rows = max(1, -(-len(measures) // COLUMNS))
    figure = Figure(figsize=(4.2 * COLUMNS, 3.0 * rows), layout="constrained")
    FigureCanvasAgg(figure)
    for place_in_figure, measure in enumerate(measures, 1):
        axes = figure.add_subplot(rows, COLUMNS, place_in_figure)
        axes.set_title(measure, fontsize=9)
        axes.set_xlabel(varied[0] if varied else "point", fontsize=8)
        for label, line in _lines(groups, measure, varied):
            at, mean, deviation = zip(*line, strict=True)
            axes.errorbar(at, mean, deviation, fmt="o-", markersize=3, linewidth=1, capsize=2, label=label)
        if len(varied) > 1:
            axes.legend(title=varied[1], fontsize=6, title_fontsize=7)
    beside = place.with_name(f".{place.stem}.part.png")
    figure.savefig(beside, dpi=110, metadata={"Software": None})
    beside.rename(place)


def _lines(groups: list[Group], measure: str, varied: list[str]) -> list[tuple[str, list[tuple[Any, float, float]]]]:
    """(label, [(x, mean, deviation)]); points that lie at one x are one above the other."""
    lines: dict[str, list[tuple[Any, float, float]]] = defaultdict(list)
    for number, group in enumerate(groups):
        if measure not in group.figures:
            continue
        label = str(group.row[varied[1]]) if len(varied) > 1 else ""
        if label in lines or len(lines) < MOST_LINES:
            x = group.row[varied[0]] if varied else number
            lines[label].append((x if isinstance(x, int | float) else str(x), *group.figures[measure][:2]))
    return list(lines.items())
