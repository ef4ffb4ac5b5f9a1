// The cloud recipe: layers of clouds. A layer is a few numbers, from which its clouds and their particles are made.
#pragma once

#include <cstdint>
#include <string_view>

#include "compiler/geometry/vec.h"

namespace citykiln::sky {

enum class CloudKind : std::uint8_t {
  kCumulus,  ///< Heaps with flat bases, apart from each other.
  kStratus,  ///< A flat layer of low cloud, closed where its cover is 1.
  kCirrus,   ///< Thin streaks of ice along the wind.
  kCount
};

/// Returns the name of a kind: "cumulus", "stratus", "cirrus".
std::string_view name_of(CloudKind kind);

struct CloudLayer {
  CloudKind kind{};
  double cover = 0.3;                  ///< Share of the sky that it covers, 0 to 1.
  double base_m = 1500, top_m = 2500;  ///< Above sea level. 0 < top_m - base_m.
  Vec2 wind{5, 0};                     ///< The direction in which it blows, m/s, which is also that of streaks.
  std::uint64_t seed = 0;
  bool operator==(const CloudLayer&) const = default;
};

/// Limits of layers, for the command line, files and manifests.
inline constexpr double kLowestCloud_m = -500, kHighestCloud_m = 20000, kThinnestCloud_m = 20, kStrongestWind_m_s = 150;
inline constexpr std::size_t kMostCloudLayers = 8;

/// True if all numbers of a layer are within their limits.
bool is_sound(const CloudLayer& layer);

}  // namespace citykiln::sky
