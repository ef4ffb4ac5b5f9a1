#!/usr/bin/env python3
"""Bad heights, through the whole program: an invented valley with the common errors of maps and heightmaps. Each error is diagnosed
with its way, and the ground stays near the true land."""
import json
import math
import unittest

from citykiln_program import ProgramTest, report_of, run
from glb import Glb

LON, LAT = 10.0, 48.0
METRES_PER_DEGREE = 111_200.0
EAST_M, NORTH_M = 700, 500  # half the map
STEP_DEG = 1 / 3600
VOID = -9999
# The largest cut or fill allowed; 4.0 m is reached. Errors of the heightmap are up to 200 m.
MAX_CUT_OR_FILL_M = 8


def land_m(x, y):
    """The true height: a valley that falls to the west, a hill in the north-west, flat land in the north-east."""
    away = 1 - math.exp(-(y / 70) ** 2)
    hill = 110 * math.exp(-((x + 350) ** 2 + (y - 230) ** 2) / (2 * 70 ** 2))
    waves = 6 * math.sin(x / 120) * math.cos(y / 90) * away * max(0, min(1, (150 - y) / 100))
    return 420 + 0.018 * x + 14 * away + hill + waves


def lonlat(x, y):
    return LON + x / (METRES_PER_DEGREE * math.cos(math.radians(LAT))), LAT + y / METRES_PER_DEGREE


class Map:
    """An OSM map; ways are given by places in metres, and equal places become one node."""

    def __init__(self):
        self.nodes, self.ways = {}, []

    def way(self, number, tags, *places):
        refs = [self.nodes.setdefault(place, len(self.nodes) + 1) for place in places]
        self.ways.append((number, tags, refs))

    def text(self):
        nodes = [f'<node id="{n}" version="1" lat="{lonlat(*p)[1]:.7f}" lon="{lonlat(*p)[0]:.7f}"/>' for p, n in self.nodes.items()]
        ways = [f'<way id="{number}" version="1">' + "".join(f'<nd ref="{r}"/>' for r in refs) +
                "".join(f'<tag k="{k}" v="{v}"/>' for k, v in tags.items()) + "</way>" for number, tags, refs in self.ways]
        return "\n".join(['<osm version="0.6">', *nodes, *ways, "</osm>"])


RIVER, BRIDGE, LAYERED, TUNNEL, LAKE = 1, 2, 3, 4, 5


def bad_map():
    bad = Map()
    # a river drawn against its flow
    bad.way(RIVER, {"waterway": "river", "width": "8"}, *[(x, 0) for x in range(-690, 691, 60)])
    # a street along the valley, over spikes and voids
    bad.way(11, {"highway": "secondary"}, *[(x, -200) for x in range(-690, 691, 60)])
    # a bridge without a layer
    bad.way(12, {"highway": "tertiary"}, (30, -200), (30, -40))
    bad.way(BRIDGE, {"highway": "tertiary", "bridge": "yes"}, (30, -40), (30, 40))
    bad.way(13, {"highway": "tertiary"}, (30, 40), (30, 400))
    # a way on layer 1 without a bridge, across the street and the river, without common nodes
    bad.way(LAYERED, {"highway": "residential", "layer": "1"}, (325, -350), (325, 150))
    # a tunnel in flat land, under a street
    bad.way(14, {"highway": "tertiary"}, (30, 300), (150, 300))
    bad.way(TUNNEL, {"highway": "tertiary", "tunnel": "yes", "layer": "-1"}, (150, 300), (350, 300))
    bad.way(15, {"highway": "tertiary"}, (350, 300), (650, 300))
    bad.way(16, {"highway": "residential"}, (250, 220), (250, 400))
    # a lake with one node on the hill
    shore = [(-560 + round(30 * math.cos(i / 16 * math.tau), 2), 230 + round(30 * math.sin(i / 16 * math.tau), 2)) for i in range(16)]
    bad.way(LAKE, {"natural": "water"}, (-350, 230), *shore[1:], (-350, 230))
    return bad.text()


def bad_heights():
    """An ESRI ASCII grid of the land, samples of 31 by 21 m, with voids and with spikes up and down, of one sample and of four, under the
    street, the river and the lake."""
    columns, rows = 100, 60
    west, south = LON - columns / 2 * STEP_DEG, LAT - rows / 2 * STEP_DEG
    metres = (METRES_PER_DEGREE * math.cos(math.radians(LAT)), METRES_PER_DEGREE)

    def place(c, r):
        return ((c + 0.5 - columns / 2) * STEP_DEG * metres[0], (rows / 2 - r - 0.5) * STEP_DEG * metres[1])

    heights = [[round(land_m(*place(c, r)), 1) for c in range(columns)] for r in range(rows)]

    def nearest(x, y):
        return (round(x / metres[0] / STEP_DEG + columns / 2 - 0.5), round(rows / 2 - 0.5 - y / metres[1] / STEP_DEG))

    for x, y, size, by_m in [(-400, -200, 1, 150), (-200, -200, 1, -200), (200, -200, 2, 120), (0, 0, 1, 90), (420, -190, 2, -180),
                             (325, 0, 1, 140), (-560, 230, 1, 100), (250, 300, 1, 80)]:
        column, row = nearest(x, y)
        for r in range(row, row + size):
            for c in range(column, column + size):
                heights[r][c] += by_m
    for x, y, size in [(-100, -200, 4), (500, 0, 5), (600, -200, 3)]:
        column, row = nearest(x, y)
        for r in range(row, row + size):
            for c in range(column, column + size):
                heights[r][c] = VOID
    head = f"ncols {columns}\nnrows {rows}\nxllcorner {west}\nyllcorner {south}\ncellsize {STEP_DEG!r}\nNODATA_value {VOID}\n"
    return head + "\n".join(" ".join(f"{h:.1f}" for h in row) for row in heights) + "\n"


SPIKES = 5 * 1 + 1 + 2 * 4  # samples


def vertices_of(path):
    """Plane coordinates and OSM id of every vertex of the tile's own meshes, one a layer."""
    tile = Glb(path)
    nodes, ids = tile.gltf["nodes"], tile.osm_ids()
    east, up, minus_north = nodes[0]["translation"]
    layers = [nodes[child] for child in nodes[0]["children"]]
    for primitive in [p for layer in layers if "mesh" in layer for p in tile.gltf["meshes"][layer["mesh"]]["primitives"]]:
        features = tile.values(primitive["attributes"]["_FEATURE_ID_0"])
        for (x, y, z), (feature,) in zip(tile.values(primitive["attributes"]["POSITION"]), features, strict=True):
            yield (x + east, -(z + minus_north), y + up), ids[int(feature)] if feature < len(ids) else None


class BadHeights(ProgramTest):
    def setUp(self):
        super().setUp()
        self.map, self.dem = self.folder / "bad.osm", self.folder / "bad.asc"
        self.map.write_text(bad_map())
        self.dem.write_text(bad_heights())
        west, south = lonlat(-EAST_M, -NORTH_M)
        east, north = lonlat(EAST_M, NORTH_M)
        self.arguments = [self.map, "--dem", self.dem, "--origin", f"{LON},{LAT}", "--bbox", f"{west:.6f},{south:.6f},{east:.6f},{north:.6f}"]

    def test_each_is_diagnosed_with_its_way_and_the_ground_stays_near_the_land(self):
        out = self.compiled("out", *self.arguments, "--lods", "0.1,2.5")
        diagnoses = report_of(out)["diagnoses"]
        diagnosed = {code: tally["objects"] for code, tally in diagnoses.items()}
        for code, way in {"WaterwayReversed": RIVER, "BridgeWithoutLayer": BRIDGE, "LayerWithoutBridge": LAYERED, "TunnelLowered": TUNNEL,
                          "ShoreSpike": LAKE}.items():
            self.assertIn(f"w{way}", diagnosed.get(code, []), f"{code}: {json.dumps(diagnoses, indent=1)}")
        self.assertEqual(diagnoses["HeightSpike"]["count"], SPIKES)
        self.assertGreater(diagnoses["HeightSpike"]["largest_size"], 150)
        self.assertIn("VoidFilled", diagnoses)

        vertices, worst = 0, (0, None)
        for path in sorted((out / "glb").glob("*_L0.glb")):
            for (x, y, z), way in vertices_of(path):
                vertices += 1
                self.assertTrue(math.isfinite(x + y + z))
                if way not in (BRIDGE, TUNNEL) and abs(x) < EAST_M and abs(y) < NORTH_M:
                    worst = max(worst, (abs(z - land_m(x, y)), (x, y, z, way)))
        self.assertGreater(vertices, 1000)
        self.assertLess(worst[0], MAX_CUT_OR_FILL_M, worst)
        done = run("check", out)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_strict_fails(self):
        done = run("compile", *self.arguments, "--lods", "2.5", "--strict", "-o", self.folder / "strict")
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)


if __name__ == "__main__":
    unittest.main()
