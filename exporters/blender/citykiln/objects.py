"""Objects of a tile in Blender: collections by tile and layer, linked copies, facts of the map as custom properties."""
import json

import bpy
import mathutils

from .lamps import light_of
from .property_table import facts_of_row

LARGEST_INT, LONGEST_KEY = 2 ** 31 - 1, 63
# a custom property of merged meshes: facts by row, as JSON
FEATURES = "features"


class Builder:
    """Builds the tiles of a run below one collection, which joins the scene last: Blender counts all objects of a scene again
    whenever one is added to it, so that the time would grow with the square of their number."""

    def __init__(self, run_collection, meshes, materials, placement, layers, has_lamps):
        self.run_collection, self.meshes, self.materials = run_collection, meshes, materials
        self.placement, self.layers, self.has_lamps = placement, layers, has_lamps
        self.shared_lights = {}

    def add_tile(self, tile, name):
        """Adds the chosen layers of a tile."""
        keys, collections = self.materials.keys_of(tile.glb), {}
        group = bpy.data.collections.new(name)
        set_facts(group, tile.extras)
        for item in tile.items:
            thing = self._data_of(tile, item, keys)
            if thing is not None:
                layer = collections.get(item.layer) or collections.setdefault(item.layer, self._layer(group, name, item.layer))
                layer.objects.link(self._object(tile, item, thing, name))
        self.run_collection.children.link(group)

    def _data_of(self, tile, item, keys):
        """The mesh or light of an item; None where it is not wanted."""
        if item.light is not None:
            return light_of(tile.glb, item.light, self.shared_lights) if self.has_lamps else None
        if item.layer and item.layer not in self.layers:
            return None
        mesh = self.meshes.mesh(tile.glb, item.mesh, keys, is_shared=not item.is_merged)
        if item.is_merged and tile.table:
            mesh[FEATURES] = features_text(mesh, tile.table)
        return mesh

    def _layer(self, group, tile_name, layer):
        if not layer:
            return group
        made = bpy.data.collections.new(f"{tile_name} {layer}")
        group.children.link(made)
        return made

    def _object(self, tile, item, data, tile_name):
        thing = bpy.data.objects.new(f"{tile_name} {item.name}" if item.is_merged else item.name, data)
        thing.matrix_basis = self.placement @ mathutils.Matrix(item.matrix.tolist())
        set_facts(thing, item.facts)
        return thing


def features_text(mesh, table):
    """The facts of the objects that a mesh shows, as JSON by row."""
    import numpy
    rows = numpy.empty(len(mesh.polygons), numpy.int32)
    mesh.attributes["feature"].data.foreach_get("value", rows)
    count = len(table["id"])
    facts = {int(row): facts_of_row(table, row) for row in numpy.unique(rows) if 0 < row < count}
    return json.dumps(facts, ensure_ascii=False)


def set_facts(thing, facts):
    """Sets custom properties, in the types that Blender has."""
    for name, value in facts.items():
        thing[name[:LONGEST_KEY]] = property_value(value)


def property_value(value):
    if isinstance(value, dict):
        return {key[:LONGEST_KEY]: property_value(each) for key, each in value.items()}
    if isinstance(value, list) and any(isinstance(each, str) for each in value):
        return ", ".join(map(str, value))
    if isinstance(value, int) and abs(value) > LARGEST_INT:
        return float(value)
    return value
