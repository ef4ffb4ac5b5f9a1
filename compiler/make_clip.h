// The clip of a run in the plane, and recipes without those beyond it.
#pragma once

#include <vector>

#include "compiler/buildings/recipe.h"
#include "compiler/contract/result.h"
#include "compiler/map/plane/plane.h"
#include "compiler/plants/recipe.h"
#include "compiler/props/recipe.h"
#include "compiler/scene/clip.h"
#include "compiler/source/osm_data.h"
#include "compiler/spec.h"
#include "compiler/things/recipe.h"
#include "compiler/wires/recipe.h"

namespace citykiln {

/// Returns the outline of a spec in the plane, with points on the grid of map::kMapStep_m; empty without one.
scene::Clip make_clip(const CompileSpec& spec, const map::Plane& plane);

/// Recipes that stand at a place.
struct StandingRecipes {
  std::vector<buildings::Building> buildings;
  std::vector<plants::Tree> trees;
  std::vector<props::Lamp> lamps;
  std::vector<things::Thing> things;
  std::vector<props::Barrier> barriers;
  std::vector<wires::WireSpan> wire_spans;
};

/// Returns the recipes inside of a clip, or all if the clip is empty. All buildings of one element are kept if the
/// centroid of its largest footprint is inside. Trees, lamps and things are kept by their place, spans of wires if both
/// ends of their first wire are inside. Barriers are cut at the clip. O(n · edges of the clip in one horizontal band of
/// the plan).
StandingRecipes within_clip(StandingRecipes recipes, const scene::Clip& clip);

}  // namespace citykiln
