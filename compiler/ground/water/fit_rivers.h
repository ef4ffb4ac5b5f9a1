// Fits the heights of a river network, and leaves out waterways that no fit brings near the
// terrain, so that they do not pull the waterways that they meet off it.
//
//   ~~~.            .~~ B        A leads over a ridge: it stays on the terrain, and B and C are
//       ~~~ A /\ ~~~             fitted as if it were not there.
//            /  \    `~~ C
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/ground/water/river_heights.h"

namespace citykiln::ground {

/// The reason for which a stream is left out of the fit and stays on the terrain.
enum class Apart : std::uint8_t {
  kNot,        ///< It is in the fit, with heights of its own.
  kRises,      ///< It is too far off the terrain even alone (off_alone_m()).
  kLake,       ///< It is too far off only with others, and meets standing water.
  kNeighbours  ///< It is too far off only with others, and meets no standing water.
};

/// The heights of a network, and its streams that are left out.
struct FittedRivers {
  RiverHeights heights;
  std::vector<Apart> apart;   ///< Per stream.
  std::vector<double> off_m;  ///< Per stream its sustained_depth_m() in the last round that had it.
};

/// Fits heights to a network, and leaves out the streams that are too far off the terrain.
///
/// @param seas       For each standing water: true if it is the sea.
/// @param max_off_m  Per stream the largest allowed sustained_depth_m(), in metres. Streams are the
///                   first lines of the network; other lines, such as culverts, are always in the
///                   fit.
/// @param run_m      The length in metres of a stretch that counts as sustained.
///
/// Method: each round calls find_river_heights() for the streams that are left, and finds the
/// offenders: streams that are farther off than allowed. An offender that is so even alone has more
/// blame than others, then one that is farther off. A round leaves out each offender that shares no
/// node with one of more blame. Round kCarefulRounds and later ones leave out all offenders. Rounds end
/// when there is none.
///
/// Guarantees: streams with heights are within max_off_m. O(rounds · n log² n); a round is needed
/// for each fault that shares its waterways with a larger one.
FittedRivers fit_rivers(const RiverNetwork& network, const std::vector<bool>& seas, std::span<const double> max_off_m,
                        double run_m);

/// The first round that leaves out all streams that are too far off at once.
inline constexpr int kCarefulRounds = 32;

/// Returns the heights of the stops of a line, in their order, in metres.
std::vector<double> heights_of_stops(const RiverLine& line, const RiverHeights& heights);

/// Returns how far off the terrain a stream would be without its neighbours, in metres:
/// sustained_depth_m() of heights_alone(), or the largest difference of a standing water on it from
/// its level, if that is more.
double off_alone_m(const RiverNetwork& network, const RiverLine& line, const std::vector<bool>& seas, double run_m);

}  // namespace citykiln::ground
