// What placing single trees, rows, woods and plantings have in common.
#pragma once

#include "compiler/contract/draw.h"
#include "compiler/geometry/box_grid.h"
#include "compiler/plants/generate.h"

namespace citykiln::plants {

/// Indices of what is drawn for a plant.
enum DrawIndex : std::uint32_t {
  kHeightDraw,
  kSpeciesDraw,
  kYawDraw,
  kVariantDraw,
  kAlongDraw,
  kAcrossDraw,
  kKeptDraw
};

/// Puts a plant's foot on the graded terrain.
void place_plant(PlacedPlants& placed, const PlacingContext& land, Species species, Vec2 at, double height_m,
                 const Draw& draw, OsmId feature);
/// The same, facing along a direction.
void place_plant_along(PlacedPlants& placed, const PlacingContext& land, Species species, Vec2 at, double height_m,
                       Vec2 along, const Draw& draw, OsmId feature);

bool is_in_half_open(const Box2& box, Vec2 p);

/// On a carriageway, a rail, a building or water.
bool is_blocked_ground(const ground::LandCoverIndex& map, Vec2 p);

Habitat habitat_of(const PlacingContext& land, Vec2 p);

/// A tree of a row or by itself, which woods keep clear of.
struct Obstacle {
  Vec2 at;
  double reach_m = 0;  ///< To where a wood's trunk may stand: its crown and room for another's.
};
double crown_clearance_m(Species species, double height_m);

/// Trees that are mapped each by itself. Ledger "bake/tree".
std::vector<Obstacle> place_trees(PlacedPlants& placed, std::span<const Tree> trees, const PlacingContext& land,
                                  Report& report);

/// Those of rows; not where a mapped tree stands already. Returns the trees, those mapped among them.
std::vector<Obstacle> place_rows(PlacedPlants& placed, std::span<const TreeRow> rows, std::vector<Obstacle> trees,
                                 const PlacingContext& land);

void place_woods(PlacedPlants& placed, std::span<const Wood> woods, std::span<const Obstacle> trees,
                 std::span<const PowerLineCorridor> corridors, const PlacingContext& land);

/// @param trees  Gaps in the rows.
void place_plantings(PlacedPlants& placed, std::span<const Planting> plantings, std::span<const Obstacle> trees,
                     const PlacingContext& land);

/// Things sorted by place: whether p is within reach of any.
struct ObstacleIndex {
  std::span<const Obstacle> all;
  BoxGrid grid;
};
ObstacleIndex index_obstacles(std::span<const Obstacle> all);
bool is_near_obstacle(const ObstacleIndex& obstacles, Vec2 p);

}  // namespace citykiln::plants
