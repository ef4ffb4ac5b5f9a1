#!/usr/bin/env python3
"""A map compiled in regions has the bytes of one run; tasks can be repeated, killed and resumed; gather knows what is missing."""
import json
import os
import random
import re
import shutil
import signal
import subprocess
import time
import unittest
from pathlib import Path

from citykiln_program import IS_FULL, PROGRAM, ROOT, TOWN, TOWN_MIDDLE, ProgramTest, bytes_of_outputs, long_test, report_of, run

ARGUMENTS = ["--lods", "2.5", "--tile", "256"]


class Plan(ProgramTest):
    MAP, DEM, REGION = TOWN / "town.osm", [], 512
    # four regions about the middle of the town; all of it has 16
    BOX = [] if IS_FULL else TOWN_MIDDLE

    def planned(self, *arguments, name="plan", map_path=None):
        plan = self.folder / name
        map_arguments = [map_path] if map_path else [self.MAP, *self.BOX]
        done = run("plan", *map_arguments, *self.DEM, *ARGUMENTS, "--region", self.REGION, *arguments, "-o", plan)
        self.assertEqual(done.returncode, 0, done.stderr)
        return plan

    def regions_of(self, plan):
        return [region["region"] for region in json.loads((plan / "plan.json").read_text())["regions"]]

    def compile_all(self, plan):
        regions = self.regions_of(plan)
        random.Random(7).shuffle(regions)
        for region in regions:
            done = run("compile", "--plan", plan, "--region", region)
            self.assertEqual(done.returncode, 0, done.stderr)

    def finished(self):
        """A plan of the town whose regions are all compiled. They are compiled once for all tests of the class."""
        original = Path(self.shared_scratch.name) / "finished"
        if not original.exists():
            self.compile_all(self.planned(name=original))
        return Path(shutil.copytree(original, self.folder / "plan"))

    def test_regions_compiled_apart_have_the_bytes_of_one_run(self):
        whole = self.compiled("whole", self.MAP, *self.BOX, *self.DEM, *ARGUMENTS)
        plan = self.finished()
        self.assertGreater(len(self.regions_of(plan)), 3)
        done = run("gather", plan)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(bytes_of_outputs(plan / "out"), bytes_of_outputs(whole))
        ours, theirs = report_of(plan / "out"), report_of(whole)
        self.assertEqual(ours["counts"], theirs["counts"])
        # each element is counted by the region that owns it
        self.assertEqual(ours["ledger"], theirs["ledger"])
        self.assertEqual({name: each["count"] for name, each in ours["diagnoses"].items()},
                         {name: each["count"] for name, each in theirs["diagnoses"].items()})
        self.assertEqual(run("check", plan / "out").returncode, 0)

    def cut_lake(self):
        """A map of 1.4 x 1.1 km whose lake and town go on outside; members are missing."""
        places = {1: (10.0, 0.006), 2: (10.006, 0.0055), 3: (10.0128, 0.007), 4: (10.001, 0.001), 5: (10.012, 0.001),
                  6: (10.002, 0.002), 7: (10.0022, 0.002), 8: (10.0022, 0.0022), 9: (10.002, 0.0022),
                  10: (9.999, 0.0042), 11: (10.004, 0.0035), 12: (10.0015, -0.001), 13: (10.006, 0.002), 14: (10.008, 0.002),
                15: (10.008, 0.004), 16: (10.006, 0.004), 17: (10.01, 0.002), 18: (10.01, 0.004)}
        ways = {20: ([1, 2, 3], {}), 21: ([4, 5], {"highway": "residential"}),
                22: ([6, 7, 8, 9, 6], {"building": "house"}), 23: ([10, 11, 12], {}),
                24: ([13, 14, 15, 16, 13], {"landuse": "farmland"}), 25: ([14, 17, 18, 15, 14], {"landuse": "meadow"})}
        text = '<osm version="0.6"><bounds minlat="0" minlon="10" maxlat="0.01" maxlon="10.0128"/>'
        text += "".join(f'<node id="{i}" lon="{x}" lat="{y}"/>' for i, (x, y) in places.items())
        for way, (nodes, tags) in ways.items():
            text += f'<way id="{way}">' + "".join(f'<nd ref="{node}"/>' for node in nodes)
            text += "".join(f'<tag k="{key}" v="{value}"/>' for key, value in tags.items()) + "</way>"
        for relation, way, tag in ((30, 20, ("natural", "water")), (31, 23, ("landuse", "residential"))):
            text += f'<relation id="{relation}"><member type="way" ref="{way}" role="outer"/>'
            text += '<member type="way" ref="99" role="outer"/><tag k="type" v="multipolygon"/>'
            text += f'<tag k="{tag[0]}" v="{tag[1]}"/></relation>'
        path = self.folder / "lake.osm"
        path.write_text(text + "</osm>")
        return path

    def lake_with_islands(self):
        """A lake of 1 km with islands that are a relation, and a building relation of one outline and a part."""
        places = {1: (10, 0), 2: (10.01, 0), 3: (10.01, 0.01), 4: (10, 0.01), 5: (10.001, 0.001), 6: (10.002, 0.001),
                  7: (10.002, 0.002), 8: (10.001, 0.002), 9: (10.004, 0.004), 10: (10.006, 0.004), 11: (10.006, 0.006),
                  12: (10.004, 0.006), 13: (10.0105, 0.001), 14: (10.012, 0.001), 15: (10.012, 0.002), 16: (10.0105, 0.002),
                  17: (10.0125, -0.001), 18: (10.0125, 0.011), 19: (9.9995, -0.001)}
        ways = {20: ([1, 2, 3, 4, 1], {}), 21: ([5, 6, 7, 8, 5], {}), 22: ([9, 10, 11, 12, 9], {}),
                23: ([13, 14, 15, 16, 13], {"building": "church"}), 24: ([13, 14, 15, 16, 13], {"building:part": "yes", "height": "9"}),
                25: ([17, 18], {"highway": "residential"}), 26: ([19, 17], {"highway": "residential"})}
        relations = {30: ([("relation", 31, "inner"), ("way", 20, "outer")], {"type": "multipolygon", "natural": "water"}),
                     31: ([("way", 21, "outer"), ("way", 22, "outer")], {"type": "multipolygon", "natural": "wood"}),
                     32: ([("way", 23, "outline"), ("way", 24, "part")], {"type": "building", "building:colour": "red"})}
        text = '<osm version="0.6"><bounds minlat="-0.001" minlon="9.9995" maxlat="0.011" maxlon="10.0125"/>'
        text += "".join(f'<node id="{i}" lon="{x}" lat="{y}"/>' for i, (x, y) in places.items())
        tags_of = lambda tags: "".join(f'<tag k="{key}" v="{value}"/>' for key, value in tags.items())
        for way, (nodes, tags) in ways.items():
            text += f'<way id="{way}">' + "".join(f'<nd ref="{node}"/>' for node in nodes) + tags_of(tags) + "</way>"
        for relation, (members, tags) in relations.items():
            text += f'<relation id="{relation}">' + "".join(
                f'<member type="{kind}" ref="{ref}" role="{role}"/>' for kind, ref, role in members) + tags_of(tags) + "</relation>"
        path = self.folder / "islands.osm"
        path.write_text(text + "</osm>")
        return path

    def test_members_that_are_relations_are_the_same_in_regions(self):
        path = self.lake_with_islands()
        whole = self.compiled("whole", path, *ARGUMENTS)
        self.assertEqual(bytes_of_outputs(self.gathered(path)), bytes_of_outputs(whole))

    def test_areas_that_a_map_without_a_box_cuts_are_the_same_in_regions(self):
        path = self.cut_lake()
        path.write_text(re.sub("<bounds[^>]*>", "", path.read_text()))
        box = ["--bbox", "10,0,10.0128,0.01"]
        whole = self.compiled("whole", path, *box, *ARGUMENTS)
        self.assertEqual(report_of(whole)["diagnoses"]["AreaClosed"]["count"], 2)
        self.assertEqual(bytes_of_outputs(self.gathered(path, *box)), bytes_of_outputs(whole))

    def test_a_box_across_180_degrees_is_refused_with_what_to_do(self):
        path = self.cut_lake()
        path.write_text(path.read_text().replace('minlon="10"', 'minlon="-179.9"').replace('maxlon="10.0128"', 'maxlon="179.9"'))
        done = run("plan", path, "-o", self.folder / "plan")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("crosses 180 degrees", done.stderr)

    def gathered(self, path, *arguments):
        """The outputs of all regions of a map, compiled apart; at least four."""
        plan = self.planned(*arguments, map_path=path)
        self.assertGreater(len(self.regions_of(plan)), 3)
        self.compile_all(plan)
        done = run("gather", plan)
        self.assertEqual(done.returncode, 0, done.stderr)
        return plan / "out"

    def test_areas_that_the_map_cuts_are_the_same_in_regions(self):
        path = self.cut_lake()
        whole, gathered = self.compiled("whole", path, *ARGUMENTS), self.gathered(path)
        self.assertEqual(bytes_of_outputs(gathered), bytes_of_outputs(whole))
        ours, theirs = report_of(gathered), report_of(whole)
        self.assertEqual(theirs["diagnoses"]["AreaClosed"]["count"], 2)
        self.assertEqual(ours["ledger"], theirs["ledger"])
        self.assertEqual({name: each["count"] for name, each in ours["diagnoses"].items()},
                         {name: each["count"] for name, each in theirs["diagnoses"].items()})

    EDITS = """# the field is a pond, as an aerial picture shows
w24 set natural=water remove landuse
building=house move 12,-7 set building:levels=4 roof:shape=flat
n18 place 10.0101,0.0041
w25 set landuse=forest
add a 10.0062,0.0062 10.0066,0.0062 10.0066,0.0065 building=church height=12
add w n4 10.0025,0.0029 10.0062,0.0060 highway=service
add n 10.0030,0.0031 natural=tree height=9
highway=residential near=10.005,0.001,2000 set width=7 sidewalk=both
w4711 drop
"""

    def test_edits_in_regions_are_those_of_one_run(self):
        path, edits = self.cut_lake(), self.folder / "lake.edits"
        edits.write_text(self.EDITS)
        plain = self.compiled("plain", path, *ARGUMENTS)
        whole, gathered = (self.compiled("whole", path, "--edits", edits, *ARGUMENTS),
                           self.gathered(path, "--edits", edits))
        self.assertNotEqual(bytes_of_outputs(whole), bytes_of_outputs(plain))
        self.assertEqual(bytes_of_outputs(gathered), bytes_of_outputs(whole))
        ours, theirs = report_of(gathered), report_of(whole)
        self.assertEqual(theirs["diagnoses"]["EditWithoutEffect"]["count"], 1)
        self.assertEqual(theirs["ledger"]["edits/line"]["out"], 8)
        self.assertEqual(theirs["ledger"]["edits/element"]["split"], 3)
        self.assertEqual(ours["ledger"], theirs["ledger"])
        self.assertEqual({name: each["count"] for name, each in ours["diagnoses"].items()},
                         {name: each["count"] for name, each in theirs["diagnoses"].items()})
        self.assertTrue(any(source.startswith("lake.edits (9 edits, ") for source in theirs["sources"]))
        self.assertEqual(run("check", whole).returncode, 0)

    def test_a_run_with_edits_is_baked_from_its_manifest_alone(self):
        path, edits = self.cut_lake(), self.folder / "lake.edits"
        edits.write_text(self.EDITS)
        whole = self.compiled("whole", path, "--edits", edits, *ARGUMENTS)
        edits.unlink()
        done = run("bake", whole / "scene.kiln", "--lods", "2.5", "--emit", "kiln,glb", "-o", self.folder / "baked")
        self.assertEqual(done.returncode, 0, done.stderr)
        for tile in sorted((whole / "glb").glob("*_L*.glb")):
            self.assertEqual((self.folder / "baked" / "glb" / tile.name).read_bytes(), tile.read_bytes(), tile.name)

    def test_regions_are_not_compiled_with_other_edits_than_the_plan(self):
        path, edits = self.cut_lake(), self.folder / "lake.edits"
        edits.write_text(self.EDITS)
        plan = self.planned("--edits", edits, map_path=path)
        edits.write_text("w22 drop\n")
        done = run("compile", "--plan", plan, "--region", self.regions_of(plan)[0])
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("lake.edits: has changed since the plan was made", done.stderr)

    def test_a_wrong_line_of_edits_is_named_with_its_place(self):
        edits = self.folder / "lake.edits"
        edits.write_text("# a comment\nw22 set height\n")
        done = run("compile", self.cut_lake(), "--edits", edits, "-o", self.folder / "out")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn(f'{edits}:2:9: expected a tag such as height=12, found "height"', done.stderr)

    def test_a_finished_region_is_not_compiled_again(self):
        plan = self.planned()
        region = self.regions_of(plan)[0]
        run("compile", "--plan", plan, "--region", region)
        again = run("compile", "--plan", plan, "--region", region)
        self.assertIn("done already", again.stdout)
        # a plan made again changes nothing
        self.planned()
        self.assertIn("done already", run("compile", "--plan", plan, "--region", region).stdout)
        # an output that is gone is made again
        shutil.rmtree(plan / "regions" / region / "glb")
        self.assertNotIn("done already", run("compile", "--plan", plan, "--region", region).stdout)

    def test_gather_names_what_is_missing(self):
        plan = self.planned()
        regions = self.regions_of(plan)
        for region in regions[1:3]:
            run("compile", "--plan", plan, "--region", region)
        done = run("gather", plan)
        self.assertEqual(done.returncode, 1)
        self.assertIn(f"region {regions[0]}: waiting", done.stdout)
        self.assertFalse((plan / "out" / "report.json").exists())

    @long_test
    def test_gather_names_tiles_of_neighbouring_regions_that_do_not_fit(self):
        plan = self.finished()
        # a tile west of a side gets the contents of another one, and the list of its region agrees
        folder = plan / "regions" / "-1_0"
        listed = json.loads((folder / "files.json").read_text())
        files = {each["name"]: each for each in listed["files"]}
        self.assertLessEqual({"glb/-1_0_L0.glb", "glb/-2_1_L0.glb"}, files.keys())
        shutil.copy(folder / "glb" / "-2_1_L0.glb", folder / "glb" / "-1_0_L0.glb")
        files["glb/-1_0_L0.glb"].update({key: value for key, value in files["glb/-2_1_L0.glb"].items() if key != "name"})
        (folder / "files.json").write_text(json.dumps(listed))
        done = run("gather", plan)
        self.assertEqual(done.returncode, 1)
        self.assertIn("-1_0 and its eastern neighbour, level 0", done.stdout)
        self.assertFalse((plan / "out" / "report.json").exists())

    def test_gather_writes_one_tileset_and_one_usd_scene(self):
        # regions leave the land around out of these two
        arguments = ["--lods", "12.5", "--tile", "128", "--emit", "kiln,usd,3dtiles", "--surroundings", "none", *TOWN_MIDDLE]
        whole = self.compiled("whole", self.MAP, *self.DEM, *arguments)
        plan = self.folder / "plan"
        done = run("plan", self.MAP, *self.DEM, *arguments, "--region", self.REGION, "-o", plan)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertGreater(len(self.regions_of(plan)), 1)
        self.compile_all(plan)
        done = run("gather", plan)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual((plan / "out" / "usd" / "scene.usda").read_bytes(), (whole / "usd" / "scene.usda").read_bytes())
        self.assertTrue((plan / "out" / "3dtiles" / "tileset.json").exists())
        self.assertEqual(run("check", plan / "out").returncode, 0)

    @long_test
    def test_zones_are_plans_of_their_own_and_every_command_goes_over_them(self):
        if shutil.which("ninja") is None:
            self.skipTest("ninja is missing")
        plan = self.planned("--zone", 1200)
        zones = json.loads((plan / "zones.json").read_text())["zones"]
        self.assertEqual([zone["zone"] for zone in zones], ["0_0", "1_0"])
        self.assertEqual(zones[0]["box_deg"][2], zones[1]["box_deg"][0])
        self.assertEqual(run("gather", plan).returncode, 1)
        done = subprocess.run(["ninja", "-C", str(plan)], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertEqual(run("plan", "--status", plan).stdout.count(" done"), 2)
        self.assertEqual(run("gather", plan).returncode, 0)
        for zone in zones:
            self.assertTrue((plan / "zones" / zone["zone"] / "out" / "report.json").exists())

    def clip_of(self, west, south, east, north):
        """A file with a box as a polygon."""
        path = self.folder / "clip.geojson"
        ring = [[west, south], [east, south], [east, north], [west, north], [west, south]]
        path.write_text(json.dumps({"type": "Polygon", "coordinates": [ring]}))
        return path

    def test_a_clip_in_regions_is_that_of_one_run(self):
        clip = ["--clip", self.clip_of(12.2994, 48.6996, 12.3016, 48.7004)]
        whole = self.compiled("whole", self.MAP, *self.BOX, *self.DEM, *ARGUMENTS, *clip)
        gathered = self.gathered(None, *clip)
        self.assertEqual(bytes_of_outputs(gathered), bytes_of_outputs(whole))
        ours, theirs = report_of(gathered), report_of(whole)
        self.assertEqual(ours["counts"], theirs["counts"])
        # a region beyond the clip is not compiled, and counts nothing
        self.assertEqual(ours["ledger"]["clip/building"]["out"], theirs["ledger"]["clip/building"]["out"])
        self.assertLessEqual(ours["ledger"]["clip/building"]["in"], theirs["ledger"]["clip/building"]["in"])

    def test_zones_beyond_a_clip_are_left_out(self):
        plan = self.folder / "plan"
        inputs = ["plan", TOWN / "town.osm", "--bbox", "12.2940,48.6992,12.3060,48.7008", *ARGUMENTS, "--region", 512, "--zone", 450]
        done = run(*inputs, "--clip", self.clip_of(12.2945, 48.6994, 12.2960, 48.7006), "-o", plan)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual([zone["zone"] for zone in json.loads((plan / "zones.json").read_text())["zones"]], ["0_0"])
        done = run(*inputs, "--clip", self.clip_of(12.4, 48.8, 12.5, 48.9), "-o", self.folder / "none")
        self.assertEqual(done.returncode, 1)
        self.assertIn("leaves no ground of the map inside", done.stderr)

    def test_a_corrupt_region_fails_alone_with_one_line(self):
        plan = self.planned()
        regions = self.regions_of(plan)
        (plan / "cut" / f"{regions[0]}.osm.pbf").write_bytes(b"nonsense")
        done = run("compile", "--plan", plan, "--region", regions[0])
        self.assertEqual(done.returncode, 1)
        self.assertEqual(done.stderr.strip().count("\n"), 0)
        self.assertEqual(run("compile", "--plan", plan, "--region", regions[1]).returncode, 0)
        status = json.loads(run("plan", "--status", plan, "--json").stdout)
        states = {region["region"]: region["state"] for region in status["regions"]}
        self.assertEqual((states[regions[0]], states[regions[1]]), ("failed", "done"))

    def test_killed_tasks_go_on_and_end_with_the_same_bytes(self):
        plan = self.planned()
        region = self.regions_of(plan)[0]
        draw = random.Random(11)
        for _ in range(6):
            task = subprocess.Popen([PROGRAM, "compile", "--plan", str(plan), "--region", region, "--quiet"], cwd=ROOT)
            time.sleep(draw.uniform(0.05, 0.6))
            task.send_signal(signal.SIGKILL)
            task.wait()
        self.assertEqual(run("compile", "--plan", plan, "--region", region).returncode, 0)
        undisturbed = self.planned(name="undisturbed")
        run("compile", "--plan", undisturbed, "--region", region)
        self.assertEqual(bytes_of_outputs(plan / "regions" / region), bytes_of_outputs(undisturbed / "regions" / region))

    @long_test
    def test_two_tasks_of_one_region_both_end_well(self):
        plan = self.planned()
        region = self.regions_of(plan)[0]
        command = [PROGRAM, "compile", "--plan", str(plan), "--region", region]
        tasks = [subprocess.Popen(command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) for _ in range(3)]
        outputs = [task.communicate() for task in tasks]
        self.assertEqual([task.returncode for task in tasks], [0, 0, 0], outputs)
        self.assertEqual(sum("done already" in out for out, _ in outputs), 2)

    @long_test
    def test_a_killed_task_is_queued_again_by_slurm_three_times(self):
        plan = self.planned()
        programs = self.folder / "programs"
        programs.mkdir()
        for name, text in (("killed", "kill -9 $$"), ("scontrol", f'echo "$@" >> {programs}/asked')):
            (programs / name).write_text(f"#!/bin/sh\n{text}\n")
            (programs / name).chmod(0o755)
        script = plan / "task.sh"
        script.write_text(script.read_text().replace(PROGRAM, str(programs / "killed")))
        for restarts in range(5):
            environment = {**os.environ, "PATH": f"{programs}:{os.environ['PATH']}", "SLURM_ARRAY_JOB_ID": "7", "SLURM_ARRAY_TASK_ID": "0",
                           "SLURM_RESTART_COUNT": str(restarts)}
            done = subprocess.run([script, "regions_1GB.txt", "1"], cwd=plan, env=environment, capture_output=True, check=False)
            self.assertEqual(done.returncode, 137)
        self.assertEqual((programs / "asked").read_text().splitlines(), ["requeue 7_0"] * 3)

    @long_test
    def test_ninja_compiles_all_regions_in_a_folder_with_a_strange_name(self):
        if shutil.which("ninja") is None:
            self.skipTest("ninja is missing")
        plan = self.planned(name="a $plan: 'it''s'")
        done = subprocess.run(["ninja", "-C", str(plan)], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertTrue((plan / "out" / "report.json").exists())

    def test_an_edited_map_recompiles_only_regions_near_the_edit(self):
        edited = self.folder / "edited" / self.MAP.name
        edited.parent.mkdir()
        shutil.copy(self.MAP, edited)
        plan = self.planned("--halo", 256, map_path=edited)
        row = ["-2_0", "-1_0", "0_0", "1_0"]
        self.assertLess(set(row), set(self.regions_of(plan)))
        compile_row = lambda: [run("compile", "--plan", plan, "--region", region) for region in row]
        self.assertEqual([done.returncode for done in compile_row()], [0] * len(row))
        text = edited.read_text()
        # one house gets another height
        place = text.index('<tag k="building"')
        edited.write_text(text[:place] + '<tag k="height" v="31"/>' + text[place:])
        self.planned("--halo", 256, map_path=edited)
        compiled = sum("done already" not in done.stdout for done in compile_row())
        self.assertGreater(compiled, 0)
        self.assertLess(compiled, len(row))

    @long_test
    def test_after_an_edit_tiles_whose_recipes_are_unchanged_are_not_baked_again(self):
        edited = self.folder / "edited" / self.MAP.name
        edited.parent.mkdir()
        shutil.copy(self.MAP, edited)
        plan = self.finished()
        edited.write_text(edited.read_text().replace('<tag k="building:levels" v="', '<tag k="building:levels" v="1', 1))
        self.planned(map_path=edited)
        again = "".join(run("compile", "--plan", plan, "--region", region).stdout for region in self.regions_of(plan))
        kept = sum(int(count) for count in re.findall(r"note: (\d+) of \d+ tile files were whole", again))
        tiles = len(list((plan / "regions").glob("*/glb/*.glb")))
        self.assertGreater(kept, tiles / 2)
        self.assertLess(kept, tiles)
        self.assertEqual(run("gather", plan).returncode, 0)
        whole = self.compiled("whole", edited, *self.DEM, *ARGUMENTS)
        self.assertEqual(bytes_of_outputs(plan / "out"), bytes_of_outputs(whole))

    def test_a_region_whose_disk_is_full_fails_alone_with_one_line(self):
        plan = self.finished()
        planned = json.loads((plan / "plan.json").read_text())["regions"]
        region = max(planned, key=lambda one: one["own_way_nodes"])["region"]
        folder = plan / "regions" / region
        shutil.rmtree(folder)
        folder.mkdir()
        mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=64k", "tmpfs", folder], capture_output=True, check=False)
        if mounted.returncode != 0:
            self.skipTest("a small disk needs root")
        try:
            done = run("compile", "--plan", plan, "--region", region)
        finally:
            subprocess.run(["umount", folder], check=True)
        self.assertEqual(done.returncode, 1)
        self.assertEqual(done.stderr.strip().count("\n"), 0, done.stderr)
        self.assertIn("No space left on device", done.stderr)
        self.assertIn(f"missing: region {region}: failed", run("gather", plan).stdout)
        self.assertEqual(run("compile", "--plan", plan, "--region", region).returncode, 0)
        self.assertEqual(run("gather", plan).returncode, 0)

    def test_a_region_whose_survey_is_damaged_fails_alone_with_one_line(self):
        plan = self.planned()
        damaged, *others = self.regions_of(plan)[:4]
        survey = plan / "survey" / f"{damaged}.kiln"
        content = bytearray(survey.read_bytes())
        content[len(content) // 2] ^= 255
        survey.write_bytes(content)
        done = run("compile", "--plan", plan, "--region", damaged)
        self.assertNotEqual(done.returncode, 0)
        self.assertEqual(done.stderr.strip().count("\n"), 0, done.stderr)
        self.assertEqual([run("compile", "--plan", plan, "--region", other).returncode for other in others], [0] * 3)

    def test_a_heightmap_that_cannot_be_read_ends_the_plan_with_its_name(self):
        heights = self.folder / "heights"
        heights.mkdir()
        (heights / "N00E000.hgt").write_bytes(b"nonsense")
        done = run("plan", self.MAP, "--dem", heights, *ARGUMENTS, "-o", self.folder / "plan")
        self.assertEqual(done.returncode, 1)
        self.assertEqual(done.stderr.strip().count("\n"), 0)
        self.assertIn("N00E000.hgt", done.stderr)


if __name__ == "__main__":
    unittest.main()
