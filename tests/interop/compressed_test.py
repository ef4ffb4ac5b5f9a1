#!/usr/bin/env python3
"""glTF Transform, with the decoders of Draco and meshoptimizer, reads the same tiles from packed files as citykiln does and as from plain
ones: triangles, materials, boxes, places of instances, features. Its plain copies pass Khronos' validator, as do the packed files."""
import subprocess
import sys
import unittest

import readers
from glb import Glb
from readers import HERE, ReaderTest

LODS = ["0.1", "2.5", "12.5"]


def boxes_of(facts):
    """The corners of the first copy of each mesh, in metres."""
    boxes = {}
    for name, mesh in facts["meshes"].items():
        place = facts["places"][name][0]
        corners = [[mesh[end][axis] for axis, end in enumerate(ends)] for ends in (("low",) * 3, ("high",) * 3)]
        boxes[name] = [sum(place[i][k] * corner[k] for k in range(3)) + place[i][3] for corner in corners for i in range(3)]
    return boxes


def features_of(path):
    """The set of features of each mesh."""
    tile, found = Glb(path), {}
    for mesh in tile.gltf["meshes"]:
        for primitive in mesh["primitives"]:
            if "_FEATURE_ID_0" in primitive["attributes"]:
                found.setdefault(mesh["name"], set()).update(round(value) for value, in tile.values(primitive["attributes"]["_FEATURE_ID_0"]))
    return found


class Compressed(ReaderTest):
    def tiles(self, compress):
        out = self.town(compress, "--lods", ",".join(LODS), "--target", "three", "--layout", "embedded", "--compress", compress)
        tiles = sorted((out / "glb").glob("*.glb"))
        self.assertGreater(len(tiles), len(LODS))
        return tiles

    def unpacked(self, tiles):
        unpacked = [self.folder / f"{i}.glb" for i in range(len(tiles))]
        done = subprocess.run(["node", HERE / "unpack_glb.mjs", *[path for pair in zip(tiles, unpacked) for path in pair]],
                              capture_output=True, text=True, cwd=HERE, check=False)
        self.assertEqual(done.returncode, 0, done.stderr[-2000:])
        return unpacked

    def assert_valid(self, files):
        done = subprocess.run(["node", HERE / "validate_glb.mjs", *files], capture_output=True, text=True, cwd=HERE, check=False)
        self.assertIn(f"{len(files)} files: 0 errors, 0 warnings", done.stdout, done.stdout[-2000:])

    def assert_holds_the_same(self, plain, packed, unpacked, step_m):
        expected, found = readers.facts_of(plain), readers.facts_of(unpacked)
        # two readers of the packed file see the same
        self.assert_as_inspected(found, packed)
        # against the plain file only triangles are missing that have no area on the lattice
        self.assertEqual(found["materials"], expected["materials"])
        for name, mesh in expected["meshes"].items():
            count, plain_count = (sum(m["triangles"].values()) for m in (found["meshes"][name], mesh))
            self.assertLessEqual(count, plain_count, name)
            self.assertGreater(count, 0.8 * plain_count, name)
        self.assertEqual({name: len(places) for name, places in found["places"].items()},
                         {name: len(places) for name, places in expected["places"].items()})
        wanted = boxes_of(expected)
        for name, box in boxes_of(found).items():
            self.assert_near(box, wanted[name], step_m)
        self.assert_features_kept(features_of(unpacked), features_of(plain))

    def assert_features_kept(self, found, expected):
        self.assertTrue(expected)
        self.assertEqual(found.keys(), expected.keys())
        for name, features in expected.items():
            self.assertLessEqual(found[name], features, name)
            self.assertGreaterEqual(len(found[name]), 0.98 * len(features), name)

    def expect_the_same(self, compress):
        plain, packed = self.tiles("none"), self.tiles(compress)
        unpacked = self.unpacked(packed)
        for a, b, c in zip(plain, packed, unpacked, strict=True):
            with self.subTest(path=a.name):
                # the lattice of packed positions moves a corner by less than a fifth of the tolerance
                self.assert_holds_the_same(a, b, c, Glb(a).gltf["nodes"][0]["extras"]["tolerance_m"] / 5)
        self.assert_valid(packed)
        self.assert_valid(unpacked)

    def test_quantised_tiles_hold_what_plain_ones_do(self):
        self.expect_the_same("quantize")

    def test_draco_tiles_hold_what_plain_ones_do(self):
        self.expect_the_same("draco")

    def test_meshopt_tiles_hold_what_plain_ones_do(self):
        self.expect_the_same("meshopt")


if __name__ == "__main__":
    readers.skip_unless(readers.has_npm("@gltf-transform") and readers.has_pictures(),
                        "glTF Transform is not installed (npm ci --prefix tests/interop)")
    unittest.main(argv=sys.argv[:2], verbosity=2)
