// Which surfaces share a border.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "compiler/ground/recipe.h"

namespace citykiln::ground {

/// Two points, the lower first.
using Edge = std::pair<Vec2, Vec2>;

/// The edges that have a member on either side, sorted; not those of two that lie on top of each other. O(n log n).
std::vector<Edge> edges_between(std::span<const LandCoverPolygon> surfaces, std::span<const std::uint32_t> members);

/// Pairs of places in `members`, the lower first, sorted, each once: surfaces with an edge between the same two points,
/// in whichever direction, and surfaces one of which has a vertex within the other.
///
/// @param members  Indices of surfaces.
/// Cost: sorts the edges; then, for pairs whose boxes touch, vertices times borders in their bands.
std::vector<std::pair<std::uint32_t, std::uint32_t>> shared_borders(std::span<const LandCoverPolygon> surfaces,
                                                                    std::span<const std::uint32_t> members);

/// The lowest member of the group that each of `count` things is in, things of a pair being in one group.
std::vector<std::uint32_t> groups_of(std::size_t count, std::span<const std::pair<std::uint32_t, std::uint32_t>> pairs);

}  // namespace citykiln::ground
