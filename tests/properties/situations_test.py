#!/usr/bin/env python3
"""Situations that maps are full of, turned, mirrored and on the borders of tiles and regions: ways through buildings, roofs on
posts, parts, crossed rings, what is gone or underground, walls that hold the ground, piers. The triangles of the tiles show
that each is as its tags say.

By hand: situations_test.py --count 20
"""
import json
import math
import random
import struct
import sys
import unittest
import zlib

from citykiln_program import IS_FULL, ProgramTest, bytes_of_outputs, report_of, run
from glb import Glb
from mutated_maps import map_xml

LAT, LON, LAT_M, LON_M = 47.0, 9.0, 111170.8, 76056.0  # metres of a degree there
SPACING_M, SIDE = 110, 6
COUNT = 20 if IS_FULL else 2
LEVELS = "0.1,2.5"


class Frame:
    """The place of a situation: its own coordinates, in metres, turned, perhaps mirrored, and moved on the map."""

    def __init__(self, x, y, turn, is_mirrored):
        self.x, self.y, self.c, self.s, self.m = x, y, math.cos(turn), math.sin(turn), -1 if is_mirrored else 1

    def on_map(self, x, y):
        x *= self.m
        return self.x + self.c * x - self.s * y, self.y + self.s * x + self.c * y

    def own(self, x, y):
        x, y = x - self.x, y - self.y
        return self.m * (self.c * x + self.s * y), -self.s * x + self.c * y


class Map:
    """Nodes, ways and relations in the order they are made; ids count from 1."""

    def __init__(self):
        self.nodes, self.ways, self.relations = [], [], []
        self.node_at = {}

    def way(self, frame, points, tags, closed=False):
        refs = []
        for x, y in points:
            east, north = frame.on_map(x, y)
            self.nodes.append((len(self.nodes) + 1, LAT + north / LAT_M, LON + east / LON_M, {}))
            refs.append(len(self.nodes))
        number = 1 + max((way for way, _, _ in self.ways), default=0)
        self.ways.append((number, refs + refs[:1] if closed else refs, tags))
        return number

    def joined(self, frame, points, tags, closed=False):
        """A way whose nodes other joined ways of the frame share."""
        way = self.way(frame, points, tags, closed)
        refs = [self.node_at.setdefault((frame, *point), ref) for point, ref in zip(points, self.ways[-1][1])]
        self.ways[-1] = (way, refs + refs[:1] if closed else refs, tags)
        used = {ref for _, nodes, _ in self.ways for ref in nodes}
        while self.nodes[-1][0] not in used:
            self.nodes.pop()
        return way

    def box(self, frame, x0, y0, x1, y1, tags):
        return self.way(frame, [(x0, y0), (x1, y0), (x1, y1), (x0, y1)], tags, closed=True)


def clipped(triangle, low, high):
    """The part of a triangle inside a box of space, as a polygon."""
    polygon = list(triangle)
    for axis in range(3):
        for sign, bound in ((1, low[axis]), (-1, -high[axis])):
            kept = []
            for a, b in zip(polygon, polygon[1:] + polygon[:1]):
                da, db = sign * a[axis] - bound, sign * b[axis] - bound
                if da >= 0:
                    kept.append(a)
                if da * db < 0:
                    kept.append(tuple(p + (q - p) * da / (da - db) for p, q in zip(a, b)))
            polygon = kept
    return polygon


def area(polygon):
    """The area of a flat polygon in space."""
    total = [0.0, 0.0, 0.0]
    for b, c in zip(polygon[1:], polygon[2:]):
        u, v = [q - p for p, q in zip(polygon[0], b)], [q - p for p, q in zip(polygon[0], c)]
        for i in range(3):
            total[i] += (u[i - 2] * v[i - 1] - u[i - 1] * v[i - 2]) / 2
    return math.hypot(*total)


class Tiles:
    """The triangles of one level by OSM way, in coordinates of the map."""

    def __init__(self, folder, level):
        self.triangles, self.things = {}, []
        for path in sorted((folder / "glb").glob(f"*_L{level}.glb")):
            self.read(Glb(path))

    def read(self, glb):
        ids = glb.osm_ids()
        at = glb.gltf["nodes"][0]["translation"]
        for node in glb.gltf["nodes"][1:]:
            if "mesh" not in node:
                continue
            self.read_instances(glb, node, at)
            for primitive in glb.gltf["meshes"][node["mesh"]]["primitives"]:
                attributes = primitive["attributes"]
                if "_FEATURE_ID_0" not in attributes:
                    continue
                points = [(x + at[0], -(z + at[2]), y + at[1]) for x, y, z in glb.values(attributes["POSITION"])]
                features = [ids[int(f[0])] for f in glb.values(attributes["_FEATURE_ID_0"])]
                corners = [i[0] for i in glb.values(primitive["indices"])]
                for a, b, c in zip(corners[::3], corners[1::3], corners[2::3]):
                    self.triangles.setdefault((features[a], node["name"]), []).append((points[a], points[b], points[c]))

    def read_instances(self, glb, node, at):
        """The place, foot and top of each instance."""
        attributes = node.get("extensions", {}).get("EXT_mesh_gpu_instancing", {}).get("attributes")
        # one of a kind is a node of its own
        places = glb.values(attributes["TRANSLATION"]) if attributes else [node["translation"]] if "translation" in node else []
        boxes = [glb.gltf["accessors"][p["attributes"]["POSITION"]] for p in glb.gltf["meshes"][node["mesh"]]["primitives"]]
        low, high = min(box["min"][1] for box in boxes), max(box["max"][1] for box in boxes)
        for x, y, z in places:
            self.things.append((x + at[0], -(z + at[2]), y + at[1] + low, y + at[1] + high))

    def thing_near(self, frame, x, y):
        """The foot and the top of the instance within 1 m of a place; None if there is none."""
        east, north = frame.on_map(x, y)
        near = [thing[2:] for thing in self.things if math.hypot(thing[0] - east, thing[1] - north) < 1]
        return near[0] if near else None

    def of(self, way, frame, layers=("buildings",)):
        """The triangles of a way in the frame's own coordinates."""
        return [tuple((*frame.own(x, y), z) for x, y, z in triangle)
                for (osm, layer), triangles in self.triangles.items() if osm & 0xFFFFFFFFFFFF == way and layer in layers
                for triangle in triangles]


def all_triangles(tiles, frame, layers):
    for (_, layer), triangles in tiles.triangles.items():
        if layer in layers:
            for triangle in triangles:
                yield tuple((*frame.own(x, y), z) for x, y, z in triangle)


def surfaces_at(tiles, frame, x, y, layers):
    """The heights of all faces of these layers at a place, from below."""
    heights = []
    for a, b, c in all_triangles(tiles, frame, layers):
        d = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
        if abs(d) < 1e-9:
            continue
        u = ((x - a[0]) * (c[1] - a[1]) - (y - a[1]) * (c[0] - a[0])) / d
        v = ((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])) / d
        if u >= -1e-6 and v >= -1e-6 and u + v <= 1 + 1e-6:
            heights.append(a[2] + u * (b[2] - a[2]) + v * (c[2] - a[2]))
    return sorted(heights)


def height_at(tiles, frame, x, y, layers=("ground", "roads", "water")):
    """The highest surface of these layers at a place."""
    return max(surfaces_at(tiles, frame, x, y, layers), default=-math.inf)


class Situation:
    """Adds itself to a map, and tests the tiles at one level."""

    def land_m(self, x, y):
        """The heightmap, in own coordinates."""
        return 100.0

    def test(self, case, tiles):
        raise NotImplementedError

    def expect_empty(self, case, tiles, way, low, high):
        triangles = tiles.of(way, self.frame)
        case.assertTrue(triangles, f"way {way} has no triangles")
        inside = [t for t in triangles if len(clipped(t, low, high)) > 2]
        case.assertEqual(len(inside), 0, f"triangles of way {way}, such as {inside[:1]}")

    def highest(self, tiles, way, x0, y0, x1, y1):
        inside = [clipped(t, (x0, y0, -1e4), (x1, y1, 1e4)) for t in tiles.of(way, self.frame)]
        return max((p[2] for polygon in inside for p in polygon), default=-math.inf)


class Passage(Situation):
    def add(self, osm, frame):
        self.frame = frame
        self.house = osm.box(frame, -14, -6, 14, 6, {"building": "apartments", "building:levels": "4"})
        osm.way(frame, [(0, -25), (0, -6)], {"highway": "service", "width": "4"})
        osm.way(frame, [(0, -6), (0, 6)], {"highway": "service", "width": "4", "tunnel": "building_passage"})
        osm.way(frame, [(0, 6), (0, 25)], {"highway": "service", "width": "4"})

    def test(self, case, tiles):
        self.expect_empty(case, tiles, self.house, (-1.9, -7, 100.15), (1.9, 7, 103.4))
        case.assertGreater(self.highest(tiles, self.house, -1, -5, 1, 5), 105)


class ObliquePassageOfTwoHouses(Situation):
    def add(self, osm, frame):
        self.frame = frame
        self.houses = [osm.box(frame, x, -6, x + 12, 6, {"building": "yes", "building:levels": "3"}) for x in (-12, 0)]
        osm.way(frame, [(-16, -20), (16, 20)], {"highway": "footway", "width": "2"})

    def test(self, case, tiles):
        along = math.hypot(16, 20)
        ux, uy = 16 / along, 20 / along
        for house in self.houses:
            triangles = [tuple((x * uy - y * ux, x * ux + y * uy, z) for x, y, z in t) for t in tiles.of(house, self.frame)]
            case.assertTrue(triangles)
            inside = [t for t in triangles if len(clipped(t, (-0.9, -12, 100.15), (0.9, 12, 101.95))) > 2]
            case.assertEqual(len(inside), 0, f"triangles of way {house}, such as {inside[:1]}")


class OpenRoof(Situation):
    def add(self, osm, frame):
        self.frame = frame
        self.roof = osm.box(frame, -10, -6, 10, 6, {"building": "roof", "height": "6"})

    def test(self, case, tiles):
        self.expect_empty(case, tiles, self.roof, (-9, -5, 100.1), (9, 5, 104.5))
        # walls all around would have 224 m²; posts have far less
        sides = [clipped(t, (-10.5, -6.5, 100.5), (10.5, 6.5, 104)) for t in tiles.of(self.roof, self.frame)]
        case.assertLess(sum(area(polygon) for polygon in sides), 90)
        case.assertAlmostEqual(self.highest(tiles, self.roof, -8, -5, 8, 5), 106, delta=0.2)


class Parts(Situation):
    def add(self, osm, frame):
        self.frame = frame
        self.outline = osm.box(frame, -18, -6, 18, 6, {"building": "yes", "building:levels": "6", "roof:shape": "flat"})
        self.ends = [osm.box(frame, x, -6, x + 12, 6, {"building:part": "yes", "building:levels": "5", "roof:shape": "flat"})
                     for x in (-18, 6)]

    def test(self, case, tiles):
        roofs_m = [self.highest(tiles, self.outline, -5, -5, 5, 5), *(self.highest(tiles, way, x, -5, x + 10, 5)
                                                                      for way, x in zip(self.ends, (-17, 7)))]
        for roof_m, usual_m in zip(roofs_m, (118.6, 115.5, 115.5)):
            # what stands on a roof is up to 3 m high
            case.assertGreater(roof_m, usual_m - 0.2)
            case.assertLess(roof_m, usual_m + 3)
        for x in (-17, 7):
            case.assertEqual(self.highest(tiles, self.outline, x, -5, x + 10, 5), -math.inf)


class BowTie(Situation):
    def add(self, osm, frame):
        self.frame = frame
        self.way = osm.way(frame, [(-12, -6), (12, 6), (12, -6), (-12, 6)],
                           {"building": "yes", "height": "9", "roof:shape": "flat"}, closed=True)

    def test(self, case, tiles):
        for x in (-11, 8):
            case.assertAlmostEqual(self.highest(tiles, self.way, x, -2, x + 3, 2), 109, delta=0.2)
        case.assertEqual(self.highest(tiles, self.way, -1, 4, 1, 6), -math.inf)


class WhatIsNotOnTheGround(Situation):
    TAGS = ({"building": "demolished"}, {"building": "yes", "razed": "yes"}, {"building": "yes", "level": "-1"},
            {"building": "yes", "building:levels": "0", "building:levels:underground": "2"}, {"razed:building": "yes"})

    def add(self, osm, frame):
        self.frame = frame
        self.ways = [osm.box(frame, 12 * i - 30, -5, 12 * i - 20, 5, tags) for i, tags in enumerate(self.TAGS)]

    def test(self, case, tiles):
        for way in self.ways:
            case.assertEqual(len(tiles.of(way, self.frame)), 0, f"triangles of way {way}")


class Ruin(Situation):
    def add(self, osm, frame):
        self.frame = frame
        self.way = osm.box(frame, -10, -8, 10, 8, {"building": "ruins", "height": "5"})

    def test(self, case, tiles):
        self.expect_empty(case, tiles, self.way, (-8, -6, 100.3), (8, 6, 120))
        case.assertAlmostEqual(self.highest(tiles, self.way, -11, -9, 11, 9), 105, delta=0.2)


class RetainingWall(Situation):
    def land_m(self, x, y):
        return 100 + 8 * min(1, max(0, (y + 12) / 24))

    def add(self, osm, frame):
        self.frame = frame
        osm.way(frame, [(-35, 0), (35, 0)], {"barrier": "retaining_wall", "height": "8"})

    def test(self, case, tiles):
        for x in (-12, 0, 12):
            case.assertLess(height_at(tiles, self.frame, x, -2, ("ground",)), 102)
            case.assertGreater(height_at(tiles, self.frame, x, 2, ("ground",)), 106)


class Pier(Situation):
    def land_m(self, x, y):
        return 99.0 if y > -10 else 100.0

    def add(self, osm, frame):
        self.frame = frame
        osm.box(frame, -30, -10, 30, 30, {"natural": "water", "water": "lake"})
        osm.way(frame, [(0, -12), (0, 20)], {"man_made": "pier", "width": "3"})

    def test(self, case, tiles):
        layers = {name for _, name in tiles.triangles}
        water = height_at(tiles, self.frame, 15, 10, layers)
        for y in (0, 10, 18):
            case.assertGreater(height_at(tiles, self.frame, 0, y, layers) - water, 0.5)


WALKED = ("ground", "roads", "water", "structures")


class AreaThatIsABridge(Situation):
    """A square over a street in a cutting, with a path to each of two sides."""
    def land_m(self, x, y):
        return 94.0 if abs(x) < 12 and abs(y) < 44 else 100.0

    def add(self, osm, frame):
        self.frame = frame
        self.area = osm.joined(frame, [(-18, -6), (18, -6), (18, 0), (18, 6), (-18, 6), (-18, 0)],
                               {"highway": "pedestrian", "area": "yes", "bridge": "yes", "layer": "1"}, closed=True)
        for side in (-1, 1):
            osm.joined(frame, [(side * 45, 0), (side * 18, 0)], {"highway": "footway"})
        osm.way(frame, [(0, -38), (0, 38)], {"highway": "service"})

    def test(self, case, tiles):
        road = height_at(tiles, self.frame, 0.2, 15)
        for x, y in ((0.3, 0.2), (-8, 4), (9, -5)):
            deck = surfaces_at(tiles, self.frame, x, y, ("structures",))
            case.assertTrue(deck, f"no deck at {x}, {y}")
            case.assertGreater(deck[-1], 99)
            case.assertGreater(deck[0], road + 4)
        for side in (-1, 1):
            outside, inside = (height_at(tiles, self.frame, side * x, 0.3, WALKED) for x in (18.4, 17.6))
            case.assertAlmostEqual(outside, inside, delta=0.25)


class OutlineOfABridge(Situation):
    """Two streets and a house on the outline of a bridge over a valley."""
    def land_m(self, x, y):
        return 94.0 if abs(x) < 12 and abs(y) < 44 else 100.0

    def add(self, osm, frame):
        self.frame = frame
        self.outline = osm.box(frame, -18, -12, 18, 12, {"man_made": "bridge", "layer": "1"})
        for y in (-5, 4):
            for x0, x1, tags in ((-50, -17.5, {}), (-17.5, 17.5, {"bridge": "yes", "layer": "1"}), (17.5, 50, {})):
                osm.joined(frame, [(x0, y), (x1, y)], {"highway": "residential", **tags})
        self.house = osm.box(frame, -8, 8, 2, 11, {"building": "yes", "building:levels": "2"})

    def test(self, case, tiles):
        for y in (-11, -0.5, 7.3):
            deck = surfaces_at(tiles, self.frame, 6, y, ("structures",))
            case.assertTrue(deck, f"no deck at y = {y}")
            case.assertAlmostEqual(deck[-1], 100, delta=0.7)
            case.assertGreater(deck[0], 97)
        house = [p[2] for triangle in tiles.of(self.house, self.frame) for p in triangle]
        case.assertGreater(min(house), 98.5)
        case.assertGreater(max(house), 104)


class TwoBridgesWithoutLayers(Situation):
    """The longer one is above."""
    def land_m(self, x, y):
        return 102.0 if abs(y) > 22 else 94.0 if abs(x) < 12 else 100.0

    def add(self, osm, frame):
        self.frame = frame
        for place, ends in ((lambda t: (t, 0), (48, 15)), (lambda t: (0, t), (52, 26))):
            out, end = ends
            for a, b, tags in ((-out, -end, {}), (-end, end, {"bridge": "yes"}), (end, out, {})):
                osm.joined(frame, [place(a), place(b)], {"highway": "service", **tags})

    def test(self, case, tiles):
        faces = surfaces_at(tiles, self.frame, 0.3, 0.4, ("structures",))
        case.assertGreater(faces[-1], faces[0] + 4)
        case.assertAlmostEqual(height_at(tiles, self.frame, 0, 18, ("structures",)), faces[-1], delta=1.5)


class SkywalksBetweenHouses(Situation):
    """A corridor that is a bridge and a building that is one, over a street."""
    def add(self, osm, frame):
        self.frame = frame
        osm.way(frame, [(0, -40), (0, 40)], {"highway": "residential"})
        for x in (-22, 8):
            osm.box(frame, x, -14, x + 14, 14, {"building": "office", "building:levels": "5", "roof:shape": "flat"})
        self.path = osm.way(frame, [(-8, 6), (8, 6)],
                            {"highway": "footway", "bridge": "yes", "layer": "1", "level": "1", "indoor": "yes"})
        self.building = osm.box(frame, -8, -8, 8, -4, {"building": "yes", "bridge": "yes", "layer": "1"})

    def test(self, case, tiles):
        self.expect_empty(case, tiles, self.building, (-7, -9, 99), (7, -3, 104.8))
        case.assertGreater(self.highest(tiles, self.building, -5, -7, 5, -5), 107)
        street = (-4, -40, 0), (4, 40, 1e4)
        deck = [p[2] for triangle in tiles.of(self.path, self.frame, ("structures",)) for p in clipped(triangle, *street)]
        case.assertTrue(deck)
        case.assertGreater(min(deck), 103.5)


class RetainingWallWithoutHeight(RetainingWall):
    TAGS = {"barrier": "retaining_wall"}

    def add(self, osm, frame):
        self.frame = frame
        osm.way(frame, [(-35, 0), (35, 0)], self.TAGS)


class WallThatHoldsTheGround(RetainingWallWithoutHeight):
    TAGS = {"barrier": "wall", "wall": "retaining_wall"}


class ThingsOnRoofs(Situation):
    """A mast and a flagpole stand on the roof, a chimney grows out of it, and none is left on the ground."""
    TAGS = (({"man_made": "mast", "height": "6", "location": "roof"}, 115, 121), ({"man_made": "flagpole", "height": "5"}, 115, 120),
            ({"man_made": "antenna", "height": "20", "min_height": "15"}, 115, 120), ({"man_made": "chimney", "height": "30"}, 100, 130))

    def add(self, osm, frame):
        self.frame = frame
        self.house = osm.box(frame, -20, -6, 20, 6, {"building": "yes", "height": "15", "roof:shape": "flat"})
        for i, (tags, _, _) in enumerate(self.TAGS):
            east, north = frame.on_map(-15 + 10 * i, 0)
            osm.nodes.append((len(osm.nodes) + 1, LAT + north / LAT_M, LON + east / LON_M, tags))

    def test(self, case, tiles):
        for i, (tags, foot_m, top_m) in enumerate(self.TAGS):
            bounds = tiles.thing_near(self.frame, -15 + 10 * i, 0)
            case.assertIsNotNone(bounds, tags)
            case.assertAlmostEqual(bounds[0], foot_m, delta=1.2, msg=tags)
            case.assertAlmostEqual(bounds[1], top_m, delta=1.2, msg=tags)


class ClosedTrack(Situation):
    def add(self, osm, frame):
        self.frame = frame
        self.way = osm.box(frame, -40, -25, 40, 25, {"leisure": "track", "sport": "running"})

    def test(self, case, tiles):
        layers = {name for _, name in tiles.triangles}
        triangles = tiles.of(self.way, self.frame, layers)
        case.assertTrue(triangles)
        case.assertEqual([t for t in triangles if len(clipped(t, (-30, -15, 0), (30, 15, 1e4))) > 2], [])
        on_line = [clipped(t, (-41, -10, 0), (-39, 10, 1e4)) for t in triangles]
        case.assertAlmostEqual(sum(area(polygon) for polygon in on_line if len(polygon) > 2), 40, delta=4)


class LinesOffTheGround(Situation):
    TAGS = ({"barrier": "wall", "level": "1"}, {"barrier": "wall", "layer": "1"}, {"barrier": "wall", "layer": "-1"},
            {"highway": "footway", "level": "1"}, {"highway": "footway", "indoor": "yes"}, {"highway": "corridor", "level": "2"})

    def add(self, osm, frame):
        self.frame = frame
        self.ways = [osm.way(frame, [(-30, 6 * i - 15), (30, 6 * i - 15)], tags) for i, tags in enumerate(self.TAGS)]

    def test(self, case, tiles):
        layers = {name for _, name in tiles.triangles}
        for way, tags in zip(self.ways, self.TAGS):
            case.assertEqual(tiles.of(way, self.frame, layers), [], tags)


def plan_area(triangles):
    """The area of the faces that look up, seen from above."""
    return sum(max(0.0, ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2) for a, b, c in triangles)


class SmallerAreasOnLarger(Situation):
    """In a square and in a car park: a pond, a flower bed, a playground, a lawn, a pitch."""
    INNER = ({"natural": "water"}, {"leisure": "garden"}, {"leisure": "playground"}, {"landuse": "grass"}, {"leisure": "pitch"})

    def add(self, osm, frame):
        self.frame = frame
        self.inner = []
        for y, tags in ((-22, {"highway": "pedestrian", "area": "yes"}), (4, {"amenity": "parking"})):
            osm.box(frame, -40, y, 40, y + 18, tags)
            self.inner += [osm.box(frame, 15 * i - 36, y + 5, 15 * i - 26, y + 13, inner) for i, inner in enumerate(self.INNER)]

    def test(self, case, tiles):
        layers = {name for _, name in tiles.triangles}
        for way in self.inner:
            # a mirrored frame turns faces over
            area_m2 = plan_area(tiles.of(way, self.frame, layers)) if self.frame.m > 0 else \
                plan_area([(a, c, b) for a, b, c in tiles.of(way, self.frame, layers)])
            case.assertGreater(area_m2, 60, f"way {way} of 80 m²")


class WayAndMultipolygon(Situation):
    """A house with a courtyard whose outer way has the tags of the multipolygon."""
    def add(self, osm, frame):
        self.frame = frame
        tags = {"building": "yes", "height": "9", "roof:shape": "flat"}
        self.outer = osm.box(frame, -16, -12, 16, 12, tags)
        inner = osm.box(frame, -8, -5, 8, 5, {})
        self.relation = 1000 + len(osm.relations)
        osm.relations.append((self.relation, [(self.outer, "outer"), (inner, "inner")], {"type": "multipolygon", **tags}))

    def test(self, case, tiles):
        case.assertEqual(tiles.of(self.outer, self.frame), [], "built twice")
        self.expect_empty(case, tiles, self.relation, (-6, -3, 100.2), (6, 3, 120))
        case.assertAlmostEqual(self.highest(tiles, self.relation, -16, -12, -9, 12), 109, delta=3)


class IslandThatIsARelation(Situation):
    def add(self, osm, frame):
        self.frame = frame
        lake, island = (osm.box(frame, -r, -r, r, r, {}) for r in (30, 12))
        first = 1000 + len(osm.relations)
        osm.relations.append((first, [(lake, "outer"), (first + 1, "inner", "relation")], {"type": "multipolygon", "natural": "water"}))
        osm.relations.append((first + 1, [(island, "outer")], {"type": "multipolygon", "landuse": "grass"}))
        self.lake, self.island = first, first + 1

    def test(self, case, tiles):
        layers = {name for _, name in tiles.triangles}
        case.assertEqual([t for t in tiles.of(self.lake, self.frame, layers) if len(clipped(t, (-9, -9, 0), (9, 9, 1e4))) > 2], [])
        case.assertTrue(tiles.of(self.island, self.frame, layers))


class ElementsTwice(Situation):
    """Overpass writes them once with tags and once without, in either order."""
    def add(self, osm, frame):
        self.frame = frame
        self.houses = [osm.box(frame, x, -5, x + 10, 5, {"building": "house"}) for x in (-20, 5)]
        without_tags = [(way, refs, {}) for way, refs, _ in osm.ways[-2:]]
        osm.ways.insert(len(osm.ways) - 2, without_tags[0])
        osm.ways.append(without_tags[1])

    def test(self, case, tiles):
        for house in self.houses:
            case.assertTrue(tiles.of(house, self.frame), f"way {house} is missing")


SITUATIONS = (Passage, ObliquePassageOfTwoHouses, OpenRoof, Parts, BowTie, WhatIsNotOnTheGround, Ruin, RetainingWall, Pier, AreaThatIsABridge,
              OutlineOfABridge, TwoBridgesWithoutLayers, SkywalksBetweenHouses, RetainingWallWithoutHeight, WallThatHoldsTheGround,
              ThingsOnRoofs, ClosedTrack, LinesOffTheGround, SmallerAreasOnLarger, WayAndMultipolygon, IslandThatIsARelation, ElementsTwice)


def grey_png(rows):
    """A picture of 16 bits a pixel."""
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
    header = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 16, 0, 0, 0, 0)
    pixels = b"".join(b"\0" + struct.pack(f">{len(row)}H", *row) for row in rows)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(pixels)) + chunk(b"IEND", b"")


def land_m(situations, east, north):
    """Each square has the land of its situation, in its middle; between them the land is level."""
    for s in situations:
        if max(abs(s.frame.x - east), abs(s.frame.y - north)) < SPACING_M / 2:
            return s.land_m(*s.frame.own(east, north))
    return 100.0


def write_heightmap(situations, path):
    """Writes a raster of 2 m, and returns the words that say where it is."""
    side = SIDE * SPACING_M + 100
    count = side // 2
    at = [(i + 0.5) * side / count - side / 2 for i in range(count)]
    path.write_bytes(grey_png([[round(10 * land_m(situations, east, north)) for east in at] for north in reversed(at)]))
    lon, lat = side / 2 / LON_M, side / 2 / LAT_M
    return f"{path},bounds={LON - lon}/{LAT - lat}/{LON + lon}/{LAT + lat},scale=0.1,offset=0"


def made_situations(seed):
    """One of each, at places in a random order; the squares meet where tiles and regions do."""
    dice, osm = random.Random(seed), Map()
    places = [((i - (SIDE - 1) / 2) * SPACING_M, (j - (SIDE - 1) / 2) * SPACING_M) for i in range(SIDE) for j in range(SIDE)]
    # one stands on the corner of four tiles, in place of the four about it
    places = [place for place in places if max(map(abs, place)) > SPACING_M]
    dice.shuffle(places)
    places[dice.randrange(len(SITUATIONS))] = (0, 0)
    situations = []
    for kind, (x, y) in zip(SITUATIONS, places):
        situation = kind()
        situation.add(osm, Frame(x + dice.uniform(-4, 4), y + dice.uniform(-4, 4), dice.uniform(0, 2 * math.pi), dice.random() < 0.5))
        situations.append(situation)
    return situations, osm


class Situations(ProgramTest):
    def test_each_is_as_its_tags_say_however_it_lies(self):
        for seed in range(COUNT):
            with self.subTest(seed=seed):
                self.compile_and_test(seed)

    def compile_and_test(self, seed):
        situations, osm = made_situations(seed)
        path = self.folder / f"map{seed}.osm"
        half = SIDE * SPACING_M / 2
        box = (LAT - half / LAT_M, LON - half / LON_M, LAT + half / LAT_M, LON + half / LON_M)
        path.write_bytes(map_xml(osm.nodes, osm.ways, osm.relations, box))
        land = write_heightmap(situations, self.folder / f"land{seed}.png")
        out = self.compiled(f"out{seed}", path, "--dem", land, "--lods", LEVELS, "--tile", "256", "--quiet")
        self.assertTrue(report_of(out)["balances"])
        checked = run("check", out)
        self.assertEqual(checked.returncode, 0, checked.stdout + checked.stderr)
        for level in range(len(LEVELS.split(","))):
            tiles = Tiles(out, level)
            for situation in situations:
                with self.subTest(situation=type(situation).__name__, level=level):
                    situation.test(self, tiles)
        self.expect_equal_in_regions(seed, path, land, out)

    def expect_equal_in_regions(self, seed, path, land, out):
        plan = self.folder / f"plan{seed}"
        done = run("plan", path, "--dem", land, "--lods", LEVELS, "--tile", "256", "--region", "256", "-o", plan)
        self.assertEqual(done.returncode, 0, done.stderr)
        regions = [each["region"] for each in json.loads((plan / "plan.json").read_text())["regions"]]
        self.assertGreater(len(regions), 1)
        for region in regions:
            done = run("compile", "--plan", plan, "--region", region)
            self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(run("gather", plan).returncode, 0)
        self.assertEqual(bytes_of_outputs(plan / "out"), bytes_of_outputs(out))


if __name__ == "__main__":
    if "--count" in sys.argv:
        at = sys.argv.index("--count")
        COUNT = int(sys.argv[at + 1])
        del sys.argv[at:at + 2]
    unittest.main()
