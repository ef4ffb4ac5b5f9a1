#include "compiler/props/generate.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "compiler/geometry/snap.h"
#include "compiler/props/drape_line.h"
#include "compiler/props/fence_mesh.h"
#include "compiler/props/railing_mesh.h"

namespace citykiln::props {
namespace {

using map::BarrierKind;
using materials::Material;
using materials::MaterialMesh;

// Depth below the ground, which coarse levels may lower.
constexpr double kFootDepth_m = 0.5;
// A coping is a slab on a wall: its thickness, how far it stands over on each side, and how deep the wall is in it.
constexpr double kCoping_m = 0.08, kOverhang_m = 0.06, kInCoping_m = 0.03;
// Barriers follow the ground to this share of the tolerance, and so closely that their feet stay in it.
constexpr double kBendShare = 0.25, kMostBend_m = 0.125;

Material material_of(BarrierKind kind) {
  switch (kind) {
    case BarrierKind::kHedge:
      return Material::kHedge;
    case BarrierKind::kFence:
      return Material::kLightTimber;
    case BarrierKind::kGuardRail:
      return Material::kPaintedMetal;
    case BarrierKind::kRetainingWall:
      return Material::kConcrete;
    default:
      return Material::kStone;
  }
}

materials::Tint tint_of(const Barrier& barrier) {
  return barrier.kind == BarrierKind::kFence ? fence_surface(barrier).tint : materials::kNoTint;
}

// The foot and the top of a barrier at a place.
struct FootAndTop {
  double foot_m, top_m;
};

// A retaining wall stands on the lower one of its sides and is at least as high as the higher one.
FootAndTop foot_and_top(const Barrier& barrier, const ground::GradedTerrain& ground, Vec3 at, Vec2 side) {
  if (barrier.kind != BarrierKind::kRetainingWall) return {at.z, at.z + barrier.height_m};
  const double left_m = land_m(ground, in_plan(at) + side), right_m = land_m(ground, in_plan(at) - side);
  const double foot_m = std::min(left_m, right_m);
  return {foot_m, std::max({foot_m + barrier.height_m, left_m, right_m})};
}

// The corners of a cross-section: left foot, left top, right top, right foot.
void add_profile(Mesh& mesh, Vec3 at, Vec2 side, FootAndTop heights) {
  const Vec2 left = snapped(in_plan(at) + side), right = snapped(in_plan(at) - side);
  const double foot = snapped(heights.foot_m), top = snapped(heights.top_m);
  for (const Vec3 corner : {at_height(left, foot), at_height(left, top), at_height(right, top), at_height(right, foot)})
    mesh.positions.push_back(corner);
}

// A line on the ground with what a barrier's cross-sections need.
struct DrapedAxis {
  std::vector<Vec3> points;
  std::vector<Vec2> sides;  ///< For half a width of 1.
  bool is_closed;
};

DrapedAxis draped_axis(const Polyline& line, const ground::GradedTerrain& ground, double bend_m) {
  DrapedAxis axis{.points = without_small_bends(drape_line(line, ground), bend_m), .sides = {}, .is_closed = false};
  if (axis.points.size() < 2) return axis;
  axis.is_closed = axis.points.size() > 3 && axis.points.front() == axis.points.back();
  for (std::size_t i = 0; i < axis.points.size(); ++i)
    axis.sides.push_back(mitred_side(axis.points, i, axis.is_closed));
  return axis;
}

// Joins cross-sections by `faces` faces each, 3: open below, 4: closed; and closes the ends of an open line.
void join_profiles(Mesh& band, bool is_closed, std::uint32_t faces) {
  const auto last = static_cast<std::uint32_t>(band.positions.size() - 4);
  for (std::uint32_t i = 0; i < last; i += 4)
    for (std::uint32_t k = 0; k < faces; ++k) {
      const std::uint32_t next = (k + 1) % 4;
      add_quad(band, i + k, i + next, i + next + 4, i + k + 4);
    }
  if (is_closed) return;
  add_quad(band, 3, 2, 1, 0);
  add_quad(band, last, last + 1, last + 2, last + 3);
}

// Piers end low walls, at gates and corners: their side, how far they stand above a wall, the highest wall with them,
// and the largest tolerance at which they are drawn.
constexpr double kPier_m = 0.375, kAboveWall_m = 0.15, kHighestPierWall_m = 1.125, kPierTolerance_m = 0.2;

bool has_piers(const Barrier& barrier) {
  constexpr double kShortest_m = 1.5;
  return barrier.kind == BarrierKind::kWall && barrier.height_m <= kHighestPierWall_m &&
         distance(barrier.axis.front(), barrier.axis.back()) > kShortest_m;
}

// Adds a pier about the end of a wall, in its direction.
void add_pier(Mesh& band, Vec3 end, Vec2 along, double height_m) {
  const Vec2 ahead = along * (kPier_m / 2), side = left_of(ahead);
  const double foot_m = end.z - kFootDepth_m, top_m = end.z + height_m + kAboveWall_m;
  const auto first = static_cast<std::uint32_t>(band.positions.size());
  for (const double z : {foot_m, top_m})
    for (const Vec2 corner : {ahead * -1.0 - side, ahead - side, ahead + side, side - ahead})
      band.positions.push_back(snapped(at_height(in_plan(end) + corner, z)));
  for (std::uint32_t k = 0; k < 4; ++k)
    add_quad(band, first + k, first + (k + 1) % 4, first + 4 + (k + 1) % 4, first + 4 + k);
  add_quad(band, first + 4, first + 5, first + 6, first + 7);
}

void add_piers(const DrapedAxis& axis, double height_m, Mesh& band) {
  const std::size_t n = axis.points.size();
  add_pier(band, axis.points[0], unit(in_plan(axis.points[1] - axis.points[0])), height_m);
  add_pier(band, axis.points[n - 1], unit(in_plan(axis.points[n - 1] - axis.points[n - 2])), height_m);
}

}  // namespace

GeneratedProp generate(const Barrier& barrier, const ground::GradedTerrain& ground, double tolerance_m) {
  assert(tolerance_m > 0);
  if (barrier.kind == BarrierKind::kRailing) return railing_mesh(barrier, ground, tolerance_m);
  if (is_sheet(barrier, tolerance_m)) return fence_mesh(barrier, ground, tolerance_m);
  if (barrier.height_m <= tolerance_m) return {{}, barrier.height_m};
  // the top of a retaining wall is that of the land at each point
  const double bend_m =
      barrier.kind == BarrierKind::kRetainingWall ? 0 : std::min(kBendShare * tolerance_m, kMostBend_m);
  const DrapedAxis axis = draped_axis(barrier.axis, ground, bend_m);
  if (axis.points.size() < 2) return {};
  const bool has_coping = barrier.kind == BarrierKind::kWall && barrier.height_m > 2 * kCoping_m;
  const bool draws_coping = has_coping && tolerance_m - bend_m < kOverhang_m;
  Mesh band, coping;
  for (std::size_t i = 0; i < axis.points.size(); ++i) {
    const Vec2 side = axis.sides[i] * (barrier.width_m / 2), over = axis.sides[i] * (barrier.width_m / 2 + kOverhang_m);
    FootAndTop heights = foot_and_top(barrier, ground, axis.points[i], side);
    if (draws_coping) {
      add_profile(coping, axis.points[i], over, {heights.top_m - kCoping_m, heights.top_m});
      heights.top_m -= kCoping_m - kInCoping_m;
    }
    add_profile(band, axis.points[i], side, {heights.foot_m - kFootDepth_m, heights.top_m});
  }
  join_profiles(band, axis.is_closed, 3);
  const bool ends_in_piers = !axis.is_closed && has_piers(barrier), draws_piers = tolerance_m <= kPierTolerance_m;
  if (ends_in_piers && draws_piers) add_piers(axis, barrier.height_m, band);
  GeneratedProp prop{{{std::move(band), material_of(barrier.kind), tint_of(barrier), barrier.id.osm}},
                     bend_m + std::max(has_coping && !draws_coping ? kOverhang_m : 0,
                                       ends_in_piers && !draws_piers ? kAboveWall_m : 0)};
  if (!draws_coping) return prop;
  join_profiles(coping, axis.is_closed, 4);
  prop.meshes.push_back({std::move(coping), Material::kConcrete, materials::kNoTint, barrier.id.osm});
  return prop;
}

Placement place(const StreetLamp& lamp, const ground::GradedTerrain& ground) {
  const Vec3 foot = at_height(lamp.at, snapped(land_m(ground, lamp.at)));
  return {
      .at = foot, .cos_yaw = lamp.facing.x, .sin_yaw = lamp.facing.y, .scale = lamp.height_m, .feature = lamp.feature};
}

}  // namespace citykiln::props
