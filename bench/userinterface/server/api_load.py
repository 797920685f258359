#!/usr/bin/env python3
"""A walkless robot under `gaitway serve`, once without and once with many clients that subscribe to everything: late batches,
pace, memory and processor time of the API's process, side by side.

    bench/userinterface/server/api_load.py --seconds 300 --clients 200
"""
import argparse
import json
import os
import re
import signal
import socket
import subprocess
import sys
import tempfile
import time
from pathlib import Path

BIN = Path(__file__).resolve().parents[3] / "build" / "release" / "bin"


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def api_process(served):
    children = [child for task in Path(f"/proc/{served}/task").iterdir() for child in (task / "children").read_text().split()]
    return next(int(child) for child in children if "user_interface" in Path(f"/proc/{child}/cmdline").read_text())


def memory_kb(process):
    return int(re.search(r"VmRSS:\s+(\d+)", Path(f"/proc/{process}/status").read_text()).group(1))


def cpu_s(process):
    fields = Path(f"/proc/{process}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def run(seconds, clients, silent):
    port = free_port()
    with tempfile.TemporaryDirectory(prefix="gaitway_load_") as folder:
        out = Path(folder) / "out"
        served = subprocess.Popen([BIN / "gaitway", "serve", "--port", str(port), "--out", out], stdout=subprocess.DEVNULL,
                                  stderr=subprocess.PIPE, text=True)
        for line in served.stderr:
            if "serves ws://" in line:
                break
        api = api_process(served.pid)
        before = (memory_kb(api), cpu_s(api), time.monotonic())
        result = {"clients": clients}
        peak = before[0]
        load = None
        if clients:
            load = subprocess.Popen([BIN / "api_load", "--port", str(port), "--clients", str(clients), "--silent", str(silent),
                                     "--seconds", str(seconds)], stdout=subprocess.PIPE, text=True)
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            time.sleep(1.0)
            peak = max(peak, memory_kb(api))
            print(f"\r  {clients} clients, {end - time.monotonic():5.0f} s to go", end="", file=sys.stderr)
        print("\r" + " " * 60 + "\r", end="", file=sys.stderr)
        result["api_memory_kb"] = {"before": before[0], "peak": peak, "after": memory_kb(api)}
        result["api_cpu_share"] = (cpu_s(api) - before[1]) / (time.monotonic() - before[2])
        if load:
            result["load"] = json.loads(load.communicate()[0])
            result["messages_per_s"] = result["load"]["messages"] / seconds
        served.send_signal(signal.SIGINT)
        served.stderr.read()
        served.wait(60)
        summary = json.loads((out / "summary.json").read_text())
        result.update({key: summary[key] for key in ("fell", "batches", "pace")})
        return result


parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("--seconds", type=float, default=30.0)
parser.add_argument("--clients", type=int, default=200)
parser.add_argument("--silent", type=int, default=10, help="of the clients: read nothing")
options = parser.parse_args()
print(json.dumps([run(options.seconds, 0, 0), run(options.seconds, options.clients, options.silent)], indent=1))
