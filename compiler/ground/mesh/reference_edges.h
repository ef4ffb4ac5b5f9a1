// The edges of the reference about places where a mesh is off: with them as its own edges, a mesh is the reference
// there.
#pragma once

#include <array>
#include <span>
#include <utility>
#include <vector>

#include "compiler/ground/mesh/reference.h"

namespace citykiln::ground {

/// Small against the length in which the ground rises by a tolerance, large against the grid, which bends shortened
/// edges.
inline constexpr double kFromBorder_m = 0x1p-6;

/// Returns the edges of the reference's faces that overlap any of some triangles.
///
/// @param triangles  In plan, counter-clockwise, in the closed cell.
/// @param kept       The vertices of a mesh on the cell's border, sorted.
/// Returns each edge once, from its lower end to its upper, sorted. Left out: edges on the cell's border, and edges
/// that end there at a place that is not in `kept`, so that no edge adds a vertex to the border. Empty where the
/// reference is the terrain. O(faces · triangles).
std::vector<std::pair<GridPoint, GridPoint>> edges_about(const Reference& reference,
                                                         std::span<const std::array<GridPoint, 3>> triangles,
                                                         std::span<const GridPoint> kept);

/// Returns which points lie on the border of a cell, sorted.
std::vector<GridPoint> points_on_border(std::span<const GridPoint> points, const Box2& cell);

}  // namespace citykiln::ground
