#!/usr/bin/env python3
"""`demo` compiles the example town into a folder and shows it; a fresh run is kept, one of another map is refused. `compile` ends with
the command that shows the run."""
import http.client
import json
import os
import re
import signal
import subprocess
import unittest

from citykiln_program import PROGRAM, TOWN, TOWN_MIDDLE, ProgramTest, run


class Demo(ProgramTest):
    def demo(self, *arguments):
        return subprocess.run([PROGRAM, "demo", *map(str, arguments)], capture_output=True, text=True, cwd=self.folder, check=False)

    def test_one_command_shows_the_town_and_ctrl_c_ends_it(self):
        with subprocess.Popen([PROGRAM, "demo"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, cwd=self.folder) as process:
            for line in process.stdout:
                if line.startswith("http://"):
                    break
            port = int(re.search(r"127.0.0.1:(\d+)/", line)[1])
            for name, kind in (("/", "text/html"), ("/3dtiles/tileset.json", "application/json")):
                connection = http.client.HTTPConnection("127.0.0.1", port, timeout=300)
                connection.request("GET", name)
                answer = connection.getresponse()
                self.assertEqual((answer.status, answer.headers["Content-Type"].split(";")[0]), (200, kind))
                connection.close()
            process.send_signal(signal.SIGINT)
            self.assertEqual(process.wait(), 130)
            self.assertEqual(process.stderr.read(), "citykiln: interrupted; the server has ended; it wrote nothing\n")
        self.assertTrue((self.folder / "citykiln-demo" / "scene.kiln").exists())

    def test_a_fresh_run_is_kept_and_an_old_one_is_made_again(self):
        self.assertIn("compiling the example town", self.demo("--no-view", "-o", "town").stdout)
        report = self.folder / "town" / "report.json"
        first = report.stat().st_mtime_ns
        again = self.demo("--no-view", "-o", "town")
        self.assertIn("holds the example town already", again.stdout)
        self.assertTrue(again.stdout.endswith("  citykiln view town   shows it in a browser\n"), again.stdout)
        self.assertEqual(report.stat().st_mtime_ns, first)
        os.utime(report, (1, 1))
        self.assertIn("compiling the example town", self.demo("--no-view", "-o", "town").stdout)
        self.assertGreater(report.stat().st_mtime_ns, first)

    def test_a_run_of_another_map_is_refused_and_stays(self):
        report = {"sources": ["monaco.osm.pbf"]}
        folder = self.folder / "town"
        folder.mkdir()
        (folder / "report.json").write_text(json.dumps(report))
        done = self.demo("--no-view", "-o", "town")
        self.assertEqual((done.returncode, done.stderr),
                         (1, "citykiln: town: holds a run of another map, monaco.osm.pbf; give another folder with -o\n"))
        self.assertEqual(json.loads((folder / "report.json").read_text()), report)

    def test_compile_ends_with_the_command_that_shows_the_run(self):
        town = ["--spec", TOWN / "spec.json", *TOWN_MIDDLE, "--emit"]
        out = self.folder / "out"
        done = run("compile", *town, "kiln", "-o", out)
        self.assertEqual(done.stdout.splitlines()[-1], f"  citykiln view {out}   shows it in a browser")
        self.assertNotIn("citykiln view", run("compile", *town, "glb", "--lods", "12.5", "-o", self.folder / "tiles").stdout)
        self.assertEqual(run("compile", *town, "kiln", "--quiet", "-o", out).stdout, "")


if __name__ == "__main__":
    unittest.main()
