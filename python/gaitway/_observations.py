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
        self._parts: list[tuple[_topics.Numbers, slice]] = []
        for name in names:
            topic_name, _, field_name = name.partition(".")
            topic = _topics.find(topic_name)
            chosen = [topic.field(field_name)] if field_name else [f for f in topic.fields.values() if not _is_stamp(f)]
            self._add(robot, topic, chosen, low, high)
        self.low, self.high = np.array(low), np.array(high)

    def _add(self, robot: Robot, topic: _topics.Topic, fields: Sequence[_topics.Field], low: list[float], high: list[float]) -> None:
        at = len(self.labels)
        chosen: list[tuple[_topics.Field, _topics.Elements]] = []
        for field in fields:
            elements = tuple(slice(len(robot.joints)) if extent == _topics.JOINT_EXTENT else slice(None) for extent in field.shape)
            shape = np.empty(field.shape, np.uint8)[elements].shape
            self.labels += [f"{topic.name}.{field.name}" + "".join(f"[{i}]" for i in index) for index in np.ndindex(shape)]
            count = len(self.labels) - len(low)
            low += [0.0 if field.dtype.kind == "u" else field.lowest] * count
            high += [field.highest] * count
            chosen.append((field, elements))
        self._parts.append((_topics.Numbers(robot.view(topic.name), chosen), slice(at, len(self.labels))))

    def read(self) -> Vector:
        """A new vector, of what the topics hold now."""
        vector = np.empty(len(self.labels))
        for numbers, place in self._parts:
            numbers.get(vector[place])
        return vector
