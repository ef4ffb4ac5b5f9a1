// Paths of least cost over slopes and water.
#pragma once

#include "compiler/invent/town/town_plan.h"

namespace citykiln::invent {

/// The costs of a road at each place: a metre on flat dry land costs 1.
struct RoadCosts {
  TownRaster<double> height_m;
  TownRaster<char> is_wet;
  TownRaster<char> has_road;   ///< A metre along a road that is there costs kSharedRoad.
  TownRaster<char> is_closed;  ///< Land that costs 40 more a metre, so that roads avoid it.
  double usual_grade = 0.05;   ///< The grade at which slope adds 70 % to the cost.
  double wet_cost = 14;        ///< A metre of bridge costs this.
};

/// The share of the cost that remains where a road is there already, so that roads join.
inline constexpr double kSharedRoad = 0.35;

/// Samples heights and water on a lattice of 12 to 25 m.
RoadCosts road_costs(const TownPlan& plan);

/// Returns the lattice points of the cheapest path, both ends included; empty if there is none.
///
/// Method: A* over 32 directions of up to three cells, whose cost grows with the square of the grade (Galin, Peytavie,
/// Maréchal, Guérin, "Procedural Generation of Roads", Computer Graphics Forum 29, 2010, sections 3 and 4). There are
/// no tunnels; a bridge is a path over wet points.
/// Cost: O(points log points) at most, mostly those near the straight line.
std::vector<Vec2> least_cost_path(const RoadCosts& costs, Vec2 from, Vec2 to);

}  // namespace citykiln::invent
