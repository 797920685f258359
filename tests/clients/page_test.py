"""Runs the page's test in a browser (page_test.mjs) against a served robot, one that wants a token, and one that is no simulation."""
import tempfile
from pathlib import Path

from module_alone import module_alone, run_in_browser
from served_robot import ServedRobot

TOKEN = "a-token-for-the-page-4711"

with tempfile.TemporaryDirectory(prefix="gaitway_page_") as folder:
    token_file = Path(folder) / "token"
    token_file.touch(mode=0o600)
    token_file.write_text(TOKEN)
    with ServedRobot() as robot, ServedRobot("--token-file", str(token_file)) as guarded, module_alone() as real_port:
        run_in_browser("page_test.mjs", str(robot.port), str(guarded.port), TOKEN, real_port)
