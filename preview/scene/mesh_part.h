// The triangles of one material in Embree, and the surfaces that hits on them give.
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

/// A primitive in Embree: its triangles, with corners in the frame of the world. Refers to the primitive, whose
/// positions may be freed, and to the images, which must outlive the part. At most one image is not null; it replaces
/// the colour of the material.
struct MeshPart {
  const bake::Primitive* primitive = nullptr;
  std::vector<bake::Float3> corners{};        ///< One per position, and one more, since Embree reads 16 bytes at each.
  const MipTexture* marking_atlas = nullptr;  ///< Colour.
  const MaterialTexture* material_texture = nullptr;  ///< Colour and normal.
  const FacadeAtlasTexture* facade_atlas = nullptr;   ///< Colour, normal, roughness and emission.
  const CutoutTexture* cutout = nullptr;              ///< Colour, normal and holes.
  /// For each triangle the texels of the facade atlas that it shows; empty without atlas.
  std::vector<TexelRectangle> pictures{};
  /// For each triangle its index among the emitters; empty if the material does not shine.
  std::vector<std::uint32_t> emitters{};
  /// The tile's features, which the primitive's vertices index. Null: the hits of this part have no feature.
  const std::vector<OsmId>* features = nullptr;
};

/// The cone of directions that a ray stands for, at its hit.
struct RayFootprint {
  Vec3 direction;  ///< Unit.
  double across_m = 0;
  bool is_scattered = false;  ///< True after diffuse scattering: images are read coarsely, without normal maps.
};

/// Returns the part of a primitive, with its positions plus `offset` (rounded once) as corners, and the image that it
/// shows.
/// @param offset  The origin of the primitive's positions, in the frame of the world.
MeshPart mesh_part_of(const bake::Primitive& primitive, Vec3 offset, const MipTexture* marking_atlas,
                      const MaterialTexture* material_texture = nullptr,
                      const FacadeAtlasTexture* facade_atlas = nullptr, const CutoutTexture* cutout = nullptr);

/// Adds a part to a scene that is not committed yet; its geometry id is the number of parts before it. The scene refers
/// to the part, which must not move. Rays pass through the holes of its cutout.
void attach(RTCDevice device, RTCScene scene, const MeshPart& part);

/// Appends the triangles of the part that shine to `all`, and sets MeshPart::emitters to their indices there. With a
/// facade atlas, the light of a triangle is the mean over the triangle.
void add_emitters(MeshPart& part, std::vector<Emitter>& all);

/// Sets origin and direction of a ray, rounded to single precision.
void set_ray(RTCRay& ray, Vec3 from, Vec3 direction);

/// Returns the hit in the part's own frame. Its normals are not turned towards the ray yet, and its distance is not
/// set. `rounding_m` is an upper bound of the distance between Embree's plane of the triangle and the exact one.
Hit hit_on(const MeshPart& part, const RTCHit& found, const RayFootprint& footprint);

}  // namespace citykiln::preview
