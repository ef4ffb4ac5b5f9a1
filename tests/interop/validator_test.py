#!/usr/bin/env python3
"""Khronos' glTF validator reports no error and no warning for the town's tiles, at every level, and for targets that know instancing."""
import os
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
TARGETS = ["generic", "blender", "godot", "three", "cesium", "unreal", "unity"]
# the tool that writes tiles with a marking atlas
MADE_GLB = os.environ.get("MADE_GLB")
sys.path.insert(0, str(HERE.parent / "properties"))
from citykiln_program import TOWN, ProgramTest  # noqa: E402


def validated(*paths):
    return subprocess.run(["node", HERE / "validate_glb.mjs", *paths], capture_output=True, text=True, cwd=HERE, check=False)


class Validator(ProgramTest):
    def tiles(self, *arguments):
        out = self.compiled("out", "--spec", TOWN / "spec.json", *arguments)
        tiles = sorted((out / "glb").glob("*.glb"))
        self.assertGreater(len(tiles), 1)
        return tiles

    def assert_valid(self, tiles):
        done = validated(*tiles)
        self.assertEqual(done.returncode, 0, done.stdout[-2000:] + done.stderr[-2000:])
        self.assertIn(f"{len(tiles)} files: 0 errors, 0 warnings", done.stdout)

    def test_every_level_is_valid(self):
        self.assert_valid(self.tiles("--lods", "0.02,0.1,0.5,1.2,2.5,12.5"))

    def test_every_target_is_valid(self):
        for target in TARGETS:
            with self.subTest(target=target):
                self.assert_valid(self.tiles("--lods", "0.5,2.5", "--target", target))

    def test_every_split_is_valid(self):
        for split in ("tile", "building"):
            with self.subTest(split=split):
                self.assert_valid(self.tiles("--lods", "0.5,12.5", "--split", split))

    def test_lights_are_valid(self):
        for packing in ([], ["--target", "three", "--compress", "meshopt", "--split", "tile"]):
            with self.subTest(packing=packing):
                tiles = self.tiles("--lods", "12.5", "--lights", "50", *packing)
                self.assertIn(b"KHR_lights_punctual", tiles[0].read_bytes())
                self.assert_valid(tiles)

    def test_contents_of_tilesets_are_valid(self):
        for packing in ([], ["--compress", "quantize"], ["--compress", "draco"], ["--compress", "meshopt"]):
            with self.subTest(packing=packing):
                out = self.compiled("tiles", "--spec", TOWN / "spec.json", "--lods", "0.5,12.5", "--emit", "3dtiles", *packing)
                contents = sorted((out / "3dtiles").glob("*.glb"))
                self.assertGreater(len(contents), 8)
                self.assert_valid(contents)

    @unittest.skipUnless(MADE_GLB, "MADE_GLB is not set")
    def test_a_tile_with_a_marking_atlas_is_valid(self):
        subprocess.run([MADE_GLB, self.folder], check=True)
        self.assert_valid([self.folder / "marked.glb", self.folder / "marked_nodes.glb"])

    def test_a_broken_tile_is_rejected(self):
        tile = self.tiles("--lods", "12.5")[0]
        data = tile.read_bytes()
        self.assertIn(b'"POSITION"', data)
        tile.write_bytes(data.replace(b'"POSITION"', b'"POSITIOM"'))
        self.assertEqual(validated(tile).returncode, 1)


if __name__ == "__main__":
    if not shutil.which("node") or not (HERE / "node_modules" / "gltf-validator").exists():
        print("the glTF validator is not installed (npm ci --prefix tests/interop): skipped")
        sys.exit(77)
    unittest.main(verbosity=2)
