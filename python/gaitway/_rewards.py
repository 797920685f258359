"""What an agent is rewarded for; any callable that takes a Transition will do."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from gaitway._robot import Robot, Truth


class Transition(NamedTuple):
    """One cycle of 80 ms, as a reward sees it."""

    robot: Robot
    action: np.ndarray[Any, np.dtype[np.float64]]
    before: Truth
    after: Truth
    duration_s: float
    fallen: bool


Reward = Callable[[Transition], float]

SPEED_SCALE_M_PER_S = 0.1
TURN_SCALE_RAD_PER_S = 0.5


def follow_command(step: Transition) -> float:
    """Stay up, and do what is commanded: 1 for exactly that, down to 0; 0 for a robot that has fallen."""
    if step.fallen:
        return 0.0
    yaw = step.before.base_rpy_rad[2]
    dx = (step.after.base_m[0] - step.before.base_m[0]) / step.duration_s
    dy = (step.after.base_m[1] - step.before.base_m[1]) / step.duration_s
    turn = math.remainder(step.after.base_rpy_rad[2] - yaw, 2.0 * math.pi) / step.duration_s
    ahead, left = math.cos(yaw) * dx + math.sin(yaw) * dy, math.cos(yaw) * dy - math.sin(yaw) * dx
    command = step.robot.view("walk_command")
    velocity, turn_rate = command["velocity"], float(command["turn_rate"])
    off = math.hypot(ahead - velocity[0], left - velocity[1]) / SPEED_SCALE_M_PER_S
    off_turn = (turn - turn_rate) / TURN_SCALE_RAD_PER_S
    return math.exp(-(off**2) - off_turn**2)
