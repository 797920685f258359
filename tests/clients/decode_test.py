"""cantools with the generated .dbc files reads the same values in a frame as our codecs do."""

import json
import os
import subprocess
import tempfile
import unittest

import cantools

GAITWAY = os.environ["GAITWAY_COMMAND"]
CODEC_FRAMES = os.environ["GAITWAY_CODEC_FRAMES"]


def database(profile):
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "robot.dbc")
        subprocess.run([GAITWAY, "bus", "dbc", "--profile", profile, "--out", file], check=True)
        return cantools.database.load_file(file, strict=True)


def codec_frames(profile, nodes):
    output = subprocess.run(
        [CODEC_FRAMES, "values", profile, str(nodes), "11"], check=True, capture_output=True, text=True
    ).stdout
    return [json.loads(line) for line in output.splitlines()]


class Decode(unittest.TestCase):
    def compare(self, profile, nodes, identifiers):
        known = database(profile)
        frames = codec_frames(profile, nodes)
        self.assertEqual({frame["id"] for frame in frames}, {message.frame_id for message in known.messages})
        self.assertEqual(len(known.messages), identifiers)
        for frame in frames:
            message = known.get_message_by_frame_id(frame["id"])
            data = bytes(frame["data"])
            self.assertEqual(message.length, len(data), message.name)
            raw = message.decode(data, decode_choices=False, scaling=False)
            self.assertEqual(
                sorted([signal.start, raw[signal.name]] for signal in message.signals),
                sorted(frame["fields"]),
                f"{message.name} {data.hex()}",
            )

    def test_every_message_of_the_full_profile_reads_as_our_codecs_read_it(self):
        self.compare("full", 22, 5 + 22 * (5 + 6))

    def test_every_message_of_the_papers_profile_reads_as_our_codecs_read_it(self):
        self.compare("paper", 12, 25)

    def test_positions_are_in_degrees_and_states_have_names(self):
        known = database("full")
        decoded = known.decode_message("feedback_left_knee", bytes([0x00, 0x40, 0xF8, 0x40, 0, 0, 0, 0]))
        self.assertEqual(decoded["position"], 90.0)
        self.assertEqual(decoded["current"], -1.0)
        self.assertEqual(decoded["state"], "holding")

    def test_every_periodic_message_has_its_cycle_time_and_the_others_a_smallest_distance(self):
        known = database("full")
        self.assertEqual(known.get_message_by_name("SYNC").cycle_time, 10)
        self.assertEqual(known.get_message_by_name("feedback_left_knee").cycle_time, 10)
        self.assertEqual(known.get_message_by_name("trajectory_0_left_knee").cycle_time, 160)
        self.assertEqual(known.get_message_by_name("heartbeat").cycle_time, 80)
        stop = known.get_message_by_name("emergency_stop")
        self.assertFalse(stop.cycle_time)
        self.assertEqual(stop.dbc.attributes["GenMsgDelayTime"].value, 10)
        self.assertEqual(stop.dbc.attributes["GaitwayDeadline"].value, 4000)


if __name__ == "__main__":
    unittest.main(verbosity=2)
