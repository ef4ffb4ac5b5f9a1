#!/usr/bin/env python3
"""tileset.3tz is the tileset as one file: each file of 3dtiles/ with its bytes, stored, and found by binary search in the index of the 3D
Tiles Archive Format 1.3. It is the same with any threads, with or without 3dtiles/, and after a run that was killed."""
import hashlib
import signal
import struct
import subprocess
import time
import unittest
import zipfile

from citykiln_program import PROGRAM, ROOT, TOWN, TOWN_MIDDLE, ProgramTest, run, sha256

ARGUMENTS = ["--spec", TOWN / "spec.json", *TOWN_MIDDLE, "--tile", "128", "--lods", "2.5,12.5"]
INDEX = "@3dtilesIndex1@"


class Index:
    def __init__(self, data):
        self.places = [struct.unpack_from("<QQQ", data, at) for at in range(0, len(data), 24)]

    def offset(self, name):
        """Where the local header of a file is, by binary search."""
        wanted, low, high = struct.unpack("<QQ", hashlib.md5(name.encode()).digest()), 0, len(self.places)
        while low < high:
            middle = (low + high) // 2
            if self.places[middle][:2] < wanted:
                low = middle + 1
            else:
                high = middle
        assert low < len(self.places) and self.places[low][:2] == wanted, name
        return self.places[low][2]


def stored_at(data, offset):
    """The name and the bytes of the file whose local header is there."""
    magic, _, flags, method, _, _, crc, packed, size, name, extra = struct.unpack_from("<IHHHHHIIIHH", data, offset)
    assert (magic, flags, method, extra) == (0x04034b50, 0, 0, 0) and packed == size
    at = offset + 30 + name
    assert zipfile.crc32(data[at:at + size]) == crc
    return data[offset + 30:at].decode(), data[at:at + size]


class TilesetArchive(ProgramTest):
    def both(self):
        return self.compiled_once(*ARGUMENTS, "--emit", "kiln,3dtiles,3tz")

    def test_it_has_the_files_of_the_folder_and_finds_each(self):
        out = self.both()
        files = {path.name: path.read_bytes() for path in (out / "3dtiles").iterdir()}
        self.assertIn("tileset.json", files)
        self.assertGreater(len(files), 5)
        data = (out / "tileset.3tz").read_bytes()
        with zipfile.ZipFile(out / "tileset.3tz") as archive:
            self.assertIsNone(archive.testzip())
            names = archive.namelist()
            self.assertEqual(names[-1], INDEX)
            self.assertEqual({name: archive.read(name) for name in names[:-1]}, files)
            self.assertEqual(len(names), len(files) + 1)
            index = Index(archive.read(INDEX))
        self.assertEqual(len(index.places), len(files))
        self.assertEqual(index.places, sorted(index.places))
        for name, content in files.items():
            self.assertEqual(stored_at(data, index.offset(name)), (name, content))

    def test_it_is_the_same_without_the_folder_and_with_one_thread(self):
        out = self.compiled("one", *ARGUMENTS, "--emit", "kiln,3tz", "--threads", 1)
        self.assertFalse((out / "3dtiles").exists())
        self.assertEqual(sha256(out / "tileset.3tz"), sha256(self.both() / "tileset.3tz"))
        done = run("check", out)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_a_run_that_was_killed_is_made_again(self):
        out = self.folder / "killed"
        arguments = [PROGRAM, "compile", *map(str, ARGUMENTS), "--emit", "kiln,3tz", "-o", str(out)]
        with subprocess.Popen(arguments, cwd=ROOT, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as process:
            part = out / ".new" / "tileset.3tz.part"
            while process.poll() is None and not (part.exists() and part.stat().st_size > 0):
                time.sleep(0.002)
            process.send_signal(signal.SIGKILL)
        self.assertFalse((out / "tileset.3tz").exists())
        done = subprocess.run(arguments, cwd=ROOT, capture_output=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(sha256(out / "tileset.3tz"), sha256(self.both() / "tileset.3tz"))
        self.assertFalse((out / ".new").exists())

    def test_a_plan_refuses_it_and_the_page_needs_the_folder(self):
        done = run("plan", TOWN / "town.osm", "--emit", "kiln,3tz", "-o", self.folder / "plan")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("3dtiles instead of 3tz", done.stderr)
        done = run("compile", TOWN / "town.osm", "--emit", "kiln,3tz,page", "-o", self.folder / "page")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("give both, such as 3dtiles,page", done.stderr)


if __name__ == "__main__":
    unittest.main()
