"""What a sweep would take: counted where that is quick, estimated from some of its trials where there are many."""

from __future__ import annotations

import json

from .progress import clock
from .store import Store
from .sweep_file import Sweep, length
from .trial import kind_of

MOST_LOOKED_AT = 5000  # trials; of more, so many that lie evenly among all


def plan(sweep: Sweep, store: Store, on: str) -> str:
    """In words. Nothing is run."""
    kind = kind_of(sweep.kind)
    looked_at = min(sweep.count, MOST_LOOKED_AT)
    known, expected_s = 0, 0.0
    for number in range(looked_at):
        trial = sweep.trial(number * sweep.count // looked_at)
        if store.has(trial.key):
            known += 1
        else:
            expected_s += kind.expected_s(trial.description)
    share = sweep.count / looked_at
    about = "about " if looked_at < sweep.count else ""
    what = ", ".join(f"{length(values)} {name}" for name, values in sweep.axes.items())
    return "\n".join([
        f"{sweep.count} trials: {what}, {sweep.design.count} points of {len(sweep.design.parameters)} parameters",
        f"{about}{round(known * share)} of them are known; the others take about {clock(expected_s * share)} on one core like this computer's",
        f"the first: {json.dumps(sweep.trial(0).row)}",
        f"would run on {on}; nothing was run",
    ])
