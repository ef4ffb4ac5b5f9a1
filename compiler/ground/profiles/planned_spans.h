// Selects the bridges and tunnels that limit the height of the land: land lies below decks and above bores.
#pragma once

#include <vector>

#include "compiler/ground/profiles/plan_profiles.h"

namespace citykiln::ground {

/// The least share of a bore's ceiling that is below the terrain, not counting kPortalLength_m at both ends, and the
/// spacing of samples.
inline constexpr double kMinCoveredShare = 0.6, kPortalLength_m = 16, kCoverSample_m = 4;

/// True for a path or service road that enters a tunnel on the ground, at most 1.75 m deep, where no slope rises above
/// the mouth: stairs, lifts or ramps lead down, in a house or a kiosk. The land would be a mound over such a mouth.
bool enters_from_above(const roads::Road& tunnel, const map::Heightfield& heights);

/// Bridges and tunnels as roads with profiles.
struct PlannedSpans {
  std::vector<roads::Road> decks;  ///< Bridges; the land is below them.
  std::vector<roads::Road> bores;  ///< Tunnels whose ceiling is below the terrain for most of their length.
};

/// Returns the bridges and tunnels of roads and rails, not those of paths. O(length of tunnels).
PlannedSpans planned_spans(const map::FeatureView& features, const Profiles& profiles, const map::Heightfield& heights);

}  // namespace citykiln::ground
