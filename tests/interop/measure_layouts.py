#!/usr/bin/env python3
"""measure_layouts.py RUN FOLDER prints what the tiles of a run cost for each target, layout and compression: MB and files of all its
levels; and of its largest tile of LEVEL (default 1) the time to load in the target's program, and the draw calls and triangles that
three.js counts from above, or the objects and meshes of Blender and Godot."""
import resource
import sys
from pathlib import Path

import readers
from citykiln_program import run

TARGETS = {"generic": ["lean"], "blender": ["lean", "quantize"], "godot": ["none"], "three": ["lean", "quantize", "draco", "meshopt"],
           "cesium": ["lean", "quantize", "draco", "meshopt"], "unreal": ["lean", "draco"], "unity": ["lean", "draco", "meshopt"]}
READERS = {"generic": readers.run_three, "blender": readers.run_blender, "godot": readers.run_godot, "three": readers.run_three}


def opened(target, folder, path):
    """Text of what the program says about a tile, seen whole from above."""
    work = folder / "work"
    work.mkdir(exist_ok=True)
    box = readers.facts_of(path)["meshes"]["ground"]
    middle = [(a + b) / 2 for a, b in zip(box["low"], box["high"])]
    origin = readers.Glb(path).gltf["nodes"][0]["translation"]
    at = [origin[0] + middle[0], -origin[2] - middle[2], origin[1] + middle[1]]
    views = [readers.picture(work / "above.png", [at[0], at[1] - 10, at[2] + 2500], at)] if READERS[target] is readers.run_three else []
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    [facts], _ = READERS[target](work, [path], views)
    cpu_s = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
    if views:
        return f"{facts['load_s']:.2f} s | {facts['drawn']['calls']} calls | {facts['drawn']['triangles']} triangles"
    places = sum(len(rows) for rows in facts["places"].values())
    return f"{facts.get('cpu_s', cpu_s):.2f} s CPU | {places} objects | {len(facts['meshes'])} meshes | {readers.triangles_in(facts)} triangles"


def measure(scene, target, layout, compress, out, level):
    done = run("bake", scene, "--target", target, "--layout", layout, "--compress", compress, "-o", out)
    assert done.returncode == 0, done.stderr
    files = [path for path in (out / "glb").rglob("*") if path.is_file()]
    tiles = sorted((out / "glb").glob(f"*_L{level}.glb"), key=lambda path: path.stat().st_size)
    seen = opened(target, out, tiles[-1]) if target in READERS and compress in ("none", "lean", "quantize") else ""
    print(f"| {target} | {layout} | {compress} | {sum(path.stat().st_size for path in files) / 1e6:.1f} | {len(files)} | {seen} |", flush=True)


folder = Path(sys.argv[2]).resolve()
for target, packings in TARGETS.items():
    for compress in packings:
        for layout in ("embedded", "shared"):
            measure(Path(sys.argv[1]) / "scene.kiln", target, layout, compress, folder / f"{target}_{layout}_{compress}",
                    int(sys.argv[3]) if len(sys.argv) > 3 else 1)
