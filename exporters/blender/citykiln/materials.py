"""Blender's materials of the materials of .glb files. Equal ones of all tiles and runs are one."""
import hashlib
import json

import bpy
import numpy

from .names import name_of_material

# custom properties: what a material or picture was made of, and a picture's mean colour
KEY, MEAN = "citykiln_key", "citykiln_mean"
# one of so many texels counts for the mean; a prime, so that all columns do
SAMPLE_STEP = 37
# of a material's values, those that do not change how it looks: names have the tile
NOT_LOOK = {"name", "extras"}


class Materials:
    """The materials and pictures of a scene, found again by what they are made of."""

    def __init__(self):
        self.made = {material[KEY]: material for material in bpy.data.materials if KEY in material}
        self.pictures = {image[KEY]: image for image in bpy.data.images if KEY in image}

    def keys_of(self, glb):
        """A key of each material of a file, equal where materials are."""
        digests = [digest_of(glb.picture(image)) for image in glb.gltf.get("images", [])]
        return [key_of(glb, material, digests) for material in glb.gltf.get("materials", [])]

    def material(self, glb, number, key, mesh_name, tint):
        """The material with this key; made at the first call.
        @param tint  The mean colour of its vertices in the mesh that shows it first; None for a mesh without colours, in which
                     Blender would see black."""
        key += "" if tint is None else " colours"
        if key not in self.made:
            self.made[key] = self._make(glb, glb.gltf["materials"][number], mesh_name, tint)
            self.made[key][KEY] = key
        return self.made[key]

    def picture(self, glb, texture, is_colour):
        """The image of a texture, whose bytes become part of the .blend file."""
        source = source_of(glb.gltf["textures"][texture])
        image = glb.gltf["images"][source]
        data = bytes(glb.picture(image))
        key = digest_of(data)
        if key not in self.pictures:
            made = bpy.data.images.new(image.get("name", "image"), 8, 8)
            made.pack(data=data, data_len=len(data))
            made.source = "FILE"
            made.colorspace_settings.name = "sRGB" if is_colour else "Non-Color"
            made[KEY] = key
            self.pictures[key] = made
        return self.pictures[key]

    def _make(self, glb, values, mesh_name, tint):
        material = bpy.data.materials.new(name_of_material(values.get("name", "material"), mesh_name))
        material.use_nodes = True
        # a mask shows leaves or railings, whose backs are left out (mesh_arrays.without_backs)
        material.use_backface_culling = not values.get("doubleSided", False) and values.get("alphaMode") != "MASK"
        nodes = Nodes(self, glb, material, values, tint is not None)
        nodes.build()
        material.diffuse_color = shown_colour(values, tint, nodes.base_picture)
        for name, value in values.get("extras", {}).items():
            material[name] = value
        return material


def shown_colour(values, tint, picture):
    """The colour in views that show no textures: factor times picture times vertices, opaque where leaves have holes."""
    factor = values.get("pbrMetallicRoughness", {}).get("baseColorFactor", [1, 1, 1, 1])
    colour = numpy.array(factor[:3]) * (1 if tint is None else tint)
    if picture is not None:
        colour = colour * mean_colour(picture)
    return [*colour, factor[3] if values.get("alphaMode") == "BLEND" else 1]


def mean_colour(picture):
    """The mean of a picture's opaque texels, linear; kept at the picture."""
    if MEAN not in picture:
        texels = numpy.empty(len(picture.pixels), numpy.float32)
        picture.pixels.foreach_get(texels)
        texels = texels.reshape(-1, picture.channels)[::SAMPLE_STEP]
        weights = texels[:, 3:4] if picture.channels == 4 else numpy.ones((len(texels), 1), numpy.float32)
        stored = (texels[:, :3] * weights).sum(axis=0) / max(float(weights.sum()), 1e-6)
        picture[MEAN] = (stored ** 2.2).tolist()
    return numpy.array(picture[MEAN])


def digest_of(data):
    return hashlib.blake2b(data, digest_size=16).hexdigest()


def source_of(texture):
    return texture.get("source", texture.get("extensions", {}).get("EXT_texture_webp", {}).get("source"))


def key_of(glb, material, digests):
    """Material values with the pictures' digests in place of their numbers, and without names."""
    def named(values):
        if isinstance(values, dict):
            if "index" in values:
                texture = glb.gltf["textures"][values["index"]]
                sampler = glb.gltf["samplers"][texture["sampler"]] if "sampler" in texture else None
                return values | {"index": [digests[source_of(texture)], sampler]}
            return {name: named(value) for name, value in values.items()}
        return values
    look = {name: value for name, value in material.items() if name not in NOT_LOOK}
    return digest_of(json.dumps(named(look), sort_keys=True).encode())


class Nodes:
    """The nodes of one material: base colour times colours of vertices, roughness, metal, normals, light, holes."""

    def __init__(self, materials, glb, material, values, has_colours):
        self.has_colours = has_colours
        self.materials, self.glb, self.material, self.values = materials, glb, material, values
        self.surface = values.get("pbrMetallicRoughness", {})
        self.tree = material.node_tree
        self.shader = next(node for node in self.tree.nodes if node.type == "BSDF_PRINCIPLED")
        self.base_picture = None

    def build(self):
        self._base_colour()
        self._roughness()
        self._normals()
        self._emission()

    def _base_colour(self):
        factor = self.surface.get("baseColorFactor", [1, 1, 1, 1])
        colour, alpha = list(factor), None
        if self.has_colours:
            node = self._add("ShaderNodeVertexColor", -600, 300)
            node.layer_name = "Color"
            colour, alpha = self._product(node.outputs["Color"], factor, 300), node.outputs["Alpha"]
        if "baseColorTexture" in self.surface:
            picture = self._picture(self.surface["baseColorTexture"], 500, True)
            self.base_picture = picture.image
            colour = self._product(picture.outputs["Color"], colour, 500)
            if self.values.get("alphaMode") == "MASK":
                self._holes(picture.outputs["Alpha"])
        self._set(colour, "Base Color")
        if self.values.get("alphaMode") == "BLEND":
            self._set(factor[3] if alpha is None else alpha, "Alpha")
            set_if_there(self.material, blend_method="BLEND", surface_render_method="BLENDED")

    def _set(self, value, name):
        """Links a socket to an input of the shader, or gives it a value."""
        if hasattr(value, "node"):
            self._link(value, name)
        else:
            self.shader.inputs[name].default_value = value

    def _holes(self, alpha):
        """Texels with an opacity below the cutoff are holes, in Cycles too."""
        cutoff = self.values.get("alphaCutoff", 0.5)
        step = self._add("ShaderNodeMath", -250, 0)
        step.operation, step.inputs[1].default_value = "GREATER_THAN", cutoff
        self.tree.links.new(alpha, step.inputs[0])
        self._link(step.outputs[0], "Alpha")
        set_if_there(self.material, blend_method="CLIP", shadow_method="CLIP", alpha_threshold=cutoff)

    def _roughness(self):
        self.shader.inputs["Roughness"].default_value = self.surface.get("roughnessFactor", 1)
        self.shader.inputs["Metallic"].default_value = self.surface.get("metallicFactor", 1)
        if "metallicRoughnessTexture" not in self.surface:
            return
        parts = self._add("ShaderNodeSeparateColor", -250, -200)
        picture = self._picture(self.surface["metallicRoughnessTexture"], -200, False)
        self.tree.links.new(picture.outputs["Color"], parts.inputs[0])
        self._link(parts.outputs[1], "Roughness")
        self._link(parts.outputs[2], "Metallic")

    def _normals(self):
        if "normalTexture" not in self.values:
            return
        node = self._add("ShaderNodeNormalMap", -250, -500)
        node.inputs["Strength"].default_value = self.values["normalTexture"].get("scale", 1)
        picture = self._picture(self.values["normalTexture"], -500, False)
        self.tree.links.new(picture.outputs["Color"], node.inputs["Color"])
        self._link(node.outputs["Normal"], "Normal")

    def _emission(self):
        factor = self.values.get("emissiveFactor")
        if factor is None:
            return
        # called Emission before Blender 4.0
        name = "Emission Color" if "Emission Color" in self.shader.inputs else "Emission"
        self.shader.inputs["Emission Strength"].default_value = 1
        self.shader.inputs[name].default_value = [*factor, 1]
        if "emissiveTexture" in self.values:
            picture = self._picture(self.values["emissiveTexture"], -800, True)
            self._link(self._product(picture.outputs["Color"], [*factor, 1], -800), name)

    def _picture(self, shown, y, is_colour):
        """The node of a texture; one node for each picture."""
        texture = self.glb.gltf["textures"][shown["index"]]
        node = self._add("ShaderNodeTexImage", -900, y)
        node.image = self.materials.picture(self.glb, shown["index"], is_colour)
        sampler = self.glb.gltf["samplers"][texture["sampler"]] if "sampler" in texture else {}
        clamp = 33071
        node.extension = "EXTEND" if sampler.get("wrapS") == clamp and sampler.get("wrapT") == clamp else "REPEAT"
        return node

    def _product(self, socket, other, y):
        """A socket times a colour or another socket."""
        if not hasattr(other, "node") and list(other)[:3] == [1, 1, 1]:
            return socket
        node = self._add("ShaderNodeMixRGB", -250, y)
        node.blend_type, node.inputs["Fac"].default_value = "MULTIPLY", 1
        self.tree.links.new(socket, node.inputs["Color1"])
        if hasattr(other, "node"):
            self.tree.links.new(other, node.inputs["Color2"])
        else:
            node.inputs["Color2"].default_value = [*list(other)[:3], 1]
        return node.outputs["Color"]

    def _add(self, kind, x, y):
        node = self.tree.nodes.new(kind)
        node.location = (x, y)
        return node

    def _link(self, socket, name):
        self.tree.links.new(socket, self.shader.inputs[name])


def set_if_there(thing, **values):
    """Sets properties that not all versions of Blender have (4.2 replaced blend_method)."""
    for name, value in values.items():
        if hasattr(thing, name):
            try:
                setattr(thing, name, value)
            except TypeError:  # an enum without this value
                pass
