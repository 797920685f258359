"""The standard topics with their fields, units and NumPy types, made from the table that the C++ is made from."""

from __future__ import annotations

import functools
import types
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from gaitway import _native
from gaitway._errors import UnknownTopic, suggest

# Arrays with this extent have an entry a joint; no other array has it.
JOINT_EXTENT = 64


@dataclass(frozen=True)
class Field:
    """One field of a topic's type."""

    name: str
    dtype: np.dtype[Any]
    shape: tuple[int, ...]
    offset: int
    unit: str
    frame: str
    doc: str
    lowest: float
    highest: float


@dataclass(frozen=True)
class Topic:
    """One standard topic: who writes it, how often (`period_s`; 0: on change), and what its values are."""

    name: str
    type_name: str
    type_hash: int
    doc: str
    writer: str
    period_s: float
    dtype: np.dtype[Any]
    fields: Mapping[str, Field]
    index: int

    def field(self, name: str) -> Field:
        """Raises UnknownTopic, which names the nearest field."""
        if not isinstance(name, str):
            raise TypeError(f"topic '{self.name}': a field goes by its name, a str; not by {type(name).__name__}")
        if name not in self.fields:
            raise UnknownTopic(f"topic '{self.name}' has no field '{name}'. {suggest(name, self.fields)}")
        return self.fields[name]

    def __str__(self) -> str:
        when = f"every {self.period_s * 1e3:g} ms" if self.period_s > 0 else "on change"
        lines = [f"{self.name} ({self.type_name}): {self.doc}", f"  written by {self.writer}, {when}"]
        for field in self.fields.values():
            shape = "x".join(map(str, field.shape))
            about = ", ".join(part for part in (field.unit, field.frame, field.doc) if part)
            lines.append(f"  {field.name:24} {field.dtype.name}{f'[{shape}]' if shape else ''}  {about}")
        return "\n".join(lines)


def _field(raw: _native.RawField) -> Field:
    name, scalar, shape, offset, unit, frame, doc, lowest, highest = raw
    return Field(name, np.dtype(scalar), tuple(shape), offset, unit, frame, doc, lowest, highest)


def _topic(index: int, raw: _native.RawTopic) -> Topic:
    name, type_name, size, type_hash, doc, writer, period_ns, raw_fields = raw
    fields = {field[0]: _field(field) for field in raw_fields}
    dtype = np.dtype({"names": list(fields), "formats": [(field.dtype, field.shape) for field in fields.values()],
                      "offsets": [field.offset for field in fields.values()], "itemsize": size})
    return Topic(name, type_name, type_hash, doc, writer, period_ns * 1e-9, dtype, types.MappingProxyType(fields), index)


@functools.cache
def topics() -> Mapping[str, Topic]:
    """All standard topics by their names."""
    return types.MappingProxyType({raw[0]: _topic(index, raw) for index, raw in enumerate(_native.topics())})


def find(name: str) -> Topic:
    """Raises UnknownTopic, which names the nearest topic."""
    if not isinstance(name, str):
        raise TypeError(f"a topic goes by its name, a str; not by {type(name).__name__}")
    found = topics().get(name)
    if found is None:
        raise UnknownTopic(f"there is no topic '{name}'. {suggest(name, topics())}")
    return found


Elements = tuple[slice, ...]  # of a field; () for all


class Numbers:
    """Chosen numbers of one value, one after the other as a vector: few operations, since each runs with cold caches in a step."""

    def __init__(self, value: np.ndarray[Any, np.dtype[Any]], chosen: Sequence[tuple[Field, Elements]]) -> None:
        memory = value.reshape(1).view(np.uint8)
        places: dict[np.dtype[Any], tuple[list[int], list[int]]] = {}  # where in the memory, where in the vector
        self.size = 0
        for field, elements in chosen:
            of_field = np.arange(int(np.prod(field.shape, dtype=int))).reshape(field.shape)[elements].ravel()
            there, here = places.setdefault(field.dtype, ([], []))
            there += [field.offset // field.dtype.itemsize + int(i) for i in of_field]
            here += range(self.size, self.size + len(of_field))
            self.size += len(of_field)
        self._parts = [(memory[: memory.size // scalar.itemsize * scalar.itemsize].view(scalar), _run_of(there), _run_of(here))
                       for scalar, (there, here) in places.items()]

    def get(self, vector: np.ndarray[Any, np.dtype[np.float64]]) -> None:
        for memory, there, here in self._parts:
            vector[here] = memory[there]

    def set(self, vector: np.ndarray[Any, np.dtype[np.float64]]) -> None:
        for memory, there, here in self._parts:
            memory[there] = vector[here]


def _run_of(indices: list[int]) -> slice | np.ndarray[Any, np.dtype[np.intp]]:
    if indices == list(range(indices[0], indices[0] + len(indices))):
        return slice(indices[0], indices[0] + len(indices))
    return np.array(indices, np.intp)


def value_of(topic: Topic, given: Any, now_ns: int) -> np.ndarray[Any, np.dtype[Any]]:
    """A whole value: of one with the topic's dtype, or of a mapping, whose missing fields are 0 and whose stamp is now."""
    if isinstance(given, Mapping):
        value = np.zeros((), topic.dtype)
        if "stamp_ns" in topic.fields:
            value["stamp_ns"] = now_ns
        for name, number in given.items():
            _assign(value, topic, topic.field(name), number)
        return value
    array = np.asarray(given)
    if array.dtype != topic.dtype or array.size != 1:
        raise TypeError(f"topic '{topic.name}' takes a mapping of its fields, or one value of its dtype; not "
                        f"{array.dtype} with shape {array.shape}")
    return np.array(array.reshape(()), order="C")


def _assign(value: np.ndarray[Any, np.dtype[Any]], topic: Topic, field: Field, given: Any) -> None:
    where = f"topic '{topic.name}', field '{field.name}'"
    if isinstance(given, (str, bytes)) and field.dtype == np.uint8:  # a text, ended by NUL
        text = given.encode() if isinstance(given, str) else given
        if len(text) >= field.shape[0]:
            raise ValueError(f"{where}: a text of {len(text)} bytes; at most {field.shape[0] - 1} have room")
        value[field.name][: len(text)] = np.frombuffer(text, np.uint8)
        return
    array = np.asarray(given)
    if array.shape != field.shape:
        raise ValueError(f"{where}: shape {array.shape}; must be {field.shape}")
    if array.dtype.kind not in "biuf" or not np.can_cast(array.dtype, field.dtype, "same_kind"):
        if array.dtype.kind not in "bi" or field.dtype.kind != "u" or np.any(array < 0):
            raise TypeError(f"{where}: {array.dtype} where {field.dtype} is wanted")
    if field.dtype.kind in "iu" and array.size > 0:
        span = np.iinfo(field.dtype)
        if int(array.min()) < span.min or int(array.max()) > span.max:
            raise ValueError(f"{where}: {given!r} is beyond what {field.dtype} holds")
    value[field.name] = array
