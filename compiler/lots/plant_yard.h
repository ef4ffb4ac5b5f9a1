// Plants trees and shrubs in yards.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/contract/random_sequence.h"
#include "compiler/lots/border_yards.h"
#include "compiler/lots/lay_yard.h"

namespace citykiln::lots {

/// A plant of a yard.
struct YardPlant {
  Vec2 at;  ///< Snapped.
  bool is_shrub = false;
  double height_m = 0;  ///< 0: as usual for its species.
};

/// The most plants of a yard.
inline constexpr std::size_t kMostPlants = 48;

/// Returns the plants of a yard: one candidate in the middle of each square of 4 m of a grid of the plane, moved at
/// random by up to 1.2 m, so that two are at least 1.6 m apart. A candidate is kept with the rule's density on lawn,
/// gravel and earth. It stands at least
///
/// - 3 m (shrubs 2 m) from walls: a crown of 2 m reaches no roof, and eaves are at most 1.5 m wide;
/// - 1 m from pavements, paths and drives, 0.75 m from barriers and the lot's border;
/// - outside of the corridors of wires (kClearOfWires_m) and of crossings (kSight_m).
/// No trees stand where one is mapped in the lot.
std::vector<YardPlant> plants_of(const Lot& lot, const YardRule& rule, const YardGround& ground,
                                 const BorderObstacles& obstacles, const RandomSequence& draw);

}  // namespace citykiln::lots
