// A mesh, what it is made of, and whose it is: what every expand door hands out.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/mesh.h"
#include "compiler/geometry/vec.h"
#include "compiler/materials/material.h"

namespace citykiln::materials {

/// What says how much light each place sends back; tints multiply it.
enum class ColourSource : std::uint8_t {
  kByMaterial,      ///< One colour, or a texture that repeats (texture.h).
  kByMarkingAtlas,  ///< The tile's sheet (sheet.h).
  kByAtlas,  ///< The tile's atlas of imprints (compiler/impostor/atlas.h), which says roughness and metalness too.
  kByCutout  ///< The prototype's own picture (compiler/impostor/cutout.h), which also says where there is nothing.
};

struct MaterialMesh {
  Mesh mesh;
  Material material{};
  Tint tint = kNoTint;
  OsmId feature;  ///< The OSM element it stands for; type kNone where there is none.
  /// Metres, one a position, or empty. On the sheet: x across it from its left edge, y along it. On the atlas and on
  /// cutouts: x along rows, y along columns. Elsewhere where the material's texture is shown: across and along a road;
  /// east and north, or a field's rows, on land.
  std::vector<Vec2> uvs{};
  std::vector<Tint> tints{};                               ///< One a position, instead of `tint`; or empty.
  ColourSource colour_source = ColourSource::kByMaterial;  ///< If by a picture it has uvs.
};

}  // namespace citykiln::materials
