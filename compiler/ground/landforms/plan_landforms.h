// Plans landforms: the planes of level areas (landforms/level_areas.h), and the heights of retaining walls, cliffs,
// dykes, dams, piers and breakwaters along their axes.
//
// - A step rises by its tagged height, else by that of its kind, but at most as much as the terrain, measured at
//   kLandformReach_m on both sides. A kind without a height takes the rise that the slopes farther out do not explain;
//   so does a retaining wall without a tagged height where that rise is higher than its kind, up to 15 m.
//   Halfway up, the step is at the mean height of both sides.
// - A ridge's crest is its height above the mean of the terrain on both sides.
// - A dam is level: at its tagged height above the lowest place of its axis, else as high as the lower one of its ends,
//   but at least the height of its kind above that place.
// - A deck is level, above the highest water along it; water whose height is not known lies on the terrain. Without
//   water a line becomes a low ridge, and an area is left out.
#pragma once

#include <span>
#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/ground/landforms/recipe.h"
#include "compiler/ground/recipe.h"
#include "compiler/map/features.h"

namespace citykiln::ground {

/// Returns the landforms, sorted by id.
/// @param surfaces  Land cover, with the levels of standing water.
/// @param streams   Watercourses with their profiles.
/// @param heights   The terrain.
///
/// Depends on terrain and water within 2 * kLandformReach_m of each place of an axis, and for decks and dams on the
/// whole object. Steps lower than 0.25 m are left out: a cliff is dropped as kStepNotInTerrain, a retaining wall
/// remains a wall. Reports kPierWithoutWater, and kStepLowered where the terrain rises over 1 m less than a tagged
/// height. Ledger "ground/landform".
std::vector<Landform> plan_landforms(const map::FeatureView& features, std::span<const LandCoverPolygon> surfaces,
                                     std::span<const roads::Strip> streams, const map::Heightfield& heights,
                                     Report& report);

}  // namespace citykiln::ground
