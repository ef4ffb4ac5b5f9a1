#include "compiler/bake/place_things.h"

#include <map>
#include <string>

#include "compiler/things/generate.h"

namespace citykiln::bake {

namespace {

// The number of each form among those of its kind, from 1.
std::map<things::Form, int> numbers_of(const std::vector<things::Thing>& things) {
  std::map<things::Form, int> numbers;
  for (const things::Thing& thing : things) numbers[thing.form] = 0;
  std::map<std::string, int> counts;
  for (auto& [form, number] : numbers) number = ++counts[form.kind];
  return numbers;
}

}  // namespace

std::vector<PlacedThing> place_things(const std::vector<things::Thing>& things, const ground::GradedTerrain& graded) {
  const std::map<things::Form, int> numbers = numbers_of(things);
  std::vector<PlacedThing> placed;
  for (const things::Thing& thing : things)
    placed.push_back({thing.form, things::place(thing, graded), numbers.at(thing.form)});
  return placed;
}

Bounds bounds_of(const PlacedThing& thing) {
  const Vec2 at = in_plan(thing.placement.at);
  const double half_m = length(Vec2{thing.form.width_m, thing.form.depth_m}) / 2;
  return {Box2{at, at}.widened(half_m), thing.placement.at.z, thing.placement.at.z + thing.form.height_m};
}

}  // namespace citykiln::bake
