#!/usr/bin/env python3
"""A picture rendered from the manifest is the picture rendered from the tiles baked from it, but for the loss of pictures in the tiles."""
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "properties"))
from citykiln_program import IS_FULL, TOWN, ProgramTest, long_test, run, sha256  # noqa: E402
from png import mean_difference  # noqa: E402

# Textures and facades are JPEG or WebP in tiles. Measured: 0.0001 from above, 0.003 in streets; scenes that differ by a tree, 0.01.
MOST = 0.006

# Small pictures with few samples: equal scenes give equal pictures at any size.
PICTURE = ["--size", "480x270", "--spp", "4"]
VIEWS = ["overview", "street"]


class SamePictures(ProgramTest):
    """The claim about one map."""
    def picture(self, name, *arguments):
        path = self.folder / name
        done = run("preview", *arguments, *PICTURE, "-o", path)
        self.assertEqual(done.returncode, 0, done.stderr)
        return path

    def both_show_the_same(self, *arguments, levels=("2.5",)):
        out = self.compiled("out", *arguments, "--lods", ",".join(levels))
        shown = set()
        for level, tolerance_m in enumerate(levels):
            for view in VIEWS:
                with self.subTest(level=level, view=view):
                    from_manifest = self.picture("manifest.png", out / "scene.kiln", "--tolerance", tolerance_m, "--view", view)
                    from_tiles = self.picture("tiles.png", out, "--level", level, "--view", view)
                    self.assertLessEqual(mean_difference(from_manifest, from_tiles), MOST)
                    shown.add(sha256(from_manifest))
        # pictures of empty sky would all be equal
        self.assertEqual(len(shown), len(VIEWS) * len(levels))


class SamePicturesOfTheTown(SamePictures):
    def test_the_town(self):
        self.both_show_the_same("--spec", TOWN / "spec.json", levels=("0.5", "2.5") if IS_FULL else ("2.5",))

    @long_test
    def test_the_town_with_instancing_and_a_node_for_each_building(self):
        self.both_show_the_same("--spec", TOWN / "spec.json", "--target", "three", "--split", "building")

    @long_test
    def test_the_town_in_many_tiles(self):
        self.both_show_the_same("--spec", TOWN / "spec.json", "--tile", "256")


@long_test
class SamePicturesReal(SamePictures):
    def test_andorra_la_vella(self):
        # one tile of each place, because buildings have many triangles
        # with a node a plant, woods are merged meshes with coarser crowns
        self.both_show_the_same(self.data("andorra/cut-andorra-la-vella.osm.pbf"), "--dem", self.data("andorra/N42E001.hgt"), "--only=0_0",
                                "--target", "three")

    def test_monaco(self):
        self.both_show_the_same(self.data("monaco/monaco-2023.osm.pbf"), "--dem", self.data("monaco/N43E007.hgt"), "--only=0_0")

    def test_chicago_loop(self):
        self.both_show_the_same(self.data("chicago-loop/chicago_loop.osm.pbf"), "--only=0_0")


if __name__ == "__main__":
    unittest.main(verbosity=2)
