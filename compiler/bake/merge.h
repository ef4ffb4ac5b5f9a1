// Dressed meshes become few primitives: one a key, in single precision about an origin.
#pragma once

#include <map>
#include <span>
#include <vector>

#include "compiler/bake/baked_tile.h"
#include "compiler/materials/material_mesh.h"
#include "compiler/materials/texture_cache.h"

namespace citykiln::bake {

/// The primitive of each key so far.
using PrimitiveMap = std::map<PrimitiveKey, Primitive>;

/// Adds a mesh. Flat meshes (without normals) get the normals of their triangles; no two vertices that it adds are
/// alike: of the same place in single precision, normal, colour and uv. Triangles that single precision makes
/// degenerate are left out. `feature` is the number written for every vertex. A mesh without triangles adds nothing.
void merge(PrimitiveMap& merged, const materials::MaterialMesh& dressed, Vec3 origin, std::uint32_t feature);

/// Sorted by key.
std::vector<Primitive> primitives_of(PrimitiveMap&& merged);

/// Meshes that stand in many places: about their own origin, without features, which the places have.
std::vector<Primitive> instanced_primitives(std::span<const materials::MaterialMesh> meshes);

/// The textures of what of a tile and of its shared meshes shows its material's, in the order of materials.
std::vector<materials::Texture> textures_shown(const BakedTile& tile, double tolerance_m,
                                               const materials::TextureCache& shelf);

Float3 offset_from(Vec3 origin, Vec3 p);

}  // namespace citykiln::bake
