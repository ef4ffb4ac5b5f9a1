// Meshes simplified to a number of triangles by two libraries, for comparison with levels made from recipes.
#pragma once

#include <cstddef>
#include <vector>

#include "compiler/bake/baked_tile.h"

namespace citykiln::charts {

/// A simplifier. Returns primitives with about `triangles` triangles, or more if it cannot reach so few. Each primitive
/// is simplified on its own, to its share of the triangles, after its vertices are welded by position.
using Simplify = std::vector<bake::Primitive> (*)(const std::vector<bake::Primitive>& primitives,
                                                  std::size_t triangles);

/// Simplifies by OpenMesh, as for the inner tiles of a tile tree (simplify/decimate.h).
std::vector<bake::Primitive> simplified_by_openmesh(const std::vector<bake::Primitive>& primitives,
                                                    std::size_t triangles);

/// Simplifies by meshopt_simplify().
std::vector<bake::Primitive> simplified_by_meshoptimizer(const std::vector<bake::Primitive>& primitives,
                                                         std::size_t triangles);

/// Returns the primitives with one normal per triangle.
std::vector<bake::Primitive> with_flat_normals(std::vector<bake::Primitive>&& primitives);

}  // namespace citykiln::charts
