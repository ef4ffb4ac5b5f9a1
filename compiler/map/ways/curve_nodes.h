// Ids of nodes that the map does not have: points of curves between mapped nodes.
#pragma once

#include <cstdint>
#include <limits>

#include "compiler/contract/stable_id.h"

namespace citykiln::map {

/// The highest node id of a point of a curve. Ids of mapped nodes are above it. Ids of places where
/// ways are cut (map/rails_in_streets.cpp) are below all ids of curves.
inline constexpr std::int64_t kHighestCurveNode = std::numeric_limits<std::int64_t>::min() / 4;
/// Ids of curves are above it: the product of the ways, parts and points below.
inline constexpr std::int64_t kBelowCurveNodes = kHighestCurveNode - (std::int64_t{1} << 60);

/// Returns the node id of a point of a curve. Ids differ for parts of ways below 2^10, n below 2^16
/// and ids of ways from 1 to 2^34; larger parts and n wrap around.
/// @param way  A piece of a way.
/// @param n    The index of the point in the piece's curved axis.
constexpr std::int64_t curve_node_id(ObjectId way, std::uint32_t n) {
  constexpr std::int64_t kPerPiece = 1 << 16, kPieces = 1 << 10;
  const std::int64_t piece = way.osm.id * kPieces + way.part % kPieces;
  return kHighestCurveNode - piece * kPerPiece - n % kPerPiece;
}

/// True for the node id of a point of a curve.
constexpr bool is_curve_node(std::int64_t node_id) {
  return node_id <= kHighestCurveNode && node_id > kBelowCurveNodes;
}

}  // namespace citykiln::map
