#include "exporters/gltf/tangents.h"

#include <cmath>

namespace citykiln::exporters {
namespace {

Vec3 widened(const bake::Float3& v) { return {v[0], v[1], v[2]}; }

// How a triangle's place changes with u, and which way round its uvs run: 0 where they tell nothing.
struct Run {
  Vec3 along_u;
  double turn = 0;
};

Run run_of(const bake::Primitive& p, const std::array<std::uint32_t, 3>& t) {
  const Vec3 at = widened(p.positions[t[0]]);
  const Vec3 e1 = widened(p.positions[t[1]]) - at, e2 = widened(p.positions[t[2]]) - at;
  const auto uv = [&](std::size_t i) { return Vec2{p.uvs[t[i]][0], p.uvs[t[i]][1]}; };
  const Vec2 d1 = uv(1) - uv(0), d2 = uv(2) - uv(0);
  const double turn = cross(d1, d2);
  return {(e1 * d2.y - e2 * d1.y) * (turn < 0 ? -1.0 : 1.0), turn};
}

Vec3 any_across(Vec3 normal) { return unit(cross(std::abs(normal.x) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}, normal)); }

bake::Float4 tangent(Vec3 normal, const Run& run) {
  Vec3 along = unit(run.along_u - normal * dot(run.along_u, normal));
  if (!(dot(along, along) > 0.5)) along = any_across(normal);
  // triangles are counter-clockwise from outside: where uvs are too, cross(normal, tangent) points along v
  return {static_cast<float>(along.x), static_cast<float>(along.y), static_cast<float>(along.z),
          run.turn < 0 ? 1.0f : -1.0f};
}

}  // namespace

std::vector<bake::Float4> tangents_of(const bake::Primitive& primitive) {
  std::vector<Run> runs(primitive.positions.size());
  for (const auto& t : primitive.triangles) {
    const Run run = run_of(primitive, t);
    for (const std::uint32_t v : t)
      if (runs[v].turn == 0) runs[v] = run;
  }
  std::vector<bake::Float4> tangents;
  for (std::size_t i = 0; i < runs.size(); ++i) tangents.push_back(tangent(widened(primitive.normals[i]), runs[i]));
  return tangents;
}

}  // namespace citykiln::exporters
