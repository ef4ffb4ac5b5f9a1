#include "exporters/gltf/flat_shading.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <vector>

#include "exporters/gltf/object_runs.h"
#include "exporters/gltf/share_vertices.h"
#include "exporters/gltf/split_buildings.h"

namespace citykiln::exporters {
namespace {

using bake::Float3;
using bake::Primitive;
using Triangle = std::array<std::uint32_t, 3>;

constexpr double kLowest_m = 0.001;
// cos 1°
constexpr double kAlike = 0.99984769515639127;
constexpr std::uint32_t kNoCopy = 0xffffffffu;

// A normal whose length is twice the triangle's area.
Vec3 doubled_area(const Primitive& p, const Triangle& t) {
  const Vec3 a = bake::widened(p.positions[t[0]]);
  return cross(bake::widened(p.positions[t[1]]) - a, bake::widened(p.positions[t[2]]) - a);
}

double longest_side_m(const Primitive& p, const Triangle& t) {
  const auto side_m = [&](int i) {
    return length(bake::widened(p.positions[t[(i + 1) % 3]]) - bake::widened(p.positions[t[i]]));
  };
  return std::max({side_m(0), side_m(1), side_m(2)});
}

bool has_own_normal(const Primitive& p, const Triangle& t) {
  const Vec3 area = doubled_area(p, t);
  const double area_m2 = length(area);
  if (area_m2 <= kLowest_m * longest_side_m(p, t)) return true;
  return std::ranges::all_of(
      t, [&](std::uint32_t v) { return dot(bake::widened(p.normals[v]), area) >= kAlike * area_m2; });
}

Float3 face_normal(const Primitive& p, const Triangle& t) {
  const Vec3 area = doubled_area(p, t);
  if (length(area) == 0) return {0, 0, 1};
  const Vec3 n = unit(area);
  return {static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)};
}

// Vertices of a primitive with one normal each: copies of the vertices of another.
struct Copies {
  const Primitive& from;
  Primitive to;
  std::vector<std::uint32_t> last;    // of each vertex: its copy made last
  std::vector<std::uint32_t> before;  // of each copy: the copy of the same vertex made before

  std::uint32_t copy_of(std::uint32_t v, const Float3& normal) {
    for (std::uint32_t c = last[v]; c != kNoCopy; c = before[c])
      if (to.normals[c] == normal) return c;
    before.push_back(last[v]);
    last[v] = static_cast<std::uint32_t>(to.normals.size());
    to.positions.push_back(from.positions[v]), to.normals.push_back(normal), to.colours.push_back(from.colours[v]);
    if (!from.features.empty()) to.features.push_back(from.features[v]);
    if (!from.uvs.empty()) to.uvs.push_back(from.uvs[v]);
    return last[v];
  }
};

}  // namespace

bool is_flat(const Primitive& primitive) {
  return std::ranges::all_of(primitive.triangles, [&](const Triangle& t) { return has_own_normal(primitive, t); });
}

ByShading by_shading(const Primitive& primitive) {
  const auto is_flat_run = [&](const ObjectRun& run) {
    const auto first = primitive.triangles.begin();
    return std::all_of(first + static_cast<std::ptrdiff_t>(run.first_triangle),
                       first + static_cast<std::ptrdiff_t>(run.last_triangle),
                       [&](const Triangle& t) { return has_own_normal(primitive, t); });
  };
  ByShading parts;
  const std::vector<ObjectRun> runs = object_runs(primitive);
  for (std::size_t first = 0, last = 0; first < runs.size(); first = last) {
    const bool is_flat = is_flat_run(runs[first]);
    for (last = first + 1; last < runs.size() && is_flat_run(runs[last]) == is_flat;) ++last;
    const ObjectRun joined{runs[first].first_vertex, runs[last - 1].last_vertex, runs[first].first_triangle,
                           runs[last - 1].last_triangle};
    Primitive& to = is_flat ? parts.flat : parts.smooth;
    if (to.triangles.empty())
      to = part_of(primitive, joined);
    else
      append_primitive(to, part_of(primitive, joined));
  }
  return parts;
}

Primitive without_normals(Primitive&& primitive) {
  primitive.normals.clear();
  share_vertices(primitive);
  return std::move(primitive);
}

Primitive with_face_normals(const Primitive& primitive) {
  assert(primitive.normals.empty());
  Copies copies{primitive, {}, std::vector(primitive.positions.size(), kNoCopy), {}};
  copies.to.material = primitive.material, copies.to.colour_source = primitive.colour_source;
  copies.to.layer = primitive.layer;
  for (const Triangle& t : primitive.triangles) {
    const Float3 normal = face_normal(primitive, t);
    copies.to.triangles.push_back(
        {copies.copy_of(t[0], normal), copies.copy_of(t[1], normal), copies.copy_of(t[2], normal)});
  }
  return std::move(copies.to);
}

}  // namespace citykiln::exporters
