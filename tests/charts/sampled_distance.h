// Measures the distance between baked meshes by samples.
#pragma once

#include <span>
#include <vector>

#include "compiler/bake/baked_tile.h"
#include "compiler/simplify/triangle_tree.h"

namespace citykiln::charts {

/// Returns the triangles of all primitives, and of all instances, moved and scaled but not rotated. In the tile's
/// frame.
std::vector<simplify::Corners> triangles_in(const bake::BakedTile& tile);

/// Returns the largest distance from samples of `from` to `to`. The samples are all corners, and points spread evenly
/// over the area. Deterministic.
double sampled_distance_m(std::span<const simplify::Corners> from, const simplify::TriangleTree& to);

}  // namespace citykiln::charts
