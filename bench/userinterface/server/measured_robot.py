"""A robot of processes that are paced by the clock (user_interface, main_controller with the plug-in api, message_controller, virtual_robot),
and a client of its WebSocket, for the measurements of this folder. All share CLOCK_MONOTONIC: the bus stamps its frames with it."""
import base64
import json
import os
import re
import select
import signal
import socket
import ssl
import struct
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
BIN = ROOT / "build" / "release" / "bin"
ROBOT = ROOT / "urdf" / "humanoid22"
EMERGENCY_STOP_FRAME = 0x001


class WebSocket:
    """As much of one as this needs: messages both ways, and a sign of life. With `token` over TLS, whoever's the certificate is."""

    def __init__(self, host, port, target="/", token=None):
        self.socket = socket.create_connection((host, port))
        self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        if token:
            self.socket = ssl._create_unverified_context().wrap_socket(self.socket)
        key = base64.b64encode(os.urandom(16)).decode()
        self.socket.sendall(f"GET {target} HTTP/1.1\r\nHost: {host}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
                            f"Sec-WebSocket-Key: {key}\r\nSec-WebSocket-Version: 13\r\n\r\n".encode())
        self.unread = b""
        while b"\r\n\r\n" not in self.unread:
            self.unread += self.socket.recv(4096)
        head, self.unread = self.unread.split(b"\r\n\r\n", 1)
        assert b" 101 " in head, head
        if token:
            self.frame(1, (token if target == "/view" else json.dumps({"op": "auth", "token": token})).encode())
        self.socket.setblocking(False)

    def frame(self, opcode, payload):
        mask = os.urandom(4)
        size = struct.pack("!B", 0x80 | len(payload)) if len(payload) < 126 else struct.pack("!BH", 0xFE, len(payload))
        data = bytes([0x80 | opcode]) + size + mask + bytes(b ^ mask[i % 4] for i, b in enumerate(payload))
        while data:
            try:
                data = data[self.socket.send(data):]
            except (BlockingIOError, ssl.SSLWantWriteError):
                select.select([], [self.socket], [], 1.0)

    def send(self, message):
        self.frame(1, json.dumps(message).encode())

    def payloads(self):
        """(opcode, payload) of what has come. Pings are answered: by that the robot knows how old what comes after may be."""
        try:
            while data := self.socket.recv(65536):
                self.unread += data
        except (BlockingIOError, ssl.SSLWantReadError):
            pass
        while len(self.unread) >= 2:
            short = self.unread[1] & 127
            header, form = {126: (4, "!H"), 127: (10, "!Q")}.get(short, (2, None))
            if len(self.unread) < header:
                return
            size = struct.unpack(form, self.unread[2:header])[0] if form else short
            if len(self.unread) < header + size:
                return
            opcode, payload = self.unread[0] & 15, self.unread[header:header + size]
            self.unread = self.unread[header + size:]
            if opcode == 9:
                self.frame(10, payload)
            elif opcode in (1, 2):
                yield opcode, payload
            elif opcode == 8:
                sys.exit(f"the robot has ended the connection: {payload[2:].decode()}")

    def messages(self):
        return [json.loads(payload) for opcode, payload in self.payloads() if opcode == 1]

    def answer_of(self, service, arguments):
        self.send({"op": "call_service", "service": service, "args": arguments})
        end = time.monotonic() + 5.0
        while time.monotonic() < end:
            for message in self.messages():
                if message["op"] == "service_response" and message["service"] == service:
                    return message["values"]
            select.select([self.socket], [], [], 0.005)
        sys.exit(f"no answer to {service}")


class MeasuredRobot:
    """The processes, from entry to exit. `bus_port`: where frames are told by the socketcand protocol. `address`: of the module, with
    its options."""

    def __init__(self, folder, address="127.0.0.1", options=()):
        self.folder, self.address, self.options = folder, address, options
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
            self._start("message_controller", "--bus", self.folder / "bus", "--memory", self.folder / "memory", "--obey-walk-requests")
            while not (self.folder / "memory").exists():
                time.sleep(0.05)
            self._start("main_controller", "--socket", self.folder / "memory", "--config", self.folder / "serve.yaml",
                        "--plugin-path", ROOT / "build" / "release" / "lib" / "gaitway" / "plugins")
            self._start("user_interface", "--link", f"unix:{self.folder}/link", "--address", self.address, "--port", self.port, *self.options)
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
            self.processes.append(subprocess.Popen([BIN / name, "--robot", ROBOT, *map(str, arguments)], stdout=output,
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
