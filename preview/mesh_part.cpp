#include "preview/mesh_part.h"

#include <algorithm>
#include <cmath>

namespace citykiln::preview {
namespace {

Vec3 widened(const bake::Float3& v) { return {v[0], v[1], v[2]}; }

// How far the plane that Embree computes in single precision lies from the exact one, near the triangle. The normal is
// a cross product of edges, each exact to a rounding: four roundings of |e1||e2|, which counts the more the thinner the
// triangle is, over a reach of the longest edge; twice that for the products after it. A triangle whose bound is larger
// than a few centimetres is a sliver far thinner than a pixel.
double plane_error_m(Vec3 edge1, Vec3 edge2, Vec3 across) {
  constexpr double kRounding = 0x1p-24, kRoundings = 8, kLargest_m = 0.03;
  const double a = length(edge1), b = length(edge2), area = length(across);
  if (!(area > 0)) return kLargest_m;
  return std::min(kRoundings * kRounding * std::max({a, b, length(edge2 - edge1)}) * a * b / area, kLargest_m);
}

void set_material(Hit& hit, const bake::Primitive& primitive, const std::array<std::uint32_t, 3>& corners,
                  const std::array<double, 3>& weights) {
  const materials::MaterialValues& values = values_of(primitive.material);
  hit.material = primitive.material;
  hit.roughness = values.roughness;
  for (int c = 0; c < 3; ++c) {
    double tint = 0;
    for (int i = 0; i < 3; ++i) tint += weights[i] * primitive.colours[corners[i]][c];
    hit.albedo[c] = values.base_colour[c] * tint / 255;
  }
}

}  // namespace

MeshPart moved(const bake::Primitive& primitive, Vec3 offset) {
  MeshPart part{&primitive, {}};
  part.corners.reserve(primitive.positions.size() + 1);
  for (const bake::Float3& p : primitive.positions)
    part.corners.push_back({static_cast<float>(p[0] + offset.x), static_cast<float>(p[1] + offset.y),
                            static_cast<float>(p[2] + offset.z)});
  part.corners.push_back({});
  return part;
}

void attach(RTCDevice device, RTCScene scene, const MeshPart& part) {
  const bake::Primitive& primitive = *part.primitive;
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, part.corners.data(), 0,
                             sizeof(bake::Float3), primitive.positions.size());
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, primitive.triangles.data(), 0,
                             sizeof(primitive.triangles[0]), primitive.triangles.size());
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
}

Hit hit_on(const MeshPart& part, const RTCHit& found) {
  const auto& corners = part.primitive->triangles[found.primID];
  const double u = found.u, v = found.v;
  const std::array<double, 3> weights = {1 - u - v, u, v};
  const Vec3 p = widened(part.corners[corners[0]]);
  const Vec3 edge1 = widened(part.corners[corners[1]]) - p, edge2 = widened(part.corners[corners[2]]) - p;
  const Vec3 across = cross(edge1, edge2);
  Hit hit;
  hit.position = p + edge1 * u + edge2 * v;
  hit.geometric_normal = unit(across);
  for (int i = 0; i < 3; ++i)
    hit.shading_normal = hit.shading_normal + widened(part.primitive->normals[corners[i]]) * weights[i];
  hit.rounding_m = plane_error_m(edge1, edge2, across);
  set_material(hit, *part.primitive, corners, weights);
  return hit;
}

}  // namespace citykiln::preview
