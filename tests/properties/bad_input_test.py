#!/usr/bin/env python3
"""Bad input gives one error line and exit code 1, and leaves no incomplete file under its final name."""
import os
import resource
import subprocess
import unittest

from citykiln_program import PROGRAM, ROOT, ProgramTest, report_of, run

MAP = """<?xml version="1.0" encoding="UTF-8"?>
<osm version="0.6">
 <node id="1" lat="48.0010" lon="10.0010"/><node id="2" lat="48.0010" lon="10.0013"/>
 <node id="3" lat="48.0012" lon="10.0013"/><node id="4" lat="48.0012" lon="10.0010"/>
 <node id="5" lat="48.0014" lon="10.0000"/><node id="6" lat="48.0014" lon="10.0020"/>
 <way id="7"><nd ref="1"/><nd ref="2"/><nd ref="3"/><nd ref="4"/><nd ref="1"/><tag k="building" v="house"/></way>
 <way id="8"><nd ref="5"/><nd ref="6"/><tag k="highway" v="residential"/></way>
</osm>
"""
EMPTY_MAP = '<?xml version="1.0" encoding="UTF-8"?>\n<osm version="0.6"></osm>\n'


class BadInput(ProgramTest):
    def written(self, name, content):
        path = self.folder / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    def assertOneLine(self, done, *words):
        self.assertEqual(done.returncode, 1, f"exit {done.returncode}: {done.stderr}")
        lines = [line for line in done.stderr.splitlines() if line]
        self.assertEqual(len(lines), 1, done.stderr)
        for word in words:
            self.assertIn(str(word), lines[0])

    def assertNothingLeft(self, out):
        left = [str(p) for p in out.rglob("*")] if out.exists() else []
        self.assertEqual(left, [])

    def fails(self, map_path, *arguments, words=(), **options):
        out = self.folder / "out"
        done = run("compile", map_path, *arguments, "-o", out, **options)
        self.assertOneLine(done, *words)
        self.assertNothingLeft(out)

    def good_map(self):
        return self.written("good.osm", MAP)

    def good_outputs(self):
        return self.compiled("good", self.good_map(), "--lods", "0.5")

    # ---- maps

    def test_a_missing_map(self):
        self.fails(self.folder / "nowhere.osm", words=["nowhere.osm"])

    def test_xml_cut_in_the_middle(self):
        self.fails(self.written("cut.osm", MAP[:400]), words=["cut.osm", "the file is cut off: load it again"])

    def test_text_named_pbf(self):
        self.fails(self.written("text.osm.pbf", "just a sentence, not a map\n" * 20), words=["text.osm.pbf"])

    def test_pbf_named_xml(self):
        self.fails(self.written("binary.osm", bytes(range(256)) * 8), words=["binary.osm"])

    def test_an_empty_file(self):
        self.fails(self.written("empty.osm", ""), words=["empty.osm"])
        self.fails(self.written("empty.osm.pbf", ""), words=["empty.osm.pbf"])

    def test_a_map_that_holds_nothing(self):
        self.fails(self.written("nothing.osm", EMPTY_MAP), words=["nothing.osm", "contains nothing to compile"])

    def test_a_box_of_half_the_world_proposes_that_of_the_nodes(self):
        half = MAP.replace('<osm version="0.6">', '<osm version="0.6"><bounds minlat="0" minlon="0" maxlat="90" maxlon="180"/>')
        self.fails(self.written("half.osm", half), words=["half.osm", "--bbox 10.0000,48.0010,10.0020,48.0014"])

    def test_changes_of_a_map(self):
        changes = MAP.replace("<osm ", "<osmChange ").replace("</osm>", "</osmChange>")
        self.fails(self.written("a.osc", changes), words=["a.osc", "osmium apply-changes"])
        self.fails(self.written("a.osm", changes), words=["a.osm", "osmium apply-changes"])

    def test_an_answer_without_nodes(self):
        ways = "".join(f'<way id="{i}"><center lat="48" lon="10"/><nd ref="1"/><nd ref="2"/><tag k="highway" v="road"/></way>' for i in range(1, 5))
        self.fails(self.written("center.osm", f'<osm version="0.6">{ways}</osm>'), words=["center.osm", "out center", "out geom;"])

    def test_an_unknown_file_type(self):
        self.fails(self.written("map.txt", MAP), words=["map.txt"])

    def test_a_truncated_pbf_real(self):
        whole = self.data("small/somes-island.osm.pbf").read_bytes()
        for share in (0.1, 0.5, 0.99):
            self.fails(self.written("cut.osm.pbf", whole[: int(len(whole) * share)]), words=["cut.osm.pbf", "load it again"])

    def test_truncated_compressed_xml_real(self):
        self.fails(self.written("cut.osm.bz2", self.data("small/West-Oakland.osm.bz2").read_bytes()[:6000]), words=["cut.osm.bz2", "load it again"])
        self.fails(self.written("cut.osm.gz", self.data("berlin/berlin-siegessaeule.osm.gz").read_bytes()[:60000]), words=["cut.osm.gz", "load it again"])

    # ---- heightmaps

    def test_a_missing_heightmap(self):
        self.fails(self.good_map(), "--dem", self.folder / "nowhere.tif", words=["nowhere.tif"])

    def test_a_heightmap_elsewhere(self):
        elsewhere = "ncols 4\nnrows 4\nxllcorner 100\nyllcorner 10\ncellsize 0.001\n" + "1 2 3 4\n" * 4
        self.fails(self.good_map(), "--dem", self.written("elsewhere.asc", elsewhere), words=["elsewhere.asc"])

    def test_a_heightmap_that_is_text(self):
        self.fails(self.good_map(), "--dem", self.written("words.tif", "no heights here\n"), words=["words.tif"])

    def test_an_unknown_key_of_a_heightmap(self):
        self.fails(self.good_map(), "--dem", "a.png,bound=1/2/3/4", words=["bound"])

    # ---- folders and disks

    def test_a_folder_that_cannot_be_made(self):
        self.assertOneLine(run("compile", self.good_map(), "-o", "/proc/citykiln"), "/proc/citykiln")

    def test_a_file_where_the_folder_should_be(self):
        blocked = self.written("blocked", "")
        self.assertOneLine(run("compile", self.good_map(), "-o", blocked), "blocked")
        self.assertOneLine(run("compile", self.good_map(), "-o", blocked / "below"), "blocked")

    @unittest.skipIf(os.geteuid() == 0, "root may write anywhere")
    def test_a_folder_that_may_not_be_written(self):
        locked = self.folder / "locked"
        locked.mkdir(mode=0o500)
        self.assertOneLine(run("compile", self.good_map(), "-o", locked), "locked")

    def test_files_that_may_not_grow(self):
        few_bytes = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (512, 512))
        self.fails(self.good_map(), preexec_fn=few_bytes)

    def test_a_full_disk(self):
        disk = self.folder / "disk"
        disk.mkdir()
        map_path = self.good_map()
        script = (f"mount -t tmpfs -o size=16k none {disk} && {{ {PROGRAM} compile {map_path} -o {disk}/out; status=$?; "
                  f"find {disk} -mindepth 1 >&2; exit $status; }} || exit $?")
        done = subprocess.run(["unshare", "-rm", "sh", "-c", script], capture_output=True, text=True, cwd=ROOT, check=False)
        if "unshare" in done.stderr or "mount" in done.stderr:
            self.skipTest("no right to mount a small disk")
        self.assertOneLine(done, "disk")

    # ---- manifests and tiles

    def broken_copies(self, path):
        """Copies that every reader must reject: truncated, emptied, overwritten."""
        whole = path.read_bytes()
        middle = len(whole) // 2
        yield "cut", whole[:middle]
        yield "cut_late", whole[:-1]
        yield "empty", b""
        yield "text", b"not what it says\n" * 50
        yield "zeros", b"\0" * len(whole)
        yield "no_begin", b"\xff" * 16 + whole[16:]

    def test_a_corrupt_manifest(self):
        manifest = self.good_outputs() / "scene.kiln"
        for name, content in self.broken_copies(manifest):
            with self.subTest(name):
                broken = self.written(f"{name}.kiln", content)
                out = self.folder / "baked"
                self.assertOneLine(run("bake", broken, "-o", out), broken.name)
                self.assertNothingLeft(out)
                self.assertOneLine(run("inspect", broken), broken.name)

    def test_a_corrupt_tile(self):
        tile = next((self.good_outputs() / "glb").glob("*.glb"))
        for name, content in self.broken_copies(tile):
            with self.subTest(name):
                broken = self.written(f"{name}.glb", content)
                picture = self.folder / "picture.png"
                self.assertOneLine(run("preview", broken, "-o", picture), broken.name)
                self.assertFalse(picture.exists())
                self.assertOneLine(run("inspect", broken), broken.name)

    def test_flipped_bytes_never_crash_a_reader(self):
        good = self.good_outputs()
        for path in (good / "scene.kiln", next((good / "glb").glob("*.glb"))):
            whole = path.read_bytes()
            step = max(1, len(whole) // 60)
            for place in range(0, len(whole), step):
                broken = self.written("flipped" + path.suffix, whole[:place] + bytes([whole[place] ^ 0x55]) + whole[place + 1 :])
                done = run("inspect", broken)
                self.assertIn(done.returncode, (0, 1), f"byte {place} of {path.name}: {done.stderr}")

    # ---- the box

    def test_a_box_as_latitude_longitude(self):
        self.fails(self.good_map(), "--bbox", "48,10,48.01,10.01", words=["--bbox", "swapped? Try 10.0000,48.0000,10.0100,48.0100"])
        self.fails(self.good_map(), "--bbox=-33.9,151.1,-33.8,151.3", words=["--bbox", "swapped?"])

    def test_a_box_beside_the_map_states_both(self):
        self.fails(self.good_map(), "--bbox", "20,50,20.1,50.1", words=["20.0000,50.0000", "10.0000,48.0010,10.0020,48.0014"])

    def test_a_box_far_larger_than_the_map_is_clipped(self):
        report = report_of(self.compiled("clipped", self.good_map(), "--bbox", "0,40,20,56", "--lods", "2.5"))
        self.assertIn("BoxClipped", report["diagnoses"])
        self.assertLessEqual(report["region_m"][2] - report["region_m"][0], 512)

    # ---- maps with far nodes

    def test_one_stray_node_does_not_widen_the_extent(self):
        nodes = "".join(f'<node id="{200 + i}" lat="48.0014" lon="{10.0021 + i * 1e-4:.4f}"/>' for i in range(20))
        paths = "".join(f'<way id="{100 + i}"><nd ref="5"/><nd ref="{200 + i}"/><tag k="highway" v="path"/></way>' for i in range(20))
        far_node = '<node id="99" lat="58.0" lon="0.5"/>'
        far_way = '<way id="98"><nd ref="6"/><nd ref="99"/><tag k="highway" v="service"/></way>'
        text = MAP.replace('<way id="7">', nodes + far_node + '<way id="7">').replace("</osm>", paths + far_way + "</osm>")
        report = report_of(self.compiled("stray", self.written("stray.osm", text), "--lods", "2.5"))
        self.assertEqual(report["diagnoses"]["StrayNode"]["objects"], ["n99"])
        self.assertLessEqual(report["region_m"][2] - report["region_m"][0], 1024)
        self.assertIn("w98", report["diagnoses"]["CutAtBounds"]["objects"])

    def test_a_map_scattered_over_the_world_is_refused(self):
        far = MAP.replace('id="5" lat="48.0014" lon="10.0000"', 'id="5" lat="40.0014" lon="1.0000"')
        self.fails(self.written("far.osm", far), words=["far.osm", "km", "--bbox"])

    # ---- heightmaps

    def test_a_heightmap_elsewhere_states_where_both_lie(self):
        grid = self.written("elsewhere.asc", "ncols 2\nnrows 2\nxllcenter 20\nyllcenter 50\ncellsize 1\n1 2\n3 4\n")
        self.fails(self.good_map(), "--dem", grid, words=["elsewhere.asc", "20.0000,50.0000,21.0000,51.0000", "10.0000,48.0000"])

    def test_several_heightmaps_follow_one_option(self):
        grids = [self.written(f"{name}.asc", f"ncols 2\nnrows 2\nxllcenter {west}\nyllcenter 47.5\ncellsize 1\n1 2\n3 4\n")
                 for name, west in (("a", 9.5), ("b", 10.5))]
        last = self.compiled("last", "--dem", *grids, self.good_map(), "--lods", "2.5")
        first = self.compiled("first", self.good_map(), "--dem", *grids, "--lods", "2.5")
        self.assertEqual(report_of(last)["sources"], ["good.osm", "a.asc", "b.asc"])
        self.assertEqual(report_of(first)["sources"], ["good.osm", "a.asc", "b.asc"])
        self.assertNotIn("NoHeightmap", report_of(first)["diagnoses"])

    def test_no_heightmap_is_a_note(self):
        self.assertEqual(report_of(self.good_outputs())["diagnoses"]["NoHeightmap"]["severity"], "note")

    # ---- the command line

    def test_wrong_settings_are_named(self):
        for arguments in (["--tile", "100"], ["--lods", "1,0.5"], ["--lods", "500"], ["--bbox", "1,2,3"], ["--only", "x"], ["--time", "noon"],
                          ["--seed", "-1"], ["--target", "maya"], ["--split", "road"], ["--compress", "zip"]):
            with self.subTest(arguments):
                self.fails(self.good_map(), *arguments, words=[arguments[0]])

    def test_a_spec_with_an_unknown_key(self):
        spec = self.written("spec.json", '{"map": "a.osm", "tiles": 512}')
        self.assertOneLine(run("compile", "--spec", spec), "spec.json", "tiles", "did you mean tile?")

    def test_a_spec_with_a_wrong_value_names_the_setting(self):
        spec = self.written("spec.json", '{"map": "a.osm", "tile": 500}')
        self.assertOneLine(run("compile", "--spec", spec), 'spec.json:1:18: "tile": expected', '"500"')

    def test_mistyped_verbs_and_options(self):
        self.assertOneLine(run("complie", "a.osm"), "complie", "did you mean compile?")
        self.assertOneLine(run("compile", "a.osm", "--lod", "1"), "--lod", "did you mean --lods?")

    def test_tolerances_beyond_a_millimetre_and_a_hundred_metres(self):
        for tolerance in ("500", "1e9", "0", "0.0000001"):
            self.assertOneLine(run("preview", "scene.kiln", "--tolerance", tolerance, "-o", "a.png"), "--tolerance", "0.001 to 100")

    def test_a_spec_that_is_not_json(self):
        spec = self.written("spec.json", '{"map": \n  nonsense}')
        self.assertOneLine(run("compile", "--spec", spec), "spec.json:2:")

    def test_tiles_outside_the_map(self):
        self.fails(self.good_map(), "--only", "900_900", words=["900_900"])

    def test_strict_is_exit_2_and_keeps_the_outputs(self):
        incomplete = MAP.replace('<nd ref="6"/>', '<nd ref="6"/><nd ref="99"/>')
        out = self.folder / "out"
        done = run("compile", self.written("incomplete.osm", incomplete), "--lods", "0.5", "--strict", "-o", out)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertTrue((out / "report.json").exists())


if __name__ == "__main__":
    unittest.main()
