"""`gaitway simulator`, on a port of its own, for the tests of its API's clients."""
import os
import re
import signal
import subprocess
import tempfile
import threading
from pathlib import Path

from served_robot import free_port, until

COMMAND = os.environ["GAITWAY_COMMAND"]


class Simulator:
    """`gaitway simulator` on a port of its own, until it is left."""

    def __init__(self, *arguments):
        self._folder = tempfile.TemporaryDirectory(prefix="gaitway_simulator_")
        self.out = Path(self._folder.name)
        self._command = [COMMAND, "simulator", "--port", str(free_port()), "--out", self._folder.name, "--quiet", *arguments]
        self.lines = []
        self.port = None

    def __enter__(self):
        self.process = subprocess.Popen(self._command, stderr=subprocess.STDOUT, stdout=subprocess.PIPE, text=True)
        self._reader = threading.Thread(target=self._follow, daemon=True)
        self._reader.start()
        until(lambda: self.port is not None or self.process.poll() is not None, "the simulator's address")
        assert self.port is not None, "\n".join(self.lines)
        return self

    def _follow(self):
        for line in self.process.stdout:
            self.lines.append(line.rstrip())
            if found := re.search(r"serves wss?://[^ ]*:(\d+)", line):
                self.port = int(found.group(1))

    def __exit__(self, *_):
        self.process.send_signal(signal.SIGINT)
        self.process.wait(60)
        self._reader.join(10)
        self.process.stdout.close()
        self._folder.cleanup()
