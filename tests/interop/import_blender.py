"""Runs inside Blender: imports .glb files, each into an empty scene, and writes facts about the imported objects as JSON.

blender -b --factory-startup -noaudio --python-exit-code 3 -P import_blender.py -- FACTS.json FILE.glb...
"""
import json
import sys

import bpy
import mathutils
import numpy

# the importer of Blender 3.4 uses numpy.bool, which newer NumPy no longer has
numpy.bool = bool


def material_name(mesh, polygon):
    return mesh.materials[polygon.material_index].name


def facts_of_uvs(mesh):
    """For each material the corners: position, and texture coordinates from the picture's lower left corner."""
    by_material = {}
    for polygon in mesh.polygons:
        row = by_material.setdefault(material_name(mesh, polygon), [])
        for loop in polygon.loop_indices:
            row.append([list(mesh.vertices[mesh.loops[loop].vertex_index].co), list(mesh.uv_layers[0].data[loop].uv)])
    return by_material


def facts_of_ground_and_buildings(tile):
    """Facts about the tile's own mesh in world coordinates: metres, z up."""
    mesh, world = tile.data, tile.matrix_world
    corners = [world @ vertex.co for vertex in mesh.vertices]
    by_material = {}
    up_m2 = 0.0
    for polygon in mesh.polygons:
        row = by_material.setdefault(material_name(mesh, polygon), {"triangles": 0, "z_m": [1e9, -1e9]})
        row["triangles"] += len(polygon.vertices) - 2
        heights = [corners[i].z for i in polygon.vertices]
        row["z_m"] = [min(row["z_m"][0], *heights), max(row["z_m"][1], *heights)]
        up_m2 += polygon.area * polygon.normal.z
    return {
        "materials": by_material,
        "low_m": [min(c[axis] for c in corners) for axis in range(3)],
        "high_m": [max(c[axis] for c in corners) for axis in range(3)],
        "area_seen_from_above_m2": up_m2,
    }


def nodes_behind(socket):
    """All shader nodes upstream of an input."""
    return [node for link in socket.links for node in [link.from_node] + [n for i in link.from_node.inputs for n in nodes_behind(i)]]


def base_colour(material):
    """The material's base colour: its picture, or the constant that is multiplied with the vertex colours."""
    shader = material.node_tree.nodes["Principled BSDF"]
    pictures = [node for node in nodes_behind(shader.inputs["Base Color"]) if node.type == "TEX_IMAGE"]
    if pictures:
        # nodes for wrapping are between the mapping and the picture
        mapping = next(node for node in nodes_behind(pictures[0].inputs["Vector"]) if node.type == "MAPPING")
        return {"roughness": shader.inputs["Roughness"].default_value,
                "roughness_is_picture": any(n.type == "TEX_IMAGE" for n in nodes_behind(shader.inputs["Roughness"])),
                "picture_px": list(pictures[0].image.size), "has_pixels": len(pictures[0].image.pixels) > 0,
                "scale": list(mapping.inputs["Scale"].default_value), "location": list(mapping.inputs["Location"].default_value)}
    link = shader.inputs["Base Color"].links[0].from_node
    constants = [tuple(i.default_value) for i in link.inputs if i.type == "RGBA" and not i.is_linked]
    if len(constants) != 1:
        raise RuntimeError(f"{material.name}: expected one constant colour, found {constants}")
    return {"colour": constants[0][:3], "roughness": shader.inputs["Roughness"].default_value}


def facts_of_copies(objects):
    """For each mesh the objects that share it: positions, scales and up axes."""
    by_mesh = {}
    for thing in objects:
        mesh = thing.data
        row = by_mesh.setdefault(mesh.name, {"users": mesh.users, "triangles": len(mesh.polygons), "places": []})
        row["materials"] = [material.name for material in mesh.materials]
        row["local_low_m"] = [min(v.co[axis] for v in mesh.vertices) for axis in range(3)]
        row["local_high_m"] = [max(v.co[axis] for v in mesh.vertices) for axis in range(3)]
        turned_up = (thing.matrix_world.to_3x3() @ mathutils.Vector((0, 0, 1))).normalized()
        row["places"].append({"at_m": list(thing.matrix_world.translation), "scale": list(thing.matrix_world.to_scale()),
                              "up": list(turned_up), "feature": thing.get("feature")})
    return by_mesh


def facts_of(path):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    answer = bpy.ops.import_scene.gltf(filepath=path)
    if answer != {"FINISHED"}:
        raise RuntimeError(f"{path}: the import returns {answer}")
    bpy.context.view_layer.update()
    tiles = [thing for thing in bpy.data.objects if thing.parent is None]
    if len(tiles) != 1 or tiles[0].type != "MESH":
        raise RuntimeError(f"{path}: expected one root with a mesh, found {[thing.name for thing in tiles]}")
    return {"root": tiles[0].name, "unit_m": bpy.context.scene.unit_settings.scale_length,
            "extras": sorted(key for key in tiles[0].keys()), "meshes": len(bpy.data.meshes),
            "materials": {name: base_colour(material) for name, material in bpy.data.materials.items()},
            "tile": facts_of_ground_and_buildings(tiles[0]), "pictures": [list(image.size) for image in bpy.data.images],
            "uvs": facts_of_uvs(tiles[0].data) if tiles[0].data.uv_layers else {},
            "copies": facts_of_copies(thing for thing in bpy.data.objects if thing.parent is not None)}


facts_path, *glb_paths = sys.argv[sys.argv.index("--") + 1:]
with open(facts_path, "w", encoding="utf-8") as out:
    json.dump([facts_of(path) for path in glb_paths], out)
