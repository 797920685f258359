#!/usr/bin/env python3
"""Compares the steps that the models take with those that the code names, so that neither goes on alone."""
import pathlib
import re
import sys


def steps(folder: pathlib.Path, suffixes: set[str]) -> dict[str, str]:
    """Each step, and where it is named first. `// model: publish.1, publish.2` names two."""
    found: dict[str, str] = {}
    for path in sorted(folder.rglob("*")):
        if path.suffix not in suffixes:
            continue
        for number, line in enumerate(path.read_text().splitlines(), 1):
            if named := re.search(r"// model: (.*)$", line):
                for step in re.findall(r"\b[a-z_]+\.\d+\b", named[1]):
                    found.setdefault(step, f"{path.name}:{number}")
    return found


def main() -> int:
    models, code = (pathlib.Path(argument) for argument in sys.argv[1:3])
    modelled = steps(models, {".pml"})
    named = steps(code, {".cpp", ".hpp"})
    for step in sorted(modelled.keys() - named.keys()):
        print(f"{modelled[step]}: step {step} is named nowhere in {code}")
    for step in sorted(named.keys() - modelled.keys()):
        print(f"{named[step]}: no model takes step {step}")
    print(f"{len(modelled)} steps of the models, {len(named)} named in the code")
    return 0 if modelled and modelled.keys() == named.keys() else 1


if __name__ == "__main__":
    sys.exit(main())
