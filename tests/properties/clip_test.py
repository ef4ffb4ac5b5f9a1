#!/usr/bin/env python3
"""A clip keeps what lies inside of it, though the tile of its anchor lies beyond."""
import json
import unittest

from citykiln_program import ProgramTest, report_of

# a street with a bridge of 184 m over the border of two tiles, which is at 12.30695, and a house of which the most lies west of it
MAP = """<osm version="0.6"><bounds minlat="48.7" minlon="12.3" maxlat="48.706" maxlon="12.316"/>
<node id="1" lat="48.703" lon="12.301"/><node id="2" lat="48.703" lon="12.306"/>
<node id="3" lat="48.703" lon="12.3085"/><node id="4" lat="48.703" lon="12.315"/>
<node id="5" lat="48.7041" lon="12.3060"/><node id="6" lat="48.7041" lon="12.3076"/><node id="7" lat="48.7049" lon="12.3076"/>
<node id="8" lat="48.7049" lon="12.3071"/><node id="9" lat="48.7042" lon="12.3071"/><node id="10" lat="48.7042" lon="12.3060"/>
<way id="11"><nd ref="1"/><nd ref="2"/><tag k="highway" v="residential"/></way>
<way id="12"><nd ref="2"/><nd ref="3"/><tag k="highway" v="residential"/><tag k="bridge" v="yes"/><tag k="layer" v="1"/></way>
<way id="13"><nd ref="3"/><nd ref="4"/><tag k="highway" v="residential"/></way>
<way id="14"><nd ref="5"/><nd ref="6"/><nd ref="7"/><nd ref="8"/><nd ref="9"/><nd ref="10"/><nd ref="5"/>
<tag k="building" v="yes"/><tag k="height" v="9"/></way></osm>"""
WOOD = """<osm version="0.6"><bounds minlat="48.7" minlon="12.3" maxlat="48.706" maxlon="12.316"/>
<node id="1" lat="48.7002" lon="12.3002"/><node id="2" lat="48.7002" lon="12.3158"/><node id="3" lat="48.7058" lon="12.3158"/>
<node id="4" lat="48.7058" lon="12.3002"/><way id="11"><nd ref="1"/><nd ref="2"/><nd ref="3"/><nd ref="4"/><nd ref="1"/>
<tag k="natural" v="wood"/></way></osm>"""
EAST = [[12.30698, 48.7005], [12.3155, 48.7005], [12.3155, 48.7055], [12.30698, 48.7055], [12.30698, 48.7005]]


class Clip(ProgramTest):
    def report_with(self, name, *arguments, map=MAP):
        path = self.folder / "map.osm"
        path.write_text(map)
        box = ["--bbox", "12.3,48.7,12.316,48.706", "--origin", "12.3,48.7"]
        return report_of(self.compiled(name, path, *box, "--tile", 512, "--lods", "2.5", *arguments))

    def east(self):
        """A file with the eastern half as a polygon."""
        clip = self.folder / "east.geojson"
        clip.write_text(json.dumps({"type": "Polygon", "coordinates": [EAST]}))
        return clip

    def test_a_bridge_and_a_house_anchored_in_a_tile_beyond_a_clip_are_baked_inside(self):
        whole, clipped = self.report_with("whole"), self.report_with("clipped", "--clip", self.east())
        self.assertEqual([tile["x"] for tile in clipped["tiles"]], [1, 1, 2, 2])
        for kind in ("bake/bridge", "bake/building"):
            self.assertEqual((whole["ledger"][kind]["out"], clipped["ledger"][kind]["out"]), (1, 1), kind)

    def test_a_wood_that_is_the_last_polygon_before_the_clip_has_a_canopy(self):
        clipped = self.report_with("wood", "--assume", "none", "--clip", self.east(), map=WOOD)
        self.assertGreater(sum(tile["triangles"] for tile in clipped["tiles"]), 100)


if __name__ == "__main__":
    unittest.main()
