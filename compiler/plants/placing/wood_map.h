// The woods of a tile: which stands where, how densely, and how high its trees are.
#pragma once

#include "compiler/plants/placing/blue_noise.h"
#include "compiler/plants/placing/standing.h"

namespace citykiln::plants {

/// Woods by the surfaces that they stand on.
struct WoodMap {
  std::span<const Wood> woods;
  const Land& land;
  std::vector<std::uint32_t> of_surface;  ///< ground::kNoSurface: none.
  std::vector<Seat> seats;                ///< One a wood.
};

WoodMap map_woods(std::span<const Wood> woods, const Land& land);

/// The wood on top at a place, or kNoSurface.
std::uint32_t wood_at(const WoodMap& map, Vec2 p);

/// What may stand at a place: nothing outside woods, in reach of what they keep clear of, and beyond the surfaces' box;
/// towards the tree line few.
Seat seat_at(const WoodMap& map, Vec2 p);

/// Of a tree by its dice.
double height_in_wood_m(const Wood& wood, Species species, const Habitat& habitat, const Draw& draw);

/// What woods leave free below power lines, by place.
struct Lanes {
  struct Segment {
    Vec2 a, b;
    double half_m;
  };
  std::vector<Segment> segments;
  BoxGrid grid;
};
Lanes sort_lanes(std::span<const Lane> lanes, const Box2& box);
bool is_in_lane(const Lanes& lanes, Vec2 p);

}  // namespace citykiln::plants
