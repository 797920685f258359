"""A recorded walk, opened with the MCAP project's own readers and with rosbags: every message of every topic is what was
published, and what a killed recorder leaves behind can be read."""

import collections
import dataclasses
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

from mcap.reader import NonSeekingReader, SeekingReader
from mcap.stream_reader import StreamReader
from mcap_ros2.decoder import DecoderFactory
from rosbags.interfaces import QosDurability
from rosbags.rosbag2 import Reader
from rosbags.typesys import Stores, get_types_from_msg, get_typestore

FULL_RATE = [
    "/joint_states", "/imu/data", "/foot/left/wrench", "/foot/right/wrench", "/zmp", "/com", "/odom", "/tf", "/clock",
]
LATCHED = ["/footsteps", "/motion_state", "/robot_state", "/commander", "/robot_description", "/diagnostics",
           "/walk_to/state", "/command/state", "/behaviour/state", "/behaviour/nodes", "/walk/command", "/link_state", "/certificate_state"]
OF_THE_MODULE = {"/walk/command", "/link_state", "/certificate_state", "/simulation/state", "/simulation/twin"}  # told by the process that faces the network, of itself, or of a simulator
OF_NOBODY = {"/walk_to/state", "/behaviour/state", "/behaviour/nodes"}  # this robot has no plug-ins that walk to places and decide
SECONDS = 5.0


def plain(value):
    """A decoded message as dictionaries, lists, texts and numbers."""
    if isinstance(value, (bool, int, float, str)):
        return value
    if dataclasses.is_dataclass(value):
        return {field.name: plain(getattr(value, field.name)) for field in dataclasses.fields(value)
                if field.name != "__msgtype__"}
    if hasattr(value, "tolist"):
        return value.tolist()
    if hasattr(value, "__slots__"):
        return {name.lstrip("_"): plain(getattr(value, name)) for name in value.__slots__}
    return [plain(element) for element in value]


class Recording(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.work = tempfile.TemporaryDirectory(prefix="gaitway_recording_")
        folder = pathlib.Path(cls.work.name)
        subprocess.run(
            [os.environ["GAITWAY_RECORDED_WALK"], folder, os.environ["GAITWAY_ROBOT"], os.environ["GAITWAY_CONFIG"],
             os.environ["GAITWAY_PLUGIN_DIR"]], check=True)
        cls.file = folder / "walk.mcap"
        with open(folder / "published.jsonl", encoding="utf-8") as lines:
            cls.published = [json.loads(line) for line in lines]

    @classmethod
    def tearDownClass(cls):
        cls.work.cleanup()

    def decoded(self, reader_class, path=None):
        with open(path or self.file, "rb") as stream:
            reader = reader_class(stream, validate_crcs=True, decoder_factories=[DecoderFactory()])
            return [(channel.topic, message, plain(content))
                    for _, channel, message, content in reader.iter_decoded_messages(log_time_order=False)]

    def test_every_message_of_every_topic_is_what_was_published(self):
        for reader_class in (SeekingReader, NonSeekingReader):
            recorded = self.decoded(reader_class)
            self.assertEqual(len(recorded), len(self.published))
            for (topic, message, content), published in zip(recorded, self.published):
                self.assertEqual(topic, published["topic"])
                self.assertEqual(message.log_time, published["robot_ns"])
                self.assertEqual(content, published["msg"], topic)

    def test_rosbags_reads_the_same(self):
        read = collections.defaultdict(list)
        with Reader(self.file) as reader:
            types = {}
            for connection in reader.connections:
                types |= get_types_from_msg(connection.msgdef.data, connection.msgtype)
                quality, = connection.ext.offered_qos_profiles
                latched = connection.topic in LATCHED
                self.assertEqual(quality.durability is QosDurability.TRANSIENT_LOCAL, latched, connection.topic)
            store = get_typestore(Stores.EMPTY)
            store.register(types)
            for connection, time_ns, data in reader.messages():
                read[connection.topic].append((time_ns, plain(store.deserialize_cdr(data, connection.msgtype))))
        published = collections.defaultdict(list)
        for line in self.published:
            published[line["topic"]].append((line["robot_ns"], line["msg"]))
        self.assertEqual(read.keys(), published.keys())
        for topic, messages in published.items():
            self.assertEqual(read[topic], messages, topic)

    def test_every_topic_is_there_at_its_rate(self):
        counts = collections.Counter(topic for topic, _, _ in self.decoded(SeekingReader))
        for topic in FULL_RATE:
            self.assertAlmostEqual(counts[topic] / SECONDS, 100.0, delta=1.0, msg=topic)
        self.assertAlmostEqual(counts["/zmp/reference"] / SECONDS, 100.0, delta=4.0)  # from the first plan on
        self.assertEqual(counts["/diagnostics"], 5)
        self.assertGreaterEqual(counts["/events"], 10)  # of this test, and the robot's own
        self.assertEqual(counts["/robot_description"], 1)
        self.assertGreater(counts["/footsteps"], 10)
        print("rates in Hz:", {topic: count / SECONDS for topic, count in sorted(counts.items())})

    def test_summary_tells_of_all_that_is_in_the_file(self):
        with open(self.file, "rb") as stream:
            summary = SeekingReader(stream, validate_crcs=True).get_summary()
        counts = collections.Counter(line["topic"] for line in self.published)
        self.assertEqual(summary.statistics.message_count, len(self.published))
        self.assertEqual(summary.statistics.chunk_count, len(summary.chunk_indexes))
        self.assertGreater(len(summary.chunk_indexes), 3)
        self.assertEqual(summary.statistics.schema_count, len(summary.schemas))
        for channel in summary.channels.values():
            self.assertEqual(summary.statistics.channel_message_counts.get(channel.id, 0), counts[channel.topic])
            self.assertEqual(channel.message_encoding, "cdr")
            self.assertEqual(summary.schemas[channel.schema_id].encoding, "ros2msg")
        self.assertEqual({channel.topic for channel in summary.channels.values()}, set(counts) | OF_THE_MODULE | OF_NOBODY)

    def test_one_topic_of_one_second_is_found_by_the_index(self):
        with open(self.file, "rb") as stream:
            reader = SeekingReader(stream, validate_crcs=True)
            found = [message.log_time for _, _, message in
                     reader.iter_messages(topics=["/odom"], starting_at=2_000_000_000, ending_before=3_000_000_000)]
        expected = [line["robot_ns"] for line in self.published
                    if line["topic"] == "/odom" and 2_000_000_000 <= line["robot_ns"] < 3_000_000_000]
        self.assertEqual(found, sorted(expected))
        self.assertEqual(len(found), 100)

    def test_the_robot_has_walked_and_stands_in_its_tree_of_frames(self):
        recorded = self.decoded(SeekingReader)
        odometry = [content for topic, _, content in recorded if topic == "/odom"]
        self.assertGreater(odometry[-1]["pose"]["pose"]["position"]["x"], 0.4)
        transforms = next(content for topic, _, content in reversed(recorded) if topic == "/tf")["transforms"]
        parents = {transform["child_frame_id"]: transform["header"]["frame_id"] for transform in transforms}
        frames = {content["header"]["frame_id"] for topic, _, content in recorded
                  if topic in ("/imu/data", "/foot/left/wrench", "/foot/right/wrench", "/zmp", "/com", "/footsteps")}
        for frame in frames | {odometry[-1]["child_frame_id"]}:
            while frame != "odom":
                frame = parents[frame]

    def test_what_a_killed_recorder_leaves_is_readable_up_to_its_last_chunk(self):
        whole = self.file.read_bytes()
        with open(self.file, "rb") as stream:
            chunks = SeekingReader(stream).get_summary().chunk_indexes
        third = chunks[2].chunk_start_offset
        killed = pathlib.Path(self.work.name) / "killed.mcap"
        for end, kept in ((third, 2), (third + 5000, 2), (chunks[3].chunk_start_offset, 3)):
            killed.write_bytes(whole[:end])
            topics = collections.Counter()
            with open(killed, "rb") as stream:
                try:
                    for record in StreamReader(stream, validate_crcs=True).records:
                        topics[type(record).__name__] += 1
                except Exception as error:  # the end is missing
                    self.assertIn("EndOfFile", type(error).__name__)
            expected = sum(1 for line in self.published if line["robot_ns"] < chunks[kept].message_start_time)
            self.assertGreaterEqual(topics["Message"], expected)
            self.assertGreater(expected, 1000)


if __name__ == "__main__":
    unittest.main()
