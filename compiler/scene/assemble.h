// Stage 10: sorts the recipes of the whole region into the chunks of their tiles.
#pragma once

#include <span>

#include "compiler/plants/plan.h"
#include "compiler/props/plan.h"
#include "compiler/scene/scene.h"
#include "compiler/structures/plan.h"

namespace citykiln::scene {

/// The recipes of the whole region, as the stages before made them.
struct Recipes {
  map::Heightfield heights;
  std::vector<ground::LandCoverPolygon> surfaces;
  std::vector<roads::Road> roads;
  std::vector<roads::Strip> watercourses;
  std::vector<roads::Junction> junctions;
  structures::Structures structures;
  std::vector<buildings::Building> buildings;
  plants::Plants plants;
  props::Props props;
  std::vector<map::ElementText> texts;  ///< Sorted by id.
};

/// Sorts the recipes into one chunk per tile; Chunk says which tiles hold an object that crosses a border.
///
/// @param only  If not empty, only these tiles become chunks.
///
/// Guarantees: a chunk holds nothing beyond its tile widened by kHalo_m, but for roads, which it holds farther out, so
/// that the arms of its junctions can be derived from them. Total. Cost: linear in vertices times tiles touched.
Scene assemble(const Recipes& recipes, const Header& header, std::span<const TileKey> only, int threads);

}  // namespace citykiln::scene
