// Divides the ground of a cell (a 128 m square) into meshes by material, with tints and texture coordinates. A marking
// layout is a pattern of painted lines on a strip of road; all layouts of a tile are drawn into one image, its marking
// atlas.
#pragma once

#include <span>
#include <vector>

#include "compiler/bake/layer.h"
#include "compiler/ground/generate.h"
#include "compiler/materials/material_mesh.h"
#include "compiler/materials/texture_image.h"
#include "compiler/scene/land_cover.h"

namespace citykiln::bake {

/// The place of one layout in the marking atlas.
struct Column {
  double left_m = 0;                 ///< The atlas' u at the layout's u = 0; < 0: the atlas had no room for the layout.
  bool is_turned = false;            ///< True if the atlas shows the layout turned by 180 degrees.
  double width_m = 0, length_m = 0;  ///< Size of the layout.
};

/// The marking atlas of a tile.
struct Markings {
  materials::TextureImage atlas;
  std::vector<Column> columns;  ///< One per layout that was given.
  /// The different layouts in the atlas, sorted, each in its canonical form (roads::canonical_layout).
  std::vector<roads::MarkingLayout> drawn{};
  std::vector<double> left_m{};  ///< Column::left_m of each layout in `drawn`.
};

/// Draws the marking atlas. Layouts with equal canonical form share a column. The order of layouts changes only the
/// order of `columns`.
/// @param tolerance_m  The tile's tolerance, which decides the texel size.
Markings lay_out_markings(std::span<const roads::MarkingLayout> layouts, double tolerance_m);

/// The column of a layout whose canonical form is one of `markings.drawn`.
Column column_of(const Markings& markings, const roads::MarkingLayout& layout);

/// Moves a mesh's uvs from its layout to the marking atlas, if the atlas has the layout.
void map_to_atlas(const Column& column, materials::MaterialMesh& mesh);

/// Divides a cell's ground into meshes: one for each combination of surface (or run of a road's pieces), material and
/// layer. Slope and snow may change materials (ground_material.h). Vertices have tints (ground_tint.h, border_tint.h).
/// Marked pieces of roads have uvs on the marking atlas, other pieces on their material's texture; other surfaces have
/// uvs on their material's texture if the tolerance has Detail::kMaterialTextures.
std::vector<LayeredMesh> material_meshes(const ground::GroundMesh& ground, const scene::LandCover& cover,
                                         const Markings& markings, const scene::Header& header, double tolerance_m);

}  // namespace citykiln::bake
