#!/usr/bin/env python3
"""A town inside of a cylinder: valid in all formats, the same on any number of threads, and refused where it does not fit."""
import json
import math
import unittest
from pathlib import Path

from citykiln_program import IS_FULL, TOWN, TOWN_MIDDLE, ProgramTest, bytes_of_outputs, report_of, run
from glb import Glb
from png import mean_difference

RADIUS_M = 1000
BOX = ["--bbox", "12.2980,48.6985,12.3020,48.7020"] if IS_FULL else TOWN_MIDDLE
MAP = ["compile", TOWN / "town.osm", *BOX, "--dem",
       f"{TOWN}/town_heights.png,bounds=12.2871378/48.6926888/12.3128622/48.7073471,scale=0.02", "--tile", "128"]


def inside(*more, radius_m=RADIUS_M, levels_m="0.5,2.5"):
    return [*MAP, "--lods", levels_m, "--compress", "none", "--target", "godot", "--world", f"cylinder:{radius_m}", *more]


class Cylinder(ProgramTest):
    def town(self):
        """The town, compiled once in all formats."""
        if "town" not in self.shared_runs:
            out = Path(self.shared_scratch.name) / "town"
            done = run(*inside("--emit", "kiln,glb,usd,3dtiles", "--lights", 64, "-o", out))
            self.assertEqual(done.returncode, 0, done.stderr)
            self.shared_runs["town"] = out
        return self.shared_runs["town"]

    def test_check_finds_nothing(self):
        checked = run("check", self.town())
        self.assertEqual(checked.returncode, 0, checked.stdout + checked.stderr)
        self.assertIn("inside of a cylinder, every vertex of a .glb maps back to that of its recipe", checked.stdout)

    def test_vertices_lie_inside_by_their_heights(self):
        out = self.town()
        for path in sorted((out / "glb").glob("*_L0.glb")):
            root = Glb(path).gltf["nodes"][0]["extras"]
            self.assertEqual(root["frame"]["radius_m"], RADIUS_M)
            self.assertNotIn("plane", root)
        self.assertEqual(report_of(out)["cylinder_radius_m"], RADIUS_M)

    def test_tiles_have_boxes_and_no_place_on_earth(self):
        tileset = json.loads((self.town() / "3dtiles" / "tileset.json").read_text())
        self.assertEqual(tileset["root"]["transform"], [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1])
        tiles = [tileset["root"]]
        while tiles:
            tile = tiles.pop()
            self.assertEqual(list(tile["boundingVolume"]), ["box"])
            tiles += tile.get("children", [])

    def test_same_bytes_on_any_number_of_threads(self):
        runs = []
        for threads in (1, 7):
            out = self.folder / str(threads)
            self.assertEqual(run(*inside("--emit", "kiln,glb,3dtiles", "--threads", threads, "-o", out, levels_m="2.5")).returncode, 0)
            runs.append(bytes_of_outputs(out))
        self.assertEqual(*runs)

    def test_bake_gives_the_bytes_of_compile(self):
        out = self.folder / "again"
        done = run("bake", self.town(), "--lods", "0.5,2.5", "--compress", "none", "--target", "godot", "--emit", "glb", "--lights", 64, "-o", out)
        self.assertEqual(done.returncode, 0, done.stderr)
        compiled = bytes_of_outputs(self.town())
        for name, sha in bytes_of_outputs(out).items():
            self.assertEqual(sha, compiled[name], name)

    def test_the_manifest_differs_by_its_sky_alone(self):
        flat = self.folder / "flat"
        self.assertEqual(run(*MAP, "--lods", "0.5,2.5", "--compress", "none", "--target", "godot", "--emit", "glb", "--lights", 64,
                             "--surroundings", "none", "-o", flat).returncode, 0)
        levels = [r["tiles"] for r in (report_of(flat), report_of(self.town()))]
        self.assertEqual([t["file"] for t in levels[0]], [t["file"] for t in levels[1]])
        for plane, bent in zip(*levels):
            self.assertGreater(bent["error_m"], plane["error_m"])
            self.assertGreaterEqual(bent["triangles"], plane["triangles"])

    def test_pictures_of_tiles_and_of_the_manifest_are_alike(self):
        views = []
        for source, more in ((self.town(), ["--level", "0"]), (self.town() / "scene.kiln", ["--tolerance", "0.5"])):
            out = self.folder / f"{len(views)}.png"
            done = run("preview", source, "--eye", "0,-150,40", "--look", "0,100,0", "--size", "64x36", "--spp", "4", *more, "-o", out)
            self.assertEqual(done.returncode, 0, done.stderr)
            views.append(out)
        self.assertLess(mean_difference(self.folder / "0.png", self.folder / "1.png"), 0.05)

    def test_a_manifest_without_a_tolerance_is_baked_with_a_note(self):
        done = run("preview", self.town() / "scene.kiln", "--eye", "0,-150,40", "--look", "0,100,0", "--size", "32x18", "--spp", "1",
                   "-o", self.folder / "p.png")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("inside of a cylinder is baked before it is rendered", done.stdout + done.stderr)

    def test_the_land_around_is_left_out_with_a_note(self):
        done = run(*inside("--emit", "glb", "-o", self.folder / "note", levels_m="2.5"))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("note: no surroundings are written: there is no land around a map inside of a cylinder", done.stdout + done.stderr)
        self.assertFalse((self.folder / "note" / "glb" / "surroundings.glb").exists())

    def refused(self, arguments, *words):
        done = run(*arguments)
        self.assertEqual(done.returncode, 1, done.stdout)
        self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)

    def test_bad_radii_get_one_line(self):
        out = ["-o", self.folder / "bad"]
        for radius in ("", "x", "-5", "0", "nan", "inf", "99", "1e7"):
            self.refused(inside(*out, radius_m=radius), "cylinder:R", "from 100 to 1000000")
        self.refused([*MAP, "--world", "cylinder", *out], "cylinder:R")
        self.refused([*MAP, "--world", "sphere", *out], "plane, ellipsoid or cylinder:R")

    def test_maps_that_do_not_fit_get_one_line(self):
        out = ["-o", self.folder / "bad"]
        whole = [argument for argument in inside(*out, radius_m=150) if argument not in BOX]
        least = math.ceil(1280 / (2 * math.pi))
        self.refused(whole, "942 m", f"at least {least} m")
        high = [f"{a},offset=2000" if "town_heights" in str(a) else a for a in inside(*out)]
        self.refused(high, "the axis of the cylinder 1000 m")

    def test_settings_without_meaning_inside_get_one_line(self):
        out = ["-o", self.folder / "bad"]
        self.refused(inside("--surroundings", *out), "--surroundings")
        self.refused(inside("--clouds", "fair", *out), "--clouds")
        self.refused(inside("--emit", "3dtiles,page", *out), "--emit")
        self.refused(inside("--geoid-height", "47", *out), "--geoid-height")
        self.refused(["bake", self.town(), "--world", "cylinder:500", *out], "--world")
        self.refused(["bake", self.town(), "--world", "plane", *out], "--world")
        self.refused(["bake", self.town(), "--eye", "0,0,50", "-o", self.folder / "eye.glb"], "--eye")
        self.refused(["plan", *MAP[1:], "--world", "cylinder:1000", *out], "--world")


if __name__ == "__main__":
    unittest.main()
