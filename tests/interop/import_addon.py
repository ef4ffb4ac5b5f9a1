"""Runs in Blender, or in Python with Blender as the module bpy: installs the add-on from its zip, runs its commands, and writes what
came of each.

A job is a JSON file: `zip`, `facts` (a file to write) and `steps`, each with `command`, `options`, and `is_new` (in a scene of its own).
Commands: "run" and "map" import; "light" sets properties of the scene's light; "finer" and "bake" are the panel's buttons, "finer" with an
object of the tile `tile` selected. The facts of a step are {"error": the message}, or those of `facts_of`.
"""
import json
import os
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
    if "camera" in options:
        add_camera(options.pop("camera"))
    options = {name: set(value) if isinstance(value, list) else value for name, value in options.items()}
    try:
        COMMANDS[step["command"]](options)
    except RuntimeError as error:
        return {"error": str(error).strip().removeprefix("Error: ")}
    bpy.context.view_layer.update()
    made = [each for each in bpy.context.scene.collection.children if "citykiln_folder" in each]
    return facts_of(made[-1]) | {"runs": len(made), "world": facts_of_world(bpy.context.scene)}


def set_light(options):
    for name, value in options.items():
        setattr(bpy.context.scene.citykiln, name, value)


def refine(options):
    tile = options.pop("tile")
    for thing in bpy.context.scene.objects:
        thing.select_set(False)
    [group] = [each for each in bpy.context.scene.collection.children_recursive if each.get("citykiln_tile") == tile]
    next(thing for thing in group.all_objects if thing.type == "MESH").select_set(True)
    bpy.ops.scene.citykiln_finer(**options)


COMMANDS = {"run": lambda options: bpy.ops.import_scene.citykiln_run(**options), "light": set_light, "finer": refine,
            "map": lambda options: bpy.ops.import_scene.citykiln_map(**options), "bake": lambda options: bpy.ops.scene.citykiln_bake(**options)}


def add_camera(place):
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.location = place
    bpy.context.scene.collection.objects.link(camera)
    bpy.context.scene.camera = camera
    bpy.context.view_layer.update()


def facts_of(collection):
    meshes = [thing for thing in collection.all_objects if thing.type == "MESH"]
    tiles = [tile for tile in collection.children if "level" in tile]
    return {"tiles": {f"{tile['citykiln_tile']}_L{tile['level']}": facts_of_tile(tile) for tile in tiles},
            "layers": sorted({layer.name.split()[-1] for tile in collection.children for layer in tile.children}),
            "lights": sum(thing.type == "LIGHT" for thing in collection.all_objects),
            "materials": len({material.name for thing in meshes for material in thing.data.materials}),
            "all_materials": len(bpy.data.materials), "shown": [facts_of_material(m) for m in bpy.data.materials if "citykiln_key" in m],
            "black": [m.name for thing in meshes for m in thing.data.materials if sees_no_colours(thing.data, m)],
            "lit": [not (group.hide_render or group.hide_viewport) for group in collection.children_recursive if "citykiln_lamps" in group],
            "meshes": len({thing.data.name for thing in meshes})}


def facts_of_tile(tile):
    things = [thing for thing in tile.all_objects if thing.type == "MESH"]
    merged = [thing for thing in things if "features" in thing.data]
    buildings = [thing for thing in things if thing.users_collection[0].name.split(".")[0].endswith(" buildings") and thing not in merged]
    low, high = box_of(things)
    return {"triangles": sum(len(thing.data.polygons) for thing in things), "instances": len(things) - len(merged) - len(buildings),
            "tolerance_m": tile["tolerance_m"], "buildings": [facts_of_building(thing) for thing in buildings], "low": low, "high": high,
            "copies": [{"of_mesh": thing.data.name, "is": thing.name} | {key: str(value) for key, value in thing.items()}
                       for thing in things if thing not in merged and thing not in buildings],
            "merged": {thing.name.split(".")[0].split()[-1]: facts_of_merged(thing.data) for thing in merged}}


def facts_of_building(thing):
    """Its facts, and the box about its origin."""
    facts = {key: str(value) for key, value in thing.items()}
    return facts | {"is": thing.name, "low": list(thing.bound_box[0]), "high": list(thing.bound_box[6]), "at": list(thing.location)}


def facts_of_material(material):
    return {"name": material.name, "colour": list(material.diffuse_color)}


def sees_no_colours(mesh, material):
    """Whether a material reads colours of vertices that the mesh does not have, which Blender shows as black."""
    reads = any(node.type == "VERTEX_COLOR" for node in material.node_tree.nodes)
    return reads and "Color" not in mesh.attributes


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
            "to_sun": [list(sun.matrix_world.to_quaternion() @ mathutils.Vector((0, 0, 1))) for sun in suns],
            "is_sun_shown": [not sun.hide_render for sun in suns], "exposure": scene.view_settings.exposure,
            "skies": sum(world.name.startswith("citykiln") and world.users > 0 for world in bpy.data.worlds),
            "camera": facts_of_camera(scene.camera), "views": [space.clip_end for screen in bpy.data.screens for area in screen.areas
                                                                for space in area.spaces if space.type == "VIEW_3D"]}


def facts_of_camera(camera):
    return camera and {"at": list(camera.location), "clip_end": camera.data.clip_end,
                       "forward": list(camera.matrix_world.to_quaternion() @ mathutils.Vector((0, 0, -1)))}


with open(sys.argv[sys.argv.index("--") + 1], encoding="utf-8") as file:
    job = json.load(file)
if bpy.app.version < (4, 2):
    bpy.ops.preferences.addon_install(filepath=job["zip"], overwrite=True)
    bpy.ops.preferences.addon_enable(module="citykiln")
else:
    # by blender_manifest.toml
    bpy.ops.extensions.package_install_files(repo="user_default", filepath=job["zip"], enable_on_install=True)
found = [done(step) for step in job["steps"]]
with open(job["facts"], "w", encoding="utf-8") as out:
    json.dump(found, out)
if not bpy.app.binary_path:
    # bpy 4.2 as a module ends with a segmentation fault once any operator with a property is registered
    sys.stdout.flush()
    os._exit(0)
