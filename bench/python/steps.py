"""What the interpreter costs: Env.step against `gaitway run` in the same minute, two robots on two threads against one, and reads.

    PYTHONPATH=build/release/lib/python python bench/python/steps.py build/release/bin/gaitway [--rounds 5] [--check]

Each ratio comes of interleaved rounds, of which the median counts. What two threads can be worth is what the computer gives two processes
of `gaitway run` that share nothing: that is a row of its own. --check: exit code 1 where a target is missed.
"""

from __future__ import annotations

import argparse
import json
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time
import tracemalloc
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor

import numpy as np

import gaitway

STEPS = 250
COMMAND = np.array([0.15, 0.0, 0.0])


def pace_of_command(command: str) -> float:
    """Steps of 80 ms a second, by the summary's own wall time."""
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([command, "run", "--seconds", str(STEPS * 0.08), "--seed", "1", "--out", folder, "--quiet", "--no-pictures"], check=True)
        summary = json.loads((pathlib.Path(folder) / "summary.json").read_text())
    return float(STEPS / summary["wall_seconds"])


def pace_of_two_commands(command: str) -> float:
    """Of both together: two processes that share nothing but the computer."""
    with ThreadPoolExecutor(2) as threads:
        return sum(threads.map(pace_of_command, [command, command]))


def pace_of_env(env: gaitway.Env) -> float:
    env.reset(seed=1)
    began = time.perf_counter()
    for _ in range(STEPS):
        env.step(COMMAND)
    return STEPS / (time.perf_counter() - began)


def pace_of_robot(robot: gaitway.Robot) -> float:
    """The bare co-simulation, in one call."""
    robot.restart(1)
    robot.run(0.96)
    robot.walk(0.15)
    began = time.perf_counter()
    robot._run.advance(STEPS * 80)
    return STEPS / (time.perf_counter() - began)


def pace_of_vec(vec: gaitway.VecEnv) -> float:
    vec.reset(seed=1)
    actions = np.repeat(COMMAND[None], vec.num_envs, 0)
    began = time.perf_counter()
    for _ in range(STEPS):
        vec.step(actions)
    return STEPS * vec.num_envs / (time.perf_counter() - began)


def interpreter_us(env: gaitway.Env) -> float:
    """CPU time of a step outside of the robot's own, with the caches that its physics leave."""
    env.reset(seed=1)
    spent = []
    for _ in range(STEPS):
        began = time.thread_time_ns()
        env.begin_step(env.checked(COMMAND))
        left = time.thread_time_ns()
        env.robot._run.advance(80)
        back = time.thread_time_ns()
        env.told(env.end_cycle()[0])
        spent.append(time.thread_time_ns() - back + left - began)
    return statistics.median(spent) * 1e-3


def nanoseconds(call, count: int = 20000) -> float:
    best = float("inf")
    for _ in range(5):
        began = time.perf_counter_ns()
        for _ in range(count):
            call()
        best = min(best, (time.perf_counter_ns() - began) / count)
    return best


def allocated(call) -> int:
    """Bytes that a thousand calls leave or need, beyond the measurement's own."""
    call()
    tracemalloc.start()
    before = tracemalloc.get_traced_memory()[0]
    tracemalloc.reset_peak()
    for _ in range(1000):
        call()
    peak = tracemalloc.get_traced_memory()[1] - before
    tracemalloc.stop()
    return peak


def read_arguments() -> argparse.Namespace:
    description = (__doc__ or "").partition("\n")[0]
    parser = argparse.ArgumentParser(description=description, epilog="Example: steps.py build/release/bin/gaitway --rounds 15 --check")
    parser.add_argument("gaitway", type=pathlib.Path, help="the command that is compared with")
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--check", action="store_true", help="exit code 1 where a target is missed")
    arguments = parser.parse_args()
    if not arguments.gaitway.is_file():
        parser.error(f"{arguments.gaitway}: there is no such program")
    if arguments.rounds < 1:
        parser.error(f"--rounds is {arguments.rounds}, and must be 1 or more")
    return arguments


def main() -> int:
    arguments = read_arguments()
    command = str(arguments.gaitway)
    env, robot = gaitway.Env(episode_s=1e6), gaitway.Robot()
    one, two = gaitway.make_vec(1, threads=1, episode_s=1e6), gaitway.make_vec(2, threads=2, episode_s=1e6)
    ways: dict[str, Callable[[], float]] = {
        "gaitway run": lambda: pace_of_command(command),
        "two of them": lambda: pace_of_two_commands(command),
        "Robot.run": lambda: pace_of_robot(robot),
        "Env.step": lambda: pace_of_env(env),
        "make_vec(1)": lambda: pace_of_vec(one),
        "make_vec(2)": lambda: pace_of_vec(two),
    }
    paces: dict[str, list[float]] = {name: [] for name in ways}
    for _ in range(arguments.rounds):
        for name, pace in ways.items():
            paces[name].append(pace())

    def ratio(slower: str, faster: str) -> float:
        return statistics.median(b / a for a, b in zip(paces[slower], paces[faster], strict=True))

    for name, values in paces.items():
        print(f"{name:14} {statistics.median(values):7.0f} steps/s   ({min(values):.0f} to {max(values):.0f})")
    overhead, gain = ratio("Env.step", "gaitway run") - 1, ratio("make_vec(1)", "make_vec(2)")
    read = nanoseconds(lambda: robot.topic("estimate"))
    view = robot.view("estimate")
    field = nanoseconds(lambda: view["attitude"])
    idle = nanoseconds(lambda: None)
    print(f"Env.step over gaitway run: {overhead:+.1%}; over the bare co-simulation: {ratio('Env.step', 'Robot.run') - 1:+.1%}")
    print(f"the interpreter's part of a step: {interpreter_us(env):.0f} us of CPU time")
    print(f"make_vec(2) over make_vec(1): {gain:.2f}; two processes of gaitway run over one: {ratio('gaitway run', 'two of them'):.2f}")
    print(f"topic(): {read - idle:.0f} ns, {allocated(lambda: robot.topic('estimate'))} bytes; a view's field: {field - idle:.0f} ns")
    met = overhead <= 0.10 and statistics.median(paces["Env.step"]) >= 400 and gain >= 1.9 and read - idle <= 1000
    return 0 if met or not arguments.check else 1


if __name__ == "__main__":
    sys.exit(main())
