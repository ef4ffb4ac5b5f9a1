#!/usr/bin/env python3
"""Blender imports the town upright, in metres and in its place; instances share their mesh; materials keep their values. Blender's
data are compared with the JSON chunk of the .glb. readers_test.py tests that no triangle is lost."""
import os
import subprocess
import sys
import unittest

import readers
from glb import Glb
from readers import ReaderTest

# the tool that writes tiles with a marking atlas
MADE_GLB = os.environ.get("MADE_GLB")


def z_up(v):
    return [v[0], -v[2], v[1]]


class BlenderTest(ReaderTest):
    """Imports the files that `written` writes into Blender, once for all tests of the class."""

    @classmethod
    def setUpClass(cls):
        cls.keeper = ReaderTest()
        cls.keeper.setUp()
        cls.addClassCleanup(cls.keeper.doCleanups)
        paths = cls.written(cls.keeper)
        found, cls.printed = readers.run_blender(cls.keeper.folder, paths)
        cls.tiles = list(zip((Glb(path).gltf for path in paths), found, strict=True))
        assert cls.tiles


LAYERS = {"ground", "roads", "water", "buildings", "structures", "props", "ArmLamp", "PostTopLamp"}


class BlenderImport(BlenderTest):
    @classmethod
    def written(cls, keeper):
        return sorted((keeper.town("town", "--lods", "0.5") / "glb").glob("*.glb"))

    def test_one_root_lies_at_its_origin_in_metres(self):
        for gltf, facts in self.tiles:
            root = gltf["nodes"][0]
            self.assertEqual(facts["unit_m"], 1)
            self.assert_near(z_up(root["translation"]), root["extras"]["origin_m"])
            [found] = facts["roots"]
            self.assertEqual(readers.plain_name(found["name"]), root["name"])
            self.assertEqual(found["extras"], sorted(root["extras"]))

    def test_layers_are_objects_below_the_root(self):
        seen = set()
        for gltf, facts in self.tiles:
            layers = [gltf["nodes"][child]["name"] for child in gltf["nodes"][0]["children"]]
            self.assertEqual(sorted(map(readers.plain_name, facts["roots"][0]["children"])), sorted(layers))
            seen.update(layers)
        self.assertLessEqual({"ground", "roads", "buildings", "plants", "props"}, seen)

    def test_the_ground_faces_up(self):
        for _, facts in self.tiles:
            [ground] = [faces for faces in facts["faces"] if readers.plain_name(faces["name"]) == "ground"]
            self.assertGreater(ground["area_seen_from_above_m2"], 1e5)

    def test_no_normal_is_opposite_to_its_face(self):
        # normals of the ground's skirts are those of its edge, square to them
        for _, facts in self.tiles:
            self.assertGreater(len(facts["faces"]), 3)
            # leaves have faces for both sides with one normal
            for faces in facts["faces"]:
                if readers.plain_name(faces["name"]) in LAYERS:
                    self.assertGreater(faces["normals_not_opposite"], 0.995, faces["name"])

    def test_instances_share_their_mesh(self):
        shared = 0
        for _, facts in self.tiles:
            for name, mesh in facts["meshes"].items():
                self.assertEqual(mesh["users"], len(facts["places"][name]))
                shared += mesh["users"] > 1
        self.assertGreater(shared, 0)

    def test_plants_and_lamps_are_upright_and_rooted(self):
        instances = 0
        for _, facts in self.tiles:
            for name, places in facts["places"].items():
                if not readers.plain_name(name).startswith(("oak", "maple", "ArmLamp")):
                    continue
                low, high = (facts["meshes"][name][end] for end in ("low", "high"))
                for place in places:
                    size = sum(place[i][1] ** 2 for i in range(3)) ** 0.5
                    self.assertLess(abs(low[1]) * size, 0.5)
                    self.assertTrue(2 < high[1] * size < 40, (name, high[1] * size))
                    self.assert_near([place[i][1] / size for i in range(3)], [0, 1, 0], 1e-4)
                    instances += 1
        self.assertGreater(instances, 50)

    def test_materials_arrive_with_their_values(self):
        for gltf, facts in self.tiles:
            values_of = {readers.plain_name(name): values for name, values in facts["values"].items()}
            for material in gltf["materials"]:
                values, found = material["pbrMetallicRoughness"], values_of[material["name"]]
                if "baseColorTexture" in values:
                    self.assertTrue(found["has_pixels"])
                else:
                    wanted = values["baseColorFactor"][:3]
                    self.assertTrue(any(max(abs(a - b) for a, b in zip(c, wanted)) < 1e-5 for c in found["colours"]), (found, wanted))
                if material.get("alphaMode") == "MASK":
                    # 4.2 has no blend_method any more: holes are nodes, whose method stays the default
                    self.assertIn(found["alpha"], ("CLIP", "HASHED") if "bpy" in sys.argv else ("CLIP",))
                if "metallicRoughnessTexture" in values:
                    self.assertTrue(found["roughness_is_picture"])
                else:
                    self.assertLess(abs(found["roughness"] - values.get("roughnessFactor", 1)), 1e-5)


# more than any tile of the town has lamps: 10 to 35
LIGHTS = 200
# of Blender's importer, which takes a light's candela as evenly spread
LUMEN_PER_WATT = 683


class BlenderLights(BlenderTest):
    @classmethod
    def written(cls, keeper):
        return sorted((keeper.town("lit", "--lods", "12.5", "--lights", str(LIGHTS)) / "glb").glob("*.glb"))

    def test_lamps_are_lights_at_their_places(self):
        kinds = set()
        for gltf, facts in self.tiles:
            nodes = [node for node in gltf["nodes"] if "KHR_lights_punctual" in node.get("extensions", {})]
            self.assertGreaterEqual(len(nodes), 10)
            self.assertEqual(len(facts["lights"]), len(nodes))
            root = gltf["nodes"][0]["translation"]
            found = {tuple(round(x, 2) for x in light["at"]): light for light in facts["lights"]}
            for node in nodes:
                light = found[tuple(round(a + b, 2) for a, b in zip(root, node["translation"]))]
                own = gltf["extensions"]["KHR_lights_punctual"]["lights"][node["extensions"]["KHR_lights_punctual"]["light"]]
                self.assertEqual(light["type"], own["type"].upper())
                self.assertTrue(light["type"] == "POINT" or light["down"])
                self.assert_near(light["colour"], own["color"], 1e-5)
                self.assertEqual(light["lumen"], node["extras"]["lumen"])
                kinds.add(light["type"])
        self.assertEqual(kinds, {"POINT", "SPOT"})

    def test_their_power_is_within_a_factor_of_two_of_the_lamp(self):
        for _, facts in self.tiles:
            for light in facts["lights"]:
                luminance = sum(a * b for a, b in zip(light["colour"], (0.2126, 0.7152, 0.0722)))
                # Blender's cone of 180 degrees falls off as a smooth step of the cosine: its solid angle is pi, not 4 pi
                share = 0.25 if light["type"] == "SPOT" else 1
                lumen = light["watts"] * LUMEN_PER_WATT * luminance * share
                self.assertTrue(0.5 < lumen / light["lumen"] < 2, (lumen, light["lumen"], light["type"]))


@unittest.skipUnless(MADE_GLB, "MADE_GLB is not set")
class BlenderMarkingAtlas(BlenderTest):
    @classmethod
    def written(cls, keeper):
        subprocess.run([MADE_GLB, keeper.folder], check=True)
        return [keeper.folder / "marked_nodes.glb"]

    def test_marked_materials_share_one_picture(self):
        [(gltf, facts)] = self.tiles
        marked = [material["name"] for material in gltf["materials"] if "Marked_" in material["name"]]
        self.assertEqual(len(marked), 3)
        self.assertEqual(len(facts["images"]), 1)
        for name in marked:
            self.assertTrue(facts["values"][name]["has_pixels"])
            self.assertEqual(facts["pictures"][name], facts["images"][0])

    def test_texture_coordinates_lie_on_the_picture(self):
        # made_tile.h gives each corner the texture coordinates (x, 8 km + y) in metres
        [(gltf, facts)] = self.tiles
        [image] = gltf["images"]
        size = [pixels * image["extras"]["texel_m"] for pixels in facts["images"][0]]
        # tile and tolerance follow the name
        corners = {name.split("_")[0]: rows for mesh in facts["corners"].values() for name, rows in mesh.items()}
        for name in ("AsphaltMarked", "PavingMarked"):
            self.assertEqual(len(corners[name]), 12)
            for (x, y, _), (u, v) in corners[name]:
                self.assert_near([u * size[0], (1 - v) * size[1]], [x, 8000 + y], 0.003)


if __name__ == "__main__":
    readers.skip_unless(readers.blender_command() and readers.has_pictures(),
                        "Blender is not installed (./setup.sh release interop), or bpy (tests/interop/requirements.txt)")
    unittest.main(argv=[word for word in sys.argv if word != "bpy"], verbosity=2)
