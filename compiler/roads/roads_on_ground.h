// Turns tracks on the ground into roads.
#pragma once

#include <span>
#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/map/features.h"
#include "compiler/roads/recipe.h"

namespace citykiln::roads {

/// Returns the track as a road, at its full width.
Road road_of(const map::Track& track);

/// Returns the roads of all tracks on the ground, sorted by id. Ledger "roads/track": tracks on bridges and in tunnels
/// become structures and count as merged. O(n).
std::vector<Road> roads_on_ground(const map::FeatureView& features, Report& report);

/// Returns the ids of the ways that are tagged to lead through buildings or have a passageway in one, sorted. O(n).
std::vector<OsmId> ways_through_buildings(std::span<const map::Track> tracks,
                                          std::span<const map::Passageway> passageways);

}  // namespace citykiln::roads
