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

/// The things that borders keep clear of. Refers to `mapped`, which must outlive it.
struct BorderObstacles {
  const MappedThings& mapped;
  Capsules openings;       ///< Paths and drives of all yards.
  Capsules street_fronts;  ///< Strips of streets: their edges are the borders of lots to them.
};

/// Returns the barriers of one lot as runs of segments of its outer ring (border_segments() of draw_yard.h), sorted by
/// their first; none if rules[lot] is empty.
///
/// The common edge of two neighbours with rules belongs to the lot whose parcel has the lower id. No barrier stands
///
/// - within 0.5 m of walls and trees, 0.375 m of paths, drives and openings, 0.25 m of roads, or 1.5 m of a mapped
///   barrier;
/// - along a street or at a side of the front: in a zone about a junction (MappedThings::junction_zones), or anywhere
/// in
///   a lot with a mapped barrier.
///
/// @param lot    Index into lots.
/// @param rules  One for each lot.
/// O(length of the ring · things near).
std::vector<BorderRun> borders_of(std::uint32_t lot, std::span<const Lot> lots,
                                  std::span<const std::optional<YardRule>> rules, const SharedEdges& edges,
                                  const BorderObstacles& obstacles);

}  // namespace citykiln::lots
