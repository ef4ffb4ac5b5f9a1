#!/usr/bin/env python3
"""bake --eye makes meshes finer near the viewpoint than far away, and its file states the viewpoint."""
import json
import unittest

from citykiln_program import TOWN, TOWN_MIDDLE, ProgramTest, long_test, run, sha256
from glb import Glb

EYE = "--eye=60,40,80"


class BakeForEye(ProgramTest):

    def setUp(self):
        super().setUp()
        self.scene = self.compiled_once("--spec", TOWN / "spec.json", "--tile", "256", "--emit", "kiln", *TOWN_MIDDLE) / "scene.kiln"

    def baked(self, name, *arguments):
        out = self.folder / name
        done = run("bake", self.scene, *arguments, "--json", "-o", out)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout), out

    def test_a_larger_pixel_error_takes_fewer_triangles(self):
        finest, _ = self.baked("finest.glb", "--tolerance", "0.05")
        counts = [self.baked(f"{pixels}.glb", EYE, "--pixel-error", pixels)[0]["triangles"] for pixels in (1, 4, 16)]
        self.assertLess(counts[0], finest["triangles"])
        self.assertGreater(counts[0], counts[1])
        self.assertGreater(counts[1], counts[2])

    def test_the_file_states_the_viewpoint_and_its_pixel_error(self):
        answer, path = self.baked("seen.glb", EYE, "--pixel-error", 2, "--size", "1000x500", "--fov", 90)
        seen = Glb(path).gltf["nodes"][0]["extras"]["viewpoint"]
        self.assertEqual(seen["eye_m"], [60, 40, 80])
        self.assertAlmostEqual(seen["focal_px"], 250, 2)
        self.assertEqual(seen["pixel_error"], answer["pixel_error"])
        self.assertLessEqual(seen["pixel_error"], 2)

    @long_test
    def test_tiles_baked_alone_add_up_to_the_whole(self):
        whole, _ = self.baked("whole.glb", EYE)
        tiles = [json.loads(line)["tile"] for line in run("inspect", self.scene).stdout.splitlines() if '"tile"' in line]
        self.assertGreater(len(tiles), 3)
        apart = [self.baked(f"{tile}.glb", EYE, "--tile", tile)[0]["triangles"] for tile in tiles]
        self.assertEqual(sum(apart), whole["triangles"])

    @long_test
    def test_same_bytes_for_any_number_of_threads(self):
        self.assertEqual(*(sha256(self.baked(f"{n}.glb", EYE, "--threads", n)[1]) for n in (1, 3)))

    def test_a_wrong_viewpoint_is_one_error_line(self):
        for wrong in (["--eye", "1,2"], [EYE, "--pixel-error", "0"], [EYE, "--fov", "180"], [EYE, "--tile", "99_99"]):
            done = run("bake", self.scene, *wrong, "-o", self.folder / "wrong.glb")
            self.assertEqual(done.returncode, 1)
            self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)
            self.assertFalse((self.folder / "wrong.glb").exists())


if __name__ == "__main__":
    unittest.main(verbosity=2)
