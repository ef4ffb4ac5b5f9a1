#!/usr/bin/env python3
"""Makes the picture of roofs.md: all shapes on all footprints, as citykiln compiles them from tags.

make_picture.py CITYKILN OUT.png
"""
import math
import subprocess
import sys
import tempfile
from pathlib import Path

SHAPES = ("flat skillion gabled hipped half-hipped side_hipped pyramidal gambrel mansard saltbox double_saltbox dome onion round cone "
          "cross_gabled sawtooth gabled_row").split()
EAST_M, NORTH_M = 46, 30  # from one to the next
METRES_A_DEGREE = 111_194.9


def box(x0, y0, x1, y1):
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


def round_about(centre, radius_m, corners, wobble=0.0):
    def corner(i):
        turn = 2 * math.pi * i / corners
        r = radius_m * (1 + wobble * math.sin(5 * turn) + wobble / 3 * math.sin(31 * turn))
        return centre[0] + r * math.cos(turn), centre[1] + r * math.sin(turn)
    return [corner(i) for i in range(corners)]


# outer rings, then inner ones; as in tests/grammars/roofs/footprints.h, and one of 400 corners
FOOTPRINTS = [
    ([box(0, 0, 16, 10)], []),
    ([[(0, 0), (20, 0), (20, 8), (8, 8), (8, 18), (0, 18)]], []),
    ([[(0, 12), (8, 12), (8, 0), (16, 0), (16, 12), (24, 12), (24, 20), (0, 20)]], []),
    ([[(0, 0), (24, 0), (24, 18), (16, 18), (16, 8), (8, 8), (8, 18), (0, 18)]], []),
    ([[(8, 0), (16, 0), (16, 8), (24, 8), (24, 16), (16, 16), (16, 24), (8, 24), (8, 16), (0, 16), (0, 8), (8, 8)]], []),
    ([box(0, 0, 26, 22)], [box(8, 8, 18, 14)]),
    ([box(0, 0, 40, 22)], [box(8, 7, 17, 15), box(24, 7, 32, 15)]),
    ([round_about((8, 8), 8, 64)], []),
    ([box(0, 0, 30, 0.25)], []),
    ([[(0, 0), (8, -0.01), (16, 0), (16, 10), (9, 10), (8.99, 2), (8.98, 10), (0, 10)]], []),
    ([[(0, 0), (10, 0), (10, 10), (0, 10)], [(10, 10), (22, 10), (22, 22), (10, 22)]], []),
    ([round_about((11, 11), 10, 400, 0.15)], []),
]


class Map:
    def __init__(self):
        self.nodes, self.ways, self.relations = [], [], []

    def way(self, ring, tags=""):
        first = len(self.nodes) + 1
        for x, y in ring:
            lat, lon = y / METRES_A_DEGREE, x / METRES_A_DEGREE
            self.nodes.append(f'<node id="{len(self.nodes) + 1}" version="1" lat="{lat:.9f}" lon="{lon:.9f}"/>')
        refs = "".join(f'<nd ref="{first + i % len(ring)}"/>' for i in range(len(ring) + 1))
        self.ways.append(f'<way id="{len(self.ways) + 1}" version="1">{refs}{tags}</way>')
        return len(self.ways)

    def building(self, outer, inner, tags):
        if len(outer) == 1 and not inner:
            self.way(outer[0], tags)
            return
        members = [(self.way(ring), role) for rings, role in ((outer, "outer"), (inner, "inner")) for ring in rings]
        listed = "".join(f'<member type="way" ref="{ref}" role="{role}"/>' for ref, role in members)
        self.relations.append(f'<relation id="{len(self.relations) + 1}" version="1">{listed}<tag k="type" v="multipolygon"/>{tags}</relation>')

    def text(self):
        return '<osm version="0.6">' + "\n".join(self.nodes + self.ways + self.relations) + "</osm>\n"


def tags_of(shape):
    tags = {"building": "yes", "building:levels": "1", "height": "3" if shape == "flat" else "8", "roof:shape": shape,
            "roof:colour": "#a5502f", "building:colour": "#e8e2d4"}
    if shape != "flat":
        tags["roof:height"] = "5"
    return "".join(f'<tag k="{key}" v="{value}"/>' for key, value in tags.items())


def town():
    made = Map()
    for row, shape in enumerate(SHAPES):
        for column, (outer, inner) in enumerate(FOOTPRINTS):
            place = [[[(x + column * EAST_M, y - row * NORTH_M) for x, y in ring] for ring in rings] for rings in (outer, inner)]
            made.building(*place, tags_of(shape))
    return made.text()


def main(citykiln, out):
    def run(*words):
        subprocess.run([citykiln, *map(str, words), "--quiet"], check=True)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "roofs.osm"
        path.write_text(town())
        run("compile", path, "--origin", "0,0", "--lods", "0.1", "-o", Path(folder) / "out")
        x, y = EAST_M * (len(FOOTPRINTS) - 0.5) / 2, -NORTH_M * (len(SHAPES) - 1) / 2 - 12
        run("preview", Path(folder) / "out", "--eye", f"{x},{y - 440},760", "--look", f"{x},{y},0", "--fov", 35, "--size", "1000x860",
            "--spp", 24, "-o", out)


if __name__ == "__main__":
    main(*sys.argv[1:])
