#!/usr/bin/env python3
"""Packed tiles keep what plain ones promise: the same bytes however they are made, borders that meet, errors that hold."""
import unittest

from citykiln_program import TOWN, ProgramTest, bytes_of_outputs, report_of, run

ARGUMENTS = ["--spec", TOWN / "spec.json", "--lods", "2.5,12.5"]

# half a step of the grid in each direction, for copies at twice their size at most, and single precision
MOST_M = 2 * 0.75**0.5 / 1024 + 0.0001


class Packed:
    """The claims, for the way of packing that a subclass names."""

    COMPRESS = ""

    def packed(self, name, *arguments):
        return self.compiled(name, *ARGUMENTS, "--compress", self.COMPRESS, *arguments)

    def test_same_bytes_however_they_are_made(self):
        one = bytes_of_outputs(self.packed("t1", "--threads", 1))
        many = self.packed("t7", "--threads", 7)
        self.assertEqual(one, bytes_of_outputs(many))
        baked = self.folder / "baked"
        done = run("bake", many / "scene.kiln", "--lods", "2.5,12.5", "--compress", self.COMPRESS, "-o", baked)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(one, bytes_of_outputs(baked))

    def test_check_finds_every_promise_kept(self):
        done = run("check", self.packed("out"))
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_the_error_of_packing_is_stated(self):
        plain, packed = report_of(self.compiled("plain", *ARGUMENTS)), report_of(self.packed("packed"))
        for before, after in zip(plain["tiles"], packed["tiles"]):
            self.assertGreater(after["error_m"], before["error_m"])
            self.assertLessEqual(after["error_m"], before["error_m"] + MOST_M)
            self.assertEqual(after["triangles"], before["triangles"])
            self.assertLess(after["bytes"], before["bytes"])

    def test_pictures_are_made_of_them(self):
        out = self.packed("out")
        done = run("preview", out, "--size", "64x48", "--spp", 1, "-o", self.folder / "x.png")
        self.assertEqual(done.returncode, 0, done.stderr)


class PackedByDraco(Packed, ProgramTest):
    COMPRESS = "draco"


class PackedByMeshopt(Packed, ProgramTest):
    COMPRESS = "meshopt"


if __name__ == "__main__":
    unittest.main()
