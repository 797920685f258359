"""`gaitway ctl` over the API does what it says, and what was asked is a scenario that gives the same run again, to the bit."""
import json
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import roslibpy

from served_robot import COMMAND, ServedRobot, until

SEED = "3"


class ServedCommands(unittest.TestCase):
    def run_ctl(self, *arguments):
        return subprocess.run([COMMAND, "ctl", "--port", str(self.robot.port), *arguments], capture_output=True,
                              text=True, timeout=120)

    def ctl(self, *arguments, code=0):
        result = self.run_ctl(*arguments)
        self.assertEqual(result.returncode, code, result.stdout + result.stderr)
        return result.stdout + result.stderr

    def test_ctl_and_replay(self):
        with tempfile.TemporaryDirectory(prefix="gaitway_commands_") as folder:
            with ServedRobot("--seed", SEED, speed=4.0) as self.robot:
                self.assertIn("/joint_states", self.ctl("topics"))
                self.assertIn("trajectory", self.ctl("plugin", "list"))
                joints = [json.loads(line) for line in self.ctl("echo", "/joint_states", "--count", "3").splitlines()]
                self.assertEqual([len(message["name"]) for message in joints], [22, 22, 22])
                self.assertIn("com_height", self.ctl("plugin", "parameters", "trajectory"))
                self.ctl("walk", "0.12,0,0.1", "--seconds", "2")
                self.ctl("play", "wave")
                self.assertIn("walk.mcap", self.ctl("recording", "start", "walk"))
                self.ctl("recording", "stop")
                self.assertRegex(self.ctl("recording", "list"), r"\A\d{4}-\d\d-\d\d .* MB  \S*/walk\.mcap\n\Z")
                self.assertIn("there is no motion 'jump'", self.ctl("play", "jump", code=2))
                self.assertIn("left_knie", self.ctl("move-joint", "left_knie", "0.3", code=2))
                self.assertIn("up", self.ctl("look", "up", code=2))
                self.assertIn("3 numbers, not 2", self.ctl("look", "point", "1,2", code=1))
                self.ctl("look", "direction", "0.4,0.1", "--speed", "2")
                self.ctl("take")
                self.ctl("let-go")
                self.assertIn("add 'behaviour'", self.ctl("behaviour", "start", "patrol", code=2))
                self.ctl("walk", "9", code=1)
                self.ctl("stop")
                self.assertIn("gaitway ctl plugin stop stability", self.ctl("stop", "stability", code=1))
                self.ctl("emergency-stop")
                self.ctl("stand", "--no-such-option", code=1)
                self.robot.stop()
                commands = Path(folder) / "commands.yaml"
                commands.write_text((self.robot.out / "commands.yaml").read_text())
            text = commands.read_text()
            self.assertRegex(text, r"walk: \[0\.12, 0(\.0)?, 0\.1\]")
            self.assertIn('motion: "wave"', text)
            self.assertIn("look: direction", text)
            self.assertIn("command: let_go", text)
            self.assertIn("emergency_stop: hold", text)
            self.assert_replays(commands)

    def test_a_walk_that_ctrl_c_ends_replays(self):
        with tempfile.TemporaryDirectory(prefix="gaitway_commands_") as folder:
            with ServedRobot("--seed", SEED, speed=4.0) as self.robot:
                walk = subprocess.Popen([COMMAND, "ctl", "--port", str(self.robot.port), "walk", "0.15,0,0"],
                                        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
                try:
                    until(lambda: self.base_x() > 0.1, "the walk's beginning")
                    self.robot.stop()
                finally:
                    walk.kill()
                    walk.wait()
                commands = Path(folder) / "commands.yaml"
                commands.write_text((self.robot.out / "commands.yaml").read_text())
            self.assertIn(", stop: true}", commands.read_text())
            self.assert_replays(commands)

    def test_a_push_replays(self):
        with tempfile.TemporaryDirectory(prefix="gaitway_commands_") as folder:
            with ServedRobot("--seed", SEED, speed=4.0) as self.robot:
                ros = roslibpy.Ros("127.0.0.1", self.robot.port)
                ros.run(timeout=20)
                try:
                    self.ctl("walk", "0.1,0,0", "--seconds", "1")
                    for link, force in (("trunk", {"x": 0.1, "y": 15.7, "z": 0.0}), ("left_forearm", {"x": -5.3, "y": 0.0, "z": 1.0 / 3.0})):
                        self.assertEqual(self.push(ros, link=link, force=force, duration=0.1, frame="heading"),
                                         {"success": True, "message": "the push begins"})
                    refused = self.push(ros, link="left_forarm", force={"x": 1.0, "y": 0.0, "z": 0.0}, duration=0.1, frame="")
                    self.assertFalse(refused["success"])
                    self.assertIn("Did you mean 'left_forearm'?", refused["message"])
                finally:
                    ros.terminate()
                self.robot.stop()
                commands = Path(folder) / "commands.yaml"
                commands.write_text((self.robot.out / "commands.yaml").read_text())
            self.assertRegex(commands.read_text(), r'push: \{body: "trunk", .*\n(.*\n)*.*push: \{body: "left_forearm", ')
            self.assertEqual(commands.read_text().count("push:"), 2)
            self.assert_replays(commands)

    def push(self, ros, **arguments):
        service = roslibpy.Service(ros, "/simulation/push", "gaitway_msgs/PushLink")
        return dict(service.call(roslibpy.ServiceRequest(arguments), timeout=20))

    def base_x(self):
        return json.loads(self.ctl("echo", "/odom", "--count", "1").splitlines()[-1])["pose"]["pose"]["position"]["x"]

    def assert_replays(self, commands):
        replay = commands.parent / "replay"
        subprocess.run([COMMAND, "run", "--quiet", "--no-pictures", "--seed", SEED, "--scenario", str(commands),
                        "--out", str(replay)], check=False, timeout=300)
        replayed = json.loads((replay / "summary.json").read_text())
        self.assertEqual(replayed["virtual_seconds"], self.robot.summary["virtual_seconds"])
        self.assertEqual(replayed["digest"], self.robot.summary["digest"])


if __name__ == "__main__":
    unittest.main(verbosity=2)
