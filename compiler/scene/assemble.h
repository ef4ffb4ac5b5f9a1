// Divides the recipes of the whole extent (the box that is compiled) into chunks: the recipes of one tile each.
#pragma once

#include <span>

#include "compiler/pitches/recipe.h"
#include "compiler/plants/plan.h"
#include "compiler/props/plan.h"
#include "compiler/scene/scene.h"
#include "compiler/structures/plan.h"
#include "compiler/things/recipe.h"
#include "compiler/wires/recipe.h"

namespace citykiln::scene {

/// The recipes of the whole extent, made by the stages before this one.
struct Recipes {
  map::Heightfield heights;
  std::vector<ground::LandCoverPolygon> surfaces;
  std::vector<roads::Road> roads;
  std::vector<roads::Strip> watercourses;
  std::vector<ground::Landform> landforms;
  std::vector<roads::Junction> junctions;
  std::vector<pitches::Field> fields{};
  structures::Structures structures;
  std::vector<buildings::Building> buildings;
  plants::Plants plants;
  props::Props props;
  std::vector<things::Thing> things;
  std::vector<wires::WireSpan> wire_spans;
  std::vector<map::ElementText> texts;  ///< Sorted by id.
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
