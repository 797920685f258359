"""What a plug-in in Python costs, against the same law in C++, in the main controller's process and in one of its own.

    PYTHONPATH=build/release/lib/python python3 bench/python/plugin_steps.py
"""

import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

import gaitway

ROOT = pathlib.Path(__file__).resolve().parents[2]
CPP, PYTHON = "libgaitway_plugin_ankle_trim.so", ROOT / "python" / "examples" / "ankle_trim.py"
WAYS = {"C++": (CPP, "none"), "C++, process of its own": (CPP, "process"), "Python": (PYTHON, "process")}
ROUNDS = 5


def configuration(folder: pathlib.Path, library: object, isolation: str) -> pathlib.Path:
    file = folder / "bench.yaml"
    file.write_text(f"plugins:\n  - name: zmp\n  - name: trajectory\n  - name: ankle_trim\n    library: {library}\n"
                    f"    isolation: {isolation}\n  - name: kinematics\n")
    return file


def measure(file: pathlib.Path) -> tuple[float, float, float]:
    """Median and 99th percentile of a step in us, and how long a robot takes to be there in s."""
    began = time.perf_counter()
    with gaitway.Robot(config=file, seed=1) as robot:
        there = time.perf_counter() - began
        robot.run(4.0)
        told = robot.topic("plugin_statistics")
        index = [bytes(name).rstrip(b"\0") for name in told["name"]].index(b"ankle_trim")
        return float(told["p50_step_ns"][index]) / 1e3, float(told["p99_step_ns"][index]) / 1e3, there


def main() -> None:
    found: dict[str, list[tuple[float, float, float]]] = {way: [] for way in WAYS}
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(ROUNDS):
            for way, (library, isolation) in WAYS.items():
                found[way].append(measure(configuration(pathlib.Path(folder), library, isolation)))
    for way, rounds in found.items():
        p50_us, p99_us, there_s = (statistics.median(column) for column in zip(*rounds, strict=True))
        print(f"{way:26} step p50 {p50_us:6.1f} us, p99 {p99_us:6.1f} us; robot there after {there_s:.2f} s")
    began = time.perf_counter()
    subprocess.run([sys.executable, "-c", "import gaitway.plugin"], check=True)
    print(f"{'interpreter and modules':26} {time.perf_counter() - began:.2f} s")


if __name__ == "__main__":
    main()
