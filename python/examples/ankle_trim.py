"""Balance in a few lines: a plug-in in Python, to the bit what docs/examples/ankle_trim.cpp is in C++.

    gaitway run --with ankle_trim.py
"""

import gaitway.plugin as gp


class AnkleTrim(gp.Plugin):
    """Presses the ankles against the trunk's lean."""

    name, version = "ankle_trim", "1.0.0"

    def __init__(self, setup: gp.Setup) -> None:
        self.gain = setup.parameter("gain", 0.25, "rad/rad")
        self.estimate = setup.reads("estimate")
        self.trim = setup.writes("trim")
        self.correction = setup.writes("correction")

    def step(self, tick: gp.Tick) -> None:
        roll, pitch = self.estimate.read()["attitude"][:2]
        trim = self.trim.value
        trim["stamp_ns"] = tick.now_ns
        trim["channel_count"] = 8
        trim["angle"][4:6] = self.gain * pitch  # ankle pitch, left and right
        trim["angle"][6:8] = self.gain * roll  # ankle roll
        self.trim.publish()
        self.correction.publish()  # no wish for the next batch: all zero
