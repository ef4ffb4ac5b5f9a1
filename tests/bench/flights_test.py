#!/usr/bin/env python3
"""flights.py: which tiles a viewer shows, from where, and what that costs."""
import json
import math
import tempfile
import unittest
from pathlib import Path

from flights import FOCAL_PX, Account, Content, Runs, Tile, View, distance_m, eye_of, grown, is_in_picture, sets_of_levels, shown

CUBE = (0, 0, 0, 50, 0, 0, 0, 50, 0, 0, 0, 50)  # sides of 100 m about the origin


def chain(*levels):
    """One place at several errors, the coarsest first."""
    tile = None
    for error_m, name in reversed(levels):
        tile = Tile(CUBE, error_m, Path(name), [tile] if tile else [])
    return tile


def write_run(folder, tolerances, shown_errors):
    """A run of one map tile below one inner tile. `shown_errors` are the errors of levels by index; one without is no coarser than another."""
    tile = None
    for index, error_m in sorted(shown_errors.items()):
        tile = {"boundingVolume": {"box": CUBE}, "geometricError": error_m, "content": {"uri": f"0_0_L{index}.glb"},
                "extras": {"tolerance_m": tolerances[index]}, "children": [tile] if tile else []}
    root = {"boundingVolume": {"box": CUBE}, "geometricError": 50, "content": {"uri": "Q1_0_0.glb"}, "transform": [], "children": [tile]}
    (folder / "3dtiles").mkdir(parents=True)
    (folder / "3dtiles" / "tileset.json").write_text(json.dumps({"root": root}))
    (folder / "report.json").write_text(json.dumps({"levels": [{"tolerance_m": tolerance} for tolerance in tolerances]}))


def chain_of(root):
    return [(root.error_m, root.path.name), *(chain_of(root.children[0]) if root.children else [])]


def names(tiles):
    return [tile.path.name for tile in tiles]


def view_from(x, heading=(1, 0)):
    return View(eye_of((x, 0, 0), heading, 0))


class Flights(unittest.TestCase):
    def test_the_distance_is_that_of_the_box_and_nought_inside(self):
        self.assertEqual(distance_m((10, 20, 30), CUBE), 0)
        self.assertEqual(distance_m((-150, 0, 0), CUBE), 100)
        self.assertAlmostEqual(distance_m((53, 54, 0), CUBE), 5)

    def test_a_grown_box_contains_both(self):
        self.assertEqual(grown(CUBE, (20, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 3)), CUBE)
        self.assertEqual(grown(CUBE, (0, 0, 60, 10, 0, 0, 0, 80, 0, 0, 0, 10)), (0, 0, 10, 50, 0, 0, 0, 80, 0, 0, 0, 60))

    def test_the_picture_is_60_degrees_high_and_wider(self):
        eye = eye_of((-1050, 0, 0), (1, 0), 0)
        for lift, is_seen in ((0, True), (600, True), (700, False)):
            self.assertEqual(is_in_picture(eye, (0, 0, lift, *CUBE[3:])), is_seen, lift)
        self.assertTrue(is_in_picture(eye, (0, 1000, 0, *CUBE[3:])))
        self.assertFalse(is_in_picture(eye_of((-1050, 0, 0), (-1, 0), 0), CUBE))

    def test_a_level_is_shown_from_where_its_error_is_at_most_the_pixels(self):
        levels = chain((2.5, "coarse"), (0.5, "middle"), (0.1, "fine"))
        for pixels in (1, 6):
            for error_m, name in ((2.5, "coarse"), (0.5, "middle")):
                from_m = 50 + error_m * FOCAL_PX / pixels
                self.assertEqual(names(shown(levels, view_from(-from_m - 0.1), pixels)[0]), [name])
                self.assertNotEqual(names(shown(levels, view_from(-from_m + 0.1), pixels)[0]), [name])

    def test_inside_of_a_box_the_finest_level_is_shown_and_the_others_are_above_it(self):
        tiles, above = shown(chain((2.5, "coarse"), (0.5, "middle"), (0.1, "fine")), view_from(0), 1)
        self.assertEqual((names(tiles), names(above)), (["fine"], ["coarse", "middle"]))

    def test_nothing_is_shown_outside_of_the_picture(self):
        self.assertEqual(shown(chain((2.5, "coarse"), (0.1, "fine")), view_from(-1000, (-1, 0)), 1), ([], []))

    def test_sets_have_the_finest_level_and_neighbours_at_most_five_times_as_coarse(self):
        sets = list(sets_of_levels([0.1, 0.5, 2.5, 12.5, 25]))
        self.assertIn((0.1, 0.5, 2.5, 12.5), sets)
        self.assertNotIn((0.1, 0.5, 12.5), sets)
        self.assertTrue(all(levels[0] == 0.1 and 3 <= len(levels) <= 6 for levels in sets))

    def test_files_count_once_a_flight_and_triangles_once_a_picture(self):
        fine, coarse = Tile(CUBE, 0.1, Path("fine")), Tile(CUBE, 0.5, Path("coarse"))
        contents = {Path("fine"): Content(bytes=9, triangles=100, draws=4), Path("coarse"): Content(bytes=3, triangles=20, draws=5)}
        account = Account()
        account.add([fine], [coarse], contents)
        account.add([coarse], [], contents)
        self.assertEqual((account.paths, account.triangles, account.draws), (contents.keys(), 100, 5))
        self.assertEqual(account.sum_triangles / account.pictures, 60)

    def test_a_set_joins_levels_of_runs_below_the_inner_tiles_of_its_coarsest_level(self):
        with tempfile.TemporaryDirectory() as scratch:
            coarse, fine = Path(scratch) / "coarse", Path(scratch) / "fine"
            write_run(coarse, [2.5, 12.5], {0: 2.25, 1: 8})
            write_run(fine, [0.1, 0.5], {0: 0.09, 1: 0.4})
            runs = Runs([coarse, fine])
            self.assertEqual(chain_of(runs.roots((0.1, 2.5, 12.5), "tree")[0]),
                             [(50, "Q1_0_0.glb"), (8, "0_0_L1.glb"), (2.25, "0_0_L0.glb"), (0.09, "0_0_L0.glb")])
            self.assertEqual(chain_of(runs.roots((0.5, 2.5), "flat")[0]), [(2.5, "0_0_L0.glb"), (0.5, "0_0_L1.glb")])

    def test_a_chain_ends_above_a_level_that_no_run_has(self):
        with tempfile.TemporaryDirectory() as scratch:
            write_run(Path(scratch) / "run", [0.1, 2.5], {0: 0.09, 1: 2.25})
            runs = Runs([Path(scratch) / "run"])
            tile = runs.roots((0.1, 0.5, 2.5), "flat")[0]
            self.assertEqual(chain_of(tile), [(2.5, "0_0_L1.glb")])
            self.assertFalse(runs.is_finest(tile, (0.1, 0.5, 2.5)))
            self.assertEqual(runs.roots((0.1, 0.5), "flat"), [])

    def test_a_level_that_is_no_coarser_than_the_finer_one_is_that_one(self):
        with tempfile.TemporaryDirectory() as scratch:
            write_run(Path(scratch) / "run", [0.1, 0.5, 2.5], {0: 0.09, 2: 2.25})
            runs = Runs([Path(scratch) / "run"])
            self.assertEqual(chain_of(runs.roots((0.5, 2.5), "flat")[0]), [(2.5, "0_0_L2.glb"), (0.5, "0_0_L0.glb")])
            self.assertEqual(chain_of(runs.roots((0.1, 0.5), "flat")[0]), [(0.1, "0_0_L0.glb")])

    def test_the_focal_length_is_that_of_1080_rows_and_60_degrees(self):
        self.assertTrue(math.isclose(FOCAL_PX, 935.3, abs_tol=0.1))


if __name__ == "__main__":
    unittest.main()
