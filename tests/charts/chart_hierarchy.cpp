// The time of a ray over the triangles of a mesh: each triangle tested, and by Embree's hierarchy.
#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <random>

#include "compiler/geometry/vec.h"
#include "tests/charts/chart.h"
#include "tests/charts/stopwatch.h"

namespace citykiln::charts {
namespace {

/// A mesh in the form that Embree reads.
struct RayMesh {
  std::vector<std::array<float, 3>> points;
  std::vector<std::array<unsigned, 3>> triangles;
};

/// A sphere with bumps, of about so many triangles.
RayMesh bumpy_sphere(int triangles) {
  const int rows = static_cast<int>(std::lround(std::sqrt(triangles / 4.0))), columns = 2 * rows;
  RayMesh mesh;
  for (int i = 0; i <= rows; ++i)
    for (int k = 0; k < columns; ++k) {
      const double up = 3.14159265358979 * i / rows, around = 6.28318530717959 * k / columns;
      const double r = 1 + 0.05 * std::sin(9 * up) * std::sin(7 * around);
      mesh.points.push_back({static_cast<float>(r * std::sin(up) * std::cos(around)),
                             static_cast<float>(r * std::sin(up) * std::sin(around)),
                             static_cast<float>(r * std::cos(up))});
    }
  const auto at = [&](int i, int k) { return static_cast<unsigned>(i * columns + k % columns); };
  for (int i = 0; i < rows; ++i)
    for (int k = 0; k < columns; ++k) {
      mesh.triangles.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
      mesh.triangles.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
    }
  return mesh;
}

Vec3 corner_of_mesh(const RayMesh& mesh, unsigned v) {
  return {mesh.points[v][0], mesh.points[v][1], mesh.points[v][2]};
}

/// The distance to the first triangle along a ray, infinite without one (Möller, Trumbore 1997).
double nearest_of_all(const RayMesh& mesh, Vec3 from, Vec3 along) {
  double nearest = INFINITY;
  for (const auto& t : mesh.triangles) {
    const Vec3 a = corner_of_mesh(mesh, t[0]), ab = corner_of_mesh(mesh, t[1]) - a, ac = corner_of_mesh(mesh, t[2]) - a;
    const Vec3 p = cross(along, ac);
    const double det = dot(ab, p);
    if (det == 0) continue;
    const Vec3 s = from - a, q = cross(s, ab);
    const double u = dot(s, p) / det, v = dot(along, q) / det, distance = dot(ac, q) / det;
    if (u >= 0 && v >= 0 && u + v <= 1 && distance > 0) nearest = std::min(nearest, distance);
  }
  return nearest;
}

/// A mesh in Embree.
class RayHierarchy {
 public:
  explicit RayHierarchy(const RayMesh& mesh) : device_(rtcNewDevice("threads=1")), scene_(rtcNewScene(device_)) {
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    void* points = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(float) * 3,
                                           mesh.points.size());
    std::copy(mesh.points.begin(), mesh.points.end(), static_cast<std::array<float, 3>*>(points));
    void* triangles = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                              sizeof(unsigned) * 3, mesh.triangles.size());
    std::copy(mesh.triangles.begin(), mesh.triangles.end(), static_cast<std::array<unsigned, 3>*>(triangles));
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
  }
  RayHierarchy(const RayHierarchy&) = delete;
  RayHierarchy& operator=(const RayHierarchy&) = delete;
  ~RayHierarchy() { rtcReleaseScene(scene_), rtcReleaseDevice(device_); }

  double nearest(Vec3 from, Vec3 along) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit hit{};
    hit.ray.org_x = static_cast<float>(from.x), hit.ray.org_y = static_cast<float>(from.y);
    hit.ray.org_z = static_cast<float>(from.z), hit.ray.dir_x = static_cast<float>(along.x);
    hit.ray.dir_y = static_cast<float>(along.y), hit.ray.dir_z = static_cast<float>(along.z);
    hit.ray.tfar = INFINITY, hit.ray.mask = ~0u, hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene_, &context, &hit);
    return hit.hit.geomID == RTC_INVALID_GEOMETRY_ID ? INFINITY : hit.ray.tfar;
  }

 private:
  RTCDevice device_;
  RTCScene scene_;
};

struct TestRay {
  Vec3 from, along;
};

/// Rays from around the sphere at points near it; most hit.
std::vector<TestRay> rays_at_sphere(std::size_t count) {
  std::mt19937_64 draw(5);
  std::normal_distribution<double> normal;
  const auto direction = [&] { return unit(Vec3{normal(draw), normal(draw), normal(draw)}); };
  std::vector<TestRay> rays;
  while (rays.size() < count) {
    const Vec3 from = direction() * 3.0, at = direction() * 0.9;
    rays.push_back({from, unit(at - from)});
  }
  return rays;
}

}  // namespace

Result<std::vector<Chart>> chart_hierarchy(const ChartRequest&) {
  // the bunny's and the Chinese dragon's numbers of triangles, and steps between
  constexpr int kTriangles[] = {1'000, 10'000, 69'451, 250'000, 871'414};
  Chart chart{
      "hierarchy", "Time of a ray", {"triangles", true}, {"microseconds", true}, {{"each", {}}, {"Embree", {}}}};
  chart.notes = {
      "| triangles | each triangle (µs a ray) | Embree (µs a ray) | ratio | building it (s) | rays that differ |",
      "|--:|--:|--:|--:|--:|--:|"};
  for (const int wanted : kTriangles) {
    const RayMesh mesh = bumpy_sphere(wanted);
    const std::vector<TestRay> rays = rays_at_sphere(100'000);
    const std::size_t few = 20 + 10'000'000 / mesh.triangles.size();
    std::vector<double> expected;
    const Stopwatch each;
    for (std::size_t i = 0; i < few; ++i) expected.push_back(nearest_of_all(mesh, rays[i].from, rays[i].along));
    const double each_us = each.microseconds() / static_cast<double>(few);
    const Stopwatch build;
    const RayHierarchy hierarchy(mesh);
    const double build_s = build.seconds();
    const Stopwatch by_tree;
    double sum = 0;
    for (const TestRay& ray : rays) sum += std::min(hierarchy.nearest(ray.from, ray.along), 9.0);
    const double tree_us = by_tree.microseconds() / static_cast<double>(rays.size());
    std::size_t differ = sum > 0 ? 0 : rays.size();
    for (std::size_t i = 0; i < few; ++i) {
      const double found = hierarchy.nearest(rays[i].from, rays[i].along);
      differ +=
          std::isinf(found) != std::isinf(expected[i]) || (!std::isinf(found) && std::abs(found - expected[i]) > 1e-4);
    }
    const auto count = static_cast<double>(mesh.triangles.size());
    chart.series[0].points.emplace_back(count, each_us), chart.series[1].points.emplace_back(count, tree_us);
    chart.notes.push_back(fmt::format("| {:L} | {:.1f} | {:.2f} | {:.0f} | {:.2f} | {} of {} |", mesh.triangles.size(),
                                      each_us, tree_us, each_us / tree_us, build_s, differ, few));
  }
  return std::vector{chart};
}

}  // namespace citykiln::charts
