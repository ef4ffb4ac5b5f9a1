#!/usr/bin/env python3
"""3D Tiles stand where the map says: mapped trees of the town at their longitude and latitude on the WGS84 ellipsoid, lifted by a geoid
that is read from a file of GeographicLib's form. Places are computed here, from the specification's numbers alone."""
import math
import unittest
import xml.etree.ElementTree as ElementTree

from citykiln_program import IS_FULL, TOWN, TOWN_MIDDLE, ProgramTest, report_of, run
from glb import Glb
from tiles3d_test import Tileset

ARGUMENTS = ["--spec", TOWN / "spec.json", "--lods", "2.5", "--emit", "kiln,3dtiles", *([] if IS_FULL else TOWN_MIDDLE)]
A_M, F = 6378137, 1 / 298.257223563
NEAR_M = 0.01


def geodetic(x, y, z):
    """Longitude and latitude in degrees and height in metres of a place, by iteration (to 1e-9 m)."""
    e2, p = F * (2 - F), math.hypot(x, y)
    lat = math.atan2(z, p * (1 - e2))
    for _ in range(6):
        n = A_M / math.sqrt(1 - e2 * math.sin(lat)**2)
        lat = math.atan2(z + e2 * n * math.sin(lat), p)
    n = A_M / math.sqrt(1 - e2 * math.sin(lat)**2)
    return math.degrees(math.atan2(y, x)), math.degrees(lat), p * math.cos(lat) + z * math.sin(lat) - A_M * A_M / n


def moved(transform, v):
    """A point times a matrix by columns."""
    return [sum(transform[4 * k + i] * v[k] for k in range(3)) + transform[12 + i] for i in range(3)]


def mapped_trees():
    nodes = ElementTree.parse(TOWN / "town.osm").iter("node")
    return {int(node.get("id")): (float(node.get("lon")), float(node.get("lat"))) for node in nodes
            if any((tag.get("k"), tag.get("v")) == ("natural", "tree") for tag in node)}


def instances(tile):
    """The OSM id and place (z up) of each instance of a content, whose nodes are not turned."""
    ids = tile.osm_ids()

    def visit(number, above):
        node = tile.gltf["nodes"][number]
        place = [a + t for a, t in zip(above, node.get("translation", [0, 0, 0]))]
        attributes = node.get("extensions", {}).get("EXT_mesh_gpu_instancing", {}).get("attributes")
        if attributes:
            for at, (feature,) in zip(tile.values(attributes["TRANSLATION"]), tile.values(attributes["_FEATURE_ID_0"]), strict=True):
                x, y, z = (p + a for p, a in zip(place, at))
                yield ids[int(feature)], (x, -z, y)
        for child in node.get("children", []):
            yield from visit(child, place)

    for root in tile.gltf["scenes"][tile.gltf.get("scene", 0)]["nodes"]:
        yield from visit(root, [0, 0, 0])


def write_geoid(path, height_of):
    """A grid of one degree, rows from the north and columns from longitude 0, with heights in steps of 1 cm from -100 m on."""
    rows = [[round((height_of(lon, 90 - row) + 100) * 100) for lon in range(360)] for row in range(181)]
    samples = b"".join(value.to_bytes(2, "big") for row in rows for value in row)
    path.write_bytes(b"P5\n# Offset -100\n# Scale 0.01\n# Origin 90N 0E\n360 181\n65535\n" + samples)


class Places(ProgramTest):
    def trees(self, name, *arguments):
        """Longitude, latitude and height of each mapped tree in the contents of tiles."""
        tileset = Tileset(self.compiled(name, *ARGUMENTS, *arguments) / "3dtiles", self)
        transform = tileset.document["root"]["transform"]
        wanted = mapped_trees()
        found = {osm: geodetic(*moved(transform, at)) for uri in tileset.contents() if "_L" in uri
                 for osm, at in instances(Glb(tileset.folder / uri)) if osm in wanted}
        self.assertGreater(len(found), 200 if IS_FULL else 40)
        return found

    def test_trees_stand_at_their_longitude_and_latitude(self):
        wanted = mapped_trees()
        for osm, (lon, lat, height_m) in self.trees("out", "--geoid-height", 47.25).items():
            north_m = math.radians(lat - wanted[osm][1]) * 6.37e6
            east_m = math.radians(lon - wanted[osm][0]) * 6.39e6 * math.cos(math.radians(lat))
            self.assertLess(math.hypot(north_m, east_m), NEAR_M, osm)
            # the town's ground, and the geoid
            self.assertTrue(370 + 47 < height_m < 480 + 47, height_m)

    def test_a_geoid_lifts_each_tree_by_its_height_there(self):
        # as steep as the steepest real ones, and in whole centimetres at the grid's points
        height_of = lambda lon, lat: max(-90, min(90, 8 * (lat - 43) + 6 * (lon - 12)))  # noqa: E731
        write_geoid(self.folder / "made.pgm", height_of)
        flat, lifted = self.trees("flat"), self.trees("lifted", "--geoid-height", self.folder / "made.pgm")
        self.assertEqual(flat.keys(), lifted.keys())
        for osm, (lon, lat, height_m) in lifted.items():
            self.assertLess(abs(height_m - flat[osm][2] - height_of(lon, lat)), NEAR_M)
            self.assertLess(abs(lon - flat[osm][0]) + abs(lat - flat[osm][1]), 1e-7)
        self.assertIn("NoGeoidHeight", report_of(self.folder / "flat")["diagnoses"])
        self.assertNotIn("NoGeoidHeight", report_of(self.folder / "lifted")["diagnoses"])

    def test_files_that_are_no_geoid_are_one_clear_line(self):
        write_geoid(self.folder / "whole.pgm", lambda lon, lat: 40)
        whole = (self.folder / "whole.pgm").read_bytes()
        broken = {"text.pgm": b"48.5 metres\n", "cut.pgm": whole[:5000], "empty.pgm": b"", "long.pgm": whole + b"0",
                  "no_scale.pgm": whole.replace(b"# Scale 0.01\n", b"")}
        for name, data in broken.items():
            (self.folder / name).write_bytes(data)
        (self.folder / "folder.pgm").mkdir()
        for name in [*broken, "folder.pgm", "missing.pgm"]:
            with self.subTest(name):
                done = run("compile", *ARGUMENTS, "--geoid-height", self.folder / name, "-o", self.folder / "x")
                self.assertEqual(done.returncode, 1)
                self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)
                self.assertIn(name, done.stderr)
                self.assertFalse((self.folder / "x").exists())


if __name__ == "__main__":
    unittest.main()
