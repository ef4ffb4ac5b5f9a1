#!/usr/bin/env python3
"""The plugin for Godot 3 makes a city of a run: chosen layers, few draw calls, one level of each tile by distance, collision shapes, day and night."""
import json
import os
import shutil
import subprocess
import unittest
from pathlib import Path

from readers import HERE, ReaderTest, done_by, facts_of, godot, import_into, skip_unless, triangles_in, y_up

PLUGIN = HERE.parent.parent / "exporters/godot/godot3/addons"
LAYERS = ["ground", "roads", "water", "buildings", "plants"]
NEAR, FAR = [0, 0, 400], [0, -6000, 900]
SOLID = "ground,roads,water,buildings,structures"
# Hours in UTC of the town's 21 June: the sun has set 1.5 hours before the second.
NOON, NIGHT = 11.2, 21.5
skip_unless(godot(), "godot3, godot3-server or xvfb-run is missing")


class GodotCity(ReaderTest):
    def setUp(self):
        super().setUp()
        self.run_folder = self.town("town", "--target", "godot", "--lods", "2.5,12.5", "--only", "0_0", "--time", "2026-06-21T21:30Z")
        self.project = Path(self.folder) / "project"
        shutil.copytree(PLUGIN, self.project / "addons")
        (self.project / "project.godot").write_text("config_version=4\n[rendering]\nquality/driver/driver_name=\"GLES3\"\n")

    def write_city(self, *options):
        return subprocess.run(["godot3-server", "--path", self.project, "-s", "addons/citykiln/import_run.gd", "--", "--run",
                               self.run_folder, *options], capture_output=True, text=True, check=False)

    def facts(self, pictures, **more):
        import_into(self.project, [f"0_0_L{level}.glb" for level in (0, 1)])
        job = self.folder / "city.json"
        common = {"out": str(self.folder / "city.png"), "fov_deg": 60, "size": [64, 36]}
        job.write_text(json.dumps({"scene": "res://city/city.tscn", "facts": str(self.folder / "facts.json"),
                                   "pictures": [common | picture for picture in pictures], "rays": [], **more}))
        return done_by([*godot(), "--path", self.project, "-s", HERE / "draw_city.gd"], self.folder / "facts.json",
                       env={**os.environ, "JOB": str(job)})[0]

    def test_shows_a_run_as_chosen(self):
        self.assertEqual(self.write_city("--layers", ",".join(LAYERS), "--collision", "ground").returncode, 0)
        facts = self.facts([{"eye": y_up(eye), "look": [60, 380, 0]} for eye in (NEAR, FAR)], rays=[[60, 900, -40]])
        fine, coarse = (facts["tiles"]["0_0"][f"L{level}"] for level in (0, 1))
        self.assertEqual(set(fine["layers"]), set(LAYERS))
        self.assertGreater(fine["copies"], 5 * fine["multis"])
        self.assertGreater(fine["places"], 0.9 * fine["copies"], "copies stand in places of their own")
        self.assertLess(coarse["triangles"], fine["triangles"])
        self.assertLess(fine["triangles"], triangles_in(facts_of(self.run_folder / "glb/0_0_L0.glb")), "props are left out")
        self.assertEqual((fine["shapes"], coarse["shapes"]), (["ground"], []))
        self.assertEqual([shown["0_0"] for shown in facts["shown"]], [["L0"], ["L1"]])
        self.assertEqual(facts["hits"][0]["layer"], "ground")

    def test_a_street_by_day_and_by_night(self):
        self.write_city("--collision", SOLID)
        street = {"eye": [80, 378, 150], "look": [130, 378, 60], "fov_deg": 75, "size": [192, 108]}
        facts = self.facts([street | {"hour": NOON}, street | {"hour": NIGHT}], walks=[{"from": [20, 420, -10], "yaw_deg": 0, "seconds": 8}])
        day, night = facts["light"]
        self.assertEqual((day["emission"], day["lamps"], night["sun"]), (0, 0, 0))
        self.assertGreater(day["to_sun"][1], 0.9, "the sun stands 64.7 degrees high")
        self.assertLess(abs(day["to_sun"][0]), 0.1, "it is in the south")
        self.assertGreater(night["shining"], 0, "a run of an evening has lit windows")
        self.assertGreater(min(night["emission"], night["lamps"]), 0)
        for counts in facts["counts"]:
            self.assertLessEqual(max(counts["calls"], counts["calls_shown"]), 300)
            self.assertLessEqual(max(counts["calls_vertices"] / 3, counts["triangles_shown"]), 3e6)
        walk = facts["walks"][0]
        self.assertEqual(walk["ways"], [], "nothing solid lies between two places of a walker")
        self.assertGreater(abs(walk["places"][-1][2] - walk["places"][0][2]), 5, "it walks until the wall")
        self.assertLess(abs(walk["places"][-1][2] - walk["places"][-5][2]), 0.01, "and stands there")

    def test_a_wrong_choice_is_one_line(self):
        for options, words in [(("--tiles", "9_9"), "has no tile 9_9"), (("--levels", "7"), "has no level"),
                               (("--layers", "sky"), "sky is not a layer"), (("--run", "/nowhere"), "no such file")]:
            done = self.write_city(*options)
            said = [line for line in done.stderr.splitlines() if line.startswith("citykiln: ")]
            self.assertEqual((done.returncode, len(said)), (1, 1), done.stderr)
            self.assertIn(words, said[0])


if __name__ == "__main__":
    unittest.main()
