// The cloud recipe: layers of clouds. A layer is a few numbers, from which clouds are generated; each cloud consists of
// particles (spheres of droplets).
#pragma once

#include <cstdint>
#include <string_view>

#include "compiler/geometry/vec.h"

namespace citykiln::sky {

enum class CloudKind : std::uint8_t {
  kCumulus,  ///< Heaps with flat bases, apart from each other.
  kStratus,  ///< Low cloud in flat layers, without gaps at a cover of 1.
  kCirrus,   ///< Thin streaks of ice along the wind.
  kCount
};

/// Returns the name of a kind: "cumulus", "stratus", "cirrus".
std::string_view name_of(CloudKind kind);

/// A layer of clouds of one kind between two heights.
struct CloudLayer {
  CloudKind kind{};
  double cover = 0.3;                  ///< Share of the sky that the layer covers, 0 to 1.
  double base_m = 1500, top_m = 2500;  ///< Heights above sea level. base_m < top_m.
  Vec2 wind{5, 0};                     ///< Velocity towards east and north, m/s. Streaks of cirrus lie along the wind.
  std::uint64_t seed = 0;
  bool operator==(const CloudLayer&) const = default;
};

/// Limits of layers, for the command line, files and manifests: heights in metres above sea level, the least thickness
/// (top_m - base_m), the speed of the wind.
inline constexpr double kLowestCloud_m = -500, kHighestCloud_m = 20000, kThinnestCloud_m = 20, kStrongestWind_m_s = 150;
inline constexpr std::size_t kMostCloudLayers = 8;

/// True if all numbers of a layer are within their limits.
bool is_sound(const CloudLayer& layer);

}  // namespace citykiln::sky
