#!/usr/bin/env python3
"""Blender, Godot and three.js show tiles as citykiln means them, for the target `generic` and for their own: the same triangles, boxes,
materials and places, pictures like those of `citykiln preview`, and plants and lamps at any distance.

readers_test.py Blender|Godot|Three[Real] runs the tests with one program."""
import sys
import unittest

import readers
from readers import ReaderTest, coverage_of, difference, our_picture, picture

LODS = ["0.5", "2.5", "12.5"]
# where the largest part of the town's plants is seen behind houses
EYE, LOOK = (-60, -260, 470), (60, 200, 390)
DISTANCES_M = [20, 100, 500]
SMALL = (480, 270)
# how many times finer the pictures are that the coverage is compared with
FINER = 4


class Program(ReaderTest):
    """The claims about one program. @param load  A function such as readers.run_blender."""
    target = None
    # of the tiles in pictures
    pictured = "generic"
    has_mipmaps = True
    # the largest mean difference from our pictures, whose light is another
    unlike = 0.15

    def load(self, files, pictures=()):
        raise NotImplementedError

    def tiles(self, out):
        files = sorted((out / "glb").glob("*.glb"))
        self.assertGreater(len(files), 0)
        return files

    def assert_loaded(self, files):
        found, printed = self.load(files)
        self.assertEqual(len(found), len(files))
        for facts, path in zip(found, files, strict=True):
            with self.subTest(path=path.name):
                self.assert_same(facts, path)
        return printed

    def same_for_both_targets(self, compiled, *arguments):
        instances = 0
        for target in ("generic", self.target):
            out = compiled(target, "--target", target, "--lods", ",".join(LODS), *arguments)
            files = self.tiles(out)
            self.assert_loaded(files)
            instances += sum(len(places) > 1 for path in files for places in readers.facts_of(path)["places"].values())
        self.assertGreater(instances, 0)


class Town(Program):
    """The example town."""

    def test_tiles_hold_the_same(self):
        self.same_for_both_targets(self.town)

    def test_pictures_are_like_ours(self):
        out = self.town("town", "--target", self.pictured, "--lods", "0.5")
        files = self.tiles(out)
        seen = {name: readers.kept(self.folder) / f"{type(self).__name__}_{name}.png" for name in ("all", "bare")}
        layers = ["ground", "roads", "water", "buildings", "structures", "props"]
        self.load(files, [picture(seen["all"], EYE, LOOK), picture(seen["bare"], EYE, LOOK, shown=layers)])
        ours = our_picture(out, 0, readers.kept(self.folder) / "ours.png", EYE, LOOK)
        mean, bare = difference(seen["all"], ours), difference(seen["bare"], ours)
        print(f"{type(self).__name__}: mean difference from our picture {mean:.3f}, without plants {bare:.3f}")
        self.assertLess(mean, self.unlike)
        # the picture would be less like ours if plants were missing
        self.assertLess(mean, bare)

    def test_plants_and_lamps_show_at_any_distance(self):
        for level in ("0.5", "2.5"):
            files = self.tiles(self.town(level, "--target", self.pictured, "--lods", level, "--only=0_0"))
            places = {layer: place_of(files[0], names) for layer, names in
                      (("plants", ("oak", "maple", "lime")), ("props", ("ArmLamp", "PostTopLamp")))}
            rows = [(layer, d, *self.pair(level, layer, places[layer], d)) for layer in places for d in DISTANCES_M]
            # pictures without mipmaps last: switching them uploads all textures again
            self.load(files, [row[2] for row in rows] + [row[3] for row in rows if self.has_mipmaps])
            for layer, d, seen, exact in rows:
                with self.subTest(level=level, layer=layer, distance_m=d):
                    covered = coverage_of(seen["out"])
                    self.assert_covered(layer, level, d, covered, coverage_of(exact["out"]) if self.has_mipmaps else covered)

    def pair(self, level, layer, place, distance_m):
        """Pictures of a layer as the program draws it, and sampled more finely without mipmaps."""
        eye = [place[0] + 0.6 * distance_m, place[1] - 0.77 * distance_m, place[2] + 2 + 0.2 * distance_m]
        look = [place[0], place[1], place[2] + 4]
        name = readers.kept(self.folder) / f"{type(self).__name__}_{layer}_{level}_{distance_m}"
        large = [FINER * pixels for pixels in SMALL]
        return (picture(f"{name}.png", eye, look, SMALL, [layer], coverage=True),
                picture(f"{name}_exact.png", eye, look, large, [layer], coverage=True, mipmaps=False))

    def assert_covered(self, layer, level, distance_m, seen, exact):
        print(f"{type(self).__name__}: {layer} at {level} m from {distance_m} m cover {100 * seen:.2f} % of the picture, exactly {100 * exact:.2f} %")
        self.assertGreater(exact, 1e-5)
        self.assertGreater(seen, 0.7 * exact)
        # the smallest mipmap of a leaf is opaque: crowns a few pixels high look fuller than they are
        self.assertLess(seen, 2 * exact)


def place_of(path, names):
    """Where the first instance of a mesh with one of these names stands, in plane metres."""
    places = readers.facts_of(path)["places"]
    matrix = next(rows[0] for name, rows in sorted(places.items()) if name.startswith(names))
    x, y, z = (matrix[i][3] for i in range(3))
    return [x, -z, y]


class Real(Program):
    """A tile of Monaco."""

    def test_tiles_hold_the_same(self):
        self.same_for_both_targets(self.monaco)


class InBlender(Program):
    target = "blender"
    is_blender = True
    # Cycles traces rays
    has_mipmaps = False

    def load(self, files, pictures=()):
        found, printed = readers.run_blender(self.folder, files, pictures)
        for word in ("error", "traceback", "unknown", "not supported"):
            self.assertNotIn(word, printed.lower())
        return found, printed


class InGodot(Program):
    target = "godot"
    # generic tiles need KHR_texture_transform, which Godot 3 lacks: the triangles are right, the pictures on them are not
    pictured = "godot"

    def load(self, files, pictures=()):
        return readers.run_godot(self.folder, files, pictures)


class InThree(Program):
    target = "three"

    def load(self, files, pictures=()):
        found, printed = readers.run_three(self.folder, files, pictures)
        self.assertNotIn("error", printed.lower())
        return found, printed


class Blender(InBlender, Town):
    pass


class BlenderReal(InBlender, Real):
    pass


class Godot(InGodot, Town):
    pass


class GodotReal(InGodot, Real):
    pass


class Three(InThree, Town):
    pass


class ThreeReal(InThree, Real):
    pass


if __name__ == "__main__":
    program = sys.argv[1].split(".")[0].removesuffix("Real")
    found = {"Blender": readers.blender() is not None, "Godot": readers.godot() is not None,
             "Three": readers.chromium() is not None and readers.has_npm("three") and readers.has_npm("playwright-core")}[program]
    readers.skip_unless(found and readers.has_pictures(),
                        f"{program} is not installed (./setup.sh release interop; npm ci --prefix tests/interop)")
    unittest.main(argv=sys.argv[:2], verbosity=2)
