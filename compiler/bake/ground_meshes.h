// What the ground is made of: materials, tints, and on roads the coordinates of what is painted there.
#pragma once

#include <vector>

#include "compiler/ground/generate.h"
#include "compiler/materials/material_mesh.h"
#include "compiler/materials/texture_image.h"
#include "compiler/scene/land_cover.h"

namespace citykiln::bake {

/// A pattern's column on the sheet.
struct Column {
  double left_m = 0;                 ///< Where u = 0 of the pattern lies; < 0: it has none.
  bool is_turned = false;            ///< Drawn as its strip turned round.
  double width_m = 0, length_m = 0;  ///< Of the pattern.
};

/// The markings of a tile, and where each of the cover's patterns is on the sheet.
struct Markings {
  materials::TextureImage sheet;
  std::vector<Column> columns;
};

/// Patterns that look alike share a column. Same bytes for the same patterns in any order.
Markings lay_out_markings(const scene::LandCover& cover, double tolerance_m);

/// Moves a mesh from its pattern's coordinates onto the sheet; where the pattern has no column it stays plain.
void map_to_atlas(const Column& column, materials::MaterialMesh& mesh);

/// A cell's ground: a mesh a surface, or one a run of a road's pieces, and for each material that slope and snow make
/// of it (ground_material.h). Vertices have tints (ground_tint.h, border_shade.h), and places on the sheet where a
/// piece is marked, else on their material's texture where the tolerance has any; on pieces of roads always.
std::vector<materials::MaterialMesh> material_meshes(const ground::GroundMesh& ground, const scene::LandCover& cover,
                                                     const Markings& markings, const scene::Header& header,
                                                     double tolerance_m);

}  // namespace citykiln::bake
