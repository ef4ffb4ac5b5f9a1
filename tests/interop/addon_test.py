#!/usr/bin/env python3
"""The add-on for Blender, installed from the zip that the program writes: tiles arrive whole and in their place, copies share a mesh,
materials are made once, runs with other origins fit, the sun stands where the run has it, and each mistake gets one line."""
import json
import os
import shutil
import sys
import unittest
from pathlib import Path

import readers
from citykiln_program import PROGRAM, ROOT, TOWN, TOWN_MIDDLE, run
from glb import Glb
from readers import ReaderTest


# of the example town: a building with a name, and a way with five storeys
NAMED, HOUSE = "Kilnturm", "66"
TOWN_RUN = ["--lods", "0.5,2.5", "--target", "blender", "--lights", "20", "--surroundings", "none"]


class AddonTest(ReaderTest):
    def addon(self, *steps):
        """The facts of steps: (command, options) in a new scene each, or (command, options, False) in the scene of the step before."""
        target = self.folder / "citykiln.zip"
        made = run("addon", "blender", "-o", target)
        self.assertEqual(made.returncode, 0, made.stderr)
        job, facts = self.folder / "job.json", self.folder / "facts.json"
        steps = [{"command": command, "options": options, "is_new": not rest} for command, options, *rest in steps]
        job.write_text(json.dumps({"zip": str(target), "facts": str(facts), "steps": steps}))
        # add-ons are installed below this folder
        env = {**os.environ, "PATH": "/usr/bin:/bin", "BLENDER_USER_SCRIPTS": str(self.folder), "BLENDER_USER_RESOURCES": str(self.folder)}
        return readers.done_by([*readers.blender_command(), readers.HERE / "import_addon.py", "--", job], facts, env=env)[0]

    def town_run(self):
        """A run that the tests of a class share."""
        return self.compiled_once("--spec", TOWN / "spec.json", *TOWN_RUN)


class Arrives(AddonTest):
    def test_every_triangle_and_copy_of_the_report_arrives_in_its_place(self):
        out = self.town_run()
        [found] = self.addon(("run", {"directory": str(out), "level": 0, "lamps": True}))
        report = json.loads((out / "report.json").read_text())
        tiles = [tile for tile in report["tiles"] if tile["level"] == 0]
        self.assertEqual(len(found["tiles"]), len(tiles))
        for tile in tiles:
            facts = found["tiles"][f"{tile['x']}_{tile['y']}_L0"]
            self.assertEqual(facts["triangles"], readers.triangles_drawn(out / tile["file"]))
            self.assertEqual(facts["instances"], tile["instances"])
            # the ground ends at the tile's border, other objects may lie across it
            for i, at in enumerate((tile["x"], tile["y"])):
                self.assertLess(facts["low"][i], at * report["tile_m"] + report["tile_m"])
                self.assertGreater(facts["high"][i], at * report["tile_m"])
        self.assertGreater(found["lights"], 10)

    def test_faces_know_their_object(self):
        out = self.town_run()
        [found] = self.addon(("run", {"directory": str(out), "level": 0, "layers": ["buildings"], "buildings": False, "lamps": False}))
        self.assertEqual(found["layers"], ["buildings"])
        for name, facts in found["tiles"].items():
            tile = Glb(out / "glb" / f"{name}.glb")
            [mesh] = [mesh for mesh in tile.gltf["meshes"] if mesh["name"] == "buildings"]
            rows = []
            for primitive in mesh["primitives"]:
                of_vertices = tile.values(primitive["attributes"]["_FEATURE_ID_0"])
                rows += [int(of_vertices[corner][0]) for (corner,) in tile.values(primitive["indices"])[::3]]
            merged = facts["merged"]["buildings"]
            self.assertEqual(merged["rows"], rows)
            ids = tile.osm_ids()
            self.assertGreater(len(merged["features"]), 5)
            for row, known in merged["features"].items():
                self.assertEqual(known["osm_id"], ids[int(row)])
                self.assertGreater(known["height_m"], 1)

    def test_copies_share_meshes_and_tiles_share_materials(self):
        out = self.town_run()
        once, twice = self.addon(("run", {"directory": str(out), "level": 0}), ("run", {"directory": str(out), "level": 0}, False))
        instances = sum(tile["instances"] for tile in once["tiles"].values())
        meshes = len({copy["of_mesh"] for tile in once["tiles"].values() for copy in tile["copies"]})
        self.assertLess(meshes, instances / 2)
        self.assertEqual(twice["all_materials"], once["all_materials"])
        self.assertEqual((twice["runs"], twice["meshes"], twice["lights"]), (1, once["meshes"], once["lights"]))
        copies = [copy for tile in once["tiles"].values() for copy in tile["copies"]]
        self.assertTrue(any(copy.get("osm_type") == "node" and "class" in copy for copy in copies))

    def test_the_extension_for_instances_brings_the_same_copies(self):
        nodes, extension = self.town_run(), self.town("three", "--lods", "0.5,2.5", "--target", "three")
        # level 0 for Blender has stands of trees instead
        a, b = self.addon(("run", {"directory": str(nodes), "level": 1, "layers": ["plants"]}),
                          ("run", {"directory": str(extension), "level": 1, "layers": ["plants"]}))
        for x, y in zip(a["tiles"].values(), b["tiles"].values(), strict=True):
            self.assertGreater(x["instances"], 10)
            self.assertEqual(x["instances"], y["instances"])
            self.assert_near(x["low"] + x["high"], y["low"] + y["high"], 0.01)


class Chooses(AddonTest):
    def test_levels_by_distance_are_coarse_far_away(self):
        out = self.town_run()
        near, far = self.addon(*(("run", {"directory": str(out), "by_distance": True, "camera": camera, "layers": ["ground"]})
                                 for camera in ([0, 0, 60], [0, 0, 9000])))
        self.assertTrue(any(name.endswith("_L0") for name in near["tiles"]))
        self.assertTrue(all(name.endswith("_L1") for name in far["tiles"]))

    def test_tiles_and_boxes(self):
        """Some tiles come without the land around the map."""
        out = self.town("around", "--lods", "2.5", "--target", "blender", "--surroundings")
        tiles = json.loads((out / "report.json").read_text())["tiles"]
        first = f"{tiles[0]['x']}_{tiles[0]['y']}"
        west, south, east, north = tiles[0]["box_deg"]
        box = f"{west + 1e-4},{south + 1e-4},{(west + east) / 2},{(south + north) / 2}"
        by_name, by_box = self.addon(("run", {"directory": str(out), "tiles": first}), ("run", {"directory": str(out), "box": box}))
        self.assertEqual(list(by_name["tiles"]), [f"{first}_L0"])
        self.assertEqual(list(by_box["tiles"]), [f"{first}_L0"])


class Fits(AddonTest):
    def test_runs_with_other_origins_lie_on_each_other(self):
        here = self.town("here", "--lods", "2.5", "--target", "blender")
        [lon, lat] = [json.loads((here / "report.json").read_text())["origin"][key] for key in ("lon_deg", "lat_deg")]
        there = self.town("there", "--lods", "2.5", "--target", "blender", f"--origin={lon + 0.05},{lat + 0.02}")
        first, second = self.addon(("run", {"directory": str(here), "layers": ["buildings"]}),
                                   ("run", {"directory": str(there), "layers": ["buildings"]}, False))

        def box(found):
            low = [min(tile["low"][i] for tile in found["tiles"].values()) for i in range(3)]
            return low + [max(tile["high"][i] for tile in found["tiles"].values()) for i in range(3)]

        # boxes of turned buildings are a little larger than their vertices
        self.assert_near(box(first), box(second), 0.5)

    def test_the_sun_stands_where_the_run_has_it(self):
        out = self.town_run()
        [found] = self.addon(("run", {"directory": str(out), "layers": ["ground"]}))
        self.assert_near(found["world"]["to_sun"][0], json.loads((out / "report.json").read_text())["sky"]["to_sun"], 1e-5)


class Looks(AddonTest):
    """Names, places, light and camera after an import."""

    def test_names_are_words_and_materials_have_colours(self):
        [found] = self.addon(("run", {"directory": str(self.town_run()), "level": 0}))
        for material in found["shown"]:
            self.assertRegex(material["name"].partition(".")[0], r"^[A-Z][a-z]+( [a-z]+)*(, [a-z ]+)?$")
            # Blender's own is 0.8
            self.assertGreater(max(abs(c - 0.8) for c in material["colour"][:3]), 0.001, material)
        self.assertTrue(any(material["name"].startswith("Leaves of ") for material in found["shown"]))
        for tile in found["tiles"].values():
            for copy in tile["copies"]:
                self.assertNotIn("_", copy["is"])
        self.assertEqual(found["black"], [])

    def test_a_building_has_its_origin_at_its_foot(self):
        [found] = self.addon(("run", {"directory": str(self.town_run()), "level": 1, "layers": ["buildings"]}))
        buildings = [building for tile in found["tiles"].values() for building in tile["buildings"]]
        self.assertGreater(len(buildings), 300)
        for building in buildings:
            low, high = building["low"], building["high"]
            self.assert_near([low[0] + high[0], low[1] + high[1], low[2]], [0, 0, 0], 0.02)
            self.assertGreater(high[2], 1)
            self.assertIn("osm_id", building)

    def test_trees_of_yards_have_no_facts_of_the_house(self):
        [found] = self.addon(("run", {"directory": str(self.town_run()), "level": 0, "layers": ["plants", "props"]}))
        copies = [copy for tile in found["tiles"].values() for copy in tile["copies"]]
        yards = [copy for copy in copies if copy.get("of_class") == "House"]
        self.assertGreater(len(yards), 100)
        for copy in yards:
            self.assertFalse({"class", "height_m", "tags", "osm_id"} & set(copy), copy)
            self.assertIn("of_osm_id", copy)

    def test_lamps_follow_the_sun(self):
        out = self.town_run()
        day, night, off, noon = self.addon(
            ("run", {"directory": str(out), "level": 1}), ("light", {"hour": 22.0}, False), ("light", {"lamps": "OFF"}, False),
            ("light", {"hour": 11.0, "lamps": "AUTO"}, False))
        self.assertEqual({True: len(day["lit"])}, {not lit: day["lit"].count(lit) for lit in day["lit"]})
        self.assertTrue(night["lit"] and all(night["lit"]))
        self.assertFalse(any(off["lit"]) or any(noon["lit"]))
        self.assertEqual([day["world"]["is_sun_shown"], night["world"]["is_sun_shown"]], [[True], [False]])
        self.assertGreater(night["world"]["exposure"], day["world"]["exposure"] + 5)
        # at 11:10 UTC the sun is in the south of 12.3 east, at 90 - 48.7 + 23.4 degrees
        self.assertGreater(noon["world"]["to_sun"][0][2], 0.9)
        self.assertLess(noon["world"]["to_sun"][0][1], -0.4)

    def test_a_second_import_replaces_sun_sky_and_run(self):
        out = self.town_run()
        once, twice = self.addon(("run", {"directory": str(out), "level": 1}), ("run", {"directory": str(out), "level": 0}, False))
        self.assertEqual((twice["runs"], len(twice["world"]["to_sun"]), twice["world"]["skies"]), (1, 1, 1))
        self.assertEqual(len(twice["tiles"]), len(once["tiles"]))
        self.assertTrue(all(name.endswith("_L0") for name in twice["tiles"]))

    def test_the_camera_sees_the_town(self):
        [found] = self.addon(("run", {"directory": str(self.town_run()), "level": 1}))
        camera = found["world"]["camera"]
        self.assertGreaterEqual(min([camera["clip_end"], *found["world"]["views"]]), 5000)
        # its axis meets the town's middle
        at, forward = camera["at"], camera["forward"]
        steps = (at[2] - 380) / -forward[2]
        self.assertLess(max(abs(at[i] + steps * forward[i]) for i in (0, 1)), 200)


class Remakes(AddonTest):
    def town_run(self):
        """A run of its own, to which tiles are added."""
        return self.compiled("town", "--spec", TOWN / "spec.json", *TOWN_MIDDLE, *TOWN_RUN)

    def test_selected_tiles_get_finer(self):
        out = self.town_run()
        found = self.addon(("run", {"directory": str(out), "level": 1}), ("finer", {"tile": "0_0"}, False),
                           ("finer", {"tile": "0_0", "program": PROGRAM}, False))
        self.assertEqual([max(each["tiles"]) for each in found], ["0_0_L1", "0_0_L0", "0_0_L0"])
        self.assertEqual([next(tile["tolerance_m"] for name, tile in each["tiles"].items() if name.startswith("0_0")) for each in found],
                         [2.5, 0.5, 0.25])
        self.assertEqual([len(each["tiles"]) for each in found], [4, 4, 4])

    def test_a_run_is_baked_again_in_its_place(self):
        out = self.town_run()
        first, again = self.addon(("run", {"directory": str(out), "level": 1, "layers": ["ground", "buildings", "plants"],
                                           "lamps": False}),
                                  ("bake", {"lods": "5", "options": "--layers=-plants", "program": PROGRAM, "out": str(self.folder / "new")},
                                   False))
        self.assertEqual((again["runs"], len(again["tiles"])), (1, len(first["tiles"])))
        self.assertEqual({tile["tolerance_m"] for tile in again["tiles"].values()}, {5})
        self.assertEqual(again["layers"], ["buildings", "ground"], "of the layers that were imported, those that the new run has")


class Compiles(AddonTest):
    def test_a_map_is_compiled_and_arrives(self):
        [found] = self.addon(("map", {"filepath": str(self.town_map()), "program": PROGRAM, "out": str(self.folder / "out"), "level": 4}))
        self.assertGreater(sum(tile["triangles"] for tile in found["tiles"].values()), 1000)

    def town_map(self):
        [found] = [path for path in TOWN.iterdir() if path.name.endswith((".osm", ".osm.pbf"))][:1]
        return found


@unittest.skipUnless(readers.blender() and "bpy" not in sys.argv, "needs Blender of the system")
class Artists(AddonTest):
    def test_ten_tasks_are_done_with_the_add_on_alone(self):
        out = self.town_run()
        target, job, facts = self.folder / "citykiln.zip", self.folder / "job.json", self.folder / "facts.json"
        self.assertEqual(run("addon", "blender", "-o", target).returncode, 0)
        pictures = Path(os.environ.get("PICTURES", self.folder))
        (self.folder / "mends.edits").write_text(f"w{HOUSE} set building:levels=9 remove height\n")
        heights = json.loads((TOWN / "spec.json").read_text())["dem"]
        job.write_text(json.dumps({"zip": str(target), "facts": str(facts), "run": str(out), "map": str(TOWN / "town.osm"), "named": NAMED,
                                   "heights": str(ROOT / heights), "house": HOUSE, "edits": str(self.folder / "mends.edits"),
                                   "program": str(PROGRAM), "pictures": str(pictures), "street": [[80, -150, 377.5], [130, -60, 380]]}))
        env = {**os.environ, "BLENDER_USER_SCRIPTS": str(self.folder), "BLENDER_USER_RESOURCES": str(self.folder)}
        done = readers.done_by([*readers.blender_command(), readers.HERE / "artist_tasks.py", "--", job], facts, env=env)[0]
        self.assertEqual(len(done), 10)
        self.assertEqual({name: word for name, word in done.items() if word is not True}, {})


class Mistakes(AddonTest):
    def test_each_gets_one_line_that_names_the_file(self):
        out = self.town("town", "--lods", "2.5", "--target", "blender")
        copy = lambda name: Path(shutil.copytree(out, self.folder / name))  # noqa: E731
        old, torn, lost, packed = copy("old"), copy("torn"), copy("lost"), self.town("packed", "--lods", "2.5", "--compress", "meshopt",
                                                                                     "--target", "three")
        report = json.loads((old / "report.json").read_text())
        del report["origin"]
        (old / "report.json").write_text(json.dumps(report))
        first = sorted((torn / "glb").glob("*.glb"))[0]
        first.write_bytes(first.read_bytes()[:1000])
        sorted((lost / "glb").glob("*.glb"))[0].unlink()
        wrong = [("run", {"directory": "/nowhere"}, "there is no such folder"), ("run", {"directory": "/tmp"}, "has no report.json"),
                 ("run", {"directory": str(old)}, "another version"), ("run", {"directory": str(torn)}, "1000 bytes"),
                 ("run", {"directory": str(lost)}, "is missing"), ("run", {"directory": str(packed)}, "packed (meshopt"),
                 ("run", {"directory": str(out), "level": 7}, "has no level 7"),
                 ("run", {"directory": str(out), "tiles": "99_99"}, "has no tile 99_99"),
                 ("run", {"directory": str(out), "box": "1,2"}, "expected west,south,east,north"),
                 ("run", {"directory": str(out), "by_distance": True}, "no perspective camera"),
                 ("map", {"filepath": "/nowhere.osm"}, "there is no such map"),
                 ("map", {"filepath": str(TOWN / "spec.json"), "program": PROGRAM, "out": str(self.folder / "no")}, "spec.json"),
                 ("map", {"filepath": str(TOWN / "spec.json"), "program": "/no/citykiln"}, "there is no such program")]
        found = self.addon(*((command, options) for command, options, _ in wrong))
        for (_, _, expected), facts in zip(wrong, found, strict=True):
            self.assertIn(expected, facts.get("error", ""), facts)
            self.assertEqual(len(facts["error"].splitlines()), 1)


if __name__ == "__main__":
    readers.skip_unless(readers.blender_command() and readers.has_pictures(), "Blender is not installed (./setup.sh release interop), or bpy (tests/interop/requirements.txt)")
    unittest.main(argv=[word for word in sys.argv if word != "bpy"], verbosity=2)
