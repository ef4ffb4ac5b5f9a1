"""Runs in Blender: draws a street of a run by Cycles, either as the add-on brings it in, or as Blender's own importer of
glTF does, with a sky as exporters/gltf/howto/blender.md describes it.

blender -b --factory-startup -noaudio --python-exit-code 3 -P draw_blender.py -- JOB.json

A job: `zip` (the add-on, or null), `run` (a folder), `sky` (of report.json), `eye`, `look` (plane metres), `fov_deg`,
`size`, `samples`, `out`.
"""
import json
import math
import sys
from pathlib import Path

import bpy
import mathutils
import numpy

# the importer of Blender 3.4 uses numpy.bool, which newer NumPy no longer has
numpy.bool = bool

HOWTO_EXPOSURE = -4


def import_by_addon(job):
    bpy.ops.preferences.addon_install(filepath=job["zip"], overwrite=True)
    bpy.ops.preferences.addon_enable(module="citykiln")
    bpy.ops.import_scene.citykiln_run(directory=job["run"], level=0)


def import_alone(job):
    for tile in sorted(Path(job["run"]).glob("glb/*_L0.glb")):
        bpy.ops.import_scene.gltf(filepath=str(tile))
    sky_of_howto(job["sky"]["to_sun"])


def sky_of_howto(to_sun):
    """The steps of the how-to."""
    scene = bpy.context.scene
    scene.world = bpy.data.worlds.new("sky")
    scene.world.use_nodes = True
    nodes = scene.world.node_tree
    texture = nodes.nodes.new("ShaderNodeTexSky")
    texture.sun_intensity = 0.5
    texture.sun_elevation, texture.sun_rotation = math.asin(to_sun[2]), math.atan2(to_sun[0], to_sun[1])
    background = nodes.nodes["Background"]
    background.inputs["Strength"].default_value = 2
    nodes.links.new(texture.outputs["Color"], background.inputs["Color"])
    scene.view_settings.exposure = HOWTO_EXPOSURE


def look_from(job):
    scene = bpy.context.scene
    data = bpy.data.cameras.new("camera")
    data.sensor_fit, data.clip_start, data.clip_end = "VERTICAL", 0.1, 6000
    data.angle_y = math.radians(job["fov_deg"])
    camera = bpy.data.objects.new("camera", data)
    camera.location = job["eye"]
    to = mathutils.Vector(job["look"]) - camera.location
    camera.rotation_euler = to.to_track_quat("-Z", "Y").to_euler()
    scene.collection.objects.link(camera)
    scene.camera = camera


def draw(job):
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.samples, scene.cycles.use_denoising = job["samples"], False
    scene.render.resolution_x, scene.render.resolution_y = job["size"]
    scene.render.resolution_percentage = 100
    scene.render.image_settings.color_mode = "RGB"
    scene.render.filepath = job["out"]
    bpy.ops.render.render(write_still=True)


with open(sys.argv[sys.argv.index("--") + 1], encoding="utf-8") as file:
    wanted = json.load(file)
for thing in list(bpy.data.objects):
    bpy.data.objects.remove(thing)
(import_by_addon if wanted["zip"] else import_alone)(wanted)
look_from(wanted)
draw(wanted)
