#!/usr/bin/env python3
"""Checks one model with Spin: every state of it, or that a mutation of it is found.

The search is exhaustive and must have been complete: neither the memory nor the depth that it was given ran
out. Every line of the model must have been reached, but for those that say `// unreached`: a model whose
steps cannot happen shows nothing.
"""
import argparse
import os
import pathlib
import re
import resource
import shutil
import subprocess
import sys
import tempfile

SKIPPED = 77


def arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("model", type=pathlib.Path)
    parser.add_argument("--define", "-D", action="append", default=[], metavar="NAME[=VALUE]")
    parser.add_argument("--found", metavar="TEXT",
                        help="the model is wrong on purpose: Spin must find an error that names TEXT")
    parser.add_argument("--liveness", metavar="NAME", help="check this LTL property, weakly fair, instead of the assertions")
    parser.add_argument("--collapse", action="store_true", help="less memory, more time")
    parser.add_argument("--depth", type=int, default=100_000)
    parser.add_argument("--memory-mb", type=int, default=1500)
    return parser.parse_args()


def run(*command: str, folder: pathlib.Path) -> str:
    done = subprocess.run(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"{' '.join(command)}: exit code {done.returncode}\n{done.stdout}")
    return done.stdout


def flatten(options: argparse.Namespace, folder: pathlib.Path) -> list[str]:
    """One file without includes and conditions, comments kept: Spin's line numbers then name one line each."""
    defines = [f"-D{name}" for name in options.define]
    run("gcc", "-E", "-P", "-C", "-undef", "-nostdinc", "-x", "c", *defines, str(options.model.resolve()), "-o", "flat.pml", folder=folder)
    return (folder / "flat.pml").read_text().splitlines()


def search(options: argparse.Namespace, folder: pathlib.Path) -> str:
    property_name = ["-N", options.liveness] if options.liveness else []
    run("spin", "-a", "-o3", "flat.pml", folder=folder)  # -o3: each statement a step, so that each can be seen as reached
    kind = ["-DNFAIR=4"] if options.liveness else ["-DSAFETY", "-DNOCLAIM"]
    if options.collapse:
        kind.append("-DCOLLAPSE")
    # A wrong model is found within seconds; a right one is searched to its end and pays for optimising.
    level = "-O0" if options.found else "-O2"
    run("gcc", "-w", level, *kind, f"-DMEMLIM={options.memory_mb}", "-o", "pan", "pan.c", folder=folder)
    flags = ["-a", "-f", *property_name] if options.liveness else []
    return run("./pan", *flags, f"-m{options.depth}", folder=folder)


def incomplete(report: str) -> str:
    """Why the search was not one of all states; empty: it was."""
    for sign in ("max search depth too small", "pan: reached -DMEMLIM", "Search not completed", "out of memory"):
        if sign in report:
            return sign
    return "" if "Full statespace search" in report else "no full search"


def unreached(report: str, lines: list[str]) -> list[str]:
    found = []
    report = re.sub(r"^unreached in claim .*?(?=^unreached in|^pan:|\Z)", "", report, flags=re.MULTILINE | re.DOTALL)
    for number, text in re.findall(r"^\t\S+?:(\d+), state \d+, \"(.*)\"$", report, re.MULTILINE):
        line = lines[int(number) - 1] if int(number) <= len(lines) else ""
        if text != "-end-" and "// unreached" not in line:
            found.append(f"line {number}: {line.strip()}   ({text})")
    return sorted(set(found))


def told(report: str) -> str:
    states = re.search(r"(\d+) states, stored", report)
    memory = re.search(r"([\d.]+)\s+total actual memory usage", report)
    depth = re.search(r"depth reached (\d+)", report)
    child = resource.getrusage(resource.RUSAGE_CHILDREN)
    return (f"{states[1]} states, depth {depth[1]}, {memory[1]} MB, "
            f"{child.ru_utime + child.ru_stime:.1f} s of processor time")


def verdict(options: argparse.Namespace, report: str, lines: list[str]) -> str:
    """What is wrong; empty: the test has passed."""
    errors = re.search(r"errors: (\d+)", report)
    if errors is None:
        return "Spin reports no number of errors"
    if options.found:
        error = re.search(r"^pan:1: (.*)$", report, re.MULTILINE)
        if errors[1] == "0":
            return "the mutation was not found"
        return "" if error and options.found in error[1] else f"another error than '{options.found}' was found: {error and error[1]}"
    if errors[1] != "0":
        return "an error was found"
    if sign := incomplete(report):
        return f"not all states were searched: {sign}"
    if not options.liveness and (never := unreached(report, lines)):
        return "steps that never happened:\n  " + "\n  ".join(never)
    return ""


def trail(folder: pathlib.Path) -> str:
    trails = list(folder.glob("*.trail"))
    if not trails:
        return ""
    done = subprocess.run(["spin", "-t", "-p", "flat.pml"], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True, check=False)
    return "the way there:\n" + "\n".join(done.stdout.splitlines()[-400:])


def main() -> int:
    options = arguments()
    if shutil.which("spin") is None or shutil.which("gcc") is None:
        print("spin or gcc is missing: install the Debian packages spin and gcc")
        return 1 if os.environ.get("GAITWAY_REQUIRE_SPIN") else SKIPPED
    with tempfile.TemporaryDirectory(prefix="gaitway_model_") as name:
        folder = pathlib.Path(name)
        lines = flatten(options, folder)
        report = search(options, folder)
        wrong = verdict(options, report, lines)
        if wrong:
            print(report)
            print(trail(folder))
            print(f"{options.model.name} {' '.join(options.define)}: {wrong}")
            return 1
        print(f"{options.model.name} {' '.join(options.define)}: {told(report)}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
