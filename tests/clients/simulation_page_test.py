"""Plays a recorded walk without dynamics, and runs simulation_page_test.mjs: the report as a person handles it, from the disk."""
import json
import os
import subprocess
import tempfile
from pathlib import Path


def simulate(*arguments):
    return subprocess.run([os.environ["GAITWAY_COMMAND"], "simulate", *map(str, arguments)], capture_output=True, text=True, check=False)


def main():
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        subprocess.run([os.environ["GAITWAY_RECORDED_WALK"], folder, os.environ["GAITWAY_ROBOT"], os.environ["GAITWAY_CONFIG"],
                        os.environ["GAITWAY_PLUGIN_DIR"]], check=True)
        walk = simulate("zmp", folder / "walk.mcap", "--json")
        played = json.loads(walk.stdout)["played"][0]
        print(walk.stdout)
        assert played["kind"] == "recording" and played["rows"] > 400, walk
        for source in ("planned", "all_masses", "cells"):
            assert played["zmp"][source]["rows"] > 300, source
        assert played["zmp"]["solver"] is None
        assert walk.returncode == 0, walk

        # A neck that is turned too far for a while, beside the motion as it is.
        plan = folder / "wave.csv"
        subprocess.run([os.environ["GAITWAY_COMMAND"], "motion", "plan", "wave", "--out", plan], check=True)
        lines = plan.read_text().splitlines()
        column = lines[0].split(",").index("neck_pitch_rad")
        for row in range(101, 111):
            fields = lines[row].split(",")
            fields[column] = "2.5"
            lines[row] = ",".join(fields)
        changed = folder / "changed.csv"
        changed.write_text("\n".join(lines) + "\n")
        assert simulate("trajectory", changed, "--against", "wave", "--report", folder / "compared.html").returncode == 3
        assert simulate("zmp", folder / "walk.mcap", "--report", folder / "walk.html").returncode == 0
        script = Path(__file__).with_name("simulation_page_test.mjs")
        subprocess.run([os.environ["GAITWAY_NODE"], script, folder / "compared.html", folder / "walk.html"], check=True, timeout=100)


main()
