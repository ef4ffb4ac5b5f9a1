// Leaves that are modelled by their outline: a polygon of an L-system with many corners, such as those of .family
// files.
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

/// Returns a ring with fewer corners, at least three, in the order of the ring: the corners that are left out are at
/// most `bend_m` from the edges that replace theirs. The result begins at the corner that is farthest from ring[0].
///
/// Source: Douglas and Peucker, Cartographica 10, 1973. The ring is divided at that corner and at the one that is
/// farthest from it. If no third corner is needed, the one that is farthest from the line between these two is kept.
/// O(n log n) as a rule, at worst O(n²).
/// @param ring  At least three corners, in metres.
std::vector<Vec3> simplified_outline(std::span<const Vec3> ring, double bend_m);

/// Returns a nearly flat ring as a mesh: its positions are the corners, and its n - 2 triangles are counter-clockwise
/// seen from where `front` points. The order of the corners is reversed if they are clockwise from there. Cost: that of
/// lsystems::triangulate_ring().
/// @param ring   At least three corners; ring[1] - ring[0] is not parallel to `front`.
/// @param front  Any length above 0.
Mesh outline_mesh(std::vector<Vec3> ring, Vec3 front);

}  // namespace citykiln::plants
