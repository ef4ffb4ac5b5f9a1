// Cuts the openings for ways into the meshes of a building, at any level of detail, and closes them.
//
//     _______________        1. triangles are cut along the sides and the ceiling of each opening, and what is inside
//    |    _______    |          is left out
//    |   | ceiling|  |       2. jambs close its sides inside the building, a ceiling closes its top
//    |jamb        |  |
#pragma once

#include "compiler/buildings/generate.h"
#include "compiler/buildings/recipe.h"

namespace citykiln::buildings {

/// Cuts all passageways of a building into its meshes and textured faces; a building without any stays unchanged.
///
/// Guarantees: no triangle has a point inside an opening, apart from rounding (2^-10 m) and pillars of arcades; jambs
/// and ceilings lie inside the footprint. Every level of detail is cut alike, so no level's error changes. Cost:
/// O(triangles · rings).
/// @param wall  An empty mesh with the material of jambs and ceilings.
void cut_passageways(const Building& building, materials::MaterialMesh wall, GeneratedBuilding& generated);

/// The side of a pillar, and the distance between pillars of an arcade.
inline constexpr double kPillar_m = 0.375, kPillarSpacing_m = 4;

}  // namespace citykiln::buildings
