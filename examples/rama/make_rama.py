#!/usr/bin/env python3
"""Makes a small Rama: map.osm and heights.png in a folder, to be compiled with --world cylinder:R (see README.md).

x runs along the axis, y around it, in metres; the map is as long along y as the cylinder of 978 m is around, so that its south meets its north.
A sea in the middle, with low and high cliffs, and an island of towers; towns, fields, hedges and woods on the plains on either side. Same file,
same bytes: chance is a small generator of our own.
"""
import math
import struct
import sys
import zlib
from pathlib import Path

LON0, LAT0 = 11.0, 47.5
SINE = math.sin(math.radians(LAT0))
# metres of a degree on the WGS84 ellipsoid
M_LAT = math.radians(1) * 6378137 * (1 - 0.00669438) / (1 - 0.00669438 * SINE**2) ** 1.5
M_LON = math.radians(1) * 6378137 * math.cos(math.radians(LAT0)) / math.sqrt(1 - 0.00669438 * SINE**2)
HALF_X, AROUND = 1280, 6144
HALF_Y = AROUND // 2
SEA_WEST, SEA_EAST = -170, 190
STEP = 8.0
SEA_LEVEL, EAST_PLAIN, WEST_PLAIN = 4.0, 12.0, 46.0


class Chance:
    """A linear congruential generator (Knuth's MMIX constants)."""

    def __init__(self, seed):
        self.state = seed

    def unit(self):
        self.state = (self.state * 6364136223846793005 + 1442695040888963407) % 2**64
        return (self.state >> 33) / 2**31

    def between(self, low, high):
        return low + (high - low) * self.unit()

    def pick(self, items):
        return items[int(self.unit() * len(items))]


chance = Chance(1973)


# ---- heights: the same at both ends of y ----
def rolling(x, y):
    """Gentle hills, whole periods around the cylinder."""
    turn = 2 * math.pi * y / AROUND
    return 3.5 * math.sin(3 * turn + x / 310) + 2.5 * math.sin(7 * turn - x / 190) + 1.5 * math.cos(12 * turn + x / 120)


def shore(y, seed):
    """How far a shore swings, in metres along x."""
    turn = 2 * math.pi * y / AROUND
    return 22 * math.sin(5 * turn + seed) + 12 * math.sin(11 * turn + 2 * seed) + 5 * math.sin(23 * turn + 3 * seed)


ISLAND = (10.0, 300.0, 95.0, 330.0)  # middle x, y, half extents


def on_island(x, y, grow=0.0):
    cx, cy, rx, ry = ISLAND
    return ((x - cx) / (rx + grow)) ** 4 + ((y - cy) / (ry + grow)) ** 4 < 1


def height(x, y):
    west, east = SEA_WEST + shore(y, 1.0), SEA_EAST + shore(y, 4.0)
    hills = rolling(x, y)
    if on_island(x, y):
        return SEA_LEVEL + 4.0
    if x < west:
        return SEA_LEVEL + (WEST_PLAIN - SEA_LEVEL) * min(1.0, (west - x) / 14) + hills * min(1.0, (west - x) / 120)
    if x > east:
        return SEA_LEVEL + (EAST_PLAIN - SEA_LEVEL) * min(1.0, (x - east) / 10) + hills * min(1.0, (x - east) / 120)
    return SEA_LEVEL - 3.0


def png_of(rows):
    """16 bits, decimetres above -100 m."""
    raw = b"".join(b"\0" + b"".join(struct.pack(">H", round((v + 100) * 100)) for v in row) for row in rows)

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 16, 0, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(raw, 9)) + chunk(b"IEND", b"")


# ---- the map ----
nodes, ways = [], []
node_at = {}


def node(x, y):
    key = (round(x, 2), round(y, 2))
    if key not in node_at:
        nodes.append(key)
        node_at[key] = len(nodes)
    return node_at[key]


def way(points, **tags):
    ways.append(([node(*p) for p in points], tags))


def area(ring, **tags):
    way([*ring, ring[0]], **tags)


def box(x0, y0, x1, y1):
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


def lie_apart(box_a, others, gap):
    return all(box_a[0] > b[2] + gap or b[0] > box_a[2] + gap or box_a[1] > b[3] + gap or b[1] > box_a[3] + gap for b in others)


def sea():
    step = 24
    west = [(SEA_WEST + shore(y, 1.0), y) for y in range(-HALF_Y, HALF_Y + 1, step)]
    east = [(SEA_EAST + shore(y, 4.0), y) for y in range(-HALF_Y, HALF_Y + 1, step)]
    cx, cy, rx, ry = ISLAND
    turns = [2 * math.pi * i / 64 for i in range(64)]
    coast = [(cx + rx * math.copysign(abs(math.cos(t)) ** 0.5, math.cos(t)),
              cy + ry * math.copysign(abs(math.sin(t)) ** 0.5, math.sin(t))) for t in turns]
    outer = [node(*p) for p in [*west, *reversed(east), west[0]]]
    inner = [node(*p) for p in [*coast, coast[0]]]
    ways.append((outer, {}))
    ways.append((inner, {}))
    return f'<relation id="1" version="1"><member type="way" ref="{len(ways) - 1}" role="outer"/><member type="way" ref="{len(ways)}" role="inner"/>' \
           '<tag k="type" v="multipolygon"/><tag k="natural" v="water"/><tag k="water" v="lake"/><tag k="name" v="Cylindrical Sea"/></relation>'


def island():
    """The towers of New York, denser and higher in the middle."""
    cx, cy, rx, ry = ISLAND
    area(box(cx - rx + 12, cy - ry + 20, cx + rx - 12, cy + ry - 20), landuse="commercial")
    xs = [cx - 66, cx - 22, cx + 22, cx + 66]
    ys = [cy - 280 + 70 * i for i in range(9)]
    for x in xs:
        way([(x, y) for y in ys], highway="residential", surface="asphalt", lit="yes")
    for y in ys:
        way([(x, y) for x in xs], highway="residential", surface="asphalt", lit="yes")
    for x0, x1 in zip(xs, xs[1:]):
        for y0, y1 in zip(ys, ys[1:]):
            middle = 1 - abs((y0 + y1) / 2 - cy) / ry
            levels = int(4 + middle * middle * chance.between(12, 46))
            inset = chance.between(7, 9)
            if chance.unit() < 0.4:
                half = (y0 + y1) / 2
                area(box(x0 + inset, y0 + inset, x1 - inset, half - 2), building="office", **{"building:levels": str(levels)})
                area(box(x0 + inset, half + 2, x1 - inset, y1 - inset), building="office",
                     **{"building:levels": str(max(3, levels // 2))})
            else:
                area(box(x0 + inset, y0 + inset, x1 - inset, y1 - inset), building="office", **{"building:levels": str(levels)})


def town(cx, cy, size, name):
    """A grid of streets, houses along them, a church on its square."""
    area(box(cx - size - 30, cy - size - 30, cx + size + 30, cy + size + 30), landuse="residential", name=name)
    lines = [-size + 2 * size * i / round(2 * size / 64) for i in range(round(2 * size / 64) + 1)]
    for a in lines:
        kind = "secondary" if abs(a) < 1 else "residential"
        way([(cx + a, cy + b) for b in lines], highway=kind, lit="yes", surface="asphalt")
        way([(cx + b, cy + a) for b in lines], highway=kind, lit="yes", surface="asphalt")
    middle = min(range(len(lines) - 1), key=lambda i: abs(lines[i] + lines[i + 1]))
    for i, (x0, x1) in enumerate(zip(lines, lines[1:])):
        for j, (y0, y1) in enumerate(zip(lines, lines[1:])):
            block(cx + x0, cy + y0, cx + x1, cy + y1, i == middle and j == middle, math.hypot(x0 + x1, y0 + y1) / 2 / size)


def block(x0, y0, x1, y1, is_square, away):
    if is_square:
        area(box(x0 + 7, y0 + 7, x1 - 7, y1 - 7), highway="pedestrian", area="yes", surface="paving_stones")
        area(box(x0 + 18, y0 + 22, x1 - 18, y1 - 22), building="church", height="19", **{"roof:shape": "gabled", "roof:height": "7"})
        return
    if chance.unit() < 0.1:
        area(box(x0 + 7, y0 + 7, x1 - 7, y1 - 7), leisure="park")
        return
    levels = 4 if away < 0.35 else 3 if away < 0.6 else 2
    roof = {"roof:shape": "gabled"} if levels < 4 or chance.unit() < 0.7 else {"roof:shape": "flat"}
    for y_front in (y0 + 9, y1 - 9):
        x = x0 + 10
        while x < x1 - 18:
            width, depth = chance.between(9, 14), chance.between(9, 12)
            low, high = (y_front, y_front + depth) if y_front < (y0 + y1) / 2 else (y_front - depth, y_front)
            if x + width < x1 - 8:
                area(box(x, low, x + width, high), building="apartments" if levels > 2 else "house",
                     **{"building:levels": str(levels - (chance.unit() < 0.3))}, **roof)
            x += width + (0.0 if levels > 3 else chance.between(3, 7))


def plains(town_boxes):
    """Fields with hedges, meadows and woods in a patchwork that leaves the towns free."""
    for side in (-1, 1):
        columns = [(x, x + 128) for x in (range(260, HALF_X - 140, 136) if side > 0 else range(-HALF_X + 12, -330, 136))]
        for x0, x1 in columns:
            y = -HALF_Y + 10
            while y < HALF_Y - 60:
                length = chance.between(90, 210)
                ring = (x0, y, x1, min(y + length, HALF_Y - 10))
                if lie_apart(ring, town_boxes, 12):
                    patch(ring)
                y += length + 8


def patch(ring):
    kind = chance.unit()
    x0, y0, x1, y1 = ring
    corners = box(x0, y0, x1, y1)
    if kind < 0.5:
        area(corners, landuse="farmland", crop=chance.pick(["wheat", "maize", "rape", "barley"]))
    elif kind < 0.74:
        area(corners, landuse="meadow")
    elif kind < 0.82:
        area(corners, landuse="orchard")
    else:
        area(corners, landuse="forest", leaf_type=chance.pick(["broadleaved", "mixed", "needleleaved"]))
        return
    if chance.unit() < 0.5:
        way([(x0 - 2, y0 - 2), (x0 - 2, y1 + 2)], barrier="hedge", height="1.8")
    if chance.unit() < 0.35:
        way([(x0 - 2, y1 + 2), (x1 + 2, y1 + 2)], natural="tree_row")


TOWNS = [(620, 0, 192, "Paris"), (700, 1900, 160, "Rome"), (640, -1850, 160, "Peking"), (760, 2950 - 140, 96, "London"), (-620, 900, 160, "Tokyo"),
         (-700, -1100, 192, "Moscow"), (-640, -2500, 128, "Cairo")]


def main_roads():
    """Roads all around, one on either plain, that the towns' main streets join."""
    for x in (620 + 320, -620 - 300):
        way([(x, y) for y in range(-HALF_Y, HALF_Y + 1, 128)], highway="primary", lanes="2", surface="asphalt")
    for cx, cy, size, _ in TOWNS:
        ring_x = 940 if cx > 0 else -920
        end = cx + size if abs(ring_x) > abs(cx + size) and cx > 0 else cx - size
        if abs(ring_x - end) > 30:
            way([(end, cy), ((end + ring_x) / 2, cy), (ring_x, round(cy / 128) * 128)], highway="secondary", surface="asphalt")


def box_deg(half_x, half_y):
    return (LON0 - half_x / M_LON, LAT0 - half_y / M_LAT, LON0 + half_x / M_LON, LAT0 + half_y / M_LAT)


def xml_of(relation):
    def tagged(tags):
        return "".join(f'<tag k="{key}" v="{value}"/>' for key, value in tags.items())

    bounds = box_deg(HALF_X - 4, HALF_Y - 4)  # compile takes whole cells of 128 m
    lines = ['<?xml version="1.0" encoding="UTF-8"?>', '<osm version="0.6" generator="make_rama.py">',
             '<bounds minlon="{:.7f}" minlat="{:.7f}" maxlon="{:.7f}" maxlat="{:.7f}"/>'.format(*bounds)]
    lines += [f'<node id="{i + 1}" version="1" lon="{LON0 + x / M_LON:.8f}" lat="{LAT0 + y / M_LAT:.8f}"/>' for i, (x, y) in enumerate(nodes)]
    for i, (refs, tags) in enumerate(ways):
        lines.append(f'<way id="{i + 1}" version="1">' + "".join(f'<nd ref="{n}"/>' for n in refs) + tagged(tags) + "</way>")
    return "\n".join([*lines, relation, "</osm>", ""])


def main(folder):
    relation = sea()
    island()
    for place in TOWNS:
        town(*place)
    main_roads()
    plains([(cx - size - 40, cy - size - 40, cx + size + 40, cy + size + 40) for cx, cy, size, _ in TOWNS] +
           [(925, -HALF_Y, 955, HALF_Y), (-935, -HALF_Y, -905, HALF_Y)])
    out = Path(folder)
    out.mkdir(parents=True, exist_ok=True)
    (out / "map.osm").write_text(xml_of(relation))
    margin = 64
    columns, rows = int((2 * HALF_X + 2 * margin) / STEP) + 1, int((2 * HALF_Y + 2 * margin) / STEP) + 1
    grid = [[height(-HALF_X - margin + c * STEP, HALF_Y + margin - r * STEP) for c in range(columns)] for r in range(rows)]
    (out / "heights.png").write_bytes(png_of(grid))
    bounds = box_deg(HALF_X + margin + STEP / 2, HALF_Y + margin + STEP / 2)
    print(f"{out}/heights.png,bounds=" + "/".join(f"{v:.7f}" for v in bounds) + ",scale=0.01,offset=-100")


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else "out/rama_map")
