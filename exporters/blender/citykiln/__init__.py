"""citykiln for Blender: imports runs of citykiln, and compiles maps. See the README beside this folder in citykiln's source.

Tested in Blender 3.4; written for the changes of 4.x too."""
bl_info = {"name": "citykiln", "author": "citykiln", "version": (0, 1, 0), "blender": (3, 4, 0),
           "location": "File > Import > citykiln run, citykiln map", "category": "Import-Export",
           "description": "Imports city tiles that citykiln compiled, and compiles OpenStreetMap extracts"}

import bpy  # noqa: E402

from . import import_map, import_run, light, panel, remake  # noqa: E402

CLASSES = [light.CitykilnLight, import_map.CitykilnPreferences, import_run.IMPORT_SCENE_OT_citykiln_run, import_map.IMPORT_SCENE_OT_citykiln_map,
           panel.MESH_OT_citykiln_select, panel.VIEW3D_PT_citykiln, panel.VIEW3D_PT_citykiln_light,
           remake.SCENE_OT_citykiln_bake, remake.SCENE_OT_citykiln_finer]


def draw_menu(menu, context):
    menu.layout.operator(import_run.IMPORT_SCENE_OT_citykiln_run.bl_idname, text="citykiln run (folder)")
    menu.layout.operator(import_map.IMPORT_SCENE_OT_citykiln_map.bl_idname, text="citykiln map (.osm, .osm.pbf)")


def register():
    for each in CLASSES:
        bpy.utils.register_class(each)
    light.register()
    bpy.types.TOPBAR_MT_file_import.append(draw_menu)


def unregister():
    light.unregister()
    bpy.types.TOPBAR_MT_file_import.remove(draw_menu)
    for each in reversed(CLASSES):
        bpy.utils.unregister_class(each)
