"""Runs the tests of the twin's part of the simulator's page in a browser (page_twin_test.mjs, page_twin_stop_test.mjs): the page against a
simulator of the test's own, which has a twin, and the description that the real module serves."""
import os
import subprocess
import tempfile
from pathlib import Path

from served_robot import free_port

with tempfile.TemporaryDirectory(prefix="gaitway_page_twin_") as folder:
    port = str(free_port())
    command = [os.environ["GAITWAY_USER_INTERFACE"], "--robot", os.environ["GAITWAY_ROBOT"], "--link", f"unix:{folder}/link.sock",
               "--port", port, "--stop-port", "0"]
    with subprocess.Popen(command, stderr=subprocess.PIPE, text=True) as module:
        try:
            assert any("serves ws" in line for line in module.stderr), "the module does not serve"
            for name in ("page_twin_test.mjs", "page_twin_stop_test.mjs"):
                script = Path(__file__).with_name(name)
                subprocess.run([os.environ["GAITWAY_NODE"], "--test-reporter=spec", str(script), port], check=True, timeout=140)
        finally:
            module.terminate()
