#!/usr/bin/env python3
"""Bad tags, through the whole program: each unreadable value is diagnosed once with its way, readable values are used, and tiles are
written."""
import json
import re
import unittest
from xml.sax.saxutils import quoteattr

from citykiln_program import ProgramTest, report_of, run

# Tags of a residential street, how many of their values are unreadable, and the street's width.
RESIDENTIAL_M = 5.5
WAYS = [
    ({"width": "wide"}, 1, RESIDENTIAL_M),
    ({"width": "3,5m"}, 0, 3.5),
    ({"width": "12'6\""}, 0, 3.81),
    ({"width": "40 ft"}, 0, 12.192),
    ({"width": "7;8"}, 0, 7),
    ({"width": "0"}, 1, RESIDENTIAL_M),
    ({"width": "-4"}, 1, RESIDENTIAL_M),
    ({"width": "1e300"}, 1, RESIDENTIAL_M),
    ({"width": "1" + "0" * 400}, 1, RESIDENTIAL_M),
    ({"width": "nan"}, 1, RESIDENTIAL_M),
    ({"width": "inf"}, 1, RESIDENTIAL_M),
    ({"width": "五米"}, 1, RESIDENTIAL_M),
    ({"width": "６"}, 1, RESIDENTIAL_M),
    ({"width": "\u202e7 m"}, 1, RESIDENTIAL_M),
    ({"width": ""}, 0, RESIDENTIAL_M),
    ({"width": "broad", "est_width": "8"}, 1, 8),
    ({"lanes": "-3"}, 1, RESIDENTIAL_M),
    ({"lanes": "1000"}, 1, RESIDENTIAL_M),
    ({"lanes": "99999999999999999999"}, 1, RESIDENTIAL_M),
    ({"lanes": "2;3"}, 0, RESIDENTIAL_M),
    ({"lanes": "many"}, 1, RESIDENTIAL_M),
    ({"lanes": ""}, 0, RESIDENTIAL_M),
    ({"lanes": "4", "lanes:forward": "x"}, 1, 11),
    ({"lanes": "3", "width": "wide"}, 1, 8.25),
    ({"maxspeed": "junk"}, 0, RESIDENTIAL_M),
    ({"maxspeed": "-1e999 mph"}, 0, RESIDENTIAL_M),
    ({"layer": "999"}, 1, RESIDENTIAL_M),
    ({"layer": "-"}, 1, RESIDENTIAL_M),
    ({"layer": "first floor"}, 1, RESIDENTIAL_M),
    ({"layer": "1;2"}, 0, RESIDENTIAL_M),
    ({"oneway": "maybe"}, 1, RESIDENTIAL_M),
    ({"oneway": ""}, 0, RESIDENTIAL_M),
    ({"oneway": "yes", "lanes": "2", "turn:lanes": "left|through|right|right|right"}, 1, 5.5),
    ({"oneway": "yes", "lanes": "2", "turn:lanes": "left|sideways"}, 1, 5.5),
    ({"oneway": "yes", "lanes": "2", "turn:lanes": "|" * 1000 + "left"}, 1, 5.5),
    ({"oneway": "yes", "lanes": "2", "turn:lanes": "through|" + "left;" * 200}, 0, 5.5),
    ({"oneway": "yes", "lanes": "2", "turn:lanes": "through|" + "x" * 1000}, 1, 5.5),
    ({"oneway": "yes", "lanes": "2", "width:lanes": "3|nan"}, 1, 5.75),
    ({"oneway": "yes", "lanes": "2", "width:lanes": "3,5|-1"}, 1, 6.25),
    ({"oneway": "yes", "lanes": "2", "placement": "junk"}, 1, 5.5),
    ({"oneway": "yes", "lanes": "2", "placement": "right_of:"}, 1, 5.5),
    ({"oneway": "yes", "lanes": "2", "placement": "right_of:7"}, 1, 5.5),
    ({"oneway": "yes", "lanes": "2", "placement": ":::"}, 1, 5.5),
    ({"oneway": "yes", "lanes": "2", "placement": "transition"}, 0, 5.5),
    ({"cycleway": "banana"}, 0, RESIDENTIAL_M),
    ({"cycleway:left": "lane", "cycleway:left:width": "slim"}, 1, 7),
    ({"cycleway:both": "lane", "cycleway:both:width": "slim"}, 1, 8.5),
    ({"cycleway:both": "lane", "cycleway:both:buffer": "thick"}, 1, 9.5),
    ({"sidewalk": "both", "sidewalk:both:width": "-2"}, 1, RESIDENTIAL_M),
    ({"sidewalk": "sideways", "parking:both": "everywhere", "shoulder": "☃"}, 0, RESIDENTIAL_M),
    ({"parking:both": "lane", "parking:both:width": "1e5"}, 1, 9.5),
    ({"surface": "\t\n", "name": "'\"<&>\\"}, 0, RESIDENTIAL_M),
    ({"crossing": "x", "junction": "knot", "bridge": "", "tunnel": "0"}, 0, RESIDENTIAL_M),
]
FIRST_WAY = 1001


def tag_xml(key, value):
    return f"<tag k={quoteattr(key)} v={quoteattr(value)}/>"


def map_of(ways):
    """Parallel streets of 60 m, 20 m apart, near 10° east, 48° north."""
    nodes, lines = [], []
    for i, (tags, _, _) in enumerate(ways):
        lat = 48 + i * 0.00018
        for side in (0, 1):
            nodes.append(f'<node id="{2 * i + side + 1}" version="1" lat="{lat:.7f}" lon="{10 + side * 0.0008:.7f}"/>')
        text = "".join(tag_xml(k, v) for k, v in {"highway": "residential", **tags}.items())
        lines.append(f'<way id="{FIRST_WAY + i}" version="1"><nd ref="{2 * i + 1}"/><nd ref="{2 * i + 2}"/>{text}</way>')
    return '<?xml version="1.0" encoding="UTF-8"?>\n<osm version="0.6">\n' + "\n".join(nodes + lines) + "\n</osm>\n"


class BadTags(ProgramTest):
    def written(self, ways, name="bad.osm"):
        path = self.folder / name
        path.write_text(map_of(ways), encoding="utf-8")
        return path

    def diagnosed(self, out):
        return report_of(out)["diagnoses"].get("BadTagValue", {"count": 0, "objects": []})

    def test_each_unreadable_value_is_diagnosed_once_with_its_way(self):
        # the report names at most twenty ways for each code
        for begin in range(0, len(WAYS), 20):
            ways = WAYS[begin : begin + 20]
            out = self.compiled(f"out{begin}", self.written(ways), "--lods", "2.5")
            found = self.diagnosed(out)
            bad = [f"w{FIRST_WAY + i}" for i, (_, count, _) in enumerate(ways) if count]
            self.assertEqual(sorted(found["objects"]), bad)
            self.assertEqual(found["count"], sum(count for _, count, _ in ways))

    def test_readable_values_are_used(self):
        layer = self.folder / "roads.geojson"
        done = run("inspect", self.written(WAYS), "--layer", "roads", "--geojson", layer)
        self.assertEqual(done.returncode, 0, done.stderr)
        widths = {int(re.search(r"\d+", feature["properties"]["id"])[0]): feature["properties"]["width_m"]
                  for feature in json.loads(layer.read_text())["features"]}
        for i, (tags, _, width_m) in enumerate(WAYS):
            self.assertAlmostEqual(widths[FIRST_WAY + i], width_m, delta=0.002, msg=str(tags)[:200])

    def test_unknown_words_are_quoted_once_each_and_known_ones_are_read_in_any_capitals(self):
        unknown = [f"unheard_of_{letter}" for letter in "abcdefghijkl"]
        ways = [({"highway": "Footway", "surface": word}, 1, 0) for word in unknown]
        ways += [({"highway": "footway", "surface": word}, 0, 0) for word in ("Fine Gravel", "asphalt;concrete", "dirt/sand")]
        ways += [({"material": word}, 0, 0) for word in ("Natural Stone", "wood;metal", "stainless steel")]
        out = self.folder / "out"
        done = run("compile", self.written(ways), "--lods", "2.5", "-o", out)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.diagnosed(out)["tags"], {f"surface={word}": 1 for word in unknown})
        for word in unknown:
            self.assertEqual(done.stdout.count(f"surface={word}"), 1, done.stdout)

    def test_a_value_longer_than_osm_allows_is_one_error_line(self):
        bad = self.written([({"turn:lanes": "x" * 10000}, 1, RESIDENTIAL_M)])
        done = run("compile", bad, "-o", self.folder / "out")
        self.assertEqual(done.returncode, 1)
        self.assertEqual(done.stderr, f"citykiln: {bad}: OSM tag value is too long\n")

    def test_tiles_are_complete_and_strict_fails(self):
        bad = self.written(WAYS)
        out = self.compiled("out", bad, "--lods", "0.5")
        tiles = list(out.glob("glb/*_L0.glb"))
        self.assertTrue(tiles)
        self.assertEqual(len(tiles), len(report_of(out)["tiles"]))
        done = run("check", out)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertEqual(run("compile", bad, "-o", self.folder / "strict", "--lods", "2.5", "--strict").returncode, 2)
        good = self.written([row for row in WAYS if row[1] == 0], "good.osm")
        self.assertEqual(run("compile", good, "-o", self.folder / "good", "--lods", "2.5", "--strict").returncode, 0)


if __name__ == "__main__":
    unittest.main()
