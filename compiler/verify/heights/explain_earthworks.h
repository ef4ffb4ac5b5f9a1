// Gives reasons for cuts and fills beyond the limit of their kind, and finds those that a defect of the heightmap
// causes: the land at the line is a peak or a hole that stands alone, since on a whole ring around it the land is at
// the height of the line.
//
//              _____
//             |     |          A slope does not stand alone: the land is higher on one side and lower on the other.
//    _________|. . .|_______   A ridge or a valley does not either, since it reaches as far as the ring.
//         line
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "compiler/outputs/findings.h"
#include "compiler/verify/heights/measure_earthworks.h"

namespace citykiln::verify {

/// The reasons, in the order in which they are tried. The first that holds is the reason.
enum class EarthworkReason : std::uint8_t {
  kFinding,      ///< A finding about the line's heights: too steep, lowered for a tunnel, water that must not rise.
  kLandform,     ///< A retaining wall, cliff, dyke, dam or pier within kLandformReach_m.
  kMouth,        ///< The end of a bridge or tunnel within kMouthNear_m.
  kNone,         ///< None of these, and the land does not stand alone.
  kStandsAlone,  ///< None of these, and the land stands alone: the heightmap is probably wrong.
};

std::string_view name_of(EarthworkReason reason);  ///< "finding", "landform", "mouth", "none", "stands alone".

/// A cut or fill beyond the limit of its kind.
struct DeepEarthwork {
  Earthwork earthwork;
  EarthworkReason reason{};
};

/// The distance within which the end of a bridge or tunnel explains an earthwork.
inline constexpr double kMouthNear_m = 64;

/// Returns the earthworks that are deeper than the limit of their kind, each with its reason, in the given order.
///
/// The land stands alone if on a whole ring around the place, of 32, 64, 96 or 128 m radius, the terrain differs from
/// the height of the line by at most a quarter of the earthwork's depth. A ring is sampled at 64 places, and must lie
/// in the scene's extent. Cost for each such earthwork: the landforms and spans of its chunk, and 256 heights.
std::vector<DeepEarthwork> explain_earthworks(const scene::Scene& scene, std::span<const Earthwork> earthworks,
                                              std::span<const outputs::Finding> findings);

}  // namespace citykiln::verify
