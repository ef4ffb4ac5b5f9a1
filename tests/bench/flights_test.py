#!/usr/bin/env python3
"""flights.py: which tiles a viewer shows, from where, and what that costs."""
import math
import unittest
from pathlib import Path

from flights import FOCAL_PX, Account, Content, Tile, View, distance_m, eye_of, is_in_picture, sets_of_levels, shown

CUBE = (0, 0, 0, 50, 0, 0, 0, 50, 0, 0, 0, 50)  # sides of 100 m about the origin


def chain(*levels):
    """One place at several errors, the coarsest first."""
    tile = None
    for error_m, name in reversed(levels):
        tile = Tile(CUBE, error_m, Path(name), [tile] if tile else [])
    return tile


def names(tiles):
    return [tile.path.name for tile in tiles]


def view_from(x, heading=(1, 0)):
    return View(eye_of((x, 0, 0), heading, 0))


class Flights(unittest.TestCase):
    def test_the_distance_is_that_of_the_box_and_nought_inside(self):
        self.assertEqual(distance_m((10, 20, 30), CUBE), 0)
        self.assertEqual(distance_m((-150, 0, 0), CUBE), 100)
        self.assertAlmostEqual(distance_m((53, 54, 0), CUBE), 5)

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

    def test_the_focal_length_is_that_of_1080_rows_and_60_degrees(self):
        self.assertTrue(math.isclose(FOCAL_PX, 935.3, abs_tol=0.1))


if __name__ == "__main__":
    unittest.main()
