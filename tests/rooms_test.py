#!/usr/bin/env python3
"""Rooms: who may include whom (DESIGN section 3), what files may be called, and what no room after the map may use.

Run from anywhere; reads the tree it stands in. Prints one line a breach.
"""
import re
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent

# From left to right; rooms of one row do not know each other.
ROWS = [
    ["compiler/contract"],
    ["compiler/geometry"],
    ["compiler/source", "compiler/materials", "grammars", "lsystems"],
    ["compiler/impostor"],
    ["compiler/map"],
    ["compiler/roads"],
    ["compiler/ground"],
    ["compiler/structures"],
    ["compiler/buildings"],
    ["compiler/plants"],
    ["compiler/props"],
    ["compiler/sky"],
    ["compiler/scene"],
    ["compiler/bake"],
    ["compiler"],  # spec, stage_watch, pipeline
    ["exporters"],
    ["preview", "compiler/verify"],
    ["compiler/charts"],
    ["compiler/commands"],
    ["main"],  # compiler/main.cpp
]
ROW_OF = {room: i for i, row in enumerate(ROWS) for room in row}

# What a room may not see although it lies to the left: patterns over the included path.
BLIND_TO = {
    "exporters": r"compiler/source/|grammars/|lsystems/|compiler/[^/]+\.h$|.*/(plan|expand)\.h$",
    "preview": r"grammars/|lsystems/|compiler/source/read_|compiler/[^/]+\.h$|.*/plan\.h$",
    "main": r"(?!compiler/commands/)",
}

NAMELESS = re.compile(r"(^|_)(util|utils|common|helper|helpers|manager|misc|core|stuff|tools?)(_|$)")

# Their last bits differ between CPUs and libraries; the domain rooms do without (DESIGN section 8.7).
UNEQUAL = re.compile(r"<random>|std::hash\b|std::(a?sinh?|a?cosh?|a?tanh?|atan2|exp2?|expm1|pow|log(2|10|1p)?|cbrt|hypot)\(")
MUST_BE_EQUAL = ["grammars", "lsystems"] + [room for row in ROWS[4:14] for room in row]
# light that only pictures show
MAY_DIFFER = [Path("compiler/sky/generate.cpp"), Path("compiler/sky/sunlight.cpp")]


def sources():
    for top in ("compiler", "exporters", "preview", "grammars", "lsystems"):
        for path in sorted((ROOT / top).rglob("*")):
            if path.suffix in (".h", ".cpp", ".inc"):
                yield path.relative_to(ROOT)


def room_of(path):
    if str(path) == "compiler/main.cpp":
        return "main"
    parts = path.parts
    return "/".join(parts[:2]) if parts[0] == "compiler" and len(parts) > 2 else parts[0]


def quoted_includes(path):
    for number, line in enumerate((ROOT / path).read_text().splitlines(), 1):
        found = re.match(r'\s*#\s*include\s+"([^"]+)"', line)
        if found:
            yield number, found.group(1)


def breach_of_include(path, included):
    own, other = room_of(path), room_of(Path(included))
    if other not in ROW_OF:
        return f"{included} is in no room"
    if own == other:
        return None
    if ROW_OF[other] >= ROW_OF[own]:
        return f"{own} lies left of, or beside, {other}"
    if own in BLIND_TO and re.match(BLIND_TO[own], included):
        return f"{own} does not look into {included}"
    return None


class Rooms(unittest.TestCase):
    def assertNone(self, breaches):
        self.assertEqual(breaches, [], "\n" + "\n".join(breaches))

    def test_includes_run_from_right_to_left(self):
        breaches = []
        for path in sources():
            for number, included in quoted_includes(path):
                breach = breach_of_include(path, included)
                if breach:
                    breaches.append(f"{path}:{number}: {breach}")
        self.assertNone(breaches)

    def test_includes_name_files_from_the_root(self):
        breaches = []
        for path in sources():
            for number, included in quoted_includes(path):
                if not (ROOT / included).exists() and not included.endswith("_generated.h"):
                    breaches.append(f"{path}:{number}: there is no {included}")
        self.assertNone(breaches)

    def test_every_room_is_in_a_row(self):
        self.assertNone([f"{path}: its room is in no row" for path in sources() if room_of(path) not in ROW_OF])

    def test_a_source_includes_its_own_header_first(self):
        breaches = []
        for path in sources():
            header = path.with_suffix(".h")
            if path.suffix != ".cpp" or not (ROOT / header).exists():
                continue
            first = next((included for _, included in quoted_includes(path)), None)
            if first != str(header):
                breaches.append(f"{path}: {header} comes first")
        self.assertNone(breaches)

    def test_headers_are_read_once(self):
        self.assertNone([f"{path}: lacks #pragma once" for path in sources()
                         if path.suffix == ".h" and "#pragma once" not in (ROOT / path).read_text()])

    def test_everything_has_a_name(self):
        breaches = []
        for top in ("compiler", "exporters", "preview", "grammars", "lsystems", "tests", "examples"):
            for path in sorted((ROOT / top).rglob("*")):
                if "node_modules" not in path.parts and NAMELESS.search(path.stem):
                    breaches.append(f"{path.relative_to(ROOT)}: named after what could not be named")
        self.assertNone(breaches)

    def test_rooms_after_the_map_use_nothing_that_differs_between_machines(self):
        breaches = []
        for path in sources():
            if room_of(path) not in MUST_BE_EQUAL or path in MAY_DIFFER:
                continue
            for number, line in enumerate((ROOT / path).read_text().splitlines(), 1):
                if UNEQUAL.search(line.split("//")[0]):
                    breaches.append(f"{path}:{number}: {line.strip()}")
        self.assertNone(breaches)

    def test_nothing_is_left_to_do_later(self):
        breaches = []
        for path in sources():
            for number, line in enumerate((ROOT / path).read_text().splitlines(), 1):
                if re.search(r"\b(TODO|FIXME|XXX|HACK)\b", line):
                    breaches.append(f"{path}:{number}: {line.strip()}")
        self.assertNone(breaches)


if __name__ == "__main__":
    sys.exit(unittest.main(argv=[sys.argv[0], "-v"]))
