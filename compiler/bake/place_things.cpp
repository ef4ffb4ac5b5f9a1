#include "compiler/bake/place_things.h"

#include "compiler/things/generate.h"

namespace citykiln::bake {

std::vector<PlacedThing> place_things(const std::vector<things::Thing>& things, const ground::GradedTerrain& graded) {
  std::vector<PlacedThing> placed;
  for (const things::Thing& thing : things) placed.push_back({thing.form, things::place(thing, graded)});
  return placed;
}

Bounds bounds_of(const PlacedThing& thing) {
  const Vec2 at = in_plan(thing.placement.at);
  const double half_m = length(Vec2{thing.form.width_m, thing.form.depth_m}) / 2;
  return {Box2{at, at}.widened(half_m), thing.placement.at.z, thing.placement.at.z + thing.form.height_m};
}

}  // namespace citykiln::bake
