// Railings that are assumed along drops beside which people walk.
//
//     pavement, footway, square
//     ______________|          |  the railing, 0.2 m inside the edge
//                   |
//                   |______    the ground 1 m beyond the edge is more than 1 m lower
//
// Source: building codes ask for a guard at drops of more than 1 m (Musterbauordnung § 38; 0.76 m in the International
// Building Code 1015.2); its height is 0.9 to 1.1 m.
#pragma once

#include <span>
#include <vector>

#include "compiler/buildings/recipe.h"
#include "compiler/contract/findings/report.h"
#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/map/features.h"
#include "compiler/props/recipe.h"
#include "compiler/structures/recipe.h"

namespace citykiln::things {

/// The fall within kFallWithin_m beyond an edge from which on a railing is assumed, and the height of the railing.
inline constexpr double kGuardedDrop_m = 1, kFallWithin_m = 1, kAssumedRailing_m = 1.125;
/// The distance of the railing from the edge.
inline constexpr double kInsideEdge_m = 0.2;
/// The distance within which a barrier or a door that is mapped leaves no room for a railing.
inline constexpr double kRailingClear_m = 1.5;
/// The radius of influence, beyond that of the heights of the ground: the side of the squares at whose sides railings
/// are cut, and what is tested beside them.
inline constexpr double kRailingSquare_m = 64, kRailingRadius_m = kRailingSquare_m + 8;

/// The data beside which railings are planned.
struct RailingSurroundings {
  std::span<const ground::LandCoverPolygon> cover;  ///< The land cover of the whole map, with buildings.
  std::span<const roads::Road> roads;               ///< On the ground.
  std::span<const structures::Span> bridges;
  std::span<const buildings::Building> buildings;
  const ground::GradedTerrain& ground;  ///< The graded terrain of the whole map.
};

/// Returns railings along the edges of land cover on which people walk at leisure: pavements, paved footways, squares,
/// pedestrian streets and platforms. They stand where the ground 1 m beyond the edge is more than kGuardedDrop_m lower,
/// over at least 3 m. None stand
/// - within kRailingClear_m of a mapped barrier (of a retaining wall only if it is tagged to stand above the upper
///   ground), of a door, or of the deck of a bridge, which has parapets;
/// - at walls of buildings, pools, and edges of platforms beside a track;
/// - where a way leads across the edge.
///
/// The ids are those of the element that is walked on, with the part kFirstDerivedPart. Each railing lies in one square
/// of kRailingSquare_m. Sorted by id, then axis. Counted as Assumption::kRailings, once for each element. Ledger
/// "things/railing". O(length of edges · land cover near).
std::vector<props::Barrier> assumed_railings(const map::FeatureView& features, const RailingSurroundings& around,
                                             Report& report);

}  // namespace citykiln::things
