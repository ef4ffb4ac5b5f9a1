#include "exporters/gltf/write/tangents.h"

#include <cassert>
#include <cmath>

namespace citykiln::exporters {
namespace {

// The direction in which u grows on a triangle, and the signed area of its uvs: 0 where they are degenerate.
struct UvGradient {
  Vec3 along_u;
  double area = 0;
};

UvGradient uv_gradient_of(const bake::Primitive& p, const std::array<std::uint32_t, 3>& t) {
  const Vec3 at = bake::widened(p.positions[t[0]]);
  const Vec3 e1 = bake::widened(p.positions[t[1]]) - at, e2 = bake::widened(p.positions[t[2]]) - at;
  const auto uv = [&](std::size_t i) { return Vec2{p.uvs[t[i]][0], p.uvs[t[i]][1]}; };
  const Vec2 d1 = uv(1) - uv(0), d2 = uv(2) - uv(0);
  const double area = cross(d1, d2);
  return {(e1 * d2.y - e2 * d1.y) * (area < 0 ? -1.0 : 1.0), area};
}

Vec3 any_across(Vec3 normal) { return unit(cross(std::abs(normal.x) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}, normal)); }

bake::Float4 tangent(Vec3 normal, const UvGradient& gradient) {
  Vec3 along = unit(gradient.along_u - normal * dot(gradient.along_u, normal));
  if (!(dot(along, along) > 0.5)) along = any_across(normal);
  // triangles are counter-clockwise from outside; where uvs are too, cross(normal, tangent) points along v
  return {static_cast<float>(along.x), static_cast<float>(along.y), static_cast<float>(along.z),
          gradient.area < 0 ? 1.0f : -1.0f};
}

}  // namespace

std::vector<bake::Float4> tangents_of(const bake::Primitive& primitive) {
  assert(primitive.uvs.size() == primitive.positions.size());
  std::vector<UvGradient> gradients(primitive.positions.size());
  for (const auto& t : primitive.triangles) {
    const UvGradient gradient = uv_gradient_of(primitive, t);
    for (const std::uint32_t v : t)
      if (gradients[v].area == 0) gradients[v] = gradient;
  }
  std::vector<bake::Float4> tangents;
  for (std::size_t i = 0; i < gradients.size(); ++i)
    tangents.push_back(tangent(bake::widened(primitive.normals[i]), gradients[i]));
  return tangents;
}

}  // namespace citykiln::exporters
