// Meshes simplified by two libraries to a number of triangles, beside the levels that recipes give.
#pragma once

#include <cstddef>
#include <vector>

#include "compiler/bake/baked_tile.h"

namespace citykiln::charts {

/// A simplifier: primitives with about as many triangles as asked for, or more where it cannot go so low. Each
/// primitive is simplified apart, with triangles in proportion; its vertices are welded by position.
using Simplify = std::vector<bake::Primitive> (*)(const std::vector<bake::Primitive>& primitives,
                                                  std::size_t triangles);

/// By OpenMesh as inner tiles of a tile tree use it (simplify/decimate.h).
std::vector<bake::Primitive> simplified_by_openmesh(const std::vector<bake::Primitive>& primitives,
                                                    std::size_t triangles);

/// By meshopt_simplify().
std::vector<bake::Primitive> simplified_by_meshoptimizer(const std::vector<bake::Primitive>& primitives,
                                                         std::size_t triangles);

/// The primitives with one normal for each triangle.
std::vector<bake::Primitive> with_flat_normals(std::vector<bake::Primitive>&& primitives);

}  // namespace citykiln::charts
