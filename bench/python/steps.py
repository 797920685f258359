"""What the interpreter costs: Env.step against `gaitway run` in the same minute, two robots on two threads against one, and reads.

    PYTHONPATH=build/release/lib/python python bench/python/steps.py build/release/bin/gaitway [--check]

Each ratio comes of interleaved rounds, of which the median counts. --check: exit code 1 where a target is missed.
"""

from __future__ import annotations

import json
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time
import tracemalloc

import numpy as np

import gaitway

STEPS = 250
ROUNDS = 5
COMMAND = np.array([0.15, 0.0, 0.0])


def pace_of_command(command: str) -> float:
    """Steps of 80 ms a second, by the summary's own wall time."""
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([command, "run", "--seconds", str(STEPS * 0.08), "--seed", "1", "--out", folder, "--quiet", "--no-pictures"], check=True)
        summary = json.loads((pathlib.Path(folder) / "summary.json").read_text())
    return float(STEPS / summary["wall_seconds"])


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


def main() -> int:
    command = sys.argv[1]
    env, robot = gaitway.Env(episode_s=1e6), gaitway.Robot()
    one, two = gaitway.make_vec(1, threads=1, episode_s=1e6), gaitway.make_vec(2, threads=2, episode_s=1e6)
    paces: dict[str, list[float]] = {"gaitway run": [], "Robot.run": [], "Env.step": [], "make_vec(1)": [], "make_vec(2)": []}
    for _ in range(ROUNDS):
        paces["gaitway run"].append(pace_of_command(command))
        paces["Robot.run"].append(pace_of_robot(robot))
        paces["Env.step"].append(pace_of_env(env))
        paces["make_vec(1)"].append(pace_of_vec(one))
        paces["make_vec(2)"].append(pace_of_vec(two))
    for name, values in paces.items():
        print(f"{name:14} {statistics.median(values):7.0f} steps/s   ({min(values):.0f} to {max(values):.0f})")
    overhead = statistics.median(b / a for a, b in zip(paces["Env.step"], paces["Robot.run"], strict=True)) - 1
    overhead_run = statistics.median(b / a for a, b in zip(paces["Env.step"], paces["gaitway run"], strict=True)) - 1
    gain = statistics.median(b / a for a, b in zip(paces["make_vec(1)"], paces["make_vec(2)"], strict=True))
    read = nanoseconds(lambda: robot.topic("estimate"))
    view = robot.view("estimate")
    field = nanoseconds(lambda: view["attitude"])
    idle = nanoseconds(lambda: None)
    print(f"Env.step over gaitway run: {overhead_run:+.1%}; over the bare co-simulation: {overhead:+.1%}")
    print(f"the interpreter's part of a step: {interpreter_us(env):.0f} us of CPU time")
    print(f"make_vec(2) over make_vec(1): {gain:.2f}")
    print(f"topic(): {read - idle:.0f} ns, {allocated(lambda: robot.topic('estimate'))} bytes; a view's field: {field - idle:.0f} ns")
    met = overhead_run <= 0.10 and statistics.median(paces["Env.step"]) >= 400 and gain >= 1.9 and read - idle <= 1000
    return 0 if met or "--check" not in sys.argv else 1


if __name__ == "__main__":
    sys.exit(main())
