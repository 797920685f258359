"""A robot under `gaitway serve`, on a port of its own, for the tests of its API's clients."""
import json
import os
import re
import signal
import socket
import subprocess
import tempfile
import threading
import time
from pathlib import Path

COMMAND = os.environ["GAITWAY_COMMAND"]


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class ServedRobot:
    """Starts on entry, stops (as by Ctrl-C) and leaves `summary` on exit. `speed`: times real time."""

    def __init__(self, *arguments, speed=1.0):
        self._folder = tempfile.TemporaryDirectory(prefix="gaitway_api_")
        self.out = Path(self._folder.name) / "out"
        self.speed = speed
        # Clients come back to the port that they know, so it is the same after the API was started again.
        self._command = [COMMAND, "serve", "--port", str(free_port()), "--speed", str(speed), "--out", str(self.out), *arguments]
        self.lines = []
        self.ports = []  # one for each time that the API came up
        self._news = threading.Condition()

    def __enter__(self):
        self.process = subprocess.Popen(self._command, stderr=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        self._readers = [threading.Thread(target=self._follow, args=(stream,), daemon=True)
                         for stream in (self.process.stderr, self.process.stdout)]
        for reader in self._readers:
            reader.start()
        self.port = self.wait_for_port(1)
        return self

    def _follow(self, stream):
        for line in stream:
            with self._news:
                self.lines.append(line.rstrip())
                if found := re.search(r"serves wss?://[^ ]*:(\d+)", line):
                    self.ports.append(int(found.group(1)))
                self._news.notify_all()

    def wait_for_port(self, times, timeout_s=60.0):
        """The port, once the API has come up so many times."""
        with self._news:
            come = self._news.wait_for(lambda: len(self.ports) >= times or self.process.poll() is not None, timeout_s)
            assert come and len(self.ports) >= times, "the API does not serve:\n" + "\n".join(self.lines)
            return self.ports[times - 1]

    def wait_for_line(self, pattern, timeout_s=30.0):
        with self._news:
            def found():
                return next((line for line in self.lines if re.search(pattern, line)), None)
            self._news.wait_for(found, timeout_s)
            assert found(), f"no line like '{pattern}':\n" + "\n".join(self.lines)
            return found()

    def api_process(self):
        """Process id of the user interface module: a child of `gaitway serve`."""
        return self._child("user_interface")

    def plugin_process(self):
        """Process id of the plug-in `api`, the robot's side of the link."""
        return self._child("gaitway_plugin_child", "sockets")  # which it alone may open

    def _child(self, program, last_word=None):
        children = [child for task in Path(f"/proc/{self.process.pid}/task").iterdir()
                    for child in (task / "children").read_text().split()]
        lines = {int(child): Path(f"/proc/{child}/cmdline").read_text().rstrip("\0").split("\0") for child in children}
        found = [child for child, line in lines.items() if program in line[0] and last_word in (None, line[-1])]
        assert len(found) == 1, (program, last_word, lines)
        return found[0]

    def stop(self):
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGINT)
        code = self.process.wait(60)
        for reader in self._readers:
            reader.join(10)
        self.process.stderr.close()
        self.process.stdout.close()
        self.summary = json.loads((self.out / "summary.json").read_text())
        return code

    def __exit__(self, kind, *_):
        try:
            if kind is None:
                code = self.stop()
                assert code == 0, f"gaitway serve ended with {code}:\n" + "\n".join(self.lines)
        finally:
            if self.process.poll() is None:
                self.process.kill()
                self.process.wait()
            self._folder.cleanup()


def until(condition, what, timeout_s=20.0):
    """Waits for something that other threads bring about. `what` is a text, or makes one once the time is up."""
    end = time.monotonic() + timeout_s
    while not condition():
        assert time.monotonic() < end, f"not within {timeout_s} s: {what() if callable(what) else what}"
        time.sleep(0.01)


def run_script(name, *arguments, timeout_s=240):
    """Runs a JavaScript test from beside the packages that it imports: that is where an ES module looks for them."""
    here = Path(__file__).parent
    packages = Path(os.environ["GAITWAY_CLIENTS_NODE"])
    with tempfile.TemporaryDirectory(prefix="test_", dir=packages) as folder:
        script = Path(folder) / name
        script.write_text((here / name).read_text())
        subprocess.run([os.environ["GAITWAY_NODE"], str(script), *map(str, arguments)], check=True, timeout=timeout_s)
