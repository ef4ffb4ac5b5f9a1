#!/usr/bin/env python3
"""Tests that other programs read the clouds of outputs: Khronos' validator and Blender clouds.glb, Blender clouds.vdb, tinyusdz
clouds.usdc; and that all three have clouds in the same place."""
import json
import shutil
import subprocess
import sys
import unittest

import readers
from glb import Glb
from readers import HERE, ProgramTest, has_npm
from usd import Text, read_layer  # beside citykiln_program.py

# Voxels are at most as large for the town: twice a cell of the surface, so that there are not too many.
VOXEL_M = 110


def box(low, high):
    return [*low, *high]


class CloudsElsewhere(ProgramTest):
    @classmethod
    def setUpClass(cls):
        cls.keeper = ProgramTest()
        cls.keeper.setUp()
        cls.addClassCleanup(cls.keeper.doCleanups)
        cls.town = cls.keeper.compiled("town", "--spec", readers.TOWN / "spec.json", "--lods", "12.5", "--emit", "glb,usd", "--clouds", "broken")
        cls.layer = read_layer(cls.town / "usd/clouds.usdc").children["clouds"]

    def boxes_near(self, one, other, within_m):
        for a, b in zip(one, other, strict=True):
            self.assertLessEqual(abs(a - b), within_m, f"{one} {other}")

    def volume_box(self):
        low, high = self.layer.children["volume"].attributes["extent"]
        return box(low, high)

    def test_the_layer_has_points_in_frames_and_a_volume(self):
        self.assertEqual(set(self.layer.children), {"cumulus", "cirrus", "volume"})
        for kind in ("cumulus", "cirrus"):
            points = self.layer.children[kind].children["particles"].attributes
            self.assertGreater(len(points["points"]), 200)
            self.assertEqual(len(points["points"]), len(points["widths"]))
            for axis in range(3):
                low = min(p[axis] - w / 2 for p, w in zip(points["points"], points["widths"]))
                self.assertAlmostEqual(low, points["extent"][0][axis], delta=0.01)
        self.assertEqual(self.layer.children["volume"].children["density"].attributes["filePath"], "./clouds.vdb")
        self.assertIn("@./clouds.usdc@", (self.town / "usd/scene.usda").read_text())

    @unittest.skipUnless(has_npm("tinyusdz"), "tinyusdz is not installed")
    def test_tinyusdz_reads_the_layer(self):
        facts = self.folder / "facts.json"
        done = subprocess.run(["node", HERE / "read_usd.mjs", facts, self.folder, self.town / "usd/clouds.usdc"], capture_output=True,
                              text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(json.loads(facts.read_text())[0]["tinyusdz"], encoding="utf-8") as text:
            read = Text(text.read()).layer().children["clouds"]
        for kind in ("cumulus", "cirrus"):
            own, other = (spec.children[kind].children["particles"].attributes for spec in (self.layer, read))
            self.assertEqual(len(own["points"]), len(other["points"]))
            self.assertLess(max(abs(a - b) for a, b in zip(own["widths"], other["widths"])), 0.01)
        self.assertEqual(read.children["volume"].targets["field:density"], ["/clouds/volume/density"])

    @unittest.skipUnless(has_npm("gltf-validator"), "gltf-validator is not installed")
    def test_the_validator_finds_nothing_in_the_meshes(self):
        done = subprocess.run(["node", HERE / "validate_glb.mjs", self.town / "glb/clouds.glb"], capture_output=True, text=True, cwd=HERE,
                              check=False)
        self.assertIn("1 files: 0 errors, 0 warnings", done.stdout, done.stdout[-2000:] + done.stderr[-2000:])

    @unittest.skipUnless(readers.blender(), "Blender is not installed")
    def test_blender_has_all_meshes_in_their_place(self):
        path = self.town / "glb/clouds.glb"
        [found], _ = readers.run_blender(self.folder, [path])
        held = readers.facts_of(path)
        self.assertGreater(len(held["meshes"]), 4)
        self.assertEqual({name: sum(mesh["triangles"].values()) for name, mesh in held["meshes"].items()},
                         {name: sum(mesh["triangles"].values()) for name, mesh in found["meshes"].items()})
        for name, mesh in held["meshes"].items():
            self.boxes_near(box(mesh["low"], mesh["high"]), box(found["meshes"][name]["low"], found["meshes"][name]["high"]), 0.01)
        self.assertEqual(found["roots"][0]["name"], "clouds")
        self.assertEqual(Glb(path).gltf["materials"][-1]["alphaMode"], "BLEND")

    @unittest.skipUnless(readers.blender(), "Blender is not installed")
    def test_blender_has_the_volume_where_the_layer_says(self):
        path = self.town / "usd/clouds.vdb"
        if not path.exists():
            self.skipTest("OpenVDB is not installed")
        facts = self.folder / "vdb.json"
        done = subprocess.run([shutil.which("blender"), "-b", "--factory-startup", "-noaudio", "--python-exit-code", "3", "-P",
                               HERE / "read_vdb.py", "--", path, facts], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr[-2000:])
        found = json.loads(facts.read_text())
        self.assertEqual(found["grids"], [["density", "FLOAT"]])
        # leaves of 8 voxels are whole
        self.boxes_near(box(found["low"], found["high"]), self.volume_box(), 9 * VOXEL_M)


if __name__ == "__main__":
    sys.exit(unittest.main(argv=[sys.argv[0], "-v"]))
