"""Turns glTF's axes (y up) into Blender's (z up): (x, y, z) becomes (x, -z, y). Does not need Blender."""
import numpy

TO_Z_UP = numpy.array([[1, 0, 0, 0], [0, 0, -1, 0], [0, 1, 0, 0], [0, 0, 0, 1]], float)


def turn_into(out, vectors):
    """Writes vectors (n, 3) turned into an array of the same shape."""
    out[:, 0], out[:, 2] = vectors[:, 0], vectors[:, 1]
    numpy.negative(vectors[:, 2], out=out[:, 1])


def turned_matrix(matrix):
    """A placement in glTF's axes, (4, 4) or (n, 4, 4), as one in Blender's."""
    return TO_Z_UP @ matrix @ TO_Z_UP.T


def matrices_of(translations, rotations, scales):
    """(n, 4, 4) placements of translations (n, 3), rotations (n, 4: x, y, z, w) and scales (n, 3)."""
    x, y, z, w = rotations.astype(float).T
    rows = [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]
    out = numpy.zeros((len(translations), 4, 4))
    out[:, :3, :3] = numpy.moveaxis(numpy.array(rows), 2, 0) * scales[:, None, :]
    out[:, :3, 3], out[:, 3, 3] = translations, 1
    return out


def matrix_of(node):
    """The placement of a glTF node below its parent."""
    if "matrix" in node:
        return numpy.array(node["matrix"], float).reshape(4, 4).T
    vector = lambda name, default: numpy.array([node.get(name, default)], float)
    return matrices_of(vector("translation", [0, 0, 0]), vector("rotation", [0, 0, 0, 1]), vector("scale", [1, 1, 1]))[0]
