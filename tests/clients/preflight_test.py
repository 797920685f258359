"""`gaitway preflight` against a robot that is served: what all simulated robots bear is sent, what they do not is not, unless somebody gives a reason."""
import json
import subprocess
import tempfile
import unittest
from pathlib import Path

from served_robot import COMMAND, ServedRobot


class Preflight(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="gaitway_preflight_")
        cls.addClassCleanup(cls.folder.cleanup)
        cls.robot = ServedRobot("--world", "empty").__enter__()
        cls.addClassCleanup(cls.robot.__exit__, None, None, None)

    def preflight(self, *arguments, code, out=None):
        result = subprocess.run([COMMAND, "preflight", "--from", f"ws://127.0.0.1:{self.robot.port}", "--robots", "2", "--out", out or self.folder.name, *arguments],
                                capture_output=True, text=True, timeout=120)
        self.assertEqual(result.returncode, code, result.stdout + result.stderr)
        return result.stdout + result.stderr

    def sent(self):
        return [json.loads(line) for line in (Path(self.folder.name) / "sent.jsonl").read_text().splitlines()]

    def base_x(self):
        echo = subprocess.run([COMMAND, "ctl", "--port", str(self.robot.port), "echo", "/odom", "--count", "1"], capture_output=True, text=True, timeout=60)
        return json.loads(echo.stdout)["pose"]["pose"]["position"]["x"]

    def test_what_all_bear_is_sent(self):
        before = self.base_x()
        self.assertIn("done", self.preflight("--walk", "0.12", "--seconds", "6", "--send", code=0))
        self.assertGreater(self.base_x(), before + 0.2)
        self.assertEqual((self.sent()[-1]["outcome"], self.sent()[-1]["passed"]), ("done", 2))
        self.assertTrue((Path(self.folder.name) / "worst.png").stat().st_size > 10_000)

    def test_what_fells_one_is_not_sent_without_a_reason(self):
        before = self.base_x()
        falls = ["--walk", "0.3", "--mismatch", "10", "--seconds", "10", "--send"]
        self.assertIn("--override REASON", self.preflight(*falls, code=2))
        self.assertAlmostEqual(self.base_x(), before, delta=0.01)
        self.assertEqual(self.sent()[-1]["outcome"], "not sent")
        self.assertIn("10 characters", self.preflight(*falls, "--override", "because", code=1))
        gentle = ["--walk", "0.05", "--mismatch", "10", "--seconds", "4", "--send", "--override", "held by its crane"]
        self.preflight(*gentle, code=0)
        self.assertEqual((self.sent()[-1]["outcome"], self.sent()[-1]["override"]), ("done", "held by its crane"))

    def test_on_a_full_disk_nothing_is_sent_since_it_could_not_be_put_on_record(self):
        before = self.base_x()
        with tempfile.TemporaryDirectory() as full:
            (Path(full) / "sent.jsonl").symlink_to("/dev/full")
            said = self.preflight("--walk", "0.12", "--seconds", "4", "--send", code=1, out=full)
            self.assertIn("sent.jsonl: what is sent must be on record, and cannot be written: No space left", said)
        self.assertAlmostEqual(self.base_x(), before, delta=0.01)

    def test_a_motion_is_played_to_its_end(self):
        self.preflight("--motion", "wave", "--seconds", "10", "--send", code=0)
        state = subprocess.run([COMMAND, "ctl", "--port", str(self.robot.port), "echo", "/motion_state", "--count", "1"], capture_output=True, text=True, timeout=60)
        self.assertEqual(json.loads(state.stdout)["result"], "finished")

    def test_another_robot_is_told_by_its_joints(self):
        with tempfile.TemporaryDirectory() as other:
            subprocess.run(["cp", "-rL", str(Path(__file__).parents[2] / "urdf/humanoid22") + "/.", other], check=True)
            for name in ("robot.urdf", "robot.yaml", "fall_postures.yaml"):
                file = Path(other) / name
                if file.exists():
                    file.write_text(file.read_text().replace("neck_yaw", "neck_turn"))
            said = self.preflight("--walk", "0.1", "--robot", other, code=1)
            self.assertIn("neck_turn", said)


if __name__ == "__main__":
    unittest.main()
