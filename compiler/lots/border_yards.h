// Draws the borders of lots: hedges, fences and walls.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "compiler/geometry/arrangement.h"
#include "compiler/lots/lay_yard.h"
#include "compiler/lots/mapped_things.h"
#include "compiler/lots/plan_lots.h"
#include "compiler/lots/yard_rules.h"

namespace citykiln::lots {

/// The edges of all lots, so that each finds its neighbour.
struct SharedEdges {
  struct Entry {
    GridPoint low, high;
    std::uint32_t lot;  ///< An index.
    auto operator<=>(const Entry&) const = default;
  };
  std::vector<Entry> entries;  ///< Sorted.
};
/// Returns the edges of the outer rings. O(n log n).
SharedEdges index_edges(std::span<const Lot> lots);

/// The things that borders keep clear of.
struct BorderObstacles {
  const MappedThings& mapped;
  Capsules openings;       ///< Paths and drives of all yards.
  Capsules street_fronts;  ///< Strips of streets. A place with clearance 0 lies on the edge of one.
};

/// Returns the barriers of one lot, without ids and widths; none if rules[lot] is empty.
///
/// The rule's `street` applies along streets and at the sides of the front yard, `sides` everywhere else. Barriers
/// along a street stand 0.625 m inside the lot, the others on its border. The common edge of two neighbours with rules
/// belongs to the one whose parcel has the lower id. No barrier stands
///
/// - at paths, drives, roads, trees and walls of buildings, or within 1.5 m of a mapped barrier;
/// - under the rule `street`, at junctions (MappedThings::junction_zones), or if a barrier is mapped in the lot.
/// @param lot    An index of lots.
/// @param rules  One for each lot.
std::vector<map::Barrier> barriers_of(std::uint32_t lot, std::span<const Lot> lots,
                                      std::span<const std::optional<YardRule>> rules, const SharedEdges& edges,
                                      const BorderObstacles& obstacles);

}  // namespace citykiln::lots
