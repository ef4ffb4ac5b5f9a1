// Finds the edges of a cell's reference (the triangulation of the graded terrain at full detail) about faces of a mesh
// that are outside the tolerance. If the mesh gets these edges, it equals the reference there.
#pragma once

#include <array>
#include <span>
#include <utility>
#include <vector>

#include "compiler/ground/mesh/reference.h"

namespace citykiln::ground {

/// The length by which edges are shortened that would otherwise add a vertex to the cell's border. It is small compared
/// with the length over which the ground rises by a tolerance, and large compared with the 2^-10 m grid, which bends
/// shortened edges.
inline constexpr double kFromBorder_m = 0x1p-6;

/// Returns the edges of the reference's faces that overlap any of the triangles, without repeats, sorted, each from its
/// lower end to its upper one. Empty if the reference is terrain without grading.
///
/// @param triangles  Triangles in plan, counter-clockwise, in the closed cell.
/// @param kept       The vertices that the mesh has on the cell's border, sorted.
///
/// No edge adds a vertex to the border: edges on the border are left out, and edges that end on it at another place
/// than `kept` are shortened by kFromBorder_m or left out. O(faces · triangles).
std::vector<std::pair<GridPoint, GridPoint>> edges_about(const Reference& reference,
                                                         std::span<const std::array<GridPoint, 3>> triangles,
                                                         std::span<const GridPoint> kept);

/// Returns the points that lie on the border of a cell, sorted.
std::vector<GridPoint> points_on_border(std::span<const GridPoint> points, const Box2& cell);

}  // namespace citykiln::ground
