"""The user interface module is killed while it drives the robot, or the plug-in at the other end of its link: the robot stands within
the velocity command's time, nothing else is disturbed, the API is back within a second, and clients go on."""
import json
import os
import re
import subprocess
import unittest

from served_robot import COMMAND, ServedRobot, until


class ApiDeath(unittest.TestCase):
    def ctl(self, *arguments):
        return subprocess.run([COMMAND, "ctl", "--url", f"ws://127.0.0.1:{self.robot.port}", *arguments], capture_output=True,
                              text=True, timeout=60)

    def odometry(self):
        return json.loads(self.ctl("echo", "/odom").stdout)

    def position(self):
        return self.odometry()["pose"]["pose"]["position"]["x"]

    def speed(self):
        return abs(self.odometry()["twist"]["twist"]["linear"]["x"])

    def test_the_robot_stands_and_the_api_comes_back(self):
        deaths = 3
        with ServedRobot() as self.robot:
            for death in range(1, deaths + 1):
                start = self.position()
                driver = subprocess.Popen([COMMAND, "ctl", "--url", f"ws://127.0.0.1:{self.robot.port}", "walk", "0.12", "--seconds",
                                           "60"], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
                until(lambda: self.position() > start + 0.1, "10 cm of walk", 30.0)
                os.kill(self.robot.api_process(), 9)
                self.robot.wait_for_port(death + 1)
                self.assertEqual(driver.wait(30), 1, driver.stderr.read())
                driver.stderr.close()
                until(lambda: self.ctl("stand").returncode == 0, "a client that goes on")
                until(lambda: self.speed() < 0.01, "the stand")  # before the robot is told to end
            self.robot.stop()
            events = self.robot.summary["events"]["newest"]
            commands = (self.robot.out / "commands.yaml").read_text()
        self.assertFalse(self.robot.summary["fell"])
        self.assertEqual(self.robot.summary["batches"]["late"], 0)
        self.assertEqual(self.robot.summary["batches"]["refused"], 0)
        lost = [event["time_s"] for event in events if event["source"] == "api" and "is lost" in event["text"]]
        back = [event["time_s"] for event in events if event["source"] == "api" and "linked to 'user_interface " in event["text"]]
        self.assertEqual(len(lost), deaths, events)
        for at in lost:
            self.assertLessEqual(min(time for time in back if time >= at) - at, 1.0, events)
        # Each walk was ended by a stand, half a second after its last renewal at the latest.
        entries = [(float(at), kind) for at, kind in re.findall(r"at_s: ([\d.]+), (walk|stand)", commands)]
        ends = 0
        for (walked_at, before), (stood_at, after) in zip(entries, entries[1:]):
            if (before, after) == ("walk", "stand"):
                ends += 1
                self.assertLessEqual(stood_at - walked_at, 0.502)
        self.assertEqual(ends, deaths, commands)

    def test_the_plugins_end_is_a_link_that_comes_back(self):
        with ServedRobot() as self.robot:
            start = self.position()
            driver = subprocess.Popen([COMMAND, "ctl", "--url", f"ws://127.0.0.1:{self.robot.port}", "walk", "0.12", "--seconds", "60"],
                                      stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
            until(lambda: self.position() > start + 0.1, "10 cm of walk", 30.0)
            os.kill(self.robot.plugin_process(), 9)
            self.robot.wait_for_line("the link to the main controller is lost")
            self.assertEqual(driver.wait(30), 1, "who commanded has the command no more")
            self.assertRegex(driver.stderr.read(), "is not there|let go")
            driver.stderr.close()
            until(lambda: self.ctl("stand").returncode == 0, "a client that goes on")
            until(lambda: self.speed() < 0.01, "the stand")
            self.robot.stop()
        self.assertFalse(self.robot.summary["fell"])
        self.assertEqual(self.robot.summary["batches"]["late"], 0)
        self.assertEqual(len(self.robot.ports), 1, "the module goes on")


if __name__ == "__main__":
    unittest.main(verbosity=2)
