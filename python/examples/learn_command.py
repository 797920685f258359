"""Learns what to command so that the robot gets as far as it can: Augmented Random Search (Mania, Guy, Recht 2018) in NumPy.

A linear policy sees where the robot is and where it looks, and commands how it walks. It begins with a slow walk. A score is the way that
was covered straight on; a fall costs a metre. It is learned on some robots and judged on others: each seed is a robot of its own.

    python learn_command.py                  # some minutes
    python learn_command.py --iterations 3   # to see it run
"""

from __future__ import annotations

import argparse

import numpy as np

import gaitway

START = np.array([0.15, 0.0, 0.0])        # m/s ahead, m/s to the left, rad/s
SCALE = np.array([0.1, 0.05, 0.2])        # by how much an output of 1 changes the command
SEEN_SCALE = np.array([0.1, 0.2])         # m to the left, rad of heading: what counts as 1
FALL = 1.0
UNSEEN = [1001, 1002, 1003, 1004]


class Task:
    """Many robots at once, each with a policy of its own."""

    def __init__(self, robots: int, cycles: int) -> None:
        self.cycles = cycles
        self.vec = gaitway.make_vec(robots, observation=["estimate.odometry_base"], reward=lambda step: -FALL if step.fallen else 0.0,
                                    episode_s=1e6)

    def scores(self, policies: np.ndarray, seeds: list[int]) -> np.ndarray:
        seen, _ = self.vec.reset(seed=seeds)
        begin, scores, up = seen.copy(), np.zeros(len(seeds)), np.ones(len(seeds), bool)
        for _ in range(self.cycles):
            seen, rewards, fell, _, _ = self.vec.step(self.commands(policies, seen - begin))
            scores += np.where(up, rewards, 0.0)
            up &= ~fell
        moved = seen - begin
        return scores + np.where(up, moved[:, 0] - np.abs(moved[:, 1]), 0.0)

    def commands(self, policies: np.ndarray, moved: np.ndarray) -> np.ndarray:
        features = np.concatenate([np.ones((len(moved), 1)), moved[:, 1:] / SEEN_SCALE], axis=1)
        box = self.vec.single_action_space
        return np.clip(START + SCALE * np.einsum("nij,nj->ni", policies, features), box.low, box.high)


def learn(iterations: int, directions: int, cycles: int) -> tuple[float, float]:
    """Mean score of robots that were not seen, at the beginning and at the end."""
    random = np.random.default_rng(0)
    task, judge = Task(2 * directions, cycles), Task(len(UNSEEN), cycles)
    policy, noise, rate = np.zeros((3, 3)), 0.4, 0.6

    def judged() -> float:
        return float(np.mean(judge.scores(np.repeat(policy[None], len(UNSEEN), axis=0), UNSEEN)))

    before = judged()
    for iteration in range(iterations):
        tried = noise * random.standard_normal((directions, *policy.shape))
        seeds = [int(seed) for seed in random.integers(1000, size=directions)]
        scores = task.scores(np.concatenate([policy + tried, policy - tried]), seeds + seeds)
        better = scores[:directions] - scores[directions:]
        policy = policy + rate / (directions * (np.std(scores) + 1e-9)) * np.einsum("d,dij->ij", better, tried / noise)
        print(f"iteration {iteration + 1}: {np.mean(scores):.3f}", flush=True)
    after = judged()
    print(f"robots that were not seen: {before:.3f} m at the beginning, {after:.3f} m with what was learned")
    print(np.round(policy, 2))
    task.vec.close()
    judge.vec.close()
    return before, after


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--iterations", type=int, default=30)
    parser.add_argument("--directions", type=int, default=8)
    parser.add_argument("--cycles", type=int, default=60)
    options = parser.parse_args()
    learn(options.iterations, options.directions, options.cycles)
