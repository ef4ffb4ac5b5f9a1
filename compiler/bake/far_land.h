// What distant land looks like, by what covers the edge of a scene and by height and slope.
#pragma once

#include <array>
#include <vector>

#include "compiler/materials/material.h"
#include "compiler/scene/ground_lookup.h"

namespace citykiln::bake {

using Colour = std::array<double, 3>;

/// The land cover in one direction.
struct EdgeCover {
  double wood_share = 0;   ///< Of its land that is not built on.
  Colour open{};           ///< Mean of the rest of that land.
  double built_share = 0;  ///< Of its land: towns, industry, roads, buildings.
  Colour built{};          ///< Mean of these.
};

/// The land cover at the edge of a scene.
struct FarLand {
  const scene::Header& header;
  Vec2 centre;                  ///< Of the edge.
  std::vector<EdgeCover> ring;  ///< By the share of the way around, counter-clockwise from east; not empty.
  EdgeCover mean{};
};

/// Looks along the border of the scene's tiles. Known land alone counts; without any, all is unknown ground.
/// @param header  Must outlive the result.
FarLand far_land_of(const scene::GroundLookup& lookup, const scene::Header& header);

/// The material and tint of land beyond the edge. Tints multiply Material::kScree, which is lighter than what grows;
/// lighter ground is as light as scree.
/// @param place  Plane metres; z is the height above sea level. @param normal  Unit.
materials::SurfaceMaterial look_of(const FarLand& land, Vec3 place, Vec3 normal);

/// At this distance from the edge half of its colours is left; the rest are their means.
inline constexpr double kEdgeFade_m = 2000;

}  // namespace citykiln::bake
