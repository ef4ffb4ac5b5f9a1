#!/usr/bin/env python3
"""Heightmaps as programs write them: in feet, with values that stand for no height and are not declared, with datums that
differ, under names with commas. The ground of the tiles shows what was read."""
import math
import shutil
import struct
import unittest

from citykiln_program import ProgramTest, report_of, run
from glb import Glb

LON, LAT = 15.3, 47.0
SIDE, STEP_DEG = 120, 5e-5  # 5.6 m north, 3.8 m east
HOUSE = """<?xml version="1.0"?>
<osm version="0.6">
<bounds minlat="46.9990" minlon="15.2985" maxlat="47.0010" maxlon="15.3015"/>
<node id="1" lat="47.0000" lon="15.3000"/><node id="2" lat="47.0000" lon="15.3001"/>
<node id="3" lat="47.0001" lon="15.3001"/><node id="4" lat="47.0001" lon="15.3000"/>
<way id="5"><nd ref="1"/><nd ref="2"/><nd ref="3"/><nd ref="4"/><nd ref="1"/><tag k="building" v="house"/></way>
</osm>
"""
NO_HEIGHTS = (-9999, -32767, 0, -500, 65535, 99999, 1e20, -99999, 9999, 32767, -1000, -12345)


def hill_m(column, row):
    return 180 + 12 * math.sin(column / 17) + 0.1 * row


def geotiff(rows, west, north, step_deg=STEP_DEG, unit="", vertical=0, is_old=False):
    """An uncompressed GeoTIFF of floats on WGS84. unit: of the band; vertical: the EPSG code of the heights' system."""
    keys = [(1024, 2), (1025, 1), (2048, 4326)] + ([(4096, vertical)] if vertical else [])
    directory = struct.pack(f"<{4 + 4 * len(keys)}H", 1, 1, 0 if is_old else 1, len(keys),
                            *[v for key, value in keys for v in (key, 0, 1, value)])
    extra = [(33550, 12, 3, struct.pack("<3d", step_deg, step_deg, 0)), (33922, 12, 6, struct.pack("<6d", 0, 0, 0, west, north, 0)),
             (34735, 3, len(directory) // 2, directory)]
    if unit:
        text = f'<GDALMetadata><Item name="UNITTYPE" sample="0" role="unittype">{unit}</Item></GDALMetadata>\0'.encode()
        extra.append((42112, 2, len(text), text))
    pixels = b"".join(struct.pack(f"<{len(row)}f", *row) for row in rows)
    short, long = 3, 4
    plain = [(256, short, len(rows[0])), (257, short, len(rows)), (258, short, 32), (259, short, 1), (262, short, 1),
             (277, short, 1), (278, short, len(rows)), (279, long, len(pixels)), (339, short, 3)]
    count = len(plain) + 1 + len(extra)
    at = 8 + 2 + 12 * count + 4
    entries, body = [(tag, kind, 1, struct.pack("<I", value)) for tag, kind, value in plain], b""
    for tag, kind, number, data in sorted(extra):
        entries.append((tag, kind, number, struct.pack("<I", at + len(body))))
        body += data + b"\0" * (len(data) % 2)
    entries.append((273, long, 1, struct.pack("<I", at + len(body))))
    head = b"II*\0" + struct.pack("<IH", 8, count)
    return head + b"".join(struct.pack("<HHI", *entry[:3]) + entry[3] for entry in sorted(entries)) + b"\0" * 4 + body + pixels


def is_hole(column, row):
    return (column - 62) ** 2 + (row - 58) ** 2 < 15 ** 2


class Heightmaps(ProgramTest):
    def setUp(self):
        super().setUp()
        self.map = self.folder / "map.osm"
        self.map.write_text(HOUSE)

    def written(self, name, height, **options):
        rows = [[height(column, row) for column in range(SIDE)] for row in range(SIDE)]
        path = self.folder / name
        path.write_bytes(geotiff(rows, LON - SIDE / 2 * STEP_DEG, LAT + SIDE / 2 * STEP_DEG, **options))
        return path

    def ground(self, name, *dems):
        """The lowest and the highest point of the ground, and the findings."""
        out = self.compiled(name, self.map, *[word for dem in dems for word in ("--dem", dem)], "--lods", "0.5", "--quiet")
        self.assertEqual(run("inspect", out / "scene.kiln").returncode, 0)
        top = {}  # the map ends in walls that lead down from the ground
        for path in (out / "glb").glob("*_L0.glb"):
            tile = Glb(path)
            nodes = tile.gltf["nodes"]
            for node in nodes:
                if node.get("name") == "ground" and "mesh" in node:
                    for primitive in tile.gltf["meshes"][node["mesh"]]["primitives"]:
                        for x, y, z in tile.values(primitive["attributes"]["POSITION"]):
                            place = path.name, round(x, 2), round(z, 2)
                            top[place] = max(top.get(place, -math.inf), y + nodes[0]["translation"][1])
        return min(top.values()), max(top.values()), report_of(out)["diagnoses"]

    def test_heights_in_feet_are_converted_as_the_file_declares_them(self):
        for name, options, foot_m in (("band", {"unit": "ft"}, 0.3048), ("survey", {"unit": "US survey foot"}, 1200 / 3937),
                                      ("system", {"vertical": 6360}, 1200 / 3937), ("old", {"vertical": 6360, "is_old": True}, 1200 / 3937),
                                      ("feet", {"vertical": 8228}, 0.3048)):
            with self.subTest(name):
                dem = self.written(f"{name}.tif", lambda c, r: 600.0, **options)
                low, high, findings = self.ground(name, dem)
                self.assertAlmostEqual(low, 600 * foot_m, delta=0.02)
                self.assertAlmostEqual(high, 600 * foot_m, delta=0.2)
                self.assertIn("HeightUnit", findings)
        dem = self.folder / "band.tif"
        self.assertAlmostEqual(self.ground("asked", f"{dem},unit=m")[0], 600, delta=0.02)
        self.assertAlmostEqual(self.ground("scaled", f"{dem},scale=0.5")[0], 300, delta=0.02)

    def test_values_that_stand_for_no_height_are_filled_from_the_land_around(self):
        low, high, _ = self.ground("whole", self.written("whole.tif", hill_m))
        for value in NO_HEIGHTS:
            with self.subTest(value):
                dem = self.written("hole.tif", lambda c, r: value if is_hole(c, r) else hill_m(c, r))
                filled = self.ground(f"hole{value}", dem)
                self.assertAlmostEqual(filled[0], low, delta=4)
                self.assertAlmostEqual(filled[1], high, delta=4)
                self.assertTrue({"HeightCode", "VoidFilled"} & set(filled[2]), filled[2])

    def test_values_that_are_mixed_into_the_samples_around_go_too(self):
        def mixed(c, r, value):
            share = sum(is_hole(c + i, r + j) for i in (0, 1) for j in (0, 1)) / 4
            return share * value + (1 - share) * hill_m(c, r)
        low, high, _ = self.ground("whole", self.written("whole.tif", hill_m))
        for value in (-9999, 0, 99999):
            with self.subTest(value):
                filled = self.ground(f"mixed{value}", self.written("mixed.tif", lambda c, r: mixed(c, r, value)))
                self.assertAlmostEqual(filled[0], low, delta=4)
                self.assertAlmostEqual(filled[1], high, delta=4)

    def test_the_sea_and_polders_stay(self):
        def coast(c, r):
            return max(0.0, (c - 40) * 1.5) if c < 60 else 30.0 + 0.2 * (c - 60)
        low, _, findings = self.ground("coast", self.written("coast.tif", coast))
        self.assertAlmostEqual(low, 0, delta=0.1)
        self.assertNotIn("HeightCode", findings)

        def polder(c, r):
            return -4.0 if is_hole(c, r) else 2.0
        low, _, findings = self.ground("polder", self.written("polder.tif", polder))
        self.assertAlmostEqual(low, -4, delta=0.3)
        self.assertNotIn("HeightCode", findings)

    def test_heights_that_are_not_on_earth_are_refused(self):
        dem = self.written("cm.tif", lambda c, r: 100 * hill_m(c, r))
        done = run("compile", self.map, "--dem", dem, "-o", self.folder / "out")
        self.assertEqual(done.returncode, 1)
        for word in ("cm.tif", "-500 to 9000 m", "longitude", "unit="):
            self.assertIn(word, done.stderr)

    def test_a_step_between_two_datums_is_one_finding_and_is_levelled_if_asked(self):
        coarse = self.written("coarse.tif", hill_m)
        fine_rows = [[hill_m(60 + (c - 40) / 5, 60 + (r - 40) / 5) + 46 for c in range(80)] for r in range(80)]
        fine = self.folder / "fine.tif"
        fine.write_bytes(geotiff(fine_rows, LON - 40 * STEP_DEG / 5, LAT + 40 * STEP_DEG / 5, STEP_DEG / 5))
        low, high, _ = self.ground("coarse", coarse)
        _, raised, findings = self.ground("step", fine, coarse)
        self.assertGreater(raised, high + 30)
        self.assertEqual(findings["HeightStep"]["count"], 1)
        self.assertAlmostEqual(findings["HeightStep"]["largest_size"], 46, delta=1)
        levelled = self.ground("levelled", f"{fine},offset=auto", coarse)
        self.assertAlmostEqual(levelled[0], low, delta=1)
        self.assertAlmostEqual(levelled[1], high, delta=1)
        self.assertAlmostEqual(levelled[2]["HeightShifted"]["largest_size"], 46, delta=1)
        alone = run("compile", self.map, "--dem", f"{fine},offset=auto", "-o", self.folder / "alone")
        self.assertEqual(alone.returncode, 1)
        self.assertIn("offset=auto needs another heightmap", alone.stderr)
        both = run("compile", self.map, "--dem", f"{fine},offset=auto", "--dem", f"{coarse},offset=auto", "-o", self.folder / "both")
        self.assertEqual(both.returncode, 1)
        self.assertIn("offset=auto needs another heightmap", both.stderr)

    def test_files_of_one_grid_with_a_step_between_them_are_a_finding(self):
        def cut(name, first, last, by_m):
            rows = [[hill_m(c, r) + by_m for c in range(first, last)] for r in range(SIDE)]
            path = self.folder / name
            path.write_bytes(geotiff(rows, LON + (first - SIDE / 2) * STEP_DEG, LAT + SIDE / 2 * STEP_DEG))
            return path
        west, east = cut("west.tif", 0, 60, 0), cut("east.tif", 60, SIDE, 30)
        findings = self.ground("step", west, east)[2]
        self.assertAlmostEqual(findings["HeightStep"]["largest_size"], 30, delta=2)
        self.assertNotIn("HeightStep", self.ground("none", west, cut("even.tif", 60, SIDE, 0))[2])

    def test_a_name_with_commas_is_a_name(self):
        dem = self.folder / "heights, of 2024,unit=ft.tif"
        shutil.copy(self.written("plain.tif", lambda c, r: 100.0), dem)
        self.assertAlmostEqual(self.ground("commas", dem)[0], 100, delta=0.02)
        self.assertAlmostEqual(self.ground("keys", f"{dem},offset=20,credit=Somebody")[0], 120, delta=0.02)


if __name__ == "__main__":
    unittest.main()
