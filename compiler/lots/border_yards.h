// Decides where on the borders of lots hedges, fences and walls stand.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "compiler/geometry/arrangement.h"
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

/// Returns the barriers of one lot as runs of steps of its outer ring (border_steps() of draw_yard.h); none if
/// rules[lot] is empty.
///
/// The common edge of two neighbours with rules
/// belongs to the one whose parcel has the lower id. No barrier stands
///
/// - at paths, drives, roads, trees and walls of buildings, or within 1.5 m of a mapped barrier;
/// - along streets and beside the front yard, at junctions (MappedThings::junction_zones), or if a barrier is mapped in
/// the lot.
/// @param lot    An index of lots.
/// @param rules  One for each lot.
std::vector<BorderRun> borders_of(std::uint32_t lot, std::span<const Lot> lots,
                                  std::span<const std::optional<YardRule>> rules, const SharedEdges& edges,
                                  const BorderObstacles& obstacles);

}  // namespace citykiln::lots
