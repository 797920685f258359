"""A robot in Python is the robot of `gaitway run`: the same states to the bit, every topic, and the way back to a snapshot."""

import gc
import json
import subprocess
import threading

import numpy as np
import pytest

import gaitway

SECONDS = 4.0
SEED = 3


@pytest.fixture(scope="module")
def robot():
    with gaitway.Robot(seed=SEED) as made:
        yield made


def walk(robot, seconds=SECONDS):
    """As `gaitway run` does without options."""
    robot.restart(SEED)
    robot.run(1.0)
    robot.walk(0.15)
    robot.run(seconds - 1.0)


def test_the_same_states_as_the_command(robot, command, tmp_path):
    subprocess.run([command, "run", "--seconds", str(SECONDS), "--seed", str(SEED), "--out", tmp_path, "--quiet", "--no-pictures"],
                   check=True)
    summary = json.loads((tmp_path / "summary.json").read_text())
    walk(robot)
    assert robot.digest == summary["digest"]
    assert robot.time_s == pytest.approx(SECONDS)
    walk(robot)
    assert robot.digest == summary["digest"]
    robot.restart(SEED + 1)
    robot.run(SECONDS)
    assert robot.digest != summary["digest"]


def test_the_same_states_with_pushes_and_a_configuration(robot, command, tmp_path):
    scenario = tmp_path / "push.yaml"
    scenario.write_text("seconds: 3\nevents:\n  - {at_s: 0.5, walk: [0.1, 0.02, 0.1]}\n"
                        "  - {at_s: 1.5, push: {direction: [0, 1, 0], impulse_Ns: 0.8, duration_s: 0.1}}\n")
    subprocess.run([command, "run", "--scenario", scenario, "--seed", "5", "--mismatch", "0.5", "--config", "fast", "--out", tmp_path,
                    "--quiet", "--no-pictures"], check=True)
    with gaitway.Robot(config="fast", seed=5, mismatch=0.5) as other:
        other.run(0.5)
        other.walk(0.1, 0.02, 0.1)
        other.run(1.0)
        other.apply("push: {direction: [0, 1, 0], impulse_Ns: 0.8, duration_s: 0.1}")
        other.run(1.5)
        assert other.digest == json.loads((tmp_path / "summary.json").read_text())["digest"]


def test_walks(robot):
    walk(robot, 6.0)
    truth = robot.truth()
    assert truth.base_m[0] > 0.4
    assert not robot.fallen
    assert robot.batches().handed_over > 60
    assert [fault.faults for fault in robot.faults()] == [0, 0, 0, 0]
    assert {"zmp", "trajectory", "stability", "kinematics"} == {fault.plugin for fault in robot.faults()}
    estimate = robot.topic("estimate")
    assert estimate["com"][2] == pytest.approx(truth.com_m[2], abs=0.03)


def test_a_push_fells_and_is_told(robot):
    robot.restart(SEED)
    robot.run(1.0)
    robot.push("trunk" if "trunk" in robot.links else robot.links[0], (0.0, 12.0, 0.0))
    robot.run(2.0)
    assert robot.fallen
    assert robot.topic("estimate")["fall"] != 0
    assert any(event.kind in ("warning", "info", "fault") for event in robot.events())


def test_snapshots_are_exact(robot):
    walk(robot, 2.0)
    robot.write("walk_request", {"walk": 1, "velocity": [0.1, 0.0], "turn_rate": 0.2})
    robot.push(robot.links[0], (0.3, 0.2, 0.0))
    robot.run(0.5)
    snapshot = robot.snapshot()
    digest, positions = robot.digest, robot.positions
    estimate = robot.topic("estimate").copy()
    robot.run(1.0)
    later = robot.digest
    robot.restore(snapshot)
    assert robot.digest == digest
    assert np.array_equal(robot.positions, positions)
    assert robot.topic("estimate") == estimate
    robot.run(1.0)
    assert robot.digest == later
    with gaitway.Robot(seed=SEED) as other, pytest.raises(ValueError, match="made otherwise"):
        other.restore(snapshot)


def test_values_never_change_and_views_follow(robot):
    robot.restart(SEED)
    robot.run(0.5)
    value, view = robot.topic("imu"), robot.view("imu")
    assert value == view
    assert robot.topic("imu") is value
    kept = value.copy()
    robot.run(0.5)
    assert value == kept
    assert view != kept
    assert view == robot.topic("imu")
    for array in (value, view):
        with pytest.raises(ValueError):
            array["stamp_ns"] = 1


def test_views_outlive_the_robot():
    robot = gaitway.Robot(seed=SEED)
    robot.run(0.5)
    view, field = robot.view("joint_states"), robot.view("joint_states")["position"]
    kept = view.copy()
    del robot
    gc.collect()
    np.zeros(10_000_000)  # something else may take the memory
    assert view == kept
    assert np.array_equal(field, kept["position"])


def test_restart_empties_views(robot):
    robot.restart(SEED)
    robot.run(0.2)
    view = robot.view("estimate")
    assert view["stamp_ns"] > 0
    robot.restart(SEED)
    assert view["stamp_ns"] == 0
    with pytest.raises(gaitway.NothingPublished, match="estimate"):
        robot.topic("estimate")


def test_several_threads_at_once_are_several_robots():
    digests = {}

    def one(seed):
        with gaitway.Robot(seed=seed) as robot:
            robot.run(1.0)
            robot.walk(0.15)
            robot.run(0.5)
            digests.setdefault(seed, set()).add(robot.digest)

    threads = [threading.Thread(target=one, args=(seed,)) for seed in (1, 2, 3, 4, 1, 2, 3, 4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all(len(of_seed) == 1 for of_seed in digests.values())
    assert len(set.union(*digests.values())) == 4


def test_topics_of_others_can_be_written_where_they_are_given_up():
    with gaitway.Robot(seed=SEED, writes=["correction", "trim"]) as robot:
        assert robot.plugins_taken_out == ["stability"]
        assert robot.writer_of("correction") == "python"
        robot.write("correction", {"com_offset": [0.01, 0.0]})
        robot.run(0.5)
        assert robot.topic("correction")["com_offset"][0] == 0.01


def test_walks_to_a_place_and_plays_a_motion():
    """Plug-ins find what they need beside the package, also when an interpreter loads them."""
    with gaitway.Robot(seed=SEED, navigation=True) as robot:
        robot.run(1.0)
        robot.apply({"walk_to": {"x_m": 0.3, "y_m": 0.0, "yaw_deg": 0}})
        robot.run(9.0)
        assert robot.truth().base_m[0] == pytest.approx(0.3, abs=0.05)
        robot.apply({"motion": "wave"})
        robot.run(1.0)
        assert robot.topic("motion_state")["refused"] == 0
        assert robot.topic("motion_state")["state"] != 0


def test_conditions_parameters_and_worlds():
    digests = set()
    for arguments in ({}, {"conditions": {"slope_deg": [3, 0]}}, {"parameters": {"trajectory": {"lift": "0.04 m"}}}, {"mismatch": 0.0}):
        with gaitway.Robot(seed=SEED, **arguments) as robot:
            robot.run(0.5)
            robot.walk(0.1)
            robot.run(1.0)
            digests.add(robot.digest)
            with pytest.raises(ValueError, match="world"):
                robot.apply({"remove": {"name": "crate"}})
    assert len(digests) == 4
    with gaitway.Robot(seed=SEED, world="boxes") as robot:
        robot.apply({"spawn": {"name": "crate", "shape": "box", "size_m": [0.2, 0.2, 0.1], "position_m": [1, 0, 0.05]}})
        robot.apply({"remove": {"name": "crate"}})
        robot.run(0.1)
