"""A trial of the simulated robot: what is asked of it and done to it, and the figures of a run's summary that come of it."""

from __future__ import annotations

import difflib
import math
import os
import re
import subprocess
import sys
import time
from collections.abc import Mapping
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .canonical import Json, files_hash
from .complaint import ImpossibleError, InputError, UnfitWorkerError
from .walk_metrics import WalkMetrics

if TYPE_CHECKING:
    from gaitway import Robot

MEASURES = (
    "survived", "fell_at_s", "distance_m", "mean_speed_m_s", "mean_side_speed_m_s", "lateral_drift_m", "heading_drift_rad",
    "commanded_m", "commanded_and_done_m", "tilt_max_rad", "tilt_rms_rad", "handed_over", "late", "refused", "tail_played",
    "faults", "digest",
)
SHIPPED = {"robot": ("urdf", "robot.yaml"), "config": ("config", ".yaml"), "world": ("worlds", ".yaml")}
PARAMETER = re.compile(r"[A-Za-z_]\w*\.[A-Za-z_]\w*")
LIBRARY_PATH = re.compile(r"""\blibrary:\s*["']?([^\s"',}]*/[^\s"',}]+)""")
AFTER_FALL_S = 1.0
SAMPLE_MS = 10
FIRST_SAMPLE_MS = 5  # a millisecond after a tick, as in a run's summary
PROBE_S = 1.2


class RobotTrials:
    """What a worker and the client have in common about the robot's trials."""

    measures = MEASURES

    def __init__(self) -> None:
        """InputError where the simulator is not installed."""
        try:
            import gaitway._native
        except ImportError as error:
            raise InputError(f"trials of the robot need Gaitway's simulator: {error}. Install the wheel") from error
        self._pace = 0.0  # seconds of this computer for one of the robot's

    @lru_cache(maxsize=None)  # noqa: B019: one instance lives as long as the process
    def code(self) -> str:
        return files_hash(_own_files())

    @lru_cache(maxsize=None)  # noqa: B019
    def probe(self) -> str:
        from gaitway import Robot

        began = time.perf_counter()
        with Robot(seed=1) as robot:
            robot.walk(0.15)
            robot.run(PROBE_S)
            self._pace = (time.perf_counter() - began) / PROBE_S
            return robot.digest

    def expected_s(self, description: Json) -> float:
        self.probe()
        return float(description["seconds"]) * self._pace

    def check(self, description: Json) -> None:
        """ValueError where the robot cannot be made so, or does not take an event."""
        with _robot(description) as robot:
            for event in description["events"]:
                try:
                    robot.apply(_action(event))
                except ValueError as error:
                    raise ValueError(f"the event at {event['at_s']:g} s: {error}") from error

    def run(self, description: Json) -> Json:
        with _robot(description) as robot:
            metrics = _let_run(robot, description["events"], float(description["seconds"]))
            return {**metrics.measures(), **_account(robot)}


def describe(
    *,
    robot: str,
    config: str,
    world: str | None,
    world_seed: int | None,
    conditions: Any,
    mismatch: float,
    seed: int,
    seconds: float,
    parameters: Json,
    events: list[Json],
) -> Json:
    """A trial's description. `robot`, `config`, `world`: as found() gives them; their contents are part of it."""
    return {
        "robot": robot,
        "robot_digest": content_of("robot", robot),
        "config": config,
        "config_digest": content_of("config", config),
        "world": world,
        "world_digest": None if world is None else content_of("world", world),
        "world_seed": world_seed,
        "conditions": conditions,
        "mismatch": mismatch,
        "seed": seed,
        "seconds": seconds,
        "parameters": parameters,
        "events": sorted(events, key=lambda event: float(event["at_s"])),
    }


def check_parameter(name: str) -> str:
    """What is wrong with a parameter's name; empty: nothing."""
    return "" if PARAMETER.fullmatch(name) else "must be PLUGIN.PARAMETER, for example trajectory.lift"


def found(what: str, name: str, beside: Path) -> str | None:
    """The name of a shipped one, or the absolute path of one beside the sweep's file; None: there is none."""
    try:
        if "/" not in name and _shipped_place(what, name).exists():
            return name
        path = (beside / name).resolve()
        there = (path / "robot.yaml").is_file() if what == "robot" else path.is_file()
    except (OSError, RuntimeError):  # a name that is too long, a link to itself, a folder that may not be looked into
        return None
    return str(path) if there else None


def nearest(what: str, name: str) -> str:
    """A sentence that names the shipped one that is meant, or all."""
    folder, file = SHIPPED[what]
    shipped = [place.name if what == "robot" else place.stem for place in sorted(_shipped_folder(folder).iterdir())
               if (place / file).exists() or (what != "robot" and place.suffix == file)]
    near = difflib.get_close_matches(name, shipped, 1)
    return f"Did you mean '{near[0]}'?" if near else f"Shipped are: {', '.join(shipped)}"


def content_of(what: str, name: str) -> str:
    """Of a robot's folder, a configuration or a world. UnfitWorkerError where this computer has none."""
    place = place_of(what, name)
    files = sorted(file for file in place.rglob("*") if file.is_file()) if place.is_dir() else [place]
    try:
        if what == "config" and place.is_file():
            files += _plugins_named_in(place)
        stamps = tuple((str(file), file.stat().st_size, file.stat().st_mtime_ns) for file in files)
        return _content(str(place), stamps)
    except OSError as error:
        raise UnfitWorkerError(f"has no {what} {name}: {error.strerror}. Share the folder, or copy it there") from error


def _plugins_named_in(config: Path) -> list[Path]:
    """By their paths. Of a plug-in in Python all Python files of its folder, since it may import them."""
    named = {config.parent / name for name in LIBRARY_PATH.findall(config.read_text(encoding="utf-8", errors="replace"))}
    return sorted({file for library in named for file in (library.parent.glob("*.py") if library.suffix == ".py" else [library])})


def place_of(what: str, name: str) -> Path:
    """A robot's folder, or a file."""
    if "/" in name:
        return Path(name)
    place = _shipped_place(what, name)
    return place.parent if what == "robot" else place


@lru_cache(maxsize=256)
def _content(place: str, stamps: tuple[tuple[str, int, int], ...]) -> str:
    return files_hash({os.path.relpath(file, place): Path(file) for file, _, _ in stamps})


def _shipped_place(what: str, name: str) -> Path:
    folder, file = SHIPPED[what]
    root = _shipped_folder(folder)
    if what == "robot":
        return root / name / file
    return root / (name if name.endswith(file) else name + file)


def _shipped_folder(name: str) -> Path:
    from gaitway import _native

    return Path(_native.installation_root()) / "share" / "gaitway" / name


def _own_files() -> dict[str, Path]:
    """The simulator, its libraries (the C library's mathematics among them), the plug-ins, and what computes the figures."""
    from gaitway import _native

    root, here = Path(_native.installation_root()), Path(__file__)
    files = [here, here.with_name("walk_metrics.py"), *(root / "lib" / "gaitway").rglob("*.so*"), *_libraries()]
    return {file.name: file for file in files if file.is_file()}


def _libraries() -> list[Path]:
    """Those that the simulator loads into a process that has loaded nothing else."""
    words = "import gaitway._native, sys; sys.stdout.write(open('/proc/self/maps').read())"
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(path for path in sys.path if path)}
    maps = subprocess.run([sys.executable, "-c", words], env=environment, capture_output=True, text=True, check=True).stdout
    python = Path(os.__file__).resolve().parent
    mapped = {Path(line.split(maxsplit=5)[5]) for line in maps.splitlines() if " /" in line and ".so" in line}
    return [file for file in mapped if not file.is_relative_to(python) and not file.name.startswith("libpython")]


def _robot(description: Json) -> Robot:
    """ValueError where nobody can make it (ImpossibleError where a plug-in says so), UnfitWorkerError where this computer cannot."""
    from gaitway import PluginError, Robot, _native

    for what in ("robot", "config", "world"):
        name = description[what]
        if name is not None and content_of(what, name) != description[f"{what}_digest"]:
            raise UnfitWorkerError(f"its {what} {name} is another than the client's. Share the folder, or copy it there")
    parameters: dict[str, dict[str, Any]] = {}
    for name, value in description["parameters"].items():
        plugin, _, parameter = name.partition(".")
        parameters.setdefault(plugin, {})[parameter] = value
    try:
        return Robot(
            description["robot"],
            description["config"],
            seed=description["seed"],
            world=description["world"],
            world_seed=description["world_seed"],
            mismatch=description["mismatch"],
            conditions=description["conditions"],
            parameters=parameters,
            navigation=any("walk_to" in event for event in description["events"]),
        )
    except (PluginError, ValueError) as error:  # the same words wherever the package is installed
        words = str(error).replace(f"{_native.installation_root()}/share/gaitway/", "")
        raise (ImpossibleError if isinstance(error, PluginError) else ValueError)(words) from error


def _let_run(robot: Robot, events: list[Json], seconds: float) -> WalkMetrics:
    """To the end, or to a second after a fall."""
    metrics = WalkMetrics()
    waiting = list(events)
    now_ms, end_ms, next_sample_ms = 0, round(seconds * 1e3), FIRST_SAMPLE_MS
    while now_ms < end_ms:
        while waiting and float(waiting[0]["at_s"]) <= now_ms * 1e-3 + 1e-9:
            action = _action(waiting.pop(0))
            robot.apply(action)
            metrics.on_event(action, now_ms)
        until_ms = min(end_ms, next_sample_ms)
        if waiting:
            until_ms = min(until_ms, max(now_ms + 1, math.ceil(float(waiting[0]["at_s"]) * 1e3 - 1e-6)))
        robot.run((until_ms - now_ms) * 1e-3)
        now_ms = until_ms
        if now_ms == next_sample_ms:
            next_sample_ms += SAMPLE_MS
            truth = robot.truth()
            metrics.add(now_ms, truth.base_m, truth.base_rpy_rad[2], truth.tilt_rad, fallen=robot.fallen)
        if metrics.fell_at_s is not None:
            end_ms = min(end_ms, round((metrics.fell_at_s + AFTER_FALL_S) * 1e3))
    return metrics


def _action(event: Json) -> Json:
    return {name: value for name, value in event.items() if name != "at_s"}


def _account(robot: Robot) -> Mapping[str, Any]:
    batches = robot.batches()
    return {
        "handed_over": batches.handed_over,
        "late": batches.late,
        "refused": batches.refused,
        "tail_played": batches.tail_played,
        "faults": sum(plugin.faults for plugin in robot.faults()),
        "digest": robot.digest,
    }
