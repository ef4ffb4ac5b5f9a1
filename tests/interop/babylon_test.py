#!/usr/bin/env python3
"""The example for Babylon.js (exporters/gltf/howto/babylon.md) does what a game needs: levels by distance within 300 draw calls and 3 million
triangles, ground and walls that stop a walker, day and night. Counts of draw calls are the engine's own."""
import json
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "properties"))
from citykiln_program import ROOT, TOWN, ProgramTest  # noqa: E402

HERE = Path(__file__).resolve().parent
MOST_CALLS, MOST_TRIANGLES = 300, 3_000_000
FORM = ["--target", "three", "--tile", "256", "--lods", "0.5,2.5,12.5", "--surroundings", "none", "--emit", "glb"]


@unittest.skipUnless((HERE / "node_modules" / "babylonjs").exists(), "needs `npm ci` in tests/interop")
class Babylon(ProgramTest):
    def played(self, out, job):
        """The facts of babylon.mjs about a run."""
        site = self.folder / "site"
        site.mkdir()
        for name in ("babylon.html", "babylon_city.js"):
            shutil.copy(ROOT / "exporters/gltf/howto" / name, site)
        (site / "node_modules").symlink_to(HERE / "node_modules")
        (site / "run").symlink_to(out)
        path = self.folder / "job.json"
        path.write_text(json.dumps({"run": "run", "pictures": [], "walks": [], **job}))
        done = subprocess.run(["node", HERE / "babylon.mjs", site, path], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return json.loads(done.stdout)

    def assert_within_the_budget(self, views):
        for view in views:
            self.assertLessEqual(view["drawn"], MOST_CALLS)
            self.assertLessEqual(view["counts"]["triangles"], MOST_TRIANGLES)
            self.assertGreater(view["counts"]["triangles"], 10_000)
            print(f"{view['drawn']} draw calls, {view['counts']['triangles']:,} triangles")

    def test_a_town_is_played(self):
        out = self.compiled("town", "--spec", TOWN / "spec.json", "--time", "2026-12-21T17:00", *FORM)
        facts = self.played(out, {
            "eyes": [[40, -30, 2], [-150, 60, 2], [200, -100, 2], [0, -400, 250]],
            "looks": [[90, 20, 4], [-100, 100, 4], [150, -50, 4], [0, 0, 0]],
            "walks": [[40, -30, turn] for turn in (0, 1.57, 3.14, 4.71)]})
        self.assert_within_the_budget(facts["views"])
        near = [level for _, level in sorted(facts["views"][0]["levels"])]
        self.assertEqual(near[0], 0)
        self.assertEqual(near[-1], 2)
        self.assertEqual(sorted(near), near, "levels are coarser farther away")
        for walk in facts["walks"]:
            self.assertLess(walk["highest_m"], 0.6, walk)
            self.assertGreater(walk["least_m"], 0.25, walk)
            self.assertEqual(walk["crossed"], 0, walk)
        self.assertGreater(max(walk["went"] for walk in facts["walks"]), 20)
        day, night = facts["light"]
        self.assertEqual((day["night"], night["night"]), (False, True))
        self.assertEqual((day["emission"], night["emission"]), (0, 1))
        self.assertGreater(day["sun"], night["sun"])
        self.assertEqual((day["lamps"], night["lamps"]), (0, 4))


if __name__ == "__main__":
    unittest.main(verbosity=2)
