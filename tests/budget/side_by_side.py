#!/usr/bin/env python3
"""Prints the budget's figures of two programs side by side: side_by_side.py BASE BRANCH > table.md

The maps are invented by BRANCH; an output or option that BASE does not have is left out.
"""
import sys
import tempfile
from pathlib import Path

import measure
import table


def rows_of(program, scratch):
    rows = {}
    for name, words in measure.maps(scratch):
        rows |= {(name, *key): value for key, value in measure.rows_of_run(words, scratch, program).items()}
    return rows


def main():
    base, branch = (str(Path(path).resolve()) for path in sys.argv[1:3])
    measure.PROGRAM = branch
    with tempfile.TemporaryDirectory(prefix="citykiln_budget_") as scratch:
        old, new = (rows_of(program, Path(scratch)) for program in (base, branch))
    print(table.side_by_side(old, new, dict.fromkeys([*old, *new]), ("base", "branch")))


if __name__ == "__main__":
    main()
