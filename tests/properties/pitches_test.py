#!/usr/bin/env python3
"""Pitches have lines on the marking atlas, goals and nets by sport; pools have a rim. Tiles that share a field agree."""
import math
import unittest

from citykiln_program import ProgramTest, bytes_of_outputs, report_of, run
from glb import Glb

LON, LAT = 7.42, 43.73
LON_M, LAT_M = 111320 * math.cos(math.radians(LAT)), 111132.0  # metres of a degree there

# name, middle, length, width, turn, tags
AREAS = {
    "soccer": ((60, 60), 105, 68, 20, {"leisure": "pitch", "sport": "soccer"}),
    "tennis": ((-60, 60), 54, 36, 75, {"leisure": "pitch", "sport": "tennis", "surface": "clay"}),
    "basketball": ((-60, -60), 28, 15, 40, {"leisure": "pitch", "sport": "basketball", "surface": "asphalt"}),
    "chess": ((0, -60), 6, 6, 0, {"leisure": "pitch", "sport": "chess"}),
    "pool": ((60, -60), 25, 12, 10, {"leisure": "swimming_pool"}),
}


def map_of(areas, side_m=300):
    nodes, ways = [], []
    for (x, y), length, width, turn, tags in areas:
        cos, sin = math.cos(math.radians(turn)), math.sin(math.radians(turn))
        first = len(nodes) + 1
        for u, v in ((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)):
            u, v = u * length, v * width
            east, north = x + u * cos - v * sin, y + u * sin + v * cos
            nodes.append(f'<node id="{len(nodes) + 1}" version="1" lat="{LAT + north / LAT_M:.7f}" lon="{LON + east / LON_M:.7f}"/>')
        refs = "".join(f'<nd ref="{first + i % 4}"/>' for i in range(5))
        text = "".join(f'<tag k="{key}" v="{value}"/>' for key, value in tags.items())
        ways.append(f'<way id="{len(ways) + 1}" version="1">{refs}{text}</way>')
    half = side_m / 2
    bounds = (f'<bounds minlat="{LAT - half / LAT_M:.7f}" minlon="{LON - half / LON_M:.7f}"'
              f' maxlat="{LAT + half / LAT_M:.7f}" maxlon="{LON + half / LON_M:.7f}"/>')
    return "\n".join(['<osm version="0.6">', bounds, *nodes, *ways, "</osm>"])


class Pitches(ProgramTest):
    def out_of(self, name, *areas, arguments=()):
        path = self.folder / f"{name}.osm"
        path.write_text(map_of([AREAS[area] for area in areas]))
        return self.compiled(name, path, "--lods", "0.1", *arguments)

    def tiles(self, out):
        return [Glb(path) for path in sorted((out / "glb").glob("*_L0.glb"))]

    def instances(self, out, name):
        count = 0
        for tile in self.tiles(out):
            for node in tile.gltf["nodes"]:
                if node.get("name") == name:
                    instancing = node.get("extensions", {}).get("EXT_mesh_gpu_instancing")
                    count += tile.gltf["accessors"][instancing["attributes"]["TRANSLATION"]]["count"] if instancing else 1
        return count

    def has_markings(self, out):
        return any("Marked" in material.get("name", "") for tile in self.tiles(out) for material in tile.gltf["materials"])

    def test_a_sport_has_lines_and_equipment(self):
        for area, thing, count in (("soccer", "soccer_goal", 2), ("tennis", "tennis_net", 3), ("basketball", "basketball_hoop", 2)):
            with self.subTest(area):
                out = self.out_of(area, area, arguments=("--tile", "1024"))
                self.assertTrue(self.has_markings(out))
                self.assertEqual(report_of(out)["counts"]["things"], count)
                self.assertGreater(self.instances(out, thing), 0)
        self.assertFalse(self.has_markings(self.out_of("chess", "chess")))

    def test_tiles_agree_and_checks_hold(self):
        out = self.out_of("all", *AREAS, arguments=("--tile", "128", "--threads", "1"))
        again = self.compiled("again", self.folder / "all.osm", "--lods", "0.1", "--tile", "128", "--threads", "3")
        self.assertEqual(bytes_of_outputs(out), bytes_of_outputs(again))
        done = run("check", out)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        baked = self.folder / "baked"
        done = run("bake", out / "scene.kiln", "--lods", "0.1", "-o", baked)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(bytes_of_outputs(out), bytes_of_outputs(baked))

    def test_covered_pools_are_left_out(self):
        whole = self.out_of("pool", "pool")
        self.assertTrue(any("PoolWater" in m.get("name", "") for tile in self.tiles(whole) for m in tile.gltf["materials"]))
        AREAS["covered"] = (*AREAS["pool"][:4], {**AREAS["pool"][4], "covered": "yes"})
        path = self.folder / "covered.osm"
        path.write_text(map_of([AREAS["covered"], AREAS["chess"]]))
        out = self.compiled("covered", path, "--lods", "0.1")
        self.assertFalse(any("PoolWater" in m.get("name", "") for tile in self.tiles(out) for m in tile.gltf["materials"]))


if __name__ == "__main__":
    unittest.main()
