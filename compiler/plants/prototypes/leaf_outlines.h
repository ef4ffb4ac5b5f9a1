// Leaves that are mapped by their outline: a polygon of an L-system with many corners, such as those of .family files.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "compiler/geometry/mesh.h"
#include "compiler/geometry/vec.h"

namespace citykiln::plants {

/// Polygons with at least this many corners are outlines; blades of grass and leaflets have fewer.
inline constexpr std::size_t kOutlineCorners = 8;
/// Plants with more outlines than this show them as cards.
inline constexpr std::size_t kMostOutlines = 16;

/// Returns the corners of a ring that are left without those that are at most `bend_m` from the rest, at least three.
/// Source: Douglas and Peucker, Cartographica 10, 1973, from the two corners that are farthest apart. At worst O(n²).
std::vector<Vec3> simplified_outline(std::span<const Vec3> ring, double bend_m);

/// Returns the triangles of a nearly flat ring; their front is where `front` points, which is not 0.
Mesh outline_mesh(std::vector<Vec3> ring, Vec3 front);

}  // namespace citykiln::plants
