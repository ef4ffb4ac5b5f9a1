"""The primitives of a mesh joined to arrays as Blender's meshes have them. Does not need Blender."""
import numpy

from .axes import turn_into
from .glb import GlbError

# the stored byte of a linear one, as Blender keeps colours of bytes
LINEAR = numpy.arange(256) / 255
STORED = numpy.where(LINEAR <= 0.0031308, LINEAR * 12.92, 1.055 * LINEAR ** (1 / 2.4) - 0.055).astype(numpy.float32)

COS_FLAT = 0.9994
# twice the area of triangles whose direction is lost in rounding
LEAST_M2 = 1e-4


class MeshArrays:
    """positions (n, 3), triangles (t, 3), slots (t): numbers in `materials`; is_smooth (t); and where the mesh has them normals
    (n, 3), colours (n, 4), uvs (n, 2; v upwards), features (t). Normals are left out where all stand on their faces, which
    Blender shows without them: normals of a file take much of the time and memory of an import."""

    def __init__(self, glb, primitives):
        counts = [glb.gltf["accessors"][p["attributes"]["POSITION"]]["count"] for p in primitives]
        has = lambda name: any(name in p["attributes"] for p in primitives)
        n = sum(counts)
        self.materials = list(dict.fromkeys(p.get("material") for p in primitives))
        self.positions = numpy.empty((n, 3), numpy.float32)
        self.normals = numpy.zeros((n, 3), numpy.float32) if has("NORMAL") else None  # zero: of the faces
        self.colours = numpy.ones((n, 4), numpy.float32) if has("COLOR_0") else None
        self.uvs = numpy.zeros((n, 2), numpy.float32) if has("TEXCOORD_0") else None
        features = numpy.zeros(n, numpy.int32) if has("_FEATURE_ID_0") else None
        triangles, slots, smooth, first = [], [], [], 0
        for primitive, count in zip(primitives, counts):
            corners = without_backs(indices_of(glb, primitive, count))
            rows = slice(first, first + count)
            self._fill(glb, primitive, rows, features)
            smooth.append(numpy.full(len(corners), self._keeps_normals(primitive, rows, corners)))
            triangles.append(corners.astype(numpy.int32) + first)
            slots.append(numpy.full(len(corners), self.materials.index(primitive.get("material")), numpy.int32))
            first += count
        self.triangles, self.slots = numpy.concatenate(triangles), numpy.concatenate(slots)
        self.is_smooth = numpy.concatenate(smooth)
        if not self.is_smooth.any():
            self.normals = None
        self.features = None if features is None else features[self.triangles[:, 0]]

    def tint(self, slot):
        """The mean linear colour of the vertices of a material; None without colours."""
        if self.colours is None:
            return None
        corners = self.triangles[self.slots == slot][::16].ravel()
        return (self.colours[corners, :3] ** 2.2).mean(axis=0) if len(corners) else numpy.ones(3)

    def _keeps_normals(self, primitive, rows, corners):
        """Whether a primitive has normals that its faces have not."""
        if "NORMAL" not in primitive["attributes"]:
            return False
        if not are_flat(self.positions[rows], corners, self.normals[rows]):
            return True
        self.normals[rows] = 0
        return False

    def _fill(self, glb, primitive, rows, features):
        attributes = primitive["attributes"]
        turn_into(self.positions[rows], glb.array(attributes["POSITION"]))
        if "NORMAL" in attributes:
            turn_into(self.normals[rows], glb.directions(attributes["NORMAL"]))
        if "COLOR_0" in attributes:
            self.colours[rows] = stored_colours(glb.array(attributes["COLOR_0"]))
        if "TEXCOORD_0" in attributes:
            uvs = glb.array(attributes["TEXCOORD_0"]) * texture_scale(glb, primitive)
            self.uvs[rows, 0] = uvs[:, 0]
            numpy.subtract(1, uvs[:, 1], out=self.uvs[rows, 1])
        if "_FEATURE_ID_0" in attributes:
            features[rows] = glb.array(attributes["_FEATURE_ID_0"])


class Part:
    """The triangles of one object in a MeshArrays, with the same members; positions are from `origin`, the middle of its box at its
    lowest vertex."""

    def __init__(self, whole, triangles):
        used, inverse = numpy.unique(whole.triangles[triangles], return_inverse=True)
        of = lambda values: None if values is None else values[used]
        self.triangles = inverse.reshape(-1, 3).astype(numpy.int32)
        self.positions, self.normals, self.colours, self.uvs = map(of, (whole.positions, whole.normals, whole.colours, whole.uvs))
        numbers, self.slots = numpy.unique(whole.slots[triangles], return_inverse=True)
        self.slots = self.slots.astype(numpy.int32)
        self.materials = [whole.materials[number] for number in numbers]
        self.is_smooth, self.features = whole.is_smooth[triangles], None
        self.origin = foot_of(self.positions)
        self.positions = self.positions - self.origin

    tint = MeshArrays.tint


def foot_of(positions):
    """The middle of a box of positions, at its lowest."""
    low, high = positions.min(axis=0), positions.max(axis=0)
    return numpy.array([(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, low[2]], numpy.float32)


def parts_by_feature(whole):
    """The rows of a merged mesh, and the Part of each."""
    order = numpy.argsort(whole.features, kind="stable")
    rows, starts = numpy.unique(whole.features[order], return_index=True)
    for row, triangles in zip(rows.tolist(), numpy.split(order, starts[1:])):
        yield row, Part(whole, triangles)


def indices_of(glb, primitive, count):
    """The triangles of a primitive. Error: a corner that is no vertex, which would end Blender."""
    if primitive.get("mode", 4) != 4 or "indices" not in primitive:
        raise GlbError(f"{glb.path}: has a primitive that is not of indexed triangles")
    indices = glb.array(primitive["indices"])
    if len(indices) % 3 != 0 or indices.max() >= count:
        raise GlbError(f"{glb.path}: has a triangle whose corners are not vertices")
    return indices.reshape(-1, 3)


def texture_scale(glb, primitive):
    """The factors of uvs by KHR_texture_transform, which are the same for all textures of a material of citykiln."""
    def scales(values):
        if isinstance(values, dict):
            if "KHR_texture_transform" in values:
                yield values["KHR_texture_transform"].get("scale", [1, 1])
            for value in values.values():
                yield from scales(value)
    material = glb.gltf["materials"][primitive["material"]] if "material" in primitive else {}
    return numpy.array(next(scales(material), [1, 1]), numpy.float32)


def without_backs(triangles):
    """Leaves have a face for each side, of the same vertices. Blender shows both sides of a face, so that the second is left out."""
    half = len(triangles) // 2
    are_backs = 2 * half == len(triangles) and numpy.array_equal(triangles[half:], triangles[:half][:, [0, 2, 1]])
    return triangles[:half] if are_backs else triangles


def are_flat(positions, triangles, normals):
    """Whether all normals stand on their triangles, within 2 degrees. Triangles without area have none to compare."""
    a, b, c = (positions[triangles[:, i]] for i in range(3))
    across = numpy.cross(b - a, c - a)
    length = numpy.linalg.norm(across, axis=1)
    for i in range(3):
        if (numpy.einsum("ij,ij->i", across, normals[triangles[:, i]]) < COS_FLAT * length - LEAST_M2).any():
            return False
    return True


def stored_colours(colours):
    """Linear colours in bytes as Blender stores them: red, green and blue by the curve of sRGB, alpha as it is."""
    out = STORED[colours]
    out[:, 3] = LINEAR[colours[:, 3]]
    return out
