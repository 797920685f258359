"""Many environments at once, run by native threads while the interpreter is free: equal to single ones, to the bit."""

from __future__ import annotations

import contextlib
import os
import threading
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from gaitway._env import CYCLE_MS, Env, Vector  # first: it says what to do without Gymnasium
from gymnasium.vector import AutoresetMode, VectorEnv
from gymnasium.vector.utils import batch_space

from gaitway import _native

Vectors = np.ndarray[Any, np.dtype[Any]]  # also of flags


class VecEnv(VectorEnv[Vectors, Vectors, Vectors]):
    """Environments that step together. One that has ended begins anew in the next step, as with SyncVectorEnv."""

    metadata: dict[str, Any] = {"render_modes": [], "autoreset_mode": AutoresetMode.NEXT_STEP}

    def __init__(self, envs: Sequence[Env], threads: int | None = None) -> None:
        if not envs:
            raise ValueError("a vector of no environments")
        self.envs = list(envs)
        self.num_envs = len(self.envs)
        self._pool = _native.Pool(min(self.num_envs, len(os.sched_getaffinity(0)) if threads is None else threads))
        self.single_action_space = self.envs[0].action_space
        self.single_observation_space = self.envs[0].observation_space
        self.action_space = batch_space(self.single_action_space, self.num_envs)
        self.observation_space = batch_space(self.single_observation_space, self.num_envs)
        self._ended = np.zeros(self.num_envs, dtype=np.bool_)
        self._in_use = threading.Lock()

    @property
    def threads(self) -> int:
        return self._pool.threads

    def reset(self, *, seed: int | Sequence[int | None] | None = None,
              options: dict[str, Any] | None = None) -> tuple[Vectors, dict[str, Any]]:
        seeds: Sequence[int | None]
        if seed is None:
            seeds = [None] * self.num_envs
        elif isinstance(seed, (int, np.integer)):
            seeds = [int(seed) + i for i in range(self.num_envs)]
        else:
            seeds = seed
        if len(seeds) != self.num_envs:
            raise ValueError(f"{len(seeds)} seeds for {self.num_envs} environments")
        infos: dict[str, Any] = {}
        observations = []
        with self._alone():
            for i, (observation, info) in enumerate(self._begin_anew(self.envs, seeds)):
                observations.append(observation)
                infos = self._add_info(infos, info, i)
            self._ended[:] = False
        return np.stack(observations), infos

    def step(self, actions: Vectors) -> tuple[Vectors, Vectors, Vectors, Vectors, dict[str, Any]]:
        actions = np.asarray(actions)
        if actions.shape[:1] != (self.num_envs,):
            raise ValueError(f"actions: shape {actions.shape}; must be {self.action_space.shape}")
        with self._alone():
            return self._step(actions)

    @contextlib.contextmanager
    def _alone(self) -> Iterator[None]:
        if not self._in_use.acquire(blocking=False):
            raise _native.BusyError("this vector is stepped or reset by another thread, or by its own reward")
        try:
            yield
        finally:
            self._in_use.release()

    def _step(self, actions: Vectors) -> tuple[Vectors, Vectors, Vectors, Vectors, dict[str, Any]]:
        going = [i for i in range(self.num_envs) if not self._ended[i]]
        checked = [self.envs[i].checked(actions[i]) for i in going]
        for i, action in zip(going, checked, strict=True):
            self.envs[i].begin_step(action)
        self._pool.advance([self.envs[i].robot._run for i in going], CYCLE_MS)
        cycles = [self.envs[i].end_cycle() for i in going]
        anew = [i for i in range(self.num_envs) if self._ended[i]]
        results: list[tuple[Vector, float, dict[str, Any]]] = [(np.zeros(0), 0.0, {})] * self.num_envs
        begun = self._begin_anew([self.envs[i] for i in anew], [None] * len(anew))
        for i, (observation, info) in zip(anew, begun, strict=True):
            results[i] = (observation, 0.0, info)
        terminations, truncations = np.zeros(self.num_envs, np.bool_), np.zeros(self.num_envs, np.bool_)
        terminations[going] = [terminated for _, terminated, _ in cycles]
        truncations[going] = [truncated for _, _, truncated in cycles]
        self._ended = terminations | truncations
        for i, (transition, _, _) in zip(going, cycles, strict=True):  # last: a reward may raise, and all are as far as each other
            results[i] = self.envs[i].told(transition)
        return self._joined(results, terminations, truncations)

    def _begin_anew(self, envs: Sequence[Env], seeds: Sequence[int | None]) -> list[tuple[Vector, dict[str, Any]]]:
        if not envs:
            return []
        chosen = [env.begin_reset(seed) for env, seed in zip(envs, seeds, strict=True)]
        runs = [env.robot._run for env in envs]
        for env in envs:
            env.robot._forget()
        self._pool.restart(runs, chosen)
        self._pool.advance(runs, envs[0].start_cycles * CYCLE_MS)
        return [env.finish_reset() for env in envs]

    def _joined(self, results: list[tuple[Vector, float, dict[str, Any]]], terminations: Vectors, truncations: Vectors
                ) -> tuple[Vectors, Vectors, Vectors, Vectors, dict[str, Any]]:
        infos: dict[str, Any] = {}
        for i, result in enumerate(results):
            infos = self._add_info(infos, result[2], i)
        rewards = np.array([result[1] for result in results], dtype=np.float64)
        return np.stack([result[0] for result in results]), rewards, terminations, truncations, infos

    def close_extras(self, **kwargs: Any) -> None:
        for env in self.envs:
            env.close()


def make_vec(num_envs: int, *, threads: int | None = None, **env: Any) -> VecEnv:
    """`num_envs` environments made alike, on as many native threads as there are processors; `env`: what gaitway.Env takes."""
    if not isinstance(num_envs, (int, np.integer)):
        raise TypeError(f"num_envs = {num_envs!r}: must be a whole number")
    if num_envs < 1:
        raise ValueError(f"num_envs = {num_envs}: must be at least 1")
    return VecEnv([Env(**env) for _ in range(num_envs)], threads)
