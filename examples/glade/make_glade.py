#!/usr/bin/env python3
"""Makes a glade as RPForest's default configuration (Rudzki 2020) has it: glade.osm, glade_heights.png and spec.json beside this file.

Terrain by diamond-square, spread 100 m, halved each time; twice as wide as there, since whole cells are compiled. A camera's place about 5 m high, 150 m from the edge. Honda's trees in two grids of cells of
3 m before it, 2 by 2 to the left and 2 by 5 to the right, and ferns in 4 by 6 cells of half a metre; each cell is planted with probability 0.8, within the inner
four fifths of it, 0.75 to 2.5 (ferns 0.8 to 1.2) times as high as its kind. Same file, same bytes: chance is a small generator of our own.
"""
import json
import math
import os
import struct
import zlib

HERE = os.path.dirname(os.path.abspath(__file__))
LON0, LAT0 = 17.03, 51.11
M_LAT, M_LON = 111250.0, 111320.0 * math.cos(math.radians(LAT0))
POWER, SIZE, FIRST, SPREAD, REDUCTION = 8, 600.0, 5.0, 100.0, 0.5
COUNT = 2**POWER + 1
STEP = SIZE / (COUNT - 1)
BASE, SCALE = 200.0, 0.01  # grey 0 lies so deep; metres a step of grey
TREE_M, FERN_M = 2.0, 0.5
ROOM_M = 60.0  # what is compiled, about the camera


class Chance:
    """A linear congruential generator (Knuth's MMIX constants)."""

    def __init__(self, seed):
        self.state = seed

    def unit(self):
        self.state = (self.state * 6364136223846793005 + 1442695040888963407) % 2**64
        return (self.state >> 33) / 2**31

    def between(self, low, high):
        return low + (high - low) * self.unit()


def diamond_square(chance):
    """Heights by row from the south, of COUNT by COUNT vertices."""
    h = [[0.0] * COUNT for _ in range(COUNT)]
    for r in (0, COUNT - 1):
        for c in (0, COUNT - 1):
            h[r][c] = FIRST
    side, spread = COUNT - 1, SPREAD
    while side > 1:
        half = side // 2
        for r in range(half, COUNT, side):
            for c in range(half, COUNT, side):
                corners = [h[r + i][c + j] for i in (-half, half) for j in (-half, half)]
                h[r][c] = sum(corners) / 4 + chance.between(-spread, spread)
        for r in range(0, COUNT, half):
            for c in range((r + half) % side, COUNT, side):
                beside = [h[r + i][c + j] for i, j in ((-half, 0), (half, 0), (0, -half), (0, half)) if 0 <= r + i < COUNT and 0 <= c + j < COUNT]
                h[r][c] = sum(beside) / len(beside) + chance.between(-spread, spread)
        side, spread = half, spread * REDUCTION
    return h


def place_of(r, c):
    return (c * STEP - SIZE / 2, r * STEP - SIZE / 2)


def camera_vertex(h):
    """The vertex nearest to 5 m high, 150 m and more from the edge, where the ground before it is most level."""
    edge = int(150 / STEP) + 1
    ahead = int(20 / STEP)
    inner = [(r, c) for r in range(edge, COUNT - edge) for c in range(edge, COUNT - edge)]

    def badness(rc):
        r, c = rc
        steep = sum(abs(h[r + i][c + j] - h[r][c]) for i in range(0, ahead, 2) for j in (-3, 0, 3))
        return abs(h[r][c] - 5) + 0.2 * steep

    return min(inner, key=badness)


def cells(chance, centre, columns, rows, cell_m, kind_m, low, high):
    """Places and heights of a grid's plants."""
    for i in range(columns):
        for j in range(rows):
            if chance.unit() >= 0.8:
                continue
            jitter = 0.8 * cell_m / 2
            x = centre[0] + (i - columns / 2 + 0.5) * cell_m + chance.between(-jitter, jitter)
            y = centre[1] + (j - rows / 2 + 0.5) * cell_m + chance.between(-jitter, jitter)
            yield (x, y), kind_m * chance.between(low, high)


def lonlat(p):
    return LON0 + p[0] / M_LON, LAT0 + p[1] / M_LAT


def write_osm(path, plants, centre):
    half = ROOM_M
    corners = [(centre[0] + x * half, centre[1] + y * half) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    (west, south), (east, north) = lonlat(corners[0]), lonlat(corners[2])
    lines = ['<?xml version="1.0" encoding="UTF-8"?>', '<osm version="0.6" generator="make_glade.py">',
             f' <bounds minlat="{south:.7f}" minlon="{west:.7f}" maxlat="{north:.7f}" maxlon="{east:.7f}"/>']
    for number, (p, height_m, tags) in enumerate(plants, 1):
        lon, lat = lonlat(p)
        lines.append(f' <node id="{number}" version="1" lat="{lat:.7f}" lon="{lon:.7f}">')
        lines += [f'  <tag k="{k}" v="{v}"/>' for k, v in sorted({**tags, "height": f"{height_m:.2f}"}.items())] + [" </node>"]
    ids = range(len(plants) + 1, len(plants) + 5)
    for number, p in zip(ids, corners):
        lon, lat = lonlat(p)
        lines.append(f' <node id="{number}" version="1" lat="{lat:.7f}" lon="{lon:.7f}"/>')
    lines += [' <way id="1" version="1">'] + [f'  <nd ref="{i}"/>' for i in (*ids, ids[0])] + ['  <tag k="natural" v="grassland"/>', " </way>", "</osm>"]
    with open(path, "w", encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n")


def write_heights(path, h):
    """Writes a 16-bit grey PNG, rows from the north; returns the options of its --dem argument."""
    raw = b"".join(b"\0" + struct.pack(f">{COUNT}H", *(min(65535, max(0, round((v + BASE) / SCALE))) for v in row)) for row in reversed(h))
    chunk = lambda kind, data: struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", COUNT, COUNT, 16, 0, 0, 0, 0)) + chunk(b"IDAT", zlib.compress(raw, 9)) + chunk(b"IEND", b""))
    half = (SIZE + STEP) / 2  # outer edges of the outer pixels
    (west, south), (east, north) = lonlat((-half, -half)), lonlat((half, half))
    return f"bounds={west:.7f}/{south:.7f}/{east:.7f}/{north:.7f},scale={SCALE},offset={-BASE:g}"


chance = Chance(2020)
heights = diamond_square(chance)
row, column = camera_vertex(heights)
x, y = place_of(row, column)
plants = []
for centre, columns, rows, cell_m, kind_m, low, high, tags in (
        ((x - 3, y + 5), 2, 2, 3.0, TREE_M, 0.75, 2.5, {"natural": "tree", "species": "Honda"}),
        ((x + 3.5, y + 8), 2, 5, 3.0, TREE_M, 0.75, 2.5, {"natural": "tree", "species": "Honda"}),
        ((x, y + 4), 4, 6, 0.5, FERN_M, 0.8, 1.2, {"natural": "tree", "species": "Dryopteris filix-mas"})):
    plants += [(p, height_m, tags) for p, height_m in cells(chance, centre, columns, rows, cell_m, kind_m, low, high)]
write_osm(os.path.join(HERE, "glade.osm"), plants, (x, y))
dem = write_heights(os.path.join(HERE, "glade_heights.png"), heights)
lon, lat = lonlat((x, y - 4))
with open(os.path.join(HERE, "spec.json"), "w", encoding="utf-8") as file:
    json.dump({"map": "examples/glade/glade.osm", "dem": f"examples/glade/glade_heights.png,{dem}", "time": "2020-07-01T14:00", "lods": "0.02"}, file, indent=2)
    file.write("\n")
eye_m = heights[row - round(4 / STEP)][column] + 1.7
print(f"eye {lon:.7f},{lat:.7f},{eye_m:.2f}; {sum('Honda' in t['species'] for _, _, t in plants)} trees, {len(plants)} plants")
ahead = heights[row + round(8 / STEP)][column]
print(f"look {lon:.7f},{lonlat((x, y + 8))[1]:.7f},{ahead + 1.5:.2f}")
