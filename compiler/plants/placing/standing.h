// What placing single trees, rows, woods and plantings have in common.
#pragma once

#include "compiler/contract/draw.h"
#include "compiler/geometry/box_grid.h"
#include "compiler/plants/expand.h"

namespace citykiln::plants {

/// Indices of what is drawn for a plant.
enum Dice : std::uint32_t { kHeightDice, kSpeciesDice, kYawDice, kVariantDice, kAlongDice, kAcrossDice, kKeptDice };

/// Puts a plant's foot on the carved ground.
void stand(Placed& placed, const Land& land, Species species, Vec2 at, double height_m, const Draw& draw,
           OsmId feature);
/// The same, facing along a direction.
void stand_along(Placed& placed, const Land& land, Species species, Vec2 at, double height_m, Vec2 along,
                 const Draw& draw, OsmId feature);

bool stands_in(const Box2& box, Vec2 p);

/// On a carriageway, a rail, a building or water.
bool is_covered(const ground::SurfaceMap& map, Vec2 p);

Habitat habitat_of(const Land& land, Vec2 p);

/// A tree of a row or by itself, which woods keep clear of.
struct Obstacle {
  Vec2 at;
  double reach_m = 0;  ///< To where a wood's trunk may stand: its crown and room for another's.
};
double reach_of_crown_m(Species species, double height_m);

/// Trees that are mapped each by itself. Ledger "bake/tree".
std::vector<Obstacle> place_trees(Placed& placed, std::span<const Tree> trees, const Land& land, Report& report);

/// Those of rows; not where a mapped tree stands already. Returns the trees, those mapped among them.
std::vector<Obstacle> place_rows(Placed& placed, std::span<const Row> rows, std::vector<Obstacle> trees,
                                 const Land& land);

void place_woods(Placed& placed, std::span<const Wood> woods, std::span<const Obstacle> trees,
                 std::span<const Lane> lanes, const Land& land);

/// @param trees  Gaps in the rows.
void place_plantings(Placed& placed, std::span<const Planting> plantings, std::span<const Obstacle> trees,
                     const Land& land);

/// Things sorted by place: whether p is within reach of any.
struct Obstacles {
  std::span<const Obstacle> all;
  BoxGrid grid;
};
Obstacles sort_obstacles(std::span<const Obstacle> all);
bool is_taken(const Obstacles& obstacles, Vec2 p);

}  // namespace citykiln::plants
