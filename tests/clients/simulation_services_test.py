"""roslibpy, as it comes from the registry, has the time and the world of `gaitway simulator`: state, pause, step, seek, reset,
a plan, a fault, and what is spawned, moved and removed by services of simulation_interfaces."""
import subprocess
import unittest

import roslibpy

from served_robot import until
from simulator import COMMAND, Simulator

OK, NOT_FOUND, FAILED = 1, 2, 4  # codes of simulation_interfaces/msg/Result
STOPPED, PLAYING, PAUSED = 0, 1, 2  # of simulation_interfaces/msg/SimulationState


class SimulationServices(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.simulator = Simulator("--world", "boxes", "--paused").__enter__()
        cls.addClassCleanup(cls.simulator.__exit__, None, None, None)
        cls.ros = roslibpy.Ros("127.0.0.1", cls.simulator.port)
        cls.ros.run(timeout=20)
        cls.addClassCleanup(cls.ros.terminate)
        cls.state = None
        cls.states = 0
        cls.topic = roslibpy.Topic(cls.ros, "/simulation/state", "gaitway_msgs/msg/SimulationState")
        cls.topic.subscribe(cls.take)

    @classmethod
    def take(cls, state):
        cls.state = state
        cls.states += 1

    def call(self, service, **arguments):
        name = "/simulation/" + service
        kind = self.ros.get_service_type(name)
        return dict(roslibpy.Service(self.ros, name, kind).call(roslibpy.ServiceRequest(arguments), timeout=20))

    def result(self, service, **arguments):
        result = self.call(service, **arguments)["result"]
        return result["result"], result["error_message"]

    def set_state(self, state):
        return self.result("set_simulation_state", state={"state": state})

    def simulation_state(self):
        return self.call("get_simulation_state")["state"]["state"]

    def reset(self):
        if self.simulation_state() != STOPPED:
            self.assertEqual(self.set_state(STOPPED), (OK, ""))

    def setUp(self):
        self.reset()

    def pose_of(self, entity):
        answer = self.call("get_entity_state", entity=entity)
        self.assertEqual(answer["result"]["result"], OK, answer["result"])
        return answer["state"]["pose"]

    def test_the_state_comes_ten_times_a_second_while_it_is_paused(self):
        before = self.states
        until(lambda: self.states >= before + 10, "ten states")
        self.assertEqual(self.state["state"], "paused")
        self.assertEqual(self.state["time"], 0.0)
        self.assertEqual(self.state["world"], "boxes")
        self.assertEqual(len(self.state["base"]), 7)
        self.assertEqual(len(self.state["odometry"]), 4)

    def test_time_is_had_by_play_pause_step_and_seek(self):
        self.assertEqual(self.simulation_state(), STOPPED)
        self.assertEqual(self.result("step_simulation", steps=80), (OK, ""))
        self.assertEqual(self.simulation_state(), PAUSED)
        until(lambda: self.state["time"] == 0.08, "80 ms")
        self.assertTrue(self.call("set_speed", speed=5.0)["success"])
        self.assertEqual(self.set_state(PLAYING), (OK, ""))
        until(lambda: self.state["time"] > 1.0, "a second")
        self.assertEqual(self.result("step_simulation")[0], FAILED)
        self.assertEqual(self.set_state(PAUSED), (OK, ""))
        until(lambda: self.state["state"] == "paused", "the pause")
        base = self.pose_of("robot")
        recorded, run = self.state["recorded"], self.state["run"]
        back = self.call("seek", time=0.5)
        self.assertEqual((back["success"], back["time"]), (True, 0.5))
        until(lambda: self.state["time"] == 0.5 and self.state["run"] > run, "the instant")
        self.assertEqual(self.state["recorded"], recorded)
        late = self.call("seek", time=recorded + 1.0)
        self.assertFalse(late["success"])
        self.assertIn("time_s", late["message"])
        there = self.call("seek", time=recorded)
        self.assertTrue(there["success"], there)
        self.assertEqual(self.pose_of("robot"), base, "to the bit")
        self.assertEqual(self.result("reset_simulation", scope=255), (OK, ""))
        self.assertEqual(self.simulation_state(), STOPPED)

    def test_things_come_move_and_go(self):
        entities = self.call("get_entities")["entities"]
        self.assertEqual(entities[0], "robot")
        self.assertGreater(len(entities), 3)
        spawned = self.call("spawn_entity", name="crate", entity_resource={"uri": "gaitway:box?size=0.1,0.1,0.1&mass=0.5"},
                            initial_pose={"pose": {"position": {"x": -1.0, "y": 0.5, "z": 0.5}}})
        self.assertEqual((spawned["result"]["result"], spawned["entity_name"]), (OK, "crate"), spawned["result"])
        self.assertIn("crate", self.call("get_entities")["entities"])
        self.assertEqual(self.result("step_simulation", steps=200), (OK, ""))
        fallen = self.call("get_entity_state", entity="crate")["state"]
        self.assertAlmostEqual(fallen["pose"]["position"]["z"], 0.5 - 9.81 * 0.2**2 / 2, delta=0.01)
        self.assertEqual(self.result("step_simulation", steps=20), (OK, ""))
        moves = self.call("get_entity_state", entity="crate")["state"]["twist"]["linear"]
        self.assertAlmostEqual(moves["z"], -9.81 * 0.21, delta=0.1)
        self.assertEqual(self.result("set_entity_state", entity="crate", set_pose=True,
                                     state={"pose": {"position": {"x": -1.0, "y": 1.0, "z": 0.05}}}), (OK, ""))
        self.assertEqual(self.result("step_simulation", steps=10), (OK, ""))
        self.assertAlmostEqual(self.pose_of("crate")["position"]["y"], 1.0, delta=1e-3)
        info = self.call("get_entity_info", entity="crate")["info"]
        self.assertEqual(info["category"]["category"], 0)
        self.assertEqual(self.result("spawn_entity", name="inside", entity_resource={"uri": "gaitway:sphere?mass=1"},
                                     initial_pose={"pose": {"position": {"x": self.state["base"][0], "y": 0.0, "z": 0.3}}})[0], FAILED)
        self.assertEqual(self.result("delete_entity", entity="crate"), (OK, ""))
        self.assertEqual(self.result("delete_entity", entity="crate")[0], NOT_FOUND)

    def test_after_a_seek_another_thing_is_another_world(self):
        for name in ("first", "second"):
            event = "{spawn: {name: %s, shape: box, size_m: [0.1, 0.1, 0.1], position_m: [-1.5, 0, 0.05]}}" % name
            applied = self.call("apply", event=event)
            self.assertTrue(applied["success"], applied["message"])
            self.assertEqual(self.result("step_simulation", steps=10), (OK, ""))
            entities = self.call("get_entities")["entities"]
            self.assertEqual([one for one in ("first", "second") if one in entities], [name])
            self.reset()

    def test_a_way_is_planned_and_the_world_is_told(self):
        plan = self.call("plan", x=0.6, y=0.0, yaw=0.0)
        self.assertTrue(plan["success"], plan["message"])
        self.assertEqual(len(plan["feet"]), 6)
        self.assertGreater(len(plan["steps"]), 9)
        self.assertGreater(plan["duration"], 1.0)
        geometry = self.call("geometry", first=0)
        self.assertEqual(geometry["total"], len(geometry["solids"]))
        inside = next(solid for solid in geometry["solids"] if solid["kind"] == "box")["pose"]["position"]
        refused = self.call("plan", x=inside["x"], y=inside["y"], yaw=0.0)
        self.assertFalse(refused["success"])
        self.assertTrue(refused["message"])

    def test_events_of_scenarios_are_applied(self):
        self.assertTrue(self.call("apply", event="{fault: {kind: jam, duration_s: 0.01}}")["success"])
        wrong = self.call("apply", event="{fault: {kind: jan}}")
        self.assertFalse(wrong["success"])
        self.assertIn("jam", wrong["message"])
        self.assertEqual(self.result("step_simulation", steps=10), (OK, ""))
        until(lambda: "fault" in self.state["mark_kinds"], "the mark")
        self.assertIn("jam", self.state["event_texts"][0])

    def test_it_says_what_it_can(self):
        features = self.call("get_simulator_features")["features"]
        self.assertIn(0, features["features"])
        self.assertEqual(self.call("get_current_world")["world"]["name"], "boxes")
        self.assertIn("/simulation/state", self.ros.get_topics())


if __name__ == "__main__":
    unittest.main(verbosity=2)
