"""The machine that was measured on, in the words that stand above the table."""

from __future__ import annotations

import datetime
import os
import pathlib
import platform
from typing import Any


def processor() -> str:
    for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
        name, _, value = line.partition(":")
        if name.strip() == "model name":
            return value.strip()
    return platform.processor() or platform.machine()


def described() -> dict[str, Any]:
    return {
        "processor": processor(),
        "cores": len(os.sched_getaffinity(0)),
        "kernel": platform.release().partition("-")[0],  # without what a distribution or a cloud adds
        "date": datetime.datetime.now(datetime.timezone.utc).strftime("%Y-%m-%d %H:%M UTC"),
        "niceness": os.nice(0),
        "load_before": load(),
    }


def load() -> float:
    """Of the last minute."""
    return round(os.getloadavg()[0], 2)


def in_words(machine: dict[str, Any], rounds: int) -> str:
    return (f"{machine['processor']}, {machine['cores']} cores, Linux {machine['kernel']}, {machine['date']}; {rounds} rounds, niceness "
            f"{machine['niceness']}, load average {machine['load_before']} before and {machine['load_after']} at the end.")
