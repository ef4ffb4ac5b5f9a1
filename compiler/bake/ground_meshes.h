// Divides the ground by material and gives it tints and texture coordinates.
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
  double left_m = 0;                 ///< Where the layout's u = 0 lies; < 0: the layout is not on the atlas.
  bool is_turned = false;            ///< The atlas holds the layout turned by 180 degrees.
  double width_m = 0, length_m = 0;  ///< Of the layout.
};

/// The marking atlas of a tile, and a column per marking layout.
struct Markings {
  materials::TextureImage atlas;
  std::vector<Column> columns;
  std::vector<roads::MarkingLayout> drawn{};  ///< The layouts on the atlas, sorted; what looks alike is once.
  std::vector<double> left_m{};               ///< Of each of them, as Column::left_m.
};

/// Draws the marking atlas. Layouts that look alike share a column; the order of layouts does not change the atlas.
Markings lay_out_markings(std::span<const roads::MarkingLayout> layouts, double tolerance_m);

/// The column of a layout, which looks like one of those that were laid out.
Column column_of(const Markings& markings, const roads::MarkingLayout& layout);

/// Moves a mesh's uvs from its layout to the marking atlas, if the layout is on it.
void map_to_atlas(const Column& column, materials::MaterialMesh& mesh);

/// Divides a cell's ground into meshes: one per surface, or per run of a road's pieces, material and layer. Slope and
/// snow may change materials (ground_material.h). Vertices have tints (ground_tint.h, border_tint.h). Marked pieces
/// have uvs on the marking atlas, other pieces of roads on their material's texture, other surfaces on theirs where the
/// tolerance has Detail::kMaterialTextures.
std::vector<LayeredMesh> material_meshes(const ground::GroundMesh& ground, const scene::LandCover& cover,
                                         const Markings& markings, const scene::Header& header, double tolerance_m);

}  // namespace citykiln::bake
