// The settings of the air that a user may give.
#pragma once

#include <optional>

#include "compiler/sky/recipe.h"

namespace citykiln::sky {

/// Limits of the settings, for the command line and for manifests. set_air() asserts them and clamps nothing. The
/// ground's albedo is from 0 to 1.
inline constexpr double kClearest_km = 300, kHaziest_km = 1;
inline constexpr double kLeastTurbidity = 1, kMostTurbidity = 20;

/// The settings, with the meanings and units of Sky. Empty: not given, the sky keeps its value.
struct AirSettings {
  std::optional<double> turbidity{}, visibility_km{}, ground_albedo{};
  bool operator==(const AirSettings&) const = default;
};

/// Copies the settings that are given into a sky. If the turbidity is given without a visibility, the visibility
/// becomes the one of aerosols with a scale height of 6 km, clamped to its limits. Gives equal bits on every CPU.
///
/// Precondition, asserted: turbidity and visibility of the resulting sky are within the limits above. The albedo is not
/// checked; manifests with one outside 0 … 1 are refused when they are read.
void set_air(const AirSettings& settings, Sky& sky);

}  // namespace citykiln::sky
