#!/usr/bin/env python3
"""One street is as bright in Blender, three.js, Godot and CesiumJS as in `citykiln preview`: from one camera, under the
sun and sky that each program has by our add-on, plugin or how-to.

KEEP=FOLDER keeps the pictures, and a mosaic of them."""
import json
import os
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
import readers  # noqa: E402
from citykiln_program import ROOT, TOWN, TOWN_MIDDLE, run  # noqa: E402

SIZE = (640, 360)
SAMPLES = 32
# The brightness of a picture over that of the preview.
LEAST, MOST = 0.85, 1.15
HOWTO = ROOT / "exporters" / "gltf" / "howto"
PLUGIN = ROOT / "exporters" / "godot" / "godot3" / "addons"
GEOID_M = 47


def done(command, **options):
    """Runs a program to its end. Fails with what it printed."""
    made = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False, timeout=1200, **options)
    assert made.returncode == 0, f"{command[0]} returned {made.returncode}: {(made.stdout + made.stderr)[-3000:]}"


def kiln(*arguments):
    made = run(*arguments)
    assert made.returncode == 0, made.stderr
    return made.stdout


class Scene:
    """The street: its manifest, the preview's camera, and folders of tiles for the programs."""

    def __init__(self, folder):
        self.folder = Path(folder)
        kiln("compile", "--spec", TOWN / "spec.json", *TOWN_MIDDLE, "--lods", "0.1", "--surroundings", "none", "--emit", "kiln,glb",
             "--target", "blender", "-o", self.run_for("blender"))
        self.manifest = self.run_for("blender") / "scene.kiln"
        self.sky = json.loads((self.run_for("blender") / "report.json").read_text())["sky"]
        self.picture = self.folder / "preview.png"
        drawn = kiln("preview", self.run_for("blender"), "--level", 0, "--view", "street", "--clouds", "clear", "--size",
                     "{}x{}".format(*SIZE), "--spp", SAMPLES, "--json", "-o", self.picture)
        self.camera = json.loads(drawn.splitlines()[-1])
        self.eye, self.look, self.fov_deg = (self.camera[key] for key in ("eye", "look", "fov_deg"))
        self._draw_layers()

    def run_for(self, target):
        return self.folder / target

    def tiles_for(self, target, *options):
        """The street's tiles, baked for a program."""
        kiln("bake", self.manifest, "--lods", "0.1", "--target", target, "--surroundings", "none", *options, "-o", self.run_for(target))
        return self.run_for(target)

    def job(self, name, place=lambda at: at, **values):
        """Writes a job for a program and returns its path and that of the picture. @param place  Turns plane metres into the program's."""
        path, out = self.folder / f"{name}.json", self.folder / f"{name}.png"
        path.write_text(json.dumps({"eye": place(self.eye), "look": place(self.look), "fov_deg": self.fov_deg, "size": SIZE,
                                    "out": str(out), **values}))
        return path, out

    def _draw_layers(self):
        """Depth and normals of the preview's picture, which tell sky, walls and ground apart."""
        light, depth, up = (self.folder / name for name in ("layers.exr", "depth.tif", "up.tif"))
        place = ["--eye=" + ",".join(map(str, self.eye)), "--look=" + ",".join(map(str, self.look)), "--fov", self.fov_deg]
        kiln("preview", self.run_for("blender"), "--level", 0, *place, "--size", "{}x{}".format(*SIZE), "--spp", 4, "-o", light)
        done(["oiiotool", light, "--ch", "Z", "-d", "float", "-o", depth])
        done(["oiiotool", light, "--ch", "normal.Z", "-d", "float", "-o", up])
        import numpy
        from PIL import Image
        is_sky = ~numpy.isfinite(numpy.asarray(Image.open(depth)))
        up = numpy.asarray(Image.open(up))
        self.parts = {"sky": is_sky, "ground": ~is_sky & (up > 0.9), "walls": ~is_sky & (abs(up) < 0.2)}


class Brightness:
    """The mean of a picture, as stored (sRGB) and as light."""

    def __init__(self, path, parts):
        import numpy
        stored = readers.pixels(path)
        light = numpy.where(stored <= 0.04045, stored / 12.92, ((stored + 0.055) / 1.055) ** 2.4) @ [0.2126, 0.7152, 0.0722]
        self.stored, self.light = float((stored @ [0.2126, 0.7152, 0.0722]).mean()), float(light.mean())
        self.parts = {name: float(light[part].mean()) for name, part in parts.items()}

    def row(self, name, other):
        parts = "  ".join(f"{part} {self.parts[part] / other.parts[part]:.2f}" for part in self.parts)
        return (f"{name:10}  sRGB {self.stored:.3f} ({self.stored / other.stored:.2f})  "
                f"light {self.light:.3f} ({self.light / other.light:.2f})  {parts}")


def draw_blender(scene, zip_path, name):
    job, out = scene.job(name, zip=zip_path and str(zip_path), run=str(scene.run_for("blender")), sky=scene.sky, samples=SAMPLES)
    env = {**os.environ, "PATH": "/usr/bin:/bin", "BLENDER_USER_SCRIPTS": str(scene.folder)}
    done([readers.blender(), "-b", "--factory-startup", "-noaudio", "--python-exit-code", "3", "-P", HERE / "draw_blender.py", "--", job],
         env=env)
    return out


def draw_addon(scene):
    zip_path = scene.folder / "citykiln.zip"
    kiln("addon", "blender", "-o", zip_path)
    return draw_blender(scene, zip_path, "addon")


def draw_import(scene):
    return draw_blender(scene, None, "import")


def draw_page(scene, name, **options):
    """Draws with a page of the how-tos, which loads out/NAME."""
    shutil.copy(HOWTO / f"{name}.html", scene.folder)
    (scene.folder / "out").mkdir(exist_ok=True)
    (scene.folder / "out" / name).symlink_to(scene.run_for(name))
    if not (scene.folder / "node_modules").exists():
        (scene.folder / "node_modules").symlink_to((readers.HERE / "node_modules").resolve())
    job, out = scene.job(name, folder=str(scene.folder), page=f"{name}.html", **options)
    done(["node", HERE / "draw_page.mjs", job], cwd=readers.HERE)
    return out


def draw_three(scene):
    scene.tiles_for("three")
    return draw_page(scene, "three")


def draw_cesium(scene):
    scene.tiles_for("cesium", "--emit", "3dtiles", "--geoid-height", GEOID_M)
    # heights above the ellipsoid
    return draw_page(scene, "cesium", place=lambda at: [at[0], at[1], at[2] + GEOID_M])


def draw_godot(scene):
    out, project = scene.tiles_for("godot"), scene.folder / "project"
    shutil.copytree(PLUGIN, project / "addons")
    (project / "project.godot").write_text("config_version=4\n[rendering]\nquality/driver/driver_name=\"GLES3\"\n")
    done(["godot3-server", "--path", project, "-s", "addons/citykiln/import_run.gd", "--", "--run", out])
    readers.import_into(project, [path.name for path in (out / "glb").glob("*.glb")])
    job, picture = scene.job("godot", place=readers.y_up, scene="res://city/city.tscn")
    done([*readers.godot(), "--path", project, "-s", HERE / "draw_godot.gd"], env={**os.environ, "JOB": str(job)})
    return picture


class Street(readers.ReaderTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        folder = Path(os.environ.get("KEEP", cls.shared_scratch.name)).resolve()
        folder.mkdir(parents=True, exist_ok=True)
        cls.scene = Scene(folder)
        cls.drawn = [cls.scene.picture]
        cls.ours = Brightness(cls.scene.picture, cls.scene.parts)
        cls.rows = [cls.ours.row("preview", cls.ours)]

    @classmethod
    def tearDownClass(cls):
        print("\n".join(cls.rows))
        done(["oiiotool", *cls.drawn, f"--mosaic:pad=4:fit={SIZE[0]}x{SIZE[1]}", f"2x{(len(cls.drawn) + 1) // 2}", "-o",
              cls.scene.folder / "street.png"])

    def assert_as_bright(self, name, draw):
        picture = draw(self.scene)
        found = Brightness(picture, self.scene.parts)
        self.rows.append(found.row(name, self.ours))
        self.drawn.append(picture)
        for ours, theirs in ((self.ours.stored, found.stored), (self.ours.light, found.light)):
            self.assertTrue(LEAST <= theirs / ours <= MOST, found.row(name, self.ours))

    @unittest.skipUnless(readers.blender(), "Blender is missing")
    def test_blender_by_the_addon(self):
        self.assert_as_bright("addon", draw_addon)

    @unittest.skipUnless(readers.blender(), "Blender is missing")
    def test_blender_by_its_own_importer(self):
        self.assert_as_bright("import", draw_import)

    @unittest.skipUnless(readers.chromium() and readers.has_npm("three"), "Chromium or three.js is missing")
    def test_three(self):
        self.assert_as_bright("three", draw_three)

    @unittest.skipUnless(readers.chromium() and readers.has_npm("cesium"), "Chromium or CesiumJS is missing")
    def test_cesium(self):
        self.assert_as_bright("cesium", draw_cesium)

    @unittest.skipUnless(readers.godot(), "Godot is missing")
    def test_godot(self):
        self.assert_as_bright("godot", draw_godot)


if __name__ == "__main__":
    readers.skip_unless(readers.has_pictures(), "python3-pil or python3-numpy is missing")
    unittest.main(verbosity=2)
