"""Stops by datagram, between processes: `gaitway stop` and the Python example stop a robot that a client walks."""
import importlib.util
import json
import os
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

from served_robot import COMMAND, ServedRobot, until

EXAMPLE = Path(__file__).resolve().parents[2] / "docs" / "examples" / "stop_client.py"
ENOUGH_S = 3.0  # so that the batch that the robot's end refuses is one of many
TOKEN = "a-token-of-some-length-4711"


def stop_client():
    spec = importlib.util.spec_from_file_location("stop_client", EXAMPLE)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


class Wire:
    """Between a client and the robot: remembers what the client says, and plays it again."""

    def __init__(self, client):
        self.said = []
        self._socket = client._socket
        self._robot = client._robot
        client._socket = self

    def sendto(self, datagram, to):
        self.said.append(datagram)
        return self._socket.sendto(datagram, to)

    def play(self):
        for datagram in self.said:
            self._socket.sendto(datagram, self._robot)

    def __getattr__(self, name):
        return getattr(self._socket, name)


class StopDatagrams(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="gaitway_stops_")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def token_file(self, name, token):
        file = self.folder / name
        file.touch(0o600)
        file.write_text(token + "\n")
        return str(file)

    def ctl(self, *arguments, token=None):
        authorised = ["--token-file", token] if token else []
        return subprocess.run([COMMAND, "ctl", "--url", f"ws://127.0.0.1:{self.robot.port}", *authorised, *arguments],
                              capture_output=True, text=True, timeout=60)

    def stop(self, *arguments):
        return subprocess.run([COMMAND, "stop", f"127.0.0.1:{self.robot.port + 1}", *arguments], capture_output=True, text=True,
                              timeout=60)

    def odometry(self):
        return json.loads(self.ctl("echo", "/odom").stdout)

    def speed(self):
        return abs(self.odometry()["twist"]["twist"]["linear"]["x"])

    def walk(self):
        start = self.odometry()["pose"]["pose"]["position"]["x"]
        driver = subprocess.Popen([COMMAND, "ctl", "--url", f"ws://127.0.0.1:{self.robot.port}", "walk", "0.12", "--seconds", "60"],
                                  stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        until(lambda: self.odometry()["pose"]["pose"]["position"]["x"] > start + 0.1, "10 cm of walk", 30.0)
        return driver

    def assert_stood(self, driver):
        self.assertEqual(driver.wait(30), 1, "who walked has lost the command")
        self.assertIn("stopped", driver.stderr.read())
        driver.stderr.close()
        until(lambda: self.speed() < 0.01, "the stand")

    def test_a_stop_ends_the_walk_and_a_recording_does_nothing(self):
        with ServedRobot() as self.robot:
            self.robot.wait_for_line(rf"listens for stops by datagram at udp://127\.0\.0\.1:{self.robot.port + 1}$")
            driver = self.walk()
            stopped = self.stop()
            self.assertEqual(stopped.returncode, 0, stopped.stderr)
            self.assertRegex(stopped.stdout, r"has obeyed after \d+ ms")
            self.assert_stood(driver)
            self.robot.wait_for_line(r"user_interface: stop by datagram from 127\.0\.0\.1:\d+$")

            driver = self.walk()
            client = stop_client().StopClient("127.0.0.1", self.robot.port + 1)
            self.addCleanup(client._socket.close)
            wire = Wire(client)
            self.assertEqual(client.stop(), "obeyed")
            self.assert_stood(driver)

            driver = self.walk()
            wire.play()
            self.assertIsNone(driver.poll())
            start = self.odometry()["pose"]["pose"]["position"]["x"]
            until(lambda: self.odometry()["pose"]["pose"]["position"]["x"] > start + 0.1, "a walk that goes on", 30.0)
            ran = subprocess.run([sys.executable, str(EXAMPLE), "127.0.0.1", str(self.robot.port + 1), "--kind", "hold"],
                                 capture_output=True, text=True, timeout=60)
            self.assertEqual((ran.returncode, ran.stdout), (0, "obeyed\n"), ran.stderr)
            self.assertEqual(driver.wait(30), 1)
            driver.stderr.close()
            self.robot.stop()
            commands = (self.robot.out / "commands.yaml").read_text()
        self.assertEqual(commands.count("asked: true, stop: true"), 2, commands)
        self.assertEqual(commands.count("emergency_stop: hold"), 1, commands)
        self.assertFalse(self.robot.summary["fell"])

    def test_another_token_is_refused_and_told(self):
        token = self.token_file("token", TOKEN)
        other = self.token_file("other", "another-token-of-some-length")
        with ServedRobot("--token-file", token) as self.robot:
            for arguments in ([], ["--token-file", other]):
                refused = self.stop(*arguments, "--seconds", "0.3")
                self.assertEqual(refused.returncode, 3, refused.stdout + refused.stderr)
                self.assertIn("nobody has answered", refused.stderr)
            line = self.robot.wait_for_line(r"refused a stop datagram with a wrong code")
            self.assertIn("127.0.0.1", line)
            stopped = self.stop("--token-file", token)
            self.assertEqual(stopped.returncode, 0, stopped.stderr)
            time.sleep(ENOUGH_S)

    def test_a_robot_that_does_not_obey_is_told_and_obeys_later(self):
        with ServedRobot() as self.robot:
            until(lambda: self.ctl("plugin", "list").returncode == 0, "the robot")
            os.kill(self.robot.plugin_process(), signal.SIGSTOP)  # the robot's side of the link, which the manager replaces
            heard = self.stop("--seconds", "0.1")
            self.assertEqual(heard.returncode, 2, heard.stdout + heard.stderr)
            self.assertIn("has heard the stop", heard.stderr)
            self.robot.wait_for_line(r"user_interface: stop by datagram")
            until(lambda: self.stop("--kind", "hold", "--seconds", "1").returncode == 0, "a link that is back")
            time.sleep(ENOUGH_S)
            self.robot.stop()
            commands = (self.robot.out / "commands.yaml").read_text()
        self.assertIn("asked: true, stop: true", commands)
        self.assertIn("emergency_stop: hold", commands)

    def test_what_is_not_there_is_told(self):
        with ServedRobot("--stop-port", "0") as self.robot:
            self.robot.wait_for_line(r"takes no stops by datagram")
            self.assertEqual(self.stop("--seconds", "0.2").returncode, 3)
            time.sleep(ENOUGH_S)
        for arguments in (["host:0"], ["host:77777"], ["[::1"], [":9091"], ["host:9091x"], ["127.0.0.1", "--token-file", "/no/such"],
                          ["127.0.0.1", "--kind", "jump"]):
            bad = subprocess.run([COMMAND, "stop", *arguments], capture_output=True, text=True, timeout=60)
            self.assertEqual(bad.returncode, 1, (arguments, bad.stderr))
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as taken:
            taken.bind(("127.0.0.1", 0))
            port = str(taken.getsockname()[1])
            serve = subprocess.run([COMMAND, "serve", "--port", "0", "--stop-port", port, "--out", str(self.folder / "out")],
                                   capture_output=True, text=True, timeout=60)
        self.assertEqual(serve.returncode, 1, serve.stderr)
        self.assertIn(port, serve.stderr)
        self.assertIn("--stop-port", serve.stderr)


if __name__ == "__main__":
    unittest.main(verbosity=2)
