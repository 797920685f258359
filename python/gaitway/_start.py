"""Where the programs in Python begin. All that they need is imported here, so that what is missing is told in a line, and so that
Ctrl-C, before anything is under way, just ends them."""

from __future__ import annotations

import importlib
import signal
import sys


def sweep() -> int:
    return _start("gaitway sweep", "gaitway.sweep.command")


def tune() -> int:
    return _start("gaitway tune", "gaitway.tune.command")


def measure_on() -> int:
    return _start("gaitway measure gait", "gaitway.measure.command")


def _start(name: str, module: str) -> int:
    is_heard = signal.getsignal(signal.SIGINT) is signal.default_int_handler  # not in the background of a script
    if is_heard:
        signal.signal(signal.SIGINT, signal.SIG_DFL)
    try:
        program = importlib.import_module(module)
    except ImportError as error:
        print(f"{name}: {error}", file=sys.stderr)
        return 1
    if is_heard:
        signal.signal(signal.SIGINT, signal.default_int_handler)
    return int(program.main())
