#!/usr/bin/env python3
"""Tests that USD outputs, read and composed by usd.py, say what the .glb of the same run say, and that damage is found."""
import json
import math
import shutil
import struct
import sys
import unittest
import zipfile
from pathlib import Path

from citykiln_program import TOWN, ProgramTest, long_test, report_of, run, sha256
from glb import Glb
from usd import Crate, Stage, UsdError, faults, read_layer, rotated

LEVELS_M = "2.5,12.5"
LAYERS = ("ground", "roads", "water", "buildings", "structures", "props", "plants")


def hashes(folder):
    return {str(p.relative_to(folder)): sha256(p) for p in sorted(Path(folder, "usd").rglob("*")) if p.is_file()}


def prim_of(tile):
    return "/scene/tiles/tile_" + "_".join(f"m{-n}" if n < 0 else str(n) for n in tile)


def bounds(points):
    return [[f(axis) for axis in zip(*points)] for f in (min, max)]


def turned(accessor):
    """Low and high of glTF's y-up positions with z up."""
    (ax, ay, az), (bx, by, bz) = accessor["min"], accessor["max"]
    return [[ax, -bz, ay], [bx, -az, by]]


# Candela of a lumen, and the unit of a scene's radiance in cd/m2 (exporters/usd)
CANDELA = {"SphereLight": 1 / (3 * math.pi), "DiskLight": 1 / math.pi}
UNIT_CD_M2 = 127500 * math.exp(-0.21) / math.pi


class LightsOfUsd(ProgramTest):
    def test_lamps_are_the_lights_of_the_glb(self):
        town = self.compiled("lit", "--spec", TOWN / "spec.json", "--lods", "12.5", "--emit", "glb,usd", "--lights", "200")
        stage, kinds = Stage(town / "usd/scene.usda"), set()
        for x, y in [(t["x"], t["y"]) for t in report_of(town)["usd"]]:
            group = stage.root.at(prim_of((x, y))).children["lights"].children.values()
            nodes = [n for n in Glb(town / f"glb/{x}_{y}_L0.glb").gltf["nodes"] if "KHR_lights_punctual" in n.get("extensions", {})]
            self.assertGreaterEqual(len(group), 10)
            for lamp, node in zip(group, nodes, strict=True):
                for own, other in zip(lamp.attributes["xformOp:translate"], [node["translation"][0], -node["translation"][2], node["translation"][1]]):
                    self.assertAlmostEqual(own, other, delta=1e-3)
                self.assertEqual(lamp.metadata["customData"]["lumen"], node["extras"]["lumen"])
                self.assertEqual(lamp.metadata["customData"]["osm_id"], str(int(node["extras"]["osm_id"])))
                disk_m2 = math.pi * lamp.attributes["inputs:radius"] ** 2
                colour = sum(a * b for a, b in zip(lamp.attributes["inputs:color"], (0.2126, 0.7152, 0.0722)))
                candela = lamp.attributes["inputs:intensity"] * colour * UNIT_CD_M2 * disk_m2
                self.assertAlmostEqual(candela / (CANDELA[lamp.kind] * node["extras"]["lumen"]), 1, delta=1e-3)
                kinds.add(lamp.kind)
        self.assertEqual(kinds, set(CANDELA))


def single(value):
    """The number in single precision."""
    return struct.unpack("f", struct.pack("f", value))[0]


class WhatUsdSays(ProgramTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.kept = cls.enterClassContext(__import__("tempfile").TemporaryDirectory(prefix="citykiln_usd_"))
        cls.town = Path(cls.kept) / "town"
        done = run("compile", "--spec", TOWN / "spec.json", "--lods", LEVELS_M, "--target", "godot", "--emit", "kiln,glb,usd", "-o", cls.town)
        assert done.returncode == 0, done.stderr
        cls.tiles = [(t["x"], t["y"]) for t in report_of(cls.town)["usd"] if t["level"] == 0]
        assert len(cls.tiles) == 4
        cls.stages = [Stage(cls.town / "usd/scene.usda", {prim_of(t): f"L{n}" for t in cls.tiles}) for n in range(2)]

    def each_level(self):
        for n, stage in enumerate(self.stages):
            for tile in self.tiles:
                yield stage.root.at(prim_of(tile)), Glb(self.town / f"glb/{tile[0]}_{tile[1]}_L{n}.glb"), n, tile

    def test_the_scene_holds_together(self):
        for stage in self.stages:
            self.assertGreater(len(stage.root.below("Mesh")), 100)
            self.assertGreater(len(stage.root.below("PointInstancer")), 3)
            self.assertEqual(faults(stage), [])
            self.assertEqual((stage.metadata["upAxis"], stage.metadata["metersPerUnit"]), ("Z", 1))

    def test_every_layer_states_the_attribution(self):
        layers = [p for p in (self.town / "usd").rglob("*.usd?")]
        self.assertEqual(len(layers), 1 + 4 + 8 + 1)  # the scene, tiles, levels, the land around
        for path in layers:
            self.assertEqual(read_layer(path).metadata["customLayerData"]["attribution"], "© OpenStreetMap contributors")

    def test_a_scene_without_payloads_opens_no_tile_and_knows_their_bounds(self):
        stage = Stage(self.town / "usd/scene.usda", loads=False)
        self.assertEqual(len(stage.files), 1)
        self.assertEqual(stage.root.below("Mesh"), [])
        for tile in self.tiles:
            prim, loaded = stage.root.at(prim_of(tile)), self.stages[0].root.at(prim_of(tile))
            low, high = prim.attributes["extentsHint"]
            for mesh in [m for name in ("ground", "buildings") for m in loaded.at(name).below("Mesh")]:
                near = 1e-3
                self.assertTrue(all(a - near <= b for a, b in zip(low, mesh.attributes["extent"][0])), mesh.path)
                self.assertTrue(all(a + near >= b for a, b in zip(high, mesh.attributes["extent"][1])), mesh.path)

    def test_the_default_variant_is_the_finest(self):
        stage = Stage(self.town / "usd/scene.usda")
        for tile in self.tiles:
            own, finest = stage.root.at(prim_of(tile)), self.stages[0].root.at(prim_of(tile))
            self.assertEqual(own.metadata["customData"], finest.metadata["customData"])

    def test_errors_and_places_are_those_of_the_glb(self):
        errors = set()
        for tile, glb, *_ in self.each_level():
            extras = glb.gltf["nodes"][0]["extras"]
            for key in ("tolerance_m", "error_m", "plant_error_m"):
                self.assertEqual(tile.metadata["customData"][key], extras[key])
            self.assertEqual(tile.attributes["xformOp:translate"], extras["origin_m"])
            errors.add(extras["error_m"])
        self.assertGreater(len(errors), 4)

    def test_meshes_of_each_layer_are_those_of_the_glb(self):
        compared = 0
        for tile, glb, *_ in self.each_level():
            nodes = {n["name"]: n for n in glb.gltf["nodes"]}
            for layer in filter(nodes.__contains__, LAYERS):
                meshes = [p for p in tile.at(layer).children.values() if p.kind == "Mesh"]
                primitives = glb.gltf["meshes"][nodes[layer]["mesh"]]["primitives"] if "mesh" in nodes[layer] else []
                positions = [glb.gltf["accessors"][p["attributes"]["POSITION"]] for p in primitives]
                faces = [glb.gltf["accessors"][p["indices"]]["count"] // 3 for p in primitives]
                # a .glb splits meshes of more than 65,535 vertices
                self.assertEqual(sum(len(m.attributes["points"]) for m in meshes), sum(p["count"] for p in positions))
                self.assertEqual(sum(len(m.attributes["faceVertexCounts"]) for m in meshes), sum(faces))
                if positions:
                    self.assertEqual(bounds([c for m in meshes for c in m.attributes["extent"]]),
                                     bounds([c for p in positions for c in turned(p)]))
                    compared += 1
        self.assertGreater(compared, 30)

    def test_vertices_are_those_of_the_glb(self):
        textured = 0
        for tile, glb, *_ in self.each_level():
            node = next(n for n in glb.gltf["nodes"] if n["name"] == "buildings")
            meshes = [p for p in tile.at("buildings").children.values() if p.kind == "Mesh"]
            primitives = glb.gltf["meshes"][node["mesh"]]["primitives"]
            self.assertEqual(len(meshes), len(primitives))
            for mesh, primitive in zip(meshes, primitives):
                values = {name: glb.values(number) for name, number in primitive["attributes"].items()}
                self.assertEqual(mesh.attributes["points"], [[x, -z, y] for x, y, z in values["POSITION"]])
                self.assertEqual(mesh.attributes["normals"], [[x, -z, y] for x, y, z in values["NORMAL"]])
                if "primvars:st" in mesh.attributes:
                    for (s, t), (u, v) in zip(mesh.attributes["primvars:st"], values["TEXCOORD_0"], strict=True):
                        self.assertEqual(s, u)
                        self.assertAlmostEqual(t, 1 - v, places=4)
                    textured += 1
        self.assertGreater(textured, 3)

    def test_instances_are_those_of_the_glb(self):
        compared = 0
        for tile, glb, *_ in self.each_level():
            nodes = {n["name"]: n for n in glb.gltf["nodes"]}
            for layer in filter(nodes.__contains__, LAYERS):
                own = [glb.gltf["nodes"][i] for i in nodes[layer].get("children", [])]
                instancers = [p for p in tile.at(layer).children.values() if p.kind == "PointInstancer"]
                self.assertEqual(len(instancers), 1 if own else 0)
                if not own:
                    continue
                values = instancers[0].attributes
                # a .glb has the shortest numbers that give the same single precision
                x, y, z = zip(*([single(v) for v in n["translation"]] for n in own))
                self.assertEqual(values["positions"], [[a, -c, b] for a, b, c in zip(x, y, z)])
                self.assertEqual([s[0] for s in values["scales"]], [single(n["scale"][0]) for n in own])
                names = [instancers[0].targets["prototypes"][i].rsplit("/", 1)[1] for i in values["protoIndices"]]
                self.assertEqual(names, [n["name"] for n in own])
                for q, node in zip(values["orientations"], own):
                    a, b, c, w = node["rotation"]
                    for one, other in zip(q, (w, a, -c, b)):
                        self.assertAlmostEqual(one, other, delta=2**-11)
                compared += len(own)
        self.assertGreater(compared, 1000)

    def test_extents_of_instancers_hold_every_instance(self):
        instancer = self.stages[1].root.at(prim_of(self.tiles[0]) + "/plants/instances")
        values, low, high = instancer.attributes, *instancer.attributes["extent"]
        self.assertGreater(len(values["positions"]), 10)
        for at, q, scale, number in zip(*(values[n] for n in ("positions", "orientations", "scales", "protoIndices"))):
            for mesh in self.stages[1].root.at(instancer.targets["prototypes"][number]).below("Mesh"):
                for point in mesh.attributes["points"]:
                    placed = [a + b for a, b in zip(at, rotated(q, [p * s for p, s in zip(point, scale)]))]
                    self.assertTrue(all(a - 0.02 <= b <= c + 0.02 for a, b, c in zip(low, placed, high)))

    def test_ids_are_those_of_the_glb(self):
        for tile, glb, *_ in self.each_level():
            table = tile.at("features").attributes
            self.assertGreater(len(table["osm:id"]), 20)
            self.assertEqual(tuple(table["osm:id"]), glb.osm_ids())
            self.assertEqual(len(table["osm:class"]), len(table["osm:id"]))
        stage = self.stages[0].root
        names = {n for t in self.tiles for n in stage.at(prim_of(t) + "/features").attributes.get("osm:name", [])}
        self.assertGreater(len(names), 3)

    def test_faces_of_a_building_have_its_feature(self):
        tile, glb, *_ = next(self.each_level())
        classes = tile.at("features").attributes["osm:class"]
        for mesh in tile.at("buildings").below("Mesh"):
            self.assertEqual(mesh.details["primvars:feature"]["interpolation"], "uniform")
            rows = mesh.attributes["primvars:feature"]
            self.assertEqual(len(rows), len(mesh.attributes["faceVertexCounts"]))
            self.assertTrue(all(classes[row] for row in rows))

    def test_the_sun_shines_from_where_the_sky_says(self):
        sun = self.stages[0].root.at("/scene/sun")
        to_sun = sun.attributes["xformOp:transform"][2][:3]
        # azimuth 266 and elevation 36 degrees at 2026-06-21T15:20 in UTC, 12.3 E, 48.7 N
        for one, other in zip(to_sun, (-0.809, -0.063, 0.585)):
            self.assertAlmostEqual(one, other, delta=0.01)
        for row in sun.attributes["xformOp:transform"][:3]:
            self.assertAlmostEqual(sum(c * c for c in row), 1, delta=1e-4)

    @long_test
    def test_bytes_depend_on_neither_threads_nor_the_command(self):
        want = hashes(self.town)
        self.assertGreater(len(want), 20)
        one = self.compiled("one", "--spec", TOWN / "spec.json", "--lods", LEVELS_M, "--emit", "usd", "--threads", "1")
        self.assertEqual(hashes(one), want)
        baked = self.folder / "baked"
        done = run("bake", self.town / "scene.kiln", "--lods", LEVELS_M, "--emit", "usd", "-o", baked)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(hashes(baked), want)
        self.assertEqual(report_of(baked)["usd"], report_of(self.town)["usd"])
        self.assertEqual(report_of(baked)["tiles"], [])

    def test_a_usdz_has_the_layer_and_its_textures(self):
        file = self.folder / "tile.usdz"
        done = run("bake", self.town / "scene.kiln", "--tile", "0_0", "--tolerance", "2.5", "-o", file)
        self.assertEqual(done.returncode, 0, done.stderr)
        with zipfile.ZipFile(file) as archive:
            self.assertIsNone(archive.testzip())
            members = archive.infolist()
            self.assertEqual(members[0].filename, "tile.usdc")
            self.assertGreaterEqual(len(members), 4)
            data = file.read_bytes()
            for member in members:
                self.assertEqual(member.compress_type, zipfile.ZIP_STORED)
                name, extra = struct.unpack_from("<HH", data, member.header_offset + 26)
                self.assertEqual((member.header_offset + 30 + name + extra) % 64, 0, member.filename)
            archive.extractall(self.folder / "unpacked")
        stage = Stage(self.folder / "unpacked/tile.usdc")
        self.assertEqual(faults(stage), [])
        folder = self.stages[0].root.at(prim_of((0, 0)))
        self.assertEqual([m.attributes["points"] for m in stage.default.below("Mesh")],
                         [m.attributes["points"] for m in folder.below("Mesh")])

    def test_one_layer_as_one_file_is_refused(self):
        file = self.folder / "tile.usda"
        done = run("bake", self.town / "scene.kiln", "--tile", "0_0", "--tolerance", "2.5", "-o", file)
        self.assertEqual(done.returncode, 1)
        self.assertIn("give FILE.usdz", done.stderr)
        self.assertFalse(file.exists())


@long_test
class DamageIsFound(ProgramTest):
    """Damage on purpose: by usd.py, and by `check` where the file list does not know the file's bytes."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.kept = cls.enterClassContext(__import__("tempfile").TemporaryDirectory(prefix="citykiln_usd_"))
        cls.whole = Path(cls.kept) / "whole"
        done = run("compile", "--spec", TOWN / "spec.json", "--lods", LEVELS_M, "--only", "0_0", "--emit", "kiln,usd", "-o", cls.whole)
        assert done.returncode == 0, done.stderr

    def setUp(self):
        super().setUp()
        self.out = self.folder / "out"
        shutil.copytree(self.whole, self.out)
        self.scene, self.tile = self.out / "usd/scene.usda", self.out / "usd/tiles/0_0.usda"
        self.level = self.out / "usd/tiles/0_0_L1.usdc"

    def assertCheckFinds(self, file, *texts):
        listed = json.loads((self.out / "files.json").read_text())
        entry = next(f for f in listed["files"] if f["name"] == str(file.relative_to(self.out)))
        for key in ("bytes", "hash"):
            entry.pop(key, None)
        (self.out / "files.json").write_text(json.dumps(listed))
        done = run("check", self.out)
        self.assertEqual(done.returncode, 1, done.stdout)
        for text in texts:
            self.assertIn(text, done.stderr)

    def replace(self, file, old, new):
        text = file.read_text()
        self.assertIn(old, text)
        file.write_text(text.replace(old, new))

    def plain_array(self, name, most):
        """The place of an array of a mesh, not compressed, and its length."""
        data = self.level.read_bytes()
        crate = Crate(data)
        crate.layer()
        for path, place in crate.places.items():
            count = struct.unpack_from("<Q", data, place - 8)[0]
            if path.endswith("." + name) and count <= most:
                return path, place, count
        self.fail(f"no array {name}")

    def patch(self, place, form, value):
        data = bytearray(self.level.read_bytes())
        struct.pack_into(form, data, place, value)
        self.level.write_bytes(data)

    def test_the_undamaged_run_passes(self):
        self.assertEqual(faults(Stage(self.scene)), [])
        done = run("check", self.out)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("the USD scene has every tile at its place", done.stdout)

    def test_a_level_that_is_not_there(self):
        self.level.unlink()
        with self.assertRaises(UsdError):
            Stage(self.scene, {prim_of((0, 0)): "L1"})
        done = run("check", self.out)
        self.assertEqual(done.returncode, 1)
        self.assertIn("0_0_L1.usdc is missing", done.stderr)

    def test_a_broken_reference(self):
        self.replace(self.scene, "@./tiles/0_0.usda@", "@./tiles/0_1.usda@")
        with self.assertRaises(UsdError):
            Stage(self.scene)
        self.assertCheckFinds(self.scene, "has no payload usd/tiles/0_0.usda")

    def test_a_wrong_level_in_a_variant(self):
        self.replace(self.tile, "@./0_0_L1.usdc@", "@./0_0_L0.usdc@")
        stage = Stage(self.scene, {prim_of((0, 0)): "L1"})
        tile = stage.root.at(prim_of((0, 0)))
        own = read_layer(tile.layers[-1]).children["tile"].metadata["customData"]
        self.assertNotEqual(tile.metadata["customData"]["tolerance_m"], own["tolerance_m"])
        self.assertCheckFinds(self.tile, "the variant L1 is not level 1")

    def test_a_variant_that_is_not_there(self):
        self.replace(self.tile, 'string level = "L0"', 'string level = "L7"')
        with self.assertRaises(UsdError):
            Stage(self.scene)
        self.assertCheckFinds(self.tile, "does not show L0")

    def test_a_tile_at_another_place(self):
        self.replace(self.tile, "xformOp:translate = (0,", "xformOp:translate = (1,")
        self.assertCheckFinds(self.tile, "is at another place than in the scene")
        self.replace(self.scene, "xformOp:translate = (0,", "xformOp:translate = (1,")
        self.assertCheckFinds(self.scene, "usd/tiles/0_0.usda is not at the origin of usd/tiles/0_0_L0.usdc")

    def test_a_turned_face(self):
        _, place, _ = self.plain_array("faceVertexIndices", 15)
        first, second = struct.unpack_from("<ii", self.level.read_bytes(), place)
        self.patch(place, "<i", second)
        self.patch(place + 4, "<i", first)
        self.assertCheckFinds(self.level, "the meshes of", "are others than those of the .glb")

    def test_an_index_out_of_range(self):
        path, place, _ = self.plain_array("faceVertexIndices", 15)
        self.patch(place, "<i", 999999)
        found = faults(Stage(self.scene, {prim_of((0, 0)): "L1"}))
        self.assertTrue(any("an index beyond its points" in f for f in found), found)
        self.assertCheckFinds(self.level, path.split(".")[0], "has an index beyond its points")

    def test_a_moved_point(self):
        path, place, _ = self.plain_array("points", 10**9)
        self.patch(place, "<f", -5000.0)
        found = faults(Stage(self.scene, {prim_of((0, 0)): "L1"}))
        self.assertTrue(any("extent" in f for f in found), found)
        self.assertCheckFinds(self.level, "states another extent than that of its points")

    def test_a_moved_instance(self):
        _, place, _ = self.plain_array("positions", 10**9)
        self.patch(place, "<f", -5000.0)
        self.assertCheckFinds(self.level, "the instances of", "are others than those of the .glb")

    def test_a_larger_instance(self):
        _, place, _ = self.plain_array("scales", 10**9)
        self.patch(place, "<f", 3.0)
        self.assertCheckFinds(self.level, "the instances of", "are others than those of the .glb")

    def test_a_turned_instance(self):
        _, place, _ = self.plain_array("orientations", 10**9)
        half, = struct.unpack_from("<e", self.level.read_bytes(), place)
        self.patch(place, "<e", half + 0.01 if half < 0.5 else half - 0.01)
        self.assertCheckFinds(self.level, "the instances of", "are others than those of the .glb")

    def test_a_texture_that_is_not_there(self):
        textures = sorted((self.out / "usd/textures").iterdir())
        self.assertGreaterEqual(len(textures), 3)
        for texture in textures:
            texture.unlink()
        found = faults(Stage(self.scene))
        self.assertTrue(any("a texture that is not there" in f for f in found), found)

    def test_a_crate_that_is_cut_off(self):
        self.level.write_bytes(self.level.read_bytes()[:-100])
        self.assertCheckFinds(self.level, "is no crate that citykiln wrote")


if __name__ == "__main__":
    sys.exit(unittest.main(argv=[sys.argv[0], "-v"]))
