#!/usr/bin/env python3
"""Makes Tonbrenn, a town that does not exist: town.osm and town_heights.png beside this file.

Streets, river, lake and land use are drawn by hand below, in metres east and north of the market's meridian; houses are set along the streets
by rule, wherever they touch nothing. Same file, same bytes: chance is a small generator of our own.
"""
import math
import os
import struct
import zlib

HERE = os.path.dirname(os.path.abspath(__file__))
LON0, LAT0 = 12.30, 48.70
M_LAT, M_LON = 111200.0, 111320.0 * math.cos(math.radians(LAT0))
WEST, SOUTH, EAST, NORTH = -640.0, -512.0, 640.0, 512.0
HEIGHT_STEP, HEIGHT_MARGIN = 10.0, 300.0


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


chance = Chance(48)


# ---- plane geometry ----
def along(a, b, t):
    return (a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t)


def distance(a, b):
    return math.hypot(a[0] - b[0], a[1] - b[1])


def distance_to_segment(p, a, b):
    length2 = (b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2
    t = 0 if length2 == 0 else max(0, min(1, ((p[0] - a[0]) * (b[0] - a[0]) + (p[1] - a[1]) * (b[1] - a[1])) / length2))
    return distance(p, along(a, b, t))


def distance_to_line(p, line):
    return min(distance_to_segment(p, a, b) for a, b in zip(line, line[1:]))


def crossing(a, b, c, d):
    det = (b[0] - a[0]) * (d[1] - c[1]) - (b[1] - a[1]) * (d[0] - c[0])
    if abs(det) < 1e-9:
        return None
    t = ((c[0] - a[0]) * (d[1] - c[1]) - (c[1] - a[1]) * (d[0] - c[0])) / det
    u = ((c[0] - a[0]) * (b[1] - a[1]) - (c[1] - a[1]) * (b[0] - a[0])) / det
    return t if 0 <= t <= 1 and 0 <= u <= 1 else None


def inside(p, ring):
    odd = False
    for a, b in zip(ring, ring[1:] + ring[:1]):
        if (a[1] > p[1]) != (b[1] > p[1]) and p[0] < (b[0] - a[0]) * (p[1] - a[1]) / (b[1] - a[1]) + a[0]:
            odd = not odd
    return odd


def smooth(points, rounds=2):
    """Chaikin's corner cutting; the ends stay."""
    for _ in range(rounds):
        finer = [points[0]]
        for a, b in zip(points, points[1:]):
            finer += [along(a, b, 0.25), along(a, b, 0.75)]
        points = finer + [points[-1]]
    return points


def circle(centre, radius, count, turn=0.0, squash=1.0):
    return [(centre[0] + radius * math.cos(2 * math.pi * (i + turn) / count), centre[1] + squash * radius * math.sin(2 * math.pi * (i + turn) / count))
            for i in range(count)]


# ---- the land ----
RIVER = smooth([(760, 120), (600, 85), (420, 60), (250, -12), (60, -32), (-120, 8), (-260, -30), (-390, -105), (-470, -165)], 2)
LAKE_CENTRE, LAKE_LEVEL = (-545, -265), 372.0
LAKE = [(LAKE_CENTRE[0] + r * math.cos(a), LAKE_CENTRE[1] + 0.72 * r * math.sin(a))
        for a, r in ((2 * math.pi * i / 36, 205 + 24 * math.sin(3 * 2 * math.pi * i / 36) + 14 * math.cos(5 * 2 * math.pi * i / 36 + 1)) for i in range(36))]
KNOLL = (-255, 345)
MARKET = (-40, 165)


def height(x, y):
    """Metres: a valley falling westwards to the lake, wooded hills in the north, low ones in the south, a knoll for the castle."""
    d = distance_to_line((x, y), RIVER)
    z = LAKE_LEVEL + 0.4 + max(0.0, x + 470) * 0.0055 + 0.012 * max(0.0, d - 14) + 0.00004 * max(0.0, d - 60) ** 2
    z += 120 * math.exp(-(((x - 60) / 620) ** 2 + ((y - 1000) / 330) ** 2)) + 70 * math.exp(-(((x + 620) / 330) ** 2 + ((y - 760) / 260) ** 2))
    z += 46 * math.exp(-(((x - 420) / 480) ** 2 + ((y + 860) / 240) ** 2))
    z += 34 * math.exp(-(((x - KNOLL[0]) / 75) ** 2 + ((y - KNOLL[1]) / 62) ** 2))
    shore = math.hypot(x - LAKE_CENTRE[0], (y - LAKE_CENTRE[1]) / 0.72) - 245
    blend = max(0.0, min(1.0, shore / 110))
    blend = blend * blend * (3 - 2 * blend)
    return LAKE_LEVEL + (z - LAKE_LEVEL) * blend


# ---- streets: name, tags, points, style of the houses along them (None: none) ----
ring_r = [(MARKET[0] + 118 * math.cos(a) * (1 + 0.06 * math.sin(2 * a + 1)), MARKET[1] + 104 * math.sin(a) * (1 + 0.05 * math.cos(3 * a)))
          for a in (2 * math.pi * i / 20 for i in range(20))]
inner = [(MARKET[0] + 64 * math.cos(a + 0.1) * (1 + 0.08 * math.sin(2 * a)), MARKET[1] + 58 * math.sin(a + 0.1)) for a in (2 * math.pi * i / 14 for i in range(14))]


def radial(angle_deg, r0, r1, bend):
    a = math.radians(angle_deg)
    return smooth([(MARKET[0] + r * math.cos(a + bend * (r - r0) / r1), MARKET[1] + r * math.sin(a + bend * (r - r0) / r1)) for r in (r0, (r0 + r1) / 2, r1)], 1)


STREETS = [
    ("Brennerstraße", {"highway": "primary", "lanes": "2", "lit": "yes"}, smooth([(96, -512), (88, -400), (82, -316)], 1), "shop"),
    ("Brennerstraße", {"highway": "primary", "lanes": "2", "lit": "yes"}, smooth([(80, -284), (78, -180), (70, -100), (64, -62)], 1), "shop"),
    ("Kilnbrücke", {"highway": "primary", "lanes": "2", "bridge": "yes", "layer": "1"}, [(64, -62), (60, -2)], None),
    ("Brennerstraße", {"highway": "primary", "lanes": "2", "lit": "yes"}, smooth([(60, -2), (66, 60), (92, 130), (104, 210), (150, 300), (200, 400), (226, 512)], 2), "shop"),
    ("Seestraße", {"highway": "secondary", "lit": "yes"}, smooth([(-640, 60), (-470, 52), (-320, 62), (-190, 58), (-80, 48), (64, 46)], 2), "town"),
    ("Ziegelstraße", {"highway": "secondary", "lit": "yes"}, smooth([(88, 118), (210, 132), (360, 150), (500, 152), (640, 170)], 2), "town"),
    ("Ringgasse", {"highway": "residential", "surface": "sett"}, ring_r + ring_r[:1], "old"),
    ("Töpfergasse", {"highway": "pedestrian", "surface": "sett"}, inner + inner[:1], "old"),
    ("Marktgasse", {"highway": "pedestrian", "surface": "sett"}, radial(10, 22, 140, 0.12), "old"),
    ("Schmiedgasse", {"highway": "pedestrian", "surface": "sett"}, radial(78, 22, 124, -0.2), "old"),
    ("Badgasse", {"highway": "residential", "surface": "sett"}, radial(150, 22, 124, 0.15), "old"),
    ("Färbergasse", {"highway": "residential", "surface": "sett"}, radial(222, 22, 128, -0.1), "old"),
    ("Torgasse", {"highway": "residential", "surface": "sett"}, radial(284, 22, 124, 0.1), "old"),
    ("Bahnhofstraße", {"highway": "tertiary", "lit": "yes"}, smooth([(-300, -300), (-160, -262), (-20, -280), (64, -298)], 2), "town"),
    ("Werkstraße", {"highway": "tertiary", "lit": "yes"}, smooth([(96, -300), (230, -290), (400, -300), (640, -268)], 2), None),
    ("Kreisel", {"highway": "tertiary", "junction": "roundabout", "oneway": "yes"}, (lambda r: r + r[:1])(circle((80, -300), 16, 16)), None),
    ("Uferweg", {"highway": "footway"}, smooth([(-470, -100), (-380, -70), (-255, 6), (-120, 40), (20, 6), (60, 2)], 2), None),
    ("Südufer", {"highway": "residential"}, smooth([(64, -62), (-60, -50), (-190, -56), (-300, -110), (-330, -200), (-300, -300)], 2), "villa"),
    ("Nonnensteg", {"highway": "footway", "bridge": "yes", "layer": "1", "width": "3"}, [(-190, -56), (-196, 32)], None),
    ("Nonnenweg", {"highway": "footway"}, [(-196, 32), (-190, 58)], None),
    ("Burgweg", {"highway": "service"}, smooth([(-150, 200), (-190, 255), (-265, 280), (-320, 330), (-290, 385), (-262, 372)], 2), None),
    ("Tunnelstraße", {"highway": "tertiary"}, smooth([(104, 240), (60, 320), (10, 370)], 1), "villa"),
    ("Bergtunnel", {"highway": "tertiary", "tunnel": "yes", "layer": "-1"}, [(10, 370), (-60, 512)], None),
    ("Waldweg", {"highway": "track", "tracktype": "grade2"}, smooth([(200, 400), (120, 430), (40, 470), (-20, 505)], 2), None),
    ("Feldweg", {"highway": "track"}, smooth([(640, 60), (520, 20), (430, -40), (400, -140)], 2), None),
    ("Seepfad", {"highway": "path"}, smooth([(-330, -200), (-330, -330), (-400, -430), (-560, -450), (-640, -420)], 2), None),
]
for i, y in enumerate((215, 275, 335, 395)):
    STREETS.append((f"{('Lehm', 'Sand', 'Kalk', 'Ofen')[i]}weg", {"highway": "residential"}, smooth([(142 + 18 * i, y + 12), (260, y + 2), (420, y + 14 * math.sin(i)), (590, y + 18)], 2), "villa"))
for i, x in enumerate((300, 440, 575)):
    STREETS.append((f"{('Erlen', 'Birken', 'Linden')[i]}allee", {"highway": "residential"}, smooth([(x - 6, 146), (x + 4, 240), (x, 330), (x + 14, 430)], 1), "villa"))
for i, y in enumerate((118, 172, 228)):
    STREETS.append((f"{('Amsel', 'Drossel', 'Finken')[i]}zeile", {"highway": "residential"}, smooth([(-610, y + 30), (-500, y + 8), (-390, y), (-262 + 8 * i, y - 14)], 2), "row"))
for i, x in enumerate((-560, -420, -290)):
    STREETS.append((f"{('Nord', 'Mittel', 'Ost')[i]}steig", {"highway": "residential"}, smooth([(x, 56), (x + 8, 120), (x + 4, 180), (x + 14, 250)], 1), None))
for i, x in enumerate((200, 330, 460)):
    STREETS.append((f"Plattenring {i + 1}", {"highway": "service"}, smooth([(x, -294), (x + 10, -370), (x - 5, -460)], 1), None))
STREETS.append(("Industriestraße", {"highway": "service"}, smooth([(400, -298), (410, -230), (430, -150), (560, -120), (600, -200), (590, -274)], 1), None))
RAIL = smooth([(640, -212), (420, -206), (200, -206), (70, -210), (-80, -214), (-220, -238), (-330, -330), (-420, -420), (-500, -512)], 2)


def split_rail():
    """The rail's runs: ground, a bridge over the Brennerstraße, ground."""
    runs, current = [], [RAIL[0]]
    for a, b in zip(RAIL, RAIL[1:]):
        for x in (104, 50):
            if b[0] < x <= a[0]:
                cut = along(a, b, (a[0] - x) / (a[0] - b[0]))
                current.append(cut)
                runs.append(current)
                current = [cut]
        current.append(b)
    return runs + [current]


for run, tags in zip(split_rail(), ({}, {"bridge": "yes", "layer": "1"}, {})):
    STREETS.append(("Lehmbahn", {"railway": "rail", **tags}, run, None))

# ---- the OSM file ----
nodes, node_of, ways, relations = [], {}, [], []


def node(p, tags=None):
    key = (round(p[0], 2), round(p[1], 2))
    if tags is None and key in node_of:
        return node_of[key]
    nodes.append((len(nodes) + 1, key, tags or {}))
    if tags is None:
        node_of[key] = len(nodes)
    return len(nodes)


def way(points, tags, closed=False):
    ids = [node(p) for p in points]
    ids = [i for k, i in enumerate(ids) if k == 0 or i != ids[k - 1]]
    if closed and ids[0] != ids[-1]:
        ids.append(ids[0])
    ways.append((len(ways) + 1, ids, tags))


def level(tags):
    return tags.get("layer", "0"), "railway" in tags


def cut_at_crossings(index):
    """A street's points, with those where it meets streets of its own level put in."""
    _, tags, points, _ = STREETS[index]
    out = [points[0]]
    for a, b in zip(points, points[1:]):
        cuts = []
        for other, (_, other_tags, line, _) in enumerate(STREETS):
            if other == index or level(tags) != level(other_tags):
                continue
            for c, d in zip(line, line[1:]):
                t = crossing(a, b, c, d)
                if t is not None:
                    # the lower street's own computation of the place, so that both write one node
                    cuts.append((t, along(a, b, t) if index < other else along(c, d, crossing(c, d, a, b))))
        out += [p for _, p in sorted(cuts)] + [b]
    return out


# ---- houses ----
ROADS = [(line, {"primary": 8, "secondary": 7, "tertiary": 6.5, "residential": 6, "pedestrian": 5, "service": 4.5, "footway": 3, "track": 4, "path": 2}.get(tags.get("highway"), 7))
         for _, tags, line, _ in STREETS if "tunnel" not in tags]
houses = []
keep_clear = [LAKE, circle((MARKET[0], MARKET[1]), 24, 12), circle(KNOLL, 70, 16)]


def corners_of(centre, direction, width, depth):
    ux, uy = direction
    return [(centre[0] + sx * width / 2 * ux - sy * depth / 2 * uy, centre[1] + sx * width / 2 * uy + sy * depth / 2 * ux) for sx, sy in ((-1, -1), (1, -1), (1, 1), (-1, 1))]


def overlaps(p, q):
    """Convex rings: is there no axis that separates them?"""
    for ring in (p, q):
        for a, b in zip(ring, ring[1:] + ring[:1]):
            nx, ny = b[1] - a[1], a[0] - b[0]
            ps, qs = [v[0] * nx + v[1] * ny for v in p], [v[0] * nx + v[1] * ny for v in q]
            if max(ps) <= min(qs) + 1e-6 or max(qs) <= min(ps) + 1e-6:
                return False
    return True


def is_free(ring, gap):
    centre = (sum(p[0] for p in ring) / len(ring), sum(p[1] for p in ring) / len(ring))
    if not all(WEST + 6 < p[0] < EAST - 6 and SOUTH + 6 < p[1] < NORTH - 6 for p in ring):
        return False
    samples = ring + [along(a, b, 0.5) for a, b in zip(ring, ring[1:] + ring[:1])] + [centre]
    if any(inside(p, area) for p in samples for area in keep_clear) or any(distance_to_line(p, RIVER) < 16 for p in samples):
        return False
    for line, width in ROADS:
        if any(distance_to_line(p, line) < width / 2 + 1.2 for p in samples):
            return False
    around = [along(centre, p, 1 + gap / max(1, distance(centre, p))) for p in ring]
    return not any(abs(o[0][0] - centre[0]) < 90 and abs(o[0][1] - centre[1]) < 90 and overlaps(around, o) for o in houses)


OLD = ["#e8d9b0", "#e3c48d", "#d9a877", "#d8b9a6", "#efe6d2", "#cfd3c0", "#d7c7c0", "#e9cfae", "#c9b48c", "#f0e2c0"]
STYLES = {
    # width, depth, setback from the kerb, gap to the neighbour, levels, tags
    "old": lambda: (chance.between(7, 11), chance.between(10, 13), 1.3, 0, chance.pick([3, 3, 4]), {"building": "residential", "building:colour": chance.pick(OLD), "roof:shape": "gabled"}),
    "shop": lambda: (chance.between(11, 18), chance.between(12, 15), 4, chance.pick([0, 0, 3]), chance.pick([3, 4, 4, 5]), {"building": "apartments", "building:colour": chance.pick(OLD), "roof:shape": "hipped"}),
    "town": lambda: (chance.between(10, 15), chance.between(11, 14), 4, chance.pick([0, 2, 4]), chance.pick([2, 3, 3]), {"building": "house", "building:colour": chance.pick(OLD), "roof:shape": "gabled"}),
    "villa": lambda: (chance.between(9, 13), chance.between(8, 11), chance.between(5, 9), chance.between(6, 11), 2, {"building": "detached", "roof:shape": chance.pick(["hipped", "gabled", "pyramidal"])}),
    "row": lambda: (6.5, 10, 4, 0, 2, {"building": "terrace", "building:colour": chance.pick(["#e9e2d4", "#d8c9b0", "#cfd6d8"]), "roof:shape": "gabled"}),
}


def add_house(ring, tags):
    houses.append(ring)
    way(ring, tags, closed=True)


def houses_along(points, road_width, style):
    for side in (1, -1):
        run, since_break = 0.0, 0
        total = sum(distance(a, b) for a, b in zip(points, points[1:]))
        while run < total:
            width, depth, setback, gap, levels, tags = STYLES[style]()
            middle, direction = place_on(points, run + width / 2)
            off = road_width / 2 + setback + depth / 2
            centre = (middle[0] - side * direction[1] * off, middle[1] + side * direction[0] * off)
            ring = corners_of(centre, direction, width, depth)
            if is_free(ring, 0.02 if style in ("old", "row") else max(0.02, gap / 2)):
                tags = {**tags, "building:levels": str(levels), "roof:levels": "1"}
                add_house(ring, tags)
                since_break += 1
                run += width + gap + (7 if style == "row" and since_break % 6 == 0 else 0.05)
            else:
                run += 2.0


def place_on(points, run):
    for a, b in zip(points, points[1:]):
        length = distance(a, b)
        if run <= length or (a, b) == (points[-2], points[-1]):
            t = run / length if length else 0
            return along(a, b, t), ((b[0] - a[0]) / length, (b[1] - a[1]) / length)
        run -= length


def box(x0, y0, x1, y1):
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


def area(ring, tags):
    way(ring, tags, closed=True)


# ---- what is drawn, in order ----
way(RIVER, {"waterway": "river", "name": "Kilna", "width": "18"})
area(LAKE, {"natural": "water", "name": "Tonsee"})
for index, (name, tags, _, _) in enumerate(STREETS):
    way(cut_at_crossings(index), {**tags, "name": name})

area(circle(MARKET, 22, 12, 0.5), {"highway": "pedestrian", "area": "yes", "name": "Markt", "surface": "sett"})
# the church on the market's edge: nave, tower
nave = corners_of((MARKET[0] - 2, MARKET[1] + 4), (0.98, 0.2), 30, 13)
tower = corners_of((MARKET[0] - 20.5, MARKET[1] + 0.3), (0.98, 0.2), 7, 7)
area(nave, {"building": "church", "height": "17", "roof:shape": "gabled", "building:colour": "#d9d0bc", "name": "St. Barbara"})
area(tower, {"building:part": "yes", "height": "46", "building:colour": "#d9d0bc", "roof:colour": "#5a7a6a", "roof:shape": "pyramidal"})
houses += [nave, tower]
# the castle: a keep, a hall, walls
hall = corners_of((KNOLL[0] + 12, KNOLL[1] - 8), (0.9, 0.43), 34, 12)
keep = corners_of((KNOLL[0] - 16, KNOLL[1] + 8), (0.9, 0.43), 11, 11)
add_house(hall, {"building": "castle", "height": "14", "building:material": "stone", "roof:colour": "#8a4a32"})
add_house(keep, {"building": "tower", "height": "28", "building:material": "stone"})
way(circle(KNOLL, 42, 14)[:13], {"barrier": "city_wall", "height": "6"})
way([(MARKET[0] + 138 * math.cos(math.radians(a)), MARKET[1] + 122 * math.sin(math.radians(a))) for a in range(96, 150, 6)], {"barrier": "city_wall", "height": "7"})
# station, platforms
add_house(corners_of((-60, -238), (1, -0.03), 46, 12), {"building": "train_station", "height": "11", "building:material": "brick", "name": "Tonbrenn"})
area(box(-130, -225, 30, -220), {"railway": "platform"})
# towers by the river, one with a setback
for x, y, levels, colour in ((150, -90, 26, "#9fb0b8"), (205, -120, 19, "#b9b2a5"), (262, -84, 30, "#8da3b3"), (160, -150, 16, "#c4b8a4")):
    ring = corners_of((x, y), (0.97, 0.26), 22, 20)
    if levels == 30:
        base = corners_of((x, y), (0.97, 0.26), 34, 30)
        area(base, {"building": "office", "building:levels": str(levels), "name": "Kilnturm"})
        area(base, {"building:part": "yes", "building:levels": "5", "building:colour": "#a89a86"})
        area(ring, {"building:part": "yes", "building:levels": str(levels), "building:min_level": "5", "building:colour": colour, "building:material": "glass"})
        houses.append(base)
    else:
        add_house(ring, {"building": "office", "building:levels": str(levels), "building:colour": colour})
# panel blocks
for x in (232, 300, 362, 428, 494):
    for y in (-345, -405, -465):
        ring = corners_of((x, y), (0.12, 0.99) if x % 4 else (0.99, 0.12), 44, 12)
        if is_free(ring, 6):
            add_house(ring, {"building": "apartments", "building:levels": str(chance.pick([5, 6, 9])), "building:colour": chance.pick(["#d8d2c4", "#c9c4ba", "#dcc9ad", "#bfc8c9"]), "roof:shape": "flat"})
# halls
for x, y, w, d in ((470, -238, 62, 40), (545, -170, 44, 60), (470, -178, 52, 34), (350, -250, 56, 36), (620, -150, 26, 50)):
    ring = corners_of((x, y), (1, 0.04), w, d)
    if is_free(ring, 3):
        add_house(ring, {"building": "industrial", "height": str(chance.pick([8, 9, 11])), "roof:shape": "flat"})
for index, (_, tags, points, style) in enumerate(STREETS):
    if style:
        houses_along(points, {"primary": 8, "secondary": 7, "tertiary": 6.5, "residential": 6, "pedestrian": 5}[tags["highway"]], style)

# land
forest = smooth([(-640, 330), (-470, 300), (-370, 380), (-180, 420), (-60, 400), (30, 420), (110, 450), (200, 470), (330, 466), (470, 470), (640, 455), (640, 512), (0, 512), (-640, 512)], 1)
area(forest, {"natural": "wood", "leaf_type": "mixed"})
area(smooth([(-640, 270), (-560, 266), (-480, 292), (-560, 322), (-640, 326), (-640, 270)], 1), {"landuse": "forest", "leaf_type": "needleleaved"})
area(circle(KNOLL, 66, 18), {"landuse": "forest", "leaf_type": "broadleaved"})
area(circle(KNOLL, 40, 14), {"landuse": "grass"})
area([(-640, 20), (-470, 30), (-330, 44), (-250, 10), (-330, -52), (-450, -118), (-640, -110)], {"landuse": "meadow"})
area([(-330, -350), (-210, -275), (-60, -300), (40, -330), (60, -512), (-460, -512)], {"landuse": "meadow"})
for i in range(7):
    x0 = 380 + 38 * i
    area([(x0, -60 + 6 * i), (x0 + 37, -54 + 6 * i), (x0 + 37, 52 + 6 * i), (x0, 40 + 6 * i)], {"landuse": "farmland"})
for i in range(8):
    x0 = -290 + 44 * i
    area([(x0, -500), (x0 + 43, -500), (x0 + 43, -345 - 2 * i), (x0, -345 - 2 * i)], {"landuse": "farmland"})
area([(-250, -120), (-110, -100), (-90, -190), (-230, -205)], {"landuse": "orchard"})
area([(-60, -80), (46, -84), (54, -196), (-60, -196)], {"leisure": "park", "name": "Stadtpark"})
area(circle((0, -140), 15, 14), {"natural": "water", "water": "pond"})
area(box(520, 330, 610, 400), {"landuse": "cemetery"})
area(box(-480, 262, -300, 300), {"landuse": "allotments"})
area(box(-200, 92, -176, 130), {"amenity": "parking"})
area(box(120, -270, 190, -232), {"amenity": "parking"})
area(box(330, -230, 620, -110), {"landuse": "industrial"})
area(box(180, -480, 520, -320), {"landuse": "residential"})
area([(130, 190), (620, 175), (630, 450), (210, 452)], {"landuse": "residential"})
area([(-625, 70), (-250, 66), (-240, 258), (-620, 276)], {"landuse": "residential"})
area(circle(MARKET, 132, 24), {"landuse": "residential"})
# the school by the row houses: pitch and running track
area(box(-236, -10 + 100, -206, 150), {"amenity": "school"})
track = circle((300, -30), 46, 28, squash=0.62)
area(track, {"leisure": "track", "sport": "running"})
area(circle((300, -30), 36, 28, squash=0.55), {"leisure": "pitch", "sport": "soccer"})
# beach, pier, boats' jetties
area([(-372, -190), (-340, -205), (-338, -262), (-364, -250)], {"natural": "beach"})
way([(-470, -120), (-500, -205)], {"man_made": "pier"})
area([(-472, -118), (-466, -120), (-494, -206), (-500, -204)], {"man_made": "pier"})
# hedges and walls
for y in (330, 400):
    way([(520, y), (610, y)], {"barrier": "hedge"})
way([(120, -270), (190, -270)], {"barrier": "wall", "height": "1.6"})
way([(330, -230), (620, -230)], {"barrier": "fence"})


def is_open(p, reach):
    clear = all(distance_to_line(p, line) > width / 2 + reach for line, width in ROADS)
    return clear and not any(inside(p, h) or distance_to_line(p, h + h[:1]) < 2 for h in houses if abs(h[0][0] - p[0]) < 60 and abs(h[0][1] - p[1]) < 60)


# avenues, lamps
for name, tags, points, _ in STREETS:
    total = sum(distance(a, b) for a, b in zip(points, points[1:]))
    if name in ("Brennerstraße", "Lindenallee", "Birkenallee", "Seestraße", "Bahnhofstraße"):
        for k in range(int(total / 13)):
            middle, d = place_on(points, 6 + 13 * k)
            for side in (1, -1):
                p = (middle[0] - side * d[1] * 5.9, middle[1] + side * d[0] * 5.9)
                if is_open(p, 1.2):
                    node(p, {"natural": "tree", "leaf_type": "broadleaved", "height": str(round(chance.between(7, 12), 1))})
    if tags.get("lit") == "yes" and "bridge" not in tags:
        for k in range(int(total / 30)):
            middle, d = place_on(points, 15 + 30 * k)
            side = 1 if k % 2 else -1
            p = (middle[0] - side * d[1] * 4.9, middle[1] + side * d[0] * 4.9)
            if is_open(p, 0.4):
                node(p, {"highway": "street_lamp", "height": "7"})
for _ in range(140):
    p = (chance.between(-620, 620), chance.between(-480, 300))
    if is_open(p, 3) and not inside(p, LAKE) and distance_to_line(p, RIVER) > 13:
        node(p, {"natural": "tree", "height": str(round(chance.between(5, 14), 1))})

# steel silos beside a hall
for x, y in ((392, -242), (392, -254)):
    ring = circle((x, y), 4.5, 16)
    if is_free(ring, 1):
        add_house(ring, {"building": "silo", "height": "19", "building:material": "stainless_steel", "roof:material": "stainless_steel", "roof:shape": "cone", "roof:height": "2"})


# ---- writing ----
def escaped(text):
    return text.replace("&", "&amp;").replace('"', "&quot;").replace("<", "&lt;")


def lonlat(p):
    return LON0 + p[0] / M_LON, LAT0 + p[1] / M_LAT


def write_osm(path):
    (west, south), (east, north) = lonlat((WEST, SOUTH)), lonlat((EAST, NORTH))
    lines = ['<?xml version="1.0" encoding="UTF-8"?>', '<osm version="0.6" generator="make_town.py">',
             f' <bounds minlat="{south:.7f}" minlon="{west:.7f}" maxlat="{north:.7f}" maxlon="{east:.7f}"/>']
    tag = lambda k, v: f'  <tag k="{escaped(k)}" v="{escaped(v)}"/>'
    for number, p, tags in nodes:
        lon, lat = lonlat(p)
        head = f' <node id="{number}" version="1" lat="{lat:.7f}" lon="{lon:.7f}"'
        lines += [head + ">"] + [tag(*t) for t in sorted(tags.items())] + [" </node>"] if tags else [head + "/>"]
    for number, ids, tags in ways:
        lines += [f' <way id="{number}" version="1">'] + [f'  <nd ref="{i}"/>' for i in ids] + [tag(*t) for t in sorted(tags.items())] + [" </way>"]
    with open(path, "w", encoding="utf-8") as file:
        file.write("\n".join(lines + ["</osm>"]) + "\n")


def write_heights(path):
    """16-bit grey PNG, steps of 2 cm, rows from the north."""
    columns = int((EAST - WEST + 2 * HEIGHT_MARGIN) / HEIGHT_STEP) + 1
    rows = int((NORTH - SOUTH + 2 * HEIGHT_MARGIN) / HEIGHT_STEP) + 1
    raw = b""
    for r in range(rows):
        y = NORTH + HEIGHT_MARGIN - r * HEIGHT_STEP
        values = [int(height(WEST - HEIGHT_MARGIN + c * HEIGHT_STEP, y) * 50 + 0.5) for c in range(columns)]
        raw += b"\0" + struct.pack(f">{columns}H", *values)
    chunk = lambda kind, data: struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", columns, rows, 16, 0, 0, 0, 0)) + chunk(b"IDAT", zlib.compress(raw, 9)) + chunk(b"IEND", b""))
    # outer edges of the outer pixels
    half = HEIGHT_STEP / 2
    west, north = lonlat((WEST - HEIGHT_MARGIN - half, NORTH + HEIGHT_MARGIN + half))
    east, south = lonlat((WEST - HEIGHT_MARGIN + (columns - 1) * HEIGHT_STEP + half, NORTH + HEIGHT_MARGIN - (rows - 1) * HEIGHT_STEP - half))
    return f"bounds={west:.7f}/{south:.7f}/{east:.7f}/{north:.7f},scale=0.02"


write_osm(os.path.join(HERE, "town.osm"))
print("town_heights.png," + write_heights(os.path.join(HERE, "town_heights.png")))
print(len(houses), "houses,", len(ways), "ways,", len(nodes), "nodes")
