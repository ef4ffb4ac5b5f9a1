// Stage 10: sorts all recipes into the chunks of their tiles.
#pragma once

#include <span>

#include "compiler/plants/plan.h"
#include "compiler/props/plan.h"
#include "compiler/scene/scene.h"
#include "compiler/structures/plan.h"

namespace citykiln::scene {

/// All that the stages planned, for the whole region.
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
};

/// @param only  If not empty, only these tiles become chunks.
/// A chunk holds nothing that does not touch its tile widened by kHalo_m (roads a little farther, so that junctions can
/// be told by them); what is in it was decided by the stages before, each with a reach of its own. Total. Cost: linear
/// in vertices times tiles touched.
Scene assemble(const Recipes& recipes, const Header& header, std::span<const TileKey> only, int threads);

}  // namespace citykiln::scene
