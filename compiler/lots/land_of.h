// Makes the land that parcels divides of a map and its planned roads.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/map/features.h"
#include "compiler/parcels/parcels.h"
#include "compiler/roads/recipe.h"

namespace citykiln::lots {

/// A lot begins this far inside the pavement, which lies on top of it: no gap is seen between the two, but for up to
/// 5 cm in bends, where outlines are coarse (coarse_outlines.h).
inline constexpr double kUnderPavement_m = 0.25;

/// The input of parcels::divide() for a map, and the elements that its footprints and lines come from.
struct MapLand {
  parcels::Land land;
  std::vector<std::uint32_t> footprints;  ///< By land.footprints: indices into Features::footprints.
  std::vector<std::uint32_t> roads;       ///< By land.lines: indices of roads; parcels::kNoIndex for others.
};

/// Returns the land of a map.
///
/// - streets: roads on the ground without motorways and runways, as wide as carriageway and raised lanes, less
///   kUnderPavement_m on each side; a path that runs along a street is one too, since it is the street's pavement
/// - axes: as mapped, without the points of curves between nodes
/// - barriers: motorways, runways, railways without tramways, rivers
/// - taken: all mapped land but residential, commercial, retail and industrial land and pools
/// - footprints: outlines of buildings with walls that stand on the ground
///
/// @param private_ways  Ways that do not bound lots: driveways, aisles of car parks, ways through buildings. Sorted.
/// Whether a path runs along a street depends on streets within 32 m of it. O(n log n).
MapLand land_of(const map::FeatureView& features, std::span<const roads::Road> roads,
                std::span<const OsmId> private_ways);

/// True for land use on which yards are assumed: residential, commercial, retail, industrial.
bool is_land_of_yards(map::LandCoverClass surface);

}  // namespace citykiln::lots
