#include "compiler/props/expand.h"

#include <algorithm>
#include <array>

#include "compiler/geometry/snap.h"
#include "compiler/geometry/trig.h"

namespace citykiln::props {
namespace {

using map::BarrierKind;
using materials::DressedMesh;
using materials::Material;

// The band's foot reaches below the ground, which a coarse level may lower.
constexpr double kFoot_m = 0.5;
// Pieces of a band are at most this long, so that it follows the ground.
constexpr double kPiece_m = 8;

Material material_of(BarrierKind kind) {
  switch (kind) {
    case BarrierKind::kHedge: return Material::kHedge;
    case BarrierKind::kFence: return Material::kTimber;
    case BarrierKind::kGuardRail: return Material::kPaintedMetal;
    case BarrierKind::kRetainingWall: return Material::kConcrete;
    default: return Material::kStone;
  }
}

Polyline in_pieces(const Polyline& axis) {
  Polyline points = {axis.front()};
  for (std::size_t i = 1; i < axis.size(); ++i) {
    const int pieces = std::max(1, static_cast<int>(distance(axis[i - 1], axis[i]) / kPiece_m) + 1);
    for (int k = 1; k <= pieces; ++k) points.push_back(snapped(axis[i - 1] + (axis[i] - axis[i - 1]) * (static_cast<double>(k) / pieces)));
  }
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

// Sideways at a point: along the mean of the two pieces' normals, not farther than twice the half width at sharp bends.
Vec2 side_at(const Polyline& points, std::size_t i) {
  const Vec2 before = i > 0 ? unit(points[i] - points[i - 1]) : Vec2{}, after = i + 1 < points.size() ? unit(points[i + 1] - points[i]) : Vec2{};
  const Vec2 mean = unit(before + after) == Vec2{} ? before : unit(before + after);
  return left_of(mean) * (1 / std::max(0.5, std::max(dot(mean, before), dot(mean, after))));
}

// Four corners a point: left foot, left top, right top, right foot.
void add_profile(Mesh& mesh, Vec2 p, Vec2 side, double ground_m, double height_m) {
  const Vec2 left = snapped(p + side), right = snapped(p - side);
  const double foot = snapped(ground_m - kFoot_m), top = snapped(ground_m + height_m);
  for (const Vec3 corner : {at_height(left, foot), at_height(left, top), at_height(right, top), at_height(right, foot)}) mesh.positions.push_back(corner);
}

void add_quad(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  mesh.triangles.push_back({a, b, c});
  mesh.triangles.push_back({a, c, d});
}

// A tube of `sides` between two radii about the z axis, closed at the top.
void add_tube(Mesh& mesh, int sides, double bottom_m, double top_m, double bottom_radius_m, double top_radius_m) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const auto n = static_cast<std::uint32_t>(sides);
  for (int i = 0; i < sides; ++i) {
    const Vec2 d = direction_of(static_cast<double>(i) / sides);
    mesh.positions.push_back(at_height(d * bottom_radius_m, bottom_m)), mesh.positions.push_back(at_height(d * top_radius_m, top_m));
  }
  for (std::uint32_t i = 0; i < n; ++i) add_quad(mesh, first + 2 * i, first + 2 * ((i + 1) % n), first + 2 * ((i + 1) % n) + 1, first + 2 * i + 1);
  for (std::uint32_t i = 1; i + 1 < n; ++i) mesh.triangles.push_back({first + 1, first + 2 * i + 1, first + 2 * i + 3});
}

}  // namespace

Expanded expand(const Barrier& barrier, const map::Heightfield& heights, double tolerance_m) {
  if (barrier.height_m <= tolerance_m) return {{}, barrier.height_m};
  DressedMesh band{{}, material_of(barrier.kind), materials::kNoTint, barrier.id.osm};
  const Polyline points = in_pieces(barrier.axis);
  for (std::size_t i = 0; i < points.size(); ++i)
    add_profile(band.mesh, points[i], side_at(points, i) * (barrier.width_m / 2), map::height_m_at(heights, points[i]), barrier.height_m);
  for (std::uint32_t i = 0; i + 1 < points.size(); ++i)
    for (std::uint32_t k = 0; k < 3; ++k) add_quad(band.mesh, 4 * i + k, 4 * i + k + 1, 4 * i + k + 5, 4 * i + k + 4);
  const auto last = static_cast<std::uint32_t>(4 * (points.size() - 1));
  add_quad(band.mesh, 3, 2, 1, 0);
  add_quad(band.mesh, last, last + 1, last + 2, last + 3);
  return {{std::move(band)}, 0};
}

Expanded lamp_mesh(double height_m, double tolerance_m) {
  if (height_m <= tolerance_m) return {{}, height_m};
  // a lamp 1 m tall: the pole, and a lantern on it
  DressedMesh pole{{}, Material::kPaintedMetal, materials::kNoTint, {}}, lantern{{}, Material::kLampGlass, materials::kNoTint, {}};
  add_tube(pole.mesh, 6, 0, 0.93, 0.013, 0.008);
  add_tube(lantern.mesh, 6, 0.93, 0.98, 0.014, 0.034);
  add_tube(pole.mesh, 6, 0.98, 1.0, 0.040, 0.010);
  return {{std::move(pole), std::move(lantern)}, 0};
}

Placement place(const Lamp& lamp, const map::Heightfield& heights) {
  return {at_height(lamp.at, snapped(map::height_m_at(heights, lamp.at))), 1, 0, lamp.height_m, lamp.id.osm};
}

}  // namespace citykiln::props
