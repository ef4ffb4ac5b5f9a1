// Plots: what lies on ground of towns that no lot has, and of which the map says no more than its land use. None of
// these is a recipe: all follows from the recipes of a tile.
//
//     ══════════════ street ═══════════
//     ┌────────┬────────┬───┐[building]     plots of 24 by 22 m along streets, where most of the
//     │ asphalt│ grass ᴖ│   │               ground is left over
//     │ ▭ ▭    │ᴖ     ᴖ │   │
//     └────────┴────────┘
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/buildings/recipe.h"
#include "compiler/geometry/box.h"
#include "compiler/ground/cover/land_cover_index.h"
#include "compiler/lots/recipe.h"
#include "compiler/plants/recipe.h"
#include "compiler/roads/recipe.h"

namespace citykiln::vacant {

/// The recipes of a tile that plots follow from.
struct PlotInputs {
  std::span<const ground::LandCoverPolygon> areas;  ///< Areas of the tile's chunk, those of yards among them.
  std::span<const roads::Road> roads;
  std::span<const buildings::Building> buildings;  ///< The tile alone has these.
  const ground::LandCoverIndex& land_cover;        ///< With each road as one surface; of the tile at least.
  Box2 tile;
  std::uint64_t seed = 0;
};

/// The plots of a tile.
struct Plots {
  /// Their grounds, for the things that stand there (furniture/yard_things.h). They have no strips, borders and plants.
  std::vector<lots::Yard> grounds;
  /// Their surfaces: classes of yards, below all that is mapped more finely than the land use, and below yards.
  std::vector<ground::LandCoverPolygon> surfaces;
  std::vector<plants::Tree> plants;  ///< Bushes and trees on grass and at the rims.
};

/// Returns the plots of a tile:
///
/// - along streets, of the kinds of plot_kinds.inc, by land use and the share of green within 24 m: yards of industry,
///   car parks, rough grass with bushes. At least 6 of 10 places of a plot are left over: no lot, road, building nor
///   finer area covers them. Where the map has no land use, a building stands within 30 m;
/// - before schools, in land of institutions: a playground of asphalt at the side with most room; paving about all
///   buildings there, gravel about churches;
/// - in allotments: plots of 11 by 18 m in rows, with beds, and paths between the rows;
/// - building sites, whole.
///
/// Surfaces lie wholly in the tile, so that no two tiles need to know the same of one. O(n log n).
Plots plots_of(const PlotInputs& inputs);

}  // namespace citykiln::vacant
