#!/usr/bin/env python3
"""Same inputs, same bytes: for any number of threads, any order of the map's elements, any x86-64 CPU, by compile or by bake, and tile
by tile."""
import json
import os
import unittest

from citykiln_program import IS_FULL, TOWN, TOWN_MIDDLE, ProgramTest, bytes_of_outputs, long_test, run
from shuffled import shuffle

# Makes glibc and libm behave as on a CPU without FMA; glibc changed the spelling of the names, so both are given.
NO_FMA = "glibc.cpu.hwcaps=-AVX2_Usable,-FMA_Usable,-FMA4_Usable,-AVX2,-FMA,-FMA4,-AVX512F"


class SameBytes:
    """The claims about one map and heightmap, which a subclass names, at a fine and a coarse level and in several tiles."""
    LEVELS = "0.1,2.5"

    def arguments(self):
        return ["--lods", self.LEVELS, "--tile", "256"]

    def inputs(self):
        raise NotImplementedError

    def compiled_plainly(self):
        map_path, dem = self.inputs()
        return self.compiled_once(map_path, *dem, *self.arguments()), map_path, dem

    def test_threads_change_no_byte(self):
        plain, map_path, dem = self.compiled_plainly()
        outputs = bytes_of_outputs(plain)
        self.assertGreater(len(outputs), 1)
        # one thread bakes below
        other = self.compiled("t7", map_path, *dem, *self.arguments(), "--threads", 7)
        self.assertEqual(outputs, bytes_of_outputs(other))
        self.assertEqual((plain / "report.json").read_text(), (other / "report.json").read_text())

    def test_the_order_of_elements_changes_no_byte(self):
        plain, map_path, dem = self.compiled_plainly()
        # the manifest contains the file's name, so the shuffled file gets the same one
        other = self.folder / "shuffled" / map_path.name
        other.parent.mkdir()
        shuffle(map_path, other, 1)
        shuffled = self.compiled("out", other, *dem, *self.arguments())
        self.assertEqual(bytes_of_outputs(plain), bytes_of_outputs(shuffled))

    def test_a_cpu_without_fma_changes_no_byte(self):
        plain, map_path, dem = self.compiled_plainly()
        without = self.compiled("no_fma", map_path, *dem, *self.arguments(), env={**os.environ, "GLIBC_TUNABLES": NO_FMA})
        self.assertEqual(bytes_of_outputs(plain), bytes_of_outputs(without))

    def test_bake_writes_what_compile_writes(self):
        plain, _, _ = self.compiled_plainly()
        baked = self.folder / "baked"
        done = run("bake", plain / "scene.kiln", "--lods", self.LEVELS, "--threads", 1, "-o", baked)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(bytes_of_outputs(plain), bytes_of_outputs(baked))

    def test_one_tile_baked_alone_is_the_tile_of_the_whole(self):
        plain, _, _ = self.compiled_plainly()
        whole = bytes_of_outputs(plain)
        name = sorted(n for n in whole if n.endswith("_L1.glb"))[0]
        tile = name.removeprefix("glb/").removesuffix("_L1.glb")
        alone = self.folder / "alone.glb"
        done = run("bake", plain / "scene.kiln", "--tile", tile, "--tolerance", "2.5", "-o", alone)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual((plain / name).read_bytes(), alone.read_bytes())

    def test_tiles_compiled_alone_are_the_tiles_of_the_whole(self):
        plain, map_path, dem = self.compiled_plainly()
        whole = bytes_of_outputs(plain)
        tiles = sorted({n.removeprefix("glb/").split("_L")[0] for n in whole if "_L" in n and n.endswith(".glb")})
        self.assertTrue(tiles)
        for tile in tiles[:2]:
            apart = self.compiled(f"apart_{tile}", map_path, *dem, *self.arguments(), "--only", tile)
            glb = {n: h for n, h in bytes_of_outputs(apart).items() if "_L" in n and n.endswith(".glb")}
            self.assertEqual(glb, {n: h for n, h in whole.items() if n.startswith(f"glb/{tile}_L")})

    def test_check_finds_no_error(self):
        plain, _, _ = self.compiled_plainly()
        done = run("check", plain)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)


class SameBytesOfTown(SameBytes, ProgramTest):
    def inputs(self):
        spec = json.loads((TOWN / "spec.json").read_text())
        return TOWN / "town.osm", ["--dem", spec["dem"], *([] if IS_FULL else TOWN_MIDDLE)]


class SameBytesOfAVillageReal(SameBytes, ProgramTest):
    def inputs(self):
        return self.data("small/regglisweiler-10.068_48.135.osm"), []


class SameBytesOfAnUnsortedMapReal(SameBytes, ProgramTest):
    def inputs(self):
        return self.data("small/osmtogeojson-map.osm"), []


@long_test
class SameBytesOverHillsReal(SameBytes, ProgramTest):
    """Voids in the heightmap, sea and slopes, in a small part of the map."""

    def inputs(self):
        return self.data("monaco/cut-1km2-monacoville-port.osm"), ["--dem", self.data("monaco/N43E007.hgt"), "--bbox",
                                                                   "7.417,43.729,7.423,43.733"]


if __name__ == "__main__":
    unittest.main()
