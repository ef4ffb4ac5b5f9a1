"""File > Import > citykiln map: compiles a map with the installed program, and imports the result."""
from pathlib import Path

import bpy
from bpy.props import EnumProperty, StringProperty
from bpy_extras.io_utils import ImportHelper

from .import_run import Wanted, finish
from .program import Job, compile_command, found_program
from .run_folder import RunError

TARGETS = [("blender", "Blender", "Flat faces without normals: imports fastest"),
           ("generic", "Generic", "Nothing that another program may lack")]
STEP_S = 0.2


class CitykilnPreferences(bpy.types.AddonPreferences):
    bl_idname = __package__
    program: StringProperty(name="Program", subtype="FILE_PATH", description="The citykiln program; empty: the one on the PATH")

    def draw(self, context):
        self.layout.prop(self, "program")


def program_of(context, path):
    """The program at a path, else that of the preferences. Error: there is none."""
    addon = context.preferences.addons.get(__package__)
    return found_program(path or (addon.preferences.program if addon else ""))


class IMPORT_SCENE_OT_citykiln_map(bpy.types.Operator, ImportHelper, Wanted):
    """Compile an OpenStreetMap extract by citykiln and import its tiles"""
    bl_idname = "import_scene.citykiln_map"
    bl_label = "Import citykiln Map"
    bl_options = {"REGISTER", "UNDO"}

    __annotations__ = ImportHelper.__annotations__ | Wanted.__annotations__ | {
        "filter_glob": StringProperty(default="*.osm;*.pbf;*.gz;*.bz2", options={"HIDDEN"}),
        "heightmaps": StringProperty(name="Heightmaps", description="Files or folders of heightmaps, with ; between them; empty: level land"),
        "box": StringProperty(name="Box", description="west,south,east,north in degrees; empty: the whole map"),
        "target": EnumProperty(name="Target", items=TARGETS),
        "options": StringProperty(name="Options", description="Further options of citykiln compile, such as --edits mends.edits"),
        "out": StringProperty(name="Folder", description="The run's folder; empty: a folder beside the map, with its name"),
        "program": StringProperty(name="Program", options={"HIDDEN", "SKIP_SAVE"})}

    def draw(self, context):
        for name in ("heightmaps", "box", "target", "options", "out"):
            self.layout.prop(self, name)
        self.draw_wanted(self.layout)

    def execute(self, context):
        try:
            self.job = self._start(context)
        except RunError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        if bpy.app.background:
            return self._finish(context)
        self.timer = context.window_manager.event_timer_add(STEP_S, window=context.window)
        context.window_manager.modal_handler_add(self)
        context.window_manager.progress_begin(0, 1)
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        """Shows the program's bar until it ends, or until Esc is pressed."""
        if event.type == "ESC":
            self.job.stop()
            self._end_bar(context)
            self.report({"INFO"}, "citykiln was stopped; its folder is as it was")
            return {"CANCELLED"}
        if event.type == "TIMER":
            context.window_manager.progress_update(self.job.share)
            context.workspace.status_text_set(f"citykiln: {self.job.stage} {self.job.share:.0%} (Esc stops it)")
            if not self.job.is_running():
                self._end_bar(context)
                return self._finish(context)
        return {"PASS_THROUGH"}

    def _start(self, context):
        """Starts the program. Errors: RunError."""
        map_path = Path(bpy.path.abspath(self.filepath))
        if not map_path.is_file():
            raise RunError(f"{map_path}: there is no such map")
        program = program_of(context, self.program)
        self.folder = self.out or str(map_path.parent / map_path.name.split(".")[0])
        heightmaps = [each.strip() for each in self.heightmaps.split(";") if each.strip()]
        return Job([*compile_command(program, str(map_path), heightmaps, self.box, self.target, self.folder), *self.options.split()])

    def _finish(self, context):
        try:
            self.job.check()
        except RunError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return finish(self, context, self.folder, self.wishes())

    def _end_bar(self, context):
        context.window_manager.event_timer_remove(self.timer)
        context.window_manager.progress_end()
        context.workspace.status_text_set(None)
