#!/usr/bin/env python3
"""Yards that are assumed: in any order of the map, in regions and by bake the same bytes, none with --assume none."""
import json
import math
import random
import struct
import unittest
from pathlib import Path

from citykiln_program import IS_FULL, ProgramTest, bytes_of_outputs, report_of, run
from regions_real_test import compiled_apart
from shuffled import shuffle

LON, LAT = 10.0, 50.0
LON_M, LAT_M = 71695.7, 111229.0  # metres of a degree there


def made_map(seed):
    """Three streets with a cross street, houses of random sizes with garages, hedges, driveways and gardens beside some."""
    draw = random.Random(seed)
    nodes, ways = [], []

    def node(x, y):
        nodes.append((LON + x / LON_M, LAT + y / LAT_M))
        return len(nodes)

    def way(places, **tags):
        ways.append(([place if isinstance(place, int) else node(*place) for place in places], tags))

    def area(x, y, width, depth, **tags):
        corner = node(x, y)
        way([corner, (x + width, y), (x + width, y + depth), (x, y + depth), corner], **tags)

    crossings = [node(0, y) for y in (-120, 0, 120)]
    way(crossings, highway="residential")
    for crossing, y in zip(crossings, (-120, 0, 120)):
        way([(-400, y), crossing, (400, y)], highway="residential")
        x = -380
        while x < 370:
            width, back = draw.uniform(8, 16), draw.uniform(3, 14)
            for side in (1, -1):
                if abs(x + width / 2) < 25:
                    continue
                depth = draw.uniform(8, 12)
                low = y + side * (5 + back) - (depth if side < 0 else 0)
                area(x, low, width, depth, building="house")
                if draw.random() < 0.3:
                    area(x + width + 1, low + side * 4, 3.5, 6, building="garage")
                if draw.random() < 0.2:
                    way([(x - 1, y + side * 5.5), (x + width, y + side * 5.5)], barrier="hedge")
                if draw.random() < 0.2:
                    way([(x + width + 3, y), (x + width + 3, y + side * 16)], highway="service", service="driveway")
                if draw.random() < 0.1:
                    area(x, y + side * 32 - 4, 10, 8, leisure="garden")
            x += width + draw.uniform(0, 12)
    area(-420, -220, 840, 440, landuse="residential")
    box = (LON - 400 / LON_M, LAT - 200 / LAT_M, LON + 400 / LON_M, LAT + 200 / LAT_M)
    lines = ['<osm version="0.6"><bounds minlon="{:.7f}" minlat="{:.7f}" maxlon="{:.7f}" maxlat="{:.7f}"/>'.format(*box)]
    lines += [f'<node id="{i + 1}" version="1" lon="{lon:.7f}" lat="{lat:.7f}"/>' for i, (lon, lat) in enumerate(nodes)]
    for i, (refs, tags) in enumerate(ways):
        inner = "".join(f'<nd ref="{ref}"/>' for ref in refs) + "".join(f'<tag k="{k}" v="{v}"/>' for k, v in tags.items())
        lines.append(f'<way id="{i + 1}" version="1">{inner}</way>')
    return "\n".join([*lines, "</osm>"])


def short_ways(seed, blocks):
    """Blocks of 150 m with houses beside ways of a few metres of any class, some of which end in turning circles."""
    draw = random.Random(seed)
    nodes, ways, tags_of = [], [], {}
    classes = ["footway", "cycleway", "track", "service", "service", "residential", "living_street", "tertiary", "secondary"]

    def node(x, y):
        nodes.append((LON + x / LON_M, LAT + y / LAT_M))
        return len(nodes)

    def block(left, low):
        corners = [node(left + x, low + y) for x, y in ((3, 3), (147, 3), (147, 147), (3, 147))]
        ways.append(([*corners, corners[0]], {"landuse": "residential"}))
        ends = [(left + 75, low + 75, 0, node(left + 75, low + 75))]
        for _ in range(draw.randint(2, 5)):
            x, y, _, first = draw.choice(ends)
            refs, turn, parts = [first], draw.uniform(0, 2 * math.pi), draw.randint(1, 3)
            length = draw.choice([draw.uniform(2, 15), draw.uniform(10, 40)]) / parts
            for _ in range(parts):
                turn += draw.uniform(-0.5, 0.5)
                x = min(max(x + length * math.cos(turn), left + 10), left + 140)
                y = min(max(y + length * math.sin(turn), low + 10), low + 140)
                refs.append(node(x, y))
                ends.append((x, y, turn, refs[-1]))
            if draw.random() < 0.3:
                tags_of[refs[-1]] = draw.choice(["turning_circle", "turning_loop", "mini_roundabout"])
            ways.append((refs, {"highway": draw.choice(classes)}))
        for _ in range(4):
            x, y, turn, _ = draw.choice(ends[1:])
            away, side = draw.uniform(9, 22), draw.choice((-1, 1))
            middle = x - side * away * math.sin(turn), y + side * away * math.cos(turn)
            width, depth = draw.uniform(3, 6), draw.uniform(3, 5)
            corners = [node(middle[0] + u * width * math.cos(turn) - v * depth * math.sin(turn),
                            middle[1] + u * width * math.sin(turn) + v * depth * math.cos(turn))
                       for u, v in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
            ways.append(([*corners, corners[0]], {"building": "house"}))

    for column in range(blocks):
        for row in range(blocks):
            block(column * 150, row * 150)
    lines = ['<osm version="0.6">']
    for i, (lon, lat) in enumerate(nodes, 1):
        tag = f'<tag k="highway" v="{tags_of[i]}"/>' if i in tags_of else ""
        lines.append(f'<node id="{i}" version="1" lon="{lon:.7f}" lat="{lat:.7f}">{tag}</node>')
    for i, (refs, tags) in enumerate(ways, 1):
        inner = "".join(f'<nd ref="{ref}"/>' for ref in refs) + "".join(f'<tag k="{k}" v="{v}"/>' for k, v in tags.items())
        lines.append(f'<way id="{i}" version="1">{inner}</way>')
    return "\n".join([*lines, "</osm>"])


def node_names(path):
    """The names of the nodes of a .glb."""
    data = path.read_bytes()
    length, = struct.unpack_from("<I", data, 12)
    return [node.get("name", "") for node in json.loads(data[20:20 + length])["nodes"]]


class Yards(ProgramTest):
    def map_path(self, seed=1):
        path = self.folder / f"map{seed}.osm"
        path.write_text(made_map(seed))
        return path

    def suburb(self):
        """The made map in two levels, compiled once for all tests."""
        path = Path(self.shared_scratch.name) / "map.osm"
        path.write_text(made_map(1))
        return self.compiled_once(path, "--lods", "0.1,2.5")

    def test_any_order_has_the_same_bytes(self):
        for seed in range(2 if IS_FULL else 1):
            path, other = self.map_path(seed), self.folder / f"shuffled{seed}" / f"map{seed}.osm"
            other.parent.mkdir()
            shuffle(path, other, seed)
            runs = [self.compiled(f"{seed}{name}", source, "--lods", "0.1,2.5", "--tile", "256", "--threads", threads)
                    for name, source, threads in (("one", path, 1), ("other", other, 3))]
            self.assertEqual(*map(bytes_of_outputs, runs))
            self.assertGreater(report_of(runs[0])["assumed"]["yards"], 80)

    def test_regions_have_the_bytes_of_one_run(self):
        arguments = ["--lods", "0.1", "--tile", "256"]
        path = self.map_path()
        whole = self.compiled("whole", path, *arguments)
        apart = compiled_apart(self.folder / "apart", [path], arguments, "512") / "out"
        tiles = {name: data for name, data in bytes_of_outputs(apart).items() if name.endswith(".glb")}
        self.assertEqual(tiles, {name: data for name, data in bytes_of_outputs(whole).items() if name.endswith(".glb")})
        self.assertEqual(report_of(apart)["assumed"], report_of(whole)["assumed"])

    def test_check_and_bake_agree(self):
        out, baked = self.suburb(), self.folder / "baked"
        self.assertEqual(run("bake", out / "scene.kiln", "--lods", "0.1,2.5", "-o", baked).returncode, 0)
        self.assertEqual(bytes_of_outputs(out), bytes_of_outputs(baked))
        row = next(line for line in run("check", out).stdout.splitlines() if "no tree of an assumed yard" in line)
        self.assertTrue(row.startswith("holds"), row)
        self.assertNotIn("by 0 tests", row)

    def test_no_tree_of_a_yard_stands_in_a_short_way_or_its_turning_circle(self):
        # 600 lots, or 10,000
        for seed in range(4 if IS_FULL else 1):
            path = self.folder / f"short{seed}.osm"
            path.write_text(short_ways(seed, 25 if IS_FULL else 12))
            out = self.compiled(f"short{seed}", path, "--lods", "12.5")
            checked = run("check", out).stdout
            row = next(line for line in checked.splitlines() if "no tree of an assumed yard" in line)
            self.assertTrue(row.startswith("holds"), row)

    def test_they_are_switched(self):
        plants = {}
        for assumed in ("none", "yards"):
            out = self.compiled(assumed, self.map_path(), "--emit", "kiln", "--assume", assumed)
            plants[assumed] = report_of(out)["ledger"].get("plants/tree", {}).get("in", 0)
            self.assertEqual(report_of(out)["assumed"].get("yards", 0) > 0, assumed == "yards")
        self.assertEqual(plants["none"], 0)
        self.assertGreater(plants["yards"], 100)

    def test_shrubs_are_left_out_where_the_tolerance_allows_it(self):
        out = self.suburb()
        fine, coarse = ([name for path in sorted((out / "glb").glob(f"*_L{level}.glb")) for name in node_names(path)]
                        for level in (0, 1))
        shrubs = [sum("bush" in name for name in names) for names in (fine, coarse)]
        # some species of trees are as low as a bush and higher than the limit
        self.assertGreater(shrubs[0], 50)
        self.assertLess(shrubs[1], shrubs[0] / 4)
        self.assertGreater(sum("_" in name for name in coarse), 20, "trees are left")

    def test_lots_are_filled(self):
        houses = {}
        for fill in ("none", "lots"):
            out = self.compiled(fill, self.map_path(), "--lods", "2.5", "--fill", fill)
            houses[fill] = report_of(out)["assumed"]["houses"]
            self.assertEqual(run("check", out).returncode, 0)
        self.assertEqual(houses["none"], 0)
        self.assertGreater(houses["lots"], 10)
        row = next(line for line in run("check", out).stdout.splitlines() if "no house that fills a lot" in line)
        self.assertTrue(row.startswith("holds"), row)
        self.assertNotIn("by 0 tests", row)

    def test_streets_of_filled_lots_have_pavements_as_those_of_mapped_houses(self):
        places = ((9.9972, 50), (10.0028, 50), (9.9972, 49.999), (10.0028, 49.999), (10.0028, 50.001), (9.9972, 50.001))
        text = '<osm version="0.6"><bounds minlat="49.998" minlon="9.997" maxlat="50.002" maxlon="10.003"/>'
        text += "".join(f'<node id="{i}" lon="{lon}" lat="{lat}"/>' for i, (lon, lat) in enumerate(places, 1))
        text += '<way id="1"><nd ref="1"/><nd ref="2"/><tag k="highway" v="residential"/></way>'
        text += '<way id="2"><nd ref="3"/><nd ref="4"/><nd ref="5"/><nd ref="6"/><nd ref="3"/><tag k="landuse" v="residential"/></way>'
        path = self.folder / "street.osm"
        path.write_text(text + "</osm>")
        pavements = {fill: report_of(self.compiled(fill, path, "--emit", "kiln", "--fill", fill))["assumed"]["pavements"]
                     for fill in ("none", "lots")}
        self.assertEqual(pavements, {"none": 0, "lots": 1})

    def test_own_rules_of_houses_replace_the_shipped_ones(self):
        rules = self.folder / "rules" / "lots"
        rules.mkdir(parents=True)
        for name in ("detached", "terrace", "flats", "courtyard"):
            (rules / f"{name}.cga").write_text("Lot --> extrude(21) Flats.")
        out = self.compiled("own", self.map_path(), "--emit", "kiln", "--fill", "lots", "--rules", self.folder / "rules")
        layer = self.folder / "buildings.geojson"
        self.assertEqual(run("inspect", out, "--layer", "buildings", "--geojson", layer).returncode, 0)
        heights = [f["properties"] for f in json.loads(layer.read_text())["features"]]
        self.assertGreater(sum(h["height_m"] >= 21 for h in heights), 5, heights[:1])


if __name__ == "__main__":
    unittest.main()
