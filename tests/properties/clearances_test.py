#!/usr/bin/env python3
"""`check` measures the same clearances from the manifest as `compile` reports from the recipes in memory. The planner's own count is
within 10 %: it samples lines at other places, and finds water by its level."""
import json
import unittest

from citykiln_program import ProgramTest, report_of, run

FIGURES = ["crossings", "shortfalls", "shortfalls_over_1_m", "shortfalls_over_3_m", "largest_shortfall_m"]


class ClearancesReal(ProgramTest):
    PLACES = [("andorra/cut-andorra-la-vella.osm.pbf", "andorra/N42E001.hgt"),
              ("monaco/cut-1km2-monacoville-port.osm", "monaco/N43E007.hgt")]

    def test_check_finds_what_the_report_says(self):
        for number, (map_path, dem) in enumerate(self.PLACES):
            with self.subTest(map_path):
                folder = self.compiled(f"place{number}", self.data(map_path), "--dem", self.data(dem), "--emit", "kiln")
                done = run("check", folder, "--json")
                stated = [s for s in json.loads(done.stdout) if s.get("measure") == "crossings with too little clearance"]
                self.assertEqual(len(stated), 1)
                heights = report_of(folder)["heights"]
                self.assertGreater(heights["clearances"]["crossings"], 50)
                for figure in FIGURES:
                    self.assertEqual(stated[0][figure], heights["clearances"][figure], figure)
                self.assertEqual(len(stated[0]["contradictions"]), heights["clearances"]["contradictions"])
                planned = heights["planned_clearances"]
                self.assertLess(abs(planned["crossings"] - heights["clearances"]["crossings"]), 0.1 * planned["crossings"])


if __name__ == "__main__":
    unittest.main()
