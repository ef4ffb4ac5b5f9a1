// The ground on which plants are placed, and the placing of one plant. A prototype is one of the few distinct plants of
// a species; plants are scaled copies of its mesh.
#pragma once

#include <map>
#include <span>
#include <vector>

#include "compiler/climate/climate_field.h"
#include "compiler/contract/findings/report.h"
#include "compiler/contract/random_sequence.h"
#include "compiler/geometry/placement.h"
#include "compiler/ground/cover/land_cover_index.h"
#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/plants/recipe.h"
#include "compiler/plants/species_table.h"

namespace citykiln::plants {

/// The placed plants by prototype. Placement::scale is the height in metres.
using PlacedPlants = std::map<Prototype, std::vector<Placement>>;

/// The least distance of trunks of woods and plantings to roads, paths, rails, water, buildings and other land cover of
/// priority kLeastObstaclePriority or more. Plantings up to 2 m tall keep 0.25 m.
inline constexpr double kTrunkClearance_m = 1.25;

/// The lowest priority (map/land_cover_classes.inc) of land cover without trunks: water, pitches, squares, paths,
/// rails, roads and buildings. The sea is below it and keeps no trunk away.
inline constexpr int kLeastObstaclePriority = 50;

/// The influence radius of land cover on the trees of woods: polygons must be known up to this distance beyond the box.
inline constexpr double kInfluenceRadius_m = 48;

/// The limit of all plant heights.
inline constexpr double kTallestPlant_m = 40;

/// The ground on which plants are placed.
struct PlacingContext {
  const ground::LandCoverIndex& surfaces;  ///< Covers the box widened by kInfluenceRadius_m.
  const ground::GradedTerrain& ground;     ///< Graded in the box; its terrain covers the surfaces' box.
  Box2 box;                                ///< Half-open: a plant on its upper sides belongs to the neighbour.
  std::uint64_t seed = 0;
  double latitude_deg = 0;
  const climate::ClimateField& climate;
  climate::LocalMonth month{6};  ///< Decides how much grass is straw.
  const SpeciesTable& species = shipped_table();
};

/// The indices of a plant's random draws.
enum DrawIndex : std::uint32_t {
  kHeightDraw,   ///< The height.
  kSpeciesDraw,  ///< The species among those of a mix.
  kYawDraw,      ///< The turn about the vertical.
  kVariantDraw,  ///< The variant: one of the differently grown plants of its species.
  kAlongDraw,    ///< The offset along a row or grid.
  kAcrossDraw,   ///< The offset across it.
  kKeptDraw,     ///< The decision to keep or omit the plant, or to replace a tree at a wood's edge by a bush.
  kDryDraw       ///< The decision between green grass and straw.
};

/// Adds a plant at a position in the plane, with its foot on the graded terrain.
void place_plant(PlacedPlants& placed, const PlacingContext& context, Species species, Vec2 at, double height_m,
                 const RandomSequence& draw, OsmId feature);
/// Adds a plant as place_plant() does, but turned to a direction.
/// @param along  A unit vector.
void place_plant_along(PlacedPlants& placed, const PlacingContext& context, Species species, Vec2 at, double height_m,
                       Vec2 along, const RandomSequence& draw, OsmId feature);

/// Returns places at equal distances of at most `spacing_m` along an axis, including its ends; the ends of a closed
/// axis of four points or more are one place. The axis is longer than 0.
std::vector<Vec2> spaced_along(const Polyline& axis, double spacing_m);

/// True if the topmost land cover at a position is a carriageway, rail, building or water, where no plant stands.
/// Pedestrian streets may have plants.
bool is_blocked_ground(const ground::LandCoverIndex& land_cover, Vec2 p);

/// Returns the growing conditions at a position.
Habitat habitat_of(const PlacingContext& context, Vec2 p);

}  // namespace citykiln::plants
