#!/usr/bin/env python3
"""gltfpack reads every file of the target `generic` and keeps its triangles."""
import subprocess
import sys
import unittest

import readers
from readers import ReaderTest

GLTFPACK = readers.HERE / "node_modules" / "gltfpack" / "cli.js"
# -kn and -km keep names of nodes and materials apart, -noq keeps floats
OPTIONS = ["-kn", "-km", "-noq"]


class Gltfpack(ReaderTest):
    def packed(self, path, *options):
        """The path of the packed file."""
        out = self.folder / "packed.glb"
        done = subprocess.run(["node", GLTFPACK, "-i", path, "-o", out, *options], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, f"{path.name}: {done.stdout}{done.stderr}")
        return out

    def assert_packs(self, out):
        files = sorted((out / "glb").glob("*.glb"))
        self.assertGreater(len(files), 0)
        for path in files:
            with self.subTest(path=path.name):
                drawn = readers.triangles_drawn(self.packed(path, *OPTIONS))
                expected = readers.triangles_drawn(path)
                # triangles without area are left out
                self.assertLessEqual(drawn, expected)
                self.assertGreater(drawn, 0.999 * expected)
                self.packed(path, "-c")

    def test_the_town(self):
        self.assert_packs(self.town("town"))


class GltfpackReal(Gltfpack):
    def test_the_town(self):
        self.assert_packs(self.monaco("monaco"))

    def test_andorra(self):
        osm, heights = self.data("andorra/cut-canillo-village.osm.pbf"), self.data("andorra/N42E001.hgt")
        self.assert_packs(self.compiled("canillo", osm, "--dem", heights, "--only=0_0", "--lods", "0.5,2.5,12.5"))


if __name__ == "__main__":
    readers.skip_unless(readers.has_npm("gltfpack") and readers.has_pictures(), "gltfpack is not installed (npm ci --prefix tests/interop)")
    unittest.main(argv=sys.argv[:2], verbosity=2)
