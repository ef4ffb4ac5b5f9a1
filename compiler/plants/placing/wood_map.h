// The woods of a tile by place: species mix, density and tree heights; and corridors without trees.
#pragma once

#include "compiler/plants/placing/blue_noise.h"
#include "compiler/plants/placing/placing.h"

namespace citykiln::plants {

struct WoodMap {
  std::span<const Wood> woods;
  const PlacingContext& context;
  std::vector<std::uint32_t> of_surface;  ///< Index of the wood of each polygon of context.surfaces, or kNoLandCover.
  std::vector<SampleDensity> densities;   ///< One a wood.
};

/// @param woods  Sorted by surface.
WoodMap map_woods(std::span<const Wood> woods, const PlacingContext& context);

/// The wood whose polygon is topmost at a place, or kNoLandCover.
std::uint32_t wood_at(const WoodMap& map, Vec2 p);

/// The density of trees at a place: none outside woods, within kTrunkClearance_m of obstacles, and outside the
/// polygons' box; fewer towards the tree line.
SampleDensity density_at(const WoodMap& map, Vec2 p);

/// Height of a tree in a wood, by species, habitat and its draws.
double height_in_wood_m(const Wood& wood, Species species, const Habitat& habitat, const Draw& draw);

/// Segments of power-line corridors in a grid of boxes.
struct CorridorIndex {
  struct Segment {
    Vec2 a, b;
    double half_m;
  };
  std::vector<Segment> segments;
  BoxGrid grid;
};
/// Indexes the corridors that touch the box.
CorridorIndex index_corridors(std::span<const PowerLineCorridor> corridors, const Box2& box);
bool is_in_corridor(const CorridorIndex& corridors, Vec2 p);

}  // namespace citykiln::plants
