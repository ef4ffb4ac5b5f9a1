// Where the ground lies on its textures: metres, less whole periods of all textures, so that numbers stay small and
// tiles that meet show one picture.
#pragma once

#include <array>
#include <cstdint>

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/mesh.h"
#include "compiler/materials/material.h"

namespace citykiln::bake {

/// The direction in which u grows over a surface: east; on what has rows, drawn by its id, and rows run across it.
Vec2 texture_direction(ObjectId surface, materials::Material material, std::uint64_t seed);

/// On land: metres along the direction, and to its left. A multiple of materials::kTextureCoordinateStep_m.
Vec2 uv_on_land(Vec2 at, Vec2 direction);
/// On a steep face: along the wall, east or north whichever is nearer, and up.
Vec2 uv_on_wall(Vec3 at, Vec3 normal);

/// A place moved to the nearest multiple of materials::kTextureCoordinateStep_m.
Vec2 on_grid(Vec2 place);

/// The whole periods (materials::kTexturePeriod_m) below a triangle: taken off, its places stay under a period and its
/// size.
Vec2 periods_below(const std::array<Vec2, 3>& places);

/// The same for all of the cell that `at`, a place inside it, lies in.
Vec2 periods_below_cell(Vec2 at, Vec2 direction);

}  // namespace citykiln::bake
