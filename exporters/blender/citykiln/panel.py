"""The panel "citykiln" of the 3D view: the object of the map that the picked face shows."""
import json

import bmesh
import bpy

from .meshes import FEATURE
from .objects import FEATURES

# facts of the mesh that was shown last, by its address and the length of its text
shown = {}


def facts_by_row(mesh):
    """The facts of the objects that a merged mesh shows, by row; {} for other meshes."""
    text = mesh.get(FEATURES, "")
    key = (mesh.as_pointer(), len(text))
    if key not in shown:
        shown.clear()
        shown[key] = json.loads(text) if text else {}
    return shown[key]


def picked_row(mesh):
    """The row of the active face of a mesh in edit mode; None without one."""
    faces = bmesh.from_edit_mesh(mesh).faces
    layer = faces.layers.int.get(FEATURE)
    return None if layer is None or faces.active is None else faces.active[layer]


def facts_of_object(thing):
    """The facts of an object that shows one object of the map."""
    names = ("osm_id", "osm_type", "class", "name", "height_m", "tags", "assumed")
    return {name: thing[name].to_dict() if hasattr(thing[name], "to_dict") else thing[name] for name in names if name in thing}


def picked_facts(context):
    """The facts of the active face or object, or a sentence that says what to do."""
    thing = context.object
    if thing is None:
        return "Choose an object"
    if thing.type != "MESH" or FEATURES not in thing.data:
        return facts_of_object(thing) or "It shows no object of the map"
    if thing.mode != "EDIT":
        return "Press Tab and choose a face"
    row = picked_row(thing.data)
    return "Choose a face" if row is None else facts_by_row(thing.data).get(str(row), "The face shows no object of the map")


class VIEW3D_PT_citykiln(bpy.types.Panel):
    bl_label = "citykiln"
    bl_space_type, bl_region_type, bl_category = "VIEW_3D", "UI", "citykiln"

    def draw(self, context):
        facts = picked_facts(context)
        if isinstance(facts, str):
            self.layout.label(text=facts)
            return
        for name, value in facts.items():
            if name != "tags":
                self.layout.label(text=f"{name}: {id_text(value)}")
        for line in tag_lines(facts.get("tags")):
            self.layout.label(text=line)
        if context.object.mode == "EDIT":
            self.layout.operator(MESH_OT_citykiln_select.bl_idname)


class VIEW3D_PT_citykiln_light(bpy.types.Panel):
    bl_label = "citykiln Light"
    bl_space_type, bl_region_type, bl_category = "VIEW_3D", "UI", "citykiln"

    @classmethod
    def poll(cls, context):
        return context.scene.citykiln.is_set

    def draw(self, context):
        for names in (("year", "month", "day"), ("hour",), ("sun_elevation", "sun_azimuth"), ("turbidity",), ("exposure",), ("lamps",)):
            row = self.layout.row(align=True)
            for name in names:
                row.prop(context.scene.citykiln, name)
        self.layout.operator("scene.citykiln_finer")
        self.layout.operator("scene.citykiln_bake")


def id_text(value):
    return str(int(value)) if isinstance(value, float) and value.is_integer() else str(value)


def tag_lines(tags):
    """Lines such as "building = yes". @param tags  An object, or its JSON."""
    values = json.loads(tags) if isinstance(tags, str) else tags or {}
    return [f"{key} = {value}" for key, value in values.items()]


class MESH_OT_citykiln_select(bpy.types.Operator):
    """Select all faces that show the same object of the map"""
    bl_idname = "mesh.citykiln_select"
    bl_label = "Select Object of the Map"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        return context.mode == "EDIT_MESH"

    def execute(self, context):
        mesh = context.object.data
        row = picked_row(mesh)
        if row is None:
            self.report({"ERROR"}, "no face is chosen, or the mesh shows no objects of the map")
            return {"CANCELLED"}
        faces = bmesh.from_edit_mesh(mesh).faces
        layer = faces.layers.int[FEATURE]
        for face in faces:
            face.select_set(face[layer] == row)
        bmesh.update_edit_mesh(mesh)
        return {"FINISHED"}
