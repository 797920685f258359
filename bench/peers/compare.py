#!/usr/bin/env python3
"""The project beside its peers: one table of ratios, each measured in rounds in which both sides take turns on this machine.

    ./dev bench --peers
    ./dev bench --peers --rows leg-ik,topics --rounds 3 --json out/peers.json
"""

from __future__ import annotations

import argparse
import json
import pathlib
import sys
import tempfile
from collections.abc import Sequence
from typing import Any, NoReturn

import machine
from contest import Contest, MeasurementError, NotHereError, Place
from framework import Jitter, Loading, Topics, WakeUp
from leg_ik import LegIk
from ratios import Row, table
from simulation import Chain, Vectors

SOURCE = pathlib.Path(__file__).resolve().parents[2]
CONTESTS: dict[str, type[Contest]] = {kind.name: kind for kind in (LegIk, Loading, Topics, WakeUp, Jitter, Chain, Vectors)}
BAD_INPUT, FAILED = 1, 3
MOST_ROUNDS = 1000


class Parser(argparse.ArgumentParser):
    def error(self, message: str) -> NoReturn:
        print(f"./dev bench --peers: {message}. --help tells more", file=sys.stderr)
        sys.exit(BAD_INPUT)


def options_of(arguments: Sequence[str]) -> argparse.Namespace:
    rows = "\n".join(f"  {name:9} {kind.about}" for name, kind in CONTESTS.items())
    parser = Parser(prog="./dev bench --peers", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter,
                    epilog=f"rows:\n{rows}\n\nA ratio is ours / peer, of times: below 1 the project is quicker, above 1 the peer.\n"
                           "exit code: 0 done (also where a peer is not available here), 1 bad input, 3 a measurement failed")
    parser.add_argument("--rows", metavar="A,B", type=chosen_rows, default=list(CONTESTS), help="only these, of those below")
    parser.add_argument("--rounds", type=round_count, default=5, help="how often each row is measured (default 5)")
    parser.add_argument("--json", metavar="OUT", type=pathlib.Path, help="machine and every round's figures, too, into this file")
    parser.add_argument("--bin", metavar="FOLDER", type=pathlib.Path, default=SOURCE / "build/release/bin", help="of the built programs")
    parser.add_argument("--plan", action="store_true", help="say what would be measured, and measure nothing")
    return parser.parse_args(arguments)


def chosen_rows(text: str) -> list[str]:
    names = [name.strip() for name in text.split(",")]
    for name in names:
        if name not in CONTESTS:
            raise argparse.ArgumentTypeError(f"there is no row '{name}'; there are {', '.join(CONTESTS)}")
    return list(dict.fromkeys(names))


def round_count(text: str) -> int:
    if not text.isdecimal() or not 1 <= int(text) <= MOST_ROUNDS:
        raise argparse.ArgumentTypeError(f"'{text}' is not a whole number from 1 to {MOST_ROUNDS}")
    return int(text)


def play(contest: Contest) -> None:
    """A round. What goes wrong is told in the contest's rows, and ends no other contest."""
    try:
        contest.play()
    except Exception as error:  # whatever a peer throws: the other rows are measured all the same
        rows = contest.rows.values() or [contest.rows.setdefault("all", Row(contest.about, "", ""))]
        for row in rows:
            if isinstance(error, NotHereError):
                row.missing = str(error)
            else:
                row.broken = str(error) if isinstance(error, MeasurementError) else f"{type(error).__name__}: {error}"


def play_all(contests: Sequence[Contest], rounds: int) -> None:
    """Round by round, so that a drift of the machine hits all rows."""
    for number in range(1, rounds + 1):
        for contest in contests:
            if any(row.broken for row in contest.rows.values()):
                continue
            print(f"round {number} of {rounds}: {contest.name}", file=sys.stderr, flush=True)
            play(contest)


def main(arguments: Sequence[str]) -> int:
    options = options_of(arguments)
    if options.json is not None and not options.json.resolve().parent.is_dir():
        print(f"./dev bench --peers: --json {options.json}: there is no such folder; make it first", file=sys.stderr)
        return BAD_INPUT
    if options.plan:
        print(f"{options.rounds} rounds of {', '.join(options.rows)}")
        return 0
    about: dict[str, Any] = machine.described()
    with tempfile.TemporaryDirectory(prefix="gaitway_peers_") as scratch:
        place = Place(SOURCE, options.bin.resolve(), pathlib.Path(scratch))
        contests = [CONTESTS[name](place) for name in options.rows]
        play_all(contests, options.rounds)
    about |= {"load_after": machine.load()}
    rows = [row for contest in contests for row in contest.rows.values()]
    print(machine.in_words(about, options.rounds), table(rows), sep="\n\n")
    if options.json is not None:
        result = {"machine": about, "rounds": options.rounds, "rows": [row.as_json() for row in rows]}
        options.json.write_text(json.dumps(result, indent=1, ensure_ascii=False) + "\n")
    return FAILED if any(row.broken for row in rows) else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
