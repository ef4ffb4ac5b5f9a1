// The people at one spot: one, or a small group.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/people/spot.h"

namespace citykiln::people {

/// One of the people at a spot.
struct Member {
  Vec2 at{}, facing{};     ///< Plane metres; facing has length 1, to within rounding.
  std::uint16_t body = 0;  ///< A row of body_models.inc.
};

/// Returns the people at a spot, all within kSpotRadius_m of it, at least 0.5 m apart:
///
/// - who waits looks at the street or the crossing, who sits looks ahead;
/// - others walk one way side by side, look at the houses, or stand face to face. Children come with adults.
std::vector<Member> members_at(const Spot& spot, std::uint64_t seed);

}  // namespace citykiln::people
