"""The Gymnasium environment: the rules that Gymnasium checks, determinism, and many at once equal to one at a time, to the bit."""

import warnings

import gymnasium
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env
from gymnasium.vector import SyncVectorEnv

import gaitway

OBSERVATION = ("estimate", "joint_states.position", "imu.inclination", "motion_plan.sequence")


def make(**arguments):
    return gaitway.Env(observation=OBSERVATION, **arguments)


@pytest.mark.parametrize("action", ["walk", "joint_plan", "step"])
def test_check_env(action):
    env = make(action=action)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        warnings.filterwarnings("ignore", message=".*(infinity|Box low bound|Box high bound|normalized|symmetric).*")
        check_env(env, skip_render_check=True)
    env.close()


def actions(env, count, seed=7):
    env.action_space.seed(seed)
    return [0.3 * env.action_space.sample() for _ in range(count)]


def rollout(env, seed, chosen):
    observation, info = env.reset(seed=seed)
    told = [observation]
    rewards = []
    for action in chosen:
        observation, reward, terminated, truncated, _ = env.step(action)
        told.append(observation)
        rewards.append((reward, terminated, truncated))
        if terminated or truncated:
            break
    return np.array(told), rewards, info


def test_one_seed_is_one_episode():
    env = make()
    chosen = actions(env, 30)
    first, rewards, _ = rollout(env, 11, chosen)
    again, rewards_again, _ = rollout(env, 11, chosen)
    fresh, rewards_fresh, _ = rollout(make(), 11, chosen)
    assert np.array_equal(first, again) and rewards == rewards_again
    assert np.array_equal(first, fresh) and rewards == rewards_fresh
    other, _, _ = rollout(env, 12, chosen)
    assert not np.array_equal(first, other)
    env.reset(seed=11)
    after, _ = env.reset()
    env.reset(seed=11)
    assert np.array_equal(after, env.reset()[0])
    env.close()


def test_it_is_the_robot_of_the_same_seed():
    """Nothing is by-passed: the same orders to a bare robot give the same states."""
    env = make()
    chosen = actions(env, 20)
    env.reset(seed=5)
    with gaitway.Robot(seed=5) as robot:
        robot.run(0.96)
        for action in chosen:
            env.step(action)
            robot.write("walk_request", {"walk": 1, "velocity": action[:2], "turn_rate": action[2]})
            robot.run(0.08)
        assert robot.digest == env.robot.digest
        assert robot.topic("command_state")["commander"] == env.robot.topic("command_state")["commander"] != 0
    env.close()


def test_reward_end_and_labels():
    seen = []

    def reward(step):
        seen.append(step)
        return 2.0

    env = gaitway.Env(observation=["estimate.com", "joint_states.position", "estimate"], reward=reward, episode_s=0.24)
    observation, _ = env.reset(seed=1)
    labels = env.observation_labels
    assert len(labels) == len(observation) == env.observation_space.shape[0]
    assert labels[:3] == ["estimate.com[0]", "estimate.com[1]", "estimate.com[2]"]
    assert sum(label.startswith("joint_states.position") for label in labels) == len(env.robot.joints)
    assert not any("stamp" in label for label in labels)
    ends = [env.step(np.zeros(3))[1:4] for _ in range(3)]
    assert ends == [(2.0, False, False), (2.0, False, False), (2.0, False, True)]
    assert len(seen) == 3 and seen[0].duration_s == 0.08
    estimate = env.robot.topic("estimate")
    observation = env.step(np.zeros(3))[0]
    assert np.array_equal(observation[:3], env.robot.topic("estimate")["com"])
    assert estimate["com"].shape == (3,)
    env.close()


def test_a_fall_terminates():
    env = make()
    env.reset(seed=1)
    env.robot.push(env.robot.links[0], (0.0, 15.0, 0.0))
    for _ in range(40):
        _, reward, terminated, truncated, _ = env.step(np.zeros(3))
        if terminated:
            break
    assert terminated and not truncated and reward == 0.0
    with pytest.raises(gymnasium.error.ResetNeeded):
        env.step(np.zeros(3))
    env.reset(seed=1)
    assert not env.step(np.zeros(3))[2]
    env.close()


def test_following_is_rewarded():
    env = make()
    walks, stands = [], []
    for told, speed in ((walks, 0.15), (stands, 0.0)):
        env.reset(seed=2)
        for i in range(50):
            reward = env.step(np.array([0.15, 0.0, 0.0]))[1] if speed else env.step(np.array([0.0, 0.0, 0.0]))[1]
            if i > 30:
                told.append(reward)
    assert 0.2 < np.mean(walks) <= 1.0
    assert 0.2 < np.mean(stands) <= 1.0
    env.close()


@pytest.mark.parametrize(("action", "error"), [
    (np.array([np.nan, 0, 0]), ValueError), (np.array([np.inf, 0, 0]), ValueError), (np.array([9.0, 0, 0]), ValueError),
    (np.zeros(2), ValueError), (np.zeros((3, 1)), ValueError), (np.array(["a", "b", "c"]), TypeError), (np.zeros(3, complex), TypeError)])
def test_bad_actions(shared_env, action, error):
    with pytest.raises(error):
        shared_env.step(action)


@pytest.fixture(scope="module")
def shared_env():
    env = make()
    env.reset(seed=1)
    yield env
    env.close()


@pytest.mark.parametrize(("arguments", "error", "tells"), [
    ({"action": "wlak"}, KeyError, "walk"), ({"observation": ["estimat"]}, KeyError, "estimate"),
    ({"observation": ["estimate.comm"]}, KeyError, "com"), ({"observation": []}, ValueError, "list"),
    ({"observation": "estimate"}, ValueError, "list"), ({"reward": 3}, TypeError, "callable"), ({"episode_s": 0.0}, ValueError, "episode_s"),
    ({"episode_s": float("nan")}, ValueError, "episode_s"), ({"seed": 1}, TypeError, "reset"),
    ({"action": 3}, TypeError, "action = 3: must be walk, .*it has no 'writes'"), ({"render_mode": "human"}, TypeError, "draws no pictures"), ({"robot": "humanoid2"}, ValueError, "humanoid22")])
def test_environments_that_cannot_be(arguments, error, tells):
    with pytest.raises(error, match=tells):
        gaitway.Env(**arguments)


def test_use_without_reset_and_after_close():
    env = make()
    with pytest.raises(gymnasium.error.ResetNeeded):
        env.step(np.zeros(3))
    env.close()
    env.close()
    with pytest.raises(gaitway.ClosedError):
        env.reset()


def vector_rollout(vec, seed, steps):
    told = [vec.reset(seed=seed)[0].copy()]
    results = []
    random = np.random.default_rng(3)
    for i in range(steps):
        chosen = random.uniform(-0.1, 0.1, (vec.num_envs, 3))
        observation, reward, terminated, truncated, info = vec.step(chosen)
        told.append(observation.copy())
        results.append((reward.copy(), terminated.copy(), truncated.copy(), info["time_s"].copy()))
    vec.close()
    return np.array(told), results


def test_native_threads_are_sync_are_single():
    """With ends of episodes and what begins after them."""
    arguments = {"observation": OBSERVATION, "episode_s": 0.4}
    native, of_native = vector_rollout(gaitway.make_vec(3, threads=2, **arguments), 21, 14)
    lone, of_lone = vector_rollout(gaitway.make_vec(3, threads=1, **arguments), 21, 14)
    sync, of_sync = vector_rollout(SyncVectorEnv([lambda: gaitway.Env(**arguments)] * 3), 21, 14)
    for told, results in ((lone, of_lone), (sync, of_sync)):
        assert np.array_equal(native, told)
        for mine, theirs in zip(of_native, results, strict=True):
            assert all(np.array_equal(a, b) for a, b in zip(mine, theirs, strict=True))
    assert any(result[2].any() for result in of_native)
    env = gaitway.Env(**arguments)
    random = np.random.default_rng(3)
    observation, _ = env.reset(seed=22)
    assert np.array_equal(observation, native[0, 1])
    for step in range(5):
        observation = env.step(random.uniform(-0.1, 0.1, (3, 3))[1])[0]
        assert np.array_equal(observation, native[step + 1, 1])
    env.close()


def test_a_reward_that_raises_leaves_all_as_far_as_each_other():
    """Also where the step ends episodes. The rewards of that step are lost, and nothing else."""
    raises = []

    def reward(step):
        if raises and step.robot is vec.envs[0].robot:
            raise raises.pop()
        return 1.0

    arguments = {"observation": OBSERVATION, "episode_s": 0.16}
    vec, sound = gaitway.make_vec(2, reward=reward, **arguments), gaitway.make_vec(2, reward=lambda _: 1.0, **arguments)
    assert np.array_equal(vec.reset(seed=3)[0], sound.reset(seed=3)[0])
    for step in range(5):
        expected = sound.step(np.zeros((2, 3)))
        if step in (1, 3):
            raises.append(ZeroDivisionError("no reward"))
            with pytest.raises(ZeroDivisionError):
                vec.step(np.zeros((2, 3)))
        else:
            told = vec.step(np.zeros((2, 3)))
            assert all(np.array_equal(a, b) for a, b in zip(told[:4], expected[:4], strict=True))
    vec.close()
    sound.close()


def test_a_bad_action_of_one_is_not_asked_of_the_others():
    vec = gaitway.make_vec(2, observation=OBSERVATION)
    vec.reset(seed=1)
    asked = vec.envs[0].robot.snapshot().entries
    with pytest.raises(ValueError):
        vec.step(np.array([[0.1, 0.0, 0.0], [np.nan, 0.0, 0.0]]))
    assert vec.envs[0].robot.snapshot().entries == asked
    vec.close()


@pytest.mark.parametrize(("reward", "error", "tells"), [
    ("x", TypeError, "the reward = 'x': must be a number"), (None, TypeError, "the reward = None"), (10**400, TypeError, "must be a number"),
    (float("nan"), ValueError, "the reward is nan: must be finite")])
def test_rewards_that_are_none(reward, error, tells):
    env = make(reward=lambda _: reward)
    env.reset(seed=1)
    with pytest.raises(error, match=tells):
        env.step(np.zeros(3))
    env.close()


def test_bad_vectors():
    with pytest.raises(TypeError, match="num_envs = 'a': must be a whole number"):
        gaitway.make_vec("a")
    with pytest.raises(ValueError):
        gaitway.make_vec(0)
    with pytest.raises(ValueError):
        gaitway.make_vec(1, threads=-1)
    vec = gaitway.make_vec(2, observation=OBSERVATION)
    vec.reset(seed=[1, 2])
    with pytest.raises(ValueError):
        vec.step(np.zeros((1, 3)))
    with pytest.raises(ValueError):
        vec.step(np.full((2, 3), np.nan))
    with pytest.raises(ValueError):
        vec.reset(seed=[1])
    vec.step(np.zeros((2, 3)))
    with pytest.raises(gaitway.BusyError):
        gaitway.VecEnv([vec.envs[0], vec.envs[0]]).reset(seed=1)
    vec.close()
