// Recipes of plants: single trees and tree rows with positions; woods and plantings as a density on a land cover
// polygon. A species mix is one species, or a plant community from which each plant's species is drawn (species_mix.h).
#pragma once

#include <cstdint>

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/polygon.h"
#include "compiler/plants/species_mix.h"

namespace citykiln::plants {

/// A mapped tree: natural=tree, natural=shrub.
struct Tree {
  ObjectId id;
  Vec2 at;              ///< Plane metres, snapped.
  double height_m = 0;  ///< 0: drawn by the seed.
  SpeciesMix species_mix{};
  bool operator==(const Tree&) const = default;
};

/// The range of Wood::trees_per_ha.
inline constexpr double kLeastTreesPerHa = 1, kMostTreesPerHa = 300;

/// A wood: trees in blue noise on a land-cover polygon, where no other polygon covers it.
struct Wood {
  ObjectId surface;  ///< The id of a ground::LandCoverPolygon of the chunk.
  SpeciesMix species_mix{};
  std::uint16_t trees_per_ha = 0;  ///< Trees per hectare of ground, not of projected area.
  double height_m = 0;             ///< The mean height of tall species in the valley, a multiple of 1/8 m.
  bool operator==(const Wood&) const = default;
};

/// The least Planting::row_spacing_m and plant_spacing_m.
inline constexpr double kLeastPlantSpacing_m = 0.25;

/// Plants in straight rows on a polygon: fruit trees, vines, hedges, corn.
struct Planting {
  ObjectId surface;
  SpeciesMix species_mix{};
  std::uint8_t heading = 0;  ///< The heading of the rows, in 256ths of half a turn counter-clockwise of east.
  double row_spacing_m = 0, plant_spacing_m = 0;  ///< The distances between rows and along a row, multiples of 1/8 m.
  double height_m = 0;                            ///< The mean height, a multiple of 1/8 m.
  bool operator==(const Planting&) const = default;
};

/// Trees at equal distances along a line: natural=tree_row, streets with tree_lined.
struct TreeRow {
  ObjectId id;
  Polyline axis;  ///< Plane metres, snapped, at least two points.
  SpeciesMix species_mix{};
  double height_m = 0;   ///< The mean height, a multiple of 1/8 m; 0: drawn by the seed.
  double spacing_m = 0;  ///< The largest spacing, a multiple of 1/8 m; 0: by the crowns' width.
  bool operator==(const TreeRow&) const = default;
};

/// A strip below a power line, which trees of woods keep clear of.
struct PowerLineCorridor {
  ObjectId id;
  Polyline axis;
  double width_m = 0;  ///< A multiple of 1/8 m.
  bool operator==(const PowerLineCorridor&) const = default;
};

/// The influence radius of trees, rows and corridors on woods: a chunk holds all that are up to this distance from its
/// tile.
inline constexpr double kObstacleInfluence_m = 16;

}  // namespace citykiln::plants
