// Plants: single trees and rows as mapped; woods and what is grown in rows as a surface and a stock, never as plants.
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
  double height_m = 0;  ///< As told, or drawn from the seed when 0.
  SpeciesMix species_mix{};
  bool operator==(const Tree&) const = default;
};

/// What may be asked of a wood.
inline constexpr double kLeastTreesPerHa = 1, kMostTreesPerHa = 300;

/// A wood: trees at even distances on the surface of the same id, wherever nothing else covers it.
struct Wood {
  ObjectId surface;  ///< A ground::LandCoverPolygon of the same chunk.
  SpeciesMix species_mix{};
  std::uint16_t trees_per_ha = 0;  ///< Trees a hectare of ground, not of map; kLeastTreesPerHa to kMostTreesPerHa.
  double height_m = 0;             ///< Of its trees where they grow best, mean; in eighths.
  bool operator==(const Wood&) const = default;
};

/// Nothing stands closer in rows.
inline constexpr double kLeastPlantSpacing_m = 0.25;

/// What is grown in straight rows on a surface: fruit trees, vines, hedges, corn.
struct Planting {
  ObjectId surface;
  SpeciesMix species_mix{};
  std::uint8_t heading = 0;                       ///< Of the rows: 256ths of half a turn, counter-clockwise of east.
  double row_spacing_m = 0, plant_spacing_m = 0;  ///< From row to row, and from plant to plant along one; in eighths.
  double height_m = 0;                            ///< Mean; in eighths.
  bool operator==(const Planting&) const = default;
};

/// Trees at equal distances along a line: natural=tree_row, tree_lined streets.
struct TreeRow {
  ObjectId id;
  Polyline axis;  ///< Plane metres, snapped, at least two points.
  SpeciesMix species_mix{};
  double height_m = 0;   ///< Mean; drawn from the seed when 0; in eighths.
  double spacing_m = 0;  ///< At most, in eighths; by the crowns when 0.
  bool operator==(const TreeRow&) const = default;
};

/// A lane below a power line, in which no wood stands.
struct PowerLineCorridor {
  ObjectId id;
  Polyline axis;
  double width_m = 0;  ///< In eighths.
  bool operator==(const PowerLineCorridor&) const = default;
};

/// Trees, rows and lanes matter to woods this far off: they are known so far about a tile.
inline constexpr double kObstacleInfluence_m = 16;

}  // namespace citykiln::plants
