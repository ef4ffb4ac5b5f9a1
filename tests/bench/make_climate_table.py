#!/usr/bin/env python3
"""Writes compiler/climate/climate_cells.inc, the climate class of each half degree of land, from a text of the classes. By hand:

    tests/bench/make_climate_table.py FILE

FILE has lines of comment that begin with "#", one of which lists letters and classes ("A=Af B=Am …"), then 360 rows of 720 letters from
north-west to south-east, "." for sea: Kottek et al. 2006, "World map of the Köppen-Geiger climate classification updated", Meteorologische
Zeitschrift 15, 259-263, whose values are free to use with this citation (koeppen-geiger.vu-wien.ac.at). Each row becomes runs: the number
of cells, if it is not 1, then their letter, "." for sea. Sea at the end of a row and rows of sea alone are left out.
"""
import itertools
import re
import sys
from pathlib import Path

OUT = Path(__file__).resolve().parent.parent.parent / "compiler/climate/climate_cells.inc"
ROWS, COLUMNS, WIDEST = 360, 720, 110
HEAD = """\
// Written by tests/bench/make_climate_table.py: do not edit.
// Classes of climate by half degree of land, 1951 to 2000. Source: Kottek, Grieser, Beck, Rudolf, Rubel, "World map of the
// Köppen-Geiger climate classification updated", Meteorologische Zeitschrift 15 (2006), 259-263; values free with this citation.
// CLIMATE_ROW(row from north, 0 to 359; runs from west, 180° W): a run is a number of cells, none for 1, and a letter of
// climate_classes.inc; "." is sea, and so is what follows the last run.
// clang-format off
"""


def read_cells(path):
    """The letters' classes and the rows of letters."""
    lines = Path(path).read_text().splitlines()
    classes = dict(re.findall(r"(\w)=(\w+)", " ".join(line for line in lines if line.startswith("#"))))
    rows = [line for line in lines if not line.startswith("#")]
    assert len(rows) == ROWS and all(len(row) == COLUMNS for row in rows)
    assert set("".join(rows)) <= set(classes) | {"."}
    return classes, rows


def runs_of(row):
    groups = [(letter, len(list(group))) for letter, group in itertools.groupby(row.rstrip("."))]
    return [f"{count if count > 1 else ''}{letter}" for letter, count in groups]


def literal_lines(runs):
    """The runs as string literals, each on a line."""
    lines, line = [], ""
    for run in runs:
        if len(line) + len(run) > WIDEST:
            lines, line = [*lines, line], ""
        line += run
    return [*lines, line]


def main():
    classes, rows = read_cells(sys.argv[1])
    text = HEAD
    for number, row in enumerate(rows):
        if row.strip("."):
            text += f"CLIMATE_ROW({number},\n" + "\n".join(f'  "{line}"' for line in literal_lines(runs_of(row))) + ")\n"
    OUT.write_text(text + "#undef CLIMATE_ROW\n")
    print(f"{OUT}: {len(text)} bytes; " + " ".join(f"{letter}={name}" for letter, name in classes.items()))


if __name__ == "__main__":
    main()
