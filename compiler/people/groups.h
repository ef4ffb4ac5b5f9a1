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

/// Returns the people at a spot, one or two, within kSpotRadius_m of it and at least 0.5 m apart:
///
/// - at stops, crossings and benches one person, who faces Spot::towards;
/// - elsewhere one or two walkers along Spot::along, one person who faces Spot::towards, or two who face each other.
///
/// The second person of a pair may be a child. Directions are turned by up to 20 degrees at random, except on benches.
std::vector<Member> members_at(const Spot& spot, std::uint64_t seed);

}  // namespace citykiln::people
