#!/usr/bin/env python3
"""howto_pictures.py FOLDER draws the pictures of exporters/gltf/howto with Blender, Godot and three.js: the town at 0.5 m."""
import sys
from pathlib import Path

import readers
from citykiln_program import TOWN, run
from PIL import Image

EYE, LOOK = (-60, -260, 470), (60, 200, 390)
PROGRAMS = {"blender": readers.run_blender, "godot": readers.run_godot, "three": readers.run_three}


def draw(name, folder):
    work = folder / f"{name}_work"
    done = run("compile", "--spec", TOWN / "spec.json", "--lods", "0.5", "--target", name, "-o", work / "out")
    assert done.returncode == 0, done.stderr
    PROGRAMS[name](work, sorted((work / "out" / "glb").glob("*.glb")), [readers.picture(work / "all.png", EYE, LOOK, (960, 540))])
    Image.open(work / "all.png").convert("RGB").save(folder / f"{name}.jpg", quality=88, optimize=True)


for program in sys.argv[2:] or PROGRAMS:
    draw(program, Path(sys.argv[1]).resolve())
