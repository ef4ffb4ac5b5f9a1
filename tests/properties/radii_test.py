#!/usr/bin/env python3
"""Each stage reaches no farther than the table of compiler/regions/radii.h states: a thing just beyond the radius changes nothing in a tile, a
near one does."""
import itertools
import math
import re
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "exporters" / "kiln"))

from citykiln_program import ROOT, ProgramTest
from manifest_page_test import Manifest

LON, LAT = 10.0, 50.0
LON_M, LAT_M = 71695.7, 111229.0  # metres of a degree there
SIDE_M, TILE_M = 12000, 256
TABLE = (ROOT / "compiler" / "regions" / "radii.h").read_text()
# what reaches no farther than a chunk holds, and is compared with the table only
WITHIN_CHUNK = {"ends of these paths", "woods", "plants' obstacles", "pieces of roads"}
# unit tests: FitAssumedWidths.WaysBeyondTheRadiusStay, ProfileKnots.DependOnNoHeightsBeyondAStretch,
# AssumePavements.ALongWayIsCutAndItsEndDoesNotChangeItsBeginning, AssumeBridgePavements.TaggedAndLongBridgesStayAsTheyAre,
# AssumedHeights.AreEqualInAShortRow, AssumedFronts.AreNotNearMappedShops, AssumeVerges.WhatLiesBeyondTheRadiusChangesNothing, AssumeFrontages.WhatLiesBeyondTheRadiusChangesNothing,
# AssumeSurfaces.LandBeyondTheRadiusChangesNothing, Railings.DependOnNothingBeyondTheRadius,
# ContactMasts.DependOnNothingBeyondTheRadius, CurvedTracks.WhatLiesBeyondTheRadiusChangesNothing, RandomLand.ALotDependsOnWhatIsWithinTheRadius (yards and houses of lots;
# yards also by yards_test, in regions), CorrectedLand.DependsOnWhatIsNear, Airports.LeaveOtherLandAsItIs,
# DivideLand.FieldsDoNotDependOnLandFarAway
UNIT_TESTED = {"closed frontages", "assumed yards", "houses of filled lots", "assumed widths", "knots of profiles", "transitions of lanes", "assumed pavements", "pavements on bridges", "assumed roofs", "assumed fronts", "assumed railings", "assumed contact lines", "verges, parking", "assumed surfaces", "curved axes", "corrected land", "airports", "assumed fields"}
# smoothed afterwards, so that they reach farther by the radius of profiles; the halo of a region is the sum
SMOOTHED = {"bridges and tunnels"}
# sums of the farthest that each of several steps reaches: no one thing was found that all of them carry on
SUMS = {"profiles", "storeys of bridges"}


def radii():
    """Metres by stage, from the table."""
    rows = re.findall(r"^// \| ([^|]+?) +\| ([\w:]+) +\| +(\d+) \|", TABLE, re.MULTILINE)
    return {stage: int(metres) for stage, _, metres in rows}


def beyond(stage):
    """A distance at which nothing may change."""
    return 1.02 * radii()[stage] + 2 + (radii()["profiles"] if stage in SMOOTHED else 0)


class Map:
    """A map around a tile whose south-west corner is at 0, 0; places in metres."""

    def __init__(self):
        self.nodes, self.ways, self.known = [], [], {}

    def node(self, x, y, **tags):
        if not tags and (x, y) in self.known:
            return self.known[x, y]
        self.nodes.append((LON + x / LON_M, LAT + y / LAT_M, tags))
        self.known.setdefault((x, y), len(self.nodes))
        return len(self.nodes)

    def way(self, places, **tags):
        self.ways.append(([self.node(*place) for place in places], tags))

    def area(self, x0, y0, x1, y1, **tags):
        self.way([(x0, y0), (x1, y0), (x1, y1), (x0, y1), (x0, y0)], **tags)

    def text(self):
        def tagged(tags):
            return "".join(f'<tag k="{key.replace("__", ":")}" v="{value}"/>' for key, value in tags.items())
        def refs(nodes):
            return "".join(f"<nd ref='{n}'/>" for n in nodes)

        half = [SIDE_M / LON_M, SIDE_M / LAT_M]
        lines = [f'<osm version="0.6"><bounds minlon="{LON - half[0]:.7f}" minlat="{LAT - half[1]:.7f}" maxlon="{LON + half[0]:.7f}" maxlat="{LAT + half[1]:.7f}"/>']
        lines += [f'<node id="{i + 1}" version="1" lon="{lon:.7f}" lat="{lat:.7f}">{tagged(tags)}</node>' for i, (lon, lat, tags) in enumerate(self.nodes)]
        lines += [f'<way id="{i + 1}" version="1">{refs(nodes)}{tagged(tags)}</way>' for i, (nodes, tags) in enumerate(self.ways)]
        return "\n".join([*lines, "</osm>"])


def base():
    made = Map()
    made.area(20, 20, 60, 60, landuse="meadow")
    return made


# Each makes a map with its thing at a distance west of the tile, or without it (None).
def land_cover(distance):
    made = base()
    if distance is not None:
        made.area(-distance - 10, 100, -distance, 150, landuse="farmland")
    return made


def road(distance):
    made = base()
    if distance is not None:
        made.way([(-distance, 40), (-distance, 220)], highway="residential", lanes=1, width=3)
    return made


def second_junction(distance):
    made = base()
    made.way([(-300, 128), (120, 128), (250, 128)], highway="residential")
    made.way([(120, 128), (120, 240)], highway="residential")
    if distance is not None:
        made.ways[-2][0].insert(1, made.node(120 - distance, 128))
        made.way([(120 - distance, 128), (120 - distance, 20)], highway="residential")
    return made


def river(distance):
    made = base()
    far = 4000 if distance is None else distance
    made.area(-far - 50, -900, 240, 1100, natural="water", water="river")
    made.way([(-far, 1000), (-far, -800)], waterway="river")
    return made


def tunnel(distance):
    made = base()
    far = 10000 if distance is None else distance
    made.way([(300, 128), (-far, 128)], railway="rail", tunnel="yes", layer=-1)
    made.way([(400, 128), (300, 128)], railway="rail")
    made.way([(-far, 128), (-far - 400, 128)], railway="rail")
    return made


def railway_bridge(distance):
    made = base()
    far = 9000 if distance is None else distance
    made.way([(-11000, 128), (-far - 20, 128)], railway="rail")
    made.way([(-far - 20, 128), (-far + 20, 128)], railway="rail", bridge="yes", layer=1)
    made.way([(-far + 20, 128), (600, 128)], railway="rail")
    made.way([(-far, -200), (-far, 400)], highway="residential")
    return made


def path_below_a_bridge(distance):
    made = base()
    far = 3000 if distance is None else distance
    made.way([(-far - 20, 128), (60, 128)], highway="footway")
    if distance is not None:
        made.way([(-far, 100), (-far, 156)], highway="residential", bridge="yes", layer=1)
    return made


def long_road(_):
    made = base()
    made.way([(-11000, 128), (600, 128)], highway="motorway", oneway="yes")
    return made


def step_at(distance, height_m):
    """Heights of a plain with a step, east of which they are 0."""
    return lambda x: height_m if x < -distance else 0


def heights_of(line):
    """Heights of a road or span every 16 m along it within the tile, to 2 cm: knots may lie 1 cm off."""
    points, start, profile = line[1], line[3], line[5]
    knots, at = [], 0
    for steps, height, _ in profile:
        at += steps
        knots.append((at, height))
    heights, along = [], start
    for (x0, y0), (x1, y1) in itertools.pairwise(points):
        length = math.dist((x0, y0), (x1, y1))
        for step in range(0, int(length), 16):
            if 0 <= x0 + (x1 - x0) * step / length <= TILE_M:
                heights.append(height_at(knots, along + step))
        along += length
    return Heights(heights)


def height_at(knots, at):
    if not knots:
        return 0
    for (a, low), (b, high) in itertools.pairwise(knots):
        if a <= at <= b:
            return low + (high - low) * (at - a) / (b - a)
    return knots[0][1] if at < knots[0][0] else knots[-1][1]


class Heights(list):
    def __eq__(self, other):
        return len(self) == len(other) and all(abs(a - b) <= 0.02 for a, b in zip(self, other, strict=True))

    def __ne__(self, other):
        return not self == other


def tagged_neighbours(distance):
    made = base()
    made.area(20, 70, 32, 82, building="yes")
    if distance is not None:
        for i in range(4):
            made.area(26 - distance, 70 + 20 * i, 38 - distance, 82 + 20 * i, building="yes", building__levels=9)
    return made


def power_line(distance):
    made = base()
    if distance is not None:
        made.node(-distance, 40, power="tower")
        made.node(distance + 10, 40, power="tower")
        made.ways.append(([len(made.nodes) - 1, len(made.nodes)], {"power": "line"}))
    return made


# the map, its heights, what is looked at in the tile, and a distance from which the thing is seen
CASES = {
    "chunk of a tile": (land_cover, None, lambda chunk: chunk.surfaces, 24),
    "roads of a chunk": (road, None, lambda chunk: chunk.roads, 28),
    "junctions": (second_junction, None, lambda chunk: [j for j in chunk.junctions if any(abs(x - 120) < 0.1 for x, _ in j[1])], 12),
    "running water": (river, lambda _: lambda x: x / 100, lambda chunk: [water[1:] for water in chunk.waters], 504),
    "assumed storeys": (tagged_neighbours, None, lambda chunk: [b[3:6] for b in chunk.buildings if b[5] < 200], 120),
    "profiles": (long_road, lambda distance: step_at(distance, 200), lambda chunk: [heights_of(road) for road in chunk.roads], 600),
    "bridges and tunnels": (tunnel, lambda distance: step_at(distance - 30, -60), lambda chunk: [heights_of(span) for span in chunk.tunnels], 2048),
    "paths to a bridge": (path_below_a_bridge, None, lambda chunk: [road[5] for road in chunk.roads], 1500),
    "wires": (power_line, None, lambda chunk: chunk.wire_spans, 300),
    "storeys of bridges": (railway_bridge, None, lambda chunk: [heights_of(road) for road in chunk.roads], 200),
}


class Radii(ProgramTest):
    without = {}

    def seen_without(self, stage):
        """Returns what is seen in a tile whose map lacks the thing. It is computed once for both claims."""
        if stage not in self.without:
            self.without[stage] = self.seen(stage, None)
        return self.without[stage]

    def seen(self, stage, distance):
        make, heights_at, view, _ = CASES[stage]
        path = self.folder / "map.osm"
        path.write_text(make(distance).text())
        dem = []
        if heights_at:
            dem = ["--dem", self.folder / "heights.asc"]
            self.write_heights(dem[1], heights_at(20000 if distance is None else distance))
        out = self.compiled(f"out{len(list(self.folder.iterdir()))}", path, *dem, "--emit", "kiln", "--tile", TILE_M, "--only", "0_0",
                            "--assume", "heights" if stage == "assumed storeys" else "none")
        return view(Manifest((out / "scene.kiln").read_bytes()).chunks[0, 0])

    @staticmethod
    def write_heights(path, height_at):
        step, count = 0.0005, 720
        west, south = LON - step * count / 2, LAT - step * count / 2
        row = " ".join(f"{height_at((west + step * i - LON) * LON_M):.2f}" for i in range(count))
        path.write_text(f"ncols {count}\nnrows {count}\nxllcenter {west}\nyllcenter {south}\ncellsize {step}\nNODATA_value -9999\n" + (row + "\n") * count)

    def test_every_stage_of_the_table_has_a_case(self):
        self.assertEqual(set(radii()), set(CASES) | WITHIN_CHUNK | UNIT_TESTED)
        for stage in WITHIN_CHUNK:
            self.assertLessEqual(radii()[stage], radii()["chunk of a tile"])

    def test_what_lies_beyond_the_radius_changes_nothing(self):
        for stage in CASES:
            with self.subTest(stage=stage):
                self.assertEqual(self.seen(stage, beyond(stage)), self.seen_without(stage))

    def test_a_line_is_in_no_tile_that_only_its_box_touches(self):
        made = base()
        made.way([(-400, -300), (-400, 600), (600, 600)], power="line")
        (self.folder / "bent.osm").write_text(made.text())
        out = self.compiled("bent", self.folder / "bent.osm", "--emit", "kiln", "--tile", TILE_M, "--only", "0_0,-2_0")
        chunks = Manifest((out / "scene.kiln").read_bytes()).chunks
        self.assertEqual([len(chunks[tile].corridors) for tile in ((0, 0), (-2, 0))], [0, 1])

    def test_what_is_near_changes_something(self):
        for stage, (*_, near) in CASES.items():
            with self.subTest(stage=stage):
                if stage not in SUMS:  # half the radius would be too little
                    self.assertLessEqual(radii()[stage] / 2, near)
                self.assertLess(near, radii()[stage])
                self.assertNotEqual(self.seen(stage, near), self.seen_without(stage))


if __name__ == "__main__":
    unittest.main()
