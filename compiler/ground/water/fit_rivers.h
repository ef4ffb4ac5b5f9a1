// Fits the heights of a river network, and leaves out waterways that no fit brings near the terrain, so that they do
// not pull the waterways that they meet off it.
//
//   ~~~.            .~~ B        A leads over a ridge: it stays on the terrain, and B and C are fitted as if it were
//       ~~~ A /\ ~~~             not there.
//            /  \    `~~ C
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/ground/water/river_heights.h"

namespace citykiln::ground {

/// The reason for which a stream stays on the terrain.
enum class Apart : std::uint8_t {
  kNot,        ///< It has heights of its own.
  kRises,      ///< The terrain along it rises more than the errors of its line explain, whatever it meets.
  kLake,       ///< It meets standing water whose level is far from the terrain at the stream.
  kNeighbours  ///< It contradicts waterways that it meets.
};

/// Heights of a network, and its streams that are left out.
struct FittedRivers {
  RiverHeights heights;
  std::vector<Apart> apart;   ///< Per stream.
  std::vector<double> off_m;  ///< Per stream its sustained_depth_m(); if it is left out, the last one with it.
};

/// Fits heights to a network.
///
/// @param seas       For each standing water: true if it is the sea.
/// @param max_off_m  Per stream the largest sustained_depth_m(). The lines of the network begin with the streams.
/// @param run_m      The length of a stretch that counts as sustained.
///
/// Method: in rounds, find_river_heights(), then of all streams that are farther off than allowed, those leave the
/// network that have none beside them with more blame. Streams that are too far off alone have more blame than others,
/// then those that are farther off. After kMaxFits rounds all that are too far off leave.
///
/// Guarantees: streams with heights keep max_off_m. O(kMaxFits n log² n) at worst; a round for each fault that shares
/// its waterways with a larger one.
FittedRivers fit_rivers(const RiverNetwork& network, const std::vector<bool>& seas, std::span<const double> max_off_m,
                        double run_m);

/// The largest number of rounds.
inline constexpr int kMaxFits = 32;

/// Returns the heights of the stops of a line.
std::vector<double> heights_of_stops(const RiverLine& line, const RiverHeights& heights);

/// Returns how far a stream alone would be off the terrain: sustained_depth_m() of its heights without its neighbours,
/// or the largest change of a standing water's level.
double off_alone_m(const RiverNetwork& network, const RiverLine& line, const std::vector<bool>& seas, double run_m);

}  // namespace citykiln::ground
