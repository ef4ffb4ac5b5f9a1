"""Shared by the tests that load tiles into other programs: what a .glb file holds, jobs for the programs, and pictures.

A job is a JSON file that import_blender.py, import_godot.gd and import_three.mjs understand alike:

| key        | value                                                                                                        |
|------------|--------------------------------------------------------------------------------------------------------------|
| `files`    | paths of .glb files, all loaded into one scene                                                               |
| `facts`    | path of a JSON file to write: for each file its meshes, places and materials, as in `facts_of` below         |
| `sun`      | direction towards the sun, y up                                                                              |
| `pictures` | list of `out` (PNG), `eye` and `look` (metres, y up), `fov_deg` (vertical), `size` (pixels), `shown` (names  |
|            | of nodes below the roots; null shows all), `coverage` (true: white where anything is drawn, black elsewhere; |
|            | false: lit by sun and sky), `mipmaps` (false switches them off)                                              |
"""
import importlib.util
import io
import json
import math
import os
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "properties"))
from citykiln_program import TOWN, ProgramTest, run  # noqa: E402
from glb import Glb  # noqa: E402

# Coordinates are on a grid of 2^-10 m; some programs hold them in single precision, 1 km from the plane's origin.
NEAR_M = 2e-4
FOV_DEG = 45
# The sun of the town's time, from azimuth 275 and elevation 35 degrees, y up.
SUN = [-0.816, 0.574, -0.071]
MONACO = ["monaco/monaco-2023.osm.pbf", "monaco/N43E007.hgt"]


def blender():
    return shutil.which("blender")


def pinned_python(module):
    """The Python of the folder build/interop, which has requirements.txt; None where it lacks the module."""
    python = HERE.parent.parent / "build" / "interop" / "bin" / "python"
    if not python.exists() or subprocess.run([python, "-c", f"import importlib.util as u; assert u.find_spec('{module}')"],
                                             capture_output=True, check=False).returncode != 0:
        return None
    return str(python)


def blender_command():
    """The program that runs a script: Blender, or where the argument bpy is given to the test Python with the module bpy; [] where it is
    not installed."""
    if "bpy" in sys.argv:
        return [pinned_python("bpy")] if pinned_python("bpy") else []
    return [blender(), "-b", "--factory-startup", "-noaudio", "--python-exit-code", "3", "-P"] if blender() else []


def godot():
    """The command that runs Godot 3 with a window on a virtual screen, or nothing."""
    if not all(map(shutil.which, ("godot3", "godot3-server", "xvfb-run"))):
        return None
    return ["xvfb-run", "-a", "-s", "-screen 0 1920x1200x24", "godot3", "--video-driver", "GLES3", "--audio-driver", "Dummy"]


def chromium():
    return shutil.which("chromium")


def has_npm(package):
    return shutil.which("node") is not None and (HERE / "node_modules" / package).exists()


def has_pictures():
    """Whether Debian's python3-pil and python3-numpy are installed."""
    return importlib.util.find_spec("PIL") is not None and importlib.util.find_spec("numpy") is not None


def skip_unless(found, message):
    """Ends the test program as skipped."""
    if not found:
        print(f"{message}: skipped")
        sys.exit(77)


# ---- what a file holds -----------------------------------------------------------------------------------------------


def plain_name(name):
    """A name without the number that Blender appends to names that occur twice."""
    return re.sub(r"\.\d{3}$", "", name)


def plain_names(counts):
    plain = {}
    for name, count in counts.items():
        plain[plain_name(name)] = plain.get(plain_name(name), 0) + count
    return plain


def matrix_of(node):
    """A node's matrix by rows, from its translation, rotation and scale."""
    x, y, z, w = node.get("rotation", [0, 0, 0, 1])
    scale = node.get("scale", [1, 1, 1])
    rows = [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]
    return [[value * s for value, s in zip(row, scale)] + [t] for row, t in zip(rows, node.get("translation", [0, 0, 0]))] + [[0, 0, 0, 1]]


def product(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(4)) for j in range(4)] for i in range(4)]


def copies_of(tile, node):
    """The matrices below a node: one, or one for each instance of EXT_mesh_gpu_instancing."""
    extension = node.get("extensions", {}).get("EXT_mesh_gpu_instancing")
    if extension is None:
        return [matrix_of({})]
    rows = {name.lower(): tile.values(accessor) for name, accessor in extension["attributes"].items()
            if name in ("TRANSLATION", "ROTATION", "SCALE")}
    count = len(next(iter(rows.values())))
    return [matrix_of({name: values[i] for name, values in rows.items()}) for i in range(count)]


def facts_of(path, joins_faces=False):
    """The content of a .glb. @param joins_faces  Faces of the same vertices count once, as in Blender, which drops the others.

    The facts are: `meshes` by name, each with `triangles` by material, `low` and `high` (its box); `places` of each mesh, matrices
    by rows in the file's order; `materials`, their names; `pictures`, the size of the base colour's picture by material."""
    tile, places = Glb(path), {}
    gltf = tile.gltf

    def walk(number, above):
        node = gltf["nodes"][number]
        here = product(above, matrix_of(node))
        if "mesh" in node:
            name = gltf["meshes"][node["mesh"]]["name"]
            places.setdefault(name, []).extend(product(here, copy) for copy in copies_of(tile, node))
        for child in node.get("children", []):
            walk(child, here)

    for root in gltf["scenes"][gltf["scene"]]["nodes"]:
        walk(root, matrix_of({}))
    return {"meshes": {mesh["name"]: mesh_facts(tile, mesh, joins_faces) for mesh in gltf["meshes"]}, "places": places,
            "materials": sorted(material["name"] for material in gltf["materials"]),
            "pictures": {material["name"]: size for material in gltf["materials"] if (size := picture_size(tile, material)) is not None}}


def picture_size(tile, material):
    """Columns and rows of a material's base colour picture, or None."""
    from PIL import Image
    shown = material.get("pbrMetallicRoughness", {}).get("baseColorTexture")
    if shown is None:
        return None
    texture = tile.gltf["textures"][shown["index"]]
    source = texture.get("source", texture.get("extensions", {}).get("EXT_texture_webp", {}).get("source"))
    return list(Image.open(io.BytesIO(tile.bytes_of_image(tile.gltf["images"][source]))).size)


def faces_in(tile, primitive, joins_faces):
    """The number of a primitive's triangles; with joins_faces that of sets of three vertices."""
    if not joins_faces:
        return tile.gltf["accessors"][primitive["indices"]]["count"] // 3
    indices = [index for index, in tile.values(primitive["indices"])]
    faces = {frozenset(indices[i:i + 3]) for i in range(0, len(indices), 3)}
    return sum(len(face) == 3 for face in faces)


def mesh_facts(tile, mesh, joins_faces):
    gltf = tile.gltf
    triangles, low, high = {}, [math.inf] * 3, [-math.inf] * 3
    for primitive in mesh["primitives"]:
        name = gltf["materials"][primitive["material"]]["name"]
        triangles[name] = triangles.get(name, 0) + faces_in(tile, primitive, joins_faces)
        box = gltf["accessors"][primitive["attributes"]["POSITION"]]
        low, high = list(map(min, low, box["min"])), list(map(max, high, box["max"]))
    return {"triangles": triangles, "low": low, "high": high}


def triangles_drawn(path):
    """All triangles that a file shows, without names: other programs may leave them out."""
    tile = Glb(path)
    counts = [sum(tile.gltf["accessors"][p["indices"]]["count"] // 3 for p in mesh["primitives"]) for mesh in tile.gltf["meshes"]]
    return sum(counts[node["mesh"]] * len(copies_of(tile, node)) for node in tile.gltf["nodes"] if "mesh" in node)


def triangles_in(facts, only=""):
    """All triangles that a program draws. @param only  Of materials with this in their names."""
    return sum(count * len(facts["places"].get(name, [])) for name, mesh in facts["meshes"].items()
               for material, count in mesh["triangles"].items() if only in material)


def counted_once(facts, instanced):
    """Triangles of meshes that are not instanced, without leaves."""
    return sum(count for name, mesh in facts["meshes"].items() if name not in instanced
               for material, count in mesh["triangles"].items() if "Cutout" not in material)


class ReaderTest(ProgramTest):
    """Tests of what a program says about the tiles that it loaded."""
    # Blender drops the second of two faces with the same vertices, and has a material twice where vertex colours multiply it in some meshes
    is_blender = False

    def assert_same(self, found, path):
        """The program's facts are those of the file, and the counts those of `citykiln inspect`."""
        expected, found = facts_of(path, self.is_blender), {**found, **{key: {plain_name(k): v for k, v in found[key].items()}
                                                       for key in ("meshes", "places", "pictures")}}
        self.assertEqual(len(set(expected["materials"])), len(expected["materials"]), "names of materials are unique")
        self.assertEqual(found["pictures"], expected["pictures"])
        self.assertEqual(sorted(found["meshes"]), sorted(expected["meshes"]))
        for name, mesh in expected["meshes"].items():
            self.assertEqual(plain_names(found["meshes"][name]["triangles"]), mesh["triangles"], name)
            for end in ("low", "high"):
                self.assert_near(found["meshes"][name][end], mesh[end])
        self.assertEqual(sorted(found["places"]), sorted(expected["places"]))
        for name, places in expected["places"].items():
            self.assert_same_places(found["places"][name], places)
        names = map(plain_name, found["materials"])
        self.assertEqual(sorted(set(names) if self.is_blender else names), expected["materials"])
        self.assert_as_inspected(found, path)

    def assert_as_inspected(self, found, path):
        """Triangles and instances are those of `citykiln inspect`, which counts a leaf once: in the file it may have a face for each side."""
        said = json.loads(run("inspect", path, "--json").stdout)
        said_once = sum(n for name, n in said["materials"].items() if "Cutout" not in name)
        if self.is_blender:
            # two buildings may have a face in common
            self.assertAlmostEqual(counted_once(found, said["instanced"]), said_once, delta=1e-3 * said_once)
            return
        self.assertEqual(counted_once(found, said["instanced"]), said_once)
        leaves = triangles_in(found, only="Cutout")
        self.assertLessEqual(triangles_in(found) - leaves / 2, said["triangles"])
        self.assertLessEqual(said["triangles"], triangles_in(found))
        for name, count in said["instanced"].items():
            self.assertEqual(len(found["places"][name]), count)

    def assert_same_places(self, found, expected):
        self.assertEqual(len(found), len(expected))

        def by_place(matrix):
            return [round(matrix[i][3], 2) for i in range(3)]

        for a, b in zip(sorted(found, key=by_place), sorted(expected, key=by_place), strict=True):
            for i in range(3):
                self.assert_near(a[i][:3], b[i][:3], 1e-4)
                self.assert_near(a[i][3:], b[i][3:])

    def assert_near(self, a, b, near=NEAR_M):
        for x, y in zip(a, b, strict=True):
            self.assertLess(abs(x - y), near, (a, b))

    def town(self, name, *arguments):
        """The example town, without the land around it unless the arguments ask for it."""
        around = [] if "--surroundings" in arguments else ["--surroundings", "none"]
        return self.compiled(name, "--spec", TOWN / "spec.json", *arguments, *around)

    def monaco(self, name, *arguments):
        """The tile of Monaco with most buildings."""
        osm, heights = map(self.data, MONACO)
        return self.compiled(name, osm, "--dem", heights, "--only=-1_-1", "--surroundings", "none", *arguments)


# ---- jobs ------------------------------------------------------------------------------------------------------------


def y_up(v):
    return [v[0], v[2], -v[1]]


def picture(out, eye, look, size=(480, 270), shown=None, coverage=False, mipmaps=True):
    """A picture for a job. @param eye, look  In plane metres, z up."""
    return {"out": str(out), "eye": y_up(eye), "look": y_up(look), "fov_deg": FOV_DEG, "size": list(size), "shown": shown,
            "coverage": coverage, "mipmaps": mipmaps}


def write_job(folder, files, pictures=()):
    """Writes a job and returns its path and that of the facts that the program will write."""
    job, facts = Path(folder) / "job.json", Path(folder) / "facts.json"
    job.write_text(json.dumps({"files": [str(path) for path in files], "facts": str(facts), "sun": SUN, "pictures": list(pictures)}))
    return job, facts


def done_by(command, facts, **options):
    """Runs a program on a job and returns its facts and all that it printed. Fails if it writes no facts."""
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False, timeout=3000, **options)
    printed = done.stdout + done.stderr
    if done.returncode != 0 or not Path(facts).exists():
        raise AssertionError(f"{command[0]} returned {done.returncode}: {printed[-3000:]}")
    return json.loads(Path(facts).read_text()), printed


def run_blender(folder, files, pictures=()):
    job, facts = write_job(folder, files, pictures)
    command = [*blender_command(), HERE / "import_blender.py", "--", job]
    # Blender looks for its Python library beside the first python3 on the PATH
    return done_by(command, facts, env={**os.environ, "PATH": "/usr/bin:/bin"})


def run_three(folder, files, pictures=()):
    job, facts = write_job(folder, files, pictures)
    return done_by(["node", HERE / "import_three.mjs", job], facts, cwd=HERE)


def run_godot(folder, files, pictures=()):
    """Godot reads files of its project only: they are copied there, with the files that they share."""
    project = Path(folder) / "project"
    shutil.rmtree(project, ignore_errors=True)
    project.mkdir()
    (project / "project.godot").write_text("config_version=4\n[rendering]\nquality/driver/driver_name=\"GLES3\"\n")
    names = [project / Path(path).name for path in files]
    for path, name in zip(files, names, strict=True):
        shutil.copy(path, name)
        if (Path(path).parent / "shared").exists():
            shutil.copytree(Path(path).parent / "shared", project / "shared", dirs_exist_ok=True)
    import_into(project, [name.name for name in names])
    job, facts = write_job(folder, [f"res://{name.name}" for name in names], pictures)
    return done_by([*godot(), "--path", project, "-s", HERE / "import_godot.gd"], facts, env={**os.environ, "JOB": str(job)})


def import_into(project, names):
    """Lets Godot's editor import the files of a project. It may quit before it has begun, and does not end by itself once it has: it is begun
    again until the last one is written, and then ended."""
    deadline_s = time.monotonic() + 1800
    def is_done():
        return all(list((project / ".import").glob(f"{name}-*.md5")) for name in names)
    with open(project.parent / "import.log", "w", encoding="utf-8") as log:
        while not is_done() and time.monotonic() < deadline_s:
            editor = subprocess.Popen(["godot3-server", "--path", str(project), "--editor", "--quit"], stdout=log, stderr=log)
            while editor.poll() is None and not is_done() and time.monotonic() < deadline_s:
                time.sleep(0.5)
            if editor.poll() is None:
                # lets the editor finish
                time.sleep(2)
                editor.terminate()
                editor.wait()

def pixels(path):
    """The pixels of a picture: rows of columns of RGB in 0 to 1."""
    import numpy
    from PIL import Image
    return numpy.asarray(Image.open(path).convert("RGB"), dtype=float) / 255


def kept(folder):
    """The folder that the environment variable KEEP names, else the one given."""
    return Path(os.environ.get("KEEP", folder))


def coverage_of(path):
    """The share of a coverage picture that is white."""
    return float(pixels(path).mean())


def difference(a, b):
    """The mean difference of two pictures, in 0 to 1, after their mean brightness is made equal."""
    a, b = pixels(a), pixels(b)
    return float(abs(a * (b.mean() / max(a.mean(), 1e-6)) - b).clip(0, 1).mean())


def our_picture(out, level, path, eye, look, size=(480, 270)):
    """Renders a run's folder by `citykiln preview`."""
    comma = lambda v: ",".join(f"{x:.3f}" for x in v)  # noqa: E731
    done = run("preview", out, "--level", level, f"--eye={comma(eye)}", f"--look={comma(look)}", "--fov", FOV_DEG, "--size",
               f"{size[0]}x{size[1]}", "--spp", 32, "-o", path)
    assert done.returncode == 0, done.stderr
    return path
