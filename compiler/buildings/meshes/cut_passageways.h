// Cuts openings for ways into a building's meshes and adds the walls and ceilings inside them. An opening is the space
// below the ceiling of a passageway (recipe.h).
//
//     _______________        1. triangles are cut along the sides and the ceiling of each opening; parts inside go
//    |    _______    |       2. inside the building, jambs (side walls) are added, and a ceiling on top
//    |   | ceiling|  |       3. pillars are added along the open side of an arcade
//    |jamb        |  |
#pragma once

#include "compiler/buildings/generate.h"
#include "compiler/buildings/recipe.h"

namespace citykiln::buildings {

/// Cuts, in plane metres, the openings of all passageways out of a building's meshes and textured faces, and appends
/// one mesh of jambs, ceilings and pillars. Meshes without triangles are removed. A building without passageways stays
/// unchanged.
///
/// Guarantees: no triangle has a point inside an opening, apart from rounding (2^-10 m) and pillars; jambs and ceilings
/// lie inside the footprint. All levels of detail are cut alike, so the error of a level does not change. Cost:
/// O(triangles · rings of the openings).
/// @param wall  An empty mesh with the material of jambs, ceilings and pillars.
void cut_passageways(const Building& building, materials::MaterialMesh wall, GeneratedBuilding& generated);

/// The side of a square pillar, and the least distance between two pillars along a segment of the axis.
inline constexpr double kPillar_m = 0.375, kLeastPillarSpacing_m = 4;

}  // namespace citykiln::buildings
