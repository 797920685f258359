"""NumPy's types of the topics are the C++'s: names, sizes, offsets and shapes, as the generated C header has them."""

import ctypes
import os
import pathlib
import re
import subprocess

import numpy as np
import pytest

import gaitway


def test_offsets_are_the_compilers(tmp_path):
    """A program that the C compiler makes of the header says where each field lies."""
    include = pathlib.Path(os.environ["GAITWAY_TOPICS_INCLUDE"])
    lines = ["#include <stddef.h>", "#include <stdio.h>", '#include "gaitway/msgclient/topics.h"', "int main(void) {"]
    expected = []
    for topic in gaitway.topics().values():
        struct = "gaitway_" + re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", topic.type_name).lower()
        lines.append(f'printf("%zu\\n", sizeof({struct}));')
        expected.append(topic.dtype.itemsize)
        for field in topic.fields.values():
            lines.append(f'printf("%zu\\n", offsetof({struct}, {field.name}));')
            lines.append(f'printf("%zu\\n", sizeof((({struct}*)0)->{field.name}));')
            expected += [field.offset, topic.dtype[field.name].itemsize]
            assert topic.dtype.fields[field.name][1] == field.offset
    source = tmp_path / "offsets.c"
    source.write_text("\n".join([*lines, "return 0; }"]))
    subprocess.run(["cc", "-I", include, source, "-o", tmp_path / "offsets"], check=True)
    told = subprocess.run([tmp_path / "offsets"], check=True, capture_output=True, text=True).stdout.split()
    assert list(map(int, told)) == expected


def test_topics_tell_what_they_are():
    estimate = gaitway.topics()["estimate"]
    assert estimate.writer == "zmp"
    assert estimate.period_s == pytest.approx(0.01)
    assert estimate.field("com").unit == "m"
    assert estimate.field("com").frame == "support"
    assert "estimated" in str(estimate)
    assert estimate.dtype["foot_zmp"].shape == (2, 2)
    assert ctypes.sizeof(ctypes.c_double) == estimate.dtype["zmp"].base.itemsize


def test_names_that_there_are_not():
    robot = gaitway.Robot()
    for call in (robot.topic, robot.view, robot.age_s, robot.writer_of):
        with pytest.raises(KeyError, match="Did you mean 'estimate'"):
            call("estimat")
    with pytest.raises(gaitway.UnknownTopic, match="Did you mean 'velocity'"):
        robot.write("walk_request", {"velocty": [0, 0]})
    with pytest.raises(TypeError):
        robot.topic(3)
    robot.close()


def test_values_are_read_whole_while_the_robot_runs():
    with gaitway.Robot(seed=2) as robot:
        for _ in range(20):
            robot.run(0.01)
            if robot.time_s > 0.05:
                joints = robot.topic("joint_states")
                assert joints["joint_count"] == len(robot.joints)
                assert np.all(joints["position"][len(robot.joints):] == 0.0)
                assert robot.age_s("joint_states") < 0.02
