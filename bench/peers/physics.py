"""MuJoCo's wheel alone, with what `chain_peers` has left of a walk: its model and the torques of each step."""

from __future__ import annotations

import pathlib
import time
from typing import Any

import gymnasium
import mujoco
import numpy as np

CYCLE_STEPS = 80
STAND_CYCLES = 12  # of the 0.96 s for which the robot stands first, as a gaitway.Env does

Vector = np.ndarray[Any, np.dtype[np.float64]]


class RecordedWalk:
    """A robot that does the walk once more, on bare physics."""

    def __init__(self, folder: pathlib.Path) -> None:
        self.model = mujoco.MjModel.from_binary_path(str(folder / "model.mjb"))
        self.data = mujoco.MjData(self.model)
        self._start = np.fromfile(folder / "start.f64")
        self._end = np.fromfile(folder / "end.f64")
        self._addresses = np.fromfile(folder / "velocity_addresses.i32", dtype=np.int32)
        self.torques = np.fromfile(folder / "torques.f32", dtype=np.float32).astype(np.float64).reshape(-1, len(self._addresses))
        applied = slice(int(self._addresses[0]), int(self._addresses[0]) + len(self._addresses))
        if not np.array_equal(self._addresses, np.arange(applied.start, applied.stop)):
            raise ValueError("the joints' velocities do not lie in a row, as this loop takes them")
        self._applied = applied
        if round(CYCLE_STEPS * self.model.opt.timestep, 9) != CYCLE_STEPS * 1e-3:
            raise ValueError(f"steps of {self.model.opt.timestep} s; a cycle of 80 ms is taken to have {CYCLE_STEPS}")

    def restart(self) -> None:
        mujoco.mj_resetData(self.model, self.data)
        self.data.qpos[:] = self._start
        mujoco.mj_forward(self.model, self.data)

    def advance(self, begin: int, end: int) -> None:
        model, data, applied, step = self.model, self.data, self.data.qfrc_applied[self._applied], mujoco.mj_step
        for torque in self.torques[begin:end]:
            applied[:] = torque
            step(model, data)

    @property
    def is_where_the_chain_ended(self) -> bool:
        return np.array_equal(self.data.qpos, self._end)

    def ns_a_step(self) -> float:
        """Of the whole walk, in an ordinary loop: the processor's time, as `chain_peers` takes it."""
        self.restart()
        began = time.thread_time_ns()
        self.advance(0, len(self.torques))
        return (time.thread_time_ns() - began) / len(self.torques)


class BareWalkEnv(gymnasium.Env[Vector, Vector]):
    """The least that is an environment: 80 ms of bare physics a step. The action changes nothing."""

    def __init__(self, folder: pathlib.Path) -> None:
        self._walk = RecordedWalk(folder)
        size = self._walk.model.nq + self._walk.model.nv
        self.observation_space = gymnasium.spaces.Box(-np.inf, np.inf, (size,), np.float64)
        self.action_space = gymnasium.spaces.Box(-1.0, 1.0, (3,), np.float64)
        self._next = 0

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[Vector, dict[str, Any]]:
        super().reset(seed=seed)
        self._walk.restart()
        self._next = STAND_CYCLES * CYCLE_STEPS
        self._walk.advance(0, self._next)
        return self._observation(), {}

    def step(self, action: Vector) -> tuple[Vector, float, bool, bool, dict[str, Any]]:
        end = self._next + CYCLE_STEPS
        if end > len(self._walk.torques):
            raise gymnasium.error.ResetNeeded("the recorded walk is at its end")
        self._walk.advance(self._next, end)
        self._next = end
        return self._observation(), 0.0, False, False, {}

    def _observation(self) -> Vector:
        return np.concatenate([self._walk.data.qpos, self._walk.data.qvel])
