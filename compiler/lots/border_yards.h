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

/// A line of a border.
struct YardBarrier {
  Polyline axis;  ///< Snapped, at least two points.
  map::BarrierKind kind{};
  double height_m = 0;
};

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
  Capsules street_fronts;  ///< The edges of the strips of streets.
};

/// Returns the barriers that a lot has: along streets as its rule for the street says, and inside the lot by the width
/// of half of it; beside the house and behind it as its rule for the sides says. The border between two neighbours is
/// that of the one with the lower id. There are none
///
/// - at paths, drives, mapped ways, pavements, walls of buildings, and crossings (kSight_m);
/// - where a barrier is mapped within 1.5 m; along the street also if one is mapped in the lot.
std::vector<YardBarrier> barriers_of(std::uint32_t lot, std::span<const Lot> lots,
                                     std::span<const std::optional<YardRule>> rules, const SharedEdges& edges,
                                     const BorderObstacles& obstacles);

}  // namespace citykiln::lots
