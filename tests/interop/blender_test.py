#!/usr/bin/env python3
"""Blender imports the town upright, in metres and in its place; instances share their mesh; materials keep their values. Blender's
data are compared with the JSON chunk of the .glb and with the output of `citykiln inspect`."""
import json
import os
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "properties"))
from citykiln_program import TOWN, ProgramTest, run  # noqa: E402
from glb import Glb  # noqa: E402

BLENDER = shutil.which("blender")
# the tool that writes tiles with a marking atlas
MADE_GLB = os.environ.get("MADE_GLB")
SCRIPT = Path(__file__).resolve().parent / "import_blender.py"

# Coordinates are on a grid of 2^-10 m; Blender holds them in single precision, 1 km from the plane's origin.
NEAR_M = 2e-4


def z_up(v):
    return [v[0], -v[2], v[1]]


def box_of(gltf, mesh):
    """The box of a mesh from its accessors' min and max, in Blender's axes, relative to the mesh's origin."""
    accessors = [gltf["accessors"][p["attributes"]["POSITION"]] for p in mesh["primitives"]]
    corners = [z_up(a[end]) for a in accessors for end in ("min", "max")]
    return [min(c[i] for c in corners) for i in range(3)], [max(c[i] for c in corners) for i in range(3)]


class BlenderTest(ProgramTest):
    """Imports the files that `written` writes into Blender, once for all tests of the class."""

    @classmethod
    def setUpClass(cls):
        cls.keeper = ProgramTest()
        cls.keeper.setUp()
        cls.addClassCleanup(cls.keeper.doCleanups)
        cls.paths = cls.written(cls.keeper)
        facts = cls.keeper.folder / "facts.json"
        cls.done = subprocess.run([BLENDER, "-b", "--factory-startup", "-noaudio", "--python-exit-code", "3", "-P", SCRIPT, "--", facts, *cls.paths],
                                  capture_output=True, text=True, check=False,
                                  # Blender looks for its Python library beside the first python3 on the PATH
                                  env={**os.environ, "PATH": "/usr/bin:/bin"})
        if cls.done.returncode != 0:
            raise AssertionError(cls.done.stdout[-2000:] + cls.done.stderr[-2000:])
        cls.tiles = list(zip(cls.paths, (Glb(path).gltf for path in cls.paths), json.loads(facts.read_text()), strict=True))
        assert cls.tiles

    def assert_near(self, a, b, near=NEAR_M):
        for x, y in zip(a, b, strict=True):
            self.assertLess(abs(x - y), near, (a, b))


class BlenderImport(BlenderTest):
    @classmethod
    def written(cls, keeper):
        out = keeper.compiled("town", "--spec", TOWN / "spec.json", "--lods", "0.5", "--target", "blender", "--split", "tile")
        return sorted((out / "glb").glob("*.glb"))

    def test_blender_prints_no_error(self):
        self.assertGreater(len(self.tiles), 1)
        for word in ("error", "traceback", "unknown", "not supported"):
            self.assertNotIn(word, (self.done.stdout + self.done.stderr).lower())

    def test_tiles_lie_in_metres_where_they_belong(self):
        for _, gltf, facts in self.tiles:
            root = gltf["nodes"][0]
            low, high = box_of(gltf, gltf["meshes"][root["mesh"]])
            at = z_up(root["translation"])
            self.assert_near(at, root["extras"]["origin_m"])
            self.assertEqual(facts["unit_m"], 1)
            self.assert_near(facts["tile"]["low_m"], [a + b for a, b in zip(at, low)])
            self.assert_near(facts["tile"]["high_m"], [a + b for a, b in zip(at, high)])

    def test_the_ground_faces_up(self):
        for _, _, facts in self.tiles:
            size = [high - low for low, high in zip(facts["tile"]["low_m"], facts["tile"]["high_m"])]
            # roofs that overhang the tile's edge enlarge the box, but not the ground
            self.assertGreater(facts["tile"]["area_seen_from_above_m2"], 0.8 * size[0] * size[1])
            self.assertLess(size[2], 0.3 * min(size[:2]))

    def test_buildings_stand_as_high_as_they_are(self):
        roofs = 0
        for _, gltf, facts in self.tiles:
            base = gltf["nodes"][0]["translation"][1]
            heights = {}
            for primitive in gltf["meshes"][gltf["nodes"][0]["mesh"]]["primitives"]:
                accessor = gltf["accessors"][primitive["attributes"]["POSITION"]]
                heights.setdefault(gltf["materials"][primitive["material"]]["name"], []).extend([accessor["min"][1], accessor["max"][1]])
            for name, z in heights.items():
                found = facts["tile"]["materials"][name]
                self.assert_near(found["z_m"], [base + min(z), base + max(z)])
                roofs += name in ("RoofTile", "Slate", "FlatRoof", "MetalRoof") and found["z_m"][1] > base + 5
        self.assertGreater(roofs, 0)

    def test_no_triangle_is_lost(self):
        for path, _, facts in self.tiles:
            said = json.loads(run("inspect", path, "--json").stdout)
            self.assertEqual({name: row["triangles"] for name, row in facts["tile"]["materials"].items()}, said["materials"])
            copies = {name: len(row["places"]) for name, row in facts["copies"].items()}
            self.assertEqual(copies, said["instanced"])
            triangles = sum(row["triangles"] for row in facts["tile"]["materials"].values())
            triangles += sum(row["triangles"] * len(row["places"]) for row in facts["copies"].values())
            self.assertEqual(triangles, said["triangles"])

    def test_instances_share_their_mesh(self):
        shared = 0
        for _, gltf, facts in self.tiles:
            # one mesh is the tile's own
            self.assertEqual(facts["meshes"], 1 + len(facts["copies"]))
            self.assertEqual(facts["meshes"], len(gltf["meshes"]))
            for row in facts["copies"].values():
                self.assertEqual(row["users"], len(row["places"]))
                shared += row["users"] > 1
        self.assertGreater(shared, 0)

    def test_instances_are_upright_in_their_places(self):
        for _, gltf, facts in self.tiles:
            root = z_up(gltf["nodes"][0]["translation"])
            for name, row in facts["copies"].items():
                nodes = [node for node in gltf["nodes"][1:] if node["name"] == name]
                wanted = sorted([a + b for a, b in zip(root, z_up(node["translation"]))] for node in nodes)
                for at, place in zip(wanted, sorted(place["at_m"] for place in row["places"]), strict=True):
                    self.assert_near(at, place)
                for place in row["places"]:
                    self.assert_near(place["up"], [0, 0, 1], 1e-5)
                    self.assert_near(place["scale"], [place["scale"][0]] * 3, 1e-4)
                    self.assertIsInstance(place["feature"], int)
                # rooted on the ground, taller than wide
                low, high = row["local_low_m"], row["local_high_m"]
                self.assertLess(abs(low[2]), 0.1)
                self.assertGreater(high[2], high[0] - low[0])

    def test_materials_arrive_with_their_values(self):
        for _, gltf, facts in self.tiles:
            self.assertEqual(sorted(facts["materials"]), sorted(material["name"] for material in gltf["materials"]))
            for material in gltf["materials"]:
                values, found = material["pbrMetallicRoughness"], facts["materials"][material["name"]]
                if "baseColorTexture" not in values:
                    self.assert_near(found["colour"], values["baseColorFactor"][:3], 1e-5)
                if "metallicRoughnessTexture" in values:
                    self.assertTrue(found["roughness_is_picture"])
                else:
                    self.assertLess(abs(found["roughness"] - values["roughnessFactor"]), 1e-5)

    def test_name_and_extras_of_the_tile_arrive(self):
        for _, gltf, facts in self.tiles:
            self.assertEqual(facts["extras"], sorted(gltf["nodes"][0]["extras"]))
            self.assertEqual(facts["root"], gltf["nodes"][0]["name"])


@unittest.skipUnless(MADE_GLB, "MADE_GLB is not set")
class BlenderMarkingAtlas(BlenderTest):
    @classmethod
    def written(cls, keeper):
        subprocess.run([MADE_GLB, keeper.folder], check=True)
        return [keeper.folder / "marked_nodes.glb"]

    def test_marked_materials_share_one_picture_scaled_in_metres(self):
        [(_, gltf, facts)] = self.tiles
        marked = [material for material in gltf["materials"] if material["name"].endswith("Marked")]
        self.assertEqual(len(marked), 3)
        self.assertEqual(len(facts["pictures"]), 1)
        for material in marked:
            found = facts["materials"][material["name"]]
            scale = material["pbrMetallicRoughness"]["baseColorTexture"]["extensions"]["KHR_texture_transform"]["scale"]
            self.assertTrue(found["has_pixels"])
            self.assertEqual(found["picture_px"], facts["pictures"][0])
            self.assert_near(found["scale"][:2], scale, 1e-6)
            # glTF counts v down from the top of a picture, Blender up from the bottom
            self.assert_near(found["location"][:2], [0, 1 - scale[1]], 1e-6)

    def test_texture_coordinates_are_metres_on_the_atlas(self):
        # made_tile.h gives each corner the texture coordinates (x, 16 km + y)
        [(_, _, facts)] = self.tiles
        for name in ("AsphaltMarked", "PavingMarked"):
            self.assertEqual(len(facts["uvs"][name]), 12)
            for (x, y, _), (u, v) in facts["uvs"][name]:
                self.assert_near([u, 1 - v], [x, 16000 + y], 0.003)


if __name__ == "__main__":
    if not BLENDER:
        print("Blender is not installed (./setup.sh release interop): skipped")
        sys.exit(77)
    unittest.main(verbosity=2)
