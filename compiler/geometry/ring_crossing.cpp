#include "compiler/geometry/ring_crossing.h"

#include <algorithm>

namespace citykiln {
namespace {

// Coordinates are integers of 24 bits and a sign in units of 2^-10 m: differences and their products are exact.
int turn(Vec2 a, Vec2 b, Vec2 c) {
  const double v = cross(b - a, c - a);
  return (v > 0) - (v < 0);
}

bool in_box(Vec2 a, Vec2 b, Vec2 p) {
  return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
         p.y <= std::max(a.y, b.y);
}

bool boxes_touch(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  return std::min(a.x, b.x) <= std::max(c.x, d.x) && std::min(c.x, d.x) <= std::max(a.x, b.x) &&
         std::min(a.y, b.y) <= std::max(c.y, d.y) && std::min(c.y, d.y) <= std::max(a.y, b.y);
}

bool edges_touch(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  if (!boxes_touch(a, b, c, d)) return false;
  const int abc = turn(a, b, c), abd = turn(a, b, d), cda = turn(c, d, a), cdb = turn(c, d, b);
  if (abc * abd < 0 && cda * cdb < 0) return true;
  return (abc == 0 && in_box(a, b, c)) || (abd == 0 && in_box(a, b, d)) || (cda == 0 && in_box(c, d, a)) ||
         (cdb == 0 && in_box(c, d, b));
}

// True where the edge b-c doubles back on the edge a-b, so that the two share more than b.
bool turns_back(Vec2 a, Vec2 b, Vec2 c) { return turn(a, b, c) == 0 && dot(a - b, c - b) > 0; }

}  // namespace

bool is_simple(std::span<const Vec2> ring) {
  const std::size_t n = ring.size();
  if (n < 3) return false;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 a = ring[i], b = ring[(i + 1) % n];
    if (a == b || turns_back(a, b, ring[(i + 2) % n])) return false;
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;
      if (edges_touch(a, b, ring[j], ring[(j + 1) % n])) return false;
    }
  }
  return true;
}

bool borders_touch(std::span<const Vec2> a, std::span<const Vec2> b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j)
      if (edges_touch(a[i], a[(i + 1) % a.size()], b[j], b[(j + 1) % b.size()])) return true;
  return false;
}

}  // namespace citykiln
