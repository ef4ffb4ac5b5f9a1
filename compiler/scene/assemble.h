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

/// The recipes of the whole extent, made by the stages before this one. Refers to their products.
struct Recipes {
  const map::Heightfield& heights;
  std::span<const ground::LandCoverPolygon> surfaces;
  std::span<const roads::Road> roads;
  std::span<const roads::Strip> watercourses;
  std::span<const ground::Landform> landforms;
  std::span<const roads::Junction> junctions;
  std::span<const pitches::Field> fields;
  const structures::Structures& structures;
  std::span<const buildings::Building> buildings;
  const plants::Plants& plants;
  std::span<const props::Barrier> barriers;
  std::span<const props::Lamp> lamps;
  std::span<const things::Thing> things;
  std::span<const wires::WireSpan> wire_spans;
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
