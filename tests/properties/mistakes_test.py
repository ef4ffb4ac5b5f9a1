#!/usr/bin/env python3
"""Mistakes of users: rules of buildings with faults, and command lines. Each is one line that says what to mend, in a second."""
import json
import signal
import socket
import subprocess
import time
import unittest

from citykiln_program import PROGRAM, ROOT, ProgramTest, report_of, run

HOUSES = """<?xml version="1.0" encoding="UTF-8"?>
<osm version="0.6">
 <node id="1" lat="48.0010" lon="10.0010"/><node id="2" lat="48.0010" lon="10.0013"/>
 <node id="3" lat="48.0012" lon="10.0013"/><node id="4" lat="48.0012" lon="10.0010"/>
 <node id="5" lat="48.0014" lon="10.0010"/><node id="6" lat="48.0014" lon="10.0013"/>
 <node id="7" lat="48.0016" lon="10.0013"/><node id="8" lat="48.0016" lon="10.0010"/>
 <way id="11"><nd ref="1"/><nd ref="2"/><nd ref="3"/><nd ref="4"/><nd ref="1"/><tag k="building" v="detached"/></way>
 <way id="12"><nd ref="5"/><nd ref="6"/><nd ref="7"/><nd ref="8"/><nd ref="5"/><tag k="building" v="detached"/></way>
</osm>
"""
START = "@StartRule\nBuilding --> "


class Mistakes(ProgramTest):
    def written(self, name, text):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return path

    def town(self):
        """The folder of a run that all tests of the class share."""
        return self.compiled_once(ROOT / "examples" / "town" / "town.osm", "--bbox", "12.2990,48.6992,12.3020,48.7008",
                                  "--lods", "2.5,12.5", "--emit", "kiln,glb")

    def compiled_with(self, rules):
        """Compiles two houses with these rules in place of those of all houses; returns the run and the tags of its findings."""
        folder = self.folder / "rules"
        for style in ("villa", "row_house", "old_town_house"):
            self.written(f"rules/{style}.cga", rules)
        out = self.folder / "out"
        done = run("compile", self.written("houses.osm", HOUSES), "--rules", folder, "--lods", "0.5,2.5", "-o", out)
        faults = []
        if done.returncode == 0:
            found = report_of(out)["diagnoses"]
            faults = [tag for code in ("RuleErrors", "RuleWithoutEffect") for tag in found.get(code, {}).get("tags", {})]
        return done, faults

    def assertOneLine(self, done, *words):
        self.assertEqual(done.returncode, 1, f"exit {done.returncode}: {done.stdout} {done.stderr}")
        lines = [line for line in done.stderr.splitlines() if line]
        self.assertEqual(len(lines), 1, done.stderr)
        for word in words:
            self.assertIn(str(word), lines[0])

    # ---- rules of buildings

    def test_faults_of_rules_are_refused_with_file_line_and_rule(self):
        cases = (("import x : \"nowhere.cga\"\n" + START + "comp(f) { all : x.W }", (".cga:1:1: the import \"nowhere.cga\": there is no such rule file",)),
                 (START + "comp(f) { side : W. | top : Roof\n\nW --> NIL", (".cga:", "(in rule Building)")),
                 (START + "extrudeee(3) W.", (".cga:2:", "'extrudeee'", "(in rule Building)")),
                 (START + "comp(f) { side : split(y) { hoehe : W. } }", (".cga:2:", "'hoehe'", "(in rule Building)")),
                 (START + "W\nW --> X.\nW --> Y.", (".cga:4:1: the rule 'W' is defined twice",)))
        for rules, words in cases:
            with self.subTest(rules=rules):
                self.assertOneLine(self.compiled_with(rules)[0], *words)

    def test_divisions_by_zero_and_negative_repeats_are_findings_with_the_rule(self):
        for rules, fault in (("attr n = 0\n" + START + "comp(f) { side : split(x) { { ~(1/n) : W. }* } | all : R. }", ":3:47, rule Building: division by zero"),
                             (START + "comp(f) { side : split(x) { { -1 : W. }* } | all : R. }", "rule Building: a size of -1 in a repeated group")):
            with self.subTest(rules=rules):
                done, faults = self.compiled_with(rules)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertTrue(any(fault in each for each in faults), faults)
                self.assertIn("rule Building", done.stdout)

    def test_rules_that_grow_without_end_stop_within_a_second(self):
        for rules in (START + "A(1)\nA(n) --> A(n+1) A(n+1)", START + "A\nA --> B\nB --> A", START + "A\nA --> s('0.9,'0.9,'0.9) A A A A"):
            with self.subTest(rules=rules):
                begin = time.monotonic()
                done, faults = self.compiled_with(rules)
                self.assertLess(time.monotonic() - begin, 3, "two houses, two levels")
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertTrue(any("rule A: the limit of depth is reached; the rule calls itself without end" in each
                                    or "rule B: the limit of depth" in each for each in faults), faults)

    def test_a_byte_order_mark_is_read(self):
        done, faults = self.compiled_with(b"\xef\xbb\xbf" + (START + "comp(f) { all : W. }").encode())
        self.assertEqual((done.returncode, faults), (0, []), done.stderr)

    def test_a_wrong_setting_of_a_spec_has_its_line(self):
        spec = self.written("spec.json", "{\n  \"map\": \"a.osm\",\n  \"tile\": 1\n}")
        self.assertOneLine(run("compile", "--spec", spec), "spec.json:3:3: \"tile\": expected")
        spec = self.written("spec.json", "{\"map\": \"a.osm\",\n \"map\": \"b.osm\"}")
        self.assertOneLine(run("compile", "--spec", spec), "spec.json:2:2: \"map\" is given twice")

    # ---- the command line

    def test_mistaken_command_lines_say_what_was_meant(self):
        town = self.town()
        cases = ((("map.osm",), "did you mean citykiln compile map.osm -o out?"),
                 ((town,), f"did you mean citykiln view {town}?"),
                 ((f"{town}/scene.kiln",), "did you mean citykiln preview"),
                 (("compile", "a.osm", "--levels", "1"), "did you mean --lods?"),
                 (("compile", "a.osm", "--heights", "1"), "did you mean --dem?"),
                 (("compile", "a.osm", "--theads", "1"), "did you mean --threads?"),
                 (("compile", "a.osm", "--lods", "0.0000001"), "0.001 to 100"),
                 (("view", "nosuch"), "nosuch: there is no such file or folder"),
                 (("check", "nosuch"), "nosuch: there is no such file or folder"),
                 (("view", self.written("map.osm", HOUSES)), "is a map; compile it first: citykiln compile"),
                 (("preview", self.written("map.osm", HOUSES), "-o", "a.png"), "is a map; compile it first"),
                 (("preview", town, "--level", "9", "-o", self.folder / "a.png"), "has no level 9; its levels are 0 (2.5 m), 1 (12.5 m)"),
                 (("compile", "a.osm", "b.osm", "-o", "out"), "one word too much: b.osm"),
                 (("compile", "a.osm", "-threads", "2"), "did you mean --threads?"),
                 (("-o", "out", "compile", "a.osm"), "the verb comes first"),
                 (("--hlep",), "did you mean --help?"),
                 (("compile", "a.osm", "-o"), "--out: expected FOLDER after it"),
                 (("check", f"{town}/report.json"), "expected the folder of a run, found a file"),
                 (("help",), "did you mean citykiln --help?"),
                 (("chart", "plane"), "charts are made by citykiln-chart, which the build of the tests makes"),
                 (("preview", f"{town}/scene.kiln", "--level", "1", "-o", self.folder / "a.png"), "--level: is for a folder's tiles"),
                 (("view", town, "--port", "99999"), "--port: expected a port from 0 to 65535"),
                 (("view", town, "--port", "-1"), "--port: expected a port from 0 to 65535"))
        for words, message in cases:
            with self.subTest(words=words):
                self.assertOneLine(run(*words), message)

    def test_what_cannot_be_written_is_refused_before_the_work(self):
        town, none = self.town(), self.folder / "none"
        cases = (("preview", town, "-o", self.folder / "a.gif"), ("preview", town, "-o", none / "a.png"),
                 ("preview", town, "-o", self.folder), ("bake", town, "--tolerance", "2.5", "-o", none / "a.glb"),
                 ("bake", town, "--tolerance", "2.5", "-o", self.folder / "a.gif"), ("inspect", "oak", "-o", self.folder / "a.gif"),
                 ("inspect", "--sheet", none / "a.png"), ("inspect", town, "--layer", "roads", "--geojson", none / "a.geojson"),
                 ("check", town, "--worst", "3", "-o", self.written("file", "") / "page"))
        for words in cases:
            with self.subTest(words=words):
                begin = time.monotonic()
                self.assertOneLine(run(*words), words[-1])
                self.assertLess(time.monotonic() - begin, 2)

    def test_a_run_without_a_manifest_says_how_to_get_one(self):
        out = self.folder / "tiles"
        done = run("compile", self.written("houses.osm", HOUSES), "--emit", "3dtiles", "--lods", "2.5", "-o", out)
        self.assertEqual(done.returncode, 0, done.stderr)
        for words in (("check", out), ("view", out), ("bake", out, "-o", self.folder / "baked"), ("inspect", out)):
            with self.subTest(words=words):
                self.assertOneLine(run(*words), "was written without its manifest", "--emit kiln,3dtiles")

    def test_json_is_one_value_also_when_a_verb_fails(self):
        town = self.town()
        broken = self.compiled("broken", self.written("houses.osm", HOUSES), "--lods", "2.5")
        tile = next(broken.glob("glb/*.glb"))
        tile.write_bytes(tile.read_bytes()[:-4])
        cases = ((("check", town), 0), (("check", broken), 1), (("check", "nosuch"), 1), (("inspect", town), 0), (("inspect", "nosuch"), 1),
                 (("inspect", town, "--layer", "roads", "--geojson", self.folder / "r.geojson"), 0),
                 (("bake", town, "--tolerance", "12.5", "-o", self.folder / "a.glb"), 0), (("bake", "nosuch", "-o", "x"), 1),
                 (("preview", town, "--size", "16x9", "--spp", "1", "-o", self.folder / "a.png"), 0),
                 (("preview", town, "--size", "16x9", "--spp", "1", "--turntable", "2", "-o", self.folder / "f_#.png"), 0),
                 (("preview", "nosuch", "-o", "a.png"), 1), (("compile", "nosuch.osm", "-o", self.folder / "x"), 1),
                 (("compile", self.folder / "houses.osm", "--lods", "12.5", "-o", self.folder / "x"), 0),
                 (("gather", "nosuch"), 1), (("plan", "nosuch.osm", "-o", self.folder / "p"), 1), (("view", "nosuch"), 1),
                 (("view", town, "--write-only"), 0), (("addon", "blender", "-o", self.folder / "a.zip"), 0),
                 (("invent", "--kind", "nosuch", "-o", self.folder / "i"), 1), (("nosuch",), 1), (("compile", "--nosuch"), 1), ((), 1))
        for words, code in cases:
            with self.subTest(words=words):
                done = run(*words, "--json")
                self.assertEqual(done.returncode, code, done.stderr)
                value = json.loads(done.stdout)
                self.assertEqual(isinstance(value, dict) and "error" in value, code == 1, done.stdout)

    def test_a_second_viewer_on_a_port_is_refused(self):
        town = self.town()
        self.assertEqual(run("view", town, "--write-only").returncode, 0)
        with socket.socket() as probe:
            probe.bind(("127.0.0.1", 0))
            port = probe.getsockname()[1]
        first = subprocess.Popen([PROGRAM, "view", str(town), "--port", str(port)], stdout=subprocess.PIPE, text=True)
        try:
            self.assertIn(str(port), first.stdout.readline())
            self.assertOneLine(run("view", town, "--port", port, timeout=20), f"port {port} is in use")
        finally:
            first.send_signal(signal.SIGINT)
            first.wait(10)
            first.stdout.close()


if __name__ == "__main__":
    unittest.main()
