"""The user interface module as a real robot has it: the robot is away; its page and its description are there."""
import contextlib
import os
import subprocess
import tempfile
from pathlib import Path

from served_robot import free_port


@contextlib.contextmanager
def module_alone():
    """Gives the port."""
    with tempfile.TemporaryDirectory(prefix="gaitway_page_") as folder:
        port = str(free_port())
        command = [os.environ["GAITWAY_USER_INTERFACE"], "--robot", os.environ["GAITWAY_ROBOT"], "--link", f"unix:{folder}/link.sock",
                   "--port", port, "--stop-port", "0"]
        with subprocess.Popen(command, stderr=subprocess.PIPE, text=True) as module:
            try:
                assert any("serves ws" in line for line in module.stderr), "the module does not serve"
                yield port
            finally:
                module.terminate()


def run_in_browser(script, *arguments, timeout_s=240):
    """A test of the page, in the folder of this file."""
    subprocess.run([os.environ["GAITWAY_NODE"], "--test-reporter=spec", str(Path(__file__).with_name(script)), *arguments], check=True, timeout=timeout_s)
