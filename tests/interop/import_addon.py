"""Runs in Blender: installs the add-on from its zip, runs its commands, and writes what came of each.

A job is a JSON file: `zip`, `facts` (a file to write) and `steps`, each with `command` ("run" or "map"), `options`, and `is_new` (in a
scene of its own). The facts of a step are {"error": the message}, or those of `facts_of`.
"""
import json
import sys

import bpy
import mathutils
import numpy


def begin_scene():
    bpy.context.window.scene = bpy.data.scenes.new("test")


def done(step):
    """The result of a step."""
    if step["is_new"]:
        begin_scene()
    options = dict(step["options"])
    before = set(bpy.context.scene.collection.children)
    if "camera" in options:
        add_camera(options.pop("camera"))
    options = {name: set(value) if isinstance(value, list) else value for name, value in options.items()}
    try:
        getattr(bpy.ops.import_scene, f"citykiln_{step['command']}")(**options)
    except RuntimeError as error:
        return {"error": str(error).strip().removeprefix("Error: ")}
    bpy.context.view_layer.update()
    [made] = [each for each in bpy.context.scene.collection.children if each not in before]
    return facts_of(made) | {"world": facts_of_world(bpy.context.scene)}


def add_camera(place):
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.location = place
    bpy.context.scene.collection.objects.link(camera)
    bpy.context.scene.camera = camera
    bpy.context.view_layer.update()


def facts_of(collection):
    meshes = [thing for thing in collection.all_objects if thing.type == "MESH"]
    # Blender adds .001 to names of other scenes
    return {"tiles": {tile.name.partition(".")[0]: facts_of_tile(tile) for tile in collection.children},
            "layers": sorted({layer.name.split()[-1] for tile in collection.children for layer in tile.children}),
            "lights": sum(thing.type == "LIGHT" for thing in collection.all_objects),
            "materials": len({material.name for thing in meshes for material in thing.data.materials}),
            "all_materials": len(bpy.data.materials), "meshes": len({thing.data.name for thing in meshes})}


def facts_of_tile(tile):
    things = [thing for thing in tile.all_objects if thing.type == "MESH"]
    merged = [thing for thing in things if "features" in thing.data]
    low, high = box_of(things)
    return {"triangles": sum(len(thing.data.polygons) for thing in things), "instances": len(things) - len(merged),
            "low": low, "high": high,
            "copies": [{key: str(value) for key, value in thing.items()} for thing in things if thing not in merged][:500],
            "merged": {thing.name.split()[-1]: facts_of_merged(thing.data) for thing in merged}}


def box_of(things):
    """The least and the largest coordinates of the vertices."""
    boxes = []
    for thing in things:
        at = numpy.empty(3 * len(thing.data.vertices), numpy.float32)
        thing.data.vertices.foreach_get("co", at)
        turned = at.reshape(-1, 3) @ numpy.array(thing.matrix_world.to_3x3()).T + numpy.array(thing.matrix_world.translation)
        boxes.append((turned.min(axis=0), turned.max(axis=0)))
    return numpy.min([low for low, _ in boxes], axis=0).tolist(), numpy.max([high for _, high in boxes], axis=0).tolist()


def facts_of_merged(mesh):
    """The rows of its faces, the facts of each row, and the share of faces whose corners have the face's normal."""
    rows = numpy.empty(len(mesh.polygons), numpy.int32)
    mesh.attributes["feature"].data.foreach_get("value", rows)
    return {"rows": rows.tolist(), "features": json.loads(mesh["features"]), "has_normals": mesh.has_custom_normals}


def facts_of_world(scene):
    suns = [thing for thing in scene.collection.objects if thing.type == "LIGHT" and thing.data.type == "SUN"]
    return {"name": scene.world.name if scene.world else None,
            "to_sun": [list(sun.matrix_world.to_quaternion() @ mathutils.Vector((0, 0, 1))) for sun in suns]}


with open(sys.argv[sys.argv.index("--") + 1], encoding="utf-8") as file:
    job = json.load(file)
bpy.ops.preferences.addon_install(filepath=job["zip"], overwrite=True)
bpy.ops.preferences.addon_enable(module="citykiln")
found = [done(step) for step in job["steps"]]
with open(job["facts"], "w", encoding="utf-8") as out:
    json.dump(found, out)
