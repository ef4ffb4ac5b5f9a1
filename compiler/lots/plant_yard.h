// Plants trees and shrubs in yards.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/contract/random_sequence.h"
#include "compiler/lots/border_yards.h"

namespace citykiln::lots {

/// A plant of a yard.
struct YardPlant {
  Vec2 at;  ///< Snapped.
  bool is_shrub = false;
  double height_m = 0;  ///< 0: as usual for its species.
};

/// The most plants of a yard. Squares are filled row by row from the south; beyond that, the north stays empty.
inline constexpr std::size_t kMostPlants = 48;

/// Returns the plants of a yard: one candidate in the middle of each square of 4 m of a grid of the plane, moved at
/// random by up to 1.2 m, so that two are at least 1.6 m apart. A candidate is kept with the rule's density on lawn,
/// gravel and earth. It stands at least
///
/// - 3 m (shrubs 2 m) from walls: a crown of 2 m reaches no roof, and eaves are at most 1.5 m wide;
/// - 1 m from pavements, paths and drives, 0.75 m from barriers and the lot's border, 2 m from mapped trees;
/// - outside of pools, of the corridors of wires (kClearOfWires_m) of the zones about junctions (kSight_m), and of
///   the surfaces of junctions and the outer corners of bends.
/// No trees stand where one is mapped in the lot.
/// @param barriers  The barriers of the lot (barriers_of()).
/// @param draw      The random numbers of the lot; indices from 16 on are used.
std::vector<YardPlant> plants_of(const Lot& lot, const YardRule& rule, std::span<const map::Barrier> barriers,
                                 const BorderObstacles& obstacles, const RandomSequence& draw);

}  // namespace citykiln::lots
