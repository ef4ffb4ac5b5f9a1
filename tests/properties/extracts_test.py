#!/usr/bin/env python3
"""Every real extract, and every map in broken/, compiles: no crash, a ledger that balances, and tiles without errors or warnings from
Khronos' glTF validator, where that is installed; two large extracts are compiled to a manifest alone. Small places run always, the others with ./test.sh --full. No building of an extract is lost:
each is planned, replaced by its parts, or outside of the extent by its centroid, and diagnosed. Fewer than one roof in 200 is flat because
the mapped roof could not be built."""
import shutil
import subprocess
import unittest
from pathlib import Path

from citykiln_program import DATA, ROOT, ProgramTest, long_test, report_of, run

# Extracts that compile in seconds: with slopes, a city's core, houses by height, an unsorted file.
SMALL = {"cut-canillo-village", "berlin-siegessaeule", "nyc-west-village", "somes-island", "osmtogeojson-map", "regglisweiler-10"}

# Map, heightmap, tolerances: coarse where the extract is a country or city, none where its tiles would take minutes.
EXTRACTS = [
    ("andorra/andorra-2023.osm.pbf", "andorra/N42E001.hgt", None),
    ("andorra/cut-andorra-la-vella.osm.pbf", "andorra/N42E001.hgt", "2.5,12.5"),
    ("andorra/cut-canillo-village.osm.pbf", "andorra/N42E001.hgt", "0.5,12.5"),
    ("monaco/monaco-2023.osm.pbf", "monaco/N43E007.hgt", "2.5,12.5"),
    ("monaco/monaco-2016-cadastre.osm.pbf", None, "12.5"),
    ("berlin/berlin-mitte-gesundbrunnen.osm", "berlin/N52E013.hgt", "2.5"),
    ("berlin/berlin-reinickendorf-2026.osm.pbf", "berlin/N52E013.hgt", "2.5"),
    ("berlin/berlin-siegessaeule.osm.gz", "berlin/N52E013.hgt", "0.5"),
    ("berlin/berlin-neukolln.osm", "berlin/N52E013.hgt", "0.5"),
    ("chicago-loop/chicago_loop.osm.pbf", None, "2.5"),
    ("helsinki/Helsinki.osm.pbf", None, "2.5"),
    ("nyc/nyc-west-village.osm.pbf", None, "2.5"),
    ("neubrandenburg/neubrandenburg.osm.bz2", None, None),
    ("liechtenstein/liechtenstein-2015.osm.pbf", None, "12.5"),
    ("small/somes-island.osm.pbf", None, "0.1"),
    ("small/osmtogeojson-map.osm", None, "0.1"),
    ("small/regglisweiler-10.068_48.135.osm", None, "0.1"),
]

# If an extract has more tiles than this, every n-th is validated.
MOST_VALIDATED = 24

VALIDATOR = ROOT / "tests" / "interop" / "validate_glb.mjs"


def validator_is_installed():
    return shutil.which("node") and VALIDATOR.exists() and (ROOT / "tests" / "interop" / "node_modules" / "gltf-validator").exists()


class WholeProgram(ProgramTest):
    """The claims about one map."""

    def expect_compiled(self, map_path, *arguments):
        out = self.folder / map_path.name
        done = run("compile", map_path, *arguments, "-o", out)
        if self.may_hold_nothing and done.returncode == 1 and "contains nothing to compile" in done.stderr:
            return
        self.assertEqual(done.returncode, 0, done.stderr)
        report = report_of(out)
        self.assertTrue(report["balances"], report["ledger"])
        self.expect_claims(report)
        if "--lods" in arguments:
            self.assertTrue(report["tiles"])
            self.validate(out)

    def expect_claims(self, report):
        """Further claims of a subclass."""

    def validate(self, out):
        tiles = sorted(map(str, (out / "glb").glob("*.glb")))
        self.assertTrue(tiles)
        tiles = tiles[::1 + len(tiles) // MOST_VALIDATED]
        if validator_is_installed():
            done = subprocess.run(["node", str(VALIDATOR), *tiles], capture_output=True, text=True, cwd=ROOT, check=False)
            self.assertEqual(done.returncode, 0, done.stdout[-2000:] + done.stderr[-2000:])


def count_of(report, code):
    return report["diagnoses"].get(code, {}).get("count", 0)


class ExtractsReal(WholeProgram):
    may_hold_nothing = False

    def test_the_small_places_are_among_the_extracts(self):
        self.assertLessEqual(SMALL, {Path(name).name.split(".")[0] for name, _, _ in EXTRACTS})

    def expect_claims(self, report):
        read, planned = report["ledger"]["map/footprint"], report["ledger"]["buildings/footprint"]
        outside = planned["dropped"].get("OutsideBounds", 0)
        self.assertGreater(planned["out"], 0)
        self.assertEqual(read["out"], planned["in"])
        self.assertEqual(planned["in"], planned["out"] + planned["merged"] + outside)
        self.assertLess(outside, 0.05 * planned["in"] + 1)
        self.assertEqual(planned["merged"], count_of(report, "OutlineReplacedByParts"))
        self.assertLessEqual(set(planned["dropped"]), {"OutsideBounds"})
        self.assertEqual(report["counts"]["buildings"], planned["out"])
        self.assertLess(count_of(report, "RoofFallback"), 0.005 * planned["out"] + 1)


class BrokenMapsReal(WholeProgram):
    """Wrong data are repaired or dropped. If nothing is left of a map, one line says so."""

    may_hold_nothing = True

    def test_there_are_broken_maps(self):
        self.assertGreater(len(list(self.data("broken").glob("*"))), 10)


def add_claim(suite, map_name, dem_name, lods):
    def claim(self):
        dem = ["--dem", self.data(dem_name)] if dem_name else []
        outputs = ["--lods", lods] if lods else ["--emit", "kiln"]
        self.expect_compiled(self.data(map_name), *dem, *outputs)

    stem = Path(map_name).name.split(".")[0]
    is_long = suite is ExtractsReal and stem not in SMALL
    setattr(suite, f"test_{stem.replace('-', '_').lower()}", long_test(claim) if is_long else claim)


for row in EXTRACTS:
    add_claim(ExtractsReal, *row)
for path in sorted((DATA / "broken").glob("*")):
    add_claim(BrokenMapsReal, f"broken/{path.name}", None, "2.5")


if __name__ == "__main__":
    if not validator_is_installed():
        print("the glTF validator is not there (npm ci --prefix tests/interop): tiles are not validated")
    unittest.main()
