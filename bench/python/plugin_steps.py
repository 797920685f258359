"""What a plug-in in Python costs, against the same law in C++, in the main controller's process and in one of its own.

    PYTHONPATH=build/release/lib/python python3 bench/python/plugin_steps.py [ROUNDS]
"""

import pathlib
import resource
import statistics
import sys
import tempfile

import gaitway

ROOT = pathlib.Path(__file__).resolve().parents[2]
CPP, PYTHON = "libgaitway_plugin_ankle_trim.so", ROOT / "python" / "examples" / "ankle_trim.py"
WAYS = {"C++": (CPP, "none"), "C++, process of its own": (CPP, "process"), "Python": (PYTHON, "process")}
SHORT_S, LONG_S, STEPS_A_SECOND = 0.5, 5.5, 100


def configuration(folder: pathlib.Path, library: object, isolation: str) -> pathlib.Path:
    file = folder / "bench.yaml"
    file.write_text(f"plugins:\n  - name: zmp\n  - name: trajectory\n  - name: ankle_trim\n    library: {library}\n"
                    f"    isolation: {isolation}\n  - name: kinematics\n")
    return file


def run(file: pathlib.Path, seconds: float) -> tuple[float, float]:
    """Median wall time of a step in us, and the processor time of the plug-in's process in s."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    with gaitway.Robot(config=file, seed=1) as robot:
        robot.run(seconds)
        told = robot.topic("plugin_statistics")
        index = [bytes(name).rstrip(b"\0") for name in told["name"]].index(b"ankle_trim")
        step_us = float(told["p50_step_ns"][index]) / 1e3
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return step_us, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def main() -> None:
    with tempfile.TemporaryDirectory() as folder:
        for way, (library, isolation) in WAYS.items():
            file = configuration(pathlib.Path(folder), library, isolation)
            rounds = []
            for _ in range(int(sys.argv[1]) if len(sys.argv) > 1 else 5):
                (_, start_s), (step_us, whole_s) = run(file, SHORT_S), run(file, LONG_S)
                cost_s = (whole_s - start_s) / ((LONG_S - SHORT_S) * STEPS_A_SECOND)
                rounds.append((step_us, cost_s * 1e6, start_s - cost_s * SHORT_S * STEPS_A_SECOND))
            step_us, cost_us, start_s = (statistics.median(column) for column in zip(*rounds, strict=True))
            print(f"{way:26} step {step_us:7.1f} us (median, waiting included); its process: {cost_us:5.1f} us of processor a step, "
                  f"{start_s:.2f} s to start", flush=True)


if __name__ == "__main__":
    main()
