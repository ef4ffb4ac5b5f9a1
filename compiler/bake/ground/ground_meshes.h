// Divides the ground into meshes by material, with tints and texture coordinates.
#pragma once

#include <span>
#include <vector>

#include "compiler/bake/layer.h"
#include "compiler/ground/generate.h"
#include "compiler/materials/material_mesh.h"
#include "compiler/materials/texture_image.h"
#include "compiler/scene/land_cover.h"

namespace citykiln::bake {

/// The place of a marking layout on the marking atlas.
struct Column {
  double left_m = 0;                 ///< The atlas' u at the layout's u = 0; < 0: the layout is not on the atlas.
  bool is_turned = false;            ///< True if the atlas has the layout turned by 180 degrees.
  double width_m = 0, length_m = 0;  ///< Size of the layout.
};

/// The marking atlas of a tile, and a column per marking layout.
struct Markings {
  materials::TextureImage atlas;
  std::vector<Column> columns;
  std::vector<roads::MarkingLayout> drawn{};  ///< The layouts on the atlas, sorted, in canonical form, without repeats.
  std::vector<double> left_m{};               ///< Column::left_m of each layout in `drawn`.
};

/// Draws the marking atlas. Layouts with equal canonical form share a column; the order of layouts does not change it.
Markings lay_out_markings(std::span<const roads::MarkingLayout> layouts, double tolerance_m);

/// The column of a layout whose canonical form is one of `markings.drawn`.
Column column_of(const Markings& markings, const roads::MarkingLayout& layout);

/// Moves a mesh's uvs from its layout to the marking atlas, if the layout is on it.
void map_to_atlas(const Column& column, materials::MaterialMesh& mesh);

/// Divides a cell's ground into meshes, one for each surface (or run of a road's pieces), material and layer. Slope and
/// snow may change materials (ground_material.h). Vertices have tints (ground_tint.h, border_tint.h). Marked pieces of
/// roads have uvs on the marking atlas, other pieces on their material's texture; other surfaces have uvs on their
/// material's texture if the tolerance has Detail::kMaterialTextures.
std::vector<LayeredMesh> material_meshes(const ground::GroundMesh& ground, const scene::LandCover& cover,
                                         const Markings& markings, const scene::Header& header, double tolerance_m);

}  // namespace citykiln::bake
