"""Runs the page's test in a browser (page_test.mjs) against a served robot, one that wants a token, and one that is no simulation."""
import contextlib
import os
import subprocess
import tempfile
from pathlib import Path

from served_robot import ServedRobot, free_port

TOKEN = "a-token-for-the-page-4711"


@contextlib.contextmanager
def module_of_a_real_robot(folder):
    """The module as a real robot has it. The robot is away; its page is there. Gives the port."""
    port = str(free_port())
    command = [os.environ["GAITWAY_USER_INTERFACE"], "--robot", os.environ["GAITWAY_ROBOT"], "--link", f"unix:{folder}/link.sock",
               "--port", port, "--stop-port", "0"]
    with subprocess.Popen(command, stderr=subprocess.PIPE, text=True) as module:
        try:
            assert any("serves ws" in line for line in module.stderr), "the module does not serve"
            yield port
        finally:
            module.terminate()


with tempfile.TemporaryDirectory(prefix="gaitway_page_") as folder:
    token_file = Path(folder) / "token"
    token_file.touch(mode=0o600)
    token_file.write_text(TOKEN)
    with ServedRobot() as robot, ServedRobot("--token-file", str(token_file)) as guarded, \
            module_of_a_real_robot(folder) as real_port:
        script = Path(__file__).with_name("page_test.mjs")
        subprocess.run([os.environ["GAITWAY_NODE"], "--test-reporter=spec", str(script), str(robot.port), str(guarded.port), TOKEN, real_port],
                       check=True, timeout=240)
