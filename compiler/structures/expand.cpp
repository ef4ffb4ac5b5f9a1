#include "compiler/structures/expand.h"

#include <algorithm>
#include <array>

#include "compiler/geometry/snap.h"

namespace citykiln::structures {
namespace {

// A deck of reinforced concrete over a road: between 0.6 and 1.2 m.
constexpr double kDeckThickness_m = 0.8;

// A mitre is at most this many times the half width; sharper bends are cut off.
constexpr double kLongestMitre = 2;

// The way from the axis to the left edge at a point, for half a width of 1: square to the axis, mitred between two
// segments.
Vec2 mitre(const std::vector<Vec3>& axis, std::size_t i) {
  const auto direction = [&](std::size_t a) { return unit(in_plan(axis[a + 1]) - in_plan(axis[a])); };
  const Vec2 before = direction(i > 0 ? i - 1 : 0), after = direction(i + 1 < axis.size() ? i : i - 1);
  const Vec2 middle = unit(before + after);
  // where the axis turns straight back there is no middle
  if (middle == Vec2{}) return left_of(before);
  return left_of(middle) * std::min(1 / std::max(dot(middle, before), 1e-9), kLongestMitre);
}

struct Edges {
  std::vector<Vec3> left, right;
};

Edges edges_of(const Span& bridge) {
  Edges edges;
  for (std::size_t i = 0; i < bridge.axis.size(); ++i) {
    const Vec2 out = mitre(bridge.axis, i) * (bridge.width_m / 2);
    const Vec3 at = bridge.axis[i];
    edges.left.push_back(snapped(at + at_height(out, 0)));
    edges.right.push_back(snapped(at - at_height(out, 0)));
  }
  return edges;
}

void add_quad(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  mesh.triangles.push_back({a, b, c});
  mesh.triangles.push_back({a, c, d});
}

Mesh deck_of(const Edges& edges) {
  Mesh mesh;
  for (std::uint32_t i = 0; i < edges.left.size(); ++i) {
    mesh.positions.insert(mesh.positions.end(), {edges.left[i], edges.right[i]});
    if (i > 0) add_quad(mesh, 2 * i - 2, 2 * i - 1, 2 * i + 1, 2 * i);
  }
  return mesh;
}

// Sides, ends and underside: the deck closes it.
Mesh slab_of(const Edges& edges) {
  Mesh mesh;
  const auto lowered = [](Vec3 p) { return Vec3{p.x, p.y, snapped(p.z - kDeckThickness_m)}; };
  for (std::uint32_t i = 0; i < edges.left.size(); ++i) {
    // left, right, right below, left below
    mesh.positions.insert(mesh.positions.end(),
                          {edges.left[i], edges.right[i], lowered(edges.right[i]), lowered(edges.left[i])});
    if (i == 0) continue;
    const std::uint32_t p = 4 * i - 4, q = 4 * i;
    add_quad(mesh, p + 1, p + 2, q + 2, q + 1);
    add_quad(mesh, p + 2, p + 3, q + 3, q + 2);
    add_quad(mesh, p + 3, p, q, q + 3);
  }
  const auto last = static_cast<std::uint32_t>(mesh.positions.size() - 4);
  add_quad(mesh, 0, 3, 2, 1);
  add_quad(mesh, last, last + 1, last + 2, last + 3);
  return mesh;
}

}  // namespace

Expanded expand(const Span& bridge, double tolerance_m) {
  Expanded expanded;
  if (bridge.axis.size() < 2) return expanded;
  const Edges edges = edges_of(bridge);
  expanded.meshes.push_back({deck_of(edges), values_of(bridge.surface).material, materials::kNoTint, bridge.id.osm});
  if (tolerance_m > kDeckThickness_m) {
    expanded.error_m = kDeckThickness_m;
    return expanded;
  }
  expanded.meshes.push_back({slab_of(edges), materials::Material::kConcrete, materials::kNoTint, bridge.id.osm});
  return expanded;
}

}  // namespace citykiln::structures
