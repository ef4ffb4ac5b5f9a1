"""Reads a .glb file: its JSON, and its accessors as arrays of numpy. Does not need Blender."""
import json
import mmap
import struct
from pathlib import Path

import numpy

DTYPES = {5120: numpy.int8, 5121: numpy.uint8, 5122: numpy.int16, 5123: numpy.uint16, 5125: numpy.uint32,
          5126: numpy.float32}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}
HEADER_BYTES, CHUNK_HEADER_BYTES = 12, 8
JSON_CHUNK, BINARY_CHUNK = 0x4E4F534A, 0x004E4942

PACKED = {"KHR_draco_mesh_compression": "Draco", "EXT_meshopt_compression": "meshopt"}
READ_EXTENSIONS = {"EXT_texture_webp", "KHR_mesh_quantization", "KHR_texture_transform"}


class GlbError(Exception):
    """A file that cannot be read. The text is one line: the file, and what was expected."""


class GlbFile:
    """A .glb file. Arrays are views of the mapped file where its layout allows."""

    def __init__(self, path):
        self.path = Path(path)
        self.gltf, binary = self._chunks(mapped(self.path))
        self._check_extensions()
        self.buffers = [self._buffer(buffer, binary) for buffer in self.gltf.get("buffers", [])]

    def array(self, number):
        """An accessor's values: (count, width), or (count,) for scalars. Integers stay integers, but for normals: see directions."""
        accessor = self._item("accessors", number)
        dtype, width = numpy.dtype(DTYPES[accessor["componentType"]]), WIDTHS[accessor["type"]]
        view, count = self._item("bufferViews", accessor["bufferView"]), accessor["count"]
        stride = view.get("byteStride", dtype.itemsize * width)
        start = accessor.get("byteOffset", 0)
        data = self.view(accessor["bufferView"])
        if count == 0 or start + stride * (count - 1) + dtype.itemsize * width > len(data):
            self._fail(f"accessor {number} is longer than its buffer view")
        values = numpy.ndarray((count, width), dtype, data, start, (stride, dtype.itemsize))
        return values[:, 0] if width == 1 else values

    def directions(self, number):
        """An accessor's vectors of unit length, which may be stored in bytes."""
        values = self.array(number)
        if values.dtype == numpy.float32:
            return values
        wide = values.astype(numpy.float32)
        return wide / numpy.maximum(numpy.linalg.norm(wide, axis=1, keepdims=True), 1e-6)

    def view(self, number):
        """The bytes of a buffer view."""
        view = self._item("bufferViews", number)
        buffer, start = self.buffers[view["buffer"]], view.get("byteOffset", 0)
        if start + view["byteLength"] > len(buffer):
            self._fail(f"buffer view {number} ends behind its buffer")
        return buffer[start:start + view["byteLength"]]

    def picture(self, image):
        """The bytes of an image, which may be a file beside this one."""
        return mapped(self.path.parent / image["uri"]) if "uri" in image else self.view(image["bufferView"])

    def _chunks(self, data):
        """The JSON as an object, and the binary chunk."""
        if len(data) < HEADER_BYTES + CHUNK_HEADER_BYTES or data[:4] != b"glTF":
            self._fail("is not a .glb file")
        _, version, length = struct.unpack_from("<4sII", data)
        if version != 2 or length != len(data):
            self._fail(f"is glTF {version} of {length} bytes; expected glTF 2 of {len(data)} bytes, as long as the file")
        chunks, start = {}, HEADER_BYTES
        while start + CHUNK_HEADER_BYTES <= length:
            size, kind = struct.unpack_from("<II", data, start)
            start += CHUNK_HEADER_BYTES
            chunks[kind] = data[start:start + size]
            start += size
        try:
            gltf = json.loads(bytes(chunks.get(JSON_CHUNK, b"")))
        except ValueError:
            self._fail("has no JSON that can be read")
        return gltf, chunks.get(BINARY_CHUNK, memoryview(b""))

    def _check_extensions(self):
        used = self.gltf.get("extensionsUsed", [])
        packed = [PACKED[name] for name in used if name in PACKED]
        if packed:
            self._fail(f"is packed ({', '.join(packed)}), which this add-on does not read: compile without --compress")
        unknown = set(self.gltf.get("extensionsRequired", [])) - READ_EXTENSIONS
        if unknown:
            self._fail(f"needs {', '.join(sorted(unknown))}, which this add-on does not read")

    def _buffer(self, buffer, binary):
        """A buffer's bytes: the binary chunk, or a file beside this one (compile --layout shared)."""
        return mapped(self.path.parent / buffer["uri"]) if "uri" in buffer else binary

    def _item(self, items, number):
        try:
            return self.gltf[items][number]
        except (KeyError, IndexError):
            self._fail(f"has no {items}[{number}]")

    def _fail(self, what):
        raise GlbError(f"{self.path}: {what}")


def mapped(path):
    """A file's bytes, which the system reads when they are used. An empty file has none."""
    try:
        with open(path, "rb") as file:
            if path.stat().st_size == 0:
                return memoryview(b"")
            return memoryview(mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ))
    except OSError as error:
        raise GlbError(f"{path}: {error.strerror}") from None
