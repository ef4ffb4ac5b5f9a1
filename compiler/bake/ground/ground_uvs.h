// Texture coordinates of the ground, in metres. Whole periods of all textures are subtracted, so that numbers stay
// small and textures continue from tile to tile.
#pragma once

#include <array>
#include <cstdint>

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/mesh.h"
#include "compiler/ground/recipe.h"
#include "compiler/materials/material_mesh.h"

namespace citykiln::bake {

/// Returns the direction of u on a surface. It is east or, for materials with rows (such as fields), a random direction
/// that depends on the surface's id; rows run along v.
Vec2 texture_direction(ObjectId surface, materials::Material material, std::uint64_t seed);
/// Returns the direction of u on a surface: that of a field is square to its rows.
Vec2 texture_direction(const ground::LandCoverPolygon& surface, materials::Material material, std::uint64_t seed);

/// Returns uv on land: metres along `direction` (u), and metres to its left (v). All functions of this file return
/// multiples of materials::kTextureCoordinateStep_m.
/// @param direction  Unit length.
Vec2 uv_on_land(Vec2 at, Vec2 direction);
/// Returns uv on a steep face: metres east or north, whichever is nearer to the wall's direction, and metres up.
Vec2 uv_on_wall(Vec3 at, Vec3 normal);

/// Returns the nearest multiple of materials::kTextureCoordinateStep_m.
Vec2 on_grid(Vec2 uv);

/// The multiple of materials::kTexturePeriod_m to subtract from a triangle's uvs, so that they are less than a period
/// plus the triangle's size.
Vec2 periods_below(const std::array<Vec2, 3>& uvs);

/// The multiple of materials::kTexturePeriod_m to subtract from all uvs on land in the cell that contains `at`.
Vec2 periods_below_cell(Vec2 at, Vec2 direction);

/// Gives a mesh texture coordinates by the planes of its triangles: on steep ones metres along the level direction of
/// the plane, and metres up; on others as on land. Triangles no longer share corners, which merge() joins again where
/// they agree. Meshes with texture coordinates or an image of their own stay as they are. O(triangles).
void add_planar_uvs(materials::MaterialMesh& mesh);

}  // namespace citykiln::bake
