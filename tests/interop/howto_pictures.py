#!/usr/bin/env python3
"""howto_pictures.py FOLDER draws the pictures of exporters/gltf/howto: the town at 0.5 m in Blender, Godot and three.js,
and its tileset in CesiumJS. After FOLDER, names of programs may follow."""
import shutil
import subprocess
import sys
from pathlib import Path

import readers
from citykiln_program import TOWN, run
from PIL import Image

EYE, LOOK = (-60, -260, 470), (60, 200, 390)
PROGRAMS = {"blender": readers.run_blender, "godot": readers.run_godot, "three": readers.run_three}


def compile_town(*arguments):
    done = run("compile", "--spec", TOWN / "spec.json", *arguments)
    assert done.returncode == 0, done.stderr


def draw_cesium(work):
    """The page of the how-to itself."""
    compile_town("--emit", "kiln,3dtiles", "--geoid-height", "47", "-o", work / "out" / "cesium")
    shutil.copy(readers.HERE.parent.parent / "exporters" / "gltf" / "howto" / "cesium.html", work)
    (work / "node_modules").symlink_to((readers.HERE / "node_modules").resolve())
    subprocess.run(["node", readers.HERE / "draw_cesium.mjs", work, "cesium.html", work / "all.png"], cwd=readers.HERE, check=True)


def draw_tiles(name, work):
    compile_town("--lods", "0.5", "--target", name, "-o", work / "out")
    PROGRAMS[name](work, sorted((work / "out" / "glb").glob("*.glb")), [readers.picture(work / "all.png", EYE, LOOK, (960, 540))])


def draw(name, folder):
    work = folder / f"{name}_work"
    work.mkdir(parents=True)
    if name == "cesium":
        draw_cesium(work)
    else:
        draw_tiles(name, work)
    Image.open(work / "all.png").convert("RGB").save(folder / f"{name}.jpg", quality=88, optimize=True)


for program in sys.argv[2:] or [*PROGRAMS, "cesium"]:
    draw(program, Path(sys.argv[1]).resolve())
