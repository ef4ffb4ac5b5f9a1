#!/usr/bin/env python3
"""Clearances are measured twice: the report has what the recipes in memory say, `check` what the manifest says when it is read again. And what
the planner counted while it had the map is nearly the same: it tells a water by its level, and looks along lines at other places."""
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
                planned = heights["planned_clearances"]
                self.assertLess(abs(planned["crossings"] - heights["clearances"]["crossings"]), 0.1 * planned["crossings"])


if __name__ == "__main__":
    unittest.main()
