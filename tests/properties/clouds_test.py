#!/usr/bin/env python3
"""Tests that outputs have the clouds of the extent: the same bytes for any number of threads and for a tile made alone, none for a clear
sky; that layers take few bytes of a manifest; and that bad layers are refused in one line."""
import json
import unittest

from citykiln_program import TOWN, ProgramTest, run, sha256

SPEC = ("--spec", TOWN / "spec.json", "--lods", "12.5")
FILES = ("glb/clouds.glb", "usd/clouds.usdc", "usd/clouds.vdb")


class Clouds(ProgramTest):
    def hashes(self, out):
        listed = {file["name"] for file in json.loads((out / "files.json").read_text())["files"]}
        found = {name: sha256(out / name) for name in FILES if (out / name).exists()}
        self.assertLessEqual(set(found), listed)
        return found

    def test_a_tile_made_alone_has_the_same_clouds_whatever_the_threads(self):
        whole = self.compiled("whole", *SPEC, "--emit", "kiln,glb,usd", "--clouds", "broken", "--threads", "1")
        alone = self.compiled("alone", *SPEC, "--emit", "kiln,glb,usd", "--clouds", "broken", "--threads", "3", "--only", "-1_-1")
        found = self.hashes(whole)
        self.assertLessEqual({"glb/clouds.glb", "usd/clouds.usdc"}, set(found))
        self.assertEqual(found, self.hashes(alone))
        for name in found:
            self.assertGreater((whole / name).stat().st_size, 20000, name)

    def test_a_clear_sky_has_no_files_and_layers_take_few_bytes(self):
        clear = self.compiled("clear", *SPEC, "--emit", "kiln,glb,usd", "--only", "-1_-1", "--clouds", "clear")
        self.assertEqual(self.hashes(clear), {})
        self.assertNotIn("clouds", (clear / "usd/scene.usda").read_text())
        broken = self.compiled("broken", *SPEC, "--emit", "kiln", "--only", "-1_-1", "--clouds", "broken")
        self.assertLess((broken / "scene.kiln").stat().st_size - (clear / "scene.kiln").stat().st_size, 300)

    def test_clouds_that_nobody_asked_for_are_in_the_manifest_alone(self):
        usual = self.compiled("usual", *SPEC, "--emit", "kiln,glb,usd", "--only", "-1_-1")
        self.assertEqual(self.hashes(usual), {})
        self.assertNotIn("clouds", (usual / "usd/scene.usda").read_text())

    def test_bad_layers_are_refused_in_one_line(self):
        bad = {"text": "{", "unknown": '{"layers": [{"kind": "fog"}]}', "upside down": '{"layers": [{"kind": "cirrus", "base": 3000, "top": 9}]}',
               "many": json.dumps({"layers": [{"kind": "stratus"}] * 9}), "huge": '{"layers": []}' + " " * 70000,
               "infinite": '{"layers": [{"kind": "cumulus", "cover": 1e999}]}', "binary": "\x00\xff"}
        for name, text in bad.items():
            with self.subTest(name):
                path = self.folder / "bad.json"
                path.write_text(text, encoding="latin-1")
                done = run("compile", *SPEC, "--clouds", path, "-o", self.folder / "out")
                self.assertEqual(done.returncode, 1, done.stdout)
                self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)
                self.assertIn("bad.json", done.stderr)

    def test_the_thickest_layer_gives_files_of_bounded_size(self):
        layers = self.folder / "layers.json"
        layers.write_text(json.dumps({"layers": [{"kind": "stratus", "cover": 0.5, "base": -500, "top": 20000}]}))
        out = self.compiled("low", *SPEC, "--emit", "glb,usd", "--only", "-1_-1", "--clouds", layers)
        for name in self.hashes(out):
            self.assertLess((out / name).stat().st_size, 60e6, name)


if __name__ == "__main__":
    unittest.main(verbosity=2)
