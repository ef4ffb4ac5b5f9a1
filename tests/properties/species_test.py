#!/usr/bin/env python3
"""A species is added by a folder with a file: the tile has it, without building anything."""
import unittest

from citykiln_program import ROOT, ProgramTest, bytes_of_outputs, run
from glb import Glb

MAP = """<osm version="0.6"><bounds minlat="43.730" minlon="7.420" maxlat="43.731" maxlon="7.422"/>
<node id="1" lat="43.7302" lon="7.4202" version="1"/><node id="2" lat="43.7302" lon="7.4209" version="1"/>
<node id="3" lat="43.7307" lon="7.4209" version="1"/><node id="4" lat="43.7307" lon="7.4202" version="1"/>
<node id="7" lat="43.7305" lon="7.4214" version="1"><tag k="natural" v="tree"/>{tree}</node>
<way id="9" version="1"><nd ref="1"/><nd ref="2"/><nd ref="3"/><nd ref="4"/><nd ref="1"/>{area}</way>
</osm>"""

PLANT = """module oak_leaf
n: 4
height: 8
width: 0.4
axiom: A(3)
A(l) -> !(l*0.1)F(l)[&(50)A(l*0.7)]/(137)[&(40)A(l*0.6)~oak_leaf(1)]A(l*0.8)
"""
TREE = "Shape = 1\nScale = 9\nLevels = 2\n1Branches = 20\n1Length = 0.4\n1DownAngle = 50\nLeaves = 30\n"


def tags(**values):
    return "".join(f'<tag k="{key}" v="{value}"/>' for key, value in values.items())


class Species(ProgramTest):
    def map_of(self, tree="", area=""):
        path = self.folder / "town.osm"
        path.write_text(MAP.format(tree=tree, area=area))
        return path

    def species(self, **files):
        """A folder with these files: sundew_lsys is sundew.lsys."""
        folder = self.folder / "species"
        folder.mkdir(exist_ok=True)
        for old in folder.iterdir():
            old.unlink()
        for name, text in files.items():
            (folder / ".".join(name.rsplit("_", 1))).write_text(text)
        return folder

    def plants(self, out, level=0):
        """Name of a species to the number of its plants."""
        gltf = Glb(out / "glb" / f"0_0_L{level}.glb").gltf
        counts = {}
        for node in gltf["nodes"]:
            stem, _, variant = node.get("name", "").rpartition("_")
            if not stem or stem.startswith("tile_") or not variant.isdigit():
                continue
            extension = node.get("extensions", {}).get("EXT_mesh_gpu_instancing")
            count = 1 if extension is None else gltf["accessors"][extension["attributes"]["TRANSLATION"]]["count"]
            counts[stem] = counts.get(stem, 0) + count
        return counts

    def test_a_file_adds_a_species(self):
        arguments = [self.map_of(tags(species="Drosera magnifica")), "--lods", "0.1,2"]
        without = self.compiled("without", *arguments)
        self.assertNotIn("sundew", self.plants(without))
        folder = self.species(sundew_lsys=PLANT, species_txt="sundew names=drosera\n")
        out = self.compiled("with", *arguments, "--species", folder)
        self.assertEqual(self.plants(out), {"sundew": 1})
        self.assertEqual(self.plants(out, 1), {"sundew": 1})
        done = run("check", out)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_each_notation_adds_a_species(self):
        honda = "N 6\nR1 0.9\nR2 0.7\nA0 45\nA2 45\nD 137.5\nWr 0.7\nHeight 5\n"
        family = "N 12\nDelta 60\nLA 5\nRA 1.05\nLB 1\nRB 1.08\nPD 0.6\n"
        old = "4\n25\n3\nF\nF > F[+F]F\n"
        for ending, text in (("lsys", PLANT), ("tree", TREE), ("honda", honda), ("family", family), ("lsys", old)):
            folder = self.species(**{f"mine_{ending}": text})
            out = self.compiled(f"{ending}{len(text)}", self.map_of(tags(species="mine")), "--lods", "0.02", "--species", folder)
            self.assertEqual(self.plants(out), {"mine": 1}, ending)

    def test_a_file_of_a_shipped_name_replaces_it(self):
        arguments = [self.map_of(tags(genus="Quercus")), "--lods", "0.1"]
        shipped, own = self.compiled("shipped", *arguments), self.compiled("own", *arguments, "--species", self.species(oak_tree=TREE))
        self.assertEqual(self.plants(own), self.plants(shipped))
        self.assertNotEqual(bytes_of_outputs(own)["glb/0_0_L0.glb"], bytes_of_outputs(shipped)["glb/0_0_L0.glb"])

    def test_longer_names_win(self):
        folder = self.species(aspen_tree=TREE, sundew_lsys=PLANT, species_txt="aspen names=populus\nsundew names=populus_nigra\n")
        for name, species in (("Populus tremula", "aspen"), ("Populus nigra 'Italica'", "sundew"), ("Quercus robur", "oak")):
            out = self.compiled(species, self.map_of(tags(species=name)), "--lods", "0.1", "--species", folder)
            self.assertEqual(self.plants(out), {species: 1})

    def test_spawners_set_plants_on_areas(self):
        arguments = [self.map_of(area=tags(natural="wood", leaf_type="broadleaved")), "--lods", "0.1"]
        self.assertNotIn("mine", self.plants(self.compiled("without", *arguments)))
        counts = {}
        for name, row in (("all", "mine 5 1 0.5 1"), ("half", "mine 5 0.5 0.5 1"), ("mixed", "mine*3,oak 5 1 0.5 0.6..1.2")):
            folder = self.species(mine_tree=TREE, spawners_txt=f"natural=wood&leaf_type=broadleaved {row}\n")
            out = self.compiled(name, *arguments, "--species", folder)
            counts[name] = self.plants(out)
            counts[name].pop("lime", None), counts[name].pop("maple", None)  # the single tree
        # 55.6 m by 56.4 m with a plant every 5 m, and the trees of one cell at the edge
        self.assertAlmostEqual(counts["all"]["mine"], 55.6 * 56.4 / 25, delta=12)
        self.assertAlmostEqual(counts["half"]["mine"], counts["all"]["mine"] / 2, delta=18)
        self.assertGreater(counts["mixed"]["mine"], counts["mixed"]["oak"])
        self.assertGreater(counts["mixed"]["oak"], 10)
        # other areas keep their own plants
        folder = self.species(mine_tree=TREE, spawners_txt="landuse=orchard mine 5 1 0.5 1\n")
        self.assertNotIn("mine", self.plants(self.compiled("others", *arguments, "--species", folder)))

    def test_spawners_choose_the_species_of_trees(self):
        folder = self.species(mine_tree=TREE, spawners_txt="natural=tree&leaf_type=needleleaved mine 1 1 0 1\n")
        arguments = ["--lods", "0.1", "--species", folder]
        needles = self.compiled("needles", self.map_of(tags(leaf_type="needleleaved")), *arguments)
        self.assertEqual(self.plants(needles), {"mine": 1})
        named = self.compiled("named", self.map_of(tags(leaf_type="needleleaved", genus="Pinus")), *arguments)
        self.assertEqual(self.plants(named), {"pine": 1})

    def test_bake_and_preview_need_no_folder(self):
        folder = self.species(mine_tree=TREE, spawners_txt="natural=wood mine 6 1 0.5 1\n")
        out = self.compiled("with", self.map_of(area=tags(natural="wood")), "--lods", "0.5", "--species", folder)
        self.species()
        baked = self.folder / "baked"
        done = run("bake", out / "scene.kiln", "--lods", "0.5", "-o", baked)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(bytes_of_outputs(out), bytes_of_outputs(baked))
        picture = self.folder / "picture.png"
        done = run("preview", out / "scene.kiln", "--size", "32x32", "--spp", "1", "-o", picture)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue(picture.exists())

    def test_the_same_bytes_on_one_and_seven_threads(self):
        folder = self.species(mine_tree=TREE, sundew_lsys=PLANT, spawners_txt="natural=wood mine,sundew 4 0.8 1 0.5..1\n")
        arguments = [self.map_of(area=tags(natural="wood")), "--lods", "0.1,2.5", "--species", folder]
        one, seven = (bytes_of_outputs(self.compiled(f"on{n}", *arguments, "--threads", n)) for n in (1, 7))
        self.assertEqual(one, seven)

    def test_a_mistake_is_one_line(self):
        many = "Levels = 4\n1Branches = 1000\n2Branches = 1000\n3Branches = 1000\n"
        cases = (({"mine_tree": "Scale = tall\n"}, "species/mine.tree:1:1: Scale: expected a number"),
                 ({"mine_tree": many}, "species/mine.tree:4:1: expected at most 4000000 stems, found parameters for 1001001001"),
                 ({"mine_lsys": "n: 60\naxiom: F\nF -> FFFF\n"}, "species/mine.lsys:3:1: rule F: the string would have more than 8000000 symbols; it grows without end"),
                 ({"mine_lsys": "n: 4\naxiom: A(1)\nA(x) -> F(x/0)A(x)\n"}, "species/mine.lsys:3:11: rule A: this value is no number"),
                 ({"mine_lsys": "n: 1\naxiom: [\n"}, "species/mine.lsys:2:8: "),
                 ({"mine_lsys": "n: 1\naxiom: X\n"}, "species/mine.lsys: expected a plant above the ground, found none"),
                 ({"mine_lsys": "n: 1\naxiom: F[+(90)F(3)][-(90)F(3)][&(90)F(3)][^(90)F(3)]\n"}, "at most 1.5 times as wide as high, found"),
                 ({"mine_honda": "N 7\n"}, "species/mine.honda: expected a value of"),
                 ({"Mine_tree": TREE}, "species/Mine.tree: expected a file name of small letters"),
                 ({"mine_tree": TREE, "mine_lsys": PLANT}, "species/mine.tree: is the second file of"),
                 ({"species_txt": "mine height=3\n"}, "species/species.txt:1: expected a file of the species"),
                 ({"species_txt": "# trees\noak height=99\n"}, "species/species.txt:2: height: expected 0.05 to 40"),
                 ({"species_txt": "oak colour=red\n"}, "species/species.txt:1: expected names, like, height"),
                 ({"species_txt": "oak leaf=#12345\n"}, "species/species.txt:1: leaf: expected #rrggbb"),
                 ({"spawners_txt": "natural=wood oak 5 1 0.5\n"}, "species/spawners.txt:1: expected 6 columns"),
                 ({"spawners_txt": "natural=wood oak 0.1 1 0.5 1\n"}, "species/spawners.txt:1: grid: expected 1 to 255 metres"),
                 ({"spawners_txt": "wood oak 5 1 0.5 1\n"}, "species/spawners.txt:1: tags: expected key=value"),
                 ({"spawners_txt": "natural=wood mine 5 1 0.5 1\n"}, "species/spawners.txt:1: there is no species \"mine\""),
                 ({}, "species: expected species.txt, spawners.txt or files"))
        for files, message in cases:
            done = run("compile", self.map_of(), "--species", self.species(**files), "-o", self.folder / "bad")
            self.assertEqual(done.returncode, 1, files)
            self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)
            self.assertIn(message, done.stderr)
            self.assertFalse((self.folder / "bad").exists())

    def test_inspect_draws_a_species_and_prints_its_levels(self):
        picture = self.folder / "plant.png"
        folder = self.species(mine_tree=TREE)
        for species, name in (("oak", "oak"), (folder / "mine.tree", "mine"), (folder, "mine")):
            done = run("inspect", species, "-o", picture)
            self.assertEqual(done.returncode, 0, done.stderr)
            lines = done.stdout.strip().splitlines()
            self.assertEqual(len(lines), 5)
            self.assertTrue(all(line.startswith(name) and "triangles, error" in line for line in lines), done.stdout)
            self.assertTrue(picture.exists())
            picture.unlink()
        done = run("inspect", "oka", "-o", picture)
        self.assertEqual(done.returncode, 1)
        self.assertIn("oka: expected a shipped species such as oak, a folder of species, or a file", done.stderr)

    def test_the_species_of_weber_and_penn_compile(self):
        folder = ROOT / "lsystems" / "weber_penn"
        out = self.compiled("aspen", self.map_of(tags(species="Populus tremuloides")), "--lods", "0.1,2.5", "--species", folder)
        self.assertEqual(self.plants(out), {"quaking_aspen": 1})


if __name__ == "__main__":
    unittest.main()
