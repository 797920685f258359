"""The figures of a walk from samples of where the robot is, under the names and by the rules of a run's summary."""

from __future__ import annotations

import math
from typing import Any

START_UP_MS = 2000  # from a walk command to steady walking
SAMPLE_S = 0.01


class WalkMetrics:
    """Samples come every 10 ms, what is asked of the robot when it is asked."""

    def __init__(self) -> None:
        self.fell_at_s: float | None = None
        self._start: tuple[float, float, float] | None = None  # x, y, yaw
        self._end = (0.0, 0.0, 0.0)
        self._velocity = (0.0, 0.0)
        self._turn_rate = 0.0
        self._walks_since_ms: int | None = None
        self._path_m = self._sideways_m = self._walked_s = 0.0
        self._commanded_m = self._done_m = self._commanded_yaw_rad = 0.0
        self._tilt_max_rad = self._tilt_squares = 0.0
        self._samples = 0

    def on_event(self, event: dict[str, Any], now_ms: int) -> None:
        if "walk" in event:
            forward, left, turn = (float(part) for part in [*event["walk"], 0.0, 0.0][:3])
            self._velocity, self._turn_rate = (forward, left), turn
            if self._walks_since_ms is None:
                self._walks_since_ms = now_ms
        elif "stand" in event or "stop" in event:
            self._velocity, self._turn_rate, self._walks_since_ms = (0.0, 0.0), 0.0, None

    def add(self, now_ms: int, base_m: tuple[float, float, float], yaw_rad: float, tilt_rad: float, *, fallen: bool) -> None:
        if fallen and self.fell_at_s is None:
            self.fell_at_s = now_ms * 1e-3
        if self._start is None:
            self._start = self._end = (base_m[0], base_m[1], yaw_rad)
        self._measure_progress(now_ms, base_m, yaw_rad)
        if self.fell_at_s is None:
            self._tilt_max_rad = max(self._tilt_max_rad, tilt_rad)
            self._tilt_squares += tilt_rad * tilt_rad
            self._samples += 1

    def _measure_progress(self, now_ms: int, base_m: tuple[float, float, float], yaw_rad: float) -> None:
        x, y, yaw = self._end
        forward, left = _turned(base_m[0] - x, base_m[1] - y, -yaw)
        if self._walks_since_ms is not None and now_ms - self._walks_since_ms > START_UP_MS:
            self._path_m += forward
            self._sideways_m += left
            self._walked_s += SAMPLE_S
        speed = math.hypot(*self._velocity)
        if speed > 0.0:
            self._commanded_m += speed * SAMPLE_S
            self._done_m += (forward * self._velocity[0] + left * self._velocity[1]) / speed
        self._commanded_yaw_rad += self._turn_rate * SAMPLE_S
        self._end = (base_m[0], base_m[1], yaw + math.remainder(yaw_rad - yaw, 2.0 * math.pi))

    def measures(self) -> dict[str, Any]:
        x, y, yaw = self._start or (0.0, 0.0, 0.0)
        _, drift = _turned(self._end[0] - x, self._end[1] - y, -yaw)
        return {
            "survived": self.fell_at_s is None,
            "fell_at_s": self.fell_at_s,
            "distance_m": math.hypot(self._end[0] - x, self._end[1] - y),
            "mean_speed_m_s": self._mean(self._path_m),
            "mean_side_speed_m_s": self._mean(self._sideways_m),
            "lateral_drift_m": drift,
            "heading_drift_rad": self._end[2] - yaw - self._commanded_yaw_rad,
            "commanded_m": self._commanded_m,
            "commanded_and_done_m": self._done_m,
            "tilt_max_rad": self._tilt_max_rad,
            "tilt_rms_rad": math.sqrt(self._tilt_squares / self._samples) if self._samples else 0.0,
        }

    def _mean(self, path_m: float) -> float | None:
        """None: it never walked steadily."""
        return path_m / self._walked_s if self._walked_s > 0.0 else None


def _turned(x: float, y: float, by_rad: float) -> tuple[float, float]:
    cosine, sine = math.cos(by_rad), math.sin(by_rad)
    return cosine * x - sine * y, sine * x + cosine * y
