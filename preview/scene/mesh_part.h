// The triangles of one material in Embree, and what a hit on one of them means.
#pragma once

#include <embree3/rtcore.h>

#include <vector>

#include "compiler/bake/baked_tile.h"
#include "preview/scene/cutout_texture.h"
#include "preview/scene/facade_atlas_texture.h"
#include "preview/scene/material_texture.h"
#include "preview/scene/mip_texture.h"
#include "preview/scene/world.h"

namespace citykiln::preview {

/// Triangles with their corners about the world's origin. Refers to the primitive, whose positions may be freed, and to
/// the images. At most one image is
/// not null: the one that colours the primitive instead of its material.
struct MeshPart {
  const bake::Primitive* primitive = nullptr;
  std::vector<bake::Float3> corners{};        ///< One per position, and one more: Embree reads 16 bytes at each.
  const MipTexture* marking_atlas = nullptr;  ///< Colour.
  const MaterialTexture* material_texture = nullptr;  ///< Colour and normal.
  const FacadeAtlasTexture* facade_atlas = nullptr;   ///< Colour, normal, roughness and emission.
  const CutoutTexture* cutout = nullptr;              ///< Colour, normal and holes.
  std::vector<TexelRectangle> pictures{};             ///< Per triangle, on the facade atlas; empty without one.
  std::vector<std::uint32_t> emitters{};  ///< Per triangle its number; empty if the material does not shine.
  /// Of the tile: the primitive's vertices index them. Null: the hits of this part have no feature.
  const std::vector<OsmId>* features = nullptr;
};

/// The cone that a ray stands for, where it hits.
struct RayFootprint {
  Vec3 direction;  ///< Unit.
  double across_m = 0;
  bool is_scattered = false;  ///< Whether it was scattered diffusely: images need no care, and relief is left out.
};

/// Returns a part: the primitive's positions plus `offset`, rounded once, and, of these images, the one that the
/// primitive shows.
MeshPart mesh_part_of(const bake::Primitive& primitive, Vec3 offset, const MipTexture* marking_atlas,
                      const MaterialTexture* material_texture = nullptr,
                      const FacadeAtlasTexture* facade_atlas = nullptr, const CutoutTexture* cutout = nullptr);

/// Adds a part to an uncommitted scene; its geometry id is the number of parts before it. The scene refers to the part,
/// which must not move. Rays pass through the holes of its cutout.
void attach(RTCDevice device, RTCScene scene, const MeshPart& part);

/// Numbers the part's triangles that shine, from the size of `all` on, and adds them there. The light of a facade atlas
/// is the mean over each triangle.
void add_emitters(MeshPart& part, std::vector<Emitter>& all);

/// Sets origin and direction of a ray, rounded once.
void set_ray(RTCRay& ray, Vec3 from, Vec3 direction);

/// The hit in the part's own frame. Its normals are not turned towards the ray, and its distance is not set.
/// `rounding_m` is an upper bound of the distance between Embree's plane of the triangle and the exact one.
Hit hit_on(const MeshPart& part, const RTCHit& found, const RayFootprint& footprint);

}  // namespace citykiln::preview
