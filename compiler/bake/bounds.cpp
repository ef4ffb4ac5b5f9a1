#include "compiler/bake/bounds.h"

#include <algorithm>

#include "compiler/plants/species.h"

namespace citykiln::bake {
namespace {

double beyond(double least, double most, double x) { return std::max({least - x, x - most, 0.0}); }

// Upper bound of how far balconies, eaves and chimneys stand out.
constexpr double kBuildingMargin_m = 3;
// Upper bounds of how far parapets, abutments and portals stand out from a road's edges, and of a bore's height.
constexpr double kSpanMargin_m = 2, kBore_m = 8;
// More than the radius of a wire.
constexpr double kWireMargin_m = 0.125;

}  // namespace

double distance_m(const Bounds& bounds, Vec3 place) {
  return length(Vec3{beyond(bounds.plan.min.x, bounds.plan.max.x, place.x),
                     beyond(bounds.plan.min.y, bounds.plan.max.y, place.y),
                     beyond(bounds.low_m, bounds.high_m, place.z)});
}

double distance_m(const Bounds& a, const Bounds& b) {
  const auto gap = [](double a_low, double a_high, double b_low, double b_high) {
    return std::max({a_low - b_high, b_low - a_high, 0.0});
  };
  return length(Vec3{gap(a.plan.min.x, a.plan.max.x, b.plan.min.x, b.plan.max.x),
                     gap(a.plan.min.y, a.plan.max.y, b.plan.min.y, b.plan.max.y),
                     gap(a.low_m, a.high_m, b.low_m, b.high_m)});
}

Bounds bounds_of(const buildings::Building& building) {
  return {box_of(building.footprint.outer).widened(kBuildingMargin_m), building.bottom_m,
          building.top_m + kBuildingMargin_m};
}

Bounds bounds_of(const structures::Span& span) {
  Bounds bounds{box_of(span.axis).widened(roads::max_offset_m(span) + kSpanMargin_m)};
  for (const Vec3 corner : structures::plate_corners(span)) {
    bounds.plan.grow(Box2{in_plan(corner), in_plan(corner)}.widened(kSpanMargin_m).min);
    bounds.plan.grow(Box2{in_plan(corner), in_plan(corner)}.widened(kSpanMargin_m).max);
  }
  if (span.profile.empty()) return bounds;
  const auto [low, high] = std::ranges::minmax(span.profile, {}, &Knot::z_m);
  bounds.low_m = low.z_m - kSpanMargin_m, bounds.high_m = high.z_m + kBore_m;
  for (const structures::Pier& pier : span.piers) bounds.low_m = std::min(bounds.low_m, pier.foot_m);
  return bounds;
}

Bounds bounds_of(const props::Barrier& barrier, const map::Heightfield& terrain) {
  Bounds bounds = bounds_of(terrain, box_of(barrier.axis).widened(barrier.width_m));
  bounds.high_m += barrier.height_m;
  return bounds;
}

Bounds bounds_of(const wires::WireSpan& span) {
  Bounds bounds{{}, span.wires.front().from.z, span.wires.front().from.z};
  for (const wires::Wire& wire : span.wires) {
    bounds.plan.grow(in_plan(wire.from)), bounds.plan.grow(in_plan(wire.to));
    // a parabola is nowhere lower than its lower end by more than its sag
    bounds.low_m = std::min(bounds.low_m, std::min(wire.from.z, wire.to.z) - wire.sag_m);
    bounds.high_m = std::max(bounds.high_m, std::max(wire.from.z, wire.to.z));
  }
  return {bounds.plan.widened(kWireMargin_m), bounds.low_m - kWireMargin_m, bounds.high_m + kWireMargin_m};
}

Bounds bounds_of(const Placement& placement) {
  const Vec2 at = in_plan(placement.at);
  return {Box2{at, at}.widened(plants::kCrownReach * placement.scale), placement.at.z,
          placement.at.z + placement.scale};
}

Bounds bounds_of(const Mesh& mesh) {
  if (mesh.positions.empty()) return {};
  Bounds bounds;
  for (const Vec3 p : mesh.positions) bounds.plan.grow(in_plan(p));
  const auto [low, high] = std::ranges::minmax(mesh.positions, {}, &Vec3::z);
  bounds.low_m = low.z, bounds.high_m = high.z;
  return bounds;
}

Bounds bounds_of(const structures::Stairs& stairs) {
  Bounds bounds = bounds_of(stairs.mesh);
  if (stairs.rails.positions.empty()) return bounds;
  const Bounds rails = bounds_of(stairs.rails);
  bounds.plan.grow(rails.plan.min), bounds.plan.grow(rails.plan.max);
  bounds.low_m = std::min(bounds.low_m, rails.low_m), bounds.high_m = std::max(bounds.high_m, rails.high_m);
  return bounds;
}

Bounds bounds_of(const map::Heightfield& terrain, const Box2& box) {
  const map::Heightfield window = map::window_of(terrain, box);
  const auto [low, high] = std::ranges::minmax(window.heights);
  return {box, low * map::kHeightQuantum_m, high * map::kHeightQuantum_m};
}

}  // namespace citykiln::bake
