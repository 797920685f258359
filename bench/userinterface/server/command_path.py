#!/usr/bin/env python3
"""From a command's way into the API's socket to its frame on the bus, in real time: user_interface, the link (a Unix socket),
main_controller with the plug-in api, message_controller and virtual_robot, all against the clock. The bus stamps its frames with the clock
that all of them share.

    .deps/python/bin/python bench/userinterface/server/command_path.py --trials 1000
    .deps/python/bin/python bench/userinterface/server/command_path.py --trials 100 --kind emergency_stop
"""
import argparse
import base64
import json
import os
import random
import re
import signal
import socket
import struct
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import can

ROOT = Path(__file__).resolve().parents[3]
BIN = ROOT / "build" / "release" / "bin"
ROBOT = ROOT / "urdf" / "humanoid22"
FRAMES = {"move_joint": 0x002, "emergency_stop": 0x001}


class WebSocket:
    """As much of one as this needs: text messages both ways, and now and then a sign of life."""

    def __init__(self, port):
        self.socket = socket.create_connection(("127.0.0.1", port))
        self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        key = base64.b64encode(os.urandom(16)).decode()
        self.socket.sendall(f"GET / HTTP/1.1\r\nHost: 127.0.0.1\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
                            f"Sec-WebSocket-Key: {key}\r\nSec-WebSocket-Version: 13\r\n\r\n".encode())
        assert b" 101 " in self.socket.recv(4096)
        self.socket.setblocking(False)
        self.unread = b""

    def frame(self, opcode, payload):
        mask = os.urandom(4)
        size = struct.pack("!B", 0x80 | len(payload)) if len(payload) < 126 else struct.pack("!BH", 0xFE, len(payload))
        self.socket.sendall(bytes([0x80 | opcode]) + size + mask + bytes(b ^ mask[i % 4] for i, b in enumerate(payload)))

    def send(self, message):
        self.frame(1, json.dumps(message).encode())

    def messages(self):
        """What has come. Pings are answered: by that the robot knows how old what comes after may be."""
        try:
            while data := self.socket.recv(65536):
                self.unread += data
        except BlockingIOError:
            pass
        while len(self.unread) >= 4:
            short = self.unread[1] & 127
            header = 2 if short < 126 else 4
            size = short if short < 126 else struct.unpack("!H", self.unread[2:4])[0]
            if len(self.unread) < header + size:
                return
            opcode, payload = self.unread[0] & 15, self.unread[header:header + size]
            self.unread = self.unread[header + size:]
            if opcode == 9:
                self.frame(10, payload)
            if opcode == 1:
                yield json.loads(payload)


def start(folder, name, *arguments):
    with open(folder / f"{name}.txt", "wb") as output:
        return subprocess.Popen([BIN / name, "--robot", ROBOT, *map(str, arguments)], stdout=output, stderr=subprocess.STDOUT)


def wait_for(pattern, file):
    end = time.monotonic() + 60
    while time.monotonic() < end:
        if file.exists() and (found := re.search(pattern, file.read_text(errors="replace"))):
            return found.group(1)
        time.sleep(0.05)
    sys.exit(f"no '{pattern}' in {file}:\n{file.read_text()}")


def histogram(milliseconds):
    edges = [0.25 * i for i in range(45)]
    for low, high in zip(edges, edges[1:]):
        count = sum(low <= value < high for value in milliseconds)
        if count:
            print(f"  {low:5.2f} .. {high:5.2f} ms {count:6d} {'#' * max(1, 60 * count // len(milliseconds))}")


def answer_of(client, service, arguments):
    client.send({"op": "call_service", "service": service, "args": arguments})
    end = time.monotonic() + 5.0
    while time.monotonic() < end:
        for message in client.messages():
            if message["op"] == "service_response" and message["service"] == service:
                return message["values"]
        time.sleep(0.005)
    sys.exit(f"no answer to {service}")


def stand_again(client):
    """After an emergency stop: until a joint can be moved by hand again, which only a standing robot lets."""
    end = time.monotonic() + 20.0
    while not answer_of(client, "/release", {}).get("success"):
        assert time.monotonic() < end, "not released"
    while not answer_of(client, "/move_joint", {"joint": "neck_yaw", "position": 0.0, "duration": 0.02}).get("success"):
        assert time.monotonic() < end, "does not stand again"


def measure(port, bus_port, trials, kind):
    client = WebSocket(port)
    bus = can.Bus(interface="socketcand", host="127.0.0.1", port=bus_port, channel="can0")
    taken = []
    lost = 0
    for trial in range(trials + 5):  # the first few only warm up
        pause_until = time.monotonic() + random.uniform(0.06, 0.16)
        while time.monotonic() < pause_until:
            bus.recv(0.005)
            list(client.messages())
        sent_s = time.monotonic()
        arguments = {"joint": "neck_yaw", "position": 0.02 * (trial % 2), "duration": 0.02} if kind == "move_joint" else {"data": False}
        client.send({"op": "call_service", "service": f"/{kind}", "args": arguments})
        end = time.monotonic() + 0.5
        while time.monotonic() < end:
            message = bus.recv(0.05)
            if message and message.arbitration_id == FRAMES[kind] and message.timestamp >= sent_s:
                if trial >= 5:
                    taken.append(1e3 * (message.timestamp - sent_s))
                break
        else:
            answers = [message for message in client.messages() if message["op"] == "service_response"]
            print(f"trial {trial}: no frame; the answer: {answers}")
            lost += trial >= 5
        if kind == "emergency_stop":
            stand_again(client)
    bus.shutdown()
    return sorted(taken), lost


parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("--trials", type=int, default=300)
parser.add_argument("--kind", choices=sorted(FRAMES), default="move_joint")
options = parser.parse_args()
with tempfile.TemporaryDirectory(prefix="gaitway_path_") as name:
    folder = Path(name)
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    config = (ROOT / "core" / "config" / "serve.yaml").read_text()
    (folder / "serve.yaml").write_text(
        config.replace("sockets: local", f"parameters: {{link: 'unix:{folder}/link'}}\n    sockets: local"))
    processes = [start(folder, "virtual_robot", "--bus", folder / "bus", "--socketcand", 0)]
    try:
        bus_port = int(wait_for(r"on port (\d+)", folder / "virtual_robot.txt"))
        processes.append(start(folder, "message_controller", "--bus", folder / "bus", "--memory", folder / "memory",
                               "--obey-walk-requests"))
        while not (folder / "memory").exists():
            time.sleep(0.05)
        processes.append(start(folder, "main_controller", "--socket", folder / "memory", "--config", folder / "serve.yaml",
                               "--plugin-path", ROOT / "build" / "release" / "lib" / "gaitway" / "plugins"))
        processes.append(start(folder, "user_interface", "--link", f"unix:{folder}/link", "--port", port))
        wait_for(r"(linked to the main controller)", folder / "user_interface.txt")
        time.sleep(1.0)  # it stands
        taken, lost = measure(port, bus_port, options.trials, options.kind)
    finally:
        for process in reversed(processes):
            process.send_signal(signal.SIGINT)
        for process in processes:
            process.wait(20)
print(f"{len(taken)} commands, {lost} without a frame; from the client's send to the end of the frame:")
histogram(taken)
at = lambda share: taken[min(len(taken) - 1, int(share * len(taken)))]
print(f"  p50 {at(0.5):.2f} ms, p99 {at(0.99):.2f} ms, worst {taken[-1]:.2f} ms; {sum(t > 10 for t in taken)} above 10 ms")
