"""A plug-in in Python, for prototypes on simulated robots: one class in a file of its own.

    import gaitway.plugin as gp

    class Lean(gp.Plugin):
        \"\"\"Presses the ankles against the trunk's lean.\"\"\"
        version = "1.0.0"

        def __init__(self, setup: gp.Setup) -> None:
            self.gain = setup.parameter("gain", 0.25, "rad/rad")
            self.estimate = setup.reads("estimate")
            self.trim = setup.writes("trim")

        def step(self, tick: gp.Tick) -> None:
            trim = self.trim.value
            trim["stamp_ns"] = tick.now_ns
            trim["channel_count"] = 8
            trim["angle"][4:6] = self.gain * self.estimate.read()["attitude"][1]
            self.trim.publish()

A configuration names the file where it names a library: `library: ./lean.py`; so do `gaitway run --with lean.py` and
`Robot(libraries=["lean.py"])`. It runs in a process of its own, with the checks of any plug-in.
"""

from __future__ import annotations

import hashlib
import math
from typing import Any, Final, Generic, Literal, NamedTuple, TypeAlias, TypeVar

import numpy as np
import numpy.typing as npt

from gaitway import _native, _topics
from gaitway._errors import UnknownTopic
from gaitway._native import SetupError, Tick

__all__ = ["Input", "Live", "Output", "Plugin", "Report", "Setup", "SetupError", "Tick"]

StructuredArray: TypeAlias = "np.ndarray[Any, np.dtype[Any]]"
Value = TypeVar("Value", float, int, bool, str)
Number = TypeVar("Number", float, int, bool)

# As the plug-in interface numbers them.
_READ: Final = 0
_READ_PREVIOUS: Final = 1
_READ_OPTIONAL: Final = 2
_WRITE: Final = 3
_READ_PREVIOUS_OPTIONAL: Final = 4
_PERIODS: Final = ("tick", "batch")
_SEVERITIES: Final = ("info", "warning", "error")


class Plugin:
    """Derive from it once in a file. `__init__(setup)` declares, `step(tick)` works; the rest is as you need it."""

    name = ""  # "": that of the file
    version = "0.0.0"
    state_version = 0  # 0: nothing is handed on; else raise it whenever the meaning of the state's bytes changes

    def __init__(self, setup: Setup) -> None:
        del setup

    def activate(self) -> None:
        """Before the first step: inputs may be read, nothing may be published."""

    def step(self, tick: Tick) -> None:
        """Each tick or batch: reads, computes, publishes. An exception is a fault, and nothing of the step goes out."""
        raise NotImplementedError

    def deactivate(self) -> None:
        """After the last step."""

    def save_state(self) -> bytes:
        """With a state_version, after each good step: what the process that replaces this one goes on from; at most 64 KiB."""
        raise NotImplementedError

    def restore_state(self, state: bytes) -> None:
        """Before the first step of that."""
        raise NotImplementedError


class Input:
    """A topic that is read. Its value does not change during a step."""

    def __init__(self, port: _native.PluginPort, dtype: np.dtype[Any]) -> None:
        self._port = port
        self._value: StructuredArray = np.ndarray((), dtype, buffer=memoryview(port))

    def read(self) -> StructuredArray:
        """The value, read-only; zeros while there is none. The same array each time: copy what is to last longer."""
        self._port.refresh()
        return self._value

    @property
    def has_value(self) -> bool:
        return self._port.refresh()

    @property
    def sequence(self) -> int:
        """Counts the topic's values: two equal numbers mean the same value; 0: none."""
        self._port.refresh()
        return self._port.sequence

    def age_ns(self, now_ns: int) -> int:
        """Time since the value's stamp."""
        self._port.refresh()
        return now_ns - self._port.stamp_ns


class Output:
    """A topic that is written. `value` keeps what was filled in, from step to step."""

    def __init__(self, port: _native.PluginPort, dtype: np.dtype[Any]) -> None:
        self._port = port
        self.value: Final[StructuredArray] = np.ndarray((), dtype, buffer=memoryview(port))

    def publish(self) -> None:
        """Goes out when step() has returned; the last one of a step counts."""
        self._port.publish()


class Live(Generic[Number]):
    """The value of a parameter that may change between two steps."""

    def __init__(self, value: Number) -> None:
        self.value: Number = value


class Report:
    """Puts a line into the run's list of events, cut off after 160 bytes. From any thread."""

    def __init__(self, host: _native.PluginHost) -> None:
        self._host = host

    def __call__(self, severity: Literal["info", "warning", "error"], text: str) -> None:
        self._host.report(_number_of(severity, _SEVERITIES), text)


class _Type(NamedTuple):
    name: str
    hash: int
    dtype: np.dtype[Any]
    float_fields: list[_native.FloatField]


class Setup:
    """What a plug-in declares; for its `__init__` alone. What cannot be given is a SetupError: let it pass."""

    def __init__(self, host: _native.PluginHost) -> None:
        self._host = host
        self._live: dict[str, Live[Any]] = {}

    def parameter(self, name: str, fallback: Value, unit: str = "", *, lowest: float = -math.inf, highest: float = math.inf,
                  doc: str = "") -> Value:
        """The configuration's value, or `fallback`, whose type it has. Numbers have a unit; without one they are plain."""
        return self._declare(name, fallback, unit, lowest, highest, doc, False)

    def live_parameter(self, name: str, fallback: Number, unit: str = "", *, lowest: float = -math.inf,
                       highest: float = math.inf, doc: str = "") -> Live[Number]:
        """One that may be changed while the robot walks, between two steps."""
        live = Live(self._declare(name, fallback, unit, lowest, highest, doc, True))
        self._live[name] = live
        return live

    def period(self, period: Literal["tick", "batch"]) -> None:
        """When step() is called: every 10 ms, which is the default, or in ticks that prepare a batch alone."""
        self._host.set_period(_number_of(period, _PERIODS))

    def reads(self, topic: str, dtype: npt.DTypeLike | None = None) -> Input:
        """The value of this tick: stepped after the topic's writer, which must exist.

        Of a topic that is not standard, `dtype` says what its values are: a structured one, the same for all who use it.
        """
        return Input(*self._open(topic, dtype, _READ))

    def reads_previous(self, topic: str, dtype: npt.DTypeLike | None = None) -> Input:
        """The value of the tick before, in no order; the writer must exist."""
        return Input(*self._open(topic, dtype, _READ_PREVIOUS))

    def reads_optional(self, topic: str, dtype: npt.DTypeLike | None = None) -> Input:
        """As reads(), but nobody needs to write it."""
        return Input(*self._open(topic, dtype, _READ_OPTIONAL))

    def reads_previous_optional(self, topic: str, dtype: npt.DTypeLike | None = None) -> Input:
        """As reads_previous(), but nobody needs to write it."""
        return Input(*self._open(topic, dtype, _READ_PREVIOUS_OPTIONAL))

    def writes(self, topic: str, dtype: npt.DTypeLike | None = None) -> Output:
        """You are its only writer; once a topic."""
        return Output(*self._open(topic, dtype, _WRITE))

    def robot_directory(self) -> str:
        """The folder with robot.urdf and robot.yaml."""
        return self._host.robot_directory()

    def reporter(self) -> Report:
        return Report(self._host)

    def _declare(self, name: str, fallback: Value, unit: str, lowest: float, highest: float, doc: str, live: bool) -> Value:
        is_number = isinstance(fallback, (int, float)) and not isinstance(fallback, bool)
        return self._host.parameter(name, unit or ("1" if is_number else ""), doc, fallback, lowest, highest, live)

    def _open(self, topic: str, dtype: npt.DTypeLike | None, access: int) -> tuple[_native.PluginPort, np.dtype[Any]]:
        kind = _standard_type(topic) if dtype is None else _own_type(topic, np.dtype(dtype))
        port = self._host.open_topic(topic, kind.name, kind.hash, kind.dtype.itemsize, kind.float_fields, access)
        return port, kind.dtype


def _number_of(word: str, words: tuple[str, ...]) -> int:
    if word not in words:
        raise ValueError(f"'{word}': must be one of {', '.join(words)}")
    return words.index(word)


def _standard_type(name: str) -> _Type:
    try:
        topic = _topics.find(name)
    except UnknownTopic as error:
        raise UnknownTopic(f"{error} A topic of your own needs a dtype.") from None
    floats = [_float_field(field.name, np.dtype((field.dtype, field.shape)), field.offset, field.lowest, field.highest)
              for field in topic.fields.values() if field.dtype.kind == "f"]
    return _Type(topic.type_name, topic.type_hash, topic.dtype, floats)


def _own_type(name: str, dtype: np.dtype[Any]) -> _Type:
    standard = _topics.topics().get(name)
    if standard is not None:
        if standard.dtype != dtype:
            raise TypeError(f"topic '{name}' is a standard one, with values of {standard.dtype}, not of {dtype}. Leave its dtype out")
        return _standard_type(name)
    if dtype.fields is None:
        raise TypeError(f"topic '{name}': {dtype} has no fields. Give a structured dtype, such as [('angle_rad', 'f8', (2,))]")
    floats = []
    for field, about in dtype.fields.items():
        if about[0].base.kind not in "biuf" or not about[0].isnative or about[0].base.itemsize > 8:
            raise TypeError(f"topic '{name}', field '{field}': {about[0].base}; must be a number of this machine, of at most 8 bytes")
        if about[0].base.kind == "f":
            if about[0].base.itemsize < 4:
                raise TypeError(f"topic '{name}', field '{field}': {about[0].base}; floating-point numbers have 4 or 8 bytes")
            floats.append(_float_field(field, about[0], about[1], -math.inf, math.inf))
    digest = hashlib.blake2b(repr((dtype.descr, dtype.itemsize)).encode(), digest_size=8).digest()
    return _Type(name, int.from_bytes(digest, "little"), dtype, floats)


def _float_field(name: str, dtype: np.dtype[Any], offset: int, lowest: float, highest: float) -> _native.FloatField:
    rows = dtype.shape[0] if dtype.shape else 1
    return name, offset, math.prod(dtype.shape), dtype.base.itemsize, rows, lowest, highest
