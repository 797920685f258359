"""Runs roslib's own test (roslib_test.mjs) against a served robot."""
import os
import subprocess
from pathlib import Path

from served_robot import ServedRobot

with ServedRobot(speed=2.0) as robot:
    here = Path(__file__).parent
    environment = dict(os.environ, NODE_PATH=os.environ["GAITWAY_CLIENTS_NODE"] + "/node_modules")
    # An ES module finds its packages from where it lies, so it runs from beside them.
    script = Path(os.environ["GAITWAY_CLIENTS_NODE"]) / "roslib_test.mjs"
    script.write_text((here / "roslib_test.mjs").read_text())
    subprocess.run([os.environ.get("GAITWAY_NODE", "node"), str(script), str(robot.port)], check=True, timeout=240,
                   env=environment)
