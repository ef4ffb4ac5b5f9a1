// Dressed meshes become few primitives: one a key, in single precision about an origin.
#pragma once

#include <map>
#include <span>
#include <vector>

#include "compiler/bake/baked.h"
#include "compiler/materials/dressed_mesh.h"
#include "compiler/materials/texture_shelf.h"

namespace citykiln::bake {

/// The primitive of each key so far.
using Merged = std::map<PrimitiveKey, Primitive>;

/// Adds a mesh. Flat meshes (without normals) get the normals of their triangles; no two vertices that it adds are
/// alike: of the same place in single precision, normal, colour and uv. Triangles that single precision makes
/// degenerate are left out. `feature` is the number written for every vertex. A mesh without triangles adds nothing.
void merge(Merged& merged, const materials::DressedMesh& dressed, Vec3 origin, std::uint32_t feature);

/// Sorted by key.
std::vector<Primitive> primitives_of(Merged&& merged);

/// Meshes that stand in many places: about their own origin, without features, which the places have.
std::vector<Primitive> shared_primitives(std::span<const materials::DressedMesh> meshes);

/// The textures of what of a tile and of its shared meshes shows its material's, in the order of materials.
std::vector<materials::Texture> textures_shown(const BakedTile& tile, double tolerance_m,
                                               const materials::TextureShelf& shelf);

Float3 offset_from(Vec3 origin, Vec3 p);

}  // namespace citykiln::bake
