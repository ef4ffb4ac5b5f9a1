#!/usr/bin/env python3
"""OpenUSD itself composes and flattens each variant of a scene, with the triangles, instances, boxes and materials of the .glb files, and
the Omniverse asset validator finds no fault in it."""
import json
import subprocess
import unittest

import readers
from citykiln_program import TOWN, TOWN_MIDDLE
from readers import HERE, ProgramTest

# Findings that are meant, by rule: why.
MEANT = {
    "NormalsWindingsChecker": "leaves have normals of their crown, and skirts of the ground those of its edge",
    "ManifoldChecker": "a city is no solid",
    "IndexedPrimvarChecker": "advice about bytes: vertices of a crate are already unique",
    "WeldChecker": "vertices at edges have two normals or materials",
}
PYTHON = readers.pinned_python("pxr")


class OpenUsd(ProgramTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        keeper = cls("test_the_validator_finds_no_fault")
        keeper.setUp()
        cls.addClassCleanup(keeper.doCleanups)
        cls.out = keeper.compiled_once("--spec", TOWN / "spec.json", *TOWN_MIDDLE, "--lods", "0.5,2.5,12.5", "--emit", "glb,usd",
                                       "--lights", "10")
        facts = keeper.folder / "facts.json"
        done = subprocess.run([PYTHON, HERE / "open_usd.py", cls.out / "usd/scene.usda", facts], capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr[-3000:]
        cls.levels = json.loads(facts.read_text())
        cls.report = json.loads((cls.out / "report.json").read_text())

    def each_tile(self):
        """Level, OpenUSD's facts of a tile, and its row of the report."""
        for number, level in enumerate(self.levels):
            rows = {prim_name(row): row for row in self.report["tiles"] if row["level"] == number}
            self.assertEqual(set(level["tiles"]), set(rows))
            for name, facts in level["tiles"].items():
                with self.subTest(level=level["level"], tile=name):
                    yield level, name, facts, rows[name]

    def test_every_variant_composes_and_flattens(self):
        self.assertEqual([level["level"] for level in self.levels], ["L0", "L1", "L2"])
        for level in self.levels:
            self.assertEqual((level["errors"], level["metres"], level["up"]), ([], 1, "Z"))
        for level, name, facts, _ in self.each_tile():
            self.assertEqual(level["flat"][name], facts["triangles"])

    def test_triangles_and_instances_are_those_of_the_glb(self):
        for _, _, facts, row in self.each_tile():
            self.assertEqual(facts["instances"], row["instances"])
            self.assertEqual(facts["drawn"], readers.triangles_drawn(self.out / row["file"]))

    def test_boxes_are_those_of_the_glb(self):
        for _, _, facts, row in self.each_tile():
            found = readers.facts_of(self.out / row["file"])
            low, high = box_of(found)
            for ours, theirs in zip(low + high, facts["low"] + facts["high"], strict=True):
                # turned boxes of instances are a little larger than their vertices
                self.assertAlmostEqual(ours, theirs, delta=4)

    def test_every_mesh_has_a_material(self):
        for _, _, facts, _ in self.each_tile():
            self.assertEqual(facts["unbound"], [])
            self.assertGreater(len(facts["materials"]), 3)

    def test_the_validator_finds_no_fault(self):
        for level in self.levels:
            found = [issue for issue in level["issues"] if issue[0] not in MEANT]
            self.assertEqual(found, [], level["level"])


def prim_name(row):
    """The name of a tile's prim."""
    return "tile_" + "_".join(f"m{-at}" if at < 0 else str(at) for at in (row["x"], row["y"]))


def box_of(facts):
    """The box of a .glb, z up: corners of all placed meshes."""
    corners = []
    for name, places in facts["places"].items():
        ends = [facts["meshes"][name][end] for end in ("low", "high")]
        for place in places:
            for number in range(8):
                at = [ends[number >> i & 1][i] for i in range(3)]
                x, y, z = (sum(place[i][k] * at[k] for k in range(3)) + place[i][3] for i in range(3))
                corners.append([x, -z, y])
    return tuple([f(corner[i] for corner in corners) for i in range(3)] for f in (min, max))


if __name__ == "__main__":
    readers.skip_unless(PYTHON is not None, "usd-core is not installed (tests/interop/requirements.txt)")
    unittest.main(verbosity=2)
