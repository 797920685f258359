"""Trials that cost next to nothing, to try a cluster with: a chain of hashes, and a sleep where one is asked for."""

from __future__ import annotations

import hashlib
import math
import time
from pathlib import Path

from .canonical import Json, files_hash

HASHES_PER_S = 1.5e6


class Rehearsals:
    """`rounds` hashes of the description's numbers, after `sleep_s`."""

    measures = ("value", "digest")

    def code(self) -> str:
        return files_hash({"rehearsal": Path(__file__)})

    def probe(self) -> str:
        return str(self.run({"seed": 1, "rounds": 1000})["digest"])

    def check(self, description: Json) -> None:
        rounds, sleep_s = description.get("rounds", 1), description.get("sleep_s", 0.0)
        if not (math.isfinite(rounds) and rounds >= 1 and math.isfinite(sleep_s) and sleep_s >= 0):
            raise ValueError(f"rounds {rounds}, sleep_s {sleep_s}: must be finite, and at least 1 and 0")

    def run(self, description: Json) -> Json:
        self.check(description)
        sleep_s = description.get("sleep_s", 0.0)
        if sleep_s:
            time.sleep(sleep_s)
        start = ",".join(f"{name}={description[name]!r}" for name in sorted(description) if name != "sleep_s")
        digest = start.encode()
        for _ in range(int(description.get("rounds", 1))):
            digest = hashlib.sha256(digest).digest()
        return {"value": int.from_bytes(digest[:4], "big") / 2**32, "digest": digest[:8].hex()}

    def expected_s(self, description: Json) -> float:
        return float(description.get("sleep_s", 0.0)) + float(description.get("rounds", 1)) / HASHES_PER_S
