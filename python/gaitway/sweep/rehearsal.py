"""Trials that cost next to nothing, to try a cluster with: a chain of hashes, a sleep and an error where one is asked for."""

from __future__ import annotations

import hashlib
import time
from pathlib import Path

from .canonical import Json, files_hash

HASHES_PER_S = 1.5e6
LIMITS = {"rounds": (1, 1e9), "sleep_s": (0, 86400), "error_share": (0, 1)}


class Rehearsals:
    """`rounds` hashes of the description's numbers, after `sleep_s`; `error_share` of them end in an error."""

    measures = ("value", "digest")

    def code(self) -> str:
        return files_hash({"rehearsal": Path(__file__)})

    def probe(self) -> str:
        return str(self.run({"seed": 1, "rounds": 1000})["digest"])

    def check(self, description: Json) -> None:
        for name, (lowest, highest) in LIMITS.items():
            value = description.get(name, lowest)
            if isinstance(value, bool) or not isinstance(value, int | float) or not lowest <= value <= highest:
                raise ValueError(f"{name} = {value!r}: must be a number, {lowest:g} to {highest:g}")

    def run(self, description: Json) -> Json:
        self.check(description)
        sleep_s = description.get("sleep_s", 0.0)
        if sleep_s:
            time.sleep(sleep_s)
        start = ",".join(f"{name}={description[name]!r}" for name in sorted(description) if name != "sleep_s")
        digest = start.encode()
        for _ in range(int(description.get("rounds", 1))):
            digest = hashlib.sha256(digest).digest()
        value = int.from_bytes(digest[:4], "big") / 2**32
        if value < description.get("error_share", 0.0):
            raise ValueError(f"a rehearsed error, of {value:.3g}")
        return {"value": value, "digest": digest[:8].hex()}

    def expected_s(self, description: Json) -> float:
        return float(description.get("sleep_s", 0.0)) + float(description.get("rounds", 1)) / HASHES_PER_S
