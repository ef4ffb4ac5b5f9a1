#!/usr/bin/env python3
"""Compares the outputs of each golden case with its expected.json. A case is a folder with map.osm, args (words of the command line),
expected.json, and optionally heights.asc. Paths in args are relative to the root of the tree. Differences in measures show what
changed; hashes show any change of bytes.
Nothing is assumed, unless args says what (--assume): the bytes of most cases show what is mapped alone.

To add a case, make the folder and run `golden_test.py --update`; no code is needed.
"""
import hashlib
import json
import sys
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "properties"))

from citykiln_program import ProgramTest, bytes_of_outputs, report_of, run, sha256  # noqa: E402

UPDATE = "--update" in sys.argv


def cases():
    return sorted(path.parent for path in HERE.glob("*/args"))


def hash_of(outputs, ending):
    """One hash of all files with this ending, in the order of their names."""
    together = hashlib.sha256()
    for name, digest in sorted(outputs.items()):
        if name.endswith(ending):
            together.update(f"{name} {digest}\n".encode())
    return together.hexdigest()


def hashes_of(out):
    """A hash for each kind of output; those of USD and of the tileset where the case writes them (--emit)."""
    outputs = bytes_of_outputs(out)
    hashes = {"kiln": hash_of(outputs, ".kiln"), "glb": hash_of(outputs, ".glb")}
    for kind, folder, ending in (("usd", "usd", (".usda", ".usdc")), ("3dtiles", "3dtiles", ".json")):
        files = {str(path.relative_to(out)): sha256(path) for path in (out / folder).rglob("*") if path.is_file()}
        if files:
            hashes[kind] = hash_of(files, ending)
    return hashes


def measured(out):
    report = report_of(out)
    assumed = report["assumed"]
    return {
        "measures": {
            "counts": report["counts"],
            "region_m": report["region_m"],
            "levels": [{key: level[key] for key in ("tolerance_m", "error_m", "triangles")} for level in report["levels"]],
            "instances": [sum(t["instances"] for t in report["tiles"] if t["level"] == level["level"]) for level in report["levels"]],
            "diagnoses": {name: tally["count"] for name, tally in report["diagnoses"].items()},
        } | ({"assumed": assumed} if any(assumed.values()) else {}),
        "sha256": hashes_of(out),
    }


class Golden(ProgramTest):
    maxDiff = None

    def test_there_are_cases(self):
        self.assertTrue(cases())

    def compare(self, case):
        words = (case / "args").read_text().split()
        if "--assume" not in words:
            words += ["--assume", "none"]
        heights = ["--dem", case / "heights.asc"] if (case / "heights.asc").exists() else []
        out = self.folder / "out"
        done = run("compile", case / "map.osm", *heights, *words, "-o", out)
        self.assertEqual(done.returncode, 0, done.stderr)
        found = measured(out)
        self.assertTrue(report_of(out)["balances"])
        expected = case / "expected.json"
        if UPDATE:
            expected.write_text(json.dumps(found, indent=1) + "\n")
        self.assertEqual(found, json.loads(expected.read_text()))


def claim_of(case):
    return lambda self: self.compare(case)


for golden_case in cases():
    setattr(Golden, f"test_{golden_case.name}", claim_of(golden_case))

if __name__ == "__main__":
    unittest.main(argv=[word for word in sys.argv if word != "--update"])
