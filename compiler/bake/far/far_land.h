// The material of distant land, from the land cover at the edge of a scene and from height and slope.
#pragma once

#include <array>
#include <vector>

#include "compiler/materials/material.h"
#include "compiler/scene/ground_lookup.h"
#include "compiler/surroundings/generate.h"

namespace citykiln::bake {

using Colour = std::array<double, 3>;

/// The land cover along one direction of a scene's edge. Colours are linear reflectances.
struct EdgeCover {
  double wood_share = 0;   ///< Share of wood in the land that is not built on.
  Colour open{};           ///< Mean colour of land that is neither wood nor built on.
  double built_share = 0;  ///< Share of towns, industry, roads and buildings in all land.
  Colour built{};          ///< Mean colour of these.
};

/// The land cover along the edge of a scene.
struct FarLand {
  const scene::Header& header;
  Vec2 centre;                  ///< Centre of the edge.
  std::vector<EdgeCover> ring;  ///< Directions at equal steps along the edge, counter-clockwise from east; not empty.
  EdgeCover mean{};             ///< The mean of all directions.
};

/// Samples the land cover along the border of the scene's tiles. Only land of known class counts; if there is none, the
/// result is unknown ground.
/// @param lookup  Gives the land cover at places of the scene.
/// @param header  Must outlive the result.
FarLand far_land_of(const scene::GroundLookup& lookup, const scene::Header& header);

/// The material and tint of land beyond the edge. The material is mostly kScree, which is lighter than vegetation, and
/// the tint gives it the land's colour. Ground lighter than scree is shown as light as scree.
/// @param place   Plane metres; z is the height above sea level.
/// @param normal  Unit length.
materials::SurfaceMaterial far_material_of(const FarLand& land, Vec3 place, Vec3 normal);

/// The material of a face of the land around: of its patch near the edge, farther out the one of far_material_of().
/// Steep or high land near the edge is as far land.
/// @param place   Plane metres; z is the height above sea level.
/// @param normal  Unit length.
/// @param away_m  The distance from the tiles.
materials::Material material_of(const FarLand& land, const surroundings::Patch& patch, Vec3 place, Vec3 normal,
                                double away_m);
/// The tint that gives a material the colour of the land around. Beside the edge that is the colour of the ground of
/// tiles; between kPatches_m and kPatchesEnd_m it fades into the colour of far_material_of().
materials::Tint tint_of(const FarLand& land, const surroundings::Patch& patch, materials::Material material, Vec3 place,
                        Vec3 normal, double away_m);
/// The colour of a class at the origin in the scene's month: linear reflectance.
Colour colour_of_cover(map::LandCoverClass cover, const scene::Header& header);

/// The distances from the edge up to which land has the full colour of its patch, and from which it has none of it.
inline constexpr double kPatches_m = 600, kPatchesEnd_m = 5000;
/// The distance up to which faces have the material of their patch.
inline constexpr double kOwnMaterial_m = 150;

/// The distance from the edge at which half the difference between the colour of a direction and the mean colour is
/// left.
inline constexpr double kEdgeFade_m = 2000;

}  // namespace citykiln::bake
