#include "compiler/outputs/tiles3d/tree_world.h"

#include <algorithm>
#include <cmath>

#include "compiler/contract/tolerance.h"
#include "exporters/gltf/pack/quantise.h"

namespace citykiln::outputs {
namespace {

// The largest distance between places of a box that are bent.
constexpr double kStep_m = 128;

// The ends of equal parts, of at most kStep_m.
std::vector<double> parts_of(double from, double to) {
  const auto count = static_cast<std::size_t>(std::ceil((to - from) / kStep_m));
  std::vector<double> ends = {from};
  for (std::size_t i = 1; i <= count; ++i)
    ends.push_back(from + (to - from) * static_cast<double>(i) / static_cast<double>(count));
  return ends;
}

}  // namespace

map::BentPoint TreeWorld::at(Vec3 p) const {
  if (cylinder_) return map::at(*cylinder_, p);
  p.z += map::height_m(geoid_, in_plan(p));
  return globe_.at(p);
}

bake::BakedTile TreeWorld::bent(bake::BakedTile tile) const {
  return cylinder_ ? bake::bent(std::move(tile), *cylinder_) : bake::bent(std::move(tile), globe_, geoid_);
}

exporters::Axes TreeWorld::axes_at(Vec2 place) const {
  const Vec3 level = at_height(place, 0);
  const map::BentPoint there = cylinder_ ? map::at(*cylinder_, level) : globe_.at(level);
  return {there.east, there.north, there.up};
}

exporters::OrientedBox TreeWorld::box_of(const bake::Bounds& bounds) const {
  exporters::OrientedBox box(axes_at(bounds.plan.centre()));
  // heights are lines of the frame, so that the bent bounds reach farthest at their lower and upper sides
  const std::vector<double> ys = parts_of(bounds.plan.min.y, bounds.plan.max.y);
  for (const double x : parts_of(bounds.plan.min.x, bounds.plan.max.x))
    for (const double y : ys)
      for (const double z : {bounds.low_m, bounds.high_m}) box.grow(at({x, y, z}).at);
  const double diagonal_m = kStep_m * std::sqrt(2.0);
  const double sag_m = cylinder_
                           ? map::sag_m(*cylinder_, kStep_m, 0, map::stretch(*cylinder_, std::min(0.0, bounds.low_m)))
                           : map::sag_m(diagonal_m);
  box.round_outwards(sag_m + kQuantum_m);
  return box;
}

double TreeWorld::error_bound_m(double shape_m, double tolerance_m, const bake::Bounds& bounds,
                                const bake::InstanceSize& largest, Compression compression) const {
  const double bent_m = cylinder_ ? bake::bent_error_bound_m(shape_m, tolerance_m, bounds, *cylinder_, largest)
                                  : bake::bent_error_bound_m(shape_m, tolerance_m, bounds, geoid_);
  const double reach_m = bounds.plan.width() + bounds.plan.height() + bounds.high_m - bounds.low_m;
  return bent_m + exporters::quantising_bound_m(tolerance_m, reach_m, largest.high_m, compression);
}

}  // namespace citykiln::outputs
