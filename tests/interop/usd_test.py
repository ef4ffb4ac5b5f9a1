#!/usr/bin/env python3
"""Tests that tinyusdz and three's USDLoader read every level layer, with the meshes, triangles and bounds that tests/properties/usd.py
finds. Neither composes payloads or point instancers here: that is tested by tests/properties/usd_test.py."""
import json
import subprocess
import sys
import unittest

from readers import HERE, TOWN, ProgramTest, has_npm

from usd import Text, read_layer  # beside citykiln_program.py

NEAR = 1e-4


def below(spec, kind, path=""):
    """Path and Spec of every prim of a kind."""
    for name, child in spec.children.items():
        if child.kind == kind:
            yield f"{path}/{name}", child
        yield from below(child, kind, f"{path}/{name}")


def bounds(points):
    return [f(axis) for f in (min, max) for axis in zip(*points)]


@unittest.skipUnless(has_npm("tinyusdz") and has_npm("three"), "tinyusdz and three are not installed: npm ci in tests/interop")
class ReadersOfUsd(ProgramTest):
    def setUp(self):
        super().setUp()
        out = self.compiled("town", "--spec", TOWN / "spec.json", "--lods", "2.5,12.5", "--emit", "usd")
        self.layers = sorted((out / "usd/tiles").glob("*.usdc"))
        self.assertEqual(len(self.layers), 8)
        facts = self.folder / "facts.json"
        command = ["node", HERE / "read_usd.mjs", facts, self.folder, *self.layers]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.facts = json.loads(facts.read_text())
        self.read = [read_layer(path) for path in self.layers]
        self.own = [dict(below(layer, "Mesh")) for layer in self.read]

    def assertNear(self, some, others, where):
        for one, other in zip(some, others, strict=True):
            self.assertLessEqual(abs(one - other), NEAR * max(1, abs(other)), where)

    def test_both_readers_have_every_mesh(self):
        self.three_has_every_mesh()
        self.tinyusdz_has_every_mesh()

    def three_has_every_mesh(self):
        for own, facts in zip(self.own, self.facts):
            self.assertGreater(len(own), 20)
            self.assertEqual([m["path"] for m in facts["three"]], list(own))
            for mesh in facts["three"]:
                spec = own[mesh["path"]].attributes
                self.assertEqual(mesh["triangles"], len(spec["faceVertexCounts"]), mesh["path"])
                self.assertNear(mesh["low"] + mesh["high"], bounds(spec["points"]), mesh["path"])

    def has_instancers(self, read, own):
        """Both have equal instances and equal tables of features."""
        instancers = dict(below(own, "PointInstancer"))
        self.assertGreater(len(instancers), 0)
        for path, instancer in below(read, "PointInstancer"):
            want = instancers.pop(path)
            self.assertEqual(instancer.targets["prototypes"], want.targets["prototypes"])
            for name in ("protoIndices", "ids", "primvars:feature"):
                self.assertEqual(instancer.attributes[name], want.attributes[name], f"{path}.{name}")
            for name in ("positions", "orientations", "scales"):
                for one, other in zip(instancer.attributes[name], want.attributes[name], strict=True):
                    self.assertNear(one, other, f"{path}.{name}")
        self.assertEqual(instancers, {})
        tables = [layer.children["tile"].children["features"].attributes for layer in (read, own)]
        for name in ("osm:id", "osm:type", "osm:class"):
            self.assertEqual(tables[0][name], tables[1][name])

    def tinyusdz_has_every_mesh(self):
        for layer, own, facts in zip(self.read, self.own, self.facts):
            with open(facts["tinyusdz"], encoding="utf-8") as text:
                printed = Text(text.read()).layer()
            self.has_instancers(printed, layer)
            read = dict(below(printed, "Mesh"))
            self.assertEqual(set(read), set(own))
            for path, mesh in read.items():
                want = own[path].attributes
                for name in ("faceVertexCounts", "faceVertexIndices", "primvars:feature"):
                    self.assertEqual(mesh.attributes.get(name), want.get(name), f"{path}.{name}")
                self.assertNear(bounds(mesh.attributes["points"]), bounds(want["points"]), path)


if __name__ == "__main__":
    if not (has_npm("tinyusdz") and has_npm("three")):
        print("skipped: tinyusdz and three are not installed: npm ci in tests/interop")
        sys.exit(77)
    sys.exit(unittest.main(argv=[sys.argv[0], "-v"]))
