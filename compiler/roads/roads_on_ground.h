// Turns tracks on the ground into roads.
#pragma once

#include <span>
#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/map/features.h"
#include "compiler/roads/recipe.h"

namespace citykiln::roads {

/// Returns the track as a road: its members of the same names, without width limits. TrackPoint::reach_quarters of its
/// points is as in the track, which is 0; roads_on_ground() sets it.
Road road_of(const map::Track& track);

/// Returns the tracks on the ground as roads, in the order of features.tracks, which is by id. At level crossings of
/// railways it sets TrackPoint::reach_quarters to the largest length that a crossing road or path on the ground covers;
/// at most 255, which is 63.75 m.
///
/// Ledger "roads/track": tracks on bridges and in tunnels become structures and count as merged. Cannot fail.
/// O(n log n) in the vertices of tracks.
std::vector<Road> roads_on_ground(const map::FeatureView& features, Report& report);

/// Returns the ids of the ways that are tagged to lead through buildings (Track::is_through_building) or have a
/// passageway in one. Sorted; an id may occur several times. O(n log n).
std::vector<OsmId> ways_through_buildings(std::span<const map::Track> tracks,
                                          std::span<const map::Passageway> passageways);

}  // namespace citykiln::roads
