"""Reads the buildings of OSM extracts with what compiler/assume/heights.cpp knows of each. train_heights.py and train_roofs.py use it.

Needs Python 3 and osmium-tool (`osmium sort` and `osmium export`). All lengths are metres, all areas square metres.
"""
import collections
import json
import math
import os
import pathlib
import re
import subprocess
import tempfile

# place: extract below the folder of data, country group (compiler/map/countries/country_group.h)
PLACES = {
    "nice": ("nice-old-town/nice.osm.pbf", "kSouthernEurope"),
    "monaco": ("monaco/monaco-2023.osm.pbf", "kSouthernEurope"),
    "andorra": ("andorra/andorra-2023.osm.pbf", "kSouthernEurope"),
    "malta": ("malta/malta-2018.osm.pbf", "kSouthernEurope"),
    "west-village": ("nyc/nyc-west-village.osm.pbf", "kNorthAmerica"),
    "north-hills": ("los-angeles-north-hills/north-hills.osm.gz", "kNorthAmerica"),
    "chicago": ("chicago-loop/chicago_loop.osm.pbf", "kNorthAmerica"),
    "boston": ("boston-back-bay/back_bay.osm.pbf", "kNorthAmerica"),
    "baltimore": ("baltimore-harbour/baltimore.osm.pbf", "kNorthAmerica"),
    "limerick": ("limerick/limerick.osm.gz", "kBritishIsles"),
    "dublin": ("dublin-docklands/docklands.osm.gz", "kBritishIsles"),
    "adlershof": ("berlin-adlershof/adlershof.osm.gz", "kCentralEurope"),
    "reinickendorf": ("berlin/berlin-reinickendorf-2026.osm.pbf", "kCentralEurope"),
    "neukolln": ("berlin/berlin-neukolln.osm", "kCentralEurope"),
    "mitte": ("berlin/berlin-mitte-gesundbrunnen.osm", "kCentralEurope"),
    "neubrandenburg": ("neubrandenburg/neubrandenburg.osm.bz2", "kCentralEurope"),
    "helsinki": ("helsinki/Helsinki.osm.pbf", "kNorthernEurope"),
    "kyoto": ("kyoto-fushimi/kyoto.osm.gz", "kJapan"),
}
ROOM = pathlib.Path(__file__).parent.parent.parent / "compiler"
TOUCH_M = 0.3  # kTouching_m of heights.cpp
AROUND_M = 100  # kSurroundings_m of heights.cpp
# storeys: usual heights with the roof, as footprints of a tagged height include it
PITCHED_M = 2.5


def table(path, macro, *names):
    """The rows of an X-macro table, each a list of texts."""
    text = (ROOM / path).read_text()
    return [[cell.strip().strip('"') for cell in row.split(",")] for row in re.findall(macro + r"\(([^)]*)\)", text) if "name," not in row]


STOREY_M = {name: float(storey) for name, _, storey in table("map/buildings/building_classes.inc", "BUILDING") if name[0] == "k"}
CLASS_HEIGHT_M = {name: float(height) for name, height, _ in table("map/buildings/building_classes.inc", "BUILDING") if name[0] == "k"}
CLASS_OF = {value: name for value, name in table("map/buildings/building_values.inc", "VALUE") if name[0] == "k"}

# land use under a building: the groups of heights.cpp
USES = {"residential": "kHomes", "commercial": "kTrade", "retail": "kTrade", "industrial": "kIndustry", "railway": "kIndustry", "port": "kIndustry",
        "farmland": "kCountry", "farmyard": "kCountry", "meadow": "kCountry", "forest": "kCountry", "allotments": "kCountry", "orchard": "kCountry"}
SHOPS = ("restaurant", "cafe", "bar", "pub", "fast_food", "ice_cream", "bank", "pharmacy", "marketplace")


class Building:
    pass


def exported(path):
    """The features of an extract, as GeoJSON."""
    with tempfile.TemporaryDirectory() as folder:
        is_sorted, out = os.path.join(folder, "sorted.osm.pbf"), os.path.join(folder, "out.geojsonseq")
        subprocess.run(["osmium", "sort", "--no-progress", "-o", is_sorted, str(path)], check=True, stderr=subprocess.DEVNULL)
        subprocess.run(["osmium", "export", "--no-progress", "-f", "geojsonseq", "-x", "print_record_separator=false", "-a", "type,id", "-o", out, is_sorted],
                       check=True, stderr=subprocess.DEVNULL)
        with open(out) as lines:
            for line in lines:
                yield json.loads(line)


def number(text):
    """The number that a tag's text begins with, in metres for feet; None if it has none."""
    found = re.match(r"\s*([0-9]+(?:\.[0-9]+)?)\s*(ft|')?", text or "")
    return None if not found else float(found[1]) * (0.3048 if found[2] else 1)


def area_of(ring):
    return abs(sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(ring, ring[1:] + ring[:1]))) / 2


def centroid_of(ring):
    twice, x, y = 0, 0, 0
    ax, ay = ring[0]
    for (px, py), (qx, qy) in zip(ring, ring[1:] + ring[:1]):
        cross = (px - ax) * (qy - ay) - (qx - ax) * (py - ay)
        twice, x, y = twice + cross, x + cross * (px + qx - 2 * ax), y + cross * (py + qy - 2 * ay)
    return (ax + x / (3 * twice), ay + y / (3 * twice)) if twice else (ax, ay)


def contains(ring, p):
    inside = False
    for (ax, ay), (bx, by) in zip(ring, ring[1:] + ring[:1]):
        if (ay > p[1]) != (by > p[1]) and p[0] < ax + (bx - ax) * (p[1] - ay) / (by - ay):
            inside = not inside
    return inside


def near_ring(ring, p, most):
    for (ax, ay), (bx, by) in zip(ring, ring[1:] + ring[:1]):
        dx, dy = bx - ax, by - ay
        square = dx * dx + dy * dy
        t = 0 if square == 0 else max(0, min(1, ((p[0] - ax) * dx + (p[1] - ay) * dy) / square))
        x, y = p[0] - ax - t * dx, p[1] - ay - t * dy
        if x * x + y * y <= most * most:
            return True
    return False


class Grid:
    """Items by buckets of their boxes."""

    def __init__(self, side):
        self.side, self.buckets = side, collections.defaultdict(list)

    def cells(self, box):
        for x in range(math.floor(box[0] / self.side), math.floor(box[2] / self.side) + 1):
            for y in range(math.floor(box[1] / self.side), math.floor(box[3] / self.side) + 1):
                yield x, y

    def add(self, box, item):
        for cell in self.cells(box):
            self.buckets[cell].append(item)

    def about(self, box):
        seen = {}
        for cell in self.cells(box):
            for item in self.buckets.get(cell, ()):
                seen[id(item)] = item
        return seen.values()


def box_of(ring):
    xs, ys = [p[0] for p in ring], [p[1] for p in ring]
    return min(xs), min(ys), max(xs), max(ys)


def about(p, m):
    return p[0] - m, p[1] - m, p[0] + m, p[1] + m


def read_storeys(building, tags):
    """Sets levels and height_m, 0 where untagged."""
    levels = number(tags.get("building:levels"))
    height = number(tags.get("height") or tags.get("building:height"))
    building.levels = levels if levels and 0.5 <= levels <= 120 else 0
    building.height_m = height if height and 1.5 <= height <= 500 else 0


def building_of(place, group, tags, rings):
    b = Building()
    b.place, b.group, b.tags, b.ring, b.holes = place, group, tags, rings[0], rings[1:]
    b.cls = CLASS_OF.get(tags["building"], "kPlain")
    b.box, b.at = box_of(b.ring), centroid_of(b.ring)
    b.area = area_of(b.ring) - sum(map(area_of, b.holes))
    b.perimeter = sum(math.dist(p, q) for p, q in zip(b.ring, b.ring[1:] + b.ring[:1]))
    b.compact = 4 * math.pi * area_of(b.ring) / max(1e-9, b.perimeter ** 2)
    b.corners = len(b.ring)
    b.use, b.mates, b.has_shop = "kNoUse", [], tags.get("shop") not in (None, "no", "vacant")
    read_storeys(b, tags)
    return b


def read(folder, place):
    """The buildings of a place, with their surroundings."""
    path, group = PLACES[place]
    plane, buildings, uses, shops, streets = None, [], [], [], []
    for feature in exported(pathlib.Path(folder) / path):
        tags, kind, points = feature["properties"], feature["geometry"]["type"], feature["geometry"]["coordinates"]
        if plane is None:
            p = points
            while isinstance(p[0], list):
                p = p[0]
            plane = p[1], 111320 * math.cos(math.radians(p[1]))

        def flat(ring):
            return [(p[0] * plane[1], p[1] * 111320) for p in ring]
        if kind == "Point" and ("shop" in tags or tags.get("amenity") in SHOPS):
            shops.append(flat([points])[0])
        if kind == "LineString" and "highway" in tags:
            streets.append((tags["highway"], flat(points)))
        if kind not in ("Polygon", "MultiPolygon"):
            continue
        polygons = [points] if kind == "Polygon" else points
        for polygon in polygons:
            rings = [flat(ring)[:-1] for ring in polygon]
            if tags.get("building") not in (None, "no"):
                buildings.append(building_of(place, group, tags, rings))
            elif tags.get("landuse") in USES:
                uses.append((area_of(rings[0]), USES[tags["landuse"]], rings))
    buildings = [b for b in buildings if b.area > 4]
    set_surroundings(buildings, uses, shops)
    return buildings


def set_surroundings(buildings, uses, shops):
    grid, at, land, served = Grid(20), Grid(100), Grid(200), Grid(100)
    for b in buildings:
        grid.add(b.box, b)
        at.add(about(b.at, 0), b)
    for use in uses:
        land.add(box_of(use[2][0]), use)
    for shop in shops:
        served.add(about(shop, 0), shop)
    for b in buildings:
        for o in grid.about((b.box[0] - TOUCH_M, b.box[1] - TOUCH_M, b.box[2] + TOUCH_M, b.box[3] + TOUCH_M)):
            if o is not b and touch(b, o):
                b.mates.append(o)
        under = [u for u in land.about(about(b.at, 0)) if contains(u[2][0], b.at) and not any(contains(h, b.at) for h in u[2][1:])]
        if under:
            b.use = min(under, key=lambda u: u[0])[1]
        b.shops = sum(1 for s in served.about(about(b.at, AROUND_M)) if math.dist(s, b.at) <= AROUND_M)
        near = [o for o in at.about(about(b.at, AROUND_M)) if math.dist(o.at, b.at) <= AROUND_M]
        b.near_count = len(near)
        b.built = sum(o.area for o in near) / (math.pi * AROUND_M ** 2)
        close = [o.area for o in near if math.dist(o.at, b.at) <= AROUND_M / 2]
        b.built50 = sum(close) / (math.pi * (AROUND_M / 2) ** 2)
        b.mean_area = sum(o.area for o in near) / len(near)
        large = sorted(o.area for o in near if o.area >= 40)
        b.median_area = large[len(large) // 2] if large else b.area
        b.row_share = 0
        b.near = near
    for b in buildings:
        b.touching = min(3, len(b.mates))
        b.row_share = sum(1 for o in b.near if o.mates) / len(b.near)
        areas = sorted([b.area] + [o.area for o in b.mates if o.cls == b.cls])
        b.row_area = areas[len(areas) // 2]
        del b.near


def touch(a, b):
    """True if at least two corners of one lie on the other's border."""
    if a.box[0] > b.box[2] + TOUCH_M or b.box[0] > a.box[2] + TOUCH_M or a.box[1] > b.box[3] + TOUCH_M or b.box[1] > a.box[3] + TOUCH_M:
        return False
    on = 0
    for one, other in ((a, b), (b, a)):
        x0, y0, x1, y1 = other.box
        for p in one.ring:
            if x0 - TOUCH_M <= p[0] <= x1 + TOUCH_M and y0 - TOUCH_M <= p[1] <= y1 + TOUCH_M and near_ring(other.ring, p, TOUCH_M):
                on += 1
                if on == 2:
                    return True
    return False
