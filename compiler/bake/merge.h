// Merges meshes into primitives: one primitive for each combination of layer, material and image (PrimitiveKey), in
// single precision about an origin.
#pragma once

#include <map>
#include <span>
#include <vector>

#include "compiler/bake/baked_tile.h"
#include "compiler/materials/material_mesh.h"
#include "compiler/materials/texture_cache.h"

namespace citykiln::bake {

/// Primitives by key.
using PrimitiveMap = std::map<PrimitiveKey, Primitive>;

/// Adds a mesh to the primitive with its key. A mesh without normals gets the normals of its triangles. Vertices of the
/// mesh that agree in position (single precision), colour, uv and, to 2^-10 in each component, normal become one, with
/// the normal of the first. Triangles that are degenerate in single precision are left out, with the
/// vertices that they alone have.
/// @param origin   Origin of the tile, plane metres.
/// @param feature  Index of the map element, for all vertices.
void merge(PrimitiveMap& merged, const LayeredMesh& part, Vec3 origin, std::uint32_t feature);

/// The primitives that have triangles, sorted by key.
std::vector<Primitive> primitives_of(PrimitiveMap&& merged);

/// Returns the primitives of a mesh for instancing, about the mesh's own origin. They have no features, as each
/// instance has one.
std::vector<Primitive> instanced_primitives(std::span<const materials::MaterialMesh> meshes, Layer layer);

/// The textures of all materials of primitives and instanced meshes with uvs, sorted by material.
std::vector<materials::SharedTexture> textures_shown(const BakedTile& tile, double tolerance_m,
                                                     const materials::TextureCache& textures);

/// The unit normal of a triangle; zero if it is degenerate.
Vec3 normal_of(const Mesh& mesh, const Triangle& t);

/// The offset of a point from an origin, in single precision.
Float3 offset_from(Vec3 origin, Vec3 p);

}  // namespace citykiln::bake
