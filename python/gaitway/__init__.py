"""Gaitway from Python: a humanoid robot in simulation, through the whole chain from plug-ins to contact physics.

    import gaitway

    robot = gaitway.Robot(seed=3)
    robot.run(1.0)
    robot.walk(0.15)
    robot.run(7.0)
    print(robot.truth().base_m, robot.topic("estimate")["attitude"])

Nothing happens on import: each name is loaded when it is first used.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from gaitway._actions import Action, JointPlanAction, TopicAction, WalkAction
    from gaitway._env import CYCLE_S, Env
    from gaitway._errors import (BusyError, ClosedError, ForkError, InputError, NothingPublished, PluginError,
                                 TopicError, UnknownTopic)
    from gaitway._rewards import Reward, Transition, follow_command
    from gaitway._robot import Batches, Event, Fault, Robot, Snapshot, Truth
    from gaitway._topics import Field, Topic, topics
    from gaitway._vec import VecEnv, make_vec

_PLACES = {
    "_actions": ("Action", "JointPlanAction", "TopicAction", "WalkAction"),
    "_env": ("CYCLE_S", "Env"),
    "_errors": ("BusyError", "ClosedError", "ForkError", "InputError", "NothingPublished", "PluginError", "TopicError",
                "UnknownTopic"),
    "_rewards": ("Reward", "Transition", "follow_command"),
    "_robot": ("Batches", "Event", "Fault", "Robot", "Snapshot", "Truth"),
    "_topics": ("Field", "Topic", "topics"),
    "_vec": ("VecEnv", "make_vec"),
}
_MODULE_OF = {name: module for module, names in _PLACES.items() for name in names}

__all__ = [
    "CYCLE_S", "Action", "Batches", "BusyError", "ClosedError", "Env", "Event", "Fault", "Field", "ForkError", "InputError",
    "JointPlanAction", "NothingPublished", "PluginError", "Reward", "Robot", "Snapshot", "Topic", "TopicAction",
    "TopicError", "Transition", "Truth", "UnknownTopic", "VecEnv", "WalkAction", "follow_command", "make_vec", "topics",
]


def __getattr__(name: str) -> Any:
    if name == "__version__":
        return importlib.import_module("gaitway._native").__version__
    if name not in _MODULE_OF:
        raise AttributeError(f"module 'gaitway' has no attribute '{name}'")
    value = getattr(importlib.import_module("gaitway." + _MODULE_OF[name]), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted([*__all__, "__version__"])
