"""A Gymnasium environment whose step is one 80 ms cycle of the whole chain: limits, bus, servos, contact physics."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

try:
    import gymnasium
except ImportError as error:
    raise ImportError("gaitway.Env and gaitway.make_vec need Gymnasium 1.x: pip install 'gaitway[gym]'") from error

from gaitway import _actions
from gaitway._observations import Observation
from gaitway._rewards import Reward, Transition, follow_command
from gaitway._robot import Robot, _number

CYCLE_MS = 80
CYCLE_S = CYCLE_MS * 1e-3
Vector = np.ndarray[Any, np.dtype[np.float64]]


class Env(gymnasium.Env[Vector, Vector]):
    """One robot that learns, or is learned from.

    action         "walk", "step", "correction", "joint_plan", or an Action of your own
    observation    topics, or topic.field, one after the other; `observation_labels` says what each number is
    reward         of a Transition; the default: stay up and follow the command
    episode_s      truncated then; a fall terminates
    start_s        how long the robot stands before the first step, in whole cycles
    others         what gaitway.Robot takes
    """

    metadata: dict[str, Any] = {"render_modes": []}

    def __init__(
        self,
        action: str | _actions.Action = "walk",
        observation: Sequence[str] = ("estimate", "joint_states"),
        *,
        reward: Reward = follow_command,
        episode_s: float = 20.0,
        start_s: float = 0.96,
        **robot: Any,
    ) -> None:
        self._action = _actions.named(action)
        writes = [*robot.pop("writes", ()), *self._action.writes]
        if "seed" in robot:
            raise TypeError("an environment takes its seed by reset(seed=…)")
        if robot.pop("render_mode", None) is not None:
            raise TypeError("an environment draws no pictures: leave render_mode out. `gaitway simulate` shows a robot that walks")
        if not callable(reward):
            raise TypeError(f"reward = {reward!r}: must be a callable that takes a Transition")
        self.robot = Robot(writes=writes, **robot)
        self._observation = Observation(self.robot, observation)
        self._reward = reward
        self._cycles = _whole_cycles("episode_s", episode_s, 1)
        self._start_cycles = _whole_cycles("start_s", start_s, 1)
        self._cycle = 0
        self._needs_reset = True
        self._chosen: Vector = np.zeros(0)
        self._before = self.robot.truth()
        low, high = self._action.bounds(self.robot)
        self._bounds: tuple[list[float], list[float]] = (low.tolist(), high.tolist())
        self.action_space = gymnasium.spaces.Box(low, high, dtype=np.float64)
        self.observation_space = gymnasium.spaces.Box(self._observation.low, self._observation.high, dtype=np.float64)

    @property
    def observation_labels(self) -> list[str]:
        return list(self._observation.labels)

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[Vector, dict[str, Any]]:
        self.robot.restart(self.begin_reset(seed))
        self.robot.run(self._start_cycles * CYCLE_S)
        return self.finish_reset()

    def step(self, action: Vector) -> tuple[Vector, float, bool, bool, dict[str, Any]]:
        self.begin_step(self.checked(action))
        self.robot.run(CYCLE_S)
        transition, terminated, truncated = self.end_cycle()
        observation, reward, info = self.told(transition)
        return observation, reward, terminated, truncated, info

    def close(self) -> None:
        if not self.robot.closed:
            self.robot.close()

    # The two halves of reset and step, between which a VecEnv lets many robots run at once.

    @property
    def start_cycles(self) -> int:
        return self._start_cycles

    def begin_reset(self, seed: int | None) -> int:
        """The robot's seed: the one given, or the next of the environment's random numbers."""
        super().reset(seed=seed)
        return int(self.np_random.integers(2**31)) if seed is None else seed

    def finish_reset(self) -> tuple[Vector, dict[str, Any]]:
        self._cycle = 0
        self._needs_reset = False
        self._action.begin(self.robot)
        self._before = self.robot.truth()
        return self._observation.read(), {"time_s": self.robot.time_s}

    def checked(self, action: Vector) -> Vector:
        """What may be taken for a step. Raises where it may not, or where there is no step."""
        if self._needs_reset:
            raise gymnasium.error.ResetNeeded("step() before reset(), or after the end of an episode")
        chosen = np.asarray(action)
        if chosen.dtype.kind not in "fiu":
            raise TypeError(f"action: {chosen.dtype} where numbers are wanted")
        low, high = self._bounds
        if chosen.shape != (len(low),):
            raise ValueError(f"action: shape {chosen.shape}; must be ({len(low)},)")
        chosen = chosen.astype(np.float64)
        for least, number, most in zip(low, chosen.tolist(), high, strict=True):  # quicker than NumPy with cold caches
            if not least <= number <= most:  # as of what is not a number
                raise ValueError(f"action = {chosen}: must be within {low} and {high}. gymnasium.wrappers.ClipAction cuts it off there")
        return chosen

    def begin_step(self, checked: Vector) -> None:
        self._chosen = checked
        self._action.write(self.robot, checked)

    def end_cycle(self) -> tuple[Transition, bool, bool]:
        """What has happened, and whether it terminates or truncates the episode. The step is done, whatever its reward."""
        self._cycle += 1
        before, after, fallen = self._before, self.robot.truth(), self.robot.fallen
        self._before = after
        self._needs_reset = fallen
        truncated = not fallen and self._cycle >= self._cycles
        return Transition(self.robot, self._chosen, before, after, CYCLE_S, fallen), fallen, truncated

    def told(self, transition: Transition) -> tuple[Vector, float, dict[str, Any]]:
        """Observation, reward and info."""
        reward = _number("the reward", self._reward(transition))
        if not math.isfinite(reward):
            raise ValueError(f"the reward is {reward}: must be finite")
        return self._observation.read(), reward, {"time_s": self.robot.time_s}


def _whole_cycles(name: str, seconds: float, least: int) -> int:
    cycles = round(seconds / CYCLE_S) if np.isfinite(seconds) else 0
    if cycles < least:
        raise ValueError(f"{name} = {seconds}: must be at least one cycle, {CYCLE_S} s")
    return cycles
