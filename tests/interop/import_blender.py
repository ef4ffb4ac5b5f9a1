"""Runs inside Blender: imports .glb files, writes facts about the imported objects as JSON, and renders pictures. The form of a job is
in readers.py.

blender -b --factory-startup -noaudio --python-exit-code 3 -P import_blender.py -- JOB.json
"""
import json
import math
import os
import sys
import time

import bpy
import mathutils
import numpy

# the importer of Blender 3.4 uses numpy.bool, which newer NumPy no longer has
numpy.bool = bool

# glTF's axes (y up) from Blender's (z up)
Y_UP = mathutils.Matrix(((1, 0, 0, 0), (0, 0, 1, 0), (0, -1, 0, 0), (0, 0, 0, 1)))


def z_up(v):
    return mathutils.Vector((v[0], -v[2], v[1]))


def column(collection, name, width, kind=numpy.float32):
    """A property of all elements of a collection, as an array of rows."""
    values = numpy.empty(len(collection) * width, dtype=kind)
    collection.foreach_get(name, values)
    return values.reshape(-1, width) if width > 1 else values


def facts_of_mesh(mesh):
    """Triangles by material, and the box in glTF's axes."""
    counts = numpy.bincount(column(mesh.polygons, "material_index", 1, numpy.int32), minlength=len(mesh.materials))
    assert (column(mesh.polygons, "loop_total", 1, numpy.int32) == 3).all(), "a face is no triangle"
    triangles = {}
    for material, count in zip(mesh.materials, counts):
        triangles[material.name] = triangles.get(material.name, 0) + int(count)
    corners = column(mesh.vertices, "co", 3)[:, [0, 2, 1]] * numpy.array([1, 1, -1])
    return {"triangles": triangles, "low": corners.min(axis=0).tolist(), "high": corners.max(axis=0).tolist(), "users": mesh.users}


def facts_of_faces(thing):
    """For each material of an object the range of heights, and the area seen from above, in m2."""
    mesh = thing.data
    normals, areas = column(mesh.polygons, "normal", 3), column(mesh.polygons, "area", 1)
    return {"name": thing.name, "area_seen_from_above_m2": float((areas * normals[:, 2]).sum()),
            "normals_not_opposite": normals_not_opposite(mesh, normals)}


def normals_not_opposite(mesh, face_normals):
    """The share of corners whose normal is less than 120 degrees from that of their face."""
    if bpy.app.version < (4, 1):  # later versions keep them
        mesh.calc_normals_split()
    corner_normals = column(mesh.loops, "normal", 3)
    starts = column(mesh.polygons, "loop_start", 1, numpy.int32)
    dots = [(corner_normals[starts + i] * face_normals).sum(axis=1) for i in range(3)]
    return float((numpy.array(dots) > -0.5).mean())


def nodes_behind(socket):
    """All shader nodes upstream of an input."""
    return [node for link in socket.links for node in [link.from_node] + [n for i in link.from_node.inputs for n in nodes_behind(i)]]


def material_facts(material):
    """The base colour's picture, or its constant; and the roughness."""
    shader = material.node_tree.nodes["Principled BSDF"]
    behind = nodes_behind(shader.inputs["Base Color"])
    facts = {"roughness": shader.inputs["Roughness"].default_value, "alpha": material.blend_method,
             "roughness_is_picture": any(n.type == "TEX_IMAGE" for n in nodes_behind(shader.inputs["Roughness"]))}
    for picture in [node for node in behind if node.type == "TEX_IMAGE"][:1]:
        facts |= {"picture_px": list(picture.image.size), "has_pixels": len(picture.image.pixels) > 0}
        for mapping in [node for node in nodes_behind(picture.inputs["Vector"]) if node.type == "MAPPING"]:
            facts |= {"scale": list(mapping.inputs["Scale"].default_value), "location": list(mapping.inputs["Location"].default_value)}
    constants = [list(i.default_value)[:3] for node in behind for i in node.inputs if i.type == "RGBA" and not i.is_linked]
    if not behind:
        constants = [list(shader.inputs["Base Color"].default_value)[:3]]
    return facts | {"colours": constants}


def corners_of(mesh):
    """For each material the corners: position, and texture coordinates from the picture's lower left corner."""
    by_material = {}
    for polygon in mesh.polygons:
        row = by_material.setdefault(mesh.materials[polygon.material_index].name, [])
        for loop in polygon.loop_indices:
            row.append([list(mesh.vertices[mesh.loops[loop].vertex_index].co), list(mesh.uv_layers[0].data[loop].uv)])
    return by_material


def facts_of(path):
    """Imports one file into the scene. Facts are of what the import added."""
    before = {kind: set(getattr(bpy.data, kind)) for kind in ("objects", "meshes", "materials", "images")}
    start_s = time.process_time()
    answer = bpy.ops.import_scene.gltf(filepath=path)
    if answer != {"FINISHED"}:
        raise RuntimeError(f"{path}: the import returns {answer}")
    bpy.context.view_layer.update()
    cpu_s = time.process_time() - start_s
    new = {kind: [thing for thing in getattr(bpy.data, kind) if thing not in old] for kind, old in before.items()}
    roots = [thing for thing in new["objects"] if thing.parent is None]
    values = {material.name: material_facts(material) for material in new["materials"]}
    places = {}
    for thing in new["objects"]:
        if thing.type == "MESH":
            places.setdefault(thing.data.name, []).append([list(row) for row in Y_UP @ thing.matrix_world @ Y_UP.inverted()])
    small = [mesh for mesh in new["meshes"] if mesh.uv_layers and len(mesh.polygons) < 100]
    return {"meshes": {mesh.name: facts_of_mesh(mesh) for mesh in new["meshes"]}, "places": places,
            "materials": sorted(material.name for material in new["materials"]),
            "cpu_s": cpu_s, "unit_m": bpy.context.scene.unit_settings.scale_length,
            "roots": [{"name": root.name, "extras": sorted(root.keys()), "children": [child.name for child in root.children]}
                      for root in roots],
            "extras": {thing.name: {key: str(value) for key, value in thing.items()} for thing in new["objects"][:2000]},
            "faces": [facts_of_faces(thing) for thing in new["objects"] if thing.type == "MESH" and thing.data.users == 1],
            "values": values,
            "pictures": {name: values["picture_px"] for name, values in values.items() if "picture_px" in values},
            "images": [list(image.size) for image in new["images"]],
            "lights": [facts_of_light(thing) for thing in new["objects"] if thing.type == "LIGHT"],
            "corners": {mesh.name: corners_of(mesh) for mesh in small}}


def facts_of_light(thing):
    """Its place in glTF's axes, where it shines to, its colour and its power in watts."""
    down = thing.matrix_world.to_quaternion() @ mathutils.Vector((0, 0, -1))
    return {"type": thing.data.type, "at": list((Y_UP @ thing.matrix_world)[i][3] for i in range(3)), "down": down.z < -0.999,
            "colour": list(thing.data.color), "watts": thing.data.energy, "osm_id": thing.get("osm_id"), "lumen": thing.get("lumen")}


def show_only(names):
    """A layer is a child of a file's root. @param names  Of layers; None shows all."""
    for root in [thing for thing in bpy.data.objects if thing.parent is None and thing.type in ("EMPTY", "MESH")]:
        for layer in root.children:
            hidden = names is not None and layer.name.split(".")[0] not in names
            for thing in [layer, *layer.children_recursive]:
                thing.hide_render = hidden


def sky_and_sun(direction, scene):
    scene.world = bpy.data.worlds.new("sky")
    scene.world.use_nodes = True
    sky = scene.world.node_tree.nodes["Background"]
    sky.inputs["Color"].default_value, sky.inputs["Strength"].default_value = (0.5, 0.55, 0.62, 1), 1
    light = bpy.data.lights.new("sun", "SUN")
    light.energy, light.angle = 4, 0.01
    sun = bpy.data.objects.new("sun", light)
    sun.rotation_euler = z_up(direction).to_track_quat("Z", "Y").to_euler()
    scene.collection.objects.link(sun)


def render(picture, scene):
    """Cycles: coverage is the alpha of the picture."""
    show_only(picture["shown"])
    camera = scene.camera
    camera.location = z_up(picture["eye"])
    camera.rotation_euler = (z_up(picture["look"]) - camera.location).to_track_quat("-Z", "Y").to_euler()
    camera.data.angle_y = math.radians(picture["fov_deg"])
    scene.render.resolution_x, scene.render.resolution_y = picture["size"]
    scene.render.film_transparent = picture["coverage"]
    scene.cycles.samples = 4 if picture["coverage"] else 24
    scene.render.image_settings.color_mode = "RGBA" if picture["coverage"] else "RGB"
    scene.render.filepath = picture["out"]
    bpy.ops.render.render(write_still=True)


def prepare(scene, sun):
    scene.render.engine = "CYCLES"
    scene.cycles.use_denoising = False
    scene.cycles.max_bounces, scene.cycles.transparent_max_bounces = 3, 32
    scene.render.resolution_percentage = 100
    scene.view_settings.view_transform = "Standard"
    data = bpy.data.cameras.new("camera")
    data.sensor_fit, data.clip_end = "VERTICAL", 6000
    scene.camera = bpy.data.objects.new("camera", data)
    scene.collection.objects.link(scene.camera)
    sky_and_sun(sun, scene)


with open(sys.argv[sys.argv.index("--") + 1], encoding="utf-8") as file:
    job = json.load(file)
bpy.ops.wm.read_factory_settings(use_empty=True)
found = [facts_of(path) for path in job["files"]]
if job["pictures"]:
    prepare(bpy.context.scene, job["sun"])
for each in job["pictures"]:
    render(each, bpy.context.scene)
with open(job["facts"], "w", encoding="utf-8") as out:
    json.dump(found, out)
if not bpy.app.binary_path:
    # bpy 4.2 as a module ends with a segmentation fault once any operator with a property is registered
    sys.stdout.flush()
    os._exit(0)
