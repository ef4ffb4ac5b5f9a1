"""Reads a .glb file with the files that it refers to, independently of the product."""
import json
import struct
from pathlib import Path

FORMATS = {5120: "b", 5122: "h", 5121: "B", 5123: "H", 5125: "I", 5126: "f"}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}


class Glb:
    """The JSON chunk as `gltf`, the binary chunk as `buffer`."""

    def __init__(self, path):
        self.folder = Path(path).parent
        data = Path(path).read_bytes()
        size = struct.unpack_from("<I", data, 12)[0]
        self.gltf, self.buffer = json.loads(data[20:20 + size]), data[28 + size:]

    def bytes_of_view(self, number):
        """The bytes of a buffer view, which may be in a file of glb/shared."""
        view = self.gltf["bufferViews"][number]
        uri = self.gltf["buffers"][view["buffer"]].get("uri")
        buffer = (self.folder / uri).read_bytes() if uri else self.buffer
        start = view.get("byteOffset", 0)
        return buffer[start:start + view["byteLength"]]

    def bytes_of_image(self, image):
        return (self.folder / image["uri"]).read_bytes() if "uri" in image else self.bytes_of_view(image["bufferView"])

    def values(self, accessor):
        """The elements of an accessor, each a tuple."""
        accessor = self.gltf["accessors"][accessor]
        view = self.gltf["bufferViews"][accessor["bufferView"]]
        form = "<" + FORMATS[accessor["componentType"]] * WIDTHS[accessor["type"]]
        data, start = self.bytes_of_view(accessor["bufferView"]), accessor.get("byteOffset", 0)
        stride = view.get("byteStride", struct.calcsize(form))
        return [struct.unpack_from(form, data, start + i * stride) for i in range(accessor["count"])]

    def osm_ids(self):
        """The OSM id of each feature, from the tile's property table."""
        table = self.gltf["extensions"]["EXT_structural_metadata"]["propertyTables"][0]
        view = self.gltf["bufferViews"][table["properties"]["id"]["values"]]
        return struct.unpack_from(f"<{table['count']}Q", self.buffer, view.get("byteOffset", 0))
