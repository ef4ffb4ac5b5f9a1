// A baked tile: the meshes and instances of one tile at one tolerance, in single precision about the tile's origin.
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

/// The distance from the origin up to which single precision holds multiples of kQuantum_m (2^-10 m) exactly.
inline constexpr double kExactReach_m = 16384;

/// Converts between single and double precision.
inline Vec2 widened(const Float2& v) { return {v[0], v[1]}; }
inline Vec3 widened(const Float3& v) { return {v[0], v[1], v[2]}; }
inline Float3 narrowed(Vec3 v) { return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)}; }

/// All triangles of a tile or mesh with one key (PrimitiveKey). Coordinates are metres from the tile's origin, x east,
/// y north, z up; in an instanced mesh, metres from the mesh's own origin. Triangles share vertices and run
/// counter-clockwise as seen from outside.
struct Primitive {
  materials::Material material{};
  std::vector<Float3> positions;
  std::vector<Float3> normals;           ///< One per position, unit length.
  std::vector<materials::Tint> colours;  ///< One per position.
  /// Per position the map element it belongs to: an index into BakedTile::features.
  std::vector<std::uint32_t> features;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  /// Texture coordinates, one per position, or empty: metres on the image that colour_source names (marking atlas,
  /// facade atlas, cutout) or on the material's texture. On textures multiples of materials::kTextureCoordinateStep_m,
  /// on images multiples of materials::uv_step_m(image), rounded to float32.
  std::vector<Float2> uvs{};
  /// Values other than kByMaterial require uvs, and that image in the tile or instanced mesh.
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

/// A mesh and the places of its copies. Translations, rotations, scales and features have one entry per copy.
struct InstancedMesh {
  std::string name;                   ///< Such as "oak_3".
  std::vector<Primitive> primitives;  ///< Not empty; without `features`, which each instance has.
  std::vector<Float3> translations{};
  std::vector<Float4> rotations{};  ///< Unit quaternions x, y, z, w.
  std::vector<float> scales{};      ///< Factors on the mesh's size.
  std::vector<std::uint32_t> features{};
  /// The image with transparency that primitives with ColourSource::kByCutout show, if there are any.
  impostor::SharedCutout cutout{};
  bool operator==(const InstancedMesh&) const = default;
};

inline Layer layer_of(const InstancedMesh& instanced) { return instanced.primitives.front().layer; }

/// The viewpoint for which a tile was baked (view_levels.h).
struct Viewpoint {
  Vec3 eye;             ///< Plane metres.
  double focal_px = 0;  ///< Focal length.
  /// Certified bound of errors in the picture, in pixels; objects baked at the finest tolerance may exceed it.
  double pixel_error = 0;
  bool operator==(const Viewpoint&) const = default;
};

/// The cylinder into which a tile was bent (bake/far/bend.h).
struct CylinderFrame {
  double radius_m = 0;
  double middle_y_m = 0;  ///< The middle of the tile along y, plane metres: tells turns of the cylinder apart.
  bool operator==(const CylinderFrame&) const = default;
};

/// One tile at one tolerance.
struct BakedTile {
  scene::TileKey tile;
  Vec3 origin;                    ///< Plane metres; whole numbers, z included.
  double tolerance_m = 0;         ///< The requested tolerance.
  double error_m = 0;             ///< Certified two-sided Hausdorff distance to the full shape, without plants.
  std::vector<OsmId> features{};  ///< The map elements in the tile, sorted. Index 0 is always the id for "no element".
  std::vector<Primitive> primitives{};      ///< Sorted by key, at most one each.
  std::vector<InstancedMesh> instanced{};   ///< Sorted by layer.
  materials::TextureImage marking_atlas{};  ///< Markings of roads; no texels if there are none.
  impostor::Atlas facade_atlas{};           ///< Facade textures; no texels if there are none.
  /// Textures of the materials of all primitives, instanced ones included, that have uvs and ColourSource::kByMaterial.
  /// Sorted by material, not null.
  std::vector<materials::SharedTexture> textures{};
  /// For tiles baked for a viewpoint; tolerance_m is then the finest of several.
  std::optional<Viewpoint> viewpoint{};
  std::vector<FeatureAttributes> attributes{};  ///< One per feature, or empty.
  /// An upper bound of the share of error_m that is not terrain (is_terrain()). Packing moves only that.
  double object_error_m = 0;
  double plant_error_m = 0;  ///< Error of plants: stated, not certified (plants/prototypes/prototype_mesh.h).
  /// Set for tiles inside of a cylinder: coordinates are those of map/plane/cylinder.h instead of the plane.
  std::optional<CylinderFrame> cylinder{};
  bool operator==(const BakedTile&) const = default;
};

}  // namespace citykiln::bake
