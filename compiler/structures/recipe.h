// What leaves the ground: bridges, and tunnels below it.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/roads/recipe.h"

namespace citykiln::structures {

/// How a span's axis ends.
enum class EndKind : std::uint8_t {
  kFree,        ///< Meets nothing: cut square.
  kGround,      ///< On the ground, at the end of the road that goes on there: square to that road.
  kBesideRoad,  ///< On the ground, beside a road that passes: cut square where that road ends.
  kJoint,       ///< Another span of its kind goes on: both are mitred to the middle of the bend.
  kCount
};

struct SpanEnd {
  EndKind kind{};
  Vec2 beyond{};     ///< Of kGround and kJoint: the next point of what goes on. Plane metres, snapped.
  double cut_m = 0;  ///< Of kBesideRoad: of the axis, what lies on the road that passes; a multiple of 1/4 m, below 64.
  bool operator==(const SpanEnd&) const = default;
};

/// Columns or a wall under a deck, square to its axis.
struct Pier {
  double at_m = 0;    ///< Along the way from its beginning; a multiple of 1/4 m.
  double foot_m = 0;  ///< Plane height of where it ends, below the ground; a multiple of 1/4 m.
  bool operator==(const Pier&) const = default;
};

/// Where one of a deck's edges lies on another deck: no parapet stands there.
struct ParapetGap {
  double from_m = 0, to_m = 0;  ///< Along the way from its beginning; multiples of 1/4 m, from_m < to_m.
  bool operator==(const ParapetGap&) const = default;
};

/// A road on a deck or in a bore, whole: never trimmed. Its profile is the top of its road.
struct Span : roads::Road {
  SpanEnd from, to;                               ///< At the first and the last point of the axis.
  std::vector<Pier> piers;                        ///< Of bridges. Sorted along the axis, strictly.
  std::vector<ParapetGap> left_gaps, right_gaps;  ///< Of bridges. Sorted, apart.
  bool is_bored = false;  ///< Of tunnels: false where there is no land above it to bore through.
  std::int8_t layer = 0;  ///< As the map tells it, -10 to 10: of two that cross the higher is above.
  bool operator==(const Span&) const = default;
};

}  // namespace citykiln::structures
