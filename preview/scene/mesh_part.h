// A primitive of a baked tile (triangles of one material) in Embree, and the surface points that hits on it give.
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

/// A primitive in Embree, with corners in the frame of the world (World::origin()). Refers to the primitive, the images
/// and the features, which must outlive it; only the primitive's positions may be freed. At most one of the four images
/// is not null; it replaces the colour of the material.
struct MeshPart {
  const bake::Primitive* primitive = nullptr;
  std::vector<bake::Float3> corners{};        ///< One per position, and one unused, as Embree reads 16 bytes at each.
  const MipTexture* marking_atlas = nullptr;  ///< Colour.
  const MaterialTexture* material_texture =
      nullptr;  ///< Colour, normal, roughness and holes; below markings their grain.
  const FacadeAtlasTexture* facade_atlas = nullptr;  ///< Colour, normal, roughness and emission.
  const CutoutTexture* cutout = nullptr;             ///< Colour, normal and holes.
  /// For each triangle the rectangle of texels of the facade atlas that it shows; empty without this atlas.
  std::vector<TexelRectangle> pictures{};
  /// For each triangle its index among the emitters (add_emitters()), or kNoEmitter. Empty if none of it shines.
  std::vector<std::uint32_t> emitters{};
  /// The tile's features, which the primitive's vertices index. Null: the hits of this part have no feature.
  const std::vector<OsmId>* features = nullptr;
  Vec3 offset{};  ///< The tile's origin in the frame of the world.
};

/// The cone of directions that a ray stands for, at its hit.
struct RayFootprint {
  Vec3 direction;             ///< Unit.
  double across_m = 0;        ///< The cone's diameter there.
  bool is_scattered = false;  ///< True after diffuse scattering: images are read coarsely, without normal maps.
};

/// Returns the part of a primitive, with its positions plus `offset`, rounded once to single precision, as corners. It
/// keeps the image that Primitive::colour_source names, if the primitive has the texture coordinates for it.
/// MeshPart::features and emitters are left empty. O(vertices).
/// @param primitive  With one normal per position.
/// @param offset     The origin of the primitive's positions, in the frame of the world, metres.
/// @param marking_atlas, material_texture, facade_atlas, cutout  The images of its tile and material; null: none.
MeshPart mesh_part_of(const bake::Primitive& primitive, Vec3 offset, const MipTexture* marking_atlas,
                      const MaterialTexture* material_texture = nullptr,
                      const FacadeAtlasTexture* facade_atlas = nullptr, const CutoutTexture* cutout = nullptr);

/// Adds a part to a scene that is not committed yet. Embree numbers geometries from 0, so the geometry id of a hit is
/// the number of parts that were added before. The scene refers to the part, its corners and its primitive's triangles:
/// none of them may move, change or end before the scene does. Rays pass through the holes of its cutout or texture.
void attach(RTCDevice device, RTCScene scene, const MeshPart& part);

/// Appends the triangles of the part that emit light to `all`, in their order, and sets MeshPart::emitters to their
/// indices there. With a facade atlas, the light of a triangle is its mean over the triangle. Does nothing for a
/// material or an atlas that does not shine. O(triangles).
void add_emitters(MeshPart& part, std::vector<Emitter>& all);

/// Sets origin and direction of a ray, rounded to single precision.
void set_ray(RTCRay& ray, Vec3 from, Vec3 direction);

/// Returns the surface point that Embree found on a part, in the frame of the part's corners. Hit::rounding_m is an
/// upper bound of the distance between the triangle's plane in single precision and the exact one. The caller turns the
/// normals towards the ray, and sets Hit::is_front and Hit::distance_m.
Hit hit_on(const MeshPart& part, const RTCHit& found, const RayFootprint& footprint);

}  // namespace citykiln::preview
