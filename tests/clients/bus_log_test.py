"""Bus logs open with can-utils and python-can, and hold what went over the bus."""

import os
import re
import subprocess
import tempfile
import unittest

import can
import cantools

GAITWAY = os.environ["GAITWAY_COMMAND"]
CODEC_FRAMES = os.environ["GAITWAY_CODEC_FRAMES"]
DBC = os.environ["GAITWAY_DBC"]


def log2asc(log):
    """The lines of can-utils' converter that stand for frames."""
    result = subprocess.run(["log2asc", "-I", log, "can0"], check=True, capture_output=True, text=True)
    return [line.split() for line in result.stdout.splitlines() if re.match(r"\s*\d+\.\d+\s", line)]


class LogOfARun(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        subprocess.run(
            [GAITWAY, "run", "--seconds", "3", "--no-pictures", "--quiet", "--out", cls.folder.name], check=True
        )
        cls.log = os.path.join(cls.folder.name, "bus.log")
        with open(cls.log, encoding="ascii") as lines:
            cls.lines = [re.fullmatch(r"\((\d+\.\d{6})\) can0 ([0-9A-F]{3})#([0-9A-F]*)", line.rstrip()) for line in lines]
        assert all(cls.lines) and len(cls.lines) > 6000, "a busy bus"

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_python_can_reads_every_frame_and_cantools_decodes_it(self):
        known = cantools.database.load_file(DBC)
        messages = list(can.CanutilsLogReader(self.log))
        self.assertEqual(len(messages), len(self.lines))
        for message, line in zip(messages, self.lines):
            self.assertAlmostEqual(message.timestamp, float(line[1]), places=6)
            self.assertEqual(message.arbitration_id, int(line[2], 16))
            self.assertEqual(message.data, bytes.fromhex(line[3]))
            self.assertFalse(message.is_extended_id or message.is_remote_frame or message.is_error_frame)
            known.decode_message(message.arbitration_id, message.data)

    def test_can_utils_converts_every_frame(self):
        converted = log2asc(self.log)
        self.assertEqual(len(converted), len(self.lines))
        for words, line in zip(converted, self.lines):
            # time, channel, identifier, direction, "d", number of bytes, bytes
            self.assertEqual(int(words[2], 16), int(line[2], 16))
            self.assertEqual(words[4:6], ["d", str(len(line[3]) // 2)])
            self.assertEqual("".join(words[6:]), line[3])


class LogWithEveryKindOfLine(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.log = os.path.join(self.folder.name, "every.log")
        subprocess.run([CODEC_FRAMES, "log", self.log], check=True)

    def test_python_can_knows_extended_and_remote_frames_and_errors(self):
        messages = list(can.CanutilsLogReader(self.log))
        self.assertEqual(
            [(m.arbitration_id, m.is_extended_id, m.is_remote_frame, m.is_error_frame) for m in messages],
            [
                (0x123, False, False, False),
                (0x7FF, False, False, False),
                (0x123, True, False, False),
                (0x1FFFFFFF, True, False, False),
                (0x45, False, True, False),
                (0x46, False, True, False),
                (0x12345, True, True, False),
                (messages[7].arbitration_id, True, False, True),
            ],
        )
        self.assertEqual([m.dlc for m in messages[:7]], [8, 0, 2, 0, 8, 0, 3])
        self.assertEqual(messages[0].data, bytes([1, 2, 3, 4, 5, 6, 7, 0xFF]))

    def test_can_utils_knows_extended_and_remote_frames_and_errors(self):
        converted = log2asc(self.log)
        self.assertEqual(
            [words[2] for words in converted],
            ["123", "7FF", "123x", "1FFFFFFFx", "45", "46", "12345x", "ErrorFrame"],
        )
        self.assertEqual([words[4] for words in converted[:7]], ["d", "d", "d", "d", "r", "r", "r"])


if __name__ == "__main__":
    unittest.main(verbosity=2)
