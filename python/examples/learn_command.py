"""Learns what to command so that the robot does what is wanted: Augmented Random Search (Mania, Guy, Recht 2018) in NumPy.

A robot that is told to walk 0.15 m/s covers a little less, or drifts; by how much differs from robot to robot. A linear policy sees
what the last second brought and adjusts the command. It is learned on some robots and judged on others.

    python learn_command.py                  # some minutes
    python learn_command.py --iterations 3   # to see it run
"""

from __future__ import annotations

import argparse
import math

import numpy as np

import gaitway

WANTED = np.array([0.15, 0.03, 0.2])  # m/s ahead, m/s to the left, rad/s
SCALE = np.array([0.05, 0.03, 0.2])   # by how much an adjustment of 1 changes the command
OBSERVATION = ["walk_command.velocity"]  # what the policy sees comes from the truth of the robot's way, below
WINDOW = 10                            # cycles


def speed(step: gaitway.Transition) -> np.ndarray:
    yaw = step.before.base_rpy_rad[2]
    dx, dy = (np.array(step.after.base_m) - np.array(step.before.base_m))[:2] / step.duration_s
    turn = math.remainder(step.after.base_rpy_rad[2] - yaw, 2 * math.pi) / step.duration_s
    return np.array([math.cos(yaw) * dx + math.sin(yaw) * dy, math.cos(yaw) * dy - math.sin(yaw) * dx, turn])


class Task:
    """Many robots at once, each with a policy of its own."""

    def __init__(self, robots: int, cycles: int) -> None:
        self.cycles = cycles
        self.speeds: dict[int, list[np.ndarray]] = {}
        self.vec = gaitway.make_vec(robots, observation=OBSERVATION, reward=self.note, episode_s=60.0)

    def note(self, step: gaitway.Transition) -> float:
        self.speeds[id(step.robot)].append(speed(step))
        return 0.0 if not step.fallen else -10.0

    def scores(self, policies: np.ndarray, seeds: list[int]) -> np.ndarray:
        """How far each robot was from what is wanted in its last cycles, as a negative number; falls cost 10."""
        self.vec.reset(seed=seeds)
        self.speeds = {id(env.robot): [] for env in self.vec.envs}
        scores = np.zeros(len(seeds))
        up = np.ones(len(seeds), bool)
        for cycle in range(self.cycles):
            commands = [self.command(policy, self.speeds[id(env.robot)]) for policy, env in zip(policies, self.vec.envs, strict=True)]
            _, rewards, ended, _, _ = self.vec.step(np.array(commands))
            scores += np.where(up, rewards, 0.0)
            up &= ~ended
        for i, env in enumerate(self.vec.envs):
            if up[i]:
                got = np.mean(self.speeds[id(env.robot)][self.cycles // 2 :], axis=0)
                scores[i] -= np.linalg.norm((got - WANTED) / SCALE)
        return scores

    def command(self, policy: np.ndarray, speeds: list[np.ndarray]) -> np.ndarray:
        seen = np.ones(4)
        seen[1:] = (np.mean(speeds[-WINDOW:], axis=0) - WANTED) / SCALE if len(speeds) >= WINDOW else 0.0
        box = self.vec.single_action_space
        return np.clip(WANTED + SCALE * np.clip(policy @ seen, -1.0, 1.0), box.low, box.high)


def learn(iterations: int, directions: int, cycles: int) -> tuple[float, float]:
    """Mean score of unseen robots, without and with what was learned."""
    random = np.random.default_rng(0)
    task, judge = Task(2 * directions, cycles), Task(4, cycles)
    policy, noise, rate = np.zeros((3, 4)), 0.2, 0.3
    unseen = [1001, 1002, 1003, 1004]
    before = float(np.mean(judge.scores(np.repeat(policy[None], 4, 0), unseen)))
    for iteration in range(iterations):
        tried = random.standard_normal((directions, *policy.shape))
        seeds = [int(random.integers(1000)) for _ in range(directions)]
        scores = task.scores(np.concatenate([policy + noise * tried, policy - noise * tried]), seeds + seeds)
        plus, minus = scores[:directions], scores[directions:]
        spread = float(np.std(scores)) or 1.0
        policy = policy + rate / (directions * spread) * np.einsum("d,dij->ij", plus - minus, tried)
        print(f"iteration {iteration + 1}: {np.mean(scores):.3f}", flush=True)
    after = float(np.mean(judge.scores(np.repeat(policy[None], 4, 0), unseen)))
    print(f"robots that it has not seen: {before:.3f} without, {after:.3f} with what was learned\n{np.round(policy, 2)}")
    task.vec.close()
    judge.vec.close()
    return before, after


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--iterations", type=int, default=30)
    parser.add_argument("--directions", type=int, default=8)
    parser.add_argument("--cycles", type=int, default=75)
    options = parser.parse_args()
    learn(options.iterations, options.directions, options.cycles)
