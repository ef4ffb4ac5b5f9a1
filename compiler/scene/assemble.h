// Divides the recipes of the whole extent (the box that is compiled) into chunks: the recipes of one tile each.
#pragma once

#include <span>

#include "compiler/scene/scene.h"

namespace citykiln::scene {

/// The recipes of the whole extent, made by the stages before this one. Refers to their products.
struct Recipes {
  const map::Heightfield& heights;
  // the recipes of each kind: std::span<const buildings::Building> buildings and so on
#define ELEMENT(type, member) std::span<const type> member;
#define PART(type, member) std::span<const type> member;
#include "compiler/scene/kinds.inc"
  std::span<const map::ElementText> texts;  ///< Sorted by id.
};

/// Makes one chunk of recipes per tile. Chunk says which chunks hold an object that crosses a tile's border.
///
/// @param only  If not empty, only these tiles become chunks.
///
/// Guarantees: land cover and watercourses of a chunk are trimmed to its tile widened by kHalo_m. Roads extend farther,
/// so that the arms of the tile's junctions can be derived from them. Cannot fail. Cost: linear in vertices times tiles
/// touched.
Scene assemble(const Recipes& recipes, const Header& header, std::span<const TileKey> only, int threads);

}  // namespace citykiln::scene
