"""Runs in a Python with usd-core and omniverse-asset-validator: opens a scene with OpenUSD, composes it with each variant, flattens it,
measures it by OpenUSD's own functions, and validates it.

open_usd.py SCENE.usda FACTS.json

The facts, a list for each variant `level`: `errors` of composition, `tiles` by name with `drawn` (triangles, prototypes once for each
instance), `triangles` (prototypes once), `instances`, `low`, `high`, `hint` (the box that the scene states), `unbound` (meshes without a
material), `materials`; `flat` (the same triangles after Flatten), and `issues` of the validator, by rule, severity and message."""
import collections
import json
import logging
import sys

logging.disable(logging.INFO)

import numpy  # noqa: E402
from omni.asset_validator import ValidationEngine  # noqa: E402
from pxr import Usd, UsdGeom, UsdShade  # noqa: E402


def with_level(path, level):
    """The scene with all tiles at a level; a tile without it keeps its own."""
    stage = Usd.Stage.Open(path)
    stage.SetEditTarget(stage.GetSessionLayer())
    for tile in stage.GetPrimAtPath("/scene/tiles").GetChildren():
        tile.GetVariantSet("level").SetVariantSelection(level)
    return stage


def levels_of(path):
    stage = Usd.Stage.Open(path)
    return sorted({name for tile in stage.GetPrimAtPath("/scene/tiles").GetChildren() for name in tile.GetVariantSet("level").GetVariantNames()})


def triangles_of(mesh):
    counts = numpy.array(mesh.GetFaceVertexCountsAttr().Get())
    indices = numpy.array(mesh.GetFaceVertexIndicesAttr().Get())
    assert (counts == 3).all() and len(indices) == 3 * len(counts), mesh.GetPath()
    assert 0 <= indices.min() and indices.max() < len(mesh.GetPointsAttr().Get()), mesh.GetPath()
    return len(counts)


def triangles_below(prim):
    return sum(triangles_of(UsdGeom.Mesh(each)) for each in Usd.PrimRange(prim) if each.IsA(UsdGeom.Mesh))


def facts_of_tile(tile, boxes):
    below = list(Usd.PrimRange(tile))
    meshes = [each for each in below if each.IsA(UsdGeom.Mesh)]
    instancers = [UsdGeom.PointInstancer(each) for each in below if each.IsA(UsdGeom.PointInstancer)]
    triangles = triangles_below(tile)
    drawn, instances = triangles, 0
    for instancer in instancers:
        sizes = [triangles_below(tile.GetStage().GetPrimAtPath(path)) for path in instancer.GetPrototypesRel().GetForwardedTargets()]
        numbers = list(instancer.GetProtoIndicesAttr().Get())
        placed = instancer.ComputeInstanceTransformsAtTime(Usd.TimeCode.Default(), Usd.TimeCode.Default())
        assert len(placed) == len(numbers), instancer.GetPath()
        drawn += sum(sizes[number] for number in numbers) - sum(sizes)
        instances += len(numbers)
    box = boxes.ComputeWorldBound(tile).ComputeAlignedRange()
    bound = {mesh.GetPath(): UsdShade.MaterialBindingAPI(mesh).ComputeBoundMaterial()[0] for mesh in meshes}
    return {"drawn": drawn, "triangles": triangles, "instances": instances, "low": list(box.GetMin()), "high": list(box.GetMax()),
            "unbound": [str(path) for path, material in bound.items() if not material],
            "materials": sorted({material.GetPrim().GetName() for material in bound.values() if material})}


def issues_of(stage):
    found = collections.Counter((issue.rule.__name__ if issue.rule else "", issue.severity.name, issue.message)
                                for issue in ValidationEngine().validate(stage).issues())
    return [[*issue, count] for issue, count in found.items()]


def facts_of_level(path, level):
    stage = with_level(path, level)
    boxes = UsdGeom.BBoxCache(Usd.TimeCode.Default(), [UsdGeom.Tokens.default_])
    tiles = stage.GetPrimAtPath("/scene/tiles").GetChildren()
    flat = Usd.Stage.Open(stage.Flatten())
    return {"level": level, "errors": [str(error) for error in stage.GetCompositionErrors()],
            "metres": UsdGeom.GetStageMetersPerUnit(stage), "up": UsdGeom.GetStageUpAxis(stage),
            "tiles": {tile.GetName(): facts_of_tile(tile, boxes) for tile in tiles},
            "flat": {tile.GetName(): triangles_below(flat.GetPrimAtPath(tile.GetPath())) for tile in tiles}, "issues": issues_of(stage)}


scene, out = sys.argv[1:]
facts = [facts_of_level(scene, level) for level in levels_of(scene)]
with open(out, "w", encoding="utf-8") as file:
    json.dump(facts, file)
