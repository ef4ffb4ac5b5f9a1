"""Measures what a compile of the budget's maps writes: bytes, triangles, instances and stated errors, and the instructions of one run.

A row is (map, output, level, item) and its value. Files are read here, not asked of the program that wrote them; the streams
of a manifest are the only figure that the program states.
"""
import json
import os
import re
import struct
import subprocess
from collections import defaultdict
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
DATA = Path(os.environ.get("CITYKILN_DATA", ROOT.parent / "shared" / "data"))
PROGRAM = os.environ.get("CITYKILN", str(ROOT / "build" / "release" / "citykiln"))
BYTES = {5120: 1, 5121: 1, 5122: 2, 5123: 2, 5125: 4, 5126: 4}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}

# Real maps: the name in the table, and the words of compile.
MONACO = [DATA / "monaco/monaco-2023.osm.pbf", "--dem", DATA / "monaco/N43E007.hgt", "--bbox", "7.4180,43.7300,7.4225,43.7330"]
TOWN = ["--spec", ROOT / "examples/town/spec.json"]
# Invented maps: kind, seed, side in metres.
INVENTED = {"invented town": ("town", 11, 512), "invented village": ("village", 11, 256), "invented forest": ("forest", 11, 256)}
# The run whose instructions are counted: small, and with one thread, so that the count does not depend on who waits for whom.
COUNTED = ("invented village", ["--lods", "2.5", "--emit", "kiln,glb", "--threads", "1"])
# Streams of a manifest below this size are one row: a frame without content has 10 bytes for each tile.
SMALL_STREAM_BYTES = 256
FORMATS = ["--emit", "kiln,glb,usd,3dtiles"]


def run(*words, program=PROGRAM):
    done = subprocess.run([program, *map(str, words)], capture_output=True, text=True, cwd=ROOT, check=False)
    if done.returncode != 0:
        raise RuntimeError(f"citykiln {' '.join(map(str, words))}: {done.stderr.strip()}")
    return done.stdout


# ---- maps ----

def maps(scratch, program=PROGRAM):
    """Yields name and words of compile of each map. The program makes the invented ones in the folder."""
    yield "example town", TOWN
    for name, (kind, seed, side_m) in INVENTED.items():
        folder = scratch / name.replace(" ", "_")
        run("invent", "--kind", kind, "--seed", seed, "--size", side_m, "-o", folder, "--quiet", program=program)
        yield name, ["--spec", folder / "spec.json"]
    if DATA.exists():
        yield "monaco, 360 m", MONACO


# ---- .glb ----

def gltf_of(path):
    """The JSON of a .glb, and its size in bytes."""
    with open(path, "rb") as file:
        size = struct.unpack("<5I", file.read(20))[3]
        return json.loads(file.read(size)), size


def bytes_of_accessors(gltf, numbers):
    accessors = gltf["accessors"]
    return sum(accessors[n]["count"] * BYTES[accessors[n]["componentType"]] * WIDTHS[accessors[n]["type"]] for n in numbers)


def accessors_of(primitive):
    return {*primitive["attributes"].values(), primitive["indices"]}


def layer_of(mesh, primitive):
    return primitive.get("extras", {}).get("layer") or mesh.get("extras", {}).get("layer", "other")


def copies_of_meshes(gltf):
    """How often each mesh stands in the scene."""
    copies = defaultdict(int)
    for node in gltf["nodes"]:
        if "mesh" not in node:
            continue
        instancing = node.get("extensions", {}).get("EXT_mesh_gpu_instancing")
        copies[node["mesh"]] += gltf["accessors"][next(iter(instancing["attributes"].values()))]["count"] if instancing else 1
    return copies


def add_meshes(gltf, rows):
    copies, counted = copies_of_meshes(gltf), defaultdict(set)
    for number, mesh in enumerate(gltf["meshes"]):
        layer = layer_of(mesh, mesh["primitives"][0])
        if copies[number] > 1 or mesh.get("name", "")[-1:].isdigit():
            rows[f"instances of {layer}"] += copies[number]
        for primitive in mesh["primitives"]:
            layer = layer_of(mesh, primitive)
            triangles = gltf["accessors"][primitive["indices"]]["count"] // 3
            rows[f"triangles of {layer}"] += triangles * copies[number]
            rows[f"stored triangles of {layer}"] += triangles
            counted[layer] |= accessors_of(primitive)
    for layer, numbers in counted.items():
        rows[f"bytes of {layer}"] += bytes_of_accessors(gltf, numbers)


def add_glb(path, rows):
    gltf, json_bytes = gltf_of(path)
    rows["bytes"] += path.stat().st_size
    rows["bytes of JSON"] += json_bytes
    rows["bytes of images"] += sum(gltf["bufferViews"][image["bufferView"]]["byteLength"]
                                   for image in gltf.get("images", []) if "bufferView" in image)
    if gltf.get("meshes"):
        add_meshes(gltf, rows)
    for key in ("error_m", "plant_error_m"):
        stated = gltf["asset"].get("extras", {}).get(key) or max((node.get("extras", {}).get(key, 0) for node in gltf["nodes"]), default=0)
        rows[key] = max(rows[key], stated)


# ---- all outputs of a run ----

def rows_of_tiles(out):
    """Returns sums over a level's tiles, and the largest stated errors; zeros are left out."""
    levels = defaultdict(lambda: defaultdict(float))
    for path in sorted((out / "glb").glob("*.glb")):
        if level := re.search(r"_L(\d+)$", path.stem):
            add_glb(path, levels[f"L{level[1]}"])
    return {("glb", level, item): value for level, rows in sorted(levels.items()) for item, value in sorted(rows.items()) if value}


def rows_of_files(out):
    """Returns the bytes of all files but .glb tiles and timing.json, by folder and level."""
    sums = defaultdict(int)
    for path in out.rglob("*"):
        name = path.relative_to(out)
        found = re.search(r"(?:_|^)([LQ]\d+)", path.name)
        is_tile = name.parts[0] == "glb" and found
        if not path.is_file() or is_tile or name.name == "timing.json":
            continue
        level = found[1] if found else ""
        sums[name.parts[0] if len(name.parts) > 1 else name.name, level, "bytes"] += path.stat().st_size
    return dict(sorted(sums.items()))


def rows_of_manifest(out, program):
    described = json.loads(run("inspect", out / "scene.kiln", "--json", program=program))
    rows = defaultdict(int)
    for row in described.get("streams", []):
        name = row["stream"] if row["packed_bytes"] >= SMALL_STREAM_BYTES else "(small ones)"
        rows["scene.kiln", "", f"packed stream {name}"] += row["packed_bytes"]
    return dict(rows)


def rows_of_run(words, scratch, program=PROGRAM):
    """(output, level, item) to value of one compile."""
    out = scratch / "out"
    run("compile", *words, *FORMATS, "-o", out, "--quiet", program=program)
    rows = rows_of_files(out) | rows_of_manifest(out, program) | rows_of_tiles(out)
    subprocess.run(["rm", "-r", out], check=True)
    return {key: int(value) if float(value).is_integer() else round(value, 6) for key, value in rows.items()}


def instructions(words, scratch, program=PROGRAM):
    """The instructions of a compile with one thread, counted by callgrind."""
    command = ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", program, "compile", *map(str, words), *COUNTED[1],
               "-o", str(scratch / "counted"), "--quiet"]
    done = subprocess.run(command, capture_output=True, text=True, cwd=ROOT, check=False)
    found = re.search(r"Collected : (\d+)", done.stderr)
    if done.returncode != 0 or not found:
        raise RuntimeError(f"callgrind: {done.stderr.strip()[-300:]}")
    return int(found[1])


def measured(scratch, program=PROGRAM):
    """(map, output, level, item) to value of all maps. Instructions are counted beside the other runs."""
    table, words_of = {}, dict(maps(scratch, program))
    with ThreadPoolExecutor(1) as beside:
        count = beside.submit(instructions, words_of[COUNTED[0]], scratch, program)
        for name, words in words_of.items():
            table |= {(name, *key): value for key, value in rows_of_run(words, scratch, program).items()}
        table[COUNTED[0], "one thread", "", "instructions"] = count.result()
    return table
