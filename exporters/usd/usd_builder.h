// A layer while a level of a tile is written into it.
#pragma once

#include <string>
#include <vector>

#include "exporters/usd/layer_writer.h"

namespace citykiln::exporters {

/// A file beside a layer.
struct UsdFile {
  std::string name;  ///< Relative to the folder of the textures, without folders: "AsphaltColour_0123456789abcdef.jpg".
  std::vector<std::byte> bytes;
};

/// What distinguishes the materials of a level.
struct UsdMaterialKey {
  bake::PrimitiveKey primitive;  ///< has_uvs is false where the uvs show no image.
  const materials::Texture* texture = nullptr;
  const impostor::Cutout* cutout = nullptr;
  bool has_backs = false;                     ///< Faces of its own for both sides (gltf/leaf_backs.h).
  materials::Tint tint = materials::kNoTint;  ///< Mean of the mesh's tints; without an image always kNoTint.
  bool operator==(const UsdMaterialKey&) const = default;
};

struct UsdMaterial {
  UsdMaterialKey key;
  std::string name;  ///< Unique in the level.
};

/// Smallest and largest coordinates; empty while low is above high.
struct UsdBounds {
  Vec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
};
void include(UsdBounds& bounds, Vec3 point);
void include(UsdBounds& bounds, const UsdBounds& other);
inline bool is_empty(const UsdBounds& bounds) { return bounds.low.x > bounds.high.x; }
/// Low and high in single precision, as `extent` has them.
std::array<bake::Float3, 2> extent_of(const UsdBounds& bounds);

struct UsdBuilder {
  const bake::BakedTile& tile;
  LayerWriter& writer;
  std::string texture_folder;  ///< From the layer, with a slash at the end: "../textures/".
  std::vector<UsdMaterial> materials{};
  std::vector<const impostor::Cutout*> cutouts{};  ///< No two are equal.
  std::vector<UsdFile> textures{};                 ///< Each name once.
  UsdBounds bounds{};                              ///< Of what is written so far, in the tile's frame.
};

/// The path of the tile's prim in the layers of its levels.
inline constexpr const char* kUsdTilePath = "/tile";

}  // namespace citykiln::exporters
