#!/usr/bin/env python3
"""Over an emulated wireless link (`gaitway wireless`), in real time: how long an emergency stop takes from the client's send to the end of its
frame on the bus, and how old the view's frames are when they come. The stop is said by datagrams; by WebSocket every 20 ms until it is answered, as the page
does; or in one call. A WebSocket that is silent for a second is given up, and the stop said again on a new one.

    .deps/python/bin/python bench/userinterface/server/wireless_path.py --what datagram --trials 1000 --rate 5Mbit --delay 10ms --loss 3% --burst 8
    .deps/python/bin/python bench/userinterface/server/wireless_path.py --what websocket --delay 2ms
    .deps/python/bin/python bench/userinterface/server/wireless_path.py --what view --seconds 60 --delay 2ms --watchers 50

`--watchers N`: N more clients beside the robot, and one behind the link, that are subscribed to everything. Other options go to `gaitway wireless`.
"""
import argparse
import importlib.util
import json
import os
import random
import select
import signal
import socket
import struct
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from measured_robot import BIN, EMERGENCY_STOP_FRAME, ROOT, MeasuredRobot, WebSocket, histogram, secret_options, share

ADDRESS = "10.77.0.1"  # of the robot behind `gaitway wireless`
TOKEN = "a-token-for-the-measurement"
EMERGENCY_STOP = {"op": "call_service", "service": "/emergency_stop", "args": {"data": False}}


def stop_client():
    spec = importlib.util.spec_from_file_location("stop_client", ROOT / "docs" / "examples" / "stop_client.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module.StopClient


def subscribe_to_everything(client):
    for topic in client.answer_of("/rosapi/topics", {})["topics"]:
        client.send({"op": "subscribe", "topic": topic, "queue_length": 1})


# --- at the robot -----------------------------------------------------------------------------------------------------------------------

class Witness:
    """Sees emergency stops on the bus, and releases the robot after each."""

    def __init__(self, robot, folder):
        import can
        self.bus = can.Bus(interface="socketcand", host="127.0.0.1", port=robot.bus_port, channel="can0")
        self.client = WebSocket(ADDRESS, robot.port, token=TOKEN)
        self.orders = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)  # of the measuring client, by a path that the link does not touch
        self.orders.bind(str(folder / "witness"))
        self.stopped_s = []  # when frames of an emergency stop were on the bus

    def look(self, wait_s=0.005):
        message = self.bus.recv(wait_s)
        if message and message.arbitration_id == EMERGENCY_STOP_FRAME:
            self.stopped_s.append(message.timestamp)
        self.client.messages()

    def stop_after(self, sent_s, within_s):
        end = time.monotonic() + within_s
        while time.monotonic() < end:
            if later := [at for at in self.stopped_s if at >= sent_s]:
                return min(later)
            self.look()
        return None

    def release(self):
        end = time.monotonic() + 10.0
        while True:  # what was asked before the module had heard of the stop is refused
            self.client.answer_of("/command/acquire", {"name": "witness"})
            answer = self.client.answer_of("/release", {})
            if isinstance(answer, dict) and answer["success"]:
                break
            assert time.monotonic() < end, f"not released: {answer}"
            self.look(0.02)
        self.stopped_s.clear()

    def serve(self):
        while True:
            while not select.select([self.orders], [], [], 0)[0]:
                self.look()
            order, client = self.orders.recvfrom(100)
            if order == b"end":
                return
            stopped_s = self.stop_after(struct.unpack("<d", order)[0], 60.0)
            while not select.select([self.orders], [], [], 0)[0]:
                self.look()
            self.orders.recv(100)  # the client has its answer
            self.release()
            self.orders.sendto(struct.pack("<d", stopped_s or 0.0), client)


def be_robot(options):
    folder = Path(options.folder)
    with MeasuredRobot(folder, ADDRESS, secret_options(folder, TOKEN)) as robot:
        watchers = subprocess.Popen([BIN / "api_load", "--address", ADDRESS, "--token", TOKEN, "--port", str(robot.port), "--clients",
                                     str(options.watchers), "--silent", "0", "--seconds", "100000"],
                                    stdout=subprocess.DEVNULL) if options.watchers else None
        witness = Witness(robot, folder)
        print("ready", robot.port, flush=True)
        (folder / "port").write_text(str(robot.port))
        witness.serve()
        if watchers:
            watchers.kill()
            watchers.wait()


# --- at the client's end of the link ----------------------------------------------------------------------------------------------------

class Patient:
    """Does nothing for a while, but answers pings."""

    def __init__(self, connections):
        self.connections = connections
        self.answers = 0

    def wait(self, seconds, until=None, answers=0):
        end = time.monotonic() + seconds
        while (left := end - time.monotonic()) > 0:
            readable = select.select([c.socket for c in self.connections] + ([until] if until else []), [], [], left)[0]
            for connection in self.connections:
                self.answers += sum(message["op"] == "service_response" for message in connection.messages())
            if until in readable or (answers and self.answers >= answers):
                return True
        return False


def say_stop(connection, how, patient):
    """Whether it is answered within a second. All that was said is then at the robot, and none stops it once more after its release."""
    patient.answers = 0
    for said in range(1, 51):
        connection.send(EMERGENCY_STOP)
        if patient.wait(0.02 if how == "websocket" else 1.0, answers=1):
            return patient.wait(1.0, answers=said)
        if how == "call":
            break
    return False


def stops(options, folder, port, connections, patient):
    orders = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)
    orders.bind(str(folder / "client"))
    datagrams = stop_client()(ADDRESS, port + 1, TOKEN)
    taken, again = [], 0
    for trial in range(options.trials + 3):
        patient.wait(random.uniform(0.1, 0.2))
        sent_s = time.monotonic()
        orders.sendto(struct.pack("<d", sent_s), str(folder / "witness"))
        if options.what == "datagram":
            datagrams.stop("hold", 60.0)
        else:
            while not say_stop(connections[0], options.what, patient):
                again += 1
                connections[0] = WebSocket(ADDRESS, port, token=TOKEN)
        orders.sendto(b"release", str(folder / "witness"))
        assert patient.wait(90.0, orders), "the witness is silent"
        seen_s = struct.unpack("<d", orders.recv(100))[0]
        if trial >= 3:
            taken.append(1e3 * (seen_s - sent_s) if seen_s else float("inf"))
        print(f"\r  {trial} of {options.trials}", end="", file=sys.stderr, flush=True)
    orders.sendto(b"end", str(folder / "witness"))
    taken.sort()
    print(f"\r{len(taken)} emergency stops by {options.what}, from the client's send to the end of the frame:")
    histogram([value for value in taken if value < 1e9], 10.0 if taken[-1] > 30.0 else 0.5)
    print(f"  p50 {share(taken, 0.5):.1f} ms, p99 {share(taken, 0.99):.1f} ms, worst {taken[-1]:.1f} ms" + (f"; said again {again} times" if again else ""))


def view(options, folder, port, connections):
    """Age of the joints when a frame has come: since they came to the module, and the way from there on."""
    connection = WebSocket(ADDRESS, port, "/view", TOKEN)
    ages, frame_bytes = [], []
    end = time.monotonic() + options.seconds
    while time.monotonic() < end:
        select.select([connection.socket] + [c.socket for c in connections], [], [], 0.1)
        for other in connections:
            for _ in other.payloads():
                pass
        for opcode, payload in connection.payloads():
            if opcode != 2:
                continue
            connection.frame(2, payload[2:6])
            now_ms = time.monotonic_ns() // 1_000_000
            robot_time_ms, = struct.unpack_from("<I", payload, 6)
            joints_ms, _, _, _, clock_ms = struct.unpack_from("<5H", payload, 14)
            made_ms = robot_time_ms + clock_ms  # the robot's clock is the computer's
            ages.append(joints_ms + (now_ms - made_ms) % 2**32)
            frame_bytes.append(len(payload))
    orders = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)
    orders.sendto(b"end", str(folder / "witness"))
    ages = sorted(ages[30:])
    print(f"{len(ages)} frames of the view, {len(ages) / options.seconds:.1f} a second of {max(frame_bytes)} bytes; age of the joints:")
    print(f"  p50 {share(ages, 0.5)} ms, p99 {share(ages, 0.99)} ms, worst {ages[-1]} ms")


def be_client(options):
    folder = Path(options.folder)
    port = int((folder / "port").read_text())
    connections = []
    if options.what in ("websocket", "call") or options.watchers:
        connections.append(WebSocket(ADDRESS, port, token=TOKEN))
    if options.watchers:
        connections.append(WebSocket(ADDRESS, port, token=TOKEN))
        subscribe_to_everything(connections[-1])
    if options.what == "view":
        view(options, folder, port, connections)
    else:
        stops(options, folder, port, connections, Patient(connections))


def run(options, link_options):
    with tempfile.TemporaryDirectory(prefix="gaitway_wireless_") as folder:
        me = [sys.executable, __file__, "--what", options.what, "--trials", str(options.trials), "--seconds", str(options.seconds),
              "--watchers", str(options.watchers), "--folder", folder]
        report = Path(folder) / "link.json"
        code = subprocess.run([BIN / "gaitway", "wireless", "--json", report, "--robot", " ".join([*me, "--role", "robot"]), "--robot-ready",
                               "ready", *link_options, "--", *me, "--role", "client"]).returncode
        if code == 0 and options.what == "view":
            link = json.loads(report.read_text())
            print("  the link:", json.dumps(link))
        return code


parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("--what", choices=["datagram", "websocket", "call", "view"], required=True)
parser.add_argument("--trials", type=int, default=100)
parser.add_argument("--seconds", type=float, default=30.0)
parser.add_argument("--watchers", type=int, default=0)
parser.add_argument("--role", choices=["robot", "client"], help=argparse.SUPPRESS)
parser.add_argument("--folder", help=argparse.SUPPRESS)
options, link_options = parser.parse_known_args()
roles = {"robot": be_robot, "client": be_client}
sys.exit(roles[options.role](options) if options.role else run(options, link_options))
