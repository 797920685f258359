"""Who commands a served robot, as a client of its API sees and changes it; and its head looks where it is told."""
import unittest

import roslibpy

from served_robot import ServedRobot, until


class Listener:
    """Keeps a topic's newest message, and all that it said of who commands."""

    def __init__(self, ros, topic, kind):
        self.message = None
        self.commanders = []
        self.topic = roslibpy.Topic(ros, topic, kind)
        self.topic.subscribe(self._take)

    def _take(self, message):
        self.message = message
        if "commander" in message:
            self.commanders.append((message["commander"], message["reason"]))


class Command(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.served = ServedRobot(speed=2.0)
        cls.robot = cls.served.__enter__()
        cls.addClassCleanup(cls.served.__exit__, None, None, None)
        cls.ros = roslibpy.Ros("127.0.0.1", cls.robot.port)
        cls.ros.run(timeout=20)
        cls.addClassCleanup(cls.ros.terminate)
        cls.command = Listener(cls.ros, "/command/state", "gaitway_msgs/CommandState")
        cls.joints = Listener(cls.ros, "/joint_states", "sensor_msgs/JointState")
        until(lambda: cls.joints.message, "joints")

    def call(self, service, kind="std_srvs/Trigger", success=True, **arguments):
        answer = dict(roslibpy.Service(self.ros, service, kind).call(roslibpy.ServiceRequest(arguments), timeout=20))
        self.assertEqual(answer["success"], success, (service, answer))
        return answer["message"]

    def until_commanded(self, commander, reason):
        until(lambda: (self.command.message["commander"], self.command.message["reason"]) == (commander, reason),
              lambda: f"{commander}, {reason}: {self.command.message}")

    def joint(self, name):
        return self.joints.message["position"][self.joints.message["name"].index(name)]

    def look(self, **arguments):
        return self.call("/head/look", "gaitway_msgs/Look", **arguments)

    def test_1_nobody_commands_until_somebody_orders(self):
        until(lambda: self.command.message, "the latched message")
        self.assertEqual(self.command.message["commander"], "nobody")
        self.assertEqual(self.command.message["reason"], "start")
        self.assertTrue(self.command.message["text"])
        self.assertEqual({self.command.message[part] for part in ("walk", "way", "motion", "head")}, {"nobody"})

    def test_2_a_velocity_makes_it_a_persons_until_it_is_let_go(self):
        velocity = roslibpy.Topic(self.ros, "/cmd_vel", "geometry_msgs/Twist")

        def walks():
            velocity.publish(roslibpy.Message({"linear": {"x": 0.1, "y": 0.0, "z": 0.0}, "angular": {"x": 0.0, "y": 0.0, "z": 0.0}}))
            return self.command.message["walk"] == "person"

        until(walks, "a walk of a person's")
        self.assertEqual((self.command.message["commander"], self.command.message["reason"]), ("person", "person_orders"))
        until(lambda: self.command.message["walk"] == "nobody", "its end, without a further velocity")
        self.assertEqual(self.command.message["commander"], "person", "whose order has ended commands on")
        self.call("/command/let_go")
        self.until_commanded("nobody", "person_lets_go")
        self.call("/stand")  # is an order, too
        self.until_commanded("person", "person_orders")
        self.call("/command/let_go")
        self.until_commanded("nobody", "person_lets_go")

    def test_3_takes_and_lets_go_without_an_order(self):
        self.call("/command/take")
        self.until_commanded("person", "person_takes")
        self.call("/command/let_go")
        self.until_commanded("nobody", "person_lets_go")

    def test_4_a_stop_is_a_persons_and_nothing_goes_on_after_it(self):
        self.call("/stop")
        self.until_commanded("person", "person_stops")
        until(lambda: self.call("/stand"), "the stand")
        self.assertEqual(self.command.message["reason"], "person_stops", "a stand ends what is ended")
        self.call("/command/let_go")
        self.until_commanded("nobody", "person_lets_go")

    def test_5_the_head_looks_where_it_is_told(self):
        self.look(mode="direction", yaw=0.5, pitch=0.1)
        until(lambda: abs(self.joint("neck_yaw") - 0.5) < 0.05, lambda: f"yaw 0.5: {self.joint('neck_yaw')}")
        self.until_commanded("person", "person_orders")
        until(lambda: self.command.message["head"] == "person", "whose the head is")
        self.look(mode="scan", extent=0.4, period=2.0)
        for side in (0.3, -0.3, 0.3):
            until(lambda s=side: (self.joint("neck_yaw") > s if s > 0 else self.joint("neck_yaw") < s),
                  lambda s=side: f"beyond {s}: {self.joint('neck_yaw')}")
        self.look(mode="ahead")
        until(lambda: abs(self.joint("neck_yaw")) < 0.05, lambda: f"ahead: {self.joint('neck_yaw')}")
        answer = roslibpy.Service(self.ros, "/head/look", "gaitway_msgs/Look")
        with self.assertRaisesRegex(Exception, 'mode is "up"'):
            answer.call(roslibpy.ServiceRequest({"mode": "up"}), timeout=20)

    def test_6_an_emergency_stop_is_above_all(self):
        self.call("/emergency_stop", "std_srvs/SetBool", data=False)
        self.until_commanded("emergency_stop", "emergency_stop")
        for service in ("/command/take", "/command/let_go"):
            self.assertIn("emergency stop", self.call(service, success=False))
        self.call("/release")
        self.until_commanded("person", "emergency_stop_released")


if __name__ == "__main__":
    unittest.main()
