"""A robot of processes that are paced by the clock (user_interface, main_controller with the plug-in api, message_controller, virtual_robot),
and a client of its WebSocket, for the measurements of this folder. All share CLOCK_MONOTONIC: the bus stamps its frames with it."""
import re
import signal
import socket
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "tests" / "clients"))

from plain_websocket import PlainWebSocket as WebSocket  # noqa: E402,F401: for those who measure
from plain_websocket import secret_options  # noqa: E402,F401

BIN = ROOT / "build" / "release" / "bin"
ROBOT = ROOT / "urdf" / "humanoid22"
EMERGENCY_STOP_FRAME = 0x001


class MeasuredRobot:
    """The processes, from entry to exit. `bus_port`: where frames are told by the socketcand protocol. `address`: of the module, with
    its options."""

    def __init__(self, folder, address="127.0.0.1", options=(), link=None, before=()):
        self.folder, self.address, self.options = folder, address, options
        self.link = link or folder / "link"  # where the module connects; the plug-in listens at `link` in the folder
        self.before = before  # of each command line: what limits the processes
        self.processes = []

    def __enter__(self):
        with socket.socket() as probe:
            probe.bind((self.address, 0))
            self.port = probe.getsockname()[1]
        config = (ROOT / "core" / "config" / "serve.yaml").read_text()
        (self.folder / "serve.yaml").write_text(
            config.replace("sockets: local", f"parameters: {{link: 'unix:{self.folder}/link'}}\n    sockets: local"))
        try:
            self._start("virtual_robot", "--bus", self.folder / "bus", "--socketcand", 0)
            self.bus_port = int(self._said(r"on port (\d+)", "virtual_robot"))
            self._start("message_controller", "--bus", self.folder / "bus", "--memory", self.folder / "memory")
            while not (self.folder / "memory").exists():
                time.sleep(0.05)
            self._start("main_controller", "--socket", self.folder / "memory", "--config", self.folder / "serve.yaml",
                        "--plugin-path", ROOT / "build" / "release" / "lib" / "gaitway" / "plugins")
            self._start("user_interface", "--link", f"unix:{self.link}", "--address", self.address, "--port", self.port, *self.options)
            self._said("(linked to the main controller)", "user_interface")
        except BaseException:
            self.__exit__()
            raise
        time.sleep(1.0)  # it stands
        return self

    def __exit__(self, *_):
        for process in reversed(self.processes):
            process.send_signal(signal.SIGINT)
        for process in self.processes:
            process.wait(20)

    def _start(self, name, *arguments):
        with open(self.folder / f"{name}.txt", "wb") as output:
            self.processes.append(subprocess.Popen([*self.before, BIN / name, "--robot", ROBOT, *map(str, arguments)], stdout=output,
                                                   stderr=subprocess.STDOUT))

    def _said(self, pattern, name):
        file = self.folder / f"{name}.txt"
        end = time.monotonic() + 60
        while time.monotonic() < end:
            if found := re.search(pattern, file.read_text(errors="replace")):
                return found.group(1)
            time.sleep(0.05)
        sys.exit(f"no '{pattern}' in {file}:\n{file.read_text()}")


def share(values, part):
    """The value below which so much of the sorted values lies."""
    return values[min(len(values) - 1, int(part * len(values)))]


def histogram(milliseconds, bin_ms=0.25):
    bins = {}
    for value in milliseconds:
        bins[int(value / bin_ms)] = bins.get(int(value / bin_ms), 0) + 1
    for index, count in sorted(bins.items()):
        print(f"  {index * bin_ms:7.2f} .. {(index + 1) * bin_ms:7.2f} ms {count:6d} {'#' * max(1, 60 * count // len(milliseconds))}")
