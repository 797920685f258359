"""What goes wrong, by name. Wrong values are ValueError, wrong types TypeError, as everywhere."""

from __future__ import annotations

import difflib
from collections.abc import Iterable

from gaitway._native import BusyError, ClosedError, ForkError, InputError, PluginError, TopicError

__all__ = ["BusyError", "ClosedError", "ForkError", "InputError", "NothingPublished", "PluginError", "TopicError",
           "UnknownTopic", "suggest"]


class UnknownTopic(KeyError):
    """There is no topic, or no field, of that name."""

    def __str__(self) -> str:
        return str(self.args[0])


class NothingPublished(LookupError):
    """Nobody has published anything in this topic yet."""


def suggest(name: str, known: Iterable[str]) -> str:
    """A sentence that names the nearest known name."""
    near = difflib.get_close_matches(name, list(known), n=1, cutoff=0.4)
    return f"Did you mean '{near[0]}'?" if near else f"Known here: {', '.join(sorted(known))}."
