#!/usr/bin/env python3
"""Tiles compiled in separate runs, or over a heightmap in pieces, have the same bytes as those of one run over one heightmap, on every
level."""
import array
import unittest

from citykiln_program import ProgramTest, bytes_of_outputs, long_test, report_of, run

VOID = -32768
DEGREE = 1200  # SRTM samples per degree
LEVELS = ["--lods", "0.5,2.5,12.5"]


def tiles_in(folder):
    return {name: digest for name, digest in bytes_of_outputs(folder).items() if name.endswith(".glb")}


@long_test
class TilesOfFourRunsReal(ProgramTest):
    """Andorra's capital on four tiles with a common corner: roads, a river, bridges, tunnels, buildings."""
    TILES = ["-7_-4", "-6_-4", "-7_-3", "-6_-3"]

    def test_have_the_bytes_of_one_run_on_each_level(self):
        map_path, dem = self.data("andorra/andorra-2023.osm.pbf"), self.data("andorra/N42E001.hgt")
        at_once = self.compiled("at_once", map_path, "--dem", dem, *LEVELS, f"--only={','.join(self.TILES)}", "--threads", 2)
        whole = tiles_in(at_once)
        self.assertEqual(len(whole), 3 * len(self.TILES))
        for threads, tile in zip((1, 7, 3, 2), reversed(self.TILES)):
            apart = tiles_in(self.compiled(f"apart{tile}", map_path, "--dem", dem, *LEVELS, f"--only={tile}", "--threads", threads))
            self.assertEqual(apart, {name: digest for name, digest in whole.items() if name.startswith(f"glb/{tile}_L")})
        # `check` compares the borders of these four edge by edge; by the equality above they are those of the four runs
        done = run("check", at_once)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("neighbouring tiles have the same border edges", done.stdout)


class HeightsInPiecesReal(ProgramTest):
    """A heightmap cut along a meridian in the middle of the map."""
    BOX = "1.52,42.515,1.54,42.527"
    # SRTM columns and rows around the map, and the column of the cut
    WEST, EAST, NORTH, SOUTH = 540, 720, 500, 660
    CUT = 636

    def samples(self):
        heights = array.array("h", self.data("andorra/N42E001.hgt").read_bytes())
        heights.byteswap()
        # a void and a spike of two samples, each on both sides of the cut
        for column in range(self.CUT - 4, self.CUT + 3):
            for row in range(570, 578):
                heights[row * (DEGREE + 1) + column] = VOID
        for column in (self.CUT - 1, self.CUT):
            heights[582 * (DEGREE + 1) + column] += 900
        return heights

    def grid(self, folder, first, last, north=NORTH, south=SOUTH):
        """Writes columns [first, last) as an ESRI ASCII grid."""
        heights = self.samples()
        lines = [" ".join(map(str, heights[row * (DEGREE + 1) + first:row * (DEGREE + 1) + last])) for row in range(north, south)]
        head = (f"ncols {last - first}\nnrows {len(lines)}\nxllcorner {1 + (first - 0.5) / DEGREE!r}\n"
                f"yllcorner {43 - (south - 0.5) / DEGREE!r}\ncellsize {1 / DEGREE!r}\nNODATA_value {VOID}\n")
        path = self.folder / folder / f"from{first}to{last}.asc"
        path.parent.mkdir(exist_ok=True)
        path.write_text(head + "\n".join(lines) + "\n")
        return path

    def compiled_over(self, name, *grids):
        dems = [word for grid in grids for word in ("--dem", grid)]
        return self.compiled(name, self.data("andorra/andorra-2023.osm.pbf"), *dems, "--bbox", self.BOX, "--lods", "2.5,12.5")

    def test_two_pieces_give_the_bytes_of_the_whole(self):
        whole = self.compiled_over("whole", self.grid("in", self.WEST, self.EAST))
        diagnoses = report_of(whole)["diagnoses"]
        self.assertEqual(diagnoses["HeightSpike"]["count"], 2)
        west, east = self.grid("in", self.WEST, self.CUT), self.grid("in", self.CUT, self.EAST)
        # neighbouring SRTM files share a column; the order of --dem is free
        sharing = self.grid("in", self.CUT - 1, self.EAST)
        for name, grids in {"apart": [west, east], "swapped": [east, west], "sharing": [sharing, west]}.items():
            pieces = self.compiled_over(name, *grids)
            self.assertEqual(diagnoses, report_of(pieces)["diagnoses"], name)
            self.assertEqual(chunks_of(whole), chunks_of(pieces), name)
            self.assertEqual(tiles_in(whole), tiles_in(pieces), name)

    @long_test
    def test_two_pieces_give_all_recipes_of_andorra(self):
        degree = (0, DEGREE + 1)
        whole, west, east = (self.grid("in", *columns, *degree) for columns in (degree, (0, self.CUT), (self.CUT, DEGREE + 1)))
        map_path = self.data("andorra/andorra-2023.osm.pbf")
        of_whole = self.compiled("all", map_path, "--dem", whole, "--emit", "kiln")
        of_pieces = self.compiled("cut", map_path, "--dem", west, "--dem", east, "--emit", "kiln")
        self.assertEqual(report_of(of_whole)["diagnoses"], report_of(of_pieces)["diagnoses"])
        self.assertEqual(chunks_of(of_whole), chunks_of(of_pieces))


def chunks_of(folder):
    """The manifest's body after the header frame: the recipes of every tile, without the names of the sources."""
    manifest = (folder / "scene.kiln").read_bytes()
    body = manifest[24 + int.from_bytes(manifest[12:16], "little"):]
    assert body
    return body


if __name__ == "__main__":
    unittest.main()
