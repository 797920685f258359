#!/usr/bin/env python3
"""What a crowd of clients costs the main controller, in real time: rounds of runs one after the other, so that whatever else the computer does is in all of them.

  alone    the robot walks, and nobody but who walks it is connected
  watched  one client is subscribed to everything: the robot sends its module all that it has, as it does for a crowd
  crowd    as many clients are subscribed to everything
  control  the same load generator reads as many messages of a server that has no robot: what the generator itself, and the messages' way, cost

    .deps/python/bin/python bench/userinterface/server/crowd.py --rounds 6 --seconds 30
    .deps/python/bin/python bench/userinterface/server/crowd.py --rounds 6 --no-fifo        as where SCHED_FIFO is not allowed
    .deps/python/bin/python bench/userinterface/server/crowd.py --rounds 6 --apart          the controllers have the last processor to themselves
"""
import argparse
import json
import os
import re
import statistics
import subprocess
import tempfile
import time
from pathlib import Path

from measured_robot import BIN, MeasuredRobot, WebSocket

KINDS = ("alone", "watched", "crowd", "control")
NO_FIFO = ["setpriv", "--bounding-set=-sys_nice", "--inh-caps=-sys_nice"]
WALK = {"op": "publish", "topic": "/cmd_vel", "msg": {"linear": {"x": 0.1}}}


def cpu_s(process):
    fields = Path(f"/proc/{process}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def processors_elsewhere_s():
    """Processor time of all programs but this one's and those that have ended of its own."""
    ticks = [int(field) for field in Path("/proc/stat").read_text().split("\n")[0].split()[1:4]]
    own = os.times()
    return sum(ticks) / os.sysconf("SC_CLK_TCK") - sum(own[:4])


def quiet_run(kind, options, like):
    """Once more as long as others have used the computer meanwhile."""
    while True:
        before_s, began = processors_elsewhere_s(), time.monotonic()
        result = run(kind, options, like)
        result["elsewhere"] = (processors_elsewhere_s() - before_s) / (time.monotonic() - began)
        if result["elsewhere"] <= options.elsewhere:
            return result
        print(f"  {kind}: not counted, others took {result['elsewhere']:.2f} processors; its p99 was {result['p99_us']} us", flush=True)


def on_processor(pid, processors):
    for task in Path(f"/proc/{pid}/task").iterdir():
        os.sched_setaffinity(int(task.name), processors)


def put_apart(robot):
    """Main and message controller on the last processor, all others of the robot, and what this program starts, on the others."""
    last = os.cpu_count() - 1
    others = set(range(last))
    os.sched_setaffinity(0, others)
    for process in robot.processes:
        program = os.readlink(f"/proc/{process.pid}/exe").rsplit("/", 1)[1]
        children = [int(child) for child in Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split()]
        for pid in (process.pid, *children):
            on_processor(pid, {last} if program in ("main_controller", "message_controller") else others)


def generator(port, clients, seconds):
    return subprocess.Popen([BIN / "api_load", "--port", str(port), "--clients", str(clients), "--silent", "0", "--seconds", str(seconds)],
                            stdout=subprocess.PIPE, text=True)


def foreign_server(clients, like):
    """Says so many messages of such a size in all as the module did in the run `like`."""
    server = subprocess.Popen([BIN / "crowd_server", "--bytes", str(round(like["bytes_a_message"])), "--messages-per-s",
                               str(like["messages_per_s"] / clients)], stdout=subprocess.PIPE, text=True)
    return server, int(re.search(r"port (\d+)", server.stdout.readline()).group(1))


def run(kind, options, like):
    with tempfile.TemporaryDirectory(prefix="gaitway_crowd_") as name:
        folder = Path(name)
        foreign = None
        result = {}
        with MeasuredRobot(folder, before=NO_FIFO if options.no_fifo else ()) as robot:
            for task in Path(f"/proc/{robot.processes[-1].pid}/task").iterdir():
                os.setpriority(os.PRIO_PROCESS, int(task.name), options.module_nice)
            if options.apart:
                put_apart(robot)
            driver = WebSocket("127.0.0.1", robot.port)
            port = robot.port
            if kind == "control":
                foreign, port = foreign_server(options.clients, like)
            load = generator(port, 1 if kind == "watched" else options.clients, options.seconds) if kind != "alone" else None
            module = robot.processes[-1].pid
            before_s, began = cpu_s(module), time.monotonic()
            while time.monotonic() < began + options.seconds:
                driver.send(WALK)
                driver.messages()
                time.sleep(0.1)
            result["module_cpu"] = (cpu_s(module) - before_s) / (time.monotonic() - began)
            if load:
                told = json.loads(load.communicate()[0])
                result |= {"messages_per_s": told["messages"] / options.seconds, "bytes_a_message": told["bytes"] / max(1, told["messages"]),
                           "open": told["open"]}
        os.sched_setaffinity(0, range(os.cpu_count()))
        if foreign:
            foreign.kill()
            foreign.wait()
        said = (folder / "main_controller.txt").read_text()
        batches = re.search(r"batch compute +p50 (\d+) us, p99 (\d+) us, max (\d+)", said)
        ticks = re.search(r"ticks +\d+, (\d+) missed, late by p50 (\d+) us, p99 (\d+) us, max (\d+)", said)
        late = re.search(r"accepted, (\d+) late", said)
        names = ("p50_us", "p99_us", "max_us"), ("missed", "wakes_p50_us", "wakes_p99_us", "wakes_max_us")
        for found, keys in zip((batches, ticks), names):
            result |= {key: int(value) for key, value in zip(keys, found.groups())}
        return result | {"late": int(late.group(1))}


parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("--rounds", type=int, default=6)
parser.add_argument("--seconds", type=float, default=30.0)
parser.add_argument("--clients", type=int, default=200)
parser.add_argument("--no-fifo", action="store_true", help="take the right to SCHED_FIFO from the robot's processes")
parser.add_argument("--elsewhere", type=float, default=0.2, help="processors that other programs may use meanwhile; otherwise the run is made again")
parser.add_argument("--module-nice", type=int, default=0, help="nice value of the module's threads")
parser.add_argument("--apart", action="store_true", help="main and message controller on the last processor, the others on the others")
options = parser.parse_args()
print(f"load of the computer before: {os.getloadavg()[0]:.2f}")
runs = {kind: [] for kind in KINDS}
for round_ in range(options.rounds):
    for kind in KINDS if round_ % 2 == 0 else ("crowd", "control", "alone", "watched"):
        runs[kind].append(quiet_run(kind, options, runs["crowd"][-1] if runs["crowd"] else None))
        print(round_, kind, json.dumps(runs[kind][-1]), flush=True)
print("\n| median of the runs | batch compute p50, p99, max [us] | wakes late by p50, p99, max [us] | batches late in all | messages/s | module's processor time |")
print("|---|---|---|---|---|---|")
for kind in KINDS:
    def median(key):
        return statistics.median(one.get(key, 0) for one in runs[kind])
    print(f"| {kind} | {median('p50_us'):.0f}, {median('p99_us'):.0f}, {median('max_us'):.0f} | {median('wakes_p50_us'):.0f}, {median('wakes_p99_us'):.0f}, "
          f"{median('wakes_max_us'):.0f} | {sum(one['late'] for one in runs[kind])} | {median('messages_per_s'):.0f} | {median('module_cpu'):.2f} |")
