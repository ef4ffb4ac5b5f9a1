#!/usr/bin/env python3
"""Invented worlds: valid files, the same bytes at any number of threads, and what invent alone promises; each kind goes through
compile and check without a finding of broken guarantees.
"""
import collections
import json
import unittest

from citykiln_program import ProgramTest, long_test, run, sha256

KINDS = ["village", "town", "city", "tiles", "forest"]
FILES = ["map.osm.pbf", "heights.tif", "invent.json", "spec.json"]


class Invent(ProgramTest):
    def invented(self, kind, seed, *arguments, name=None):
        out = self.folder / (name or f"{kind}{seed}")
        done = run("invent", "--kind", kind, "--seed", seed, *arguments, "-o", out, "--json")
        self.assertEqual(done.returncode, 0, f"{kind}, seed {seed}: {done.stderr}")
        return out, json.loads(done.stdout)

    def test_each_kind_is_valid_for_some_seeds(self):
        self.check_seeds(4)

    @long_test
    def test_each_kind_is_valid_for_1000_seeds(self):
        self.check_seeds(1000)

    def check_seeds(self, count):
        for kind in KINDS:
            totals = collections.Counter()
            for seed in range(1, count + 1):
                out, summary = self.invented(kind, seed, "--size", 256, name="world")
                self.assertEqual(sorted(path.name for path in out.iterdir()), sorted(FILES))
                self.assertGreater(summary["nodes"], 10, f"{kind}, seed {seed} is empty")
                totals += collections.Counter({key: summary[key] for key in ("nodes", "ways", "relations")})
            print(f"{kind}: {count} seeds, {dict(totals)}")

    def test_a_seed_gives_the_same_bytes_and_another_seed_others(self):
        for kind in KINDS:
            first, _ = self.invented(kind, 3, "--size", 512, name="a")
            hashes = {name: sha256(first / name) for name in FILES}
            again, _ = self.invented(kind, 3, "--size", 512, name="a")
            self.assertEqual({name: sha256(again / name) for name in FILES}, hashes)
            other, _ = self.invented(kind, 4, "--size", 512, name="a")
            self.assertNotEqual(sha256(other / "heights.tif"), hashes["heights.tif"])

    def test_settings_that_were_written_give_the_same_world(self):
        first, _ = self.invented("forest", 3, "--size", 512, "--place", "-3.5,55.2")
        done = run("invent", "--settings", first / "invent.json", "-o", self.folder / "b")
        self.assertEqual(done.returncode, 0, done.stderr)
        for name in FILES[:3]:
            self.assertEqual(sha256(first / name), sha256(self.folder / "b" / name))

    def test_worlds_are_compiled_and_checked_without_a_finding(self):
        for kind in KINDS:
            out, _ = self.invented(kind, 5, "--size", 256)
            self.check_compiled(out)

    @long_test
    def test_40_worlds_of_each_kind_are_compiled_and_checked(self):
        for kind in KINDS:
            for seed in range(1, 41):
                out, _ = self.invented(kind, seed, "--size", 512, name="world")
                self.check_compiled(out)

    def check_compiled(self, out):
        compiled = self.compiled(out / "run", "--spec", out / "spec.json", "--lods", 2.5)
        done = run("check", compiled)
        self.assertEqual(done.returncode, 0, f"{out}: {done.stdout}{done.stderr}")

    def test_bad_input_gives_one_line(self):
        settings, tiles = self.folder / "bad.json", self.folder / "bad.tiles"
        settings.write_text('{"terrain": {"powr": 3}}')
        tiles.write_text("tile a\nsides . .\n")
        for arguments, message in (
                (["--kind", "moon"], "expected village, town, city, tiles or forest"),
                (["--place", "200,0"], "expected longitude,latitude"),
                (["--size", "0"], "--size"),
                (["--settings", settings], "bad.json: unknown setting \"powr\"; did you mean power?"),
                (["--settings", self.folder / "none.json"], "none.json"),
                (["--kind", "tiles", "--tileset", tiles], "bad.tiles:2: expected the labels of four sides")):
            done = run("invent", *arguments, "-o", self.folder / "out")
            self.assertEqual(done.returncode, 1, arguments)
            self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
            self.assertIn(message, done.stderr)
            self.assertFalse((self.folder / "out").exists())


if __name__ == "__main__":
    unittest.main()
