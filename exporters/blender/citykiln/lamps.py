"""Blender's lights of street lamps, from KHR_lights_punctual."""
import math

import bpy

# of light of 555 nm, by which Blender's importer of glTF converts too
LUMEN_PER_WATT = 683
# of a lamp's glass
RADIUS_M = 0.15


def light_of(glb, number, made):
    """The light of this number of a file. Equal lights are one. @param made  Lights by their values."""
    values = glb.gltf["extensions"]["KHR_lights_punctual"]["lights"][number]
    key = repr(sorted(values.items(), key=str))
    if key not in made:
        made[key] = make_light(values)
    return made[key]


def make_light(values):
    light = bpy.data.lights.new(values.get("name", "Lamp"), values["type"].upper())
    light.color = values.get("color", [1, 1, 1])
    # candela are of one direction, Blender's watts of all
    light.energy = values.get("intensity", 1) * 4 * math.pi / LUMEN_PER_WATT
    light.shadow_soft_size = RADIUS_M
    if values["type"] == "spot":
        light.spot_size = 2 * values["spot"].get("outerConeAngle", math.pi / 4)
        light.spot_blend = 1 - values["spot"].get("innerConeAngle", 0) / values["spot"].get("outerConeAngle", math.pi / 4)
    return light
