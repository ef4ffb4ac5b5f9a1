// One material's triangles as Embree sees them, and what a hit on one means.
#pragma once

#include <embree3/rtcore.h>

#include <vector>

#include "compiler/bake/baked_tile.h"
#include "preview/cutout_texture.h"
#include "preview/facade_atlas_texture.h"
#include "preview/material_texture.h"
#include "preview/mip_texture.h"
#include "preview/world.h"

namespace citykiln::preview {

/// Triangles, and their corners about another origin. Refers to the primitive and the texture.
struct MeshPart {
  const bake::Primitive* primitive = nullptr;
  std::vector<bake::Float3> corners;             ///< One a position, and one more: Embree reads 16 bytes at each.
  const MipTexture* texture = nullptr;           ///< What colours it instead of its material, if any.
  const MaterialTexture* surface = nullptr;      ///< Or its material's texture.
  const FacadeAtlasTexture* impostor = nullptr;  ///< Or the atlas, which says how rough it is, too.
  const CutoutTexture* cutout = nullptr;         ///< Or a cutout, which says where there is nothing, too.
};

/// What a ray covers where it hits.
struct RayFootprint {
  Vec3 direction;  ///< Unit.
  double across_m = 0;
};

/// The primitive's positions plus `offset`, rounded once. @param texture  Its tile's sheet, if there is one: taken
/// where the primitive is on it. @param surface  Its material's texture, if there is one: taken where it has uvs.
/// @param imprint  Its tile's atlas, if there is one: taken where the primitive is on it. @param cutout  Its shape's,
/// likewise.
MeshPart moved(const bake::Primitive& primitive, Vec3 offset, const MipTexture* texture,
               const MaterialTexture* surface = nullptr, const FacadeAtlasTexture* impostor = nullptr,
               const CutoutTexture* cutout = nullptr);

/// Adds a part to an uncommitted scene; its id is the number of parts before it. The part must outlive the scene, where
/// it is. Rays pass where its cutout has nothing.
void attach(RTCDevice device, RTCScene scene, const MeshPart& part);

/// A hit in the part's own frame; normals not turned towards the ray, distance not set. `rounding_m` covers what the
/// triangle adds: Embree's plane of it lies at most so far from the exact one.
Hit hit_on(const MeshPart& part, const RTCHit& found, const RayFootprint& beam);

}  // namespace citykiln::preview
