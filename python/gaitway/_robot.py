"""One simulated robot: it runs, is told what to do, is pushed, and all that it knows can be read."""

from __future__ import annotations

import json
import math
import operator
import os
import sys
from collections.abc import Iterable, Mapping
from typing import Any, NamedTuple, NoReturn, TypeAlias

import numpy as np

from gaitway import _native, _topics
from gaitway._errors import NothingPublished, TopicError
from gaitway._native import Snapshot as Snapshot

StructuredArray: TypeAlias = "np.ndarray[Any, np.dtype[Any]]"
MILLISECONDS_A_SLICE = 1000  # of a long run, between which a keyboard's interrupt is heard
PUSH_S = 0.1

if sys.executable:  # what the processes of plug-ins in Python run
    os.environ.setdefault("GAITWAY_PYTHON", sys.executable)


class Event(NamedTuple):
    """What the main controller, the network or a plug-in had to say."""

    time_s: float
    kind: str  # info, warning, error, fault or refusal
    source: str
    text: str


class Fault(NamedTuple):
    """How often a plug-in's steps failed."""

    plugin: str
    steps: int
    faults: int


class Truth(NamedTuple):
    """Where the robot really is, in the world: for rewards and reports, known to no plug-in."""

    base_m: tuple[float, float, float]
    base_rpy_rad: tuple[float, float, float]
    com_m: tuple[float, float, float]
    cop_m: tuple[float, float, float]
    tilt_rad: float


class Batches(NamedTuple):
    """What became of the batches of 80 ms."""

    handed_over: int
    late: int
    refused: int
    tail_played: int
    repaired: int


class _Held:
    """A topic that was read: its newest value, and the view onto it."""

    __slots__ = ("index", "sequence", "topic", "value", "view")

    def __init__(self, topic: _topics.Topic) -> None:
        self.topic = topic
        self.index = topic.index
        self.sequence = 0
        self.value: StructuredArray | None = None
        self.view: StructuredArray | None = None


class Robot:
    """A robot in simulation, with everything that it consists of; made as `gaitway run` makes it.

    robot, config, world    paths, or names of shipped ones; None: the defaults of `gaitway run`
    seed                    of what differs from robot to robot, of noise and clock drifts
    mismatch                scale of what the planner does not know of the robot
    conditions              of ground and body, as a scenario's `conditions`
    parameters              {plug-in: {parameter: value}}, in place of the configuration's
    libraries               plug-in libraries, in the place of those whose topics they write
    writes                  topics that you write; the plug-ins that otherwise do are taken out
    navigation              with the plug-in that walks to places (`walk_to`), and what tells the robot where it is

    One thread at a time. `close()` frees it at once; so does the end of a `with` block.
    """

    def __init__(
        self,
        robot: str | os.PathLike[str] | None = None,
        config: str | os.PathLike[str] | None = None,
        *,
        seed: int = 1,
        world: str | os.PathLike[str] | None = None,
        world_seed: int | None = None,
        mismatch: float = 1.0,
        conditions: Mapping[str, Any] | None = None,
        parameters: Mapping[str, Mapping[str, Any]] | None = None,
        libraries: Iterable[str | os.PathLike[str]] = (),
        writes: Iterable[str] = (),
        profile: str = "",
        accept_unproven: bool = False,
        navigation: bool = False,
        localization: bool = True,
    ) -> None:
        self._setup = _native.Setup(
            robot="" if robot is None else _path("robot", robot),
            configuration="" if config is None else _path("config", config),
            profile=profile,
            accept_unproven=accept_unproven,
            libraries=[_path("libraries", library) for library in _several("libraries", libraries)],
            parameters=_parameters({} if parameters is None else parameters),
            world=None if world is None else _path("world", world),
            world_seed=None if world_seed is None else _seed(world_seed),
            conditions="" if conditions is None else _json("conditions", conditions),
            navigation=navigation,
            localization=localization,
            mismatch=float(mismatch),
            writes=[_topics.find(topic).name for topic in _several("writes", writes)],
        )
        self._held: dict[str, _Held] = {}
        self._run = _native.Run(self._setup, _seed(seed))

    # What it is.

    @property
    def name(self) -> str:
        return self._setup.name

    @property
    def joints(self) -> list[str]:
        """Names, in the order of all arrays over joints."""
        return self._setup.joints

    @property
    def joint_limits(self) -> list[tuple[float, float, float]]:
        """Of each joint: lowest and highest angle in rad, largest speed in rad/s."""
        return self._setup.joint_limits

    @property
    def links(self) -> list[str]:
        return self._setup.links

    @property
    def seed(self) -> int:
        return self._run.seed

    @property
    def hip_height_m(self) -> float:
        """Of the hip axes above the soles, in the stand."""
        return self._setup.hip_height_m

    @property
    def mass_kg(self) -> float:
        return self._setup.mass_kg

    @property
    def plugins_taken_out(self) -> list[str]:
        """Whose topics are written from outside."""
        return self._setup.plugins_taken_out

    # Time.

    @property
    def time_s(self) -> float:
        return self._run.now_ns * 1e-9

    def run(self, seconds: float) -> None:
        """Lets it go on for this long of its own time, rounded to whole milliseconds: each call by itself."""
        seconds = _number("seconds", seconds)
        if not math.isfinite(seconds) or seconds < 0:
            raise ValueError(f"seconds = {seconds}: must be a finite number that is not negative")
        milliseconds = round(seconds * 1e3)
        while milliseconds > 0:
            self._run.advance(min(milliseconds, MILLISECONDS_A_SLICE))
            milliseconds -= MILLISECONDS_A_SLICE

    def restart(self, seed: int | None = None) -> None:
        """Begins anew, as if it had just been made; `seed`: with another one."""
        self._forget()
        self._run.restart(self._run.seed if seed is None else _seed(seed))

    def snapshot(self) -> Snapshot:
        """What it takes to make this instant again: the seed, and all that was asked so far. A few bytes for each."""
        return self._run.snapshot()

    def restore(self, snapshot: Snapshot) -> None:
        """Makes the snapshot's instant again, to the bit, by simulating from the beginning: as long as that took.

        A keyboard's interrupt leaves the robot on the way there.
        """
        if not isinstance(snapshot, Snapshot):
            raise TypeError(f"snapshot = {snapshot!r}: must be what snapshot() returned")
        self._forget()
        self._run.restore(snapshot)

    def close(self) -> None:
        """Frees all that it takes. Arrays of its topics stay as they are."""
        self._run.close()

    @property
    def closed(self) -> bool:
        return self._run.closed

    # What is asked of it, in the millisecond that comes next.

    def walk(self, vx: float = 0.0, vy: float = 0.0, wz: float = 0.0) -> None:
        """Walks on: ahead and to the left in m/s, turning in rad/s; all 0: on the spot."""
        command = [_number(name, value) for name, value in (("vx", vx), ("vy", vy), ("wz", wz))]
        if not all(map(math.isfinite, command)):
            raise ValueError(f"walk = {command}: must be three finite numbers, m/s ahead and to the left, rad/s")
        self.apply({"walk": command})

    def stand(self) -> None:
        """Finishes the step and stands."""
        self.apply({"stand": True})

    def push(self, link: str, impulse: Iterable[float], duration_s: float = PUSH_S) -> None:
        """A constant force at the link's centre of mass that gives the impulse (x, y, z of the world, N·s)."""
        vector = [_number("impulse", part) for part in _several("impulse", impulse)]
        if len(vector) != 3 or not all(map(math.isfinite, vector)):
            raise ValueError(f"impulse = {vector}: must be three finite numbers, N*s along x, y and z of the world")
        strength = math.hypot(*vector)
        if strength == 0.0:
            raise ValueError("impulse = [0, 0, 0]: a push of nothing has no direction")
        self.apply({"push": {"body": link, "direction": [part / strength for part in vector], "impulse_Ns": strength,
                             "duration_s": duration_s}})

    def apply(self, action: str | Mapping[str, Any]) -> None:
        """Any action of a scenario, as YAML or as a mapping: {"motion": "wave"}, {"fault": {"kind": "jam", …}}."""
        if not isinstance(action, (str, Mapping)):
            raise TypeError(f"an action is a text or a mapping, not {type(action).__name__}")
        self._run.apply(action if isinstance(action, str) else _json("action", action))

    def write(self, topic: str, value: Mapping[str, Any] | StructuredArray) -> None:
        """Publishes a value: of a topic of requests, or of those named in `writes`. What is missing is 0, but for the stamp."""
        described = _topics.find(topic)
        whole = _topics.value_of(described, value, self._run.now_ns)
        try:
            self._run.write(described.index, whole)
        except TopicError as error:
            if self.writer_of(topic) != "main_controller" or described.writer not in {fault.plugin for fault in self.faults()}:
                raise
            raise TopicError(f"topic '{topic}' is already written by the plug-in {described.writer}. Robot(writes=['{topic}']) takes "
                             "that plug-in out, and leaves its topics to you") from error

    # What can be read.

    def topic(self, name: str) -> StructuredArray:
        """The newest value, a read-only array that never changes: the same one until something newer is published."""
        held = self._held.get(name) or self._hold(name)
        sequence = self._run.sequence(held.index)
        if sequence == held.sequence and held.value is not None:
            return held.value
        if sequence == 0:
            raise NothingPublished(f"topic '{name}': nothing has been published yet by {held.topic.writer}")
        value = np.empty((), held.topic.dtype)
        held.sequence = self._run.read(held.index, value)
        value.flags.writeable = False
        held.value = value
        return value

    def view(self, name: str) -> StructuredArray:
        """A read-only array that shows the newest value after each `run`, without a copy. It outlives the robot."""
        held = self._held.get(name) or self._hold(name)
        if held.view is None:
            held.view = np.ndarray((), held.topic.dtype, buffer=memoryview(self._run.view(held.index)))
        return held.view

    def age_s(self, name: str) -> float | None:
        """How old the newest value is by its writer's stamp; None: there is none."""
        stamp_ns = self._run.stamp_ns(_topics.find(name).index)
        return None if stamp_ns < 0 else (self._run.now_ns - stamp_ns) * 1e-9

    def writer_of(self, name: str) -> str | None:
        """Who writes a topic at the moment; None: nobody, so `write` may."""
        return self._run.writer_of(_topics.find(name).name) or None

    def events(self) -> list[Event]:
        """What was told since the beginning, the newest 10,000."""
        return [Event(*event) for event in self._run.events()]

    def faults(self) -> list[Fault]:
        """Of each plug-in, in the order of their steps."""
        return [Fault(*plugin) for plugin in self._run.plugins()]

    def batches(self) -> Batches:
        return Batches(*self._run.batches())

    def truth(self) -> Truth:
        n = self._run.whereabouts()
        return Truth((n[0], n[1], n[2]), (n[3], n[4], n[5]), (n[6], n[7], n[8]), (n[9], n[10], n[11]), n[12])

    @property
    def positions(self) -> np.ndarray[Any, np.dtype[np.float64]]:
        """MuJoCo's qpos: base x, y, z and quaternion, then the joints."""
        return np.array(self._run.positions)

    @property
    def velocities(self) -> np.ndarray[Any, np.dtype[np.float64]]:
        """MuJoCo's qvel."""
        return np.array(self._run.velocities)

    @property
    def fallen(self) -> bool:
        return self._run.fallen

    @property
    def digest(self) -> str:
        """Of every frame and state so far: as `gaitway run` has it in its summary. The same to the bit, or not."""
        return f"{self._run.digest:016x}"

    # Python's own.

    def __enter__(self) -> Robot:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def __repr__(self) -> str:
        return (f"<gaitway.Robot '{self.name}', closed>" if self.closed
                else f"<gaitway.Robot '{self.name}', seed {self.seed}, {self.time_s:.3f} s>")

    def __reduce__(self) -> NoReturn:
        raise TypeError("a robot cannot be copied or pickled: make another one, with the same arguments")

    def _hold(self, name: str) -> _Held:
        held = _Held(_topics.find(name))
        self._held[name] = held
        return held

    def _forget(self) -> None:
        for held in self._held.values():
            held.sequence, held.value = 0, None


def _seed(seed: int) -> int:
    try:
        number = operator.index(seed)
    except TypeError:
        raise TypeError(f"seed = {seed!r}: must be a whole number") from None
    if not 0 <= number < 2**64:
        raise ValueError(f"seed = {number}: must be 0..2^64 - 1")
    return number


def _path(argument: str, given: Any) -> str:
    try:
        path = os.fsdecode(given)
        path.encode()
        return path
    except (TypeError, UnicodeEncodeError):
        raise TypeError(f"{argument} = {given!r}: must be a path or a name, in UTF-8") from None


def _number(argument: str, given: Any) -> float:
    try:
        if isinstance(given, (str, bytes, bytearray, complex, np.complexfloating)):
            raise TypeError
        return float(given)
    except (TypeError, ValueError, OverflowError):
        raise TypeError(f"{argument} = {given!r}: must be a number") from None


def _json(argument: str, given: Any) -> str:
    """Also of NumPy's numbers and arrays."""
    try:
        return json.dumps(given, allow_nan=False, default=_plain)
    except ValueError as error:
        why = "numbers must be finite" if "Out of range" in str(error) else str(error)
        raise ValueError(f"{argument} = {given!r}: {why}") from None
    except TypeError as error:
        raise TypeError(f"{argument} = {given!r}: {error}. Take texts, numbers, flags, lists and mappings") from None


def _plain(given: Any) -> Any:
    if isinstance(given, (np.generic, np.ndarray)):
        return given.tolist()
    raise TypeError(f"{given!r} is a {type(given).__name__}")


def _several(argument: str, names: Iterable[Any]) -> Iterable[Any]:
    """What is one name, and not several, would be taken for as many as it has letters."""
    if isinstance(names, (str, bytes, os.PathLike)) or not isinstance(names, Iterable):
        raise TypeError(f"{argument} = {names!r}: must be a list, such as [{names!r}]")
    return names


def _parameters(given: Mapping[str, Mapping[str, Any]]) -> list[tuple[str, str, str]]:
    """(plug-in, parameter, text)."""
    form = 'must be {plug-in: {parameter: value}}, such as {"trajectory": {"lift": "0.04 m"}}'
    if not isinstance(given, Mapping):
        raise TypeError(f"parameters = {given!r}: {form}")
    chosen = []
    for plugin, values in given.items():
        if not isinstance(plugin, str) or not isinstance(values, Mapping):
            raise TypeError(f"parameters: {plugin!r}: {values!r}: {form}")
        for name, value in values.items():
            if not isinstance(name, str):
                raise TypeError(f"parameters: {plugin}: a parameter goes by its name, a str; not by {name!r}")
            chosen.append((plugin, name, _text(value)))
    return chosen


def _text(value: Any) -> str:
    """Of a parameter, as a configuration has it."""
    return str(value).lower() if isinstance(value, bool) else str(value)
