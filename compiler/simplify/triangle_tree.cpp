#include "compiler/simplify/triangle_tree.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "compiler/geometry/segment.h"

namespace citykiln::simplify {
namespace {

constexpr std::uint32_t kLeaf = 4;

double squared_m2(Vec3 v) { return dot(v, v); }

double to_segment_m2(Vec3 p, Vec3 a, Vec3 b) { return squared_m2(nearest_point(a, b, p) - p); }

// Squared: to the plane where the foot of the perpendicular is inside, else to the nearest edge.
double squared_m2(Vec3 p, const Corners& t) {
  const Vec3 normal = cross(t.b - t.a, t.c - t.a);
  const double size = squared_m2(normal);
  const bool is_above = size > 0 && dot(cross(t.b - t.a, p - t.a), normal) >= 0 &&
                        dot(cross(t.c - t.b, p - t.b), normal) >= 0 && dot(cross(t.a - t.c, p - t.c), normal) >= 0;
  if (is_above) return dot(p - t.a, normal) * dot(p - t.a, normal) / size;
  return std::min({to_segment_m2(p, t.a, t.b), to_segment_m2(p, t.b, t.c), to_segment_m2(p, t.c, t.a)});
}

double to_box_m(Vec3 low, Vec3 high, Vec3 p) {
  const auto out = [](double from, double to, double v) { return std::max({from - v, 0.0, v - to}); };
  return length(Vec3{out(low.x, high.x, p.x), out(low.y, high.y, p.y), out(low.z, high.z, p.z)});
}

void grow(Vec3& low, Vec3& high, Vec3 p) {
  low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
  high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
}

}  // namespace

std::vector<Corners> corners_of(const Mesh& mesh) {
  std::vector<Corners> all;
  all.reserve(mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) all.push_back({mesh.positions[a], mesh.positions[b], mesh.positions[c]});
  return all;
}

double distance_m(Vec3 p, const Corners& triangle) { return std::sqrt(squared_m2(p, triangle)); }

TriangleTree::TriangleTree(std::vector<Corners> triangles) : triangles_(std::move(triangles)) {
  nodes_.reserve(triangles_.size() / 2 + 2);
  if (!triangles_.empty()) build(0, static_cast<std::uint32_t>(triangles_.size()));
}

TriangleTree::Nearest TriangleTree::nearest(Vec3 p, std::uint32_t guess) const {
  if (triangles_.empty()) return {std::numeric_limits<double>::infinity(), 0};
  Nearest best{citykiln::simplify::distance_m(p, triangles_[guess]), guess};
  search(0, p, best);
  return best;
}

std::uint32_t TriangleTree::build(std::uint32_t first, std::uint32_t last) {
  Node node{triangles_[first].a, triangles_[first].a, first, last};
  for (std::uint32_t i = first; i < last; ++i)
    for (const Vec3 p : {triangles_[i].a, triangles_[i].b, triangles_[i].c}) grow(node.low, node.high, p);
  const auto at = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back(node);
  if (last - first <= kLeaf) return at;

  const Vec3 size = node.high - node.low;
  const auto key = [&](const Corners& t) {
    const Vec3 sum = t.a + t.b + t.c;
    return size.x >= size.y && size.x >= size.z ? sum.x : size.y >= size.z ? sum.y : sum.z;
  };
  const std::uint32_t half = first + (last - first) / 2;
  std::nth_element(triangles_.begin() + first, triangles_.begin() + half, triangles_.begin() + last,
                   [&](const Corners& s, const Corners& t) { return key(s) < key(t); });
  build(first, half);
  const std::uint32_t second = build(half, last);
  nodes_[at].second = second;
  return at;
}

void TriangleTree::search(std::uint32_t at, Vec3 p, Nearest& best) const {
  const Node& node = nodes_[at];
  if (node.second == 0) {
    for (std::uint32_t i = node.first; i < node.last; ++i)
      if (const double away_m = citykiln::simplify::distance_m(p, triangles_[i]); away_m < best.distance_m)
        best = {away_m, i};
    return;
  }
  std::uint32_t near = at + 1, far = node.second;
  double near_m = to_box_m(nodes_[near].low, nodes_[near].high, p);
  double far_m = to_box_m(nodes_[far].low, nodes_[far].high, p);
  if (far_m < near_m) std::swap(near, far), std::swap(near_m, far_m);
  if (near_m < best.distance_m) search(near, p, best);
  if (far_m < best.distance_m) search(far, p, best);
}

}  // namespace citykiln::simplify
