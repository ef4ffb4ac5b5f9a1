// Plots: assumed uses of urban ground where the map has only a land use and no lot. Plots are not recipes: they are
// computed from the recipes of a tile when it is baked.
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
  std::span<const ground::LandCoverPolygon> areas;  ///< Land cover of the tile's chunk, surfaces of yards included.
  std::span<const roads::Road> roads;
  std::span<const buildings::Building> buildings;  ///< Only those of this tile; neighbours have other ones.
  const ground::LandCoverIndex& land_cover;        ///< Each road is one surface. It covers at least the tile.
  Box2 tile;
  std::uint64_t seed = 0;
};

/// The plots of a tile.
struct Plots {
  /// Their grounds, for the things that stand there (furniture/yard_things.h). They have no strips, borders and plants.
  std::vector<lots::Yard> grounds;
  /// Their surfaces: classes of yards, below all that is mapped more finely than the land use, and below yards.
  std::vector<ground::LandCoverPolygon> surfaces;
  std::vector<plants::Tree> plants;  ///< Bushes (PlantKind::kBush) on grass and at the rims.
};

/// Returns the plots of a tile:
///
/// - along streets, of the kinds of plot_kinds.inc, by land use and the share of green within 24 m: yards of industry,
///   car parks, rough grass with bushes. One land use is on top at 60 % or more of 25 samples of a plot: no lot, road,
///   building or finer area covers it. Unmapped land counts only with a building within 30 m of the middle;
/// - beside schools of 200 m2 or more, in land of institutions: a playground of asphalt on the side with most free
///   ground; paving about all buildings of 80 m2 or more there, gravel about churches;
/// - in allotments: plots of 11 by 18 m in rows, with beds, and paths between the rows;
/// - mapped building sites of 150 m2 or more, with their whole area as ground.
///
/// Surfaces lie in the tile, so neighbouring tiles need not agree on them. O(roads + plots² + buildings · areas), each
/// with a query of land cover.
Plots plots_of(const PlotInputs& inputs);

}  // namespace citykiln::vacant
