#!/usr/bin/env python3
"""Measures what a viewer loads and draws along three flights over a map, for sets of levels of detail. By hand:

    tests/bench/flights.py --street "Neustrelitzer Straße" RUN... [--csv sets.csv]

Each RUN is the folder of a run with 3D Tiles, one of them with the manifest. All are of one map with one size of tiles; together they have every
level of the tiles near a flight, and coarser ones far from it, so that the map need not be compiled at its finest levels everywhere. The bytes of a
tile's level do not depend on the other levels of its run. Inner tiles depend on the coarsest level, so a set uses those of the run with the
same coarsest level.

A tile is shown at its coarsest level whose error is at most PIXELS pixels in a picture of 1920 x 1080 with a vertical field of view of 60
degrees. The distance is that of the eye from the tile's box, as in CesiumJS and 3DTilesRendererJS. Tiles outside of the picture are neither
shown nor loaded. There are two layouts:

    flat   each tile apart, with its tolerance as error: files of glb/ in an engine. Only what is shown is loaded
    tree   tileset.json, with its errors, boxes and inner tiles. Tiles above those that are shown are loaded too, as CesiumJS does

The flights: `street` at eye height along a street; `roofs` 60 m above it in a straight line; `hills` 300 m above the roads, 4 km in the
direction of the street.
"""
import argparse
import csv
import functools
import itertools
import json
import math
import os
import re
import subprocess
import sys
import tempfile
from collections import defaultdict
from dataclasses import dataclass, field
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tests" / "properties"))
from glb import Glb  # noqa: E402

PROGRAM = os.environ.get("CITYKILN", str(ROOT / "build" / "release" / "citykiln"))

WIDTH_PX, HEIGHT_PX, FIELD_DEG = 1920, 1080, 60
FOCAL_PX = HEIGHT_PX / 2 / math.tan(math.radians(FIELD_DEG / 2))
PIXELS = (1, 6)
LAYOUTS = ("flat", "tree")
DEFAULT = (0.1, 0.5, 1.2, 2.5, 12.5)
MOST_RATIO = 5  # of neighbouring levels, which skirts rely on
FEWEST_LEVELS, MOST_LEVELS = 3, 6
HILLS_M = 4000


@dataclass
class Content:
    """The costs of one .glb file."""
    bytes: int
    triangles: int  # instanced ones at each of their places
    draws: int  # primitives of nodes; instances of one mesh are one


@dataclass
class Tile:
    """A tile of a tree. Its children replace it."""
    box: tuple  # centre and three half axes, twelve numbers, in the root's frame
    error_m: float
    path: Path = None
    children: list = field(default_factory=list)


@dataclass
class Eye:
    """A place, and the planes of its picture: unit normals that point inwards."""
    at: tuple
    planes: list


@dataclass
class Flight:
    name: str
    height_m: float  # above the roads
    down_deg: float  # how far the picture's middle lies below the horizon
    step_m: float


FLIGHTS = (Flight("street", 1.7, 0, 5), Flight("roofs", 60, 10, 20), Flight("hills", 300, 15, 50))


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def scaled(v, factor):
    return tuple(factor * c for c in v)


def plus(a, b):
    return tuple(p + q for p, q in zip(a, b))


def eye_of(at, heading, down_deg):
    """The eye at a place that looks along a heading in plan, of length 1."""
    down = math.radians(down_deg)
    ahead = (heading[0] * math.cos(down), heading[1] * math.cos(down), -math.sin(down))
    right = (heading[1], -heading[0], 0)
    up = cross(right, ahead)
    planes = [ahead]
    for side, half_px in ((right, WIDTH_PX / 2), (up, HEIGHT_PX / 2)):
        half = math.atan(half_px / FOCAL_PX)
        for sign in (1, -1):
            planes.append(plus(scaled(ahead, math.sin(half)), scaled(side, sign * math.cos(half))))
    return Eye(at, planes)


def distance_m(at, box):
    """The distance of a place from a box; 0 inside."""
    away = [p - c for p, c in zip(at, box[:3])]
    outside = 0
    for axis in (box[3:6], box[6:9], box[9:12]):
        half = math.sqrt(dot(axis, axis))
        if half > 0:
            outside += max(0, abs(dot(axis, away)) / half - half) ** 2
    return math.sqrt(outside)


def grown(box, other):
    """A box with the same axes that contains both."""
    centre, axes = box[:3], []
    for axis in (box[3:6], box[6:9], box[9:12]):
        half = math.sqrt(dot(axis, axis))
        if half == 0:
            axes.append(axis)
            continue
        unit = scaled(axis, 1 / half)
        reach = sum(abs(dot(unit, other[i:i + 3])) for i in (3, 6, 9))
        middle, there = dot(unit, box[:3]), dot(unit, other[:3])
        low, high = min(middle - half, there - reach), max(middle + half, there + reach)
        centre = plus(centre, scaled(unit, (low + high) / 2 - middle))
        axes.append(scaled(unit, (high - low) / 2))
    return (*centre, *axes[0], *axes[1], *axes[2])


def is_in_picture(eye, box):
    """False only where the box lies behind a plane of the picture."""
    away = [c - p for p, c in zip(eye.at, box[:3])]
    for plane in eye.planes:
        reach = abs(dot(plane, box[3:6])) + abs(dot(plane, box[6:9])) + abs(dot(plane, box[9:12]))
        if dot(plane, away) + reach < 0:
            return False
    return True


class View:
    """The boxes that an eye sees. Each is computed once."""

    def __init__(self, eye):
        self.eye, self.seen = eye, {}

    def pixels_per_m(self, box):
        """How many pixels a metre at the box has; None outside of the picture."""
        if box not in self.seen:
            near_m = distance_m(self.eye.at, box)
            self.seen[box] = (FOCAL_PX / near_m if near_m > 0 else math.inf) if is_in_picture(self.eye, box) else None
        return self.seen[box]


def shown(tile, view, most_px):
    """The tiles of a tree that are shown, and those above them: coarser ones where their error is at most `most_px` pixels."""
    pixels_per_m = view.pixels_per_m(tile.box)
    if pixels_per_m is None:
        return [], []
    if not tile.children or tile.error_m * pixels_per_m <= most_px:
        return [tile], []
    tiles, above = [], [tile]
    for child in tile.children:
        more, more_above = shown(child, view, most_px)
        tiles += more
        above += more_above
    return tiles, above


@dataclass
class Level:
    """A tile at one tolerance."""
    box: tuple
    error_m: float
    path: Path


class Runs:
    """The levels of all tiles of the runs, and for each coarsest level the inner tiles of its run."""

    def __init__(self, folders):
        self.levels = defaultdict(dict)  # tile to tolerance to Level
        self.compiled = defaultdict(set)  # tile to tolerances; a level that is no coarser than the next is compiled, but has no file
        self.inner = {}  # coarsest tolerance to a Tile whose leaves have the name of a tile in place of a path
        for folder in map(Path, folders):
            document = json.loads((folder / "3dtiles" / "tileset.json").read_text())
            self.tolerances = {level["tolerance_m"] for level in json.loads((folder / "report.json").read_text())["levels"]}
            root = self.read(document["root"], folder / "3dtiles")
            self.inner.setdefault(max(self.tolerances), root)
            self.to_earth = document["root"]["transform"]
            if (folder / "scene.kiln").exists():
                self.manifest, self.box = folder / "scene.kiln", tuple(document["root"]["boundingVolume"]["box"])

    def read(self, tile, folder):
        """A tile of tileset.json. Levels of one tile of the map go to `levels`; a leaf with its name stays."""
        uri = tile["content"]["uri"]
        if uri.endswith(".json"):
            return self.read(json.loads((folder / uri).read_text())["root"], folder)
        name = re.fullmatch(r"(-?\d+_-?\d+)_L\d+\.glb", uri)
        if not name:
            children = [self.read(child, folder) for child in tile["children"]]
            return Tile(tuple(tile["boundingVolume"]["box"]), tile["geometricError"], folder / uri, children)
        self.compiled[name[1]] |= self.tolerances
        self.keep(tile, folder, name[1])
        return Tile((), 0, name[1])

    def keep(self, tile, folder, name):
        level = Level(tuple(tile["boundingVolume"]["box"]), tile["geometricError"], folder / tile["content"]["uri"])
        self.levels[name][tile["extras"]["tolerance_m"]] = level
        for child in tile.get("children", []):
            self.keep(child, folder, name)

    def chain(self, name, tolerances, layout):
        """A tile at some levels as a tree, the coarsest first. It ends above the first level that no run has. None without the coarsest."""
        known = list(itertools.takewhile(lambda tolerance: tolerance in self.compiled[name], sorted(tolerances, reverse=True)))
        below = None
        for tolerance in reversed(known):
            # the compiler leaves a level out whose error is no larger than that of the finer one
            there = max((t for t in self.levels[name] if t <= tolerance), default=None)
            if there is None or below is not None and below.path == self.levels[name][there].path:
                continue
            level = self.levels[name][there]
            box = grown(level.box, below.box) if below else level.box
            below = Tile(box, tolerance if layout == "flat" else level.error_m, level.path, [below] if below else [])
        return below

    def roots(self, tolerances, layout):
        """The trees of a set of levels; none where a tile has no run with the coarsest."""
        if any(max(tolerances) not in compiled for compiled in self.compiled.values()):
            return []
        if layout == "flat":
            return [self.chain(name, tolerances, layout) for name in sorted(self.levels)]
        return [self.joined(self.inner[max(tolerances)], tolerances)]

    def joined(self, tile, tolerances):
        if not tile.children:
            return self.chain(tile.path, tolerances, "tree")
        children = [self.joined(child, tolerances) for child in tile.children]
        return Tile(functools.reduce(grown, (child.box for child in children), tile.box), tile.error_m, tile.path, children)

    def is_finest(self, tile, tolerances):
        """Whether no level of the set would be finer than a tile without children."""
        name = re.fullmatch(r"(-?\d+_-?\d+)_L\d+\.glb", tile.path.name)
        return not name or self.compiled[name[1]].issuperset(tolerances)


def content_of(path):
    gltf = Glb(path).gltf
    count = Content(path.stat().st_size, 0, 0)
    for node in gltf["nodes"]:
        instances = node.get("extensions", {}).get("EXT_mesh_gpu_instancing")
        copies = gltf["accessors"][next(iter(instances["attributes"].values()))]["count"] if instances else 1
        for primitive in gltf["meshes"][node["mesh"]]["primitives"] if "mesh" in node else []:
            accessor = primitive.get("indices", primitive["attributes"]["POSITION"])
            count.triangles += gltf["accessors"][accessor]["count"] // 3 * copies
            count.draws += 1
    return count


def roads_of(runs):
    """The roads of a run's scene.kiln: names and lines of places in the root's frame."""
    with tempfile.TemporaryDirectory() as scratch:
        path = Path(scratch) / "roads.json"
        subprocess.run([PROGRAM, "inspect", runs.manifest, "--layer", "roads", "--geojson", path], check=True, capture_output=True)
        features = json.loads(path.read_text())["features"]
    return [(road["properties"].get("name", ""), [in_frame(runs.to_earth, *place) for place in road["geometry"]["coordinates"]])
            for road in features if road["geometry"]["type"] == "LineString"]


def in_frame(to_earth, lon_deg, lat_deg, height_m):
    """A place of WGS 84 in the frame of a root with this transform."""
    radius_m, squared = 6378137.0, 6.69437999014e-3
    lon, lat = math.radians(lon_deg), math.radians(lat_deg)
    normal_m = radius_m / math.sqrt(1 - squared * math.sin(lat) ** 2)
    across_m = (normal_m + height_m) * math.cos(lat)
    place = (across_m * math.cos(lon), across_m * math.sin(lon), (normal_m * (1 - squared) + height_m) * math.sin(lat))
    away = [p - o for p, o in zip(place, to_earth[12:15])]
    return tuple(dot(to_earth[i:i + 3], away) for i in (0, 4, 8))


def evenly(line, step_m):
    """Places on a line, at most a step apart."""
    for a, b in zip(line, line[1:]):
        pieces = max(1, math.ceil(math.dist(a, b) / step_m))
        yield from (plus(scaled(a, 1 - i / pieces), scaled(b, i / pieces)) for i in range(pieces))
    yield line[-1]


def along_street(roads, name, step_m):
    """Places on the ways of a street from one end to the other, a step apart in the direction of the street."""
    places = [place for road, line in roads if road == name for place in evenly(line, step_m / 2)]
    if not places:
        raise SystemExit(f"no road is called {name}")
    end = max(places, key=lambda p: math.dist(p, places[0]))
    start = max(places, key=lambda p: math.dist(p, end))
    axis = scaled([e - s for s, e in zip(start, end)], 1 / math.dist(start, end))
    taken = []
    for place in sorted(places, key=lambda p: dot(p, axis)):
        if not taken or dot(place, axis) - dot(taken[-1], axis) >= step_m:
            taken.append(place)
    return taken


def over_roads(roads, start, end, step_m):
    """Places on a straight line in plan, with the heights of the nearest roads."""
    ground = [place for _, line in roads for place in line]
    for place in evenly([start, end], step_m):
        nearest = min(ground, key=lambda g: (g[0] - place[0]) ** 2 + (g[1] - place[1]) ** 2)
        yield (place[0], place[1], nearest[2])


def eyes_of(flight, runs, roads, street):
    """The eyes of a flight. Each heads towards its place 50 m later, tilted down by down_deg."""
    places = along_street(roads, street, flight.step_m if flight.name == "street" else 5)
    if flight.name != "street":
        start, end = places[0], places[-1]
        if flight.name == "hills":
            middle, stretch = scaled(plus(start, end), 0.5), HILLS_M / math.dist(start, end)
            start, end = (plus(middle, scaled([p - m for p, m in zip(place, middle)], stretch)) for place in (start, end))
        places = [place for place in over_roads(roads, start, end, flight.step_m) if distance_m(place, runs.box) == 0]
    later = max(1, round(50 / flight.step_m))
    for here, there in zip(places, places[later:]):
        heading = (there[0] - here[0], there[1] - here[1])
        yield eye_of((here[0], here[1], here[2] + flight.height_m), scaled(heading, 1 / math.hypot(*heading)), flight.down_deg)


def sets_of_levels(candidates):
    """All sets with the finest candidate and 3 to 6 levels whose neighbours differ by at most MOST_RATIO."""
    finest, *others = sorted(candidates)
    for count in range(FEWEST_LEVELS, MOST_LEVELS + 1):
        for rest in itertools.combinations(others, count - 1):
            levels = (finest, *rest)
            if all(b <= MOST_RATIO * a * 1.0001 for a, b in zip(levels, levels[1:])):
                yield levels


class Account:
    """The costs of a flight: the files that were loaded, and the most triangles and draw calls in one picture."""

    def __init__(self):
        self.paths, self.triangles, self.draws, self.sum_triangles, self.pictures = set(), 0, 0, 0, 0

    def add(self, tiles, above, contents):
        self.paths.update(tile.path for tile in itertools.chain(tiles, above))
        triangles = sum(contents[tile.path].triangles for tile in tiles)
        self.triangles = max(self.triangles, triangles)
        self.sum_triangles += triangles
        self.pictures += 1
        self.draws = max(self.draws, sum(contents[tile.path].draws for tile in tiles))


class Contents(dict):
    """Costs of files by path; each is read when it is asked for."""

    def __missing__(self, path):
        self[path] = content_of(path)
        return self[path]


def lacks_level(tiles, view, most_px, runs, levels):
    """Whether a tile is too coarse for the picture although the set has a finer level, which no run has of this tile."""
    return any(tile.error_m * view.pixels_per_m(tile.box) > most_px and not runs.is_finest(tile, levels) for tile in tiles)


def fly(runs, eyes, sets, contents):
    """Accounts of a flight, by set, layout and pixels, without those that need a level that no run has."""
    trees = {(levels, layout): runs.roots(levels, layout)
             for levels in sets for layout in LAYOUTS if layout == "flat" or max(levels) in runs.inner}
    accounts = {(*key, px): Account() for key, roots in trees.items() if roots for px in PIXELS}
    for eye in eyes:
        view = View(eye)
        for key in list(accounts):
            levels, layout, px = key
            parts = [shown(root, view, px) for root in trees[levels, layout]]
            tiles = [tile for part, _ in parts for tile in part]
            if lacks_level(tiles, view, px, runs, levels):
                del accounts[key]
                continue
            above = [tile for _, part in parts for tile in part] if layout == "tree" else []
            accounts[key].add(tiles, above, contents)
    return accounts


def text_of(levels):
    return " ".join(f"{level:g}" for level in levels)


def rows_of(flight, accounts, contents):
    """A row for each account."""
    for (levels, layout, px), account in accounts.items():
        yield {"flight": flight.name, "layout": layout, "pixels": px, "levels": text_of(levels), "files": len(account.paths),
               "MB": round(sum(contents[path].bytes for path in account.paths) / 1e6, 2), "most triangles": account.triangles,
               "mean triangles": round(account.sum_triangles / account.pictures), "most draw calls": account.draws}


def is_near_default(levels):
    """Whether a set is the default, or has one level less or one more."""
    return len(set(DEFAULT) ^ set(levels)) <= 1


def print_table(rows, layout, px):
    """A row for each set near the default, and for the five with the smallest product of all bytes and triangles."""
    by_set = defaultdict(dict)
    for row in rows:
        if (row["layout"], row["pixels"]) == (layout, px):
            by_set[row["levels"]][row["flight"]] = row
    whole = {levels: by_flight for levels, by_flight in by_set.items() if len(by_flight) == len(FLIGHTS)}
    product = {levels: math.prod(row["MB"] * row["most triangles"] for row in by_flight.values()) for levels, by_flight in whole.items()}
    best = sorted(whole, key=product.get)[:5]
    chosen = [levels for levels in whole if levels in best or is_near_default(map(float, levels.split()))]
    print(f"\n{layout}, {px} px: MB loaded, most million triangles, most draw calls\n")
    print("| levels (m) | " + " | ".join(f"{flight.name}: MB | triangles | calls" for flight in FLIGHTS) + " |")
    print("|---|" + "--:|" * 3 * len(FLIGHTS))
    for levels in sorted(chosen, key=lambda levels: (levels != text_of(DEFAULT), product[levels])):
        cells = (f"{row['MB']:.0f} | {row['most triangles'] / 1e6:.2f} | {row['most draw calls']}" for row in whole[levels].values())
        print(f"| {levels} | " + " | ".join(cells) + " |")


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("runs", nargs="+")
    arguments.add_argument("--street", required=True)
    arguments.add_argument("--csv", help="a file for the rows of all sets")
    request = arguments.parse_args()
    runs, contents = Runs(request.runs), Contents()
    roads = roads_of(runs)
    sets = list(sets_of_levels(set().union(*runs.compiled.values())))
    rows = []
    for flight in FLIGHTS:
        eyes = list(eyes_of(flight, runs, roads, request.street))
        print(f"{flight.name}: {len(eyes)} pictures, {len(sets)} sets", file=sys.stderr)
        rows += rows_of(flight, fly(runs, eyes, sets, contents), contents)
    for layout, px in itertools.product(LAYOUTS, PIXELS):
        print_table(rows, layout, px)
    if request.csv:
        with open(request.csv, "w", encoding="utf-8", newline="") as out:
            writer = csv.DictWriter(out, rows[0].keys())
            writer.writeheader()
            writer.writerows(rows)


if __name__ == "__main__":
    main()
