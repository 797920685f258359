"""The whole chain beside MuJoCo alone, and vectors of environments beside Gymnasium's."""

from __future__ import annotations

import functools
import os
import pathlib
import time
from collections.abc import Callable
from typing import Any

from contest import Contest, MeasurementError, Place, json_of
from ratios import Pair, Row

WALK_S = 10  # of the robot's time
VECTOR_STEPS = 100
VECTOR_TURNS = 2
COMMAND = (0.15, 0.0, 0.0)


def recorded_walk(place: Place) -> pathlib.Path:
    """The folder with a walk's model and torques; recorded once a run."""
    folder = place.scratch / "walk"
    if not (folder / "torques.f32").exists():
        json_of([place.programs / "chain_peers", str(WALK_S), folder])
    return folder


class Chain(Contest):
    name = "chain"
    about = "the whole chain of a walk: MuJoCo alone with the same torques, in C and by its Python wheel"

    def play(self) -> None:
        in_c = Row("whole chain, a step of 1 ms", "MuJoCo alone, C", "µs")
        by_wheel = Row("whole chain, a step of 1 ms", "MuJoCo alone, Python wheel", "µs")
        taken = json_of([self.program("chain_peers"), str(WALK_S), self.place.scratch / "walk"])
        ours = taken["chain"]["ns"] * 1e-3
        self.add("c", in_c, Pair(ours, taken["mj_step"]["ns"] * 1e-3, f"{taken['steps']:.0f} steps, same end to the bit"))
        try:
            import physics
        except ImportError as error:
            self.miss("wheel", by_wheel, f"{error}: pip install mujoco gymnasium")
            return
        walk = physics.RecordedWalk(recorded_walk(self.place))
        taken_ns = walk.ns_a_step()
        if not walk.is_where_the_chain_ended:
            raise MeasurementError("MuJoCo's wheel does not end where the chain does: they did not do the same")
        self.add("wheel", by_wheel, Pair(ours, taken_ns * 1e-3, "mj_step in a loop, same end to the bit"))


class Vectors(Contest):
    name = "vectors"
    about = "gaitway.make_vec: Gymnasium's AsyncVectorEnv over bare MuJoCo, and over gaitway.Env"

    def play(self) -> None:
        count = len(os.sched_getaffinity(0))
        bare = Row(f"make_vec({count}), a step of 80 ms", "AsyncVectorEnv over MuJoCo alone", "ms")
        whole = Row(f"make_vec({count}), a step of 80 ms", "AsyncVectorEnv over gaitway.Env", "ms")
        try:
            import gymnasium
            import physics
        except ImportError as error:
            for key, row in (("bare", bare), ("whole", whole)):
                self.miss(key, row, f"{error}: pip install mujoco gymnasium")
            return
        import gaitway

        def beside(make: Callable[[], Any]) -> Any:
            return gymnasium.vector.AsyncVectorEnv([make] * count, context="spawn")

        vectors = {"ours": gaitway.make_vec(count, observation=["estimate"], episode_s=1e6),
                   "bare": beside(functools.partial(physics.BareWalkEnv, recorded_walk(self.place))),
                   "whole": beside(chain_env)}
        try:
            taken: dict[str, list[float]] = {name: [] for name in vectors}
            for _ in range(VECTOR_TURNS):
                for name, vector in vectors.items():
                    taken[name].append(ms_a_step(vector, count))
        finally:
            for vector in vectors.values():
                vector.close()
        ours = min(taken["ours"])
        self.add("bare", bare, Pair(ours, min(taken["bare"]), "the peer: physics alone, no sensors, controllers, bus or plug-ins"))
        self.add("whole", whole, Pair(ours, min(taken["whole"]), "the same robots on both sides"))


def chain_env() -> Any:
    """In the process that AsyncVectorEnv makes for it."""
    import gaitway

    return gaitway.Env(observation=["estimate"], episode_s=1e6)


def ms_a_step(vector: Any, count: int) -> float:
    import numpy as np

    vector.reset(seed=1)
    actions = np.repeat(np.array(COMMAND)[None], count, 0)
    began = time.perf_counter()
    for _ in range(VECTOR_STEPS):
        _, _, terminated, truncated, _ = vector.step(actions)
        if np.any(terminated) or np.any(truncated):
            raise MeasurementError("an environment ended meanwhile: its step was not one of the walk")
    return (time.perf_counter() - began) * 1e3 / VECTOR_STEPS
