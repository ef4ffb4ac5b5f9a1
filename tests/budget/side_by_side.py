#!/usr/bin/env python3
"""Prints the budget's figures of two programs side by side: side_by_side.py BASE BRANCH > table.md

The maps are invented by BRANCH. BASE must know the options of measure.py; rows that only one of both has are shown, too.
"""
import sys
import tempfile
from pathlib import Path

import measure
import table


def rows_of(program, maps, scratch):
    rows = {}
    for name, words in maps.items():
        rows |= {(name, *key): value for key, value in measure.rows_of_run(words, scratch, program).items()}
    return rows


def main():
    base, branch = (str(Path(path).resolve()) for path in sys.argv[1:3])
    with tempfile.TemporaryDirectory(prefix="citykiln_budget_") as scratch:
        maps = dict(measure.maps(Path(scratch), branch))
        old, new = (rows_of(program, maps, Path(scratch)) for program in (base, branch))
    print(table.side_by_side(old, new, dict.fromkeys([*old, *new]), ("base", "branch")))


if __name__ == "__main__":
    main()
