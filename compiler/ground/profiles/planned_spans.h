// Bridges and tunnels with decided profiles, as the grading of the terrain takes them.
#pragma once

#include <vector>

#include "compiler/ground/profiles/plan_profiles.h"

namespace citykiln::ground {

struct PlannedSpans {
  std::vector<roads::Road> decks;  ///< Bridges: the land keeps below them.
  std::vector<roads::Road> bores;  ///< Tunnels whose ceiling lies under the terrain for most of their length.
};

/// Returns the spans that are driven on, not those of paths. O(length of tunnels).
PlannedSpans planned_spans(const map::Features& features, const Profiles& profiles, const map::Heightfield& heights);

}  // namespace citykiln::ground
