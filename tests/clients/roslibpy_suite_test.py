"""roslibpy's own tests, as its source archive brings them (./dev setup), against a served robot. What does not apply stands in a
table with its reason, and has to fail: a reason that holds no more fails the run."""
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from served_robot import ServedRobot

SUITE = Path(os.environ["GAITWAY_ROSLIBPY_SUITE"])
PORT_OF_THE_SUITE = "9090"
TRANSPORTS = ["twisted", "asyncio"]
NO_ACTIONS = "the robot has no actions of ROS 2, and clients offer none to each other"
NOT_APPLICABLE = {
    "tests/ros1/test_actionlib.py::test_action_preemt":
        "its cancel lacks a field that rosbridge would add by the message's type; here messages of clients are passed on as they are",
    "tests/ros1/test_param.py": "parameters are those of the robot's plug-ins: clients make none, and delete none",
    "tests/ros1/test_service.py::test_add_two_ints_service":
        "its provider answers result: false and expects a success; here false is a failure, as the protocol says",
    "tests/ros1/test_tf.py": "needs tf2_web_republisher, a node of a ROS graph; the robot publishes /tf",
    "tests/ros2/test_actions.py::test_fibonacci": NO_ACTIONS,
    "tests/ros2/test_actions.py::test_cancel": NO_ACTIONS,
    "tests/test_ws_headers.py": "speaks to a server of its own, with a package that is not installed",
}


def listed(test):
    return any(test == name or test.startswith(name + "::") for name in NOT_APPLICABLE)


class Suite(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        served = ServedRobot()
        robot = served.__enter__()
        cls.addClassCleanup(served.__exit__, None, None, None)
        folder = tempfile.TemporaryDirectory(prefix="gaitway_roslibpy_")
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        shutil.copytree(SUITE / "tests", cls.folder / "tests")
        for file in (cls.folder / "tests").rglob("*.py"):
            file.write_text(file.read_text().replace(PORT_OF_THE_SUITE, str(robot.port)))

    def run_tests(self, transport, *arguments, timeout_s=200):
        """Outcome of each test ("passed", "failed" or "skipped"), and what pytest printed. One process has one transport."""
        report = Path(tempfile.mkdtemp(dir=self.folder)) / "report.xml"
        run = subprocess.Popen([sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", "--rootdir", str(self.folder), f"--junitxml={report}",
                                *arguments], cwd=self.folder, env={**os.environ, "ROSLIBPY_TRANSPORT": transport},
                               stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        try:
            printed, _ = run.communicate(timeout=timeout_s)
        except subprocess.TimeoutExpired:
            run.kill()
            printed, _ = run.communicate()
        outcomes = {}
        if report.exists():
            for case in ElementTree.parse(report).iter("testcase"):
                module, name = case.get("classname"), case.get("name").split("[")[0]  # a file that is skipped is its own case
                test = module.replace(".", "/") + ".py::" + name if module else name.replace(".", "/") + ".py"
                outcomes[test] = ("skipped" if case.find("skipped") is not None else
                                  "passed" if case.find("failure") is None and case.find("error") is None else "failed")
        return outcomes, printed

    def test_what_applies_passes(self):
        leave_out = [argument for name in NOT_APPLICABLE for argument in ("--deselect", name)]
        passed = set()
        skipped = set()
        for transport in TRANSPORTS:
            outcomes, printed = self.run_tests(transport, *leave_out, "tests")
            with self.subTest(transport):
                self.assertGreater(len(outcomes), 30, printed)
                self.assertEqual([test for test, outcome in outcomes.items() if outcome == "failed"], [], printed)
            passed |= {test for test, outcome in outcomes.items() if outcome == "passed"}
            skipped |= {test for test, outcome in outcomes.items() if outcome == "skipped" and not listed(test)}
            print(f"{transport}: {list(outcomes.values()).count('passed')} passed")
        self.assertEqual(sorted(skipped - passed), [], "each runs with one transport at least")

    def test_what_does_not_apply_fails(self):
        with ThreadPoolExecutor(len(NOT_APPLICABLE)) as pool:  # most wait for an answer that never comes
            runs = list(pool.map(lambda name: self.run_tests("twisted", name, timeout_s=25), NOT_APPLICABLE))
        for (name, reason), (outcomes, printed) in zip(NOT_APPLICABLE.items(), runs):
            with self.subTest(name):
                self.assertNotIn("passed", outcomes.values(), f"{name} passes, though it is listed: {reason}\n{printed}")
                self.assertNotIn("not found", printed, f"{name} is listed, but is not there")


if __name__ == "__main__":
    unittest.main(verbosity=2)
