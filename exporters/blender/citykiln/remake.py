"""Bakes a run again with other settings, or the tiles of selected objects more finely, and imports the result in their place."""
from pathlib import Path

import bpy
from bpy.props import StringProperty

from .bring_in import File, add_finer, bring_in, wishes_of
from .choice import Choice
from .earlier_run import FOLDER, TILE_KEY
from .import_map import program_of
from .import_run import finish
from .program import Job
from .run_folder import Run, RunError


def run_collection(scene):
    """The run that was imported last. Error: the scene has none."""
    found = [each for each in scene.collection.children if FOLDER in each]
    if not found:
        raise RunError("the scene has no run of citykiln: import one first")
    return found[-1]


def chosen_groups(scene, things):
    """The collections of the tiles of objects, with that of their run."""
    return [(run, group) for run in scene.collection.children if FOLDER in run for group in run.children
            if "level" in group and any(thing.name in group.all_objects for thing in things)]


def manifest_of(folder):
    """Error: the run was written without it."""
    path = Path(folder) / "scene.kiln"
    if not path.is_file():
        raise RunError(f"{path}: is missing; compile the map again with --emit kiln,glb")
    return path


def bake(program, *words):
    """Runs `citykiln bake` to its end. Error: its own line."""
    Job([program, "bake", *map(str, words)]).check()


def as_run(run):
    """The options by which a run's tiles were baked."""
    words = ["--target", run.report.get("target", "generic"), "--split", run.report.get("split", "layer")]
    return words + (["--lights", run.report["lights"]] if run.report.get("lights") else [])


class SCENE_OT_citykiln_bake(bpy.types.Operator):
    """Bake the run again with other settings, and import it in its place"""
    bl_idname = "scene.citykiln_bake"
    bl_label = "Bake Run Again"
    bl_options = {"REGISTER", "UNDO"}
    __annotations__ = {
        "lods": StringProperty(name="Levels", default="0.5,2.5", description="Largest errors in metres, finest first"),
        "options": StringProperty(name="Options", description="Further options of citykiln bake, such as --layers=-yards --lights 100"),
        "out": StringProperty(name="Folder", description="The new run's folder; empty: beside the old one, with _again"),
        "program": StringProperty(name="Program", options={"HIDDEN", "SKIP_SAVE"})}

    def invoke(self, context, event):
        return context.window_manager.invoke_props_dialog(self)

    def execute(self, context):
        try:
            old = run_collection(context.scene)
            run = Run(old[FOLDER])
            folder = self.out or str(run.folder).removesuffix("_again") + "_again"
            bake(program_of(context, self.program), manifest_of(run.folder), "--lods", self.lods, *as_run(run), *self.options.split(),
                 "--emit", "kiln,glb", "-o", folder)
        except RunError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        # the new run takes the old one's place
        old[FOLDER] = str(Path(folder).resolve())
        return finish(self, context, folder, wishes_of(old, has_view=False, has_sky=False))


class SCENE_OT_citykiln_finer(bpy.types.Operator):
    """Import the tiles of the selected objects at the next finer level; a level that the run lacks is baked"""
    bl_idname = "scene.citykiln_finer"
    bl_label = "Finer Level for Selected"
    bl_options = {"REGISTER", "UNDO"}
    __annotations__ = {"program": StringProperty(name="Program", options={"HIDDEN", "SKIP_SAVE"})}

    def execute(self, context):
        try:
            groups = chosen_groups(context.scene, context.selected_objects)
            if not groups:
                raise RunError("no object of a tile is selected")
            for collection, group in groups:
                self._refine(context, collection, group)
        except RunError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return {"FINISHED"}

    def _refine(self, context, collection, group):
        """Replaces one tile."""
        run, key, level = Run(collection[FOLDER]), group[TILE_KEY], group["level"]
        if level > 0:
            bring_in(context, run.folder, wishes_of(collection, choice=Choice(level=level - 1, tiles=key), has_view=False, has_sky=False))
            return
        tolerance_m = group["tolerance_m"] / 2
        path = run.folder / "finer" / f"{key}_{tolerance_m:g}m.glb"
        if not path.is_file():
            path.parent.mkdir(exist_ok=True)
            # = because a tile's name may begin with a minus
            bake(program_of(context, self.program), manifest_of(run.folder), f"--tile={key}", "--tolerance", f"{tolerance_m:g}",
                 *as_run(run), "-o", path)
        add_finer(context, run, File(key, f"Tile {key}, {tolerance_m:g} m", path, 0))
