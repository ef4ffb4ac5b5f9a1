// Explains cuts and fills beyond the limit of their kind, and finds those that no landscape explains: a line deep under
// a peak, or high over a hole, that stands alone in the land at the height of the line. Such land is a defect of the
// heightmap.
//
//              _____
//             |     |          a slope explains a cut: the land about is higher on one side and lower on the other.
//    _________|. . .|_______   A ridge or a valley does too, since it reaches as far as the ring about the place.
//         line
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "compiler/outputs/findings.h"
#include "compiler/verify/measure_earthworks.h"

namespace citykiln::verify {

/// The reasons, in the order in which they are looked for.
enum class EarthworkReason : std::uint8_t {
  kFinding,      ///< A finding about the line's heights: too steep, lowered for a tunnel, water that must not rise.
  kLandform,     ///< A retaining wall, cliff, dyke, dam or pier near the place.
  kMouth,        ///< The end of a bridge or tunnel near the place.
  kNone,         ///< None of these; the land about has the relief for it.
  kStandsAlone,  ///< None of these; the land at the place stands alone.
};

std::string_view name_of(EarthworkReason reason);  ///< "finding", "landform", "mouth", "none", "stands alone".

/// A cut or fill beyond the limit of its kind.
struct DeepEarthwork {
  Earthwork earthwork;
  EarthworkReason reason{};
};

/// The distance of a bridge's or tunnel's end that explains an earthwork, metres.
inline constexpr double kMouthNear_m = 64;

/// Returns the earthworks that are deeper than the limit of their kind, each with its reason, in the given order.
///
/// Land stands alone if the terrain on a whole ring about the place, of 32, 64, 96 or 128 m radius, differs from the
/// height of the line by at most a quarter of the depth. The ring is sampled at 64 places, 12.6 m apart or less; it
/// must lie in the scene's extent. Cost: O(landforms + spans) per chunk with such an earthwork, 256 heights for each.
std::vector<DeepEarthwork> explain_earthworks(const scene::Scene& scene, std::span<const Earthwork> earthworks,
                                              std::span<const outputs::Finding> findings);

}  // namespace citykiln::verify
