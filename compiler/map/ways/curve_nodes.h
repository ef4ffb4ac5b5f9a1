// The node ids of points between mapped nodes, which axes have where they are curves.
#pragma once

#include <cstdint>
#include <limits>

#include "compiler/contract/stable_id.h"

namespace citykiln::map {

/// Curves' node ids are not above this: below those of maps, and apart from those of places where ways are cut
/// (map/rails_in_streets.cpp).
inline constexpr std::int64_t kHighestCurveNode = std::numeric_limits<std::int64_t>::min() / 4;

/// Returns the node id of a point of a curve: the n-th point of the axis of a piece of a way.
constexpr std::int64_t curve_node_id(ObjectId way, std::uint32_t n) {
  constexpr std::int64_t kPerPiece = 1 << 16, kPieces = 1 << 10;
  const std::int64_t piece = way.osm.id * kPieces + way.part % kPieces;
  return kHighestCurveNode - piece * kPerPiece - n % kPerPiece;
}

/// True for the node id of a point of a curve.
constexpr bool is_curve_node(std::int64_t node_id) { return node_id <= kHighestCurveNode; }

}  // namespace citykiln::map
