#include "compiler/bake/place_yard_things.h"

#include <algorithm>

#include "compiler/furniture/yard_things.h"
#include "compiler/things/generate.h"

namespace citykiln::bake {
namespace {

constexpr double kMostOffGround_m = 0.4;

// How far the ground rises above the foot of a thing, below it.
double rise_m(const things::Thing& thing, const Placement& foot, const ground::GradedTerrain& graded) {
  const Vec2 right = Vec2{foot.cos_yaw, foot.sin_yaw} * (thing.form.width_m / 2),
             back = left_of(Vec2{foot.cos_yaw, foot.sin_yaw}) * (thing.form.depth_m / 2);
  double most_m = 0;
  for (const Vec2 corner : {right + back, right - back, back - right, right * -1.0 - back})
    most_m = std::max(most_m, land_m(graded, thing.at + corner) - foot.at.z);
  return most_m;
}

}  // namespace

std::vector<PlacedThing> place_yard_things(const scene::Header& header, const scene::Chunk& chunk,
                                           std::span<const plants::Tree> trees,
                                           const ground::LandCoverIndex& land_cover,
                                           const ground::GradedTerrain& graded, const Box2& box) {
  const auto has_rules = [&](const std::string& kind) {
    return std::ranges::find(header.things, kind, &buildings::RuleText::name) != header.things.end();
  };
  const furniture::YardRecipes recipes{.yards = chunk.yards, .trees = trees, .land_cover = land_cover};
  std::vector<PlacedThing> placed;
  for (const things::Thing& thing : furniture::yard_things(recipes, header.seed, box)) {
    if (!has_rules(thing.form.kind)) continue;
    const Placement foot = place(thing, graded);
    if (rise_m(thing, foot, graded) <= kMostOffGround_m)
      placed.push_back({.form = thing.form, .placement = foot, .is_parked = true});
  }
  return placed;
}

}  // namespace citykiln::bake
