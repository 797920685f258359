"""The API goes down with its main controller, or with that one's message controller, and comes back with it: a client that is
connected goes on, a recording goes on, an order that comes meanwhile waits, and the robot, which was being driven, has come to
a stand."""
import os
import re
import signal
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

import roslibpy
from mcap.records import Message
from mcap.stream_reader import StreamReader

from served_robot import free_port, until


class Processes:
    """virtual_robot, message_controller, a supervised main_controller with the api among its plug-ins, and the module."""

    def __init__(self, folder):
        self.folder = Path(folder)
        self.port = free_port()
        self.started = []
        config = Path(os.environ["GAITWAY_CONFIG"]).with_name("serve.yaml").read_text()
        config = config.replace("sockets: local", f"parameters: {{link: 'unix:{self.folder}/link'}}\n    sockets: local")
        (self.folder / "serve.yaml").write_text(config)
        self.start("robot", "GAITWAY_VIRTUAL_ROBOT", "--bus", self.folder / "bus")
        self.start_message_controller()
        until(lambda: (self.folder / "memory").exists(), "the memory block")
        self.main = self.start("main", "GAITWAY_MAIN_CONTROLLER", "--supervised", "--socket", self.folder / "memory", "--config",
                               self.folder / "serve.yaml", "--plugin-path", os.environ["GAITWAY_PLUGIN_DIR"])
        self.start("module", "GAITWAY_USER_INTERFACE", "--link", f"unix:{self.folder}/link", "--port", self.port, "--recordings",
                   self.folder)
        until(lambda: self.times_linked() == 1, lambda: "the API:\n" + self.output("main") + self.output("module"), 60.0)

    def start_message_controller(self):
        self.message = self.start("message", "GAITWAY_MESSAGE_CONTROLLER", "--bus", self.folder / "bus", "--memory",
                                  self.folder / "memory")

    def ctl(self, *arguments):
        address = [] if "--port" in arguments else ["--port", str(self.port)]
        return subprocess.run([os.environ["GAITWAY_COMMAND"], "ctl", *address, *arguments], capture_output=True, text=True, timeout=60)

    def start(self, name, program, *arguments):
        with open(self.folder / f"{name}.txt", "wb") as output:
            process = subprocess.Popen([os.environ[program], "--robot", os.environ["GAITWAY_ROBOT"], *map(str, arguments)],
                                       stdout=output, stderr=subprocess.STDOUT)
        self.started.append(process)
        return process

    def output(self, name):
        return (self.folder / f"{name}.txt").read_text(errors="replace")

    def times_linked(self):
        return len(re.findall(r"linked to the main controller", self.output("module")))

    def times_lost(self):
        return len(re.findall(r"link to the main controller is lost", self.output("module")))

    def kill_main_controller(self):
        """Not its supervisor, which starts it again."""
        children = Path(f"/proc/{self.main.pid}/task/{self.main.pid}/children").read_text().split()
        controllers = [int(child) for child in children if os.readlink(f"/proc/{child}/exe").endswith("/main_controller")]
        assert len(controllers) == 1, controllers
        os.kill(controllers[0], signal.SIGKILL)

    def stop(self):
        for process in reversed(self.started):
            if process.poll() is None:
                process.send_signal(signal.SIGINT)
        for process in self.started:
            try:
                process.wait(20)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()


class MainControllerRestart(unittest.TestCase):
    @classmethod
    def setUpClass(cls):  # one robot for all: roslibpy's reactor runs once in a process
        folder = tempfile.TemporaryDirectory(prefix="gaitway_restart_")
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        cls.processes = Processes(folder.name)
        cls.addClassCleanup(cls.processes.stop)
        cls.ros = roslibpy.Ros("127.0.0.1", cls.processes.port)
        cls.ros.run(timeout=20)
        cls.addClassCleanup(cls.ros.terminate)
        cls.seen = []
        odometry = roslibpy.Topic(cls.ros, "/odom", "nav_msgs/Odometry", throttle_rate=20)
        odometry.subscribe(cls.seen.append)
        until(lambda: cls.seen, "odometry")

    def walk(self):
        velocity = roslibpy.Topic(self.ros, "/cmd_vel", "geometry_msgs/Twist")
        velocity.advertise()
        end = time.monotonic() + 4.0
        while time.monotonic() < end:
            velocity.publish(roslibpy.Message({"linear": {"x": 0.1}}))
            time.sleep(0.05)  # as a client does: ten times a second and more
        self.assertGreater(self.seen[-1]["pose"]["pose"]["position"]["x"], 0.05, "it walked")

    def assert_it_goes_on(self, linked_before):
        until(lambda: self.processes.times_linked() == linked_before + 1, lambda: "the link again:\n" + self.processes.output("module") + self.processes.output("main"), 30.0)
        count = len(self.seen)
        until(lambda: self.ros.is_connected and len(self.seen) > count + 20, "odometry of the new main controller", 30.0)

    def test_clients_go_on(self):
        self.walk()
        linked = self.processes.times_linked()
        lost = self.processes.times_lost()
        self.processes.kill_main_controller()
        until(lambda: self.processes.times_lost() == lost + 1, "the loss", 10.0)
        walked = self.processes.ctl("--wait", "20", "walk", "0.1", "--seconds", "0.3")
        self.assertEqual(walked.returncode, 0, walked.stderr)
        self.assertIn("its main controller does not answer. It is waited for, 20 s at most", walked.stderr)
        self.assert_it_goes_on(linked)
        self.assertGreater(self.seen[-1]["pose"]["pose"]["position"]["z"], 0.25, "it stands")

    def test_they_go_on_without_the_message_controller_too(self):
        recording = self.processes.ctl("recording", "start", "outage")
        self.assertEqual(recording.returncode, 0, recording.stderr)
        linked = self.processes.times_linked()
        self.processes.message.kill()
        self.processes.message.wait()
        until(lambda: self.processes.times_lost() == linked, "the loss", 10.0)
        stand = subprocess.Popen([os.environ["GAITWAY_COMMAND"], "ctl", "--port", str(self.processes.port), "--wait", "20", "stand"],
                                 stderr=subprocess.PIPE, text=True)
        self.assertRegex(stand.stderr.readline(), "the robot is not there: its .* does not answer. It is waited for, 20 s at most")
        self.processes.start_message_controller()
        said = stand.stderr.read()
        stand.stderr.close()
        self.assertEqual(stand.wait(30), 0, said)
        self.assert_it_goes_on(linked)
        back_s = time.monotonic()
        time.sleep(1.0)  # of the recording
        self.assertEqual(self.processes.ctl("recording", "stop").returncode, 0)
        files = list(self.folder.glob("*.mcap"))
        self.assertEqual(len(files), 1, "the recording goes on in its file")
        with open(files[0], "rb") as stream:
            newest_s = max(1e-9 * record.log_time for record in StreamReader(stream).records if isinstance(record, Message))
        self.assertGreater(newest_s, back_s)

    def test_nobody_is_waited_for_longer_than_said(self):
        nobody = str(free_port())
        begin = time.monotonic()
        stand = self.processes.ctl("--port", nobody, "--wait", "1", "stand")
        self.assertEqual(stand.returncode, 1)
        self.assertIn("It is waited for, 1 s at most", stand.stderr)
        self.assertGreater(time.monotonic() - begin, 1.0)
        at_once = self.processes.ctl("--port", nobody, "--wait", "0", "stand")
        self.assertEqual(at_once.returncode, 1)
        self.assertNotIn("waited for", at_once.stderr)


if __name__ == "__main__":
    unittest.main(verbosity=2)
