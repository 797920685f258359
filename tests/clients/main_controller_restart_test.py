"""The API goes down with its main controller and comes back with it: a client that is connected goes on, and the robot, which
was being driven, has come to a stand meanwhile."""
import os
import re
import signal
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

import roslibpy

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
        self.start("message", "GAITWAY_MESSAGE_CONTROLLER", "--bus", self.folder / "bus", "--memory", self.folder / "memory")
        until(lambda: (self.folder / "memory").exists(), "the memory block")
        self.main = self.start("main", "GAITWAY_MAIN_CONTROLLER", "--supervised", "--socket", self.folder / "memory", "--config",
                               self.folder / "serve.yaml", "--plugin-path", os.environ["GAITWAY_PLUGIN_DIR"])
        self.start("module", "GAITWAY_USER_INTERFACE", "--link", f"unix:{self.folder}/link", "--port", self.port)
        until(lambda: self.times_linked() == 1, lambda: "the API:\n" + self.output("main") + self.output("module"), 60.0)

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

    def kill_main_controller(self):
        """Not its supervisor, which starts it again."""
        children = Path(f"/proc/{self.main.pid}/task/{self.main.pid}/children").read_text().split()
        controllers = [int(child) for child in children if os.readlink(f"/proc/{child}/exe").endswith("/main_controller")]
        assert len(controllers) == 1, controllers
        os.kill(controllers[0], signal.SIGKILL)

    def stop(self):
        for process in reversed(self.started):
            process.send_signal(signal.SIGINT)
        for process in self.started:
            try:
                process.wait(20)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()


class MainControllerRestart(unittest.TestCase):
    def test_clients_go_on(self):
        with tempfile.TemporaryDirectory(prefix="gaitway_restart_") as folder:
            processes = Processes(folder)
            self.addCleanup(processes.stop)
            ros = roslibpy.Ros("127.0.0.1", processes.port)
            ros.run(timeout=20)
            self.addCleanup(ros.terminate)
            seen = []
            odometry = roslibpy.Topic(ros, "/odom", "nav_msgs/Odometry", throttle_rate=20)
            odometry.subscribe(seen.append)
            until(lambda: seen, "odometry")
            velocity = roslibpy.Topic(ros, "/cmd_vel", "geometry_msgs/Twist")
            velocity.advertise()
            end = time.monotonic() + 4.0
            while time.monotonic() < end:
                velocity.publish(roslibpy.Message({"linear": {"x": 0.1}}))
                time.sleep(0.05)  # as a client does: ten times a second and more
            self.assertGreater(seen[-1]["pose"]["pose"]["position"]["x"], 0.05, "it walked")
            processes.kill_main_controller()
            until(lambda: processes.times_linked() == 2, lambda: "the link again:\n" + processes.output("module"), 30.0)
            count = len(seen)
            until(lambda: ros.is_connected and len(seen) > count + 20, "odometry of the new main controller", 30.0)
            self.assertGreater(seen[-1]["pose"]["pose"]["position"]["z"], 0.25, "it stands")


if __name__ == "__main__":
    unittest.main(verbosity=2)
