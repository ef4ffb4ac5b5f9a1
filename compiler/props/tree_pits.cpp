#include "compiler/props/tree_pits.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "compiler/contract/detail_tolerances.h"
#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/segment.h"
#include "compiler/geometry/snap.h"

namespace citykiln::props {
namespace {

using map::LandCoverClass;
using map::LandCoverGroup;
using materials::Material;
using materials::MaterialMesh;

constexpr std::array kSides_m = {1.5, 1.25, 1.0, 0.75};

constexpr double kSoil_m = 0.03, kEdging_m = 0.08, kEdgingWidth_m = 0.1, kPitFoot_m = 0.1;

// Pits farther from all roads lie in courts or squares.
constexpr double kMaxRoad_m = 20;

constexpr double kBucket_m = 32;

// Largest distance of the ground from the plane of the corners: less than the height of the soil.
constexpr double kMaxUnevenness_m = 0.02;

using Corners = std::array<Vec2, 4>;

// Counter-clockwise.
Corners corners_of(const TreePit& pit, double side_m) {
  const Vec2 along = pit.along * (side_m / 2), left = left_of(pit.along) * (side_m / 2);
  return {pit.at - along - left, pit.at + along - left, pit.at + along + left, pit.at - along + left};
}

bool is_paving(LandCoverClass surface) {
  using enum map::LandCoverClass;
  constexpr std::array kPaving = {kPavement,    kSquare,        kPlatform, kParking,       kParkingLane,
                                  kServiceArea, kTrafficIsland, kIsland,   kPavedFootPath, kPedestrianStreet};
  return std::ranges::find(kPaving, surface) != kPaving.end();
}

bool is_on_paving(const ground::LandCoverIndex& surfaces, Vec2 p) {
  const std::uint32_t top = ground::land_cover_at(surfaces, p);
  return top != ground::kNoLandCover && is_paving(surfaces.surfaces[top].surface);
}

// Corners and middles of the sides are tested: no land cover is narrow enough to lie between them.
bool has_paving_around(const ground::LandCoverIndex& surfaces, const TreePit& pit) {
  const Corners corners = corners_of(pit, pit.side_m);
  for (std::size_t i = 0; i < 4; ++i)
    if (!is_on_paving(surfaces, corners[i]) || !is_on_paving(surfaces, (corners[i] + corners[(i + 1) % 4]) * 0.5))
      return false;
  return is_on_paving(surfaces, pit.at);
}

struct Segment {
  Vec2 a, b;
};

// Axes of streets and paths, with a spatial index.
struct Axes {
  std::vector<Segment> segments;
  BoxGrid grid;
};

Axes axes_of(std::span<const roads::Road> roads) {
  Axes axes;
  std::vector<Box2> boxes;
  for (const roads::Road& road : roads) {
    const LandCoverGroup group = map::values_of(road.surface).group;
    if (group != LandCoverGroup::kRoad && group != LandCoverGroup::kPath) continue;
    for (std::size_t i = 0; i + 1 < road.axis.size(); ++i) {
      axes.segments.push_back({road.axis[i], road.axis[i + 1]});
      boxes.push_back(box_of_segment(road.axis[i], road.axis[i + 1]).widened(kMaxRoad_m));
    }
  }
  axes.grid = grid_of(boxes, kBucket_m);
  return axes;
}

Vec2 direction_at(const Axes& axes, Vec2 p) {
  Vec2 along{1, 0};
  double nearest_m = kMaxRoad_m;
  for (const std::uint32_t i : boxes_about(axes.grid, p)) {
    const auto [a, b] = axes.segments[i];
    const double distance_m = distance_to_segment(a, b, p);
    if (distance_m >= nearest_m || a == b) continue;
    nearest_m = distance_m, along = unit(b - a);
  }
  return along;
}

// True if a pit of the largest size at p would touch no such pit at a place of `pits`.
bool is_apart(std::span<const TreePit> pits, std::span<const std::uint32_t> of_tree, const BoxGrid& near, Vec2 p) {
  return std::ranges::none_of(boxes_about(near, p), [&](std::uint32_t tree) {
    return of_tree[tree] < pits.size() && distance(pits[of_tree[tree]].at, p) < 1.5 * kSides_m[0];
  });
}

Vec3 on_ground(const ground::GradedTerrain& ground, Vec2 p, double up_m) {
  return snapped(at_height(p, land_m(ground, p) + up_m));
}

// Steep or uneven paving has steps and walls instead of pits.
bool is_even(const TreePit& pit, const ground::GradedTerrain& ground) {
  constexpr double kMaxSlope = 0.25;
  const Corners c = corners_of(pit, pit.side_m);
  std::array<double, 4> z_m;
  for (std::size_t i = 0; i < 4; ++i) z_m[i] = land_m(ground, c[i]);
  const auto [least_m, most_m] = std::ranges::minmax(z_m);
  if (most_m - least_m > kMaxSlope * pit.side_m) return false;
  const auto is_off = [&](Vec2 p, double straight_m) {
    return std::abs(land_m(ground, p) - straight_m) > kMaxUnevenness_m;
  };
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t next = (i + 1) % 4;
    if (is_off((c[i] + c[next]) * 0.5, (z_m[i] + z_m[next]) / 2)) return false;
  }
  return !is_off(pit.at, (z_m[0] + z_m[2]) / 2) && !is_off(pit.at, (z_m[1] + z_m[3]) / 2);
}

MaterialMesh soil_of(const TreePit& pit, const ground::GradedTerrain& ground, double side_m) {
  MaterialMesh soil{{}, Material::kEarth, materials::kNoTint, pit.feature};
  for (const Vec2 p : corners_of(pit, side_m)) soil.mesh.positions.push_back(on_ground(ground, p, kSoil_m));
  add_quad(soil.mesh, 0, 1, 2, 3);
  return soil;
}

// The outer side, the top and the inner side of the edging.
MaterialMesh edging_of(const TreePit& pit, const ground::GradedTerrain& ground) {
  MaterialMesh edging{{}, Material::kStone, materials::kNoTint, pit.feature};
  const double inner_m = pit.side_m - 2 * kEdgingWidth_m;
  for (const auto& [side_m, up_m] :
       {std::pair{pit.side_m, -kPitFoot_m}, {pit.side_m, kEdging_m}, {inner_m, kEdging_m}, {inner_m, kSoil_m}})
    for (const Vec2 p : corners_of(pit, side_m)) edging.mesh.positions.push_back(on_ground(ground, p, up_m));
  for (std::uint32_t ring = 0; ring < 12; ring += 4)
    for (std::uint32_t i = 0; i < 4; ++i) {
      const std::uint32_t a = ring + i, b = ring + (i + 1) % 4;
      add_quad(edging.mesh, a, b, b + 4, a + 4);
    }
  return edging;
}

}  // namespace

std::vector<TreePit> tree_pits(std::span<const Placement> trees, std::span<const roads::Road> roads,
                               const ground::LandCoverIndex& index) {
  std::vector<Box2> boxes;
  for (const Placement& tree : trees)
    boxes.push_back(Box2{in_plan(tree.at), in_plan(tree.at)}.widened(2 * kSides_m[0]));
  const BoxGrid near = grid_of(boxes, kBucket_m);
  const Axes axes = axes_of(roads);
  std::vector<TreePit> pits;
  std::vector<std::uint32_t> of_tree(trees.size(), ground::kNoLandCover);
  for (std::size_t t = 0; t < trees.size(); ++t) {
    const Vec2 at = in_plan(trees[t].at);
    if (!is_on_paving(index, at) || !is_apart(pits, of_tree, near, at)) continue;
    TreePit pit{at, direction_at(axes, at), 0, trees[t].feature};
    const auto fits = std::ranges::find_if(kSides_m, [&](double side_m) {
      pit.side_m = side_m;
      return has_paving_around(index, pit);
    });
    if (fits == kSides_m.end()) continue;
    of_tree[t] = static_cast<std::uint32_t>(pits.size());
    pits.push_back(pit);
  }
  return pits;
}

GeneratedProp generate(const TreePit& pit, const ground::GradedTerrain& ground, double tolerance_m) {
  assert(tolerance_m > 0);
  if (!is_even(pit, ground)) return {};
  if (!has_detail(Detail::kTreePits, tolerance_m)) return {{}, kEdging_m};
  if (tolerance_m >= kEdging_m) return {{soil_of(pit, ground, pit.side_m)}, kEdging_m - kSoil_m};
  return {{edging_of(pit, ground), soil_of(pit, ground, pit.side_m - 2 * kEdgingWidth_m)}, 0};
}

}  // namespace citykiln::props
