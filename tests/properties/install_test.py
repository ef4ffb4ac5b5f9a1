#!/usr/bin/env python3
"""An installed program works in any folder, also after the folder was moved."""
import subprocess
import unittest
from pathlib import Path

from citykiln_program import PROGRAM, TOWN, ProgramTest


class Install(ProgramTest):
    def installed_and_moved(self):
        first, second = self.folder / "first", self.folder / "elsewhere" / "second"
        subprocess.run(["cmake", "--install", Path(PROGRAM).parent, "--prefix", first], check=True, capture_output=True)
        second.parent.mkdir()
        first.rename(second)
        return second / "bin" / "citykiln"

    def call(self, program, *arguments):
        done = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True, cwd=self.folder, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_a_moved_installation_compiles_and_renders(self):
        program = self.installed_and_moved()
        self.call(program, "compile", TOWN / "town.osm", "--lods", "2.5", "--emit", "kiln,glb,usd", "--clouds", "fair", "-o", "out")
        self.call(program, "preview", "out", "--level", 0, "--size", "64x48", "--spp", 1, "-o", "town.png")
        self.assertGreater((self.folder / "town.png").stat().st_size, 1000)

    def test_a_moved_installation_compiles_its_own_example(self):
        program = self.installed_and_moved()
        self.call(program, "demo", "--no-view")
        self.assertGreater((self.folder / "citykiln-demo" / "scene.kiln").stat().st_size, 1000)
        share = program.parent.parent / "share/citykiln"
        share.rename(self.folder / "away")
        done = subprocess.run([program, "demo", "--no-view"], capture_output=True, text=True, cwd=self.folder, check=False)
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, r"^citykiln: the example town is missing; expected the folder .*\n$")

    def test_no_file_names_the_build(self):
        program = self.installed_and_moved()
        build = str(Path(PROGRAM).parent).encode()
        named = [path.name for path in program.parent.parent.rglob("*") if path.is_file() and build in path.read_bytes()]
        self.assertEqual(named, [])


if __name__ == "__main__":
    unittest.main()
