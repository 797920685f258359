#!/usr/bin/env python3
"""How late the message controller's loop of 1 ms wakes, beside cyclictest (Debian: rt-tests) at the same priority and period in the
same seconds, while a simulated robot walks. Several rounds, each with processes of its own; a round's figure is the ratio of both p99.

    python3 bench/msgcontroller/loop_jitter.py --bin build/release/bin --rounds 6 --seconds 20
"""

import argparse
import json
import pathlib
import re
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

SOURCE = pathlib.Path(__file__).resolve().parents[2]
ROBOT = SOURCE / "urdf/humanoid22"
CONFIG = SOURCE / "core/config/walk.yaml"
PRIORITY = 70  # the message controller's own
BUCKETS_US = 20_000


def until_there(path, seconds=20.0):
    end = time.monotonic() + seconds
    while not path.exists():
        if time.monotonic() > end:
            sys.exit(f"loop_jitter: {path} does not come")
        time.sleep(0.01)


def cyclictest_us(text):
    """p50, p99, p99.9 and the largest of a histogram as `cyclictest -h` prints it."""
    counts = [(int(us), int(count)) for us, count in re.findall(r"^(\d{6}) (\d{6,})$", text, re.MULTILINE)]
    overflows = sum(int(n) for n in re.findall(r"^# Histogram Overflows: (\d+)$", text, re.MULTILINE))
    largest = int(re.search(r"^# Max Latencies: (\d+)$", text, re.MULTILINE).group(1))
    total = sum(count for _, count in counts) + overflows

    def percentile(share):
        seen = 0
        for us, count in counts:
            seen += count
            if seen >= share * total:
                return us
        return largest

    return {"p50": percentile(0.5), "p99": percentile(0.99), "p999": percentile(0.999), "max": largest, "samples": total}


def play(bin_dir, seconds):
    with tempfile.TemporaryDirectory(prefix="gaitway_jitter_") as name:
        folder = pathlib.Path(name)
        quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
        robot = subprocess.Popen([bin_dir / "virtual_robot", "--robot", ROBOT, "--bus", folder / "bus"], **quiet)
        parts = [robot]
        try:
            until_there(folder / "bus")
            message = subprocess.Popen(
                [bin_dir / "message_controller", "--robot", ROBOT, "--bus", folder / "bus", "--memory", folder / "memory",
                 "--walk", "0.2,0,0", "--walk-after", "2", "--seconds", str(seconds), "--summary", folder / "message.json"], **quiet)
            parts.append(message)
            until_there(folder / "memory")
            parts.append(subprocess.Popen(
                [bin_dir / "main_controller", "--supervised", "--socket", folder / "memory", "--robot", ROBOT, "--config", CONFIG], **quiet))
            beside = subprocess.run(
                ["cyclictest", "--quiet", "--mlockall", f"--priority={PRIORITY}", "--interval=1000", f"--duration={seconds}",
                 f"--histogram={BUCKETS_US}"], capture_output=True, text=True, check=True)
            message.wait(timeout=30)
            summary = json.loads((folder / "message.json").read_text())
        finally:
            for part in reversed(parts):
                part.terminate()
            for part in parts:
                part.wait()
    return summary, cyclictest_us(beside.stdout)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", type=pathlib.Path, default=SOURCE / "build/release/bin", help="folder of the programs")
    parser.add_argument("--rounds", type=int, default=6)
    parser.add_argument("--seconds", type=int, default=20, help="of each round")
    options = parser.parse_args()
    if shutil.which("cyclictest") is None:
        sys.exit("loop_jitter: cyclictest is not installed; on Debian: apt-get install rt-tests")
    print("| round | message controller p50, p99, max us | cyclictest p50, p99, p99.9, max us | p99 / p99 |\n|---|---|---|---|")
    ratios = []
    for number in range(1, options.rounds + 1):
        summary, beside = play(options.bin.resolve(), options.seconds)
        own = summary["wake_up_latency_us"]
        ratios.append(own["p99"] / beside["p99"])
        print(f"| {number} | {own['p50']:.0f}, {own['p99']:.0f}, {own['max']:.0f} | {beside['p50']}, {beside['p99']}, {beside['p999']}, "
              f"{beside['max']} | {ratios[-1]:.2f} |", flush=True)
    print(f"\nRatio of p99: median {statistics.median(ratios):.2f}, {min(ratios):.2f} to {max(ratios):.2f}.")


if __name__ == "__main__":
    main()
