"""Every example of docs/api.md does what the page says, on a robot that is served."""
from pathlib import Path

from served_robot import ServedRobot, run_script

with ServedRobot(speed=2.0) as robot:
    run_script("api_examples_test.mjs", robot.port, Path(__file__).parents[2] / "docs" / "api_examples.json")
