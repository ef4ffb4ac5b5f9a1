#!/usr/bin/env python3
"""glTF Transform, with the decoders of Draco and meshoptimizer, reads the same triangles from compressed tiles as from plain ones, and
its plain copies pass Khronos' validator."""
import math
import shutil
import subprocess
import sys
import unittest
from collections import Counter
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "properties"))
from citykiln_program import TOWN, ProgramTest  # noqa: E402
from glb import Glb  # noqa: E402


def triangles_of(path):
    """For each mesh and material its triangles: corners on the 2^-10 m grid with their feature, starting at the least corner."""
    tile, found = Glb(path), {}
    for mesh in tile.gltf["meshes"]:
        for primitive in mesh["primitives"]:
            attributes = primitive["attributes"]
            # rounded as in quantise.h, where y is minus a rounded number
            places = [(math.floor(x * 1024 + 0.5), math.floor(y * 1024 + 0.5), -math.floor(-z * 1024 + 0.5))
                      for x, y, z in tile.values(attributes["POSITION"])]
            features = tile.values(attributes["_FEATURE_ID_0"]) if "_FEATURE_ID_0" in attributes else [(0,)] * len(places)
            corners = [place + feature for place, feature in zip(places, features, strict=True)]
            indices = [i for i, in tile.values(primitive["indices"])]
            name = mesh["name"], tile.gltf["materials"][primitive["material"]]["name"]
            found.setdefault(name, Counter()).update(
                rotated([corners[n] for n in indices[i:i + 3]]) for i in range(0, len(indices), 3))
    return found


def rotated(triangle):
    first = triangle.index(min(triangle))
    return tuple(triangle[first:] + triangle[:first])


class Compressed(ProgramTest):
    LEVELS = ["--lods", "0.1,12.5"]

    def tiles(self, compress):
        out = self.compiled(compress, "--spec", TOWN / "spec.json", *self.LEVELS, "--target", "three", "--compress", compress)
        tiles = sorted((out / "glb").glob("*.glb"))
        self.assertGreater(len(tiles), 1)
        return tiles

    def unpacked(self, tiles):
        unpacked = [self.folder / f"{i}.glb" for i in range(len(tiles))]
        done = subprocess.run(["node", HERE / "unpack_glb.mjs", *[path for pair in zip(tiles, unpacked) for path in pair]], capture_output=True, text=True, cwd=HERE, check=False)
        self.assertEqual(done.returncode, 0, done.stderr[-2000:])
        return unpacked

    def expect_the_same(self, compress):
        unpacked = self.unpacked(self.tiles(compress))
        # both levels of two tiles are enough: the Python reader is slow
        for plain, path in list(zip(self.tiles("none"), unpacked, strict=True))[:4]:
            expected = triangles_of(plain)
            self.assertTrue(expected)
            self.assertEqual(triangles_of(path), expected, path)
        done = subprocess.run(["node", HERE / "validate_glb.mjs", *unpacked], capture_output=True, text=True, cwd=HERE, check=False)
        self.assertIn(f"{len(unpacked)} files: 0 errors, 0 warnings", done.stdout, done.stdout[-2000:])

    def test_draco_tiles_hold_the_triangles_of_plain_ones(self):
        self.expect_the_same("draco")

    def test_meshopt_tiles_hold_the_triangles_of_plain_ones(self):
        self.expect_the_same("meshopt")


if __name__ == "__main__":
    if not shutil.which("node") or not (HERE / "node_modules" / "@gltf-transform").exists():
        print("glTF Transform is not installed (npm ci --prefix tests/interop): skipped")
        sys.exit(77)
    unittest.main(verbosity=2)
