#!/usr/bin/env python3
"""3D Tiles follow the specification (OGC 22-025r4), by a reader of our own: the schema, volumes that contain what is below them, errors
that fall, contents that are there. They are on the globe where the plane's .glb files say, the same on every run, and whole in parts."""
import json
import math
import random
import unittest

from citykiln_program import TOWN, TOWN_MIDDLE, ProgramTest, bytes_of_outputs, long_test, report_of, run, sha256
from glb import Glb

ARGUMENTS = ["--spec", TOWN / "spec.json", *TOWN_MIDDLE, "--tile", "128", "--lods", "2.5,12.5", "--emit", "kiln,3dtiles"]
SLACK_M = 0.002
# volumes are known before baking: with room for cuts, banks, and plants wherever they may stand
LOOSE_M = 90

TILE_KEYS = {"boundingVolume", "viewerRequestVolume", "geometricError", "refine", "transform", "content", "contents", "metadata",
             "implicitTiling", "children", "extensions", "extras"}
TILESET_KEYS = {"asset", "properties", "schema", "schemaUri", "statistics", "groups", "metadata", "geometricError", "root", "extensionsUsed",
                "extensionsRequired", "extensions", "extras"}


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def outside_m(box, point):
    """How far a point is outside of a box of twelve numbers."""
    away = [p - c for p, c in zip(point, box[:3])]
    axes = [box[3:6], box[6:9], box[9:12]]
    return max(abs(dot(axis, away)) / math.sqrt(dot(axis, axis)) - math.sqrt(dot(axis, axis)) for axis in axes)


def corners(box):
    signs = [(a, b, c) for a in (-1, 1) for b in (-1, 1) for c in (-1, 1)]
    return [[box[i] + sum(s * box[3 + 3 * k + i] for k, s in enumerate(sign)) for i in range(3)] for sign in signs]


def turned(q, v):
    x, y, z, w = q
    t = [2 * (y * v[2] - z * v[1]), 2 * (z * v[0] - x * v[2]), 2 * (x * v[1] - y * v[0])]
    return [v[0] + w * t[0] + y * t[2] - z * t[1], v[1] + w * t[1] + z * t[0] - x * t[2], v[2] + w * t[2] + x * t[1] - y * t[0]]


def vertices(tile):
    """The vertices of a content in the frame of its tileset (z up), those of instances too. No node is scaled or turned but instances."""
    gltf = tile.gltf

    def visit(number, parent):
        node = gltf["nodes"][number]
        place = [p + t for p, t in zip(parent, node.get("translation", [0, 0, 0]))]
        instances = node.get("extensions", {}).get("EXT_mesh_gpu_instancing", {}).get("attributes")
        places = [((0, 0, 0), (0, 0, 0, 1), (1, 1, 1))]
        if instances:
            places = list(zip(*(tile.values(instances[name]) for name in ("TRANSLATION", "ROTATION", "SCALE"))))
        for primitive in gltf["meshes"][node["mesh"]]["primitives"] if "mesh" in node else []:
            points = tile.values(primitive["attributes"]["POSITION"])
            for at, turn, scale in places:
                for point in points:
                    x, y, z = (p + a + v for p, a, v in zip(place, at, turned(turn, [s * c for s, c in zip(scale, point)])))
                    yield x, -z, y
        for child in node.get("children", []):
            yield from visit(child, place)

    for root in gltf["scenes"][gltf.get("scene", 0)]["nodes"]:
        yield from visit(root, [0, 0, 0])


def triangles(tile):
    """The triangles of a content without its instances and plants, in the frame of its tileset (z up)."""
    gltf = tile.gltf

    def visit(number, parent):
        node = gltf["nodes"][number]
        place = [p + t for p, t in zip(parent, node.get("translation", [0, 0, 0]))]
        is_shown = "mesh" in node and "extensions" not in node and "plants" not in node.get("name", "")
        for primitive in gltf["meshes"][node["mesh"]]["primitives"] if is_shown else []:
            points = [(p[0] + place[0], -p[2] - place[2], p[1] + place[1]) for p in tile.values(primitive["attributes"]["POSITION"])]
            indices = [i[0] if isinstance(i, (tuple, list)) else i for i in tile.values(primitive["indices"])]
            yield from ([points[i] for i in indices[t:t + 3]] for t in range(0, len(indices), 3))
        for child in node.get("children", []):
            yield from visit(child, place)

    for root in gltf["scenes"][gltf.get("scene", 0)]["nodes"]:
        yield from visit(root, [0, 0, 0])


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def to_triangle_m(p, triangle):
    """The distance of a point from a triangle: to its plane where it is above the triangle, else to an edge."""
    a, b, c = triangle
    u, v, w = minus(b, a), minus(c, a), minus(p, a)
    uu, uv, vv, wu, wv = dot(u, u), dot(u, v), dot(v, v), dot(w, u), dot(w, v)
    area = uu * vv - uv * uv
    if area > 0:
        s, t = (vv * wu - uv * wv) / area, (uu * wv - uv * wu) / area
        if s >= 0 and t >= 0 and s + t <= 1:
            return math.dist(w, [s * x + t * y for x, y in zip(u, v)])

    def to_edge(q, r):
        edge = minus(r, q)
        size = dot(edge, edge)
        at = max(0, min(1, dot(minus(p, q), edge) / size)) if size else 0
        return math.dist(p, [x + at * y for x, y in zip(q, edge)])

    return min(to_edge(a, b), to_edge(b, c), to_edge(c, a))


def relisted(listed):
    """files.json, with tileset.json as a file whose bytes may differ."""
    files = [{"name": file["name"]} if file["name"] == "3dtiles/tileset.json" else file for file in listed["files"]]
    return {"files": files}


class Tileset:
    """All tiles of tileset.json and of the tilesets that it names: (tile, parent, is the root of an external tileset)."""

    def __init__(self, folder, test):
        self.folder, self.test, self.tiles, self.files = folder, test, [], []
        self.document = self.read("tileset.json", None)

    def read(self, name, referring):
        document = json.loads((self.folder / name).read_text())
        self.files.append(name)
        self.test.assertLessEqual(document.keys(), TILESET_KEYS)
        self.test.assertEqual(document["asset"]["version"], "1.1")
        self.test.assertGreater(document["geometricError"], document["root"]["geometricError"])
        self.test.assertIn("refine", document["root"])
        self.visit(document["root"], referring, referring is not None)
        return document

    def visit(self, tile, parent, is_external):
        self.tiles.append((tile, parent, is_external))
        self.test.assertLessEqual(tile.keys(), TILE_KEYS)
        self.test.assertEqual(len(tile["boundingVolume"]["box"]), 12)
        self.test.assertIn(tile.get("refine", "REPLACE"), ("REPLACE", "ADD"))
        uri = tile.get("content", {}).get("uri", "")
        if uri.endswith(".json"):
            self.test.assertNotIn("children", tile, "a tile with an external tileset has no children")
            self.read(uri, tile)
        for child in tile.get("children", []):
            self.test.assertNotIn("transform", child)
            self.visit(child, tile, False)

    def contents(self):
        found = {tile["content"]["uri"]: tile for tile, _, _ in self.tiles if tile.get("content", {}).get("uri", "").endswith(".glb")}
        self.test.assertTrue(found)
        return found


class Tiles3d(ProgramTest):
    def tileset(self, *arguments):
        return Tileset(self.compiled_once(*ARGUMENTS, *arguments) / "3dtiles", self)

    def test_errors_fall_and_volumes_hold_their_children(self):
        pairs = [(tile, parent, is_external) for tile, parent, is_external in self.tileset().tiles if parent]
        self.assertGreater(len(pairs), 6)
        for tile, parent, is_external in pairs:
            if is_external:
                self.assertLessEqual(tile["geometricError"], parent["geometricError"])
            else:
                self.assertLess(tile["geometricError"], parent["geometricError"])
            for corner in corners(tile["boundingVolume"]["box"]):
                self.assertLess(outside_m(parent["boundingVolume"]["box"], corner), SLACK_M)

    def test_contents_are_there_state_the_error_and_fill_their_volumes(self):
        tileset = self.tileset()
        for uri, tile in tileset.contents().items():
            with self.subTest(uri):
                content, box = Glb(tileset.folder / uri), tile["boundingVolume"]["box"]
                extras = content.gltf["nodes"][0]["extras"]
                self.assertGreaterEqual(tile["geometricError"], extras["error_m"])
                self.assertEqual(tile["extras"]["error_m"], tile["geometricError"])
                self.assertIn("OpenStreetMap", content.gltf["asset"]["copyright"])
                self.assertIn("EXT_structural_metadata", content.gltf["extensionsUsed"])
                self.assertEqual(any(content.osm_ids()), uri != "surroundings.glb")
                points = list(vertices(content))
                self.assertLess(max(outside_m(box, point) for point in points), SLACK_M)
                if "children" in tile:
                    continue
                # tight: a vertex near each side
                for k in range(3):
                    axis = box[3 + 3 * k:6 + 3 * k]
                    size = math.sqrt(dot(axis, axis))
                    along = [dot(axis, [p - c for p, c in zip(point, box[:3])]) / size for point in points]
                    self.assertLess(size - max(along), LOOSE_M)
                    self.assertLess(size + min(along), LOOSE_M)

    def test_inner_tiles_of_every_width_have_content_and_buildings_up_to_100_m(self):
        out = self.compiled("out", "--spec", TOWN / "spec.json", "--tile", "128", "--lods", "12.5", "--emit", "kiln,3dtiles")
        tileset = Tileset(out / "3dtiles", self)
        # the root holds the map's tiles and the land around
        for tile, parent, is_external in tileset.tiles:
            self.assertTrue(is_external or "content" in tile or parent is None)
        inner = {uri: tile for uri, tile in tileset.contents().items() if uri.startswith("Q")}
        heights = {int(uri[1]) for uri in inner}
        self.assertGreaterEqual(max(heights), 4)
        self.assertEqual(heights, set(range(1, max(heights) + 1)))
        for uri, tile in inner.items():
            tolerance_m = tile["extras"]["tolerance_m"]
            self.assertEqual(tolerance_m, 12.5 * 2**int(uri[1]))
            # the ellipsoid's sag; tiles joined from others spend their tolerance once more, and a quarter
            self.assertLess(tile["geometricError"], tolerance_m * (1.03 if tolerance_m * 0.75 <= 100 else 1.27))
        layers = {uri: {node.get("name") for node in Glb(tileset.folder / uri).gltf["nodes"]} for uri in inner}
        for height in (1, 2, 3):
            self.assertTrue(any("buildings" in layers[uri] for uri in layers if int(uri[1]) == height))

    @long_test
    def test_inner_tiles_are_as_near_to_finer_ones_as_both_state(self):
        tileset = self.tileset()
        contents = tileset.contents()
        inner = next(uri for uri in contents if uri.startswith("Q1_0_0"))
        surface = list(triangles(Glb(tileset.folder / inner)))
        boxes = [([min(c) for c in zip(*t)], [max(c) for c in zip(*t)]) for t in surface]
        draw = random.Random(1)
        fine = [uri for uri in contents if uri.endswith("_L0.glb")]
        allowed_m = contents[inner]["geometricError"] + max(contents[uri]["geometricError"] for uri in fine)
        farthest_m = 0
        for uri in fine:
            for triangle in draw.sample(list(triangles(Glb(tileset.folder / uri))), 40):
                place = [sum(c) / 3 for c in zip(*triangle)]
                nearest_m = math.inf
                for t, (low, high) in zip(surface, boxes):
                    out = [max(f - x, 0, x - h) for f, x, h in zip(low, place, high)]
                    if dot(out, out) < nearest_m**2:
                        nearest_m = min(nearest_m, to_triangle_m(place, t))
                farthest_m = max(farthest_m, nearest_m)
        self.assertGreater(farthest_m, 1)
        self.assertLessEqual(farthest_m, allowed_m)

    def test_every_file_is_named(self):
        tileset = self.tileset()
        self.assertEqual({path.name for path in tileset.folder.iterdir()}, set(tileset.files) | set(tileset.contents()))

    def test_the_root_stands_at_the_origin_on_the_ellipsoid(self):
        tileset = self.tileset()
        values = tileset.document["metadata"]["properties"]
        self.assertEqual(tileset.document["metadata"]["class"], "tileset")
        self.assertEqual(values.keys(), tileset.document["schema"]["classes"]["tileset"]["properties"].keys())
        lon, lat = math.radians(values["origin_lon_deg"]), math.radians(values["origin_lat_deg"])
        e2 = 2 / 298.257223563 - 1 / 298.257223563**2
        n = 6378137 / math.sqrt(1 - e2 * math.sin(lat)**2)
        expected = [-math.sin(lon), math.cos(lon), 0, 0,
                    -math.sin(lat) * math.cos(lon), -math.sin(lat) * math.sin(lon), math.cos(lat), 0,
                    math.cos(lat) * math.cos(lon), math.cos(lat) * math.sin(lon), math.sin(lat), 0,
                    n * math.cos(lat) * math.cos(lon), n * math.cos(lat) * math.sin(lon), n * (1 - e2) * math.sin(lat), 1]
        for found, wanted in zip(tileset.document["root"]["transform"], expected, strict=True):
            self.assertAlmostEqual(found, wanted, delta=1e-6 if abs(wanted) > 2 else 1e-13)
        self.assertIn("OpenStreetMap", values["attribution"])

    def test_a_geoid_height_lifts_everything(self):
        flat, lifted = self.tileset(), self.tileset("--geoid-height", "47.5")
        self.assertEqual(lifted.document["metadata"]["properties"]["geoid_height_m"], 47.5)
        self.assertIn("NoGeoidHeight", report_of(flat.folder.parent)["diagnoses"])
        self.assertNotIn("NoGeoidHeight", report_of(lifted.folder.parent)["diagnoses"])
        for uri in flat.contents().keys() - {"surroundings.glb"}:
            for a, b in zip(vertices(Glb(flat.folder / uri)), vertices(Glb(lifted.folder / uri)), strict=True):
                self.assertAlmostEqual(b[2] - a[2], 47.5, delta=0.003)
                # verticals diverge by 47.5 m / the Earth's radius
                self.assertAlmostEqual(b[0] - a[0], 0, delta=0.02)

    def test_a_geoid_of_geographiclib_is_read(self):
        # 30 degrees a point, rising by 1 m from row to row towards the south
        samples = b"".join((row * 100).to_bytes(2, "big") * 12 for row in range(7))
        path = self.folder / "made.pgm"
        path.write_bytes(b"P5\n# Offset 0\n# Scale 0.01\n# Origin 90N 0E\n12 7\n65535\n" + samples)
        tileset = self.tileset("--geoid-height", path)
        found = tileset.document["metadata"]["properties"]["geoid_height_m"]
        self.assertAlmostEqual(found, (90 - 48.7) / 30, delta=0.05)

    @long_test
    def test_threads_and_verbs_change_no_byte(self):
        one = self.compiled("t1", *ARGUMENTS, "--threads", 1)
        many = self.compiled_once(*ARGUMENTS)
        self.assertEqual(bytes_of_outputs(one), bytes_of_outputs(many))
        baked = self.folder / "baked"
        done = run("bake", many / "scene.kiln", "--lods", "2.5,12.5", "--emit", "kiln,3dtiles", "-o", baked)
        self.assertEqual(done.returncode, 0, done.stderr)
        for folder in (many, baked):
            self.assertEqual(sha256(one / "3dtiles" / "tileset.json"), sha256(folder / "3dtiles" / "tileset.json"))
        self.assertEqual(bytes_of_outputs(one), bytes_of_outputs(baked))

    @long_test
    def test_tiles_made_apart_are_those_of_the_whole(self):
        whole, part = self.tileset(), self.tileset("--only", "0_0,-1_0")
        common = [uri for uri in part.contents() if not uri.startswith("Q")]
        self.assertEqual(len(common), 4)
        for uri in common:
            self.assertEqual(sha256(whole.folder / uri), sha256(part.folder / uri))

    def test_check_finds_no_fault_and_finds_what_is_broken(self):
        out = self.compiled("out", *ARGUMENTS)
        done = run("check", out)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        path = out / "3dtiles" / "tileset.json"
        text = path.read_text()
        breaks = {"geometricError falls": lambda t: t["root"].update(geometricError=0.5),
                  "bounding volumes": lambda t: t["root"]["boundingVolume"]["box"].__setitem__(0, 1e5),
                  "3D Tiles follow": lambda t: t["root"]["transform"].__setitem__(12, 4.1e6)}
        listed = json.loads((out / "files.json").read_text())
        for claim, make_wrong in breaks.items():
            with self.subTest(claim):
                tileset = json.loads(text)
                make_wrong(tileset)
                path.write_text(json.dumps(tileset))
                (out / "files.json").write_text(json.dumps(relisted(listed)))
                done = run("check", out)
                self.assertEqual(done.returncode, 1, done.stdout)
                self.assertIn(claim, done.stderr)

    def test_wrong_worlds_and_geoids_are_one_clear_line(self):
        for arguments, words in ((["--world", "plane"], "--world"), (["--geoid-height", "high"], "--geoid-height"),
                                 (["--geoid-height", self.folder / "none.pgm"], "none.pgm")):
            with self.subTest(arguments):
                done = run("compile", *ARGUMENTS, *arguments, "-o", self.folder / "x")
                self.assertEqual(done.returncode, 1)
                self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)
                self.assertIn(words, done.stderr)
                self.assertFalse((self.folder / "x").exists())
        done = run("compile", "--spec", TOWN / "spec.json", "--emit", "glb", "--world", "ellipsoid", "-o", self.folder / "x")
        self.assertEqual(done.returncode, 1)
        self.assertIn("--world", done.stderr)


if __name__ == "__main__":
    unittest.main()
