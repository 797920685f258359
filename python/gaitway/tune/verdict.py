"""What a search bought: the tuned gait against the default one on robots that it has never seen, as a report."""

from __future__ import annotations

import difflib
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import yaml

from gaitway.sweep.complaint import InputError

from .measures import SURE, Comparison


@dataclass(frozen=True)
class Verdict:
    """`reached`: better in one measure at least, worse in none."""

    comparisons: Sequence[Comparison]

    @property
    def reached(self) -> bool:
        verdicts = [one.verdict for one in self.comparisons]
        return "better" in verdicts and "worse" not in verdicts

    @property
    def words(self) -> str:
        if self.reached:
            return "better than the default gait in one measure at least, worse in none"
        if any(one.verdict == "worse" for one in self.comparisons):
            return "worse in a measure: keep the default gait"
        return "no measure shows a difference: keep the default gait"


def report(robot: str, verdict: Verdict, begun: dict[str, str], parameters: dict[str, str], how: dict[str, Any]) -> str:
    """Markdown. `begun`: the numbers with which the search began."""
    lines = [
        f"# The gait of {robot}, tuned",
        "",
        f"Verdict: **{verdict.words}**.",
        "",
        f"| measure, mean of {how['verdict trials']} trials | default | tuned | difference ± standard error | |",
        "|---|---|---|---|---|",
    ]
    for one in verdict.comparisons:
        lines.append(
            f"| {one.measure} | {one.usual:.4g} | {one.tuned:.4g} | {one.difference:+.2g} ± {one.standard_error:.2g} | {one.verdict} |"
        )
    lines += [
        "",
        f"Less is better in each. Both gaits had the same trials; better and worse are differences beyond {SURE:g} standard errors.",
        "",
        "| number | where the search began | tuned |",
        "|---|---|---|",
        *(f"| {name} | {begun[name]} | {value} |" for name, value in parameters.items()),
        "",
        *(f"- {name}: {value}" for name, value in how.items()),
    ]
    return "\n".join(lines) + "\n"


def tuned_config(base: str, parameters: dict[str, str], head: str) -> str:
    """The base configuration's text with the numbers in it. InputError where it lacks a plug-in that has one."""
    config = yaml.safe_load(base)
    plugins = {plugin["name"]: plugin for plugin in config["plugins"]}
    for name, value in parameters.items():
        plugin, _, parameter = name.partition(".")
        if plugin not in plugins:
            near = difflib.get_close_matches(plugin, list(plugins), 1)
            raise InputError(f"the configuration has no plug-in '{plugin}'{f', but {near[0]}' if near else ''}: {name} is not its")
        plugins[plugin].setdefault("parameters", {})[parameter] = value
    comment = "".join(f"# {line}\n" for line in head.splitlines())
    return comment + str(yaml.safe_dump(config, sort_keys=False, width=120))
