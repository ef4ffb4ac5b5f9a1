// The fired form: meshes and instances of one tile at one tolerance, in single precision about the tile's origin, ready
// to be written or looked at.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <vector>

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

/// All triangles of one key. Frame: x east, y north, z up, metres from the tile's origin (prototypes: from their own).
/// Vertices are shared.
struct Primitive {
  materials::Material material{};
  std::vector<Float3> positions;
  std::vector<Float3> normals;           ///< One a position, unit length.
  std::vector<materials::Tint> colours;  ///< One a position.
  std::vector<std::uint32_t> features;   ///< One a position: index into BakedTile::features.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  /// One a position, or empty: metres on the sheet, the atlas or the material's texture (dressed_mesh.h). On sheets
  /// rounded once, to float32: by at most 0.5 mm up to 16 km; elsewhere multiples of
  /// materials::kTextureCoordinateStep_m.
  std::vector<Float2> uvs{};
  /// By BakedTile::sheet, BakedTile::imprints or InstancedMesh::cutout: then it has uvs, and they texels.
  materials::ColourSource colour_source = materials::ColourSource::kByMaterial;
  bool operator==(const Primitive&) const = default;
};

/// What tells the primitives of a mesh apart, in the order in which they are kept.
struct PrimitiveKey {
  materials::Material material{};
  bool has_uvs = false;
  materials::ColourSource colour_source = materials::ColourSource::kByMaterial;
  auto operator<=>(const PrimitiveKey&) const = default;
};

inline PrimitiveKey key_of(const Primitive& p) { return {p.material, !p.uvs.empty(), p.colour_source}; }

/// A mesh that stands in many places.
struct InstancedMesh {
  std::string name;                   ///< "oak_3".
  std::vector<Primitive> primitives;  ///< `features` empty: the instances have them.
  std::vector<Float3> translations;
  std::vector<Float4> rotations;  ///< Unit quaternions x, y, z, w.
  std::vector<float> scales;
  std::vector<std::uint32_t> features;
  impostor::Cutout cutout{};  ///< What its primitives on cutouts show; no texels: there are none.
  bool operator==(const InstancedMesh&) const = default;
};

/// For which eye a tile was made (view_levels.h).
struct Viewpoint {
  Vec3 eye;                ///< Plane metres.
  double focal_px = 0;     ///< Focal length.
  double pixel_error = 0;  ///< Certified: no error is longer on the picture, but for what is as fine as it gets.
  bool operator==(const Viewpoint&) const = default;
};

struct BakedTile {
  scene::TileKey tile;
  Vec3 origin;                        ///< Plane metres, whole numbers; z too.
  double tolerance_m = 0;             ///< Asked for.
  double error_m = 0;                 ///< Certified: Hausdorff, both ways, to the full-detail shape; but for plants.
  std::vector<OsmId> features;        ///< Sorted; index 0 is always the none feature.
  std::vector<Primitive> primitives;  ///< Sorted by key, at most one each.
  std::vector<InstancedMesh> instanced;
  materials::TextureImage sheet{};  ///< What primitives on the sheet are coloured by; no texels: there are none.
  impostor::Atlas facade_atlas{};   ///< Likewise: what facades of this level show as pictures.
  /// Of primitives, shared ones too, that have uvs and are coloured by their material, by material, rising, where the
  /// tolerance has any.
  std::vector<materials::Texture> textures{};
  std::optional<Viewpoint> viewpoint{};  ///< Then tolerance_m is the finest of many.
  double plant_error_m = 0;  ///< Stated, not certified, and in no other error: of plants (plants/prototype_mesh.h).
  bool operator==(const BakedTile&) const = default;
};

}  // namespace citykiln::bake
