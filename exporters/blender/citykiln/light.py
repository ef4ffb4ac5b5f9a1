"""The light of a scene: time, sun, exposure and lamps as properties of the scene, which can be turned and animated."""
import math

import bpy
import mathutils
from bpy.props import BoolProperty, EnumProperty, FloatProperty, IntProperty

from .exposure import TRANSFORMS, exposure_stops
from .scene_origin import origin_of
from .sky_world import direction_of, set_first, turn_sky, turn_sun
from .sun_position import sun_direction

# of a collection of lamps
LAMPS = "citykiln_lamps"
# the sun's height at which street lamps are lit: are_lamps_lit of compiler/sky/recipe.h
LIT_BELOW_SINE = -0.06976
LAMP_ITEMS = [("AUTO", "By the Sun", "Lit while the sun is 4 degrees below the horizon"), ("ON", "On", "Lit at any time"),
              ("OFF", "Off", "Never lit")]
# nonempty while properties are set together
held = []


def turn_time(light, context):
    """The time was changed: the sun goes where it then stands."""
    if held or origin_of(light.id_data) is None:
        return
    at = sun_direction(light.year, light.month, light.day, light.hour, *origin_of(light.id_data))
    set_sun(light, mathutils.Vector(at))
    apply_light(light.id_data)


def turn_light(light, context):
    if not held:
        apply_light(light.id_data)


def set_sun(light, to_sun):
    held.append(light)
    light.sun_elevation, light.sun_azimuth = math.asin(max(-1, min(to_sun.z, 1))), math.atan2(to_sun.x, to_sun.y) % (2 * math.pi)
    held.pop()


class CitykilnLight(bpy.types.PropertyGroup):
    """Light of the scene; Scene.citykiln."""
    is_set: BoolProperty(default=False, options={"HIDDEN"})
    year: IntProperty(name="Year", default=2026, min=1950, max=2050, update=turn_time)
    month: IntProperty(name="Month", default=6, min=1, max=12, update=turn_time)
    day: IntProperty(name="Day", default=21, min=1, max=31, update=turn_time)
    hour: FloatProperty(name="Hour (UTC)", default=12, min=0, max=24, step=25, update=turn_time)
    sun_elevation: FloatProperty(name="Sun Elevation", subtype="ANGLE", default=0.8, min=-math.pi / 2, max=math.pi / 2, update=turn_light)
    sun_azimuth: FloatProperty(name="Sun Azimuth", subtype="ANGLE", description="From north to east", default=math.pi, update=turn_light)
    exposure: FloatProperty(name="Exposure", description="Stops, on top of the preview's adaptation to the sun's height", default=0,
                            min=-10, max=10, update=turn_light)
    lamps: EnumProperty(name="Lamps", items=LAMP_ITEMS, default="AUTO", update=turn_light)
    turbidity: FloatProperty(name="Turbidity", description="Haze: 2 is clear, 10 is hazy", default=2.6, min=1.9, max=10, update=turn_light)
    ground_m: FloatProperty(options={"HIDDEN"})


def light_of_run(scene, run):
    """Gives the scene the light of the run's time. Returns notes for the user."""
    if run.sky is None:
        return ["report.json has no sky, so the world stays as it is: compile the map again"]
    light = scene.citykiln
    held.append(light)
    date, _, clock = run.sky["time"].partition("T")
    light.year, light.month, light.day = map(int, date.split("-"))
    hour, minute = clock.split(":")[:2]
    light.hour = int(hour) + int(minute[:2]) / 60
    light.turbidity, light.ground_m, light.is_set = run.sky["turbidity"], run.sky["ground_m"], True
    held.pop()
    set_sun(light, mathutils.Vector(run.sky["to_sun"]))
    set_first(scene.view_settings, "view_transform", TRANSFORMS)
    return []


def apply_light(scene):
    """Sets sun, sky, exposure and lamps by the scene's properties. Without a run's light in the scene, nothing."""
    light = scene.citykiln
    if not light.is_set:
        return
    to_sun = direction_of(light.sun_elevation, light.sun_azimuth)
    turn_sky(scene, to_sun, light.turbidity, light.ground_m)
    turn_sun(scene, to_sun, light.turbidity)
    transform = scene.view_settings.view_transform
    scene.view_settings.exposure = light.exposure + exposure_stops(transform if transform in TRANSFORMS else "Filmic", to_sun.z)
    switch_lamps(scene, light.lamps == "ON" or light.lamps == "AUTO" and to_sun.z < LIT_BELOW_SINE)


def switch_lamps(scene, are_lit):
    """Lamps that are off are hidden, so that they cost a render nothing."""
    for collection in scene.collection.children_recursive:
        if LAMPS in collection:
            collection.hide_render = collection.hide_viewport = not are_lit


@bpy.app.handlers.persistent
def turn_animated(scene, *_):
    """Follows keyframes: Blender does not call updates of animated properties."""
    if scene.citykiln.is_set and scene.animation_data and scene.animation_data.action:
        curves = {curve.data_path for curve in scene.animation_data.action.fcurves}
        if any(path.startswith("citykiln.") for path in curves):
            (turn_time if any(path in TIMES for path in curves) else turn_light)(scene.citykiln, None)


TIMES = {f"citykiln.{name}" for name in ("year", "month", "day", "hour")}


def register():
    bpy.types.Scene.citykiln = bpy.props.PointerProperty(type=CitykilnLight)
    bpy.app.handlers.frame_change_post.append(turn_animated)


def unregister():
    bpy.app.handlers.frame_change_post.remove(turn_animated)
    del bpy.types.Scene.citykiln
