"""The framework beside its peers: plug-ins loaded, topics written and read, processes woken, loops on time."""

from __future__ import annotations

import importlib.util
import shutil
from typing import Any

from contest import Contest, MeasurementError, NotHereError, counters, json_of, run_program
from ratios import Pair, Row

JITTER_ROUND_S = 10
CYCLICTEST = ["cyclictest", "--quiet", "--mlockall", "--priority=70", "--interval=1000", "--duration=1"]


class Loading(Contest):
    name = "loading"
    about = "a plug-in loaded, created, destroyed and unloaded: ROS's class_loader"

    def play(self) -> None:
        program = self.program("plugin_loading_bench")
        for key, what in (("load_and_create", "plug-in: load, create, destroy, unload"), ("create_instance", "plug-in: create, destroy")):
            row = Row(what, "ROS class_loader", "µs")
            try:
                found = counters(program, key)
            except NotHereError as error:
                self.miss(key, row, str(error))
                continue
            remark = f"{found['copy_us']:.0f} µs of ours: a copy of the library" if "copy_us" in found else ""
            self.add(key, row, Pair(found["p50_us"], found["class_loader_us"], remark))


class Topics(Contest):
    name = "topics"
    about = "a topic written and read: a raw seqlock, iceoryx"

    def play(self) -> None:
        for size, taken in json_of([self.program("topic_peers")]).items():
            for peer in ("seqlock", "iceoryx"):
                row = Row(f"topic of {size}: write and read", "raw seqlock" if peer == "seqlock" else "iceoryx 2.0", "ns")
                if peer in taken:
                    self.add(f"{size} {peer}", row, Pair(taken["gaitway"]["ns"], taken[peer]["ns"]))
                else:
                    self.miss(f"{size} {peer}", row, "not there when this was configured: apt-get install libiceoryx-posh-dev")


class WakeUp(Contest):
    name = "wake-up"
    about = "what a process of its own adds to a plug-in's step: a round trip over a bare futex"

    def play(self) -> None:
        program = self.program("core_bench")
        for key, what in (("added_delay_paced", "isolated plug-in, a step every ms: wake-up round trip"),
                          ("added_delay_back_to_back", "isolated plug-in, step after step: wake-up round trip")):
            found = counters(program, key)
            self.add(f"{key} futex", Row(what, "bare futex", "µs"), Pair(found["added_p50_us"], found["futex_p50_us"], "medians"))
            self.add(f"{key} spin", Row(what, "futex that spins first, as ours does", "µs"), Pair(found["added_p50_us"], found["spin_p50_us"], "medians"))


class Jitter(Contest):
    name = "jitter"
    about = "how late the message controller's loop wakes: cyclictest in the same seconds"

    def play(self) -> None:
        rows = {"p50": Row("loop of 1 ms: wake-up latency, p50", "cyclictest", "µs"),
                "p99": Row("loop of 1 ms: wake-up latency, p99", "cyclictest", "µs")}
        why = self._why_not()
        for key, row in rows.items():
            if why:
                self.miss(key, row, why)
        if why:
            return
        try:
            summary, beside = self._loop_jitter().play(self.place.programs, JITTER_ROUND_S)
        except SystemExit as error:  # as a script it ends with what went wrong
            raise MeasurementError(str(error)) from error
        own = summary["wake_up_latency_us"]
        for key, row in rows.items():
            # cyclictest counts whole µs: 0 there is less than one.
            self.add(key, row, Pair(own[key], max(beside[key], 1), f"a robot walks meanwhile; largest {own['max']:.0f} and {beside['max']:.0f} µs"))

    @staticmethod
    def _why_not() -> str:
        if shutil.which("cyclictest") is None:
            return "cyclictest is not installed: apt-get install rt-tests"
        try:
            run_program([*CYCLICTEST], 30)
        except MeasurementError as error:
            return f"{error} (it wants root, or CAP_SYS_NICE)"
        return ""

    def _loop_jitter(self) -> Any:
        path = self.place.source / "bench/msgcontroller/loop_jitter.py"
        spec = importlib.util.spec_from_file_location("loop_jitter", path)
        assert spec is not None and spec.loader is not None
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
        return module
