"""`gaitway simulator --robot ADDRESS`: a robot that is served is the real one here, behind a link that can be cut. The simulated one does what
that one is told, the difference is told, and what is sent goes through the pre-flight gate."""
import os
import re
import shutil
import socket
import subprocess
import tempfile
import threading
import time
import unittest
from pathlib import Path

import roslibpy

from served_robot import COMMAND, ServedRobot, free_port, until
from simulator import Simulator
from twin_client import SEND, Client

class Relay:
    """A TCP relay in front of a server: `cut` ends what is connected and lets nobody in, `rewrite` changes what the server says first."""

    def __init__(self, port, rewrite=None):
        self.port = free_port()
        self._target, self._rewrite, self._pairs, self._hung, self._open = port, rewrite, [], [], True
        self._server = socket.create_server(("127.0.0.1", self.port))
        threading.Thread(target=self._accept, daemon=True).start()

    def _accept(self):
        while True:
            try:
                client, _ = self._server.accept()
            except OSError:
                return
            if not self._open:
                client.close()
                continue
            server = socket.create_connection(("127.0.0.1", self._target))
            self._pairs.append((client, server))
            pair = (client, server)
            threading.Thread(target=self._pass, args=(pair, client, server, None), daemon=True).start()
            threading.Thread(target=self._pass, args=(pair, server, client, self._rewrite), daemon=True).start()

    def _pass(self, pair, source, sink, rewrite):
        try:
            while data := source.recv(65536):
                while pair in self._hung and pair in self._pairs:
                    time.sleep(0.01)
                if rewrite:
                    data, rewrite = data.replace(*rewrite), None
                sink.sendall(data)
        except OSError:
            pass
        for one in (source, sink):
            try:
                one.shutdown(socket.SHUT_RDWR)
            except OSError:
                pass

    def hang(self):
        """What is connected hears nothing any more; who comes anew is let through."""
        self._hung = list(self._pairs)

    def cut(self):
        self._open = False
        for pair in self._pairs:
            for one in pair:
                try:
                    one.shutdown(socket.SHUT_RDWR)
                except OSError:
                    pass
        self._pairs.clear()

    def mend(self):
        self._open = True

    def close(self):
        self.cut()
        self._server.close()


TRIED = 4  # simulated robots: what the gate does with their number is the same for 20


class Twin(unittest.TestCase):
    """One robot there, one simulator here, for all tests of this class."""

    mismatch = "1"

    @classmethod
    def setUpClass(cls):
        cls.robot = ServedRobot("--world", "empty", "--seed", "7", "--mismatch", cls.mismatch).__enter__()
        cls.addClassCleanup(cls.robot.__exit__, None, None, None)
        cls.relay = Relay(cls.robot.port)
        cls.addClassCleanup(cls.relay.close)
        cls.simulator = Simulator("--robot", f"ws://127.0.0.1:{cls.relay.port}", "--preflight-robots", str(TRIED)).__enter__()
        cls.addClassCleanup(cls.simulator.__exit__, None, None, None)
        cls.there = Client(cls.robot.port, {"/odom": "nav_msgs/msg/Odometry", "/robot_state": "gaitway_msgs/msg/RobotState"})
        cls.addClassCleanup(cls.there.close)
        cls.here = Client(cls.simulator.port, {"/simulation/twin": "gaitway_msgs/msg/TwinState", "/simulation/state": "gaitway_msgs/msg/SimulationState",
                                               "/robot_state": "gaitway_msgs/msg/RobotState", "/odom": "nav_msgs/msg/Odometry"})
        cls.addClassCleanup(cls.here.close)
        until(lambda: cls.here.newest.get("/simulation/twin", {}).get("state") == "connected", "the robot there", 30)

    def setUp(self):
        for last in (False, False, True):  # what the test before has left may not be known yet
            self.order("follow", "std_srvs/srv/SetBool", data=True)
            try:
                until(self.side_by_side, lambda: f"a stand side by side: {self.twin}", 15)
                return
            except AssertionError:
                if last:
                    raise

    def side_by_side(self):
        return all(client.newest["/robot_state"]["state"] == "stands" for client in (self.there, self.here)) and (self.place_apart() or 0.0) < 0.1

    @property
    def twin(self):
        return self.here.newest["/simulation/twin"]

    def order(self, name, kind, **arguments):
        return self.here.call("/simulation/twin/" + name, kind, **arguments)

    def drive(self, seconds, forward):
        velocity = roslibpy.Topic(self.there.ros, "/cmd_vel", "geometry_msgs/msg/Twist")
        velocity.advertise()
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            velocity.publish({"linear": {"x": forward, "y": 0.0, "z": 0.0}, "angular": {"x": 0.0, "y": 0.0, "z": 0.0}})
            time.sleep(0.1)
        velocity.unadvertise()

    def place_apart(self):
        difference = dict(zip(self.twin["channels"], self.twin["difference"]))
        x, y = difference["place x"], difference["place y"]
        return None if x is None or y is None else (x * x + y * y) ** 0.5

    @staticmethod
    def x_of(client):
        return client.newest["/odom"]["pose"]["pose"]["position"]["x"]

    def send_and_wait(self, timeout_s=90, **task):
        self.assertEqual(self.order("send", SEND, **task), {"success": True, "message": ""})
        until(lambda: self.twin["sending"] in ("trying", "sending"), "the trial", 10)
        until(lambda: self.twin["sending"] not in ("trying", "sending"), lambda: f"its end: {self.twin}", timeout_s)
        return self.twin["sending"]


class InStep(Twin):
    def test_the_simulated_robot_does_what_the_one_there_is_told(self):
        before = self.x_of(self.there), self.x_of(self.here)
        heard = max(self.twin["told_times"], default=0.0)
        self.drive(5.0, 0.15)
        until(lambda: self.twin["lag"] is not None, "the lag")
        self.assertLess(abs(self.twin["lag"]), 0.6)
        until(lambda: self.here.newest["/robot_state"]["state"] == "stands" and self.there.newest["/robot_state"]["state"] == "stands", "the stand")
        walked = self.x_of(self.there) - before[0], self.x_of(self.here) - before[1]
        self.assertGreater(walked[0], 0.3)
        self.assertAlmostEqual(walked[1], walked[0], delta=0.1)
        self.assertEqual([text for at, text in zip(self.twin["told_times"], self.twin["told_texts"]) if at > heard and "differs" in text], [], "it is as it is described")
        until(lambda: all(one is not None for one in self.twin["difference"]), lambda: f"all of it: {self.twin}")
        twin = self.twin
        self.assertEqual(len(twin["channels"]), 22 + 7)
        self.assertEqual(twin["channels"][22:24], ["roll", "pitch"])
        for name, difference, limit in zip(twin["channels"], twin["difference"], twin["limits"]):
            if limit > 0:
                self.assertLess(difference, limit, name)
        self.assertEqual(len(twin["joints"]), 22)
        self.assertAlmostEqual(twin["base"][2], self.here.newest["/simulation/state"]["base"][2], delta=0.01)
        self.assertTrue(twin["follows"], twin["follows_text"])


class AsDescribed(Twin):
    def test_what_is_sent_was_tried_before(self):
        before = self.x_of(self.there)
        self.assertEqual(self.send_and_wait(walk=[0.12, 0.0, 0.0], duration=4.0), "done")
        self.assertEqual((self.twin["passed"], self.twin["tried"]), (TRIED, TRIED))
        self.assertIn(f"{TRIED} of {TRIED}", self.twin["sending_text"])
        self.assertGreater(self.x_of(self.there), before + 0.2)
        until(lambda: self.twin["picture"] > 0, "the picture")
        picture = self.order("picture", "gaitway_msgs/srv/GetPicture", first=0)
        self.assertTrue(picture["success"], picture["message"])
        self.assertTrue(picture["data"].startswith("iVBORw0KGgo"), "a PNG")
        self.assertGreater(picture["total"], 10_000)
        record = (self.simulator.out / "preflight" / "sent.jsonl").read_text()
        self.assertIn('"outcome":"begun"', record)
        self.assertIn('"outcome":"done"', record)

    def test_what_does_not_pass_is_not_sent_without_a_reason(self):
        self.assertEqual(self.send_and_wait(motion="no_such_motion"), "not passed")
        self.assertIn(f"0 of {TRIED}", self.twin["sending_text"])
        self.assertEqual(self.send_and_wait(motion="no_such_motion", reason="to see what it says"), "failed")
        self.assertIn("no_such_motion", self.twin["sending_text"])
        self.assertIn("to see what it says", (self.simulator.out / "preflight" / "sent.jsonl").read_text())

    def test_a_stop_ends_what_is_sent(self):
        self.order("send", SEND, walk=[0.12, 0.0, 0.0], duration=15.0)
        until(lambda: self.there.newest["/robot_state"]["state"] == "walks", "the walk", 60)
        again = self.order("send", SEND, motion="kick")
        self.assertFalse(again["success"])
        self.assertIn("under way", again["message"])
        self.assertTrue(self.order("stop", "std_srvs/srv/Trigger")["success"])
        until(lambda: self.there.newest["/robot_state"]["state"] in ("stands", "stops"), "the stop", 3)
        until(lambda: self.twin["sending"] == "stopped", "the word", 5)
        until(lambda: any("told to stop" in text for text in self.twin["told_texts"]), "the answer", 5)

    def test_a_link_that_is_lost_in_mid_mission_leaves_both_standing(self):
        self.assertTrue(self.order("send", SEND, goal=[self.x_of(self.there) + 1.0, 0.0, 0.0])["success"])
        until(lambda: self.there.newest["/robot_state"]["state"] == "walks" and self.twin["sending"] == "sending", lambda: f"the way: {self.twin}", 90)
        time.sleep(1.5)  # some steps
        self.relay.cut()
        cut = time.monotonic()
        until(lambda: self.there.newest["/robot_state"]["state"] == "stands", "the stand there", 5)
        self.assertLess(time.monotonic() - cut, 4.0)
        until(lambda: self.twin["state"] == "lost", "that it is told", 10)
        self.assertTrue(self.twin["text"])
        until(lambda: self.twin["sending"] == "failed", lambda: f"the mission's end: {self.twin}", 15)
        until(lambda: self.here.newest["/robot_state"]["state"] == "stands", "the stand here", 20)
        refused = self.order("send", SEND, motion="kick")
        self.assertFalse(refused["success"])
        self.assertIn("lost", refused["message"])
        self.relay.mend()
        until(lambda: self.twin["state"] == "connected", "the link", 10)

    def test_a_robot_that_has_moved_is_not_sent_what_was_tried(self):
        self.order("send", SEND, walk=[0.1, 0.0, 0.0], duration=10.0)
        until(lambda: self.twin["sending"] == "trying", "the trial", 10)
        time.sleep(1.0)  # it has asked where the robot is
        self.drive(1.2, 0.15)
        until(lambda: self.twin["sending"] not in ("trying", "sending"), lambda: f"its end: {self.twin}", 60)
        self.assertEqual(self.twin["sending"], "failed", self.twin["sending_text"])
        self.assertRegex(self.twin["sending_text"], "has moved|must stand")

    def test_a_stop_waits_for_no_link_that_hangs(self):
        walking = threading.Thread(target=self.drive, args=(4.0, 0.12))
        walking.start()
        until(lambda: self.there.newest["/robot_state"]["state"] == "walks", "the walk", 10)
        self.relay.hang()
        pressed = time.monotonic()
        self.assertTrue(self.order("stop", "std_srvs/srv/Trigger")["success"])
        until(lambda: self.there.newest["/robot_state"]["state"] in ("stops", "stands"), "the stop", 5)
        self.assertLess(time.monotonic() - pressed, 1.5)
        walking.join()
        self.relay.cut()
        self.relay.mend()
        until(lambda: self.twin["state"] == "connected", "the link", 20)

    def test_whoever_follows_again_goes_to_where_the_robot_there_is(self):
        self.order("follow", "std_srvs/srv/SetBool", data=False)
        until(lambda: not self.twin["follows"], "that it is told", 5)
        self.drive(4.0, 0.15)
        until(lambda: self.there.newest["/robot_state"]["state"] == "stands", "the stand", 10)
        until(lambda: (self.place_apart() or 0.0) > 0.15, lambda: f"that they are apart: {self.twin}", 10)
        self.order("follow", "std_srvs/srv/SetBool", data=True)
        until(lambda: (self.place_apart() or 9.0) < 0.06, lambda: f"that they are not: {self.twin}", 40)

    def test_a_paused_simulation_follows_nobody(self):
        pause = {"state": {"state": 2}}
        self.here.call("/simulation/set_simulation_state", "simulation_interfaces/srv/SetSimulationState", **pause)
        until(lambda: not self.twin["follows"], "that it is told", 5)
        self.assertIn("paused", self.twin["follows_text"])
        self.here.call("/simulation/set_simulation_state", "simulation_interfaces/srv/SetSimulationState", state={"state": 1})
        until(lambda: self.twin["follows"], "that it follows again", 5)


class AnotherThanDescribed(Twin):
    mismatch = "6"  # joint zeros are off by degrees

    def test_what_differs_is_told(self):
        until(lambda: any("differs from the simulated one" in text for text in self.twin["told_texts"]), lambda: f"the difference: {self.twin}", 30)
        over = [name for name, difference, limit in zip(self.twin["channels"], self.twin["difference"], self.twin["limits"])
                if limit > 0 and difference is not None and difference > limit]
        self.assertTrue(over)


class Ends(unittest.TestCase):
    """What is at stake when the simulator ends, or the robot there was set otherwise."""

    def setUp(self):
        self.robot = ServedRobot("--world", "empty", "--seed", "7").__enter__()
        self.addCleanup(self.robot.__exit__, None, None, None)
        self.simulator = Simulator("--robot", f"ws://127.0.0.1:{self.robot.port}", "--preflight-robots", str(TRIED)).__enter__()
        self.addCleanup(self.simulator.__exit__, None, None, None)
        self.there = Client(self.robot.port, {"/robot_state": "gaitway_msgs/msg/RobotState", "/motion_state": "gaitway_msgs/msg/MotionState"})
        self.addCleanup(self.there.close)
        self.here = Client(self.simulator.port, {"/simulation/twin": "gaitway_msgs/msg/TwinState"})
        self.addCleanup(self.here.close)
        until(lambda: self.here.newest.get("/simulation/twin", {}).get("state") == "connected", "the robot there", 30)

    @property
    def twin(self):
        return self.here.newest["/simulation/twin"]

    def send(self, **task):
        answer = self.here.call("/simulation/twin/send", SEND, **task)
        self.assertTrue(answer["success"], answer)

    def test_the_simulators_end_ends_a_motion_that_it_sent(self):
        self.send(motion="kick")
        until(lambda: self.there.newest["/motion_state"]["state"] == "playing", "the motion", 60)
        self.simulator.process.terminate()
        ended = time.monotonic()
        until(lambda: self.there.newest["/robot_state"]["state"] != "plays", "its end", 5)
        self.assertLess(time.monotonic() - ended, 1.0, "a kick takes longer")
        until(lambda: self.there.newest["/motion_state"]["state"] == "none", "its result", 5)
        self.assertNotEqual(self.there.newest["/motion_state"]["result"], "finished")

    def test_what_is_set_there_counts_in_the_trial(self):
        wild = {"stability": {"walking_lean_gain": "5", "lean_limit": "0.3", "ankle_pitch": "0", "ankle_roll": "0", "ankle_pitch_rate": "0", "ankle_roll_rate": "0"},
                "trajectory": {"adjust_share": "0", "adjust_threshold": "1", "adjust_side_threshold": "1"}}
        for plugin, parameters in wild.items():
            for parameter, value in parameters.items():
                answer = self.there.call("/plugins/set_parameter", "gaitway_msgs/srv/SetParameter", plugin=plugin, parameter=parameter, value=value)
                self.assertTrue(answer["success"], answer)
        self.send(walk=[0.25, 0.0, 0.0], duration=10.0)
        until(lambda: self.twin["sending"] not in ("idle", "trying"), lambda: f"the verdict: {self.twin}", 90)
        self.assertEqual(self.twin["sending"], "not passed", self.twin["sending_text"])
        self.assertEqual(self.there.newest["/robot_state"]["state"], "stands")


class Refusals(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.robot = ServedRobot("--world", "empty").__enter__()
        cls.addClassCleanup(cls.robot.__exit__, None, None, None)

    def simulator(self, *arguments):
        with tempfile.TemporaryDirectory() as out:
            result = subprocess.run([COMMAND, "simulator", "--port", str(free_port()), "--out", out, "--seconds", "1", *arguments], capture_output=True, text=True, timeout=60)
        return result.returncode, result.stdout + result.stderr

    def test_another_release_is_refused_by_both_numbers(self):
        relay = Relay(self.robot.port, (b"Server: gaitway/", b"Server: gaitway/7."))
        self.addCleanup(relay.close)
        code, said = self.simulator("--robot", f"ws://127.0.0.1:{relay.port}")
        self.assertEqual(code, 1)
        self.assertIn("runs release 7.", said)
        self.assertIn("install the same on both", said)

    def test_nobody_there_is_said(self):
        code, said = self.simulator("--robot", f"ws://127.0.0.1:{free_port()}")
        self.assertEqual(code, 1)
        self.assertIn("Connection refused", said)

    def test_two_robots_are_one_too_many(self):
        address = f"ws://127.0.0.1:{self.robot.port}"
        self.assertIn("one already", self.simulator("--robot", address, "--robot", address)[1])
        self.assertIn("give its address", self.simulator("--robot-token-file", "x")[1])

    def test_another_description_is_refused_by_its_line(self):
        with tempfile.TemporaryDirectory() as folder:
            shutil.copytree(Path(os.environ["GAITWAY_ROBOT"]), folder, dirs_exist_ok=True)
            file = Path(folder) / "robot.urdf"
            file.write_text(re.sub(r'(<mass value="[0-9.]+)', r"\g<1>1", file.read_text(), count=1))  # some grams more
            code, said = self.simulator("--robot", folder, "--robot", f"ws://127.0.0.1:{self.robot.port}")
            self.assertEqual(code, 1)
            self.assertIn("another description: line", said)
            self.assertIn("<mass value=", said)

    def test_what_is_no_address_is_said(self):
        for wrong in (f"http://127.0.0.1:{self.robot.port}", f"127.0.0.1:{self.robot.port}"):
            self.assertIn("begins with ws://", self.simulator("--robot", wrong)[1])


del Twin  # it is no test of its own

if __name__ == "__main__":
    unittest.main(verbosity=2)
