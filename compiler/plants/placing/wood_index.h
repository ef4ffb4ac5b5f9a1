// Looks up the woods of a tile by position: species mix, density and tree heights. Also looks up power-line corridors,
// where no trees grow.
#pragma once

#include "compiler/plants/placing/blue_noise.h"
#include "compiler/plants/placing/placing.h"

namespace citykiln::plants {

/// Woods with the data for queries. Refers to woods and context, which must outlive it.
struct WoodIndex {
  std::span<const Wood> woods;
  const PlacingContext& context;
  std::vector<std::uint32_t> of_surface;  ///< By polygon of context.surfaces: the index of its wood, or kNoLandCover.
  std::vector<SampleDensity> densities;   ///< One per wood.
};

/// Prepares the index.
/// @param woods  Sorted by surface.
WoodIndex index_woods(std::span<const Wood> woods, const PlacingContext& context);

/// Returns the index of the wood whose polygon is topmost at a position, or kNoLandCover.
std::uint32_t wood_at(const WoodIndex& wood_index, Vec2 p);

/// Returns the density of trees at a position: none outside woods, within kTrunkClearance_m of obstacles, and outside
/// the polygons' box; less towards the tree line.
SampleDensity density_at(const WoodIndex& wood_index, Vec2 p);

/// Returns the height of a tree in a wood, by species, habitat and its random draws.
double height_in_wood_m(const Wood& wood, const SpeciesValues& species, const Habitat& habitat,
                        const RandomSequence& draw);

/// The segments of power-line corridors, with a spatial index.
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
/// True if a position lies in a power-line corridor.
bool is_in_corridor(const CorridorIndex& corridors, Vec2 p);

}  // namespace citykiln::plants
