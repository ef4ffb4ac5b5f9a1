// Dropped kerbs: where people cross a street, the kerb and the pavement behind it are lower.
//
//     pavement  ────────┐          ┌────────      The kerb falls over kKerbRamp_m on both sides;
//               ────────╲__________╱────────      the pavement rises to its outer edge.
//                 ramp    crossing   ramp
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/geometry/box_grid.h"
#include "compiler/roads/pieces/stretches.h"

namespace citykiln::roads {

/// The length over which a kerb falls, along it, in metres.
inline constexpr double kKerbRamp_m = 0.75;
/// The height that is left of a lowered kerb, in metres; flush kerbs have none. Assumed, near the 3 cm of DIN 18040-3.
inline constexpr double kKerbLip_m = 0.025;
/// The length of a kerb that is lowered where people cross without paint, in metres.
inline constexpr double kPlainCrossing_m = 2.5;

/// Returns the stretches of a road with its dropped kerbs. An unpainted crossing becomes a stretch of its own with the
/// markings of the road around it, and stretches are cut where a ramp begins. Roads without raised lanes are unchanged.
///
/// @param stretches  Result of stretches_of().
/// @param intervals  The road's entry of junction_intervals_of(). Unpainted crossings in junctions are left out.
/// @param assumes    True if crossings whose kerbs are not mapped have lowered ones, and tactile paving as usual in
///                   their country (tactile_paving.h).
std::vector<RoadStretch> with_dropped_kerbs(const Road& road, std::vector<RoadStretch> stretches,
                                            std::span<const JunctionInterval> intervals, bool assumes);

/// A dropped kerb on one side of a road.
struct KerbRamp {
  Vec2 at;              ///< On the kerb's face, in the middle of the crossing.
  Vec2 along, outward;  ///< Unit vectors.
  double half_m = 0;    ///< Half of the length that is low.
  double reach_m = 0;   ///< The width of the pavement, over which it rises.
  double lip_m = 0;     ///< The height that is left of the kerb.
};

/// Adds the ramps of a road's dropped kerbs: one on each side with raised lanes.
/// @param stretches  Result of with_dropped_kerbs().
void add_kerb_ramps(const Road& road, std::span<const RoadStretch> stretches, std::vector<KerbRamp>& ramps);

/// Returns the ramps of all roads of a tile.
std::vector<KerbRamp> kerb_ramps_of(std::span<const Road> roads, std::span<const Junction> junctions, double tile_m,
                                    bool assumes);

/// Ramps with a spatial index.
struct KerbRampIndex {
  std::vector<KerbRamp> ramps;
  BoxGrid grid;
};
KerbRampIndex index_kerb_ramps(std::vector<KerbRamp> ramps);

/// Returns by how many metres a dropped kerb lowers raised lanes at p: the largest value of all ramps, 0 far from them.
/// Continuous on raised lanes. O(ramps near).
/// @param kerb_m  The full height of the kerb.
double dropped_m(const KerbRampIndex& index, Vec2 p, double kerb_m);

}  // namespace citykiln::roads
