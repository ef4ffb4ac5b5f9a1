#!/usr/bin/env python3
"""Compressed tiles keep the guarantees of plain ones: the same bytes on every run, borders that meet, errors within the tolerance."""
import unittest

from citykiln_program import TOWN, TOWN_MIDDLE, ProgramTest, bytes_of_outputs, long_test, report_of, run

ARGUMENTS = ["--spec", TOWN / "spec.json", *TOWN_MIDDLE, "--tile", "128", "--lods", "2.5,12.5"]

# The largest error of compression: half a step of 2^-5 m in each direction, half of it for instances of at most double
# size, and single precision.
MAX_ADDED_ERROR_M = 0.75**0.5 / 32 + 0.0001


class Packed:
    """The claims about one compression, which a subclass names."""

    COMPRESS = ""

    def packed_once(self):
        return self.compiled_once(*self.words())

    def words(self):
        return [*ARGUMENTS, "--target", "three", "--compress", self.COMPRESS]

    def test_threads_and_verbs_change_no_byte(self):
        plain = self.packed_once()
        baked = self.folder / "baked"
        done = run("bake", plain / "scene.kiln", "--lods", "2.5,12.5", "--target", "three", "--compress", self.COMPRESS, "--threads", 1,
                   "-o", baked)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(bytes_of_outputs(plain), bytes_of_outputs(baked))

    def test_check_finds_no_error(self):
        done = run("check", self.packed_once())
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_the_report_states_the_error_of_compression(self):
        plain, packed = report_of(self.compiled_once(*ARGUMENTS, "--compress", "none", "--target", "godot")), report_of(self.packed_once())
        self.assertTrue(plain["tiles"])
        for before, after in zip(plain["tiles"], packed["tiles"], strict=True):
            self.assertGreaterEqual(after["error_m"], before["error_m"])
            self.assertLessEqual(after["error_m"], before["error_m"] + MAX_ADDED_ERROR_M)
            self.assertLessEqual(after["triangles"], before["triangles"])
            self.assertGreater(after["triangles"], 0.98 * before["triangles"])
            self.assertLess(after["bytes"], before["bytes"])

    def test_preview_reads_them(self):
        out = self.packed_once()
        done = run("preview", out, "--size", "64x48", "--spp", 1, "-o", self.folder / "x.png")
        self.assertEqual(done.returncode, 0, done.stderr)


@long_test
class PackedByQuantization(Packed, ProgramTest):
    COMPRESS = "quantize"


class PackedByDraco(Packed, ProgramTest):
    COMPRESS = "draco"


@long_test
class PackedByMeshopt(Packed, ProgramTest):
    COMPRESS = "meshopt"


if __name__ == "__main__":
    unittest.main()
