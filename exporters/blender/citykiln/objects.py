"""Objects of a tile in Blender: collections by tile and layer, linked copies, facts of the map as custom properties."""
import json

import bpy
import mathutils
import numpy

from .lamps import light_of
from .light import LAMPS
from .mesh_arrays import MeshArrays, parts_by_feature
from .names import name_of_building, name_of_copy
from .property_table import facts_of_row

LARGEST_INT, LONGEST_KEY = 2 ** 31 - 1, 63
# a custom property of merged meshes: facts by row, as JSON
FEATURES = "features"


class Builder:
    """Builds the tiles of a run below one collection, which joins the scene last: Blender counts all objects of a scene again
    whenever one is added to it, so that the time would grow with the square of their number."""

    def __init__(self, run_collection, meshes, materials, placement, layers, has_lamps, has_single_buildings):
        self.run_collection, self.meshes, self.materials = run_collection, meshes, materials
        self.placement, self.layers, self.has_lamps = placement, layers, has_lamps
        self.has_single_buildings = has_single_buildings
        self.shared_lights = {}
        self.waiting = []

    def add_tile(self, tile, name):
        """Adds the chosen layers of a tile, and returns its collection, whose objects place_all() makes."""
        keys, collections = self.materials.keys_of(tile.glb), {}
        group = bpy.data.collections.new(name)
        set_facts(group, tile.extras)
        for item in filter(self._is_wanted, tile.items):
            layer = collections.get(item.layer) or collections.setdefault(item.layer, self._layer(group, name, item.layer))
            self.waiting += [(layer, *thing) for thing in self._things(tile, item, keys, name)]
        self.run_collection.children.link(group)
        return group

    def place_all(self):
        """Makes the objects of all tiles. Before, the scene has meshes only: Blender looks at all objects whenever a mesh gets a
        material."""
        for layer, name, data, matrix, facts in self.waiting:
            layer.objects.link(self._object(name, data, matrix, facts))
        self.waiting.clear()

    def _is_wanted(self, item):
        return self.has_lamps if item.light is not None else not item.layer or item.layer in self.layers

    def _things(self, tile, item, keys, tile_name):
        """The objects of an item, as name, data, matrix and facts: one, or one for each building of a merged mesh."""
        if item.light is not None:
            light = light_of(tile.glb, item.light, self.shared_lights)
            return [(name_of_copy(item.name, item.facts), light, item.matrix, item.facts)]
        if item.layer == "buildings" and (self.has_single_buildings or not item.is_merged):
            return list(self._buildings(tile, item, keys))
        mesh = self.meshes.mesh(tile.glb, item.mesh, keys, is_shared=not item.is_merged)
        if item.is_merged and tile.table:
            mesh[FEATURES] = features_text(mesh, tile.table)
        is_single = item.is_merged or not item.facts and item.layer == item.name
        name = f"{tile_name} {item.name}" if is_single else name_of_copy(item.name, item.facts)
        return [(name, mesh, item.matrix, item.facts)]

    def _buildings(self, tile, item, keys):
        """An object for each building, whose origin is its middle at its lowest vertex."""
        whole = MeshArrays(tile.glb, tile.parts(item.mesh))
        if whole.features is None:
            whole.features = numpy.zeros(len(whole.triangles), numpy.int32)
        for row, part in parts_by_feature(whole):
            facts = item.facts or {"feature": row} | (facts_of_row(tile.table, row) if tile.table and row else {})
            name = name_of_building(facts)
            mesh = self.meshes.mesh_of(tile.glb, name, part, keys)
            yield name, mesh, item.matrix @ moved_by(part.origin), facts

    def _layer(self, group, tile_name, layer):
        if not layer:
            return group
        made = bpy.data.collections.new(f"{tile_name} {layer}")
        if layer == "lights":
            made[LAMPS] = True
        group.children.link(made)
        return made

    def _object(self, name, data, matrix, facts):
        thing = bpy.data.objects.new(name, data)
        thing.matrix_basis = self.placement @ mathutils.Matrix(matrix.tolist())
        set_facts(thing, facts)
        return thing


def moved_by(vector):
    matrix = numpy.eye(4)
    matrix[:3, 3] = vector
    return matrix


def features_text(mesh, table):
    """The facts of the objects that a mesh shows, as JSON by row."""
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
