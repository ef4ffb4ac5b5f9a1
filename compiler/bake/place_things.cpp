#include "compiler/bake/place_things.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <string>

#include "compiler/map/things/thing_role.h"
#include "compiler/things/generate.h"

namespace citykiln::bake {

namespace {

// Numbers each form among those of its kind, from 1.
void number_forms(std::vector<PlacedThing>& things) {
  std::map<things::Form, int> numbers;
  for (const PlacedThing& thing : things) numbers[thing.form] = 0;
  std::map<std::string, int> counts;
  for (auto& [form, number] : numbers) number = ++counts[form.kind];
  for (PlacedThing& thing : things) thing.number = numbers.at(thing.form);
}

}  // namespace

std::vector<PlacedThing> place_things(const std::vector<things::Thing>& things, const ground::GradedTerrain& graded,
                                      std::vector<PlacedThing> drawn) {
  std::vector<PlacedThing> placed;
  for (const things::Thing& thing : things)
    if (map::role_of(thing.form.kind) != map::ThingRole::kCar)
      placed.push_back({thing.form, things::place(thing, graded)});
  std::ranges::move(drawn, std::back_inserter(placed));
  number_forms(placed);
  return placed;
}

Bounds bounds_of(const PlacedThing& thing) {
  const Vec2 at = in_plan(thing.placement.at);
  const double half_m = length(Vec2{thing.form.width_m, thing.form.depth_m}) / 2;
  // a tilted one leans by its height, and its corners rise and fall
  const double lean_m = length(in_plan(thing.up)) * thing.form.height_m, fall_m = length(in_plan(thing.up)) * half_m;
  return {Box2{at, at}.widened(half_m + lean_m), thing.placement.at.z - fall_m,
          thing.placement.at.z + thing.form.height_m + fall_m};
}

}  // namespace citykiln::bake
