#!/usr/bin/env python3
"""CesiumJS and 3DTilesRendererJS load the town's tileset in headless Chromium: from 5 km down to a street more and finer tiles are loaded,
no tile fails, and the ground fills the lower part of every picture: nothing of the background shows between levels or tiles. Tilesets with
packed contents show as many tiles, and nearly the same picture."""
import json
import subprocess
import sys
import unittest

import readers
from readers import HERE, ReaderTest

# the town's ground is 398 to 422 m high
VIEWS = [((-1500, -4500, 2200), (0, 0, 400)), ((-700, -1500, 1000), (0, 0, 400)), ((-250, -500, 560), (0, 100, 400)),
         ((-60, -260, 440), (60, 200, 400))]
SIZE = (480, 270)
# small tiles: pictures are drawn without a graphics card
PACKED_LODS = "12.5"


class Tiles3d(ReaderTest):
    def fly(self, page, views=VIEWS, lods="0.5,2.5,12.5", packing="none"):
        out = self.town(f"tiles_{packing}", "--lods", lods, "--emit", "kiln,3dtiles", "--compress", packing)
        pictures = [self.folder / f"{packing}_{i}.png" for i in range(len(views))]
        job = {"page": page, "folder": str(out / "3dtiles"), "size": SIZE, "error_px": 4, "facts": str(self.folder / "facts.json"),
               "views": [{"eye": eye, "look": look, "out": str(path)} for (eye, look), path in zip(views, pictures)]}
        (self.folder / "job.json").write_text(json.dumps(job))
        done = subprocess.run(["node", HERE / "fly_tiles3d.mjs", self.folder / "job.json"], capture_output=True, text=True, cwd=HERE,
                              check=False, timeout=900)
        self.assertEqual(done.returncode, 0, done.stderr[-2000:])
        return json.loads((self.folder / "facts.json").read_text()), pictures

    def expect_a_flight(self, page):
        import numpy
        from PIL import Image
        facts, pictures = self.fly(page)
        print(page, json.dumps(facts["views"]))
        self.assertEqual(facts["errors"], [])
        loaded = [view["loaded"] for view in facts["views"]]
        self.assertGreaterEqual(loaded[0], 1)
        self.assertEqual(loaded, sorted(loaded))
        self.assertGreater(loaded[-1], loaded[0])
        for i, path in enumerate(pictures):
            self.assertEqual(facts["views"][i]["failed"], 0)
            colours = numpy.asarray(Image.open(path).convert("RGB")).astype(int)
            background = (abs(colours - (255, 0, 255)).sum(axis=2) < 60)
            with self.subTest(view=i):
                self.assertGreater(colours.std(), 10)
                self.assertGreater((~background).mean(), 0.02)
                # the middle looks at the town, and holes would be background inside of it
                middle = background[SIZE[1] * 50 // 100:SIZE[1] * 58 // 100, SIZE[0] * 45 // 100:SIZE[0] * 55 // 100]
                self.assertEqual(middle.mean(), 0)

    def expect_packed_as_plain(self, page):
        view = [VIEWS[2]]
        plain, [expected] = self.fly(page, view, PACKED_LODS)
        for packing in ("quantize", "draco", "meshopt"):
            with self.subTest(packing):
                facts, [picture] = self.fly(page, view, PACKED_LODS, packing)
                print(page, packing, json.dumps(facts["views"]), readers.difference(picture, expected))
                self.assertEqual(facts["errors"], [])
                self.assertEqual(facts["views"][0]["failed"], 0)
                self.assertEqual(facts["views"][0]["shown"], plain["views"][0]["shown"])
                self.assertLess(facts["views"][0]["bytes"], plain["views"][0]["bytes"])
                self.assertLess(readers.difference(picture, expected), 0.02)

    def test_packed_three(self):
        self.expect_packed_as_plain("fly_three.html")

    def test_packed_cesium(self):
        self.expect_packed_as_plain("fly_cesium.html")

    def test_three(self):
        self.expect_a_flight("fly_three.html")

    def test_cesium(self):
        self.expect_a_flight("fly_cesium.html")


if __name__ == "__main__":
    readers.skip_unless(readers.has_npm("cesium") and readers.has_npm("3d-tiles-renderer") and readers.has_npm("playwright-core")
                        and readers.has_pictures(), "CesiumJS and 3DTilesRendererJS are not installed (npm ci --prefix tests/interop)")
    unittest.main(argv=sys.argv[:2], verbosity=2)
