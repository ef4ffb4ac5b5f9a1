// Plans landforms: the heights of tops and feet of retaining walls, cliffs, dykes, dams, piers and breakwaters.
//
// - A step's rise is its tagged height, else that of its kind, but never more than the terrain rises between
//   kLandformReach_m on both sides. Its middle is the mean of both sides.
// - A ridge's crest is its height above the mean of the terrain on both sides.
// - A deck lies above the highest water near it; without water it is a low ridge.
#pragma once

#include <span>
#include <vector>

#include "compiler/contract/report.h"
#include "compiler/ground/landforms/recipe.h"
#include "compiler/ground/recipe.h"
#include "compiler/map/features.h"

namespace citykiln::ground {

/// Returns the landforms, sorted by id.
/// @param surfaces  Land cover, with the levels of standing water.
/// @param streams   Watercourses with their profiles.
///
/// Depends on terrain and water within 2 * kLandformReach_m of each place of an axis, and for decks and dams on the
/// whole object. Reports kPierWithoutWater, and kStepNotInTerrain where a tagged height is more than the terrain rises.
/// Ledger "ground/landform".
std::vector<Landform> plan_landforms(const map::Features& features, std::span<const LandCoverPolygon> surfaces,
                                     std::span<const roads::Strip> streams, const map::Heightfield& heights,
                                     Report& report);

}  // namespace citykiln::ground
