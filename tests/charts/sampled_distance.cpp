#include "tests/charts/sampled_distance.h"

#include <algorithm>
#include <cmath>

#include "compiler/contract/random_sequence.h"

namespace citykiln::charts {
namespace {

using simplify::Corners;

constexpr std::uint32_t kDistanceSamples = 50'000;

void add(std::vector<Corners>& all, const bake::Primitive& p, Vec3 at, double scale) {
  const auto place = [&](std::uint32_t v) { return at + bake::widened(p.positions[v]) * scale; };
  for (const auto& [a, b, c] : p.triangles) all.push_back({place(a), place(b), place(c)});
}

double area_m2(const Corners& t) { return length(cross(t.b - t.a, t.c - t.a)) / 2; }

// A point of a triangle by two numbers in 0…1: those beyond the diagonal are mirrored.
Vec3 point_of(const Corners& t, double u, double v) {
  if (u + v > 1) u = 1 - u, v = 1 - v;
  return t.a + (t.b - t.a) * u + (t.c - t.a) * v;
}

}  // namespace

std::vector<Corners> triangles_in(const bake::BakedTile& tile) {
  std::vector<Corners> all;
  for (const bake::Primitive& p : tile.primitives) add(all, p, {}, 1);
  for (const bake::InstancedMesh& mesh : tile.instanced)
    for (const bake::Primitive& p : mesh.primitives)
      for (std::size_t i = 0; i < mesh.scales.size(); ++i)
        add(all, p, bake::widened(mesh.translations[i]), mesh.scales[i]);
  return all;
}

double sampled_distance_m(std::span<const Corners> from, const simplify::TriangleTree& to) {
  double total_m2 = 0, farthest_m = 0;
  for (const Corners& t : from) total_m2 += area_m2(t);
  const RandomSequence draw(1, {}, "distance");
  std::uint32_t number = 0;
  double due = 0;
  for (const Corners& t : from) {
    for (const Vec3 p : {t.a, t.b, t.c}) farthest_m = std::max(farthest_m, to.nearest(p).distance_m);
    for (due += kDistanceSamples * area_m2(t) / total_m2; due >= 1; --due, number += 2)
      farthest_m = std::max(farthest_m, to.nearest(point_of(t, draw.unit(number), draw.unit(number + 1))).distance_m);
  }
  return farthest_m;
}

}  // namespace citykiln::charts
