"""Chosen topics as one vector: every number of them but time stamps, joints that there are not left out."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from gaitway import _topics
from gaitway._robot import Robot

Vector = np.ndarray[Any, np.dtype[np.float64]]


def _is_stamp(field: _topics.Field) -> bool:
    return field.unit == "ns"


class Observation:
    """Reads `topic` or `topic.field` for each name given, in that order. `labels` say what each number is."""

    def __init__(self, robot: Robot, names: Sequence[str]) -> None:
        if isinstance(names, str) or not names:
            raise ValueError(f"observation = {names!r}: must be a list of names, such as ('estimate', 'imu.inclination')")
        self.labels: list[str] = []
        low: list[float] = []
        high: list[float] = []
        self._parts: list[tuple[Any, Any, slice]] = []
        for name in names:
            topic_name, _, field_name = name.partition(".")
            topic = _topics.find(topic_name)
            chosen = [topic.field(field_name)] if field_name else [f for f in topic.fields.values() if not _is_stamp(f)]
            for field in chosen:
                self._add(robot, topic, field, low, high)
        self.low, self.high = np.array(low), np.array(high)

    def _add(self, robot: Robot, topic: _topics.Topic, field: _topics.Field, low: list[float], high: list[float]) -> None:
        shown = robot.view(topic.name)[field.name]
        keep = tuple(slice(len(robot.joints)) if extent == _topics.JOINT_EXTENT else slice(None) for extent in field.shape)
        part = shown[keep] if field.shape else shown
        at = len(self.labels)
        self.labels += [f"{topic.name}.{field.name}" + "".join(f"[{i}]" for i in index) for index in np.ndindex(part.shape)]
        count = len(self.labels) - at
        unsigned = field.dtype.kind == "u"
        low += [0.0 if unsigned else field.lowest] * count
        high += [field.highest] * count
        self._parts.append((part, part.shape, slice(at, at + count)))

    def read(self) -> Vector:
        """A new vector, of what the topics hold now."""
        vector = np.empty(len(self.labels))
        for part, shape, place in self._parts:
            vector[place].reshape(shape)[...] = part
        return vector
