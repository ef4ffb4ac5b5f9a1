#!/usr/bin/env python3
"""A thing is added by a folder with a row and a rule: the tile has it, without building anything."""
import json
import unittest

from citykiln_program import ProgramTest, bytes_of_outputs, report_of, run
from glb import Glb

MAP = """<osm version="0.6"><bounds minlat="43.730" minlon="7.420" maxlat="43.731" maxlon="7.422"/>
<node id="1" lat="43.7305" lon="7.4201" version="1"/>
<node id="2" lat="43.7305" lon="7.4212" version="1"><tag k="{road_key}" v="{road_value}"/></node>
<node id="3" lat="43.7305" lon="7.4219" version="1"/>
<node id="4" lat="43.73056" lon="7.4211" version="1"><tag k="{key}" v="{value}"/><tag k="height" v="3"/></node>
<way id="9" version="1"><nd ref="1"/><nd ref="2"/><nd ref="3"/><tag k="highway" v="residential"/></way>
</osm>"""

ROW = "sundial  man_made=sundial|highway=dial  sundial  0.4x0.4xheight:1.2  ground  street  0.3  size  Sundial\n"
RULES = 'attr height = 1\n\nThing --> split(z) { ~1 : Post. | 0.1 : color("#d0a020") Dial. }\n'


class Things(ProgramTest):
    def map_of(self, key="man_made", value="sundial", road_key="amenity", road_value="nothing"):
        path = self.folder / "town.osm"
        path.write_text(MAP.format(key=key, value=value, road_key=road_key, road_value=road_value))
        return path

    def things_folder(self, row=ROW, rules=RULES):
        folder = self.folder / "things"
        folder.mkdir(exist_ok=True)
        (folder / "things.txt").write_text(row)
        (folder / "sundial.cga").write_text(rules)
        return folder

    def tile(self, out, level=0):
        return Glb(out / "glb" / f"0_0_L{level}.glb")

    def node(self, tile, name):
        return next((node for node in tile.gltf["nodes"] if node.get("name") == name), None)

    def test_a_row_and_a_rule_add_a_thing(self):
        arguments = [self.map_of(), "--lods", "0.1,2,10"]
        without = self.compiled("without", *arguments)
        self.assertIsNone(self.node(self.tile(without), "sundial"))
        unknown = json.loads((without / "findings.json").read_text())["features"]
        self.assertIn("man_made=sundial", json.dumps(unknown))
        out = self.compiled("with", *arguments, "--things", self.things_folder())
        self.assertIsNotNone(self.node(self.tile(out), "sundial"))
        self.assertIsNotNone(self.node(self.tile(out, 1), "sundial"), "it is 3 m high")
        self.assertIsNone(self.node(self.tile(out, 2), "sundial"))
        self.assertEqual(report_of(out)["counts"]["things"], 1)
        self.assertIn(4, self.tile(out).osm_ids())
        enums = self.tile(out).gltf["extensions"]["EXT_structural_metadata"]["schema"]["enums"]
        self.assertIn("Sundial", [value["name"] for value in enums["class"]["values"]])

    def test_bake_needs_no_folder(self):
        out = self.compiled("with", self.map_of(), "--lods", "0.1", "--things", self.things_folder())
        (self.folder / "things" / "sundial.cga").unlink()
        baked = self.folder / "baked"
        done = run("bake", out / "scene.kiln", "--lods", "0.1", "-o", baked)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(bytes_of_outputs(out), bytes_of_outputs(baked))

    def test_a_node_of_a_road_stands_beside_it(self):
        out = self.compiled("on_road", self.map_of("name", "none", "highway", "dial"), "--lods", "0.1", "--things", self.things_folder())
        self.assertIsNotNone(self.node(self.tile(out), "sundial"))
        done = run("check", out)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_a_mistake_is_one_line(self):
        for row, rules, place in (("sundial man_made=sundial\n", RULES, "things/things.txt:1: "), (ROW, "Thing --> split(\n", "sundial.cga:"),
                                  (ROW.replace("street", "up"), RULES, "things/things.txt:1: faces: "),
                                  ("# a table\n" + ROW + ROW.replace("sundial", "moondial"), RULES,
                                   "things/things.txt:3: rule: there is no file moondial.cga")):
            done = run("compile", self.map_of(), "--things", self.things_folder(row, rules), "-o", self.folder / "bad")
            self.assertEqual(done.returncode, 1)
            self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)
            self.assertIn(place, done.stderr)


if __name__ == "__main__":
    unittest.main()
