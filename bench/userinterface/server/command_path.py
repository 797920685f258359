#!/usr/bin/env python3
"""From a command's way into the API's socket to its frame on the bus, in real time: user_interface, the link (a Unix socket),
main_controller with the plug-in api, message_controller and virtual_robot, all against the clock.

    .deps/python/bin/python bench/userinterface/server/command_path.py --trials 1000
    .deps/python/bin/python bench/userinterface/server/command_path.py --trials 100 --kind emergency_stop
"""
import argparse
import random
import tempfile
import time
from pathlib import Path

import can
from measured_robot import EMERGENCY_STOP_FRAME, MeasuredRobot, WebSocket, histogram, share

FRAMES = {"move_joint": 0x002, "emergency_stop": EMERGENCY_STOP_FRAME}


def stand_again(client):
    """After an emergency stop: until a joint can be moved by hand again, which only a standing robot lets."""
    end = time.monotonic() + 20.0
    while not client.answer_of("/release", {}).get("success"):
        assert time.monotonic() < end, "not released"
    while not client.answer_of("/move_joint", {"joint": "neck_yaw", "position": 0.0, "duration": 0.02}).get("success"):
        assert time.monotonic() < end, "does not stand again"


def measure(robot, trials, kind):
    client = WebSocket("127.0.0.1", robot.port)
    bus = can.Bus(interface="socketcand", host="127.0.0.1", port=robot.bus_port, channel="can0")
    taken = []
    lost = 0
    for trial in range(trials + 5):  # the first few only warm up
        pause_until = time.monotonic() + random.uniform(0.06, 0.16)
        while time.monotonic() < pause_until:
            bus.recv(0.005)
            client.messages()
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
with tempfile.TemporaryDirectory(prefix="gaitway_path_") as name, MeasuredRobot(Path(name)) as robot:
    taken, lost = measure(robot, options.trials, options.kind)
print(f"{len(taken)} commands, {lost} without a frame; from the client's send to the end of the frame:")
histogram(taken)
print(f"  p50 {share(taken, 0.5):.2f} ms, p99 {share(taken, 0.99):.2f} ms, worst {taken[-1]:.2f} ms; {sum(t > 10 for t in taken)} above 10 ms")
