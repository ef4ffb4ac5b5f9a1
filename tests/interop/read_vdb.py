"""Runs inside Blender: imports a .vdb file and writes facts about its grids as JSON: `grids`, names and types; `low` and `high`, the box
of the voxels in metres.

blender -b --factory-startup -noaudio --python-exit-code 3 -P read_vdb.py -- FILE.vdb FACTS.json
"""
import json
import os
import sys

import bpy

file, facts = sys.argv[sys.argv.index("--") + 1:]
bpy.ops.object.volume_import(filepath=file, directory=os.path.dirname(file), files=[{"name": os.path.basename(file)}])
[volume] = [thing for thing in bpy.data.objects if thing.type == "VOLUME"]
if not volume.data.grids.load():
    raise RuntimeError(volume.data.grids.error_message)
corners = [volume.matrix_world @ __import__("mathutils").Vector(corner) for corner in volume.bound_box]
found = {"grids": [[grid.name, grid.data_type] for grid in volume.data.grids],
         "low": [min(corner[axis] for corner in corners) for axis in range(3)],
         "high": [max(corner[axis] for corner in corners) for axis in range(3)]}
with open(facts, "w", encoding="utf-8") as out:
    json.dump(found, out)
