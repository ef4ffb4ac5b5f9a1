#!/usr/bin/env python3
"""Measures where streets have pavements, and prints the scores of compiler/assume/pavements.inc. By hand, needs osmium-tool and numpy:

    tests/bench/train_pavements.py [--cache | --lamps]

--cache keeps the facts of all sides in /tmp; --lamps prints spacings of mapped street lamps instead.

A side of a stretch of street (at most 256 m) counts as "there" if its tags give it a pavement or say that it is mapped separately, and as
"none" if they say no; silent sides are left out. The score of a side is the sum of rows: class of road, land use 20 m beside the axis, the
share of the side along which buildings stand within 40 m, what is mapped beside it. There is a pavement where the sum is above 0. A row is
the rounded weight of a logistic regression in which both kinds of sides count alike in each place. Errors are balanced: the mean of the
share of wrong sides among those that have a pavement and among those that have none; each place is left out in turn.
"""
import json
import math
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from collections import Counter, defaultdict
from pathlib import Path

import numpy as np

DATA = Path(__file__).resolve().parents[2].parent / "shared" / "data"
PLACES = {
    "Adlershof": "berlin-adlershof/adlershof.osm.gz",
    "Reinickendorf": "berlin/berlin-reinickendorf-2026.osm.pbf",
    "Boston": "boston-back-bay/back_bay.osm.pbf",
    "Chicago": "chicago-loop/chicago_loop.osm.pbf",
    "Portland": "portland/portland-central-filtered.osm.pbf",
    "Limerick": "limerick/limerick.osm.gz",
}
LAMP_PLACES = {**{name: PLACES[name] for name in ("Boston", "Adlershof", "Chicago", "Reinickendorf")}, "Helsinki": "helsinki/Helsinki.osm.pbf"}
STREETS = ("motorway", "trunk", "primary", "secondary", "tertiary", "unclassified", "residential", "living_street", "service")
PATHS = ("footway", "path", "pedestrian", "steps", "cycleway")
LAND_USES = {
    "landuse": {"residential": "residential", "commercial": "shops", "retail": "shops", "industrial": "industrial", "railway": "railway",
                "farmland": "fields", "meadow": "fields", "farmyard": "fields", "orchard": "fields", "vineyard": "fields", "grass": "green",
                "forest": "wood", "allotments": "green", "recreation_ground": "green", "cemetery": "green", "village_green": "green"},
    "leisure": {"park": "green", "garden": "green", "pitch": "green", "golf_course": "fields"},
    "natural": {"wood": "wood", "scrub": "wood", "water": "water", "grassland": "fields", "heath": "fields"},
    "amenity": {"school": "shops", "university": "shops", "hospital": "shops", "parking": "parking"},
}
LAND_NAMES = ["none", "residential", "shops", "industrial", "railway", "fields", "green", "wood", "water", "parking"]
STRETCH_M, EVERY_M, FRONT_M, BESIDE_M = 256, 8, 40, 30
MAPPED_FROM_M, MAPPED_TO_M = 2.5, 16


def read_osm(path):
    """The nodes (lon, lat), tagged nodes, ways (nodes, tags) and relations (ways, tags) of an extract."""
    text = subprocess.run(["osmium", "cat", str(path), "-f", "osm", "-o", "-"], stdout=subprocess.PIPE, check=True).stdout
    nodes, points, ways, relations = {}, [], {}, []
    for element in ElementTree.fromstring(text):
        tags = {tag.get("k"): tag.get("v") for tag in element.findall("tag")}
        if element.tag == "node" and element.get("lon"):
            nodes[element.get("id")] = (float(element.get("lon")), float(element.get("lat")))
            if tags:
                points.append((element.get("id"), tags))
        elif element.tag == "way":
            ways[element.get("id")] = ([node.get("ref") for node in element.findall("nd")], tags)
        elif element.tag == "relation":
            relations.append(([(m.get("ref"), m.get("role")) for m in element.findall("member") if m.get("type") == "way"], tags))
    return nodes, points, ways, relations


def joined_rings(lines):
    """Closed rings of lines that are joined at equal ends."""
    rings, lines = [], [list(line) for line in lines if len(line) > 1]
    while lines:
        ring = lines.pop()
        while ring[0] != ring[-1]:
            at = next((i for i, line in enumerate(lines) if ring[-1] in (line[0], line[-1])), None)
            if at is None:
                break
            line = lines.pop(at)
            ring += (line if line[0] == ring[-1] else line[::-1])[1:]
        if ring[0] == ring[-1] and len(ring) > 3:
            rings.append(ring)
    return rings


class Raster:
    """A grid of one value a square metre."""

    def __init__(self, least, most, kind=np.uint8):
        self.least = np.floor(least)
        size = np.ceil(most - self.least).astype(int) + 1
        self.values = np.zeros((size[1], size[0]), kind)

    def fill(self, ring, value):
        ring = np.asarray(ring) - self.least
        for y in range(max(0, math.floor(ring[:, 1].min())), min(self.values.shape[0], math.ceil(ring[:, 1].max()) + 1)):
            a, b = ring[:-1], ring[1:]
            cuts = (a[:, 1] <= y + 0.5) != (b[:, 1] <= y + 0.5)
            xs = np.sort(a[cuts, 0] + (b[cuts, 0] - a[cuts, 0]) * (y + 0.5 - a[cuts, 1]) / (b[cuts, 1] - a[cuts, 1]))
            for left, right in zip(xs[::2], xs[1::2]):
                self.values[y, max(0, round(left)):max(0, round(right))] = value

    def draw(self, line, value):
        for a, b in zip(line[:-1], line[1:]):
            t = np.linspace(0, 1, max(2, int(np.hypot(*(b - a)) * 2)))[:, None]
            x, y = np.floor(a + (b - a) * t - self.least).astype(int).T
            inside = (x >= 0) & (y >= 0) & (x < self.values.shape[1]) & (y < self.values.shape[0])
            self.values[y[inside], x[inside]] = value

    def at(self, points):
        x, y = np.floor(points - self.least).astype(int).T
        inside = (x >= 0) & (y >= 0) & (x < self.values.shape[1]) & (y < self.values.shape[0])
        return np.where(inside, self.values[np.clip(y, 0, self.values.shape[0] - 1), np.clip(x, 0, self.values.shape[1] - 1)], 0)


def tagged_side(tags, side):
    """True, False or None (silent) for a pavement on a side: "left" or "right"."""
    for key in (f"sidewalk:{side}", "sidewalk:both"):
        if key in tags:
            return tags[key] in ("yes", "separate", "both", side)
    value = tags.get("sidewalk")
    if value is None:
        return None
    return value in ("both", "yes", "separate", side)


def land_use(tags):
    return next((values[tags[key]] for key, values in LAND_USES.items() if tags.get(key) in values), None)


class Place:
    def __init__(self, path, has_rasters=True):
        self.osm_nodes, self.points, self.ways, relations = read_osm(path)
        at = np.array(list(self.osm_nodes.values()))
        middle = np.median(at, axis=0)
        scale = np.array([111320 * math.cos(math.radians(middle[1])), 110950])
        self.middle, self.scale = middle, scale
        near = {k: (np.array(v) - middle) * scale for k, v in self.osm_nodes.items()}
        self.nodes = {k: v for k, v in near.items() if np.abs(v).max() < 4000}
        self.streets = {way_id: (self.line_of(refs), tags) for way_id, (refs, tags) in self.ways.items()
                        if tags.get("highway", "").removesuffix("_link") in STREETS and len(self.line_of(refs)) > 1}
        if has_rasters:
            self.draw(relations)

    def draw(self, relations):
        used = np.array(list(self.nodes.values()))
        least, most = used.min(axis=0) - 50, used.max(axis=0) + 50
        self.land, self.houses, self.paths = (Raster(least, most) for _ in range(3))
        self.roads = Raster(least, most, np.int32)
        areas = []
        for refs, tags in self.ways.values():
            line = self.line_of(refs)
            if len(line) < 2:
                continue
            kind = land_use(tags)
            if refs[0] == refs[-1] and len(line) > 3:
                if kind:
                    areas.append((line, kind))
                if "building" in tags:
                    self.houses.fill(line, 1)
            if tags.get("highway") in PATHS and tags.get("footway") not in ("crossing", "traffic_island"):
                self.paths.draw(line, 1)
        for members, tags in relations:
            kind = land_use(tags)
            if kind or "building" in tags:
                for ring in joined_rings([self.ways[ref][0] for ref, role in members if role != "inner" and ref in self.ways]):
                    line = self.line_of(ring)
                    if len(line) > 3:
                        areas.append((line, kind)) if kind else self.houses.fill(line, 1)
        box = lambda line: np.prod(line.max(axis=0) - line.min(axis=0))
        for line, kind in sorted(areas, key=lambda area: -box(area[0])):
            self.land.fill(line, LAND_NAMES.index(kind))
        for way_id, (line, _) in self.streets.items():
            self.roads.draw(line, int(way_id) % 1000003 + 1)
        self.direction = {int(w) % 1000003 + 1: (line, tags) for w, (line, tags) in self.streets.items()}

    def line_of(self, refs):
        return np.array([self.nodes[ref] for ref in refs if ref in self.nodes]).reshape(-1, 2)


def stretches_of(line):
    """The line cut at vertices to at most 256 m where it is longer than 512 m."""
    lengths = np.hypot(*np.diff(line, axis=0).T)
    if lengths.sum() <= 2 * STRETCH_M:
        return [line]
    pieces, start, sum_m = [], 0, 0
    for i, length in enumerate(lengths):
        if sum_m > 0 and sum_m + length > STRETCH_M:
            pieces.append(line[start:i + 1])
            start, sum_m = i, 0
        sum_m += length
    return pieces + [line[start:]]


def samples_of(line):
    """Points every 8 m and the unit direction at each."""
    points, along = [], []
    for a, b in zip(line[:-1], line[1:]):
        length = np.hypot(*(b - a))
        for k in range(max(1, round(length / EVERY_M))):
            points.append(a + (b - a) * (k + 0.5) / max(1, round(length / EVERY_M)))
            along.append((b - a) / max(length, 1e-9))
    return np.array(points), np.array(along)


def is_inner(place, line, tags, way_number, points, along, out):
    """The share of the side along which a one-way street runs the other way within 30 m."""
    if tags.get("oneway") not in ("yes", "-1") and tags.get("junction") != "roundabout":
        return 0
    seen = np.zeros(len(points), bool)
    for off in np.arange(3, BESIDE_M, 0.7):
        ids = place.roads.at(points + out * off)
        for k in np.flatnonzero((ids != 0) & (ids != way_number) & ~seen):
            other, other_tags = place.direction.get(ids[k], (None, {}))
            if other is None or other_tags.get("oneway") != "yes" or other_tags.get("highway", "").endswith("_link"):
                continue
            middles = (other[1:] + other[:-1]) / 2
            nearest = np.argmin(np.hypot(*(middles - points[k]).T))
            step = other[nearest + 1] - other[nearest]
            if step @ along[k] < -0.8 * np.hypot(*step):
                seen[k] = True
    return seen.mean()


def sides_of(place):
    """A row of facts for each side of each stretch that is on the ground."""
    for way_id, (line, tags) in place.streets.items():
        if any(tags.get(key, "no") != "no" for key in ("bridge", "tunnel", "covered")) or tags.get("area") == "yes":
            continue
        number = int(way_id) % 1000003 + 1
        for piece in stretches_of(line):
            points, along = samples_of(piece)
            left = np.stack([-along[:, 1], along[:, 0]], axis=1)
            for side, out in (("left", left), ("right", -left)):
                offsets = np.arange(MAPPED_FROM_M, MAPPED_TO_M, 0.5)
                # a path that crosses is seen by few samples
                mapped = np.any([place.paths.at(points + out * off) for off in offsets], axis=0).mean()
                front = np.any([place.houses.at(points + out * off) for off in np.arange(2, FRONT_M, 1)], axis=0).mean()
                lands = Counter(place.land.at(points + out * 20).tolist())
                yield {
                    "way": way_id, "tags": tags, "side": side, "length": np.hypot(*np.diff(piece, axis=0).T).sum(),
                    "there": tagged_side(tags, side), "class": tags["highway"].removesuffix("_link"),
                    "link": tags["highway"].endswith("_link"), "mapped": mapped, "front": front,
                    "land": LAND_NAMES[lands.most_common(1)[0][0]],
                    "inner": is_inner(place, piece, tags, number, points, along, out), "at": points.mean(axis=0),
                    "oneway": tags.get("oneway") in ("yes", "-1"), "roundabout": tags.get("junction") in ("roundabout", "circular"),
                }


def main_kind(row):
    kind = row["class"]
    if kind == "service":
        return "service=" + row["tags"].get("service", "-") if row["tags"].get("service") in ("driveway", "parking_aisle", "alley") else "service"
    return kind


FEATURES = ["motorway", "trunk", "primary", "secondary", "tertiary", "unclassified", "residential", "living_street", "service",
            "service=driveway", "service=parking_aisle", "service=alley", "link", "inner", "one-way",
            "one-way inside, houses", "one-way inside, none", "roundabout inside", "mapped",
            "front < 10 %", "front > 40 %"] + [f"land {name}" for name in LAND_NAMES[1:]]


def facts(row):
    drives_left = row.get("drives_left", False)
    inside = "right" if drives_left else "left"
    is_inside = row["oneway"] and row["side"] == inside
    is_street = row["inner"] <= 0.25 and row["front"] > 0.6  # between houses, not one carriageway of two
    held = {main_kind(row), f"land {row['land']}"}
    for name, holds in (("link", row["link"]), ("inner", row["inner"] > 0.25), ("one-way", row["oneway"]),
                        ("one-way inside, houses", is_inside and is_street), ("one-way inside, none", is_inside and not is_street), ("roundabout inside", row["roundabout"] and row["side"] == inside),
                        ("mapped", row["mapped"] > 0.5), ("front < 10 %", row["front"] < 0.1), ("front > 40 %", row["front"] > 0.4)):
        if holds:
            held.add(name)
    return np.array([name in held for name in FEATURES], float)


def fit(rows, weights, steps=12, ridge=0.003):
    """The weights of a logistic regression, by Newton's method."""
    x, y = np.array([facts(r) for r in rows]), np.array([r["there"] for r in rows], float)
    share, w = weights / weights.sum(), np.zeros(x.shape[1])
    for _ in range(steps):
        p = 1 / (1 + np.exp(-x @ w))
        slope = x.T @ ((y - p) * share) - ridge * w
        w += np.linalg.solve((x * (p * (1 - p) * share)[:, None]).T @ x + ridge * np.eye(len(w)), slope)
    return w


def balanced(rows):
    """Weights with which both kinds of sides, and all places, count alike; long stretches count more."""
    sums = defaultdict(float)
    for r in rows:
        sums[r["place"], r["there"]] += r["length"]
    return np.array([r["length"] / sums[r["place"], r["there"]] for r in rows])


def error_of(rows, guesses):
    wrong, all_m = defaultdict(float), defaultdict(float)
    for r, guess in zip(rows, guesses):
        all_m[r["there"]] += 1
        wrong[r["there"]] += guess != r["there"]
    return tuple(wrong[k] / max(1, all_m[k]) for k in (True, False))


def by_class(train, rows):
    there = defaultdict(list)
    for r in train:
        there[main_kind(r)].append(r["there"])
    return [np.mean(there.get(main_kind(r), [1])) >= 0.5 for r in rows]


def by_neighbours(rows):
    """Blocks left out: the majority of sides of other ways whose middles lie 128 to 512 m away."""
    at = np.array([r["at"] for r in rows])
    there = np.array([r["there"] for r in rows])
    guesses = []
    for r in rows:
        away = np.hypot(*(at - r["at"]).T)
        near = (away > 64) & (away < 512)
        guesses.append(there[near].mean() >= 0.5 if near.any() else True)
    return guesses


def scored(rows, w):
    return [facts(r) @ w > 0 for r in rows]


def show(name, rows, guesses):
    yes, no = error_of(rows, guesses)
    print(f"  {name:24} balanced error {100 * (yes + no) / 2:5.1f} %   there {100 * yes:5.1f} %   none {100 * no:5.1f} %")


LIT_WITHIN_M, LONG_M = 16, 80


def lamps_beside(place, line, lamps):
    """For each mapped lamp beside a line: the distance along it and the offset to the left."""
    found, along_m = [], 0
    for a, b in zip(line[:-1], line[1:]):
        length = np.hypot(*(b - a))
        unit = (b - a) / max(length, 1e-9)
        near = lamps - a
        t, off = near @ unit, near @ np.array([-unit[1], unit[0]])
        for k in np.flatnonzero((t >= 0) & (t < length) & (np.abs(off) < LIT_WITHIN_M)):
            found.append((along_m + t[k], off[k]))
        along_m += length
    return sorted(found), along_m


def print_lamps():
    """Mapped lamps along ways of 80 m or more that have at least three: lamps a kilometre, median spacing, sides, offset from the axis; and
    which streets are tagged as lit."""
    for name, path in LAMP_PLACES.items():
        place = Place(DATA / path, has_rasters=False)
        lamps = np.array([place.nodes[ref] for ref, tags in place.points if tags.get("highway") == "street_lamp" and ref in place.nodes])
        print(f"{name}: {len(lamps)} lamps, {len(place.streets)} streets")
        by_class, lit = defaultdict(list), defaultdict(Counter)
        for line, tags in place.streets.values():
            kind = tags["highway"]
            lit[kind][tags.get("lit", "silent") if tags.get("lit") in (None, "yes", "no") else "yes"] += 1
            found, long_m = lamps_beside(place, line, lamps) if len(lamps) else ([], 0)
            if long_m >= LONG_M and len(found) >= 3:
                gaps = np.diff([along for along, _ in found])
                lefts = sum(off > 0 for _, off in found) / len(found)
                by_class[kind].append((long_m, len(found), np.median(gaps[gaps > 4]) if (gaps > 4).any() else 0, min(lefts, 1 - lefts),
                                       np.median([abs(off) for _, off in found])))
        for kind, ways in sorted(by_class.items()):
            w = np.array(ways)
            print(f"  {kind:14} {len(ways):3} ways  {1000 * w[:, 1].sum() / w[:, 0].sum():5.1f} lamps a km  spacing {np.median(w[:, 2]):5.1f} m  "
                  f"on the lesser side {100 * np.median(w[:, 3]):3.0f} %  from the axis {np.median(w[:, 4]):4.1f} m")
        print("  lit:", {kind: dict(counts) for kind, counts in lit.items()})


def main():
    if "--lamps" in sys.argv:
        return print_lamps()
    cache = Path("/tmp/train_pavements.json") if "--cache" in sys.argv else None
    if cache and cache.exists():
        rows = json.loads(cache.read_text())
        for r in rows:
            r["at"] = np.array(r["at"])
    else:
        rows = []
        for name, path in PLACES.items():
            print(name, flush=True)
            for row in sides_of(Place(DATA / path)):
                rows.append({**row, "place": name, "drives_left": name == "Limerick"})
        if cache:
            cache.write_text(json.dumps([{**r, "at": list(r["at"])} for r in rows], default=float))
    silent = [r for r in rows if r["there"] is None]
    rows = [{**r, "there": bool(r["there"])} for r in rows if r["there"] is not None]
    print(f"{len(rows)} tagged sides, {len(silent)} silent ones")
    for name in PLACES:
        train, test = [r for r in rows if r["place"] != name], [r for r in rows if r["place"] == name]
        print(f"{name}: {len(test)} sides, {sum(r['there'] for r in test)} there")
        w = np.round(4 * fit(train, balanced(train))) / 4
        show("constant by class", test, by_class(train, test))
        show("majority of neighbours", test, by_neighbours(test))
        show("scores", test, scored(test, w))
    w = fit(rows, balanced(rows))
    counts = np.array([facts(r) for r in rows]).sum(axis=0)
    print("rows of the table")
    for name, weight, count in zip(FEATURES, w, counts):
        print(f"  {name:24} {weight:+.2f}  {int(count)} sides")


if __name__ == "__main__":
    main()
