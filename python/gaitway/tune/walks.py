"""The trials by which a gait is tuned and judged: walks and pushes of robots with deviations, scaled to the body."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Any

from gaitway.sweep.canonical import Json
from gaitway.sweep.trial import Trial, key_of, kind_of

GRAVITY_M_PER_S2 = 9.81
# Of each robot, as in the table of the gait: play in the joints and a biased gyro besides the deviations of mismatch 1.
CONDITIONS = {"backlash_deg": 0.2, "gyro_bias_deg_per_s": 0.2}


@dataclass(frozen=True)
class Body:
    """What speeds and pushes are scaled by."""

    hip_height_m: float
    mass_kg: float

    @property
    def speed_m_per_s(self) -> float:
        return math.sqrt(GRAVITY_M_PER_S2 * self.hip_height_m)


def scenes(body: Body, seconds: float) -> dict[str, list[Json]]:
    """Straight ahead, sideways in a turn, and pushed twice while it walks; humanoid22: 0.3 m/s, 0.07 m/s, 0.9 N·s."""
    v, push = body.speed_m_per_s, 0.07 * body.mass_kg * body.speed_m_per_s
    ahead = {"at_s": 0.5, "walk": [round(0.16 * v, 4), 0.0, 0.0]}
    turning = {"at_s": 0.5, "walk": [round(0.053 * v, 4), round(0.037 * v, 4), round(0.25 * v / body.hip_height_m * 0.1, 4)]}
    slow = {"at_s": 0.5, "walk": [round(0.08 * v, 4), 0.0, 0.0]}
    pushes = [
        {"at_s": round(share * seconds, 2), "push": {"direction": direction, "impulse_Ns": round(push, 4), "duration_s": 0.1}}
        for share, direction in ((0.5, [0, 1, 0]), (0.75, [-1, 0, 0]))
    ]
    return {"straight": [ahead], "turning": [turning], "pushed": [slow, *pushes]}


@dataclass(frozen=True)
class Subject:
    """One robot, and how it is tried."""

    robot: str
    config: str
    body: Body
    seconds: float

    def trials(self, parameters: Json, seeds: Iterable[int]) -> Iterator[Trial]:
        """For each seed each scene."""
        from gaitway.sweep.robot_trial import describe

        code = kind_of("robot").code()
        number = 0
        for seed in seeds:
            for name, events in scenes(self.body, self.seconds).items():
                description = describe(
                    robot=self.robot, config=self.config, world=None, world_seed=None, conditions=CONDITIONS, mismatch=1.0,
                    seed=seed, seconds=self.seconds, parameters=parameters, events=events,
                )
                yield Trial(number, description, {"seed": seed, "scene": name}, key_of("robot", code, description))
                number += 1

    @staticmethod
    def told(trial: Trial) -> Json:
        """The walk that a trial's robot was told."""
        walk: list[Any] = next(event["walk"] for event in trial.description["events"] if "walk" in event)
        return {"told_m_s": walk[0], "told_side_m_s": walk[1]}
