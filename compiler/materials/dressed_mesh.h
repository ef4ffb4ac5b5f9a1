// A mesh, what it is made of, and whose it is: what every expand door hands out.
#pragma once

#include <vector>

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/mesh.h"
#include "compiler/geometry/vec.h"
#include "compiler/materials/material.h"

namespace citykiln::materials {

struct DressedMesh {
  Mesh mesh;
  Material material{};
  Tint tint = kNoTint;
  OsmId feature;  ///< The OSM element it stands for; type kNone where there is none.
  /// Metres, one a position, or empty. On the sheet: x across it from its left edge, y along it. Elsewhere where the
  /// material's texture is shown: across and along a road; east and north, or a field's rows, on land.
  std::vector<Vec2> uvs{};
  std::vector<Tint> tints{};  ///< One a position, instead of `tint`; or empty.
  bool is_on_sheet =
      false;  ///< Drawn with the tile's sheet (sheet.h) instead of the material's colour; then it has uvs.
};

}  // namespace citykiln::materials
