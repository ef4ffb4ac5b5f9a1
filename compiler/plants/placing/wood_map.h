// The woods of a tile: which stands where, how densely, and how high its trees are.
#pragma once

#include "compiler/plants/placing/blue_noise.h"
#include "compiler/plants/placing/placing.h"

namespace citykiln::plants {

/// Woods by the surfaces that they stand on.
struct WoodMap {
  std::span<const Wood> woods;
  const PlacingContext& land;
  std::vector<std::uint32_t> of_surface;  ///< ground::kNoLandCover: none.
  std::vector<SampleDensity> densities;   ///< One a wood.
};

WoodMap map_woods(std::span<const Wood> woods, const PlacingContext& land);

/// The wood on top at a place, or kNoLandCover.
std::uint32_t wood_at(const WoodMap& map, Vec2 p);

/// What may stand at a place: nothing outside woods, in reach of what they keep clear of, and beyond the surfaces' box;
/// towards the tree line few.
SampleDensity density_at(const WoodMap& map, Vec2 p);

/// Of a tree by its dice.
double height_in_wood_m(const Wood& wood, Species species, const Habitat& habitat, const Draw& draw);

/// What woods leave free below power lines, by place.
struct CorridorIndex {
  struct Segment {
    Vec2 a, b;
    double half_m;
  };
  std::vector<Segment> segments;
  BoxGrid grid;
};
CorridorIndex index_corridors(std::span<const PowerLineCorridor> corridors, const Box2& box);
bool is_in_corridor(const CorridorIndex& corridors, Vec2 p);

}  // namespace citykiln::plants
