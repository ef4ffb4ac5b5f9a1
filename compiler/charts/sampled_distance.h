// Distances between baked meshes by samples.
#pragma once

#include <span>
#include <vector>

#include "compiler/bake/baked_tile.h"
#include "compiler/simplify/triangle_tree.h"

namespace citykiln::charts {

/// The triangles of all primitives, and of the copies of instanced meshes that are not turned.
std::vector<simplify::Corners> triangles_in(const bake::BakedTile& tile);

/// The largest distance of samples of `from` to `to`: all corners, and points spread evenly over the area, the same
/// each time.
double sampled_distance_m(std::span<const simplify::Corners> from, const simplify::TriangleTree& to);

}  // namespace citykiln::charts
