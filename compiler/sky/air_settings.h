// The settings of the air that a user may give.
#pragma once

#include <optional>

#include "compiler/sky/recipe.h"

namespace citykiln::sky {

/// Limits of the settings, for the command line and for manifests.
inline constexpr double kClearest_km = 300, kHaziest_km = 1;
inline constexpr double kLeastTurbidity = 1, kMostTurbidity = 20;

/// The settings; empty: not given.
struct AirSettings {
  std::optional<double> turbidity{}, visibility_km{}, ground_albedo{};
  bool operator==(const AirSettings&) const = default;
};

/// Copies the settings that are given into a sky. If only the turbidity is given, the visibility becomes the one of
/// aerosols with a scale height of 6 km. Gives equal bits on every CPU.
/// Asserts that turbidity and visibility of the sky are then within the limits above.
void set_air(const AirSettings& settings, Sky& sky);

}  // namespace citykiln::sky
