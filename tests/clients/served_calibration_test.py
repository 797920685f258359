"""A served robot plays the standing poses, and the log of its bus tells its joints' zeros."""
import json
import os
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

from served_robot import COMMAND, ServedRobot, until

SEED = "3"
POSES = Path(__file__).parents[2] / "tools" / "calibrate" / "poses" / "standing.yaml"
SERVE = Path(os.environ["GAITWAY_CONFIG"]).parent / "serve.yaml"


def gaitway(*arguments):
    result = subprocess.run([COMMAND, *map(str, arguments)], capture_output=True, text=True, timeout=200)
    return result.returncode, result.stdout, result.stderr


def true_zeros_deg():
    """Those that the seed has drawn, by joint: the column beside what the simulated calibration finds."""
    _, report, _ = gaitway("calibrate", "--simulate", "--seed", SEED, "--rounds", "1")
    row = r"^  (\w+_\w+) +-?[\d.]+ ± [\d.]+ +deg +\d+ % +(-?[\d.]+)"
    return {name: float(truth) for name, truth in re.findall(row, report, re.M)}


class ServedCalibration(unittest.TestCase):
    def ctl(self, *arguments):
        return gaitway("ctl", "--url", f"ws://127.0.0.1:{self.robot.port}", *arguments)

    def motions_ended(self):
        code, said, complaint = self.ctl("echo", "/motion_state")
        self.assertEqual(code, 0, said + complaint)
        return json.loads(said)["ended"]

    def stands_s(self):
        code, said, complaint = self.ctl("echo", "/joint_states")
        self.assertEqual(code, 0, said + complaint)
        return json.loads(said)["header"]["stamp"]["sec"]

    def test_finds_the_zeros(self):
        with tempfile.TemporaryDirectory(prefix="gaitway_calibration_") as name:
            folder = Path(name)
            code, _, complaint = gaitway("motion", "prepare", POSES, "--out", folder / "motions")
            self.assertEqual(code, 0, complaint)
            config = SERVE.read_text()
            library = "library: libgaitway_plugin_trajectory.so"
            self.assertEqual(config.count(library), 1)
            motions = f"{library}\n    parameters: {{motions: {folder}/motions}}"
            (folder / "serve.yaml").write_text(config.replace(library, motions))
            with ServedRobot("--bus-log", "--seed", SEED, "--mismatch", "1", "--config", str(folder / "serve.yaml"),
                             speed=6.0) as self.robot:
                until(lambda: self.stands_s() >= 5, "the soles to be turned flat by the balance feedback")
                until(lambda: self.ctl("play", "standing")[0] == 0, "the beginning of the poses")
                until(lambda: self.motions_ended() == 1, "the end of the poses", timeout_s=150)
                self.robot.stop()
                self.assertFalse(self.robot.summary["fell"])
                log = self.robot.out / "bus.log"
                code, said, complaint = gaitway("calibrate", "--bus-log", log, "--weighed-kg", "6.665",
                                                "--out", folder / "found.yaml")
            self.assertEqual(code, 0, said + complaint)
            found = (folder / "found.yaml").read_text()
        truth = true_zeros_deg()
        legs = [joint for joint in truth if re.search("hip|knee|ankle", joint)]
        self.assertEqual(len(legs), 12)
        zero = {joint: float(re.search(rf"{joint}: {{value: (-?[\d.e-]+)", found).group(1)) for joint in legs}
        before = sum(truth[joint] ** 2 for joint in legs)
        after = sum((zero[joint] - truth[joint]) ** 2 for joint in legs)
        self.assertLess(after, 0.1 * before, (zero, truth))


if __name__ == "__main__":
    unittest.main()
