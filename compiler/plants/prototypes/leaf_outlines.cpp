#include "compiler/plants/prototypes/leaf_outlines.h"

#include <algorithm>
#include <cassert>

#include "lsystems/mesh/leaves.h"

namespace citykiln::plants {
namespace {

double off_line_m(Vec3 a, Vec3 b, Vec3 p) {
  const Vec3 along = b - a;
  const double square = dot(along, along);
  const double share = square > 0 ? std::clamp(dot(p - a, along) / square, 0.0, 1.0) : 0;
  return length(p - a - along * share);
}

// Marks the corners between two kept ones that are needed.
void keep_between(std::span<const Vec3> line, std::size_t from, std::size_t to, double bend_m,
                  std::vector<bool>& kept) {
  std::size_t farthest = from;
  double most_m = bend_m;
  for (std::size_t i = from + 1; i < to; ++i)
    if (const double off_m = off_line_m(line[from], line[to], line[i]); off_m > most_m) most_m = off_m, farthest = i;
  if (farthest == from) return;
  kept[farthest] = true;
  keep_between(line, from, farthest, bend_m, kept), keep_between(line, farthest, to, bend_m, kept);
}

// The corner farthest from a place.
std::size_t farthest_from(std::span<const Vec3> ring, Vec3 place) {
  return static_cast<std::size_t>(
      std::ranges::max_element(ring, {}, [&](Vec3 p) { return dot(p - place, p - place); }) - ring.begin());
}

}  // namespace

std::vector<Vec3> simplified_outline(std::span<const Vec3> ring, double bend_m) {
  assert(ring.size() >= 3);
  const std::size_t first = farthest_from(ring, ring[0]);
  std::vector<Vec3> line(ring.begin(), ring.end());
  std::rotate(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(first), line.end());
  const std::size_t second = std::max<std::size_t>(1, farthest_from(line, line[0]));
  line.push_back(line.front());
  std::vector<bool> kept(line.size());
  kept[0] = kept[second] = true;
  keep_between(line, 0, second, bend_m, kept), keep_between(line, second, line.size() - 1, bend_m, kept);
  std::vector<Vec3> left;
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
    if (kept[i]) left.push_back(line[i]);
  if (left.size() >= 3) return left;
  line.pop_back();
  const auto off_axis = [&](Vec3 p) { return off_line_m(left[0], left[1], p); };
  const auto third = std::ranges::max_element(line, {}, off_axis);
  left.insert(left.begin() + (static_cast<std::size_t>(third - line.begin()) < second ? 1 : 2), *third);
  return left;
}

Mesh outline_mesh(std::vector<Vec3> ring, Vec3 front) {
  const Vec3 up = unit(front), x = unit(ring[1] - ring[0] - up * dot(up, ring[1] - ring[0])), y = cross(up, x);
  std::vector<Vec2> flat;
  double area = 0;
  for (const Vec3 p : ring) flat.push_back({dot(p - ring[0], x), dot(p - ring[0], y)});
  for (std::size_t i = 0; i < flat.size(); ++i) area += cross(flat[i], flat[(i + 1) % flat.size()]);
  if (area < 0) std::ranges::reverse(flat), std::ranges::reverse(ring);
  Mesh mesh;
  mesh.positions = std::move(ring);
  mesh.triangles = lsystems::triangulate_ring(flat);
  return mesh;
}

}  // namespace citykiln::plants
