// Recipes of plants: single trees and tree rows with their places; woods and plantings as a density on a land-cover
// polygon.
#pragma once

#include <cstdint>

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/polygon.h"
#include "compiler/plants/species_mix.h"

namespace citykiln::plants {

/// natural=tree, natural=shrub.
struct Tree {
  ObjectId id;
  Vec2 at;              ///< Plane metres, snapped.
  double height_m = 0;  ///< 0: drawn from the seed.
  SpeciesMix species_mix{};
  bool operator==(const Tree&) const = default;
};

/// Range of Wood::trees_per_ha.
inline constexpr double kLeastTreesPerHa = 1, kMostTreesPerHa = 300;

/// A wood: trees in blue noise on the polygon of the same id, where no other polygon covers it.
struct Wood {
  ObjectId surface;  ///< A ground::LandCoverPolygon of the same chunk.
  SpeciesMix species_mix{};
  std::uint16_t trees_per_ha = 0;  ///< Trees a hectare of ground, not of projected area.
  double height_m = 0;             ///< Mean height of tall species in the valley; in eighths.
  bool operator==(const Wood&) const = default;
};

/// Least Planting::row_spacing_m and plant_spacing_m.
inline constexpr double kLeastPlantSpacing_m = 0.25;

/// Plants in straight rows on a polygon: fruit trees, vines, hedges, corn.
struct Planting {
  ObjectId surface;
  SpeciesMix species_mix{};
  std::uint8_t heading = 0;                       ///< Of the rows: 256ths of half a turn, counter-clockwise of east.
  double row_spacing_m = 0, plant_spacing_m = 0;  ///< Between rows, and along a row; in eighths.
  double height_m = 0;                            ///< Mean; in eighths.
  bool operator==(const Planting&) const = default;
};

/// Trees at equal distances along a line: natural=tree_row, tree_lined streets.
struct TreeRow {
  ObjectId id;
  Polyline axis;  ///< Plane metres, snapped, at least two points.
  SpeciesMix species_mix{};
  double height_m = 0;   ///< Mean; 0: drawn from the seed; in eighths.
  double spacing_m = 0;  ///< Largest spacing, in eighths; 0: by the crowns' width.
  bool operator==(const TreeRow&) const = default;
};

/// A strip below a power line without trees of woods.
struct PowerLineCorridor {
  ObjectId id;
  Polyline axis;
  double width_m = 0;  ///< In eighths.
  bool operator==(const PowerLineCorridor&) const = default;
};

/// Influence radius of trees, rows and corridors on woods: a chunk holds those up to this distance from its tile.
inline constexpr double kObstacleInfluence_m = 16;

}  // namespace citykiln::plants
