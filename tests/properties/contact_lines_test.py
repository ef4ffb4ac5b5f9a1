#!/usr/bin/env python3
"""Railings and masts that are assumed: in any order of the map, in regions and by bake the same bytes, none with --assume none."""
import random
import unittest
from pathlib import Path

from citykiln_program import ProgramTest, bytes_of_outputs, report_of, run
from regions_real_test import compiled_apart
from shuffled import shuffle

LON, LAT = 10.0, 50.0
LON_M, LAT_M = 71695.7, 111229.0  # metres of a degree there


def made_map(seed):
    """Two tracks in ways of random lengths with a branch, a street across them, and a square above a retaining wall."""
    draw = random.Random(seed)
    nodes, ways = [], []

    def node(x, y):
        nodes.append((LON + x / LON_M, LAT + y / LAT_M))
        return len(nodes)

    def way(places, **tags):
        ways.append(([place if isinstance(place, int) else node(*place) for place in places], tags))

    electric = {"railway": "rail", "electrified": "contact_line"}
    for y in (0, 4.5):
        x, last = -900, node(-900, y)
        while x < 900:
            x += draw.uniform(60, 500)
            end = node(x, y)
            way([last, end], **electric)
            last = end
        if y:
            way([last, (x + 200, 30)], **electric)
    way([(-20, -300), (-20, 0.0), (-20, 300)], highway="residential")
    way([(100, 60), (100, 80), (220, 80), (220, 60)], barrier="retaining_wall", height="3")
    way([(90, 40), (230, 40), (230, 79), (90, 79), (90, 40)], highway="pedestrian", area="yes")
    box = (LON - 850 / LON_M, LAT - 320 / LAT_M, LON + 850 / LON_M, LAT + 320 / LAT_M)
    lines = ['<osm version="0.6"><bounds minlon="{:.7f}" minlat="{:.7f}" maxlon="{:.7f}" maxlat="{:.7f}"/>'.format(*box)]
    lines += [f'<node id="{i + 1}" version="1" lon="{lon:.7f}" lat="{lat:.7f}"/>' for i, (lon, lat) in enumerate(nodes)]
    for i, (refs, tags) in enumerate(ways):
        inner = "".join(f'<nd ref="{ref}"/>' for ref in refs) + "".join(f'<tag k="{k}" v="{v}"/>' for k, v in tags.items())
        lines.append(f'<way id="{i + 1}" version="1">{inner}</way>')
    return "\n".join([*lines, "</osm>"])


class ContactLines(ProgramTest):
    def map_path(self, seed=1):
        path = self.folder / f"map{seed}.osm"
        path.write_text(made_map(seed))
        return path

    def test_any_order_has_the_same_bytes(self):
        for seed in range(3):
            # the manifest names the map
            path = self.map_path(seed)
            other = self.folder / f"shuffled{seed}" / path.name
            other.parent.mkdir()
            shuffle(path, other, seed)
            runs = [self.compiled(f"{seed}{name}", source, "--lods", "0.1,0.5", "--tile", "256", "--threads", threads)
                    for name, source, threads in (("one", path, 1), ("other", other, 3))]
            self.assertEqual(*map(bytes_of_outputs, runs))
            self.assertGreater(report_of(runs[0])["assumed"]["masts"], 1)
            self.assertGreater(report_of(runs[0])["ledger"]["things/contact mast"]["out"], 30)

    def test_regions_have_the_bytes_of_one_run(self):
        arguments = ["--lods", "0.1", "--tile", "256"]
        path = self.map_path()
        whole = self.compiled("whole", path, *arguments)
        apart = compiled_apart(self.folder / "apart", [path], arguments, "512") / "out"
        tiles = {name: data for name, data in bytes_of_outputs(apart).items() if name.endswith(".glb")}
        self.assertEqual(tiles, {name: data for name, data in bytes_of_outputs(whole).items() if name.endswith(".glb")})
        self.assertEqual(report_of(apart)["assumed"], report_of(whole)["assumed"])

    def test_check_and_bake_agree(self):
        out, baked = self.compiled("out", self.map_path(), "--lods", "0.1,0.5"), self.folder / "baked"
        self.assertEqual(run("bake", out / "scene.kiln", "--lods", "0.1,0.5", "-o", baked).returncode, 0)
        self.assertEqual(bytes_of_outputs(out), bytes_of_outputs(baked))
        checked = run("check", out)
        for claim in ("no assumed mast", "no wire hangs lower"):
            row = next(line for line in checked.stdout.splitlines() if claim in line)
            self.assertTrue(row.startswith("holds"), row)
            self.assertNotIn("by 0 tests", row)

    def test_they_are_switched(self):
        for assumed, masts in (("none", False), ("masts", True), ("railings", False)):
            out = self.compiled(assumed, self.map_path(), "--lods", "0.1", "--assume", assumed)
            self.assertEqual(report_of(out)["counts"]["things"] > 0, masts)
            self.assertEqual(b"contact_mast" in b"".join(p.read_bytes() for p in Path(out / "glb").glob("*")), masts)


if __name__ == "__main__":
    unittest.main()
