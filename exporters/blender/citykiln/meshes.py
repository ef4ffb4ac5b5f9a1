"""Blender's meshes of the meshes of .glb files. Equal meshes of copies are one for all tiles."""
import hashlib

import bpy
import numpy

from .mesh_arrays import MeshArrays

# the attribute of faces: the row of the tile's table, which is on the tile's collection (features.py)
FEATURE = "feature"
COLOURS = "Color"


class Meshes:
    """The meshes of a run."""

    def __init__(self, materials):
        self.materials, self.made = materials, {}

    def mesh(self, glb, number, keys, is_shared):
        """The mesh of this number of a file.
        @param keys  Of the file's materials.  @param is_shared  False: it is the only one of its kind."""
        primitives = glb.gltf["meshes"][number]["primitives"]
        key = digest_of(glb, primitives, keys) if is_shared else None
        if key is None or key not in self.made:
            mesh = self.mesh_of(glb, glb.gltf["meshes"][number].get("name", "mesh"), MeshArrays(glb, primitives), keys)
            if key is None:
                return mesh
            self.made[key] = mesh
        return self.made[key]

    def mesh_of(self, glb, name, arrays, keys):
        """A new mesh of arrays, with its materials."""
        mesh = make_mesh(name, arrays)
        for slot, material in enumerate(arrays.materials):
            mesh.materials.append(None if material is None else
                                  self.materials.material(glb, material, keys[material], name, arrays.tint(slot)))
        return mesh


def digest_of(glb, primitives, keys):
    """Equal for meshes with the same vertices, triangles and materials."""
    digest = hashlib.blake2b(digest_size=16)
    for primitive in primitives:
        digest.update(keys[primitive["material"]].encode() if "material" in primitive else b"-")
        for name, accessor in sorted(primitive["attributes"].items()):
            digest.update(name.encode())
            digest.update(numpy.ascontiguousarray(glb.array(accessor)))
        digest.update(numpy.ascontiguousarray(glb.array(primitive["indices"])))
    return digest.digest()


def make_mesh(name, arrays):
    mesh = bpy.data.meshes.new(name)
    add_faces(mesh, arrays)
    if arrays.uvs is not None:
        layer = mesh.uv_layers.new(name="UVMap", do_init=False)
        layer.data.foreach_set("uv", arrays.uvs[arrays.triangles.ravel()].ravel())
    if arrays.colours is not None:
        mesh.color_attributes.new(COLOURS, "BYTE_COLOR", "POINT").data.foreach_set("color_srgb", arrays.colours.ravel())
    if arrays.features is not None:
        mesh.attributes.new(FEATURE, "INT", "FACE").data.foreach_set("value", arrays.features)
    mesh.update(calc_edges=True)
    if arrays.normals is not None:
        set_normals(mesh, arrays.normals)
    return mesh


def add_faces(mesh, arrays):
    count = len(arrays.triangles)
    mesh.vertices.add(len(arrays.positions))
    mesh.vertices.foreach_set("co", arrays.positions.ravel())
    mesh.loops.add(3 * count)
    mesh.loops.foreach_set("vertex_index", arrays.triangles.ravel())
    mesh.polygons.add(count)
    mesh.polygons.foreach_set("loop_start", numpy.arange(0, 3 * count, 3, dtype=numpy.int32))
    if bpy.app.version < (4, 0, 0):  # later versions know it by the next face's start
        mesh.polygons.foreach_set("loop_total", numpy.full(count, 3, numpy.int32))
    if len(arrays.materials) > 1:
        mesh.polygons.foreach_set("material_index", arrays.slots)
    mesh.polygons.foreach_set("use_smooth", arrays.is_smooth)


def set_normals(mesh, normals):
    """Gives vertices the normals of the file."""
    mesh.normals_split_custom_set_from_vertices(normals)
    if bpy.app.version < (4, 1, 0):  # later versions always show them
        mesh.use_auto_smooth = True
