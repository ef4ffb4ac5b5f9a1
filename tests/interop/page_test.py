#!/usr/bin/env python3
"""The page of `citykiln view`: what its server answers and refuses, and every function of the page in headless Chromium (tests in page/).

page_test.py [TEST…]
"""
import functools
import http.client
import http.server
import json
import os
import re
import socket
import subprocess
import sys
import threading
import unittest
from pathlib import Path

import readers
from citykiln_program import PROGRAM, TOWN, ProgramTest, report_of, run

VIEWER = readers.HERE.parent.parent / "exporters" / "page" / "viewer"
# small tiles: pictures are drawn without a graphics card
LEVELS = ("--lods", "2.5,12.5", "--tags", "--emit", "kiln,3dtiles,page")
MARKUP = '<img src=x onerror="hacked=1"><script>hacked=2</script>'
PLACES = {"Monaco": ["monaco/monaco-2023.osm.pbf", "monaco/N43E007.hgt"],
          "Andorra la Vella": ["andorra/cut-andorra-la-vella.osm.pbf", "andorra/N42E001.hgt"]}


class Server:
    """`citykiln view` of a folder."""

    def __init__(self, folder, *arguments):
        self.process = subprocess.Popen([PROGRAM, "view", folder, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.lines = []
        for line in self.process.stdout:
            self.lines.append(line)
            if found := re.search(r"http://127\.0\.0\.1:(\d+)/", line):
                self.port, self.url = int(found.group(1)), found.group(0)
                return
        raise AssertionError(self.process.stderr.read())

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.terminate()
        self.process.wait()
        self.process.stdout.close(), self.process.stderr.close()

    def ask(self, path, host=None, method="GET"):
        """Status, body and media type of an answer; the path is sent as it is."""
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=20)
        connection.putrequest(method, path, skip_host=True)
        connection.putheader("Host", host or f"127.0.0.1:{self.port}")
        connection.endheaders()
        answer = connection.getresponse()
        body = answer.read()
        connection.close()
        return answer.status, body, answer.getheader("Content-Type")


class StaticServer:
    """Python's server of a folder."""

    def __init__(self, folder):
        class Quiet(http.server.SimpleHTTPRequestHandler):
            def log_message(self, *_):
                pass
        self.server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Quiet, directory=str(folder)))
        threading.Thread(target=self.server.serve_forever, daemon=True).start()
        self.url = f"http://127.0.0.1:{self.server.server_port}/"

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.server.shutdown()
        self.server.server_close()


class PageTest(ProgramTest):
    def use(self, script, **environment):
        """Runs a script of page/ and prints its notes."""
        if not readers.has_npm("playwright-core") or readers.chromium() is None:
            self.skipTest("chromium or playwright-core is missing")
        done = subprocess.run(["node", "--test", "--test-reporter=tap", readers.HERE / "page" / script], capture_output=True, text=True,
                              cwd=readers.HERE, check=False, timeout=3000, env={**os.environ, **environment})
        print("\n".join(re.findall(r"^\s*(?:# \w+:.*|(?:not )?ok .*)$", done.stdout, re.M)))
        self.assertEqual(done.returncode, 0, done.stdout[-6000:] + done.stderr[-2000:])


class ServesTheTown(PageTest):
    def setUp(self):
        super().setUp()
        self.out = self.compiled_once("--spec", TOWN / "spec.json", "--lods", "12.5", "--emit", "kiln,3dtiles,page")

    def test_serves_every_listed_file(self):
        listed = json.loads((self.out / "files.json").read_text())["files"]
        self.assertLessEqual({"index.html", "page/viewer.js", "page/page.json", "page/names.json", "page/licences.txt", "page/features/0.json"},
                             {file["name"] for file in listed})
        with Server(self.out) as server:
            for file in listed:
                status, body, _ = server.ask("/" + file["name"])
                # the bytes of timing.json are not listed: they differ with every run
                self.assertEqual((status, len(body)), (200, file.get("bytes", len(body))), file["name"])
            status, body, kind = server.ask("/")
            self.assertEqual((status, body, kind), (200, (self.out / "index.html").read_bytes(), "text/html; charset=utf-8"))
            self.assertEqual(server.ask("/page/viewer.js")[2], "application/javascript; charset=utf-8")

    def test_buildings_have_the_recipe_of_a_building(self):
        records = {}
        for path in sorted(self.out.glob("page/features/*.json")):
            records.update(json.loads(path.read_text()))
        self.assertGreater(sum("storeys" in record.get("recipe", {}) for record in records.values()), 100)
        self.assertEqual([id for id, record in records.items() if record.get("recipe", {}).get("surface") == "FloorSlab"], [])

    def test_refuses_what_is_not_listed(self):
        (self.out.parent / "secret.txt").write_text("secret")
        (self.out / "unlisted.txt").write_text("secret")
        try:
            with Server(self.out) as server:
                for path in ("/../secret.txt", "/page/../../secret.txt", "/%2e%2e/secret.txt", "/..%2fsecret.txt", "//../secret.txt",
                             "/page/..%5c..%5csecret.txt"):
                    status, body, _ = server.ask(path)
                    self.assertIn(status, (400, 403, 404), path)
                    self.assertNotIn(b"secret", body)
                for path in ("/unlisted.txt", "/page", "/page/", "/etc/passwd", "//etc/passwd", "/.new/journal", "/%00", "/index.html%00"):
                    self.assertEqual(server.ask(path)[0], 404, path)
        finally:
            (self.out / "unlisted.txt").unlink()

    def test_refuses_other_hosts(self):
        with Server(self.out) as server:
            self.assertEqual(server.ask("/")[0], 200)
            self.assertEqual(server.ask("/", f"localhost:{server.port}")[0], 200)
            for host in ("example.org", f"example.org:{server.port}", "127.0.0.1", f"127.0.0.1:{server.port + 1}", "127.0.0.1.example.org"):
                self.assertEqual(server.ask("/", host)[0], 403, host)

    def test_only_reads(self):
        with Server(self.out) as server:
            for method in ("POST", "PUT", "DELETE"):
                self.assertGreaterEqual(server.ask("/index.html", method=method)[0], 400, method)
            self.assertEqual(server.ask("/index.html", method="HEAD")[0], 200)

    def test_listens_on_this_machine_alone(self):
        with Server(self.out) as server:
            wanted = f"{server.port:04X}"
            rows = [line.split() for name in ("tcp", "tcp6") if Path(f"/proc/net/{name}").exists() for line in Path(f"/proc/net/{name}").read_text().splitlines()[1:]]
            own = [row[1] for row in rows if row[1].endswith(":" + wanted) and row[3] == "0A"]
            self.assertEqual(own, ["0100007F:" + wanted])

    def test_a_port_in_use_is_one_clear_line(self):
        with socket.socket() as taken:
            taken.bind(("127.0.0.1", 0))
            taken.listen()
            done = run("view", self.out, "--port", taken.getsockname()[1])
            self.assertEqual(done.returncode, 1)
            self.assertRegex(done.stderr, r"^citykiln: .*--port.*in use.*\n$")

    def test_check_accepts_the_page(self):
        done = run("check", self.out)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertNotIn("page/", done.stdout)


class AddsToARun(PageTest):
    def test_a_run_without_a_tileset_bakes_one_first(self):
        out = self.compiled("plain", "--spec", TOWN / "spec.json", "--lods", "2.5,12.5")
        before = {file["name"]: file for file in json.loads((out / "files.json").read_text())["files"]}
        self.assertNotIn("3dtiles/tileset.json", before)
        done = run("view", out, "--write-only")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("baking the tileset", done.stdout)
        after = {file["name"]: file for file in json.loads((out / "files.json").read_text())["files"]}
        for name, file in before.items():
            if name != "report.json":
                self.assertEqual(after[name], file)
        whole = self.compiled("whole", "--spec", TOWN / "spec.json", "--lods", "2.5,12.5", "--emit", "kiln,3dtiles,page")
        for path in [*whole.glob("3dtiles/*"), *whole.glob("page/**/*.*"), whole / "index.html"]:
            self.assertEqual((out / path.relative_to(whole)).read_bytes(), path.read_bytes(), path)
        self.assertEqual(report_of(out)["bytes"], sum(f["bytes"] for n, f in after.items() if n not in ("report.json", "findings.json", "timing.json")))
        self.assertEqual(run("check", out).returncode, 0)
        self.assertEqual(run("view", out, "--write-only").stdout, "")

    def test_a_folder_without_a_run_is_one_clear_line(self):
        done = run("view", self.folder)
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, r"^citykiln: .*no finished run.*\n$")

    def test_a_run_without_a_manifest_is_one_clear_line(self):
        out = self.compiled("bare", "--spec", TOWN / "spec.json", "--lods", "12.5", "--emit", "glb")
        done = run("view", out)
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, r"^citykiln: .*without its manifest, scene\.kiln.*\n$")

    def test_a_page_without_a_tileset_is_one_clear_line(self):
        done = run("compile", TOWN / "town.osm", "--emit", "kiln,page", "-o", self.folder / "out")
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, r"^citykiln: --emit: .*3dtiles.*\n$")

    def test_a_plan_with_a_page_is_one_clear_line(self):
        done = run("plan", TOWN / "town.osm", "--emit", "kiln,3dtiles,page", "-o", self.folder / "plan")
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, r"^citykiln: --emit: .*leave page out\n$")


class UsesTheTown(PageTest):
    def setUp(self):
        super().setUp()
        self.out = self.compiled_once("--spec", TOWN / "spec.json", *LEVELS)

    def test_every_function(self):
        with Server(self.out) as server, StaticServer(self.out) as static:
            self.use("town.test.mjs", PAGE_URL=server.url, PAGE_STATIC=static.url)

    def test_a_new_reader(self):
        with Server(self.out) as server:
            self.use("first_use.test.mjs", PAGE_URL=server.url)

    def test_fingers(self):
        with Server(self.out) as server:
            self.use("touch.test.mjs", PAGE_URL=server.url)

    def test_ten_tasks_with_a_phone(self):
        with Server(self.out) as server:
            self.use("phone_tasks.test.mjs", PAGE_URL=server.url)

    def test_the_keyboard_alone(self):
        with Server(self.out) as server:
            self.use("keyboard.test.mjs", PAGE_URL=server.url)

    def test_night(self):
        out = self.compiled_once("--spec", TOWN / "spec.json", *LEVELS, "--time", "2026-12-21T17:30Z", "--lights", "64")
        with Server(out) as server:
            self.use("night.test.mjs", PAGE_URL=server.url)

    def test_markup_of_strangers_stays_text(self):
        text = (TOWN / "town.osm").read_text()
        way = re.search(r'<way id="(\d+)"(?:(?!</way>).)*?<tag k="building" v="[^"]*"/>(?:(?!</way>).)*?</way>', text, re.S)
        escaped = MARKUP.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;").replace('"', "&quot;")
        kept = re.sub(r'<tag k="name"[^>]*/>', "", way.group(0))
        changed = kept.replace("</way>", f'<tag k="name" v="{escaped}"/><tag k="note" v="{escaped}"/></way>')
        (self.folder / "town.osm").write_text(text.replace(way.group(0), changed))
        out = self.compiled("markup", self.folder / "town.osm", "--lods", "12.5", "--tags", "--emit", "kiln,3dtiles,page")
        with Server(out) as server:
            self.use("strangers.test.mjs", PAGE_URL=server.url, PAGE_ID=f"w{way.group(1)}", PAGE_MARKUP=MARKUP)


class PlacesReal(PageTest):
    def expect_a_place(self, name):
        osm, heights = PLACES[name]
        out = self.compiled_once(self.data(osm), "--dem", self.data(heights), "--lods", "0.5,2.5,12.5", "--tags", "--emit", "kiln,3dtiles,page")
        size = sum(path.stat().st_size for path in out.rglob("*") if path.is_file())
        with Server(out) as server:
            self.use("place.test.mjs", PAGE_URL=server.url, PAGE_BYTES=str(size))

    def test_monaco(self):
        self.expect_a_place("Monaco")

    def test_andorra_la_vella(self):
        self.expect_a_place("Andorra la Vella")


class Bundle(unittest.TestCase):
    def test_the_committed_files_are_those_of_the_sources(self):
        """Builds the bundle at the versions of the lock file, and compares every file."""
        import shutil
        import tempfile
        if not shutil.which("npm"):
            self.skipTest("npm is missing")
        with tempfile.TemporaryDirectory() as folder:
            work = Path(folder) / "viewer"
            shutil.copytree(VIEWER, work, ignore=shutil.ignore_patterns("node_modules"))
            installed = subprocess.run(["npm", "ci", "--silent", "--no-audit", "--no-fund", "--prefix", work], capture_output=True, text=True, check=False)
            if installed.returncode != 0:
                self.skipTest(f"npm ci failed: {installed.stderr[-300:]}")
            built = Path(folder) / "files"
            subprocess.run(["node", work / "build.mjs", built], check=True)
            names = sorted(path.name for path in built.iterdir())
            self.assertEqual(names, sorted(path.name for path in (VIEWER.parent / "files").iterdir()))
            for name in names:
                self.assertEqual((built / name).read_bytes(), (VIEWER.parent / "files" / name).read_bytes(), f"{name}: run exporters/page/viewer/build.mjs")

    def test_licences_name_all_that_is_bundled(self):
        text = (VIEWER.parent / "files" / "licences.txt").read_text()
        for name in ("three 0.187.0 (MIT)", "3d-tiles-renderer 0.5.3 (Apache-2.0)", "Draco", "meshopt"):
            self.assertIn(name, text)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], "-v", *sys.argv[1:]])
