#!/usr/bin/env python3
"""No building is lost between the map and the tiles: each is planned, replaced by its parts, or outside of the extent by its centroid,
and diagnosed. Fewer than one roof in
200 is flat because the mapped roof could not be built."""
import unittest
from pathlib import Path

from citykiln_program import ProgramTest, report_of

EXTRACTS = [
    "helsinki/Helsinki.osm.pbf", "monaco/monaco-2023.osm.pbf", "monaco/monaco-2016-cadastre.osm.pbf", "neubrandenburg/neubrandenburg.osm.bz2",
    "chicago-loop/chicago_loop.osm.pbf", "nyc/nyc-west-village.osm.pbf", "berlin/berlin-mitte-gesundbrunnen.osm", "berlin/berlin-neukolln.osm",
    "berlin/berlin-reinickendorf-2026.osm.pbf", "berlin/berlin-siegessaeule.osm.gz", "liechtenstein/liechtenstein-2015.osm.pbf",
]
LOD_M = "2.5"


def count_of(report, code):
    return report["diagnoses"].get(code, {}).get("count", 0)


class BuildingsReal(ProgramTest):
    def expect_kept(self, map_name):
        report = report_of(self.compiled("out", self.data(map_name), "--lods", LOD_M))
        read, planned = report["ledger"]["map/footprint"], report["ledger"]["buildings/footprint"]
        replaced, flat = count_of(report, "OutlineReplacedByParts"), count_of(report, "RoofFallback")
        self.assertGreater(planned["out"], 0)
        print(f"{map_name}: in {planned['in']}, out {planned['out']}, merged into parts {planned['merged']}, dropped before {read['dropped']}, "
              f"flat because their roof failed {flat} ({100 * flat / max(1, planned['out']):.3f} %)")
        self.assertEqual(read["out"], planned["in"])
        outside = planned["dropped"].get("OutsideBounds", 0)
        self.assertEqual(planned["in"], planned["out"] + planned["merged"] + outside)
        self.assertLess(outside, 0.05 * planned["in"] + 1)
        self.assertEqual(planned["merged"], replaced)
        self.assertLessEqual(set(planned["dropped"]), {"OutsideBounds"})
        self.assertEqual(report["counts"]["buildings"], planned["out"])
        self.assertLess(flat, 0.005 * planned["out"] + 1)


for path in EXTRACTS:
    name = Path(path).name.split(".")[0].replace("-", "_").lower()
    setattr(BuildingsReal, f"test_{name}", lambda self, path=path: self.expect_kept(path))


if __name__ == "__main__":
    unittest.main()
