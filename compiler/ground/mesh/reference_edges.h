// Finds the edges of the reference about faces of a mesh that are outside the tolerance. With these edges as its own,
// the mesh equals the reference there.
#pragma once

#include <array>
#include <span>
#include <utility>
#include <vector>

#include "compiler/ground/mesh/reference.h"

namespace citykiln::ground {

/// The distance from the cell's border at which edges end that must not add a vertex to it. It is small compared with
/// the length over which the ground rises by a tolerance, and large compared with the grid, which bends shortened
/// edges.
inline constexpr double kFromBorder_m = 0x1p-6;

/// Returns the edges of the reference's faces that overlap any of the triangles, without repeats, each from its lower
/// end to its upper one, sorted. Empty if the reference is the terrain.
///
/// @param triangles  Triangles in plan, counter-clockwise, in the closed cell.
/// @param kept       The vertices of a mesh on the cell's border, sorted.
/// Edges on the cell's border are left out. Edges that would end on the border at a place that is not in `kept` are
/// shortened by kFromBorder_m or left out, so that no edge adds a vertex to the border. O(faces · triangles).
std::vector<std::pair<GridPoint, GridPoint>> edges_about(const Reference& reference,
                                                         std::span<const std::array<GridPoint, 3>> triangles,
                                                         std::span<const GridPoint> kept);

/// Returns the points that lie on the border of a cell, sorted.
std::vector<GridPoint> points_on_border(std::span<const GridPoint> points, const Box2& cell);

}  // namespace citykiln::ground
