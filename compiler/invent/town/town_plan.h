// The plan of a town before any street: its centres, how dense it is where, and the reserves that streets keep out of.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/geometry/polygon.h"
#include "compiler/invent/terrain.h"
#include "compiler/invent/town/add_town.h"
#include "compiler/invent/town/town_raster.h"

namespace citykiln::invent {

// The distance of places from water.

/// The largest distance that is told apart.
inline constexpr double kFarFromWater_m = 200;

/// Distances in metres, 0 in water, at most kFarFromWater_m.
struct WaterDistance {
  TownRaster<double> distance_m;

  double at(Vec2 p) const { return distance_m.at(p); }
  /// True if a place is so near to water that it may lie in it: the lattice is as fine as this.
  bool may_be_water(Vec2 p) const { return at(p) < 1.5 * distance_m.step_m; }
};

/// Returns the distances over a square about the middle. Steps are 4 m, 1/1250 of larger worlds. Errors are below a
/// step and 5 %. Method: seas and lakes are filled row by row, rivers capsule by capsule; two passes of a chamfer
/// transform (Borgefors, "Distance transformations in digital images", 1986).
WaterDistance water_distance(const Terrain& terrain, double side_m);

struct Centre {
  Vec2 position;
  double peak = 1;      ///< The density in it.
  double radius_m = 0;  ///< The distance at which the density that is due to it ends.
  Vec2 grid{1, 0};      ///< The direction of its streets, length 1.
};

/// Land without streets through it: a park.
struct Reserve {
  Vec2 middle;
  double radius_m = 0;
};

/// The axis of a railway, and its station.
struct Railway {
  Polyline axis;  ///< Empty: none.
  bool has_station = false;
  Vec2 station, along;  ///< Its middle on the axis, and the direction of the axis there, length 1.
  Vec2 town;            ///< Square to the axis, towards the town.
  Vec2 at(double along_m, double town_m) const { return station + along * along_m + town * town_m; }
};

struct TownPlan {
  TownSettings settings;
  const Terrain* terrain = nullptr;
  WaterDistance water;
  std::vector<Centre> centres;  ///< The first is the main centre.
  std::vector<Reserve> reserves;
  TownRaster<double> density;  ///< 0: country, 1: the middle of a city.

  double half_m() const { return settings.side_m / 2; }
  Railway railway;
  TownRaster<char> tracks;  ///< 1 near the railway and its station, where no street grows; empty without one.

  bool is_track_land(Vec2 p) const { return !tracks.values.empty() && tracks.nearest(p); }
  /// True on the land of the station.
  bool is_station_land(Vec2 p) const;
  /// True on the mapped square.
  bool is_inside(Vec2 p) const { return p.x >= -half_m() && p.x <= half_m() && p.y >= -half_m() && p.y <= half_m(); }
  bool is_reserved(Vec2 p) const;
  /// The distance of a place from the nearest centre.
  double centre_distance_m(Vec2 p) const;
};

/// Where the density is below this, no streets grow.
inline constexpr double kTownEdge = 0.04;

/// Puts the main centre near the middle on flat dry land, others apart from it by 1,100 m or more.
TownPlan plan_town(const Terrain& terrain, const TownSettings& settings);

}  // namespace citykiln::invent
