#include "compiler/things/on_roofs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "compiler/buildings/meshes/mass_model.h"
#include "compiler/geometry/snap.h"

namespace citykiln::things {
namespace {

constexpr double kRoofBucket_m = 64;
// The largest deviation of a roof's form at which its heights are taken.
constexpr double kRoofTolerance_m = 0.05;
// The least height of a thing that shows above a roof, and of one whose height is not tagged.
constexpr double kLeastAbove_m = 2, kLeastAssumed_m = 3;

// The height of a triangle seen from above at a place; nothing beside it, or if it is upright.
std::optional<double> height_in_triangle(Vec3 a, Vec3 b, Vec3 c, Vec2 at) {
  const Vec2 u = in_plan(b - a), v = in_plan(c - a), p = at - in_plan(a);
  const double area = cross(u, v);
  if (area == 0) return std::nullopt;
  const double s = cross(p, v) / area, t = cross(u, p) / area;
  if (s < 0 || t < 0 || s + t > 1) return std::nullopt;
  return a.z + (b.z - a.z) * s + (c.z - a.z) * t;
}

// The height of a roof at a place, plane metres.
std::optional<double> roof_height_at(const buildings::Building& building, const roofs::Roof& roof, Vec2 at) {
  if (!contains(building.footprint, at)) return std::nullopt;
  std::optional<double> highest_m;
  for (const Triangle& t : roof.triangles) {
    const auto z_m = height_in_triangle(roof.positions[t[0]], roof.positions[t[1]], roof.positions[t[2]], at);
    if (z_m && (!highest_m || *z_m > *highest_m)) highest_m = z_m;
  }
  return eaves_m(building) + highest_m.value_or(0);
}

// The lowest place of a roof in the middle and at the corners of a base, as far as they are on the building.
std::optional<double> lowest_on_roof(const buildings::Building& building, Vec2 at, double radius_m) {
  if (!contains(building.footprint, at)) return std::nullopt;
  Report unheard;
  const buildings::MassModel mass = buildings::mass_model_of(building, kRoofTolerance_m, unheard);
  std::optional<double> lowest_m;
  for (const Vec2 off : {Vec2{0, 0}, Vec2{1, 0}, Vec2{-1, 0}, Vec2{0, 1}, Vec2{0, -1}}) {
    const auto z_m = roof_height_at(building, mass.roof, at + off * radius_m);
    if (z_m && (!lowest_m || *z_m < *lowest_m)) lowest_m = z_m;
  }
  return lowest_m;
}

// The height of what is not tagged: that of its kind, but in proportion to the building.
double own_height_m(const map::ThingFeature& thing, double building_m) {
  if (thing.has_height) return thing.height_m;
  return std::min(thing.height_m, std::max(kLeastAssumed_m, building_m / 2));
}

}  // namespace

Roofs::Roofs(std::span<const buildings::Building> buildings) : buildings_(buildings) {
  std::vector<Box2> boxes;
  for (const buildings::Building& building : buildings) {
    const Box2 box = box_of(building.footprint.outer);
    boxes.push_back(box.is_empty() ? Box2{{}, {}} : box);
  }
  grid_ = grid_of(boxes, kRoofBucket_m);
}

std::optional<RoofBelow> Roofs::below(Vec2 at, double radius_m) const {
  std::optional<RoofBelow> highest;
  double ground_m = std::numeric_limits<double>::infinity();
  for (const std::uint32_t i : boxes_about(grid_, at)) {
    const std::optional<double> roof_m = lowest_on_roof(buildings_[i], at, radius_m);
    if (!roof_m) continue;
    if (buildings_[i].stands_on_ground) ground_m = std::min(ground_m, buildings_[i].floor_m);
    if (!highest || *roof_m > highest->roof_m) highest = RoofBelow{buildings_[i].floor_m, *roof_m};
  }
  if (highest && std::isfinite(ground_m)) highest->ground_m = ground_m;
  return highest;
}

FootOnRoof foot_on_roof(const map::ThingFeature& thing, map::Stand stand, const RoofBelow& below) {
  const double building_m = below.roof_m - below.ground_m;
  if (thing.min_height_m > 0) {
    const bool is_to_top = thing.has_height && thing.height_m > thing.min_height_m;
    return {snapped(std::min(below.ground_m + thing.min_height_m, below.roof_m)),
            snapped(is_to_top ? thing.height_m - thing.min_height_m : own_height_m(thing, building_m))};
  }
  const bool is_from_ground = !thing.is_on_roof && thing.height_m > building_m;
  if (is_from_ground && stand == map::Stand::kThroughRoof) return {std::nullopt, thing.height_m};
  if (is_from_ground && thing.has_height)
    return {snapped(below.roof_m),
            snapped(std::max(thing.height_m - building_m, std::min(thing.height_m, kLeastAbove_m)))};
  return {snapped(below.roof_m), snapped(own_height_m(thing, building_m))};
}

}  // namespace citykiln::things
