#!/usr/bin/env python3
"""Wires hang between the supports of a line: over the borders of tiles, up to the sides of the extent, in one tile each."""
import json
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "exporters" / "kiln"))

from citykiln_program import DATA, ProgramTest, bytes_of_outputs, report_of, run
from manifest_page_test import Manifest

LON, LAT = 10.0, 50.0
LON_M, LAT_M = 71695.7, 111229.0  # metres of a degree there

# a line from west to east: towers 200 m apart, the last ones outside of the map, and a road below it
TOWERS = [-500, -300, -100, 100, 300, 500]


def line_map():
    nodes = [(x, 20 + x / 20, {"power": "tower"}) for x in TOWERS] + [(30, -300, {}), (30, 300, {})]
    ways = [(range(1, len(TOWERS) + 1), {"power": "line", "cables": "6", "voltage": "220000", "name": "North line"}),
            ((len(nodes) - 1, len(nodes)), {"highway": "tertiary"})]

    def tagged(tags):
        return "".join(f'<tag k="{key}" v="{value}"/>' for key, value in tags.items())

    box = (LON - 380 / LON_M, LAT - 250 / LAT_M, LON + 380 / LON_M, LAT + 250 / LAT_M)
    lines = ['<osm version="0.6"><bounds minlon="{:.7f}" minlat="{:.7f}" maxlon="{:.7f}" maxlat="{:.7f}"/>'.format(*box)]
    lines += [f'<node id="{i + 1}" version="1" lon="{LON + x / LON_M:.7f}" lat="{LAT + y / LAT_M:.7f}">{tagged(tags)}</node>'
              for i, (x, y, tags) in enumerate(nodes)]
    lines += [f'<way id="{i + 1}" version="1">{"".join(f"<nd ref=@{n}@/>".replace("@", chr(34)) for n in refs)}{tagged(tags)}</way>'
              for i, (refs, tags) in enumerate(ways)]
    return "\n".join([*lines, "</osm>"])


def spans_of(out):
    """The spans of all tiles, by their number along the way."""
    spans = {}
    for chunk in Manifest((out / "scene.kiln").read_bytes()).chunks.values():
        for (_, way, number), above, wires in chunk.wire_spans:
            assert (way, number) not in spans, "a span is in one tile"
            spans[way, number] = (above, wires)
    return spans


def row_of(checked, claim):
    return next(line for line in checked.stdout.splitlines() if claim in line)


class Wires(ProgramTest):
    def compiled_line(self, name, *arguments):
        path = self.folder / "line.osm"
        path.write_text(line_map())
        return self.compiled(name, path, "--lods", "0.1,2,50", *arguments)

    def test_every_span_has_its_wires(self):
        spans = spans_of(self.compiled_line("whole", "--tile", "128"))
        self.assertEqual(sorted(number for _, number in spans), [1, 2, 3, 4, 5])
        for above, wires in spans.values():
            self.assertEqual([kind for _, _, kind, _, _ in wires], [0] * 6 + [1])
            self.assertTrue(20 < above < 50, above)
        for number in range(1, 5):
            ends, begins = ([wire[4 - side] for wire in spans[1, number + side][1]] for side in (0, 1))
            self.assertEqual(ends, begins, "wires of both sides meet at the tower")

    def test_wires_end_at_the_extent(self):
        out = self.compiled_line("cut", "--emit", "kiln,glb")
        west, south, east, north = report_of(out)["region_m"]
        self.assertLess(east, 500)
        self.assertEqual(report_of(out)["counts"]["things"], sum(west <= x <= east for x in TOWERS))
        done = run("check", out)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertRegex(row_of(done, "no wire hangs lower"), r"\d")

    def test_the_size_of_tiles_does_not_change_a_wire(self):
        self.assertEqual(spans_of(self.compiled_line("large", "--tile", "1024")), spans_of(self.compiled_line("small", "--tile", "128")))

    def test_bake_makes_the_same_bytes(self):
        out, baked = self.compiled_line("compiled"), self.folder / "baked"
        done = run("bake", out / "scene.kiln", "--lods", "0.1,2,50", "-o", baked)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(bytes_of_outputs(out), bytes_of_outputs(baked))

    def test_wires_have_the_class_and_name_of_their_line(self):
        tiles = b"".join(path.read_bytes() for path in (self.compiled_line("named") / "glb").glob("*_L0.glb"))
        self.assertIn(b"PowerLine", tiles)
        self.assertIn(b"North line", tiles)


class WiresReal(ProgramTest):
    @unittest.skipUnless((DATA / "liechtenstein").exists(), "needs real data")
    def test_a_line_in_liechtenstein(self):
        data = DATA / "liechtenstein"
        out = self.compiled("pylons", data / "liechtenstein-2015.osm.pbf", "--dem", data / "N47E009.hgt.zip", "--bbox",
                            "9.485,47.172,9.509,47.190", "--emit", "kiln")
        account = json.loads((out / "report.json").read_text())["ledger"]["wires/span"]
        spans = spans_of(out)
        self.assertGreaterEqual(len(spans), 15)
        self.assertEqual(account["out"], len(spans))
        for _, wires in spans.values():
            for sag, _, _, begin, end in wires:
                length = ((end[0] - begin[0]) ** 2 + (end[1] - begin[1]) ** 2) ** 0.5
                self.assertTrue(0.003 * length <= sag <= 0.05 * length, (sag, length))


if __name__ == "__main__":
    unittest.main()
