"""roslibpy, as it comes from the registry: connects, lists, subscribes to everything, drives, calls every service, reconnects."""
import math
import os
import threading
import unittest
from pathlib import Path

import roslibpy

from served_robot import ServedRobot, until

# Topics that speak all the time; `/events` does when there is something to say.
STEADY = ["/joint_states", "/imu/data", "/foot/left/wrench", "/foot/right/wrench", "/zmp", "/zmp/reference", "/com", "/odom", "/tf",
          "/clock", "/diagnostics"]
LATCHED = ["/robot_description", "/footsteps", "/motion_state", "/walk_to/state", "/command/state", "/robot_state", "/walk/command", "/commander"]


class Listener:
    """Counts a topic's messages and keeps the newest."""

    def __init__(self, ros, topic, kind, **options):
        self.count = 0
        self.message = None
        self.topic = roslibpy.Topic(ros, topic, kind, **options)
        self.topic.subscribe(self._take)

    def _take(self, message):
        self.message = message
        self.count += 1


def connect(port):
    ros = roslibpy.Ros("127.0.0.1", port)
    ros.run(timeout=20)
    return ros


def call(ros, service, kind, **arguments):
    return dict(roslibpy.Service(ros, service, kind).call(roslibpy.ServiceRequest(arguments), timeout=20))


class Roslibpy(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.served = ServedRobot(speed=2.0)
        cls.robot = cls.served.__enter__()
        cls.addClassCleanup(cls.served.__exit__, None, None, None)
        cls.ros = connect(cls.robot.port)
        cls.addClassCleanup(cls.ros.terminate)

    def test_1_lists_what_there_is(self):
        topics = self.ros.get_topics()
        for topic in STEADY + LATCHED + ["/events", "/rosout", "/cmd_vel", "/simulation/state", "/simulation/twin"]:
            self.assertIn(topic, topics)
            self.assertTrue(self.ros.get_topic_type(topic), topic)
        services = self.ros.get_services()
        for service in ["/stand", "/stop", "/emergency_stop", "/move_joint", "/play_motion", "/plugins/list", "/recording/start", "/simulation/push",
                        "/simulation/spawn_entity"]:
            self.assertIn(service, services)
            self.assertTrue(self.ros.get_service_type(service), service)
        details = self.ros.get_message_details("sensor_msgs/msg/JointState")
        self.assertIn("position", details["typedefs"][0]["fieldnames"])
        self.assertGreater(self.ros.get_time()["secs" if "secs" in self.ros.get_time() else "sec"], -1)

    def test_2_subscribes_to_everything_in_json_and_cbor(self):
        listeners = {topic: Listener(self.ros, topic, self.ros.get_topic_type(topic)) for topic in STEADY + LATCHED + ["/events"]}
        until(lambda: all(listeners[topic].count >= 2 for topic in STEADY), "two messages of each topic")
        until(lambda: all(listeners[topic].count >= 1 for topic in LATCHED), "the latched messages")
        joints = listeners["/joint_states"].message
        self.assertEqual(len(joints["name"]), 22)
        self.assertEqual(len(joints["position"]), 22)
        self.assertIn("<robot", listeners["/robot_description"].message["data"])
        gravity = listeners["/imu/data"].message["linear_acceleration"]["z"]
        self.assertAlmostEqual(gravity, 9.81, delta=1.5)
        weight = sum(listeners[f"/foot/{side}/wrench"].message["wrench"]["force"]["z"] for side in ("left", "right"))
        self.assertAlmostEqual(weight, 6.84 * 9.81, delta=15.0)
        frames = {frame["child_frame_id"] for frame in listeners["/tf"].message["transforms"]}
        self.assertTrue({"pelvis", "trunk", "left_foot", "head"} <= frames, frames)
        for listener in listeners.values():
            listener.topic.unsubscribe()

    def test_3_a_foreign_name_gets_an_error_and_nothing_else(self):
        # roslibpy has no error callback for subscriptions: what counts is that the connection goes on.
        Listener(self.ros, "/no/such/topic", "std_msgs/String")
        with self.assertRaises(Exception):
            call(self.ros, "/no/such/service", "std_srvs/Trigger")
        self.assertTrue(self.ros.is_connected)
        self.assertIn("/odom", self.ros.get_topics())

    def test_4_drives_and_stands(self):
        odometry = Listener(self.ros, "/odom", "nav_msgs/Odometry")
        until(lambda: odometry.message, "odometry")
        start = odometry.message["pose"]["pose"]["position"]
        velocity = roslibpy.Topic(self.ros, "/cmd_vel", "geometry_msgs/Twist")
        velocity.advertise()
        done = threading.Event()

        def drive():
            while not done.wait(0.05):
                velocity.publish(roslibpy.Message({"linear": {"x": 0.15, "y": 0.0, "z": 0.0}, "angular": {"x": 0.0, "y": 0.0, "z": 0.0}}))

        driver = threading.Thread(target=drive)
        driver.start()

        def walked():
            now = odometry.message["pose"]["pose"]["position"]
            return math.hypot(now["x"] - start["x"], now["y"] - start["y"])

        try:
            until(lambda: walked() > 0.4, "40 cm of walk", 40.0)
        finally:
            done.set()
            driver.join()
        # Nobody renews the command any more: it stands without being told to.
        def speed():
            return abs(odometry.message["twist"]["twist"]["linear"]["x"])
        def still():
            before, count = walked(), odometry.count
            until(lambda: odometry.count > count + 50, "more odometry")
            return abs(walked() - before) < 0.003 and speed() < 0.02
        until(still, "the stand", 40.0)
        odometry.topic.unsubscribe()

    def test_5_calls_every_service(self):
        self.assertTrue(call(self.ros, "/stand", "std_srvs/Trigger")["success"])
        self.assertTrue(call(self.ros, "/stop", "std_srvs/Trigger")["success"])
        listing = call(self.ros, "/plugins/list", "gaitway_msgs/ListPlugins")
        self.assertTrue({"trajectory", "kinematics", "zmp", "stability", "api"} <= {plugin["name"] for plugin in listing["plugins"]})
        parameters = call(self.ros, "/plugins/get_parameters", "gaitway_msgs/GetParameters", plugin="zmp")
        self.assertTrue(parameters["success"], parameters)
        self.assertTrue(parameters["names"])
        fixed = call(self.ros, "/plugins/set_parameter", "gaitway_msgs/SetParameter", plugin="zmp",
                     parameter=parameters["names"][0], value=parameters["values"][0])
        self.assertFalse(fixed["success"], "none of its parameters may change while it runs")
        self.assertIn(parameters["names"][0], fixed["message"])
        refused = call(self.ros, "/plugins/set_parameter", "gaitway_msgs/SetParameter", plugin="stability", parameter="nonsense", value="1")
        self.assertFalse(refused["success"])
        self.assertIn("nonsense", refused["message"])
        reloaded = call(self.ros, "/plugins/reload", "gaitway_msgs/ChangePlugin", name="stability", library="")
        self.assertTrue(reloaded["success"], reloaded)
        outside = call(self.ros, "/plugins/load", "gaitway_msgs/ChangePlugin", name="evil", library="../../tmp/evil.so")
        self.assertFalse(outside["success"])
        with self.assertRaisesRegex(Exception, "nobody"):
            call(self.ros, "/plugins/unload", "gaitway_msgs/ChangePlugin", name="nobody", library="")
        unknown = call(self.ros, "/play_motion", "gaitway_msgs/PlayMotion", motion="jump")
        self.assertFalse(unknown["success"])
        self.assertIn("squat", unknown["message"])
        motion = Listener(self.ros, "/motion_state", "gaitway_msgs/MotionState")
        until(lambda: call(self.ros, "/play_motion", "gaitway_msgs/PlayMotion", motion="squat")["success"], "the squat's beginning")
        until(lambda: motion.message and motion.message["motion"] == "squat" and motion.message["result"] == "finished", "its end")
        recording = call(self.ros, "/recording/start", "gaitway_msgs/StartRecording", name="roslibpy")
        self.assertTrue(recording["success"], recording)
        self.assertFalse(call(self.ros, "/recording/start", "gaitway_msgs/StartRecording", name="other")["success"])
        self.assertTrue(call(self.ros, "/recording/stop", "std_srvs/Trigger")["success"])
        self.assertTrue(Path(recording["file"]).stat().st_size > 0)
        with self.assertRaisesRegex(Exception, "escape"):
            call(self.ros, "/recording/start", "gaitway_msgs/StartRecording", name="../escape")

    def test_6_reconnects(self):
        for _ in range(3):
            other = connect(self.robot.port)
            listener = Listener(other, "/joint_states", "sensor_msgs/JointState")
            until(lambda: listener.count >= 3, "joint states after a new connection")
            other.close()
            until(lambda: not other.is_connected, "the end of the connection")
        self.assertTrue(self.ros.is_connected)

    def test_7_survives_the_end_of_the_api_process(self):
        listener = Listener(self.ros, "/joint_states", "sensor_msgs/JointState")
        until(lambda: listener.count > 0, "joint states")
        os.kill(self.robot.api_process(), 9)
        self.robot.wait_for_port(2)
        # The client connects again by itself, and subscribes again to what it was subscribed to.
        before = listener.count
        until(lambda: self.ros.is_connected and listener.count > before + 10, "joint states of the new process", 40.0)

    def test_8_an_emergency_stop_is_obeyed(self):
        ros = connect(self.robot.port)
        self.addCleanup(ros.close)
        self.assertTrue(call(ros, "/emergency_stop", "std_srvs/SetBool", data=False)["success"])
        diagnostics = Listener(ros, "/diagnostics", "diagnostic_msgs/DiagnosticArray")
        until(lambda: diagnostics.message and "emergency" in str(diagnostics.message).lower(), "the stop in the diagnostics")


if __name__ == "__main__":
    unittest.main(verbosity=2)
