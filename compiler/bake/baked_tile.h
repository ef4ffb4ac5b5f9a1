// A baked tile: meshes and instances of one tile at one tolerance, in single precision about the tile's origin.
// Exporters write it, the preview renders it.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <vector>

#include "compiler/bake/feature_attributes.h"
#include "compiler/bake/layer.h"
#include "compiler/contract/stable_id.h"
#include "compiler/impostor/atlas.h"
#include "compiler/impostor/cutout.h"
#include "compiler/materials/material.h"
#include "compiler/materials/material_mesh.h"
#include "compiler/materials/texture.h"
#include "compiler/materials/texture_image.h"
#include "compiler/scene/scene.h"

namespace citykiln::bake {

using Float2 = std::array<float, 2>;
using Float3 = std::array<float, 3>;
using Float4 = std::array<float, 4>;

/// Single precision holds multiples of kQuantum_m exactly up to this distance from the origin.
inline constexpr double kExactReach_m = 16384;

inline Vec2 widened(const Float2& v) { return {v[0], v[1]}; }
inline Vec3 widened(const Float3& v) { return {v[0], v[1], v[2]}; }
inline Float3 narrowed(Vec3 v) { return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)}; }

/// All triangles with one key (PrimitiveKey). Frame: x east, y north, z up, metres from the tile's origin; in instanced
/// meshes from the mesh's own origin. Triangles share vertices and are counter-clockwise from outside.
struct Primitive {
  materials::Material material{};
  std::vector<Float3> positions;
  std::vector<Float3> normals;           ///< One per position, unit length.
  std::vector<materials::Tint> colours;  ///< One per position.
  std::vector<std::uint32_t> features;   ///< One per position: index into BakedTile::features.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  /// One per position, or empty: metres on the marking atlas, the facade atlas, the cutout or the material's texture.
  /// Multiples of materials::kTextureCoordinateStep_m on textures, else of materials::uv_step_m(image), rounded to
  /// float32.
  std::vector<Float2> uvs{};
  /// Values other than kByMaterial require uvs, and the image in the tile or instanced mesh.
  materials::ColourSource colour_source = materials::ColourSource::kByMaterial;
  Layer layer{};  ///< Equal for all primitives of an instanced mesh.
  bool operator==(const Primitive&) const = default;
};

/// True if a primitive is part of the ground. Primitives of the ground meet at the borders of tiles.
inline bool is_terrain(const Primitive& p) {
  return p.layer == Layer::kGround || p.layer == Layer::kRoads || p.layer == Layer::kWater;
}

/// The key of a primitive. Primitives of a tile or mesh are sorted by key, and no two have the same.
struct PrimitiveKey {
  Layer layer{};
  materials::Material material{};
  bool has_uvs = false;
  materials::ColourSource colour_source = materials::ColourSource::kByMaterial;
  auto operator<=>(const PrimitiveKey&) const = default;
};

inline PrimitiveKey key_of(const Primitive& p) { return {p.layer, p.material, !p.uvs.empty(), p.colour_source}; }

/// A mesh and the places of its copies.
struct InstancedMesh {
  std::string name;                   ///< Such as "oak_3".
  std::vector<Primitive> primitives;  ///< Not empty; without `features`, which each instance has.
  std::vector<Float3> translations{};
  std::vector<Float4> rotations{};  ///< Unit quaternions x, y, z, w.
  std::vector<float> scales{};
  std::vector<std::uint32_t> features{};
  impostor::SharedCutout cutout{};  ///< Image of the primitives with ColourSource::kByCutout, if there are any.
  bool operator==(const InstancedMesh&) const = default;
};

inline Layer layer_of(const InstancedMesh& instanced) { return instanced.primitives.front().layer; }

/// The viewpoint for which a tile was baked (view_levels.h).
struct Viewpoint {
  Vec3 eye;                ///< Plane metres.
  double focal_px = 0;     ///< Focal length.
  double pixel_error = 0;  ///< Certified bound of errors in the picture, except for objects at the finest tolerance.
  bool operator==(const Viewpoint&) const = default;
};

/// One tile at one tolerance.
struct BakedTile {
  scene::TileKey tile;
  Vec3 origin;                          ///< Plane metres; whole numbers, z included.
  double tolerance_m = 0;               ///< The requested tolerance.
  double error_m = 0;                   ///< Certified two-sided Hausdorff distance to the full shape, without plants.
  std::vector<OsmId> features{};        ///< Sorted; index 0 is always the none feature.
  std::vector<Primitive> primitives{};  ///< Sorted by key, at most one each.
  std::vector<InstancedMesh> instanced{};   ///< Sorted by layer.
  materials::TextureImage marking_atlas{};  ///< Markings of roads; no texels if there are none.
  impostor::Atlas facade_atlas{};           ///< Facade textures; no texels if there are none.
  /// Textures of the materials of all primitives, instanced ones included, that have uvs and ColourSource::kByMaterial.
  /// Sorted by material.
  std::vector<materials::Texture> textures{};
  std::optional<Viewpoint> viewpoint{};         ///< If there is one, tolerance_m is the finest of several.
  std::vector<FeatureAttributes> attributes{};  ///< One per feature, or empty.
  double plant_error_m = 0;  ///< Error of plants: stated, not certified (plants/prototypes/prototype_mesh.h).
  bool operator==(const BakedTile&) const = default;
};

}  // namespace citykiln::bake
