#!/usr/bin/env python3
"""Bad input gives one error line and exit code 1, and leaves no incomplete file under its final name."""
import os
import resource
import subprocess
import unittest

from citykiln_program import PROGRAM, ROOT, ProgramTest, run

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
        self.fails(self.written("cut.osm", MAP[:400]), words=["cut.osm"])

    def test_text_named_pbf(self):
        self.fails(self.written("text.osm.pbf", "just a sentence, not a map\n" * 20), words=["text.osm.pbf"])

    def test_pbf_named_xml(self):
        self.fails(self.written("binary.osm", bytes(range(256)) * 8), words=["binary.osm"])

    def test_an_empty_file(self):
        self.fails(self.written("empty.osm", ""), words=["empty.osm"])
        self.fails(self.written("empty.osm.pbf", ""), words=["empty.osm.pbf"])

    def test_a_map_that_holds_nothing(self):
        self.fails(self.written("nothing.osm", EMPTY_MAP), words=["nothing.osm", "contains nothing to compile"])

    def test_an_unknown_file_type(self):
        self.fails(self.written("map.txt", MAP), words=["map.txt"])

    def test_a_truncated_pbf_real(self):
        whole = self.data("small/somes-island.osm.pbf").read_bytes()
        for share in (0.1, 0.5, 0.99):
            self.fails(self.written("cut.osm.pbf", whole[: int(len(whole) * share)]), words=["cut.osm.pbf"])

    def test_truncated_compressed_xml_real(self):
        self.fails(self.written("cut.osm.bz2", self.data("small/West-Oakland.osm.bz2").read_bytes()[:6000]), words=["cut.osm.bz2"])
        self.fails(self.written("cut.osm.gz", self.data("berlin/berlin-siegessaeule.osm.gz").read_bytes()[:60000]), words=["cut.osm.gz"])

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

    # ---- the command line

    def test_planned_settings_say_not_yet(self):
        for arguments in (["--emit", "usd"], ["--emit", "kiln,3dtiles"], ["--world", "ellipsoid"], ["--world", "cylinder:8000"]):
            with self.subTest(arguments):
                self.fails(self.good_map(), *arguments, words=[arguments[0], "yet"])

    def test_wrong_settings_are_named(self):
        for arguments in (["--tile", "100"], ["--lods", "1,0.5"], ["--bbox", "1,2,3"], ["--only", "x"], ["--time", "noon"],
                          ["--seed", "-1"], ["--target", "maya"], ["--split", "road"], ["--compress", "zip"]):
            with self.subTest(arguments):
                self.fails(self.good_map(), *arguments, words=[arguments[0]])

    def test_a_spec_with_an_unknown_key(self):
        spec = self.written("spec.json", '{"map": "a.osm", "tiles": 512}')
        self.assertOneLine(run("compile", "--spec", spec), "spec.json", "tiles")

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
