#!/usr/bin/env python3
"""The add-on for Blender, installed from the zip that the program writes: tiles arrive whole and in their place, copies share a mesh,
materials are made once, runs with other origins fit, the sun stands where the run has it, and each mistake gets one line."""
import json
import os
import shutil
import unittest
from pathlib import Path

import readers
from citykiln_program import PROGRAM, TOWN, run
from glb import Glb
from readers import ReaderTest


class AddonTest(ReaderTest):
    def addon(self, *steps):
        """The facts of steps: (command, options) in a new scene each, or (command, options, False) in the scene of the step before."""
        target = self.folder / "citykiln.zip"
        made = run("addon", "blender", "-o", target)
        self.assertEqual(made.returncode, 0, made.stderr)
        job, facts = self.folder / "job.json", self.folder / "facts.json"
        steps = [{"command": command, "options": options, "is_new": not rest} for command, options, *rest in steps]
        job.write_text(json.dumps({"zip": str(target), "facts": str(facts), "steps": steps}))
        command = [readers.blender(), "-b", "--factory-startup", "-noaudio", "--python-exit-code", "3", "-P",
                   readers.HERE / "import_addon.py", "--", job]
        # add-ons are installed below this folder
        env = {**os.environ, "PATH": "/usr/bin:/bin", "BLENDER_USER_SCRIPTS": str(self.folder)}
        return readers.done_by(command, facts, env=env)[0]

    def town_run(self):
        return self.town("town", "--lods", "0.5,2.5", "--target", "blender", "--lights", "20")


class Arrives(AddonTest):
    def test_every_triangle_and_copy_of_the_report_arrives_in_its_place(self):
        out = self.town_run()
        [found] = self.addon(("run", {"directory": str(out), "level": 0, "lamps": True}))
        report = json.loads((out / "report.json").read_text())
        tiles = [tile for tile in report["tiles"] if tile["level"] == 0]
        self.assertEqual(len(found["tiles"]), len(tiles))
        for tile in tiles:
            facts = found["tiles"][f"tile_{tile['x']}_{tile['y']}_L0"]
            self.assertEqual(facts["triangles"], readers.triangles_drawn(out / tile["file"]))
            self.assertEqual(facts["instances"], tile["instances"])
            # the ground ends at the tile's border, other objects may lie across it
            for i, at in enumerate((tile["x"], tile["y"])):
                self.assertLess(facts["low"][i], at * report["tile_m"] + report["tile_m"])
                self.assertGreater(facts["high"][i], at * report["tile_m"])
        self.assertGreater(found["lights"], 10)

    def test_faces_know_their_object(self):
        out = self.town_run()
        [found] = self.addon(("run", {"directory": str(out), "level": 0, "layers": ["buildings"]}))
        self.assertEqual(found["layers"], ["buildings"])
        for name, facts in found["tiles"].items():
            tile = Glb(out / "glb" / f"{name.removeprefix('tile_')}.glb")
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
        objects = sum(tile["instances"] + len(tile["merged"]) for tile in once["tiles"].values())
        self.assertLess(once["meshes"], objects / 2)
        self.assertEqual(twice["all_materials"], once["all_materials"])
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
        self.assertEqual(list(by_name["tiles"]), [f"tile_{first}_L0"])
        self.assertEqual(list(by_box["tiles"]), [f"tile_{first}_L0"])


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


class Compiles(AddonTest):
    def test_a_map_is_compiled_and_arrives(self):
        [found] = self.addon(("map", {"filepath": str(self.town_map()), "program": PROGRAM, "out": str(self.folder / "out"), "level": 4}))
        self.assertGreater(sum(tile["triangles"] for tile in found["tiles"].values()), 1000)

    def town_map(self):
        [found] = [path for path in TOWN.iterdir() if path.name.endswith((".osm", ".osm.pbf"))][:1]
        return found


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
    readers.skip_unless(readers.blender() and readers.has_pictures(), "Blender is not installed (./setup.sh release interop)")
    unittest.main(verbosity=2)
