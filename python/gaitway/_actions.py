"""What an environment's action is: numbers in a box that become the value of a topic, and so go through the whole chain."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Protocol

import numpy as np

from gaitway import _topics
from gaitway._errors import UnknownTopic, suggest
from gaitway._robot import Robot

Vector = np.ndarray[Any, np.dtype[np.float64]]


class Action(Protocol):
    """How an agent commands the robot. Bounds are known once there is a robot."""

    @property
    def writes(self) -> Sequence[str]:
        """Topics that are taken over from a plug-in."""

    def bounds(self, robot: Robot) -> tuple[Vector, Vector]:
        """Lowest and highest, one number for each of the action's."""

    def begin(self, robot: Robot) -> None:
        """A new episode."""

    def write(self, robot: Robot, action: Vector) -> None:
        """Before each cycle of 80 ms."""


class TopicAction:
    """Fields of one topic, one after the other; others keep the values of `constants`, or 0.

    `low` and `high`: one number for each of the action's; None: the limits of the fields.
    """

    def __init__(self, topic: str, fields: Sequence[str], *, low: Sequence[float] | None = None,
                 high: Sequence[float] | None = None, constants: Mapping[str, Any] | None = None,
                 takes_over: bool = False) -> None:
        self.topic = _topics.find(topic)
        self.fields = [self.topic.field(name) for name in fields]
        for field in self.fields:
            if field.dtype.kind != "f":
                raise TypeError(f"topic '{topic}', field '{field.name}': {field.dtype}, and an action's numbers are not whole. "
                                "Give it in `constants`")
        self.constants = dict(constants or {})
        self.writes = (topic,) if takes_over else ()
        self._value = _topics.value_of(self.topic, self.constants, 0).reshape(1)
        self._numbers = _topics.Numbers(self._value, [(field, ()) for field in self.fields])
        self._stamp = self._value["stamp_ns"] if "stamp_ns" in self.topic.fields and "stamp_ns" not in self.constants else None
        self._sizes = [int(np.prod(field.shape, dtype=int)) for field in self.fields]
        size = sum(self._sizes)
        self._low = self._bound(low, [field.lowest for field in self.fields], size)
        self._high = self._bound(high, [field.highest for field in self.fields], size)

    def _bound(self, given: Sequence[float] | None, of_fields: list[float], size: int) -> Vector:
        bound = np.repeat(of_fields, self._sizes) if given is None else np.array(given, np.float64)
        if bound.shape != (size,) or not np.all(np.isfinite(bound)):
            raise ValueError(f"bounds of an action on '{self.topic.name}': {size} finite numbers are wanted, not {bound}")
        return bound.astype(np.float64)

    def bounds(self, robot: Robot) -> tuple[Vector, Vector]:
        return self._low, self._high

    def begin(self, robot: Robot) -> None:
        pass

    def write(self, robot: Robot, action: Vector) -> None:
        if self._stamp is not None:
            self._stamp[0] = robot._run.now_ns
        self._numbers.set(action)
        robot._run.write(self.topic.index, self._value)


class WalkAction(TopicAction):
    """A velocity command: ahead and to the left in m/s, turning in rad/s, as a person's order, which the arbiter obeys."""

    def __init__(self, low: Sequence[float] = (-0.35, -0.15, -1.0), high: Sequence[float] = (0.5, 0.15, 1.0)) -> None:
        super().__init__("walk_request", ("velocity", "turn_rate"), low=low, high=high, constants={"walk": 1})


class JointPlanAction:
    """Angles of all joints at the end of the next batch, in the place of the plug-in that plans them.

    The way there is straight, and no faster than the joints may be; the main controller checks the plan as any plug-in's.
    The safe tail holds the last point.
    """

    writes = ("joint_plan",)
    SPEED_SHARE = 0.9  # of the joints' speed limits
    TAIL_POINTS = 25

    def __init__(self) -> None:
        self._last: Vector = np.zeros(0)
        self._limits: Vector = np.zeros((0, 3))

    def bounds(self, robot: Robot) -> tuple[Vector, Vector]:
        self._limits = np.array(robot.joint_limits)
        return self._limits[:, 0].copy(), self._limits[:, 1].copy()

    def begin(self, robot: Robot) -> None:
        self._last = robot.topic("joint_states")["reference_position"][: len(robot.joints)].copy()

    def write(self, robot: Robot, action: Vector) -> None:
        from gaitway._env import CYCLE_S

        count = len(self._last)
        farthest = self.SPEED_SHARE * self._limits[:, 2] * CYCLE_S
        goal = self._last + np.clip(action - self._last, -farthest, farthest)
        plan = np.zeros((), _topics.find("joint_plan").dtype)
        plan["sequence"] = round(robot.time_s / CYCLE_S) + 1
        plan["joint_count"] = count
        plan["tail_count"] = self.TAIL_POINTS
        points = np.linspace(self._last, goal, 9)[1:]
        plan["position"][:8, :count] = points
        plan["position"][8 : 8 + self.TAIL_POINTS, :count] = points[-1]
        plan["support"][: 8 + self.TAIL_POINTS] = 2
        robot.write("joint_plan", plan)
        self._last = goal


_NAMED: Mapping[str, Any] = {
    "walk": WalkAction,
    "correction": lambda: TopicAction("correction", ("com_offset", "step_offset"), takes_over=True),
    "step": lambda: TopicAction("correction", ("step_offset",), takes_over=True),
    "joint_plan": JointPlanAction,
}


def named(action: str | Action) -> Action:
    """Raises UnknownTopic for a name that there is not."""
    if not isinstance(action, str):
        if missing := [name for name in ("writes", "bounds", "begin", "write") if not hasattr(action, name)]:
            raise TypeError(f"action = {action!r}: must be {', '.join(_NAMED)}, or an Action; it has no '{missing[0]}'")
        return action
    if action not in _NAMED:
        raise UnknownTopic(f"there is no action '{action}'. {suggest(action, _NAMED)} Or give a TopicAction")
    made: Action = _NAMED[action]()
    return made
