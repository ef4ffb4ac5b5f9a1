// The state while a level of a tile is written into a layer.
#pragma once

#include <string>
#include <vector>

#include "exporters/usd/layer_writer.h"

namespace citykiln::exporters {

/// A file beside a layer.
struct UsdFile {
  std::string name;  ///< The file name, without a folder: "AsphaltColour_0123456789abcdef.jpg".
  std::vector<std::byte> bytes;
};

/// The properties that distinguish the materials of a level.
struct UsdMaterialKey {
  bake::PrimitiveKey primitive;  ///< has_uvs is false if the uvs show no image.
  const materials::Texture* texture = nullptr;
  const impostor::Cutout* cutout = nullptr;
  bool has_backs = false;                     ///< Both sides have their own faces (gltf/leaf_backs.h).
  materials::Tint tint = materials::kNoTint;  ///< The mean of the mesh's tints; kNoTint if it has no image.
  bool operator==(const UsdMaterialKey&) const = default;
};

/// A material of a level.
struct UsdMaterial {
  UsdMaterialKey key;
  std::string name;  ///< Unique in the level.
};

/// A box between the least and the greatest coordinates; empty while low.x is above high.x.
struct UsdBounds {
  Vec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
};
/// Extends the bounds by a point or by other bounds.
void include(UsdBounds& bounds, Vec3 point);
void include(UsdBounds& bounds, const UsdBounds& other);
inline bool is_empty(const UsdBounds& bounds) { return bounds.low.x > bounds.high.x; }
/// Returns low and high in single precision, as USD's `extent` has them.
std::array<bake::Float3, 2> extent_of(const UsdBounds& bounds);

/// The state: the tile, the writer, and what is collected from the tile.
struct UsdBuilder {
  const bake::BakedTile& tile;
  LayerWriter& writer;
  std::string texture_folder;  ///< The path from the layer, with a slash at the end: "../textures/".
  std::vector<UsdMaterial> materials{};
  std::vector<const impostor::Cutout*> cutouts{};  ///< Distinct cutouts.
  std::vector<UsdFile> textures{};                 ///< Each name once.
  UsdBounds bounds{};                              ///< The bounds of all prims written until now, in the tile's frame.
};

/// The path of the tile's prim in the layers of its levels.
inline constexpr const char* kUsdTilePath = "/tile";

}  // namespace citykiln::exporters
