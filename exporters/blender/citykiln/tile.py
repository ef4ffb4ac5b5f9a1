"""The content of a tile's .glb: placed meshes and lights by layer, in Blender's axes. Does not need Blender."""
from dataclasses import dataclass, field

import numpy

from .axes import matrices_of, matrix_of, turned_matrix
from .glb import GlbFile
from .owners import own_facts
from .property_table import facts_of_row, read_table


# layers whose nodes are objects of the map themselves
ONE_OBJECT = {"buildings", "ground", "roads", "water", "structures"}


@dataclass
class Item:
    """A mesh or a light at a place. Copies of one mesh have the same number."""
    name: str
    layer: str
    matrix: numpy.ndarray
    mesh: int = None
    light: int = None
    facts: dict = field(default_factory=dict)
    is_merged: bool = False  # the mesh shows many objects, whose rows are at its vertices


class Tile:
    def __init__(self, path):
        self.glb = GlbFile(path)
        self.table = read_table(self.glb)
        self.items = []
        gltf = self.glb.gltf
        for root in gltf["scenes"][gltf.get("scene", 0)]["nodes"]:
            self.extras = gltf["nodes"][root].get("extras", {})
            self._walk(root, numpy.eye(4), [])

    def parts(self, mesh):
        """The primitives of a mesh."""
        return self.glb.gltf["meshes"][mesh]["primitives"]

    def _walk(self, number, above, names):
        """Adds the items of a node and of those below it. @param names  Of the nodes above it."""
        node = self.glb.gltf["nodes"][number]
        here, names = above @ matrix_of(node), names + [node.get("name", "")]
        if "mesh" in node:
            self._add_mesh(node, here, names)
        light = node.get("extensions", {}).get("KHR_lights_punctual")
        if light is not None:
            self.items.append(Item(names[-1], "lights", turned_matrix(here), light=light["light"], facts=node.get("extras", {})))
        for child in node.get("children", []):
            self._walk(child, here, names)

    def _add_mesh(self, node, here, names):
        mesh = self.glb.gltf["meshes"][node["mesh"]]
        layer = mesh.get("extras", {}).get("layer") or (names[1] if len(names) > 1 else "")
        instancing = node.get("extensions", {}).get("EXT_mesh_gpu_instancing")
        if instancing is not None:
            self._add_copies(node, here, names[-1], layer, instancing["attributes"])
            return
        is_merged = "_FEATURE_ID_0" in mesh["primitives"][0]["attributes"] and "feature" not in node.get("extras", {})
        facts = {} if len(names) == 1 else node.get("extras", {})
        if layer not in ONE_OBJECT:
            facts = own_facts(names[-1], facts)
        self.items.append(Item(names[-1], layer, turned_matrix(here), node["mesh"], facts=facts, is_merged=is_merged))

    def _add_copies(self, node, here, name, layer, attributes):
        """Adds the copies that a node of EXT_mesh_gpu_instancing stands for."""
        values = {key: self.glb.array(accessor) for key, accessor in attributes.items()}
        places = turned_matrix(here @ matrices_of(values["TRANSLATION"], values["ROTATION"], values["SCALE"]))
        rows = values.get("_FEATURE_ID_0", numpy.zeros(len(places))).astype(int).tolist()
        for place, row in zip(places, rows):
            facts = {"feature": row} | facts_of_row(self.table, row) if self.table else {}
            self.items.append(Item(name, layer, place, node["mesh"], facts=own_facts(name, facts)))
