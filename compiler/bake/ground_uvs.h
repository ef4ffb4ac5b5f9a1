// Texture coordinates of the ground, in metres. Whole periods of all textures are subtracted, so that numbers stay
// small and textures continue from tile to tile.
#pragma once

#include <array>
#include <cstdint>

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/mesh.h"
#include "compiler/materials/material.h"

namespace citykiln::bake {

/// The direction of u on a surface: east, or, for materials with rows, drawn by the surface's id; rows run across it.
Vec2 texture_direction(ObjectId surface, materials::Material material, std::uint64_t seed);

/// uv on land: metres along the direction (unit length), and to its left. A multiple of
/// materials::kTextureCoordinateStep_m, here and below.
Vec2 uv_on_land(Vec2 at, Vec2 direction);
/// uv on a steep face: metres along the wall, east or north, whichever is nearer, and up.
Vec2 uv_on_wall(Vec3 at, Vec3 normal);

/// The nearest multiple of materials::kTextureCoordinateStep_m.
Vec2 on_grid(Vec2 uv);

/// The whole periods (materials::kTexturePeriod_m) below a triangle's uvs. Without them its uvs are less than a period
/// plus the triangle's size.
Vec2 periods_below(const std::array<Vec2, 3>& uvs);

/// The whole periods below all uvs on land of the cell that holds the place `at`.
Vec2 periods_below_cell(Vec2 at, Vec2 direction);

}  // namespace citykiln::bake
