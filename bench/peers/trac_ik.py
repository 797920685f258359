"""TRAC-IK by its wheel `pytracik`, on the poses that leg_ik_peers has written down."""

from __future__ import annotations

import statistics
import time
from typing import Any

import numpy as np
import pytracik

TIMEOUT_S = 0.005  # its own default
TURNS = 2

Matrix = np.ndarray[Any, np.dtype[np.float64]]


def _matrix(numbers: list[float]) -> Matrix:
    return np.array(numbers).reshape(4, 4).T  # column by column


def _rpy(rotation: Matrix) -> tuple[float, float, float]:
    return (float(np.arctan2(rotation[2, 1], rotation[2, 2])), float(np.arcsin(np.clip(-rotation[2, 0], -1, 1))),
            float(np.arctan2(rotation[1, 0], rotation[0, 0])))


def _quaternion(rotation: Matrix) -> tuple[float, float, float, float]:
    """x, y, z, w: the eigenvector of K. J. Bar-Itzhack's matrix, exact also for half turns."""
    m = rotation
    k = np.array([[m[0, 0] - m[1, 1] - m[2, 2], m[1, 0] + m[0, 1], m[2, 0] + m[0, 2], m[2, 1] - m[1, 2]],
                  [m[1, 0] + m[0, 1], m[1, 1] - m[0, 0] - m[2, 2], m[2, 1] + m[1, 2], m[0, 2] - m[2, 0]],
                  [m[2, 0] + m[0, 2], m[2, 1] + m[1, 2], m[2, 2] - m[0, 0] - m[1, 1], m[1, 0] - m[0, 1]],
                  [m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1], m[0, 0] + m[1, 1] + m[2, 2]]]) / 3.0
    x, y, z, w = np.linalg.eigh(k)[1][:, 3]
    return float(x), float(y), float(z), float(w)


def urdf_of(task: dict[str, Any]) -> str:
    """The leg alone, from its base to the sole."""
    parts = ['<robot name="leg"><link name="base"/>']
    parent = "base"
    for number, joint in enumerate(task["joints"]):
        origin, child = _matrix(joint["origin"]), f"link{number}"
        lower, upper = joint["limits_rad"]
        parts.append(
            f'<link name="{child}"/><joint name="{joint["name"]}" type="revolute"><parent link="{parent}"/><child link="{child}"/>'
            f'<origin xyz="{_numbers(origin[:3, 3])}" rpy="{_numbers(_rpy(origin))}"/><axis xyz="{_numbers(joint["axis"])}"/>'
            f'<limit lower="{lower!r}" upper="{upper!r}" velocity="10" effort="10"/></joint>')
        parent = child
    sole = _matrix(task["sole"])
    parts.append(f'<link name="sole"/><joint name="to_sole" type="fixed"><parent link="{parent}"/><child link="sole"/>'
                 f'<origin xyz="{_numbers(sole[:3, 3])}" rpy="{_numbers(_rpy(sole))}"/></joint></robot>')
    return "".join(parts)


def _numbers(values: Any) -> str:
    return " ".join(repr(float(value)) for value in values)


class TracIkTask:
    """The poses of one task, solved by TRAC-IK."""

    def __init__(self, task: dict[str, Any]) -> None:
        self._task = task
        self._solve = pytracik.ik
        self._solver = pytracik.TRAC_IK("base", "sole", urdf_of(task), TIMEOUT_S, task["tolerance"], pytracik.SolveType.Speed)
        self._goals = [_matrix(goal) for goal in task["goals"]]
        self._asked = [(*(float(x) for x in goal[:3, 3]), *_quaternion(goal[:3, :3])) for goal in self._goals]
        self._home = np.array([joint["home_rad"] for joint in task["joints"]])

    def play(self) -> dict[str, float]:
        taken, answers = [], []
        for _ in range(TURNS):
            began = time.perf_counter_ns()
            answers = self._solve_all()
            taken.append((time.perf_counter_ns() - began) / len(answers))
        solved = sum(self._is_solution(goal, answer) for goal, answer in zip(self._goals, answers, strict=True))
        return {"ns": statistics.median(taken), "solved": solved / len(answers)}

    def _solve_all(self) -> list[Any]:
        start, from_last, answers = self._home, self._task["from_last"], []
        for asked in self._asked:
            answer = self._solve(self._solver, start, *asked)
            answers.append(answer)
            if from_last and answer[0] >= 0:
                start = answer[1:]
        return answers

    def _is_solution(self, goal: Matrix, answer: Any) -> bool:
        if answer[0] < 0:
            return False
        pose = np.eye(4)
        for joint, angle in zip(self._task["joints"], answer[1:], strict=True):
            lower, upper = joint["limits_rad"]
            if not lower - self._task["limit_tolerance_rad"] <= angle <= upper + self._task["limit_tolerance_rad"]:
                return False
            pose = pose @ _matrix(joint["origin"]) @ _turn(np.array(joint["axis"]), float(angle))
        left = np.linalg.inv(goal) @ pose @ _matrix(self._task["sole"])
        turn = np.linalg.norm(left[:3, :3] - np.eye(3)) / np.sqrt(2.0)  # of a small one
        return bool(np.linalg.norm(left[:3, 3]) < self._task["proven"] and turn < self._task["proven"])


def _turn(axis: Matrix, angle_rad: float) -> Matrix:
    """Rodrigues' formula."""
    x, y, z = axis
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    turn = np.eye(4)
    turn[:3, :3] += np.sin(angle_rad) * cross + (1.0 - np.cos(angle_rad)) * cross @ cross
    return turn
