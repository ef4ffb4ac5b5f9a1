// A mesh with its material and the feature it belongs to: what generate() functions return.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/mesh.h"
#include "compiler/geometry/vec.h"
#include "compiler/materials/material.h"

namespace citykiln::materials {

/// The source of a surface's colour; tints multiply it.
enum class ColourSource : std::uint8_t {
  kByMaterial,      ///< The material's colour, or its texture (texture.h), which repeats.
  kByMarkingAtlas,  ///< The tile's marking atlas (roads/markings).
  kByAtlas,         ///< The tile's facade atlas (impostor/atlas.h), which has roughness and metalness too.
  kByCutout         ///< The prototype's cutout (impostor/cutout.h), which has opacity too.
};

/// A mesh whose triangles have one material and belong to one map element.
struct MaterialMesh {
  Mesh mesh;
  Material material{};
  Tint tint = kNoTint;
  OsmId feature;  ///< The OSM element; type kNone if there is none.
  /// Texture coordinates, metres, one per position; or empty. For the marking atlas: x across from its left edge, y
  /// along. For facade atlases and cutouts: x along rows, y down columns. For textures of materials: across and along
  /// on roads; east and north, or along a field's rows, on land. Not empty unless colour_source is kByMaterial.
  std::vector<Vec2> uvs{};
  std::vector<Tint> tints{};  ///< One per position, instead of `tint`; or empty.
  ColourSource colour_source = ColourSource::kByMaterial;
};

}  // namespace citykiln::materials
