// Finds land cover polygons that share a border.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "compiler/ground/recipe.h"

namespace citykiln::ground {

/// Two points in plane metres, the smaller first: compared by x, then by y.
using Edge = std::pair<Vec2, Vec2>;

/// Returns the edges with members on both sides, sorted: rings of members run along them in both directions. The two
/// sides may be one polygon. Edges with rings in one direction only, as where members lie on top of each other, are
/// left out. O(n log n).
/// @param members  Indices of polygons.
std::vector<Edge> edges_between(std::span<const LandCoverPolygon> surfaces, std::span<const std::uint32_t> members);

/// Returns pairs of members, as indices into `members`: polygons with a common edge in either direction, and polygons
/// one of which has a vertex inside the other. The smaller index is the first of a pair. Pairs are sorted, without
/// repeats.
///
/// @param members  Indices of polygons.
/// O(n log n) in edges, plus vertices times edges in their bands for pairs whose boxes touch.
std::vector<std::pair<std::uint32_t, std::uint32_t>> shared_borders(std::span<const LandCoverPolygon> surfaces,
                                                                    std::span<const std::uint32_t> members);

/// Returns for each number below `count` the lowest number of its group. Numbers of a pair are in one group.
std::vector<std::uint32_t> groups_of(std::size_t count, std::span<const std::pair<std::uint32_t, std::uint32_t>> pairs);

}  // namespace citykiln::ground
