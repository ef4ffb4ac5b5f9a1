"""File > Import > citykiln run: chooses the folder of a run, and what of it is imported."""
import bpy
from bpy.props import BoolProperty, EnumProperty, FloatProperty, IntProperty, StringProperty

from .bring_in import Wishes, bring_in
from .choice import Choice
from .run_folder import LAYERS, GlbError, RunError

LAYER_ITEMS = [(name, name.capitalize(), "", 1 << i) for i, name in enumerate(LAYERS)]


class Wanted:
    """The options that both commands of the menu share."""
    level: IntProperty(name="Level", default=0, min=0, description="0 is the finest level of detail of the run")
    by_distance: BoolProperty(name="Levels by Distance", default=False,
                              description="Each tile at the coarsest level whose error is small on the picture of the scene's camera")
    pixel_error: FloatProperty(name="Error in Pixels", default=1, min=0.1, max=100,
                               description="Largest error on the camera's picture, for levels by distance")
    layers: EnumProperty(name="Layers", items=LAYER_ITEMS, options={"ENUM_FLAG"}, default=set(LAYERS))
    lamps: BoolProperty(name="Lamps as Lights", default=True,
                        description="Street lamps as lights, where the run has them (compile --lights); off while the sun is up")
    buildings: BoolProperty(name="Single Buildings", default=True,
                            description="Each building as an object of its own, whose origin is its middle at the ground; else one mesh")
    sky: BoolProperty(name="Sun and Sky", default=True, description="The sun and the sky of the run's time, as the scene's world")
    surroundings: BoolProperty(name="Surroundings", default=True, description="The land around the map, with all of its tiles")
    clouds: BoolProperty(name="Clouds", default=True, description="Clouds, where the run has them")
    view: BoolProperty(name="Camera and View", default=True,
                       description="A camera, where the scene has none, and views that show the whole run")

    def wishes(self, **choice):
        return Wishes(Choice(level=self.level, **choice), self.by_distance, self.pixel_error, set(self.layers), self.lamps,
                      self.buildings, self.sky, self.surroundings, self.clouds, self.view)

    def draw_wanted(self, layout):
        layout.prop(self, "by_distance")
        layout.prop(self, "pixel_error" if self.by_distance else "level")
        layout.column().prop(self, "layers")
        for name in ("buildings", "lamps", "sky", "surroundings", "clouds", "view"):
            layout.prop(self, name)


class IMPORT_SCENE_OT_citykiln_run(bpy.types.Operator, Wanted):
    """Import the tiles of a run of citykiln"""
    bl_idname = "import_scene.citykiln_run"
    bl_label = "Import citykiln Run"
    bl_options = {"REGISTER", "UNDO"}

    __annotations__ = Wanted.__annotations__ | {
        "directory": StringProperty(name="Folder", subtype="DIR_PATH", description="The folder of a run, with report.json"),
        "filter_folder": BoolProperty(default=True, options={"HIDDEN"}),
        "tiles": StringProperty(name="Tiles", description="Tiles to import, such as 0_0, -1_2; empty: all"),
        "box": StringProperty(name="Box", description="Tiles in a box: west,south,east,north in degrees; empty: all")}

    def invoke(self, context, event):
        context.window_manager.fileselect_add(self)
        return {"RUNNING_MODAL"}

    def draw(self, context):
        self.draw_wanted(self.layout)
        self.layout.prop(self, "tiles")
        self.layout.prop(self, "box")

    def execute(self, context):
        return finish(self, context, self.directory, self.wishes(tiles=self.tiles, box_deg=self.box))


def finish(operator, context, folder, wishes):
    """Imports a run and shows the result, or an error as Blender shows them."""
    manager = context.window_manager
    manager.progress_begin(0, 1)
    try:
        operator.report({"INFO"}, bring_in(context, folder, wishes, manager.progress_update))
    except (RunError, GlbError) as error:
        operator.report({"ERROR"}, str(error))
        return {"CANCELLED"}
    finally:
        manager.progress_end()
    return {"FINISHED"}
