// Decides which trees line the streets of towns where no map shows trees.
//
//     houses     [#######]  [########]
//     pavement   ─────────────────────
//     verge        o    o    o    o      every 8 m, in the middle of the verge, else 0.8 m inside the pavement
//     ═════════ kerb ═══════════════
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "compiler/plants/recipe.h"
#include "compiler/roadside/clear_zones.h"

namespace citykiln::furniture {

/// Trees stand in verges at least this wide, or on pavements at least this wide, in metres.
inline constexpr double kTreeVerge_m = 1, kTreePavement_m = 2.5;
/// No trees are assumed this near to a mapped one, in metres.
inline constexpr double kMappedStreetTree_m = 60;
/// The distances of trunks from walls, and of their pits from lamps, in metres.
inline constexpr double kTreeFromWall_m = 3, kTreeFromLamp_m = 2;

/// The mapped trees of a tile.
struct MappedTrees {
  std::span<const plants::Tree> trees;  ///< Trees of yards do not count.
  std::span<const plants::TreeRow> rows;
};

/// Draws the species of a tree from its foot and a uniform random number in [0, 1) that a whole street shares, as most
/// streets have one species.
using DrawStreetSpecies = std::function<plants::SpeciesMix(Vec2 foot, double street)>;

/// Returns the trees that are assumed along the pavements of a tile: one 4 m beside each station (stations.h). All
/// trees of one side of an OSM way are drawn together, by the percentages of street_trees.inc for its country and
/// class. Main streets are primary, secondary and tertiary; other streets are residential; further classes have none. A
/// tree
///
/// - stands in a verge of kTreeVerge_m or, where there is none, on a pavement of kTreePavement_m;
/// - keeps kTreeFromWall_m from buildings; the height grows with that distance, from 6 to 12 m, of palms 12 to 16 m;
/// - is outside of the clear zones of streets, doors, things and lamps, on pavement or verge.
///
/// A tree is in the tile that contains its foot. Mapped trees of the next
/// tile do not count. O(stations · mapped trees).
/// @param zones  clear_zones_of() the recipes.
/// @param box    The tile.
std::vector<plants::Tree> street_trees(const roadside::TileRecipes& recipes, const roadside::ClearZones& zones,
                                       const MappedTrees& mapped, const DrawStreetSpecies& draw_species,
                                       std::uint64_t seed, const Box2& box);

}  // namespace citykiln::furniture
