#!/usr/bin/env python3
"""Same inputs, same bytes: for any number of threads, any order of the map's elements, any x86-64 CPU, either way of firing, and tile by tile."""
import os
import unittest

from citykiln_program import TOWN, ProgramTest, bytes_of_outputs, run
from shuffled import shuffle

# What glibc and, through it, libm would choose on a CPU without these; both the old and the new spelling.
NO_FMA = "glibc.cpu.hwcaps=-AVX2_Usable,-FMA_Usable,-FMA4_Usable,-AVX2,-FMA,-FMA4,-AVX512F"

# Small enough for five runs each; levels fine and coarse; tiles small enough that there are several.
ARGUMENTS = ["--lods", "0.1,2.5", "--tile", "256"]


class SameBytes:
    """The claims, for the map and heightmap that a subclass names."""

    def inputs(self):
        raise NotImplementedError

    def compiled_plainly(self):
        map_path, dem = self.inputs()
        return self.compiled("plain", map_path, *dem, *ARGUMENTS), map_path, dem

    def test_threads_change_no_byte(self):
        map_path, dem = self.inputs()
        outputs = [bytes_of_outputs(self.compiled(f"t{n}", map_path, *dem, *ARGUMENTS, "--threads", n)) for n in (1, 2, 7)]
        self.assertGreater(len(outputs[0]), 1)
        self.assertEqual(outputs[0], outputs[1])
        self.assertEqual(outputs[0], outputs[2])

    def test_reports_are_the_same_again(self):
        plain, map_path, dem = self.compiled_plainly()
        again = self.compiled("again", map_path, *dem, *ARGUMENTS, "--threads", 1)
        self.assertEqual((plain / "report.json").read_text(), (again / "report.json").read_text())

    def test_the_order_of_elements_changes_no_byte(self):
        plain, map_path, dem = self.compiled_plainly()
        for seed in (1, 2):
            # sources are named in the manifest, so the file keeps its name
            other = self.folder / f"seed{seed}" / map_path.name
            other.parent.mkdir()
            shuffle(map_path, other, seed)
            shuffled = self.compiled(f"shuffled{seed}", other, *dem, *ARGUMENTS)
            self.assertEqual(bytes_of_outputs(plain), bytes_of_outputs(shuffled))

    def test_a_cpu_without_fma_changes_no_byte(self):
        plain, map_path, dem = self.compiled_plainly()
        without = self.compiled("no_fma", map_path, *dem, *ARGUMENTS, env={**os.environ, "GLIBC_TUNABLES": NO_FMA})
        self.assertEqual(bytes_of_outputs(plain), bytes_of_outputs(without))

    def test_bake_writes_what_compile_writes(self):
        plain, _, _ = self.compiled_plainly()
        baked = self.folder / "baked"
        done = run("bake", plain / "scene.kiln", "--lods", "0.1,2.5", "-o", baked)
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

    def test_tiles_compiled_apart_are_the_tiles_of_the_whole(self):
        plain, map_path, dem = self.compiled_plainly()
        whole = bytes_of_outputs(plain)
        tiles = sorted({n.removeprefix("glb/").split("_L")[0] for n in whole if n.endswith(".glb")})
        for tile in tiles[:3]:
            apart = self.compiled(f"apart_{tile}", map_path, *dem, *ARGUMENTS, "--only", tile)
            glb = {n: h for n, h in bytes_of_outputs(apart).items() if n.endswith(".glb")}
            self.assertEqual(glb, {n: h for n, h in whole.items() if n.startswith(f"glb/{tile}_L")})

    def test_outputs_keep_their_promises(self):
        plain, _, _ = self.compiled_plainly()
        done = run("check", plain)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)


class SameBytesOfTown(SameBytes, ProgramTest):
    def inputs(self):
        if not (TOWN / "town.osm").exists():
            self.skipTest("examples/town is not there")
        return TOWN / "town.osm", town_dem()


class SameBytesOfAVillageReal(SameBytes, ProgramTest):
    def inputs(self):
        return self.data("small/regglisweiler-10.068_48.135.osm"), []


class SameBytesOfAnUnsortedMapReal(SameBytes, ProgramTest):
    def inputs(self):
        return self.data("small/osmtogeojson-map.osm"), []


class SameBytesOverHillsReal(SameBytes, ProgramTest):
    """Voids in the heightmap, sea, slopes; a corner of the map, since it is the way that counts."""

    def inputs(self):
        return self.data("monaco/cut-1km2-monacoville-port.osm"), ["--dem", self.data("monaco/N43E007.hgt"), "--bbox",
                                                                   "7.417,43.729,7.423,43.733"]


def town_dem():
    """The town's heightmap as its own spec gives it."""
    import json
    spec = json.loads((TOWN / "spec.json").read_text())
    dems = spec.get("dem", [])
    return [word for dem in ([dems] if isinstance(dems, str) else dems) for word in ("--dem", dem)]


if __name__ == "__main__":
    unittest.main()
