"""python-can and cantools on the bus of a robot that walks in real time: everything decodes, rates and positions are
what they should be, and what a client sends is counted under its cause and does no harm.

Everything is measured in time slots of the bus, that is, from SYNC to SYNC; the clock on the wall only ends a test
that hangs."""

import collections
import json
import logging
import os
import re
import signal
import subprocess
import tempfile
import time
import unittest

import can
import cantools

ROBOT = os.environ["GAITWAY_ROBOT"]
JOINTS = 22
SLOTS_A_CYCLE = 8
PATIENCE_S = 60.0


def wait_for(what, condition):
    end = time.monotonic() + PATIENCE_S
    while not (result := condition()):
        if time.monotonic() > end:
            raise AssertionError(f"{what} did not come within {PATIENCE_S} s")
        time.sleep(0.02)
    return result


class Robot:
    """virtual_robot, message_controller and main_controller, as they run on a desk."""

    def __init__(self, folder):
        self.folder = folder
        self.processes = []
        robot = self.start("robot", "GAITWAY_VIRTUAL_ROBOT", "--bus", self.path("bus"), "--socketcand", "0")
        self.port = int(
            wait_for("the port", lambda: re.search(r"on port (\d+)", self.output("robot")))[1]
        )
        self.start(
            "message", "GAITWAY_MESSAGE_CONTROLLER", "--bus", self.path("bus"), "--memory", self.path("memory"),
            "--walk", "0.12,0,0", "--walk-after", "2",
        )
        wait_for("the memory block", lambda: os.path.exists(self.path("memory")))
        self.start(
            "main", "GAITWAY_MAIN_CONTROLLER", "--socket", self.path("memory"), "--config",
            os.environ["GAITWAY_CONFIG"], "--plugin-path", os.environ["GAITWAY_PLUGIN_DIR"], summary=False,
        )
        self.robot = robot

    def path(self, name):
        return os.path.join(self.folder, name)

    def start(self, name, program, *arguments, summary=True):
        command = [os.environ[program], "--robot", ROBOT, *arguments]
        if summary:
            command += ["--summary", self.path(name + ".json")]
        with open(self.path(name + ".txt"), "wb") as output:
            process = subprocess.Popen(command, stdout=output, stderr=subprocess.STDOUT)
        self.processes.append(process)
        return process

    def output(self, name):
        with open(self.path(name + ".txt"), encoding="utf-8", errors="replace") as text:
            return text.read()

    def everything(self):
        return "".join(f"\n--- {name}\n{self.output(name)}" for name in ("robot", "message", "main"))

    def summary(self, name):
        with open(self.path(name + ".json"), encoding="utf-8") as text:
            return json.load(text)

    def stop(self):
        codes = []
        for process in reversed(self.processes):
            process.send_signal(signal.SIGTERM)
            codes.append(process.wait(PATIENCE_S))
        return codes

    def kill(self):
        for process in self.processes:
            if process.poll() is None:
                process.kill()
                process.wait()


def attach(port):
    """python-can takes what comes with an answer for the answer; the server leaves it time, a busy machine may not."""
    for attempt in range(5):
        try:
            return can.Bus(interface="socketcand", host="127.0.0.1", port=port, channel="can0")
        except can.CanError:
            if attempt == 4:
                raise


class Listener:
    """Takes all frames from the bus, up to a number of time slots."""

    def __init__(self, port, known):
        self.bus = attach(port)
        self.known = known
        self.sync = known.get_message_by_name("SYNC").frame_id
        self.messages = []

    def hear(self, slots=None, until=None):
        """The messages of so many slots, or of all slots until a message fulfils a condition."""
        heard = []
        left = slots if slots is not None else 3000
        while left > 0:
            message = self.bus.recv(PATIENCE_S)
            if message is None:
                raise AssertionError(f"the bus was silent for {PATIENCE_S} s")
            heard.append(message)
            if message.arbitration_id == self.sync and not message.is_extended_id:
                left -= 1
            if until is not None and until(message):
                break
        else:
            if until is not None:
                raise AssertionError("what was waited for did not come within 3000 time slots")
        self.messages += heard
        return heard

    def decode(self, message):
        return self.known.decode_message(message.arbitration_id, message.data, decode_choices=False)


class LiveBus(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        logging.getLogger("can").setLevel(logging.ERROR)  # it warns of every frame that comes in two pieces
        os.nice(5)  # the robot's processes keep a clock, this one does not
        cls.known = cantools.database.load_file(os.environ["GAITWAY_DBC"])
        with tempfile.TemporaryDirectory() as folder:
            robot = Robot(folder)
            try:
                cls.attend(robot)
                cls.codes = robot.stop()
                cls.robot, cls.message = robot.summary("robot"), robot.summary("message")
                cls.everything = robot.everything()
            except BaseException:
                print(robot.everything())
                raise
            finally:
                robot.kill()

    @classmethod
    def attend(cls, robot):
        listener = Listener(robot.port, cls.known)
        witness = Listener(robot.port, cls.known)
        heartbeat = cls.known.get_message_by_name("heartbeat").frame_id
        trajectory = cls.known.get_message_by_name("trajectory_0_left_knee")

        def mode_is(mode):
            return lambda m: m.arbitration_id == heartbeat and listener.decode(m)["mode"] == mode

        def moves(message):
            return message.arbitration_id == trajectory.frame_id and any(listener.decode(message).values())

        listener.hear(until=moves)
        cls.walk = listener.hear(slots=500)
        cls.injected = []
        for number in range(20):
            cls.inject(listener.bus, number)
            listener.hear(slots=3)
        cls.walk_on = listener.hear(slots=200)
        cls.witnessed = witness.hear(slots=900)
        # A frame that claims to come from the message controller.
        listener.bus.send(
            can.Message(arbitration_id=trajectory.frame_id, data=bytes(8), is_extended_id=False)
        )
        cls.after_forgery = listener.hear(until=mode_is(1))  # safe_tail
        cls.after_forgery += listener.hear(slots=300)
        listener.bus.shutdown()
        witness.bus.shutdown()

    @classmethod
    def inject(cls, bus, number):
        feedback = cls.known.get_message_by_name("feedback_left_elbow").frame_id
        frames = [
            can.Message(arbitration_id=0x7A5, data=[number, 1, 2], is_extended_id=False),
            can.Message(arbitration_id=0x1ABCDE0, data=[number], is_extended_id=True),
            can.Message(arbitration_id=0x008, is_extended_id=True, data=[number, 0, 0]),
            can.Message(arbitration_id=feedback, dlc=8, is_remote_frame=True, is_extended_id=False),
            can.Message(arbitration_id=feedback, data=[number], is_extended_id=False),
        ]
        for frame in frames:
            bus.send(frame)
        cls.injected += frames

    # What was received.

    def slots(self, messages):
        """The messages from each SYNC to the next, and what the SYNC said."""
        slots = []
        sync = self.known.get_message_by_name("SYNC")
        for message in messages:
            if message.arbitration_id == sync.frame_id:
                slots.append((sync.decode(message.data), message.timestamp, []))
            elif slots:
                slots[-1][2].append(message)
        return slots[:-1]  # the last one is not whole

    def name(self, message):
        return self.known.get_message_by_frame_id(message.arbitration_id).name

    def test_every_frame_of_the_robot_decodes(self):
        self.assertGreater(len(self.walk), 500 * JOINTS)
        for message in self.walk + self.walk_on + self.after_forgery:
            self.known.decode_message(message.arbitration_id, message.data)

    def test_sync_counts_the_slots_and_comes_with_them(self):
        slots = self.slots(self.walk)
        steps = [
            ((b[0]["cycle"] * SLOTS_A_CYCLE + b[0]["slot"]) - (a[0]["cycle"] * SLOTS_A_CYCLE + a[0]["slot"]))
            % (65536 * SLOTS_A_CYCLE)
            for a, b in zip(slots, slots[1:])
        ]
        self.assertGreaterEqual(steps.count(1), 0.98 * len(steps), collections.Counter(steps))
        distances = [b[1] - a[1] for a, b in zip(slots, slots[1:])]
        regular = [d for d in distances if abs(d - 0.010) < 0.001]  # by the clock of the bus
        self.assertGreaterEqual(len(regular), 0.95 * len(distances))

    def test_every_joint_answers_each_sync_once(self):
        slots = self.slots(self.walk)
        feedback = {m.frame_id for m in self.known.messages if m.name.startswith("feedback_")}
        self.assertEqual(len(feedback), JOINTS)
        complete = 0
        for _, _, messages in slots:
            counted = collections.Counter(m.arbitration_id for m in messages if m.arbitration_id in feedback)
            complete += counted.keys() == feedback and set(counted.values()) == {1}
        self.assertGreaterEqual(complete, 0.97 * len(slots))

    def test_every_joint_gets_a_batch_a_cycle_with_toggles_in_turn(self):
        cycles = len(self.slots(self.walk)) / SLOTS_A_CYCLE
        sequences = collections.defaultdict(list)
        for message in self.walk:
            match = re.fullmatch(r"trajectory_([01])_(\w+)", self.name(message))
            if match:
                sequences[match[2]].append(match[1])
        self.assertEqual(len(sequences), JOINTS)
        for joint, toggles in sequences.items():
            self.assertAlmostEqual(len(toggles), cycles, delta=2 + 0.05 * cycles, msg=joint)
            in_turn = sum(a != b for a, b in zip(toggles, toggles[1:]))
            self.assertGreaterEqual(in_turn, 0.95 * (len(toggles) - 1), joint)

    def test_positions_stay_within_the_joints_limits_while_the_robot_walks(self):
        margin_deg = 1.0
        angles = collections.defaultdict(list)
        for message in self.walk + self.walk_on:
            if self.name(message).startswith("feedback_"):
                decoded = self.known.decode_message(message.arbitration_id, message.data)
                angles[self.name(message)].append(decoded["position"])
        self.assertEqual(len(angles), JOINTS)
        for name, values in angles.items():
            limits = self.known.get_message_by_name(name).get_signal_by_name("position")
            self.assertGreaterEqual(min(values), limits.minimum - margin_deg, name)
            self.assertLessEqual(max(values), limits.maximum + margin_deg, name)
        for knee in ("feedback_left_knee", "feedback_right_knee"):
            self.assertGreater(max(angles[knee]) - min(angles[knee]), 5.0, "it walks")

    def test_the_force_cells_carry_the_robot(self):
        sums = collections.Counter()
        for message in self.walk:
            for name, value in self.known.decode_message(message.arbitration_id, message.data).items():
                if "_cell_" in name:
                    sums[name] += value
        self.assertEqual(len(sums), 8)
        weight_N = 6.84 * 9.81
        self.assertAlmostEqual(sum(sums.values()) / 500, weight_N, delta=0.25 * weight_N)

    def test_another_client_sees_what_a_client_sends_but_remote_frames(self):
        kept = collections.Counter(
            (m.arbitration_id, m.is_extended_id, bytes(m.data)) for m in self.witnessed
        )
        for sent in self.injected:
            if not sent.is_remote_frame:  # the protocol has no words for them
                self.assertGreaterEqual(kept[(sent.arbitration_id, sent.is_extended_id, bytes(sent.data))], 1, sent)

    def test_what_was_sent_is_counted_under_its_cause(self):
        network = self.message["network"]
        self.assertEqual(network["unknown_identifiers"], 20)
        self.assertEqual(network["extended_frames"], 40)
        self.assertEqual(network["remote_frames"], 20)
        self.assertEqual(network["wrong_lengths"], 20)
        self.assertEqual(network["forged"], 1)
        self.assertEqual(self.robot["socketcand"]["frames"], len(self.injected) + 1)
        self.assertEqual(self.robot["socketcand"]["rejected_commands"], 0)
        self.assertEqual(self.robot["socketcand"]["not_reading"], 0)

    def test_the_robot_walks_on_and_ends_well(self):
        self.assertEqual(self.codes, [0, 0, 0], self.everything)
        self.assertFalse(self.robot["fell"], self.everything)
        self.assertGreater(self.robot["distance_m"], 0.3, self.everything)
        modes = {
            str(self.known.decode_message(m.arbitration_id, m.data)["mode"])
            for m in self.walk_on
            if self.name(m) == "heartbeat"
        }
        self.assertEqual(modes, {"batches"}, "bad frames do not stop it")


if __name__ == "__main__":
    unittest.main(verbosity=2)
