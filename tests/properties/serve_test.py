#!/usr/bin/env python3
"""`serve` and `view` answer with the bytes that `bake` writes, baked when they are asked for: to many clients at once, to clients that go
away, in parts and by tag. They write nothing, and answer no request for what is not theirs."""
import gzip
import http.client
import json
import random
import re
import socket
import subprocess
import threading
import unittest
from pathlib import Path

from citykiln_program import IS_FULL, PROGRAM, TOWN, TOWN_MIDDLE, ProgramTest, run

ARGUMENTS = ["--spec", TOWN / "spec.json", *TOWN_MIDDLE, "--tile", "128", "--lods", "2.5,12.5", "--emit", "kiln,glb,3dtiles"]
CLIENTS = 16


class Server:
    """A server of the program, and requests to it."""

    def __init__(self, verb, path, *arguments):
        self.process = subprocess.Popen([PROGRAM, verb, str(path), "--port", "0", *arguments], stdout=subprocess.PIPE, text=True)
        self.port = int(re.search(r":(\d+)/", self.process.stdout.readline())[1])

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.terminate()
        self.process.wait()
        self.process.stdout.close()

    def ask(self, path, method="GET", connection=None, **headers):
        """Returns status, headers and body."""
        own = connection or http.client.HTTPConnection("127.0.0.1", self.port, timeout=300)
        own.request(method, path, headers={name.replace("_", "-"): value for name, value in headers.items()})
        answer = own.getresponse()
        body = answer.read()
        if not connection:
            own.close()
        return answer.status, answer, body

    def memory_kb(self):
        status = Path(f"/proc/{self.process.pid}/status").read_text()
        return int(re.search(r"VmRSS:\s+(\d+)", status)[1])


def files_below(folder):
    return {str(path.relative_to(folder)): path.stat().st_mtime_ns for path in folder.rglob("*")}


class Serve(ProgramTest):
    def run_folder(self):
        return self.compiled_once(*ARGUMENTS)

    def manifest_alone(self):
        """A manifest in a folder of its own."""
        path = self.folder / "alone" / "scene.kiln"
        path.parent.mkdir()
        path.write_bytes((self.run_folder() / "scene.kiln").read_bytes())
        return path

    def tileset(self):
        return {f"/3dtiles/{path.name}": path.read_bytes() for path in (self.run_folder() / "3dtiles").iterdir()}

    def test_every_file_of_the_tileset_is_served_and_nothing_is_written(self):
        manifest, files = self.manifest_alone(), self.tileset()
        before = files_below(manifest.parent)
        with Server("serve", manifest, "--lods", "2.5,12.5") as server:
            for name, written in files.items():
                status, answer, body = server.ask(name)
                self.assertEqual((status, body == written), (200, True), name)
                self.assertEqual(answer.headers["Content-Type"].split(";")[0],
                                 "application/json" if name.endswith(".json") else "model/gltf-binary")
        self.assertEqual(files_below(manifest.parent), before)

    def test_random_requests_of_many_clients_get_the_bytes_of_bake(self):
        files, wrong = self.tileset(), []
        names = sorted(files)
        requests = (10000 if IS_FULL else 400) // 2 // CLIENTS  # in each of two rounds
        # a cache that holds a part of the tileset
        with Server("serve", self.manifest_alone(), "--lods", "2.5,12.5", "--cache", "1MB") as server:
            def client(number):
                draw, connection = random.Random(number), http.client.HTTPConnection("127.0.0.1", server.port, timeout=300)
                for _ in range(requests):
                    name = draw.choice(names)
                    status, _, body = server.ask(name, connection=connection)
                    if status != 200 or body != files[name]:
                        wrong.append((name, status, len(body)))
                connection.close()

            def all_clients():
                threads = [threading.Thread(target=client, args=(number,)) for number in range(CLIENTS)]
                for thread in threads:
                    thread.start()
                for thread in threads:
                    thread.join()

            all_clients()
            first_kb = server.memory_kb()
            all_clients()
            self.assertEqual(wrong, [])
            self.assertLess(server.memory_kb(), 1.3 * first_kb)

    def test_clients_that_go_away_harm_no_one(self):
        files = self.tileset()
        names = sorted(name for name in files if name.endswith(".glb"))
        with Server("serve", self.manifest_alone(), "--lods", "2.5,12.5", "--threads", "1") as server:
            for name in names:
                with socket.create_connection(("127.0.0.1", server.port)) as gone:
                    gone.sendall(f"GET {name} HTTP/1.1\r\nHost: 127.0.0.1:{server.port}\r\n\r\n".encode())
            for name in names[:3]:
                self.assertEqual(server.ask(name)[2], files[name])

    def test_tags_parts_and_heads(self):
        files = self.tileset()
        name = next(name for name in sorted(files) if name.endswith("_L1.glb"))
        with Server("serve", self.manifest_alone(), "--lods", "2.5,12.5") as server:
            tag = server.ask(name)[1].headers["ETag"]
            self.assertEqual(server.ask(name, If_None_Match=tag)[::2], (304, b""))
            self.assertEqual(server.ask(name, If_None_Match='"another"')[0], 200)
            status, _, body = server.ask(name, Range="bytes=4-19")
            self.assertEqual((status, body), (206, files[name][4:20]))
            status, answer, body = server.ask(name, method="HEAD")
            self.assertEqual((status, int(answer.headers["Content-Length"]), body), (200, len(files[name]), b""))
            _, answer, body = server.ask("/3dtiles/tileset.json", Accept_Encoding="gzip")
            self.assertEqual(answer.headers["Content-Encoding"], "gzip")
            self.assertEqual(gzip.decompress(body), files["/3dtiles/tileset.json"])
        # other levels are other bytes
        with Server("serve", self.manifest_alone_again(), "--lods", "2.5,20") as server:
            self.assertNotEqual(server.ask(name)[1].headers["ETag"], tag)

    def manifest_alone_again(self):
        return self.folder / "alone" / "scene.kiln"

    def test_only_what_is_there_is_answered(self):
        with Server("serve", self.manifest_alone(), "--lods", "2.5,12.5") as server:
            for path in ("/", "/index.html", "/scene.kiln", "/3dtiles", "/3dtiles/", "/3dtiles/9_9_L0.glb", "/page/page.json", "/%00", "//"):
                self.assertEqual(server.ask(path)[0], 404, path)
            for path in ("/../scene.kiln", "/3dtiles/../../secret", "/3dtiles/%2e%2e/scene.kiln"):
                self.assertEqual(server.ask(path)[0], 403, path)
            for method in ("POST", "PUT", "DELETE"):
                self.assertIn(server.ask("/3dtiles/tileset.json", method=method)[0], (400, 404, 405), method)
            self.assertEqual(server.ask("/3dtiles/tileset.json", Host="example.org")[0], 403)
            self.assertNotIn("Access-Control-Allow-Origin", server.ask("/3dtiles/tileset.json")[1].headers)
        with Server("serve", self.manifest_alone_again(), "--lods", "2.5,12.5", "--cors", "*") as server:
            self.assertEqual(server.ask("/3dtiles/tileset.json")[1].headers["Access-Control-Allow-Origin"], "*")

    def test_view_serves_the_page_of_a_manifest(self):
        with Server("view", self.manifest_alone(), "--lods", "2.5,12.5") as server:
            self.assertIn(b"<canvas", server.ask("/")[2])
            page = json.loads(server.ask("/page/page.json")[2])
            for sky in page["skies"][:2]:
                self.assertIn("radiance", json.loads(server.ask("/" + sky["file"])[2]))
            records = [json.loads(server.ask(f"/page/features/{i}.json")[2]) for i in range(page["feature_files"])]
            self.assertGreater(sum(map(len, records)), 20)
            self.assertEqual(json.loads(server.ask("/findings.json")[2])["features"], [])
            self.assertEqual(server.ask("/3dtiles/tileset.json")[2], self.tileset()["/3dtiles/tileset.json"])

    def test_a_run_is_served_from_its_files_with_the_page(self):
        with Server("view", self.run_folder()) as server:
            for name, written in self.tileset().items():
                self.assertEqual(server.ask(name)[2], written, name)
            self.assertEqual(server.ask("/findings.json")[2], (self.run_folder() / "findings.json").read_bytes())
            self.assertEqual(server.ask("/page/page.json")[0], 200)

    def test_a_run_without_a_tileset_has_the_levels_of_the_run(self):
        out = self.compiled("glb", *ARGUMENTS[:-1], "kiln,glb")
        with Server("serve", out) as server:
            for name, written in self.tileset().items():
                self.assertEqual(server.ask(name)[2], written, name)

    def test_layers_of_a_run_and_of_its_manifest_are_those_of_bake(self):
        without = self.compiled("without", *ARGUMENTS, "--layers=-plants,-things")
        whole = self.tileset()
        for shown in (self.run_folder(), self.manifest_alone()):
            with Server("serve", shown, "--lods", "2.5,12.5", "--layers=-plants,-things") as server:
                for path in (without / "3dtiles").glob("*_L1.glb"):
                    name = f"/3dtiles/{path.name}"
                    self.assertEqual(server.ask(name)[2], path.read_bytes(), name)
                    self.assertNotEqual(server.ask(name)[2], whole[name], name)

    def test_mistakes_are_one_line(self):
        cases = (((), "nothing to show is given"), (("nosuch",), "there is no such file or folder"),
                 ((TOWN / "town.osm",), "is a map; compile it first"), ((TOWN / "spec.json",), "expected a manifest (.kiln)"),
                 ((self.run_folder(), "--port", "70000"), "expected a port from 0 to 65535"),
                 ((self.run_folder(), "--listen", "192.0.2.1"), "cannot listen at 192.0.2.1"),
                 ((self.run_folder(), "--cache", "lots"), "--cache"))
        for arguments, words in cases:
            done = run("serve", *arguments)
            self.assertEqual(done.returncode, 1, arguments)
            self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)
            self.assertIn(words, done.stderr)


if __name__ == "__main__":
    unittest.main()
