#!/usr/bin/env python3
"""Claims about USD and 3D Tiles alike: the same bytes for any number of threads and order of the map, and one clear line where a folder
cannot be written or the disk is full; an earlier run stays. Packed contents of 3D Tiles state their error."""
import json
import resource
import subprocess
import unittest

from citykiln_program import PROGRAM, ROOT, TOWN, TOWN_MIDDLE, ProgramTest, report_of, run, sha256
from glb import Glb
from shuffled import shuffle
from tiles3d_test import Tileset

FORMS = ["usd", "3dtiles"]
HEIGHTS = json.loads((TOWN / "spec.json").read_text())["dem"]
ARGUMENTS = ["--dem", HEIGHTS, "--lods", "2.5,12.5", "--geoid-height", "47", *TOWN_MIDDLE, "--tile", "128"]


def files_of(out):
    """Name to hash of all files of the two forms."""
    found = {str(path.relative_to(out)): sha256(path) for form in FORMS for path in sorted((out / form).rglob("*")) if path.is_file()}
    assert any(name.endswith(".usdc") for name in found) and any(name.endswith(".glb") for name in found), found.keys()
    return found


class Forms(ProgramTest):
    def both(self, name, *arguments, osm=TOWN / "town.osm"):
        return self.compiled(name, osm, *ARGUMENTS, "--emit", "kiln,usd,3dtiles", *arguments)

    def tileset(self, name, *arguments):
        return Tileset(self.compiled(name, TOWN / "town.osm", *ARGUMENTS, "--emit", "kiln,3dtiles", *arguments) / "3dtiles", self)

    def test_threads_and_order_change_no_byte(self):
        one = files_of(self.both("t1", "--threads", 1))
        self.assertEqual(one, files_of(self.both("t2", "--threads", 2)))
        other = self.folder / "shuffled" / "town.osm"
        other.parent.mkdir()
        shuffle(TOWN / "town.osm", other, 3)
        self.assertEqual(one, files_of(self.both("s", osm=other)))

    def refused(self, *command, **options):
        """Runs the program, which fails with one line, and returns it."""
        done = subprocess.run([PROGRAM, *map(str, command)], cwd=ROOT, capture_output=True, text=True, check=False, **options)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)
        return done.stderr

    def test_folders_that_cannot_be_written_are_one_clear_line(self):
        (self.folder / "file").write_text("no folder")
        for form in FORMS:
            with self.subTest(form):
                line = self.refused("compile", TOWN / "town.osm", *ARGUMENTS, "--emit", form, "-o", self.folder / "file" / "out")
                self.assertIn("file/out", line)

    def test_a_full_disk_is_one_clear_line_and_leaves_the_earlier_run(self):
        for form in FORMS:
            with self.subTest(form):
                out = self.compiled(form, TOWN / "town.osm", *ARGUMENTS, "--emit", form)
                before = {path: sha256(path) for path in sorted(out.rglob("*")) if path.is_file()}
                largest = max(path.stat().st_size for path in before)
                limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (largest - 1, largest - 1))  # noqa: E731
                finer = [*ARGUMENTS[:3], "1.2,12.5", *ARGUMENTS[4:]]
                line = self.refused("compile", TOWN / "town.osm", *finer, "--emit", form, "-o", out, preexec_fn=limit)
                self.assertIn(str(out), line)
                self.assertEqual(before, {path: sha256(path) for path in before})

    def test_other_worlds_are_one_clear_line(self):
        for arguments in (["--world", "sphere"], ["--emit", "usd,glb", "--world", "ellipsoid"]):
            with self.subTest(arguments):
                self.assertIn("--world", self.refused("compile", TOWN / "town.osm", *ARGUMENTS, *arguments, "-o", self.folder / "w"))

    def test_packed_contents_state_their_error_and_are_checked(self):
        plain = self.tileset("plain")
        stated = {uri: Glb(plain.folder / uri).gltf["nodes"][0]["extras"]["error_m"] for uri in plain.contents()}
        for compression in ("quantize", "draco", "meshopt"):
            with self.subTest(compression):
                tileset = self.tileset(compression, "--compress", compression)
                out, contents = tileset.folder.parent, tileset.contents()
                self.assertEqual(contents.keys(), stated.keys())
                raised = 0
                for uri, tile in contents.items():
                    error_m = Glb(tileset.folder / uri).gltf["nodes"][0]["extras"]["error_m"]
                    self.assertGreaterEqual(tile["geometricError"], error_m)
                    self.assertGreaterEqual(error_m, stated[uri] / 1.001)
                    raised += error_m > stated[uri]
                    children = [child["geometricError"] for child in tile.get("children", [])]
                    self.assertLess(max(children, default=0), tile["geometricError"])
                self.assertGreater(raised, 0)
                self.assertNotIn("NoGeoidHeight", report_of(out)["diagnoses"])
                done = run("check", out)
                self.assertEqual(done.returncode, 0, done.stdout + done.stderr)


if __name__ == "__main__":
    unittest.main()
