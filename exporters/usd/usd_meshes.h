// Writes meshes and instances as USD prims.
#pragma once

#include <span>
#include <string>

#include "exporters/usd/usd_builder.h"

namespace citykiln::exporters {

/// Writes a Mesh prim for each primitive as a child of the open prim, named after its material. Returns the bounds of
/// the prims.
///
/// | attribute                    | value                                                                          |
/// |------------------------------|--------------------------------------------------------------------------------|
/// | points, normals, st          | one per vertex of the primitive; st in units of the image, v up                |
/// | displayColor                 | linear colour of the material times the tint, indexed; constant where all equal |
/// | primvars:feature             | row in the scope "features": one per face, or per vertex where faces mix       |
/// | subdivisionScheme            | none                                                                           |
///
/// Leaves have back sides as in the .glb (gltf/leaf_backs.h); beyond kMostTrianglesWithBacks they are doubleSided.
/// @param cutout  The result of shared_cutout() for an instanced mesh; else null.
UsdBounds write_meshes(UsdBuilder& b, std::span<const bake::Primitive> primitives, const impostor::Cutout* cutout);

/// Writes a PointInstancer "instances" as a child of the open prim, with a prototype for each instanced mesh, and
/// extends the builder's bounds. Orientations have half precision: an error of at most 0.06 degrees.
/// @param path  The path of the open prim.
void write_instances(UsdBuilder& b, const std::string& path, std::span<const bake::InstancedMesh> instanced);

}  // namespace citykiln::exporters
