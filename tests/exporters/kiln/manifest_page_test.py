#!/usr/bin/env python3
"""A reader written from exporters/kiln/MANIFEST.md alone reads what citykiln writes; the names of streams come from the page's table."""
import ctypes
import ctypes.util
import json
import math
import re
import struct
import sys
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent.parent / "properties"))

from citykiln_program import ROOT, ProgramTest, report_of, run  # noqa: E402

GOLDEN = ROOT / "tests" / "golden"
PAGE = (ROOT / "exporters" / "kiln" / "MANIFEST.md").read_text()


def stream_names():
    """The streams by number, from the page's table."""
    names = {}
    for row in re.findall(r"^\|(.*)\|$", PAGE, re.MULTILINE):
        cells = [cell.strip() for cell in row.split("|")]
        if len(cells) == 6 and cells[0].isdigit():
            names[int(cells[0])] = cells[1]
            if cells[3]:
                names[int(cells[3])] = cells[4]
    assert sorted(names) == list(range(len(names)))
    return [names[number] for number in range(len(names))]


def field_classes():
    """The numbers of the land cover classes of fields."""
    rows = (ROOT / "compiler/map/land_cover_classes.inc").read_text()
    names = re.findall(r"^LAND_COVER\((\w+)", rows, re.MULTILINE)
    return range(names.index("kCereals"), names.index("kHayMeadow") + 1)


def fnv(data):
    value = 0xCBF29CE484222325
    for byte in data:
        value = ((value ^ byte) * 0x100000001B3) % 2**64
    return value


ZSTD = ctypes.CDLL(ctypes.util.find_library("zstd"))
ZSTD.ZSTD_getFrameContentSize.restype = ctypes.c_uint64
ZSTD.ZSTD_decompress_usingDict.restype = ctypes.c_size_t
ZSTD.ZSTD_createDCtx.restype = ctypes.c_void_p
CONTEXT = ctypes.c_void_p(ZSTD.ZSTD_createDCtx())


def unzstd(frame, dictionary=b""):
    size = ZSTD.ZSTD_getFrameContentSize(frame, ctypes.c_size_t(len(frame)))
    assert size <= 2**28
    raw = ctypes.create_string_buffer(size)
    got = ZSTD.ZSTD_decompress_usingDict(CONTEXT, raw, ctypes.c_size_t(size), frame, ctypes.c_size_t(len(frame)),
                                         dictionary, ctypes.c_size_t(len(dictionary)))
    assert got == size
    return raw.raw


class Table:
    """A table of a FlatBuffer."""

    def __init__(self, data, at):
        self.data, self.at = data, at
        self.fields = at - struct.unpack_from("<i", data, at)[0]

    def place(self, field):
        entry = 4 + 2 * field
        inside = entry < struct.unpack_from("<H", self.data, self.fields)[0]
        offset = struct.unpack_from("<H", self.data, self.fields + entry)[0] if inside else 0
        return self.at + offset if offset else None

    def number(self, field, kind):
        place = self.place(field)
        return 0 if place is None else struct.unpack_from("<" + kind, self.data, place)[0]

    def vector(self, field):
        """Where its elements begin, and how many there are."""
        place = self.place(field)
        place += struct.unpack_from("<I", self.data, place)[0]
        return place + 4, struct.unpack_from("<I", self.data, place)[0]

    def bytes(self, field):
        if self.place(field) is None:
            return b""
        at, count = self.vector(field)
        return self.data[at:at + count]

    def table(self, field):
        place = self.place(field)
        return Table(self.data, place + struct.unpack_from("<I", self.data, place)[0])


def root_of(data):
    return Table(data, struct.unpack_from("<I", data, 0)[0])


class Stream:
    def __init__(self, data):
        self.data, self.at, self.last = data, 0, 0

    def plain(self):
        value, shift = 0, 0
        while True:
            byte = self.data[self.at]
            self.at, value, shift = self.at + 1, value | (byte & 127) << shift, shift + 7
            if byte < 128:
                return value

    def signed(self):
        value = self.plain()
        return -(value + 1) // 2 if value % 2 else value // 2

    def step(self):
        self.last += self.signed()
        return self.last


class Chunk:
    """One tile, read in the order of the page; each object is a tuple of the fields that the page lists."""

    def __init__(self, raw):
        names, head = stream_names(), Stream(raw)
        sizes = [head.plain() for _ in names]
        self.streams, at = {}, head.at
        for name, size in zip(names, sizes, strict=True):
            self.streams[name], at = Stream(raw[at:at + size]), at + size
        assert at == len(raw)
        self.known, self.last = [], -1
        self.point_step = 2**-7 if self.plain("point step") else 2**-10
        self.heights = self.read_heights()
        self.surfaces = self.all("surfaces", self.surface)
        self.road_kinds = self.all("road kinds", self.road_kind)
        self.roads = self.all("roads", self.road)
        self.narrowed = self.all("narrowed roads", self.narrowed_road)
        self.stairs = self.all("stepped roads", lambda: self.several("stepped road", 1) + [self.plain("riser") / 1024, self.plain("handrails")])
        self.walled = self.all("walled roads", self.walled_road)
        self.junctions = self.all("junctions", self.junction)
        self.waters = self.all("watercourses", self.water)
        self.bridges = self.all("bridges", self.span)
        self.tunnels = self.all("tunnels", self.span)
        self.buildings = self.all("buildings", self.building)
        self.trees = self.all("trees", lambda: (self.id(), self.point(), self.metres("tree height"), self.plain("tree species mix")))
        self.woods = self.all("woods", lambda: (self.id(), self.several("wood", 3)))
        self.plantings = self.all("plantings", lambda: (self.id(), self.several("planting", 5)))
        self.tree_rows = self.all("tree rows", lambda: (self.id(), self.points("tree row points"), self.several("tree row", 3)))
        self.corridors = self.all("power corridors", lambda: (self.id(), self.points("power corridor points"), self.plain("power corridor")))
        self.barriers = self.all("barriers", self.barrier)
        self.lamps = self.all("lamps", lambda: (self.id(), self.point(), self.metres("lamp height"), self.several("lamp light", 5) if self.plain("lamp light") else None))
        self.fields = self.all("sports fields", lambda: (self.id(), self.plain("sports field kind"), self.point(), self.point(),
                                                         self.metres("sports field width")))
        self.landforms = self.all("landforms", lambda: (self.water(), self.plain("landform kind")))
        self.words = [""]
        self.thing_forms = self.all("thing forms", self.thing_form)
        self.things = self.all("things", lambda: (self.id(), self.point(), self.thing_forms[self.plain("thing form")], self.plain("thing direction"),
                                              self.metres("thing size") if self.plain("thing traits") & 2 else None))
        self.wire_spans = self.all("wire spans", self.wire_span)
        self.names = [""]
        self.texts = self.all("texts", self.text)
        self.outline, self.last_outline, self.next_building, self.heading = [], 0, 0, 0
        self.yards = self.all("yards", self.yard)
        self.gaps = [self.bits("yard gaps", "yard gap bits") for _ in self.yards]

    def plain(self, name):
        return self.streams[name].plain()

    def wire_span(self):
        span, above = self.id(), self.streams["wire height"].step()
        wires = self.all("wires", lambda: (self.streams["wire sag"].step() * 2**-7, self.plain("wire radius"), self.plain("wire kind")))
        ends = [[tuple(self.streams[f"wire {axis}"].step() * 2**-7 for axis in "xyz") for _ in wires] for _ in range(2)]
        return (span, above, [(*wire, *both) for wire, *both in zip(wires, *ends, strict=True)])

    def thing_word(self):
        number = self.plain("thing word")
        if number == len(self.words):
            size, stream = self.plain("thing word size"), self.streams["thing word bytes"]
            self.words.append(stream.data[stream.at:stream.at + size].decode())
            stream.at += size
        return self.words[number]

    def thing_form(self):
        kind, size = self.thing_word(), [self.metres("thing size") for _ in range(3)]
        words = [self.thing_word() for _ in range(3)]
        return kind, size, words, [self.plain(f"thing {name}") for name in ("colour", "capacity", "country", "variant")]

    def several(self, name, count):
        return [self.plain(name) for _ in range(count)]

    def metres(self, name):
        return self.streams[name].step() / 1024

    def all(self, name, each):
        return [each() for _ in range(self.plain(name))]

    def points(self, name):
        return self.all(name, self.point)

    def line(self, name):
        line = []
        for _ in range(self.plain(name)):
            code, curve = self.plain("points"), None
            if code == 4:
                assert line
                slopes = [self.streams["curve slopes"].signed() for _ in range(2)]
                curve, code = (slopes, self.several("curve reaches", 2), self.plain("curve pieces")), self.plain("points")
            end = self.point(code)
            line += ([] if curve is None else curve_between(line[-1], end, *curve)) + [end]
        return line

    def id(self):
        return self.plain("id type"), self.streams["id"].step(), self.plain("part")

    def utf8(self, size, content):
        stream, count = self.streams[content], self.plain(size)
        stream.at += count
        return stream.data[stream.at - count:stream.at].decode()

    def text(self):
        """An element's id, name and tags."""
        element, number = (self.plain("id type"), self.streams["id"].step()), self.plain("name number")
        if number == len(self.names):
            self.names.append(self.utf8("name size", "name bytes"))
        tags = self.utf8("tags size", "tags bytes")
        return element, self.names[number], json.loads(tags) if tags else {}

    def eighths(self, name):
        return self.streams[name].signed() / 8

    def bits(self, size, name):
        numbers = self.all(size, lambda: self.plain(name))
        assert not numbers or numbers[-1] != 0
        return [number >> k & 1 for number in numbers for k in range(7)]

    def yard_building(self):
        number = self.plain("yard building")
        if number == 0:
            return self.id()
        self.next_building += number
        return self.buildings[self.next_building - 1][0]

    def outline_point(self):
        code = self.plain("yard points")
        if code == 0:
            x, y = self.outline[self.last_outline] if self.outline else (0, 0)
            self.outline.append((x + self.streams["yard x"].signed() / 4, y + self.streams["yard y"].signed() / 4))
            self.last_outline = len(self.outline) - 1
        else:
            self.last_outline += {1: 1, 2: -1}[code] if code < 3 else self.streams["yard point jumps"].signed()
        assert 0 <= self.last_outline < len(self.outline)
        return self.outline[self.last_outline]

    def yard_strip(self):
        return self.plain("yard strip kind"), [self.eighths(f"yard strip {name}") for name in ("x", "y", "aside", "end")]

    def yard(self):
        building, country, kind = self.yard_building(), self.plain("yard country"), self.several("yard kind", 3)
        rings = [self.all("yard ring points", self.outline_point)]
        rings += self.all("yard holes", lambda: self.all("yard ring points", self.outline_point))
        origin = [place + self.eighths(f"yard frame {axis}") for place, axis in zip(rings[0][0], "xy", strict=True)]
        self.heading = (self.heading + self.plain("yard heading")) % 1024
        return (building, country, kind, rings, origin, self.heading, self.eighths("yard setback"), self.all("yard strips", self.yard_strip),
                self.all("yard borders", lambda: (self.plain("border place"), self.several("border steps", 2))),
                self.bits("yard plants", "yard plant bits"))

    def point(self, code=None):
        code = self.plain("points") if code is None else code
        if code == 0:
            self.known.append(tuple(self.streams[axis].step() * self.point_step for axis in "xy"))
            self.last = len(self.known) - 1
        else:
            self.last += {1: 1, 2: -1}[code] if code < 3 else self.streams["point jumps"].signed()
        assert 0 <= self.last < len(self.known)
        return self.known[self.last]

    def read_heights(self):
        field = self.streams["field"]
        assert field.plain() in (1, 2, 4)
        for _ in range(4):
            field.step()
        columns, rows = field.plain(), field.plain()
        field.step()
        assert field.plain() == columns * rows
        shift, heights = field.plain(), []
        for i in range(columns * rows):
            west = heights[i - 1] if i % columns else 0
            south = heights[i - columns] if i >= columns else 0
            predicted = south if i % columns == 0 else west if i < columns else west + south - heights[i - columns - 1]
            heights.append(predicted + self.streams["heights"].signed() * 2**shift)
        return [height / 64 for height in heights]

    def surface(self):
        return (self.id(), self.surface_class(), self.plain("surface area"),
                self.all("surface rings", lambda: self.points("ring points")), self.level(),
                self.plain("graded"), self.field_rows())

    def surface_class(self):
        self.last_class = self.plain("surface class")
        return self.last_class

    def field_rows(self):
        return self.plain("field rows") if self.last_class in field_classes() else None

    def level(self):
        return self.streams["water level"].step() / 128 if self.plain("levelled") else None

    def profile(self):
        return self.all("knots", lambda: (self.plain("knot steps") / 8, self.streams["knot height"].step() / 128,
                                          self.streams["knot tilt"].step() / 1024))

    def road(self):
        return (self.id(), self.line("road points"), self.road_kinds[self.plain("road kind")], self.plain("start offset") / 1024,
                self.all("track points", self.track_point), self.profile())

    def track_point(self):
        vertex, sign = self.plain("track vertex"), divmod(self.plain("track sign"), 3)
        return vertex, sign, self.plain("crossing reach") / 4 if sign[0] == 5 else 0

    def narrowed_road(self):
        return self.plain("narrowed road"), *(self.all("width limits", self.width_limit) for side in ("left", "right"))

    def walled_road(self):
        return self.plain("walled road"), self.all("cuttings", lambda: self.several("cutting step", 2))

    def width_limit(self):
        return divmod(self.plain("width limit steps"), 2), self.streams["width limit half"].step() / 32

    def road_kind(self):
        surface, traits, country = (self.plain("road " + name) for name in ("surface", "traits", "country"))
        offset_m = self.plain("axis offset") / 2048
        drift = self.plain("axis offset") / 65536 - 0.5 if traits & 16 else 0
        return surface, traits, country, offset_m, drift, self.all("lanes", self.lane)

    def lane(self):
        kind, raised = divmod(self.plain("lane kind"), 2)
        return *divmod(kind, 3), raised, self.metres("lane width"), self.plain("lane turns")

    def water(self):
        return (self.id(), self.line("road points"), self.plain("water class"), self.metres("water sides"),
                self.metres("water sides"), self.plain("start offset") / 1024, self.profile(),
                16 * self.plain("water influence"))

    def junction(self):
        return (self.plain("junction family"), self.points("junction places"),
                self.all("junction arms", lambda: (self.plain("cut lengths") / 4, self.plain("corner radii") / 4)))

    def span(self):
        return (*self.road(), self.span_end(), self.span_end(), self.plain("bored"),
                self.plain("span layer") - 10, self.plain("deck form"), self.all("plates", self.plate), self.all("openings", self.opening), self.all("openings", self.opening), self.all("piers", self.pier))

    def plate(self):
        return self.id(), self.plain("plate surface"), self.all("plate parts", self.plate_part)

    def plate_part(self):
        return self.plain("plate below road"), self.all("plate rings", lambda: self.all("plate corners", self.plate_corner))

    def plate_corner(self):
        return self.point(), self.streams["plate height"].step() / 128, self.plain("plate walls")

    def span_end(self):
        kind = self.plain("span ends")
        return kind, self.point() if kind in (1, 3) else None, self.plain("end cut") / 4 if kind == 2 else 0

    def opening(self):
        return self.plain("opening step") / 4, self.plain("opening step") / 4

    def pier(self):
        return self.plain("pier step") / 4, self.streams["pier foot"].step() / 4

    def colour(self):
        return [self.plain("colour values") for _ in range(3)] if self.plain("colours") else None

    def roof_shape(self):
        form = self.plain("roof form")
        if form == 0:
            return form, 0
        rise, traits, eaves = self.metres("roof rise"), self.plain("roof traits"), self.metres("roof eaves")
        direction = (self.metres("roof direction"), self.metres("roof direction")) if traits & 1 else None
        return form, rise, traits & 2, eaves, direction

    def party_wall(self):
        edge = self.plain("party edge")
        places = [self.metres("party place") for _ in range(2)]
        return edge, places, self.metres("party top"), self.plain("party traits")

    def buried_place(self):
        return self.plain("buried edge"), self.metres("buried from"), self.plain("buried storeys")

    def passageway(self):
        way, axis, sides = self.id(), self.points("passageway points"), [self.metres("passageway sides") for _ in range(2)]
        return way, axis, sides, self.metres("passageway top"), [self.metres("passageway pillars") for _ in range(2)]

    def building(self):
        seen = (self.id(), self.points("footprint points"), self.all("footprint holes", lambda: self.points("hole points")),
                self.metres("building bottom"), self.metres("building floor"), self.metres("building top"),
                self.plain("building stands"), self.plain("wall"), self.plain("roof"), self.colour(), self.colour(),
                self.roof_shape())
        style = [self.plain(name) for name in ("style", "building class", "storeys", "year", "shop",
                                              "building country", "building assumed")]
        walls = (self.all("facade edges", lambda: self.plain("facade edge")), self.all("buried places", self.buried_place),
                 self.all("party walls", self.party_wall))
        posts = self.points("posts")
        return (*seen, style, *walls, posts, self.metres("post foot") if posts else None,
                self.all("passageways", self.passageway), self.all("fronts", self.front))

    def front(self):
        edge, places, kind = self.plain("front edge"), [self.metres("front place") for _ in range(2)], self.plain("front kind")
        return edge, places, kind, [self.plain("front hours") for _ in range(6)] if self.plain("front hours") else None

    def barrier(self):
        return (self.id(), self.line("barrier points"), self.plain("barrier kind"),
                self.metres("barrier height"), self.metres("barrier width"))


def curve_between(a, b, slopes, reaches, pieces):
    """The points of a curve between its ends."""
    if b < a:
        return curve_between(b, a, slopes[::-1], reaches[::-1], pieces)[::-1]
    p, q = (reach / 64 for reach in reaches)

    def offset(t):
        from_a = slopes[0] / 64 * t * (1 - t / p) ** 2 if p and t < p else 0
        return from_a - (slopes[1] / 64 * (1 - t) * (1 - (1 - t) / q) ** 2 if q and 1 - t < q else 0)

    if pieces < 2:
        shares = []
    elif p + q > 1:
        shares = [k / pieces for k in range(1, pieces)]
    else:
        along = [k / pieces * (1 + k / pieces) / 2 for k in range(1, pieces + 1)]
        shares = [u * p for u in along if p] + [1 - u * q for u in along if q]
    points = []
    dx, dy = b[0] - a[0], b[1] - a[1]
    for t in sorted({t for t in shares if 0 < t < 1}):
        place = tuple(math.floor(v * 128 + 0.5) / 128 for v in (a[0] + dx * t - dy * offset(t), a[1] + dy * t + dx * offset(t)))
        if place not in (a, b) and (not points or points[-1] != place):
            points.append(place)
    return points


class Around:
    """The land around the region: lines, heights by crossing, and what covers them."""

    def __init__(self, table):
        x, y, heights, covers = (Stream(table.bytes(field)) for field in range(4))
        self.x, self.y = all_of(x, Stream.step), all_of(y, Stream.step)
        self.heights = []
        for row in range(len(self.y)):
            for column in range(len(self.x)):
                self.heights.append(self.predicted(column, row) + heights.signed())
        self.covers = []
        for number, run in enumerate(all_of(covers, Stream.plain)):
            self.covers += [("land", "sea", "lake")[number % 3]] * run
        self.error_m, self.rms_error_m = table.number(4, "d"), table.number(5, "d")
        assert heights.at == len(heights.data) and len(self.covers) == len(self.heights)

    def at(self, column, row):
        return self.heights[row * len(self.x) + column]

    def predicted(self, column, row):
        if column == 0:
            return self.at(0, row - 1) if row else 0
        if row == 0:
            return self.at(column - 1, 0)
        return self.at(column - 1, row) + self.at(column, row - 1) - self.at(column - 1, row - 1)


class Climate:
    """The classes of a grid, and that of the origin."""

    def __init__(self, table):
        self.own, self.first, self.columns = table.number(0, "B"), (table.number(1, "i"), table.number(2, "i")), table.number(3, "i")
        classes, shares = table.bytes(4), table.bytes(5)
        assert len(classes) == len(shares) and len(shares) % (4 * self.columns) == 0
        self.nodes = [{classes[i]: shares[i] for i in range(at, at + 4) if shares[i]} for at in range(0, len(shares), 4)]


def all_of(stream, take):
    numbers = []
    while stream.at < len(stream.data):
        numbers.append(take(stream))
    return numbers


class Manifest:
    """Maps tiles to chunks; checks every hash, size and offset."""

    def __init__(self, manifest):
        assert manifest[:8] == b"CITYKILN"
        major, _, size, value = struct.unpack_from("<HHIQ", manifest, 8)
        assert major == 7
        frame, body = manifest[24:24 + size], manifest[24 + size:]
        assert fnv(manifest[:16] + frame) == value
        header = root_of(unzstd(frame))
        self.dictionary = header.bytes(13)
        line_m = header.number(14, "d") if header.place(14) else math.nan
        self.snow_line_m = None if math.isnan(line_m) else line_m
        self.around = Around(header.table(17)) if header.place(17) else None
        self.climate = Climate(header.table(19))
        self.chunks, end = {}, 0
        for tile, size, value in tiles_of(header.table(12)):
            assert not self.chunks or max(self.chunks) < tile
            frame, end = body[end:end + size], end + size
            assert fnv(frame) == value
            self.chunks[tile] = Chunk(unzstd(frame, self.dictionary))
        assert end == len(body)


def tiles_of(index):
    """Each tile, the size of its frame and the hash of it."""
    x, y, size = (Stream(index.bytes(field)) for field in range(3))
    at, count = index.vector(3)
    tiles = [((x.step(), y.step()), size.plain(), value) for value in struct.unpack_from(f"<{count}Q", index.data, at)]
    assert all(stream.at == len(stream.data) for stream in (x, y, size))
    return tiles


def centre_of(path):
    """Longitude and latitude in the middle of an .osm file's nodes."""
    places = [(float(node.get("lon")), float(node.get("lat"))) for node in ElementTree.parse(path).getroot().iter("node")]
    return tuple(sum(axis) / len(places) for axis in zip(*places, strict=True))


def tags_in_map(path):
    """The tags of each element of an .osm file, by type as in ids, and id."""
    types = {"node": 1, "way": 2, "relation": 3}
    return {(types[element.tag], int(element.get("id"))): {tag.get("k"): tag.get("v") for tag in element.findall("tag")}
            for element in ElementTree.parse(path).getroot() if element.tag in types}


def drawn_by(yard, kind):
    """The ids of what a yard draws: parts from 0x4000 on, 256 for each part of the building; one in four for barriers."""
    (kind_of_id, number, part), borders, plants = yard[0], yard[8], yard[9]
    count, step = {"trees": (sum(plants), 1), "barriers": (len(borders), 4)}.get(kind, (0, 1))
    return [(kind_of_id, number, 0x4000 + part * 256 + step * i) for i in range(count)]


class Page(ProgramTest):
    def read(self, case):
        heights = ["--dem", case / "heights.asc"] if (case / "heights.asc").exists() else []
        out = self.compiled(case.name, case / "map.osm", *heights, *(case / "args").read_text().split())
        return Manifest((out / "scene.kiln").read_bytes()).chunks, report_of(out)

    def test_says_all_that_a_reader_needs(self):
        cases = sorted(path.parent for path in GOLDEN.glob("*/args"))
        self.assertTrue(cases)
        for case in cases:
            chunks, report = self.read(case)
            self.assertTrue(chunks, case.name)
            for tile, chunk in chunks.items():
                unread = [name for name, stream in chunk.streams.items() if stream.at != len(stream.data)]
                self.assertEqual(unread, [], f"{case.name} {tile}")
            for kind in ("bridges", "tunnels", "buildings", "trees", "barriers", "lamps", "things", "wire_spans"):
                # a bridge or tunnel is in every chunk that it touches
                read = {thing[0] for chunk in chunks.values() for thing in getattr(chunk, kind)}
                read.update(drawn for chunk in chunks.values() for yard in chunk.yards for drawn in drawn_by(yard, kind))
                self.assertEqual(len(read), report["counts"][kind], f"{case.name}: {kind}")

    def test_says_how_tiles_share_a_dictionary(self):
        town = ROOT / "examples" / "town"
        out = self.compiled("town", town / "town.osm", "--tile", "128", "--emit", "kiln")
        manifest = Manifest((out / "scene.kiln").read_bytes())
        self.assertGreaterEqual(len(manifest.chunks), 64)
        self.assertTrue(manifest.dictionary)
        self.assertEqual(sum(len(chunk.buildings) for chunk in manifest.chunks.values()), report_of(out)["counts"]["buildings"])

    def test_says_where_names_and_tags_are(self):
        town = ROOT / "examples" / "town"
        mapped = tags_in_map(town / "town.osm")
        for arguments in ([], ["--tags"]):
            out = self.compiled(f"texts{len(arguments)}", town / "town.osm", "--emit", "kiln", *arguments)
            read = {}
            for chunk in Manifest((out / "scene.kiln").read_bytes()).chunks.values():
                self.assertEqual([text[0] for text in chunk.texts], sorted({text[0] for text in chunk.texts}))
                read.update({element: (name, tags) for element, name, tags in chunk.texts})
            named = {element for element, (name, _) in read.items() if name}
            self.assertGreater(len(named), 5)
            for element in named:
                self.assertEqual(read[element][0], mapped[element].get("name", read[element][0]), element)
            tagged = {element: tags for element, (_, tags) in read.items() if tags}
            self.assertEqual(tagged, {element: mapped[element] for element in read} if arguments else {})

    def test_says_where_snow_lies(self):
        for arguments, line_m in ([], None), (["--snow-line", "2200.5"], 2200.5):
            out = self.compiled("crossing", GOLDEN / "crossing" / "map.osm", "--emit", "kiln", *arguments)
            self.assertEqual(Manifest((out / "scene.kiln").read_bytes()).snow_line_m, line_m)

    def test_says_what_climate_there_is(self):
        out = self.compiled("crossing", GOLDEN / "crossing" / "map.osm", "--emit", "kiln")
        climate = Manifest((out / "scene.kiln").read_bytes()).climate
        names = re.findall(r"^CLIMATE\((\w+)", (ROOT / "compiler/climate/climate_classes.inc").read_text(), re.MULTILINE)
        described = re.search(r"^climate +(\w+)", run("inspect", out / "scene.kiln").stdout, re.MULTILINE)
        self.assertEqual(names[climate.own], described.group(1))
        for node in climate.nodes:
            self.assertEqual(sum(node.values()), 255)
            self.assertLess(max(node), len(names))

    def test_says_what_is_around(self):
        self.assertIsNone(Manifest((self.compiled("crossing", GOLDEN / "crossing" / "map.osm", "--emit", "kiln", "--surroundings", "none") / "scene.kiln").read_bytes()).around)
        heights = self.folder / "wide.asc"
        rows = [[round(100 + 40 * math.sin(x / 3) + y) for x in range(60)] for y in range(60)]
        lon, lat = centre_of(GOLDEN / "crossing" / "map.osm")
        heights.write_text(f"ncols 60\nnrows 60\nxllcenter {lon - 0.3}\nyllcenter {lat - 0.3}\ncellsize 0.01\n"
                           + "\n".join(" ".join(map(str, row)) for row in rows))
        out = self.compiled("around", GOLDEN / "crossing" / "map.osm", "--dem", heights, "--emit", "kiln")
        around = Manifest((out / "scene.kiln").read_bytes()).around
        self.assertEqual((around.x, around.y), (sorted(set(around.x)), sorted(set(around.y))))
        self.assertGreater(len(around.x), 100)
        self.assertGreaterEqual(around.x[-1] - around.x[0], 120000)
        west, south, east, north = report_of(out)["region_m"]
        self.assertLessEqual({west, east}, set(around.x))
        self.assertLessEqual({south, north}, set(around.y))
        self.assertGreater(max(around.heights) - min(around.heights), 60)
        self.assertTrue(0 < around.rms_error_m <= around.error_m < 50)
        self.assertEqual(set(around.covers), {"land"})

    def test_says_where_things_are(self):
        chunks, _ = self.read(GOLDEN / "crossing")
        colours = [building[9] for chunk in chunks.values() for building in chunk.buildings]
        self.assertIn([200, 176, 144], colours)
        for (x, y), chunk in chunks.items():
            for _, footprint, *_ in chunk.buildings:
                self.assertTrue(all((px < 0) == (x < 0) and (py < 0) == (y < 0) for px, py in footprint))


if __name__ == "__main__":
    unittest.main()
