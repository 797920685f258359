"""Runs the page's test in a browser (page_test.mjs) against a served robot, and one that wants a token."""
import os
import subprocess
import tempfile
from pathlib import Path

from served_robot import ServedRobot

TOKEN = "a-token-for-the-page-4711"

with tempfile.TemporaryDirectory(prefix="gaitway_page_") as folder:
    token_file = Path(folder) / "token"
    token_file.touch(mode=0o600)
    token_file.write_text(TOKEN)
    with ServedRobot() as robot, ServedRobot("--token-file", str(token_file)) as guarded:
        script = Path(__file__).with_name("page_test.mjs")
        subprocess.run([os.environ["GAITWAY_NODE"], "--test-reporter=spec", str(script), str(robot.port), str(guarded.port), TOKEN],
                       check=True, timeout=240)
