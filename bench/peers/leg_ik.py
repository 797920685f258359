"""A leg's inverse kinematics beside KDL, Pinocchio and TRAC-IK, on the same poses."""

from __future__ import annotations

import json
from typing import Any

from contest import Contest, json_of, run_program
from ratios import Pair, Row

PEERS = {"KDL LMA": "KDL, LMA", "KDL NR_JL": "KDL, NR_JL", "Pinocchio CLIK": "Pinocchio, CLIK, whole steps",
         "Pinocchio CLIK, step 0.1": "Pinocchio, CLIK, steps of 0.1", "TRAC-IK": "TRAC-IK (from Python)"}
NO_PINOCCHIO = "not there when this was configured: ./dev bench --peers puts it into .deps/peers"
NO_TRAC_IK = "pytracik is not in this Python: ./dev bench --peers puts it into .deps/peers"


class LegIk(Contest):
    name = "leg-ik"
    about = "a leg's angles from its foot's pose: KDL, Pinocchio, TRAC-IK"

    def play(self) -> None:
        trac_ik = self._trac_ik()
        for task, taken in json_of([self.program("leg_ik_peers")]).items():
            if task in trac_ik:
                taken["TRAC-IK"] = trac_ik[task].play()
            ours = taken["gaitway"]
            for peer, title in PEERS.items():
                row = Row(f"leg IK, {task}", title, "µs")
                if peer not in taken:
                    self.miss(f"{task} {peer}", row, NO_TRAC_IK if peer == "TRAC-IK" else NO_PINOCCHIO)
                    continue
                theirs = taken[peer]
                self.add(f"{task} {peer}", row, Pair(ours["ns"] * 1e-3, theirs["ns"] * 1e-3,
                                                     f"solved: {ours['solved']:.1%} and {theirs['solved']:.1%}"))

    def _trac_ik(self) -> dict[str, Any]:
        try:
            from trac_ik import TracIkTask
        except ImportError:
            return {}
        file = self.place.scratch / "leg_tasks.json"
        if not file.exists():
            run_program([self.program("leg_ik_peers"), file])
        return {task["name"]: TracIkTask(task) for task in json.loads(file.read_text())}
