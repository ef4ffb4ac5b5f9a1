#include "tests/charts/textbook.h"

#include <algorithm>
#include <numeric>

namespace citykiln::charts {

std::optional<Vec2> line_intersection(Vec2 a, Vec2 along_a, Vec2 b, Vec2 along_b) {
  const double determinant = cross(along_a, along_b);
  if (determinant == 0) return std::nullopt;
  return a + along_a * (cross(b - a, along_b) / determinant);
}

std::optional<Ring> mitred_outline(Vec2 node, Vec2 first_end, Vec2 second_end, double width_m) {
  const Vec2 first = unit(first_end - node), second = unit(second_end - node);
  const Vec2 beside_first = left_of(first) * (width_m / 2), beside_second = left_of(second) * (width_m / 2);
  const auto left = line_intersection(node + beside_first, first, node - beside_second, second);
  const auto right = line_intersection(node - beside_first, first, node + beside_second, second);
  if (!left || !right) return std::nullopt;
  return Ring{*right, first_end - beside_first,   first_end + beside_first,
              *left,  second_end - beside_second, second_end + beside_second};
}

namespace {

bool is_inside(Vec2 a, Vec2 b, Vec2 c, Vec2 p) {
  return twice_area(a, b, p) >= 0 && twice_area(b, c, p) >= 0 && twice_area(c, a, p) >= 0;
}

bool is_ear(const Ring& ring, const std::vector<std::uint32_t>& left, std::size_t i) {
  const std::size_t n = left.size(), before = (i + n - 1) % n, after = (i + 1) % n;
  const Vec2 a = ring[left[before]], b = ring[left[i]], c = ring[left[after]];
  if (twice_area(a, b, c) <= 0) return false;
  for (std::size_t k = 0; k < n; ++k)
    if (k != before && k != i && k != after && is_inside(a, b, c, ring[left[k]])) return false;
  return true;
}

}  // namespace

std::vector<Triangle> cut_ears(const Ring& ring) {
  std::vector<std::uint32_t> left(ring.size());
  std::iota(left.begin(), left.end(), 0u);
  std::vector<Triangle> triangles;
  while (left.size() >= 3) {
    std::size_t ear = 0;
    while (ear < left.size() && !is_ear(ring, left, ear)) ++ear;
    if (ear == left.size()) break;
    const std::size_t n = left.size();
    triangles.push_back({left[(ear + n - 1) % n], left[ear], left[(ear + 1) % n]});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  return triangles;
}

std::optional<Ring> inset_by_lines(const Ring& ring, double depth_m) {
  Ring moved;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[(i + ring.size() - 1) % ring.size()], b = ring[i], c = ring[(i + 1) % ring.size()];
    const Vec2 in = unit(b - a), out = unit(c - b);
    const auto corner = line_intersection(b + left_of(in) * depth_m, in, b + left_of(out) * depth_m, out);
    if (!corner) return std::nullopt;
    moved.push_back(*corner);
  }
  return moved;
}

}  // namespace citykiln::charts
