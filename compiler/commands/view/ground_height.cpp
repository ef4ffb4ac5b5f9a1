#include "compiler/commands/view/ground_height.h"

#include <algorithm>

#include "compiler/contract/tolerance.h"
#include "compiler/scene/graded_terrain.h"

namespace citykiln::commands {
namespace {

// Returns the height of a triangle at a place inside it or on its border; empty for vertical triangles.
std::optional<double> height_in(Vec3 a, Vec3 b, Vec3 c, Vec2 p) {
  const auto area = [](Vec3 u, Vec3 v, Vec2 w) { return (v.x - u.x) * (w.y - u.y) - (v.y - u.y) * (w.x - u.x); };
  const double whole = area(a, b, in_plan(c));
  if (whole == 0) return std::nullopt;
  const double of_a = area(b, c, p) / whole, of_b = area(c, a, p) / whole, of_c = area(a, b, p) / whole;
  if (std::min({of_a, of_b, of_c}) < 0) return std::nullopt;
  return of_a * a.z + of_b * b.z + of_c * c.z;
}

}  // namespace

std::optional<double> ground_height_m(std::span<const bake::BakedTile> tiles, Vec2 place) {
  std::optional<double> highest;
  for (const bake::BakedTile& tile : tiles)
    for (const bake::Primitive& primitive : tile.primitives) {
      if (!bake::is_terrain(primitive)) continue;
      const Vec2 p = place - in_plan(tile.origin);
      const auto corner = [&](std::uint32_t i) { return bake::widened(primitive.positions[i]); };
      for (const auto& [a, b, c] : primitive.triangles) {
        const std::optional<double> z = height_in(corner(a), corner(b), corner(c), p);
        if (z) highest = std::max(highest.value_or(tile.origin.z + *z), tile.origin.z + *z);
      }
    }
  return highest;
}

std::optional<double> ground_height_m(const scene::Scene& scene, Vec2 place) {
  for (const scene::Chunk& chunk : scene.chunks) {
    if (!scene::box_of(scene.header, chunk.tile).contains(place)) continue;
    return ground::land_m(scene::graded_terrain_of(scene.header, chunk, kFinestTolerance_m), place);
  }
  return std::nullopt;
}

}  // namespace citykiln::commands
