#!/usr/bin/env python3
"""Packed tiles hold what plain ones hold, says a reader that is not ours: glTF Transform with Khronos' and meshoptimizer's decoders. What it makes of them
is valid by Khronos' validator."""
import json
import math
import shutil
import struct
import subprocess
import sys
import unittest
from collections import Counter
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "properties"))
from citykiln_program import TOWN, ProgramTest  # noqa: E402

FORMATS = {5121: "B", 5123: "H", 5125: "I", 5126: "f"}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}


class Glb:
    def __init__(self, path):
        data = path.read_bytes()
        size = struct.unpack_from("<I", data, 12)[0]
        self.gltf, self.buffer = json.loads(data[20 : 20 + size]), data[28 + size :]

    def values(self, number):
        accessor = self.gltf["accessors"][number]
        view = self.gltf["bufferViews"][accessor["bufferView"]]
        form = "<" + FORMATS[accessor["componentType"]] * WIDTHS[accessor["type"]]
        start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        stride = view.get("byteStride", struct.calcsize(form))
        return [struct.unpack_from(form, self.buffer, start + i * stride) for i in range(accessor["count"])]

    def triangles(self):
        """Of each material of each mesh: corners on the 2^-10 m grid with their feature, each triangle from its least corner on."""
        found = {}
        for mesh in self.gltf["meshes"]:
            for primitive in mesh["primitives"]:
                attributes = primitive["attributes"]
                # as quantise.h rounds them, y being minus a rounded number
                places = [(math.floor(x * 1024 + 0.5), math.floor(y * 1024 + 0.5), -math.floor(-z * 1024 + 0.5)) for x, y, z in self.values(attributes["POSITION"])]
                features = self.values(attributes["_FEATURE_ID_0"]) if "_FEATURE_ID_0" in attributes else [(0,)] * len(places)
                corners = [place + feature for place, feature in zip(places, features)]
                numbers = [i for i, in self.values(primitive["indices"])]
                name = mesh["name"], self.gltf["materials"][primitive["material"]]["name"]
                found.setdefault(name, Counter()).update(turned([corners[n] for n in numbers[i : i + 3]]) for i in range(0, len(numbers), 3))
        return found


def turned(triangle):
    first = triangle.index(min(triangle))
    return tuple(triangle[first:] + triangle[:first])


class Compressed(ProgramTest):
    LEVELS = ["--lods", "0.1,12.5"]

    def tiles(self, compress):
        out = self.compiled(compress, "--spec", TOWN / "spec.json", *self.LEVELS, "--compress", compress)
        tiles = sorted((out / "glb").glob("*.glb"))
        self.assertGreater(len(tiles), 1)
        return tiles

    def unpacked(self, tiles):
        unpacked = [self.folder / f"{i}.glb" for i in range(len(tiles))]
        done = subprocess.run(["node", HERE / "unpack_glb.mjs", *[path for pair in zip(tiles, unpacked) for path in pair]], capture_output=True, text=True, cwd=HERE, check=False)
        self.assertEqual(done.returncode, 0, done.stderr[-2000:])
        return unpacked

    def expect_the_same(self, compress):
        unpacked = self.unpacked(self.tiles(compress))
        # both levels of two tiles: reading by Python takes its time
        for plain, path in list(zip(self.tiles("none"), unpacked))[:4]:
            self.assertEqual(Glb(path).triangles(), Glb(plain).triangles(), path)
        done = subprocess.run(["node", HERE / "validate_glb.mjs", *unpacked], capture_output=True, text=True, cwd=HERE, check=False)
        self.assertIn(f"{len(unpacked)} files: 0 errors, 0 warnings", done.stdout, done.stdout[-2000:])

    def test_draco_holds_what_plain_tiles_hold(self):
        self.expect_the_same("draco")

    def test_meshopt_holds_what_plain_tiles_hold(self):
        self.expect_the_same("meshopt")


if __name__ == "__main__":
    if not shutil.which("node") or not (HERE / "node_modules" / "@gltf-transform").exists():
        print("glTF Transform is not there (npm ci --prefix tests/interop): skipped")
        sys.exit(77)
    unittest.main(verbosity=2)
