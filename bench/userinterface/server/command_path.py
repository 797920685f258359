#!/usr/bin/env python3
"""A command's way from a touch on the page to the last joint's frame, stage by stage, as one table for each kind of command:

  - what is proven of each stage, over I2C and over a Unix socket, and what was measured in virtual time over I2C: by userinterface_command_path_tests;
  - what was measured in real time over a Unix socket: user_interface, main_controller with the plug-in api, message_controller and virtual_robot against the
    clock. From the client's send to the link, from there to the millisecond in which the message controller offers its frame, from that to the frame's end. And
    from a touch on the page in a headless Chromium to the module's socket.

    .deps/python/bin/python bench/userinterface/server/command_path.py --trials 300 --touches 60
    .deps/python/bin/python bench/userinterface/server/command_path.py --kind move_joint --trials 1000 --touches 0
"""
import argparse
import logging
import os
import random
import select
import subprocess
import tempfile
import time
from collections import defaultdict
from pathlib import Path

import can
from link_tap import LinkTap
from measured_robot import BIN, EMERGENCY_STOP_FRAME, ROOT, MeasuredRobot, WebSocket, share

FRAMES = {"emergency_stop": EMERGENCY_STOP_FRAME, "move_joint": 0x002}
ON_THE_LINK = {"emergency_stop": "stop", "move_joint": "order"}
TITLES = {"emergency_stop": "emergency stop", "move_joint": "user command (`/move_joint`)"}
STAGES = {
    "page": "touch → module's socket",
    "module": "module: socket → link",
    "link": "link",
    "desk": "plug-in `api`: link → memory block",
    "intake": "message controller: memory block → frame offered",
    "offered": "link, `api` and message controller",
    "bus": "bus: offered → on every joint",
    "sum": "module → joints",
    "all": "touch → joints",
}
LIMIT_MS = 10.0  # published, from the module to the joints
MILLISECOND_S = 1e-3


class Trial:
    """The instants of one command, in seconds of CLOCK_MONOTONIC."""

    def __init__(self, sent_s, touched_s=None):
        self.sent_s, self.touched_s = sent_s, touched_s
        self.linked_s = self.frame_s = None

    def stages(self):
        """In ms. The message controller offers a frame in its millisecond, and the bus takes it within that."""
        offered_s = (self.frame_s - 1e-5) // MILLISECOND_S * MILLISECOND_S
        times = {"module": self.linked_s - self.sent_s, "offered": offered_s - self.linked_s, "bus": self.frame_s - offered_s,
                 "sum": self.frame_s - self.sent_s}
        if self.touched_s:
            times |= {"page": self.sent_s - self.touched_s, "all": self.frame_s - self.touched_s}
        return {stage: 1e3 * time_s for stage, time_s in times.items()}


class CommandedRobot:
    """Gives commands, and sees them on the link and on the bus."""

    def __init__(self, folder):
        self.tap = LinkTap(folder / "tap", folder / "link")
        while not (folder / "tap").exists():
            time.sleep(0.01)
        self.robot = MeasuredRobot(folder, link=folder / "tap")
        self.robot.__enter__()
        self.client = WebSocket("127.0.0.1", self.robot.port)
        self.bus = can.Bus(interface="socketcand", host="127.0.0.1", port=self.robot.bus_port, channel="can0")

    def end(self):
        self.bus.shutdown()
        self.robot.__exit__()
        self.tap.end()

    def pause(self, seconds):
        pause_until = time.monotonic() + seconds
        while time.monotonic() < pause_until:
            self.bus.recv(0.005)
            self.client.messages()
            self.tap.said()

    def send(self, kind, number):
        arguments = {"joint": "neck_yaw", "position": 0.02 * (number % 2), "duration": 0.02} if kind == "move_joint" else {"data": False}
        trial = Trial(time.monotonic())
        self.client.call(f"/{kind}", **arguments)
        return trial

    def complete(self, trial, kind):
        """Whether it came to the joints."""
        end = time.monotonic() + 0.5
        while trial.frame_s is None and time.monotonic() < end:
            message = self.bus.recv(0.05)
            if message and message.arbitration_id == FRAMES[kind] and message.timestamp >= trial.sent_s:
                trial.frame_s = message.timestamp
        trial.linked_s = next((at for at, what in self.tap.said() if what == ON_THE_LINK[kind] and at >= trial.sent_s), None)
        return trial.frame_s is not None and trial.linked_s is not None

    def stand_again(self):
        """After an emergency stop: until a joint can be moved by hand again, which only a standing robot lets."""
        end = time.monotonic() + 20.0
        for service, arguments in (("/release", {}), ("/move_joint", {"joint": "neck_yaw", "position": 0.0, "duration": 0.02})):
            answer = None  # a text, when it was refused before it came to the robot
            while not isinstance(answer, dict) or not answer["success"]:
                assert time.monotonic() < end, f"{service}: {answer}"
                self.client.answer_of("/command/acquire", {"name": "command_path"})  # the page's stops, which it repeats, have ended it
                answer = self.client.answer_of(service, arguments)
                self.pause(0.02)


def measure(robot, trials, kind):
    """ms of each stage, and how many commands came to no joint."""
    times, lost = defaultdict(list), 0
    for number in range(-5, trials):  # the first few only warm up
        robot.pause(random.uniform(0.06, 0.16))
        trial = robot.send(kind, number)
        if not robot.complete(trial, kind):
            lost += number >= 0
        elif number >= 0:
            for stage, ms in trial.stages().items():
                times[stage].append(ms)
        if kind == "emergency_stop":
            robot.stand_again()
    return times, lost


def touch(robot, touches):
    times, lost = defaultdict(list), 0
    environment = os.environ | {"GAITWAY_PAGE_PACKAGES": str(ROOT / ".deps" / "web"), "GAITWAY_CHROMIUM": "/usr/bin/chromium"}
    page = subprocess.Popen([ROOT / ".deps" / "python" / "bin" / "node", ROOT / "bench" / "userinterface" / "page" / "touch_path.mjs",
                             str(robot.robot.port), str(touches + 2)], env=environment, stdin=subprocess.PIPE, stdout=subprocess.PIPE)
    for number in range(-2, touches):
        while not select.select([page.stdout], [], [], 0.0)[0]:
            robot.client.messages()  # answers pings
            time.sleep(0.001)
        touched_s, sent_s = (1e-9 * int(instant) for instant in page.stdout.readline().split())
        trial = Trial(sent_s, touched_s)
        if not robot.complete(trial, "emergency_stop"):
            lost += number >= 0
        elif number >= 0:
            for stage, ms in trial.stages().items():
                times[stage].append(ms)
        robot.stand_again()
        robot.pause(random.uniform(0.2, 0.4))
        page.stdin.write(b"\n")
        page.stdin.flush()
    page.wait(30)
    return times, lost


def virtual_figures(folder):
    """{(line, kind): {stage: (proven, p50, p99, worst)}}, in ms."""
    file = folder / "figures"
    subprocess.run([BIN / "userinterface_command_path_tests", "--gtest_brief=1"], check=True, env=os.environ | {"GAITWAY_FIGURES": str(file)},
                   stdout=subprocess.DEVNULL)
    figures = defaultdict(dict)
    for line in file.read_text().splitlines():
        carrier, kind, stage, *times_ns, count = line.split()
        figures[carrier, kind][stage] = tuple(1e-6 * int(time_ns) for time_ns in times_ns)
        figures[carrier, kind]["count"] = int(count)
    return figures


def text(values):
    return " / ".join(f"{value:.2f}" for value in values)


def table(kind, figures, real, count, touches):
    i2c, unix = figures["i2c", kind], figures["socket", kind]
    print(f"\n| {TITLES[kind]}, ms | proven, I²C | measured, I²C, virtual time, {i2c['count']} | proven, Unix socket | measured, Unix socket, real time, {count} |")
    print("|---|---|---|---|---|")
    for stage, name in STAGES.items():
        if stage not in i2c and stage not in real:
            continue
        if stage == "all":
            name += f" ({touches} touches)"
        elif stage == "page":
            name += f" ({touches} touches)"
        measured = sorted(real.get(stage, []))
        row = [f"{i2c[stage][0]:.2f}" if stage in i2c else "", text(i2c[stage][1:]) if stage in i2c else "",
               f"{unix[stage][0]:.2f}" if stage in unix else "", text([share(measured, part) for part in (0.5, 0.99, 1.0)]) if measured else ""]
        print(f"| {name} | {' | '.join(row)} |")
    print(f"\np50 / p99 / worst. Proven sums against the published {LIMIT_MS:.0f} ms: I²C {i2c['sum'][0]:.2f}, Unix socket {unix['sum'][0]:.2f}; "
          f"in real time {sum(ms > LIMIT_MS for ms in real['sum'])} of {len(real['sum'])} took longer.")


parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("--trials", type=int, default=300, help="commands of each kind in real time")
parser.add_argument("--touches", type=int, default=60, help="of the page's emergency stop")
parser.add_argument("--kind", choices=list(FRAMES), help="one only")
options = parser.parse_args()
logging.getLogger("can").setLevel(logging.ERROR)  # a socket brings half a message now and then
print(f"load of the computer before: {os.getloadavg()[0]:.2f}")
with tempfile.TemporaryDirectory(prefix="gaitway_path_") as name:
    figures = virtual_figures(Path(name))
    robot = CommandedRobot(Path(name))
    try:
        for kind in [options.kind] if options.kind else FRAMES:
            real, lost = measure(robot, options.trials, kind)
            if kind == "emergency_stop" and options.touches:
                touched, none = touch(robot, options.touches)
                real |= {stage: touched[stage] for stage in ("page", "all")}
                lost += none
            table(kind, figures, real, options.trials, options.touches)
            print(f"{lost} commands came to no joint")
    finally:
        robot.end()
