// Branch and bound as in Tang, Lee, Kim, "Interactive Hausdorff distance computation for general polygonal models",
// SIGGRAPH 2009; there with bounds from Voronoi cells of pairs of triangles.
#include "compiler/simplify/distance_bound.h"

#include <algorithm>

namespace citykiln::simplify {
namespace {

constexpr double kRounding_m = 0x1p-20;

struct Search {
  const TriangleTree& to;
  const BoundOptions& options;
  DistanceBound bound;
  bool is_over = false;
};

// Both halves, cut in the middle of the longest edge.
std::array<Corners, 2> halved(const Corners& t) {
  const double ab = length(t.b - t.a), bc = length(t.c - t.b), ca = length(t.a - t.c);
  if (ab >= bc && ab >= ca) return {{{t.a, (t.a + t.b) * 0.5, t.c}, {(t.a + t.b) * 0.5, t.b, t.c}}};
  if (bc >= ca) return {{{t.a, t.b, (t.b + t.c) * 0.5}, {t.a, (t.b + t.c) * 0.5, t.c}}};
  return {{{t.a, t.b, (t.c + t.a) * 0.5}, {(t.c + t.a) * 0.5, t.b, t.c}}};
}

void measure_triangle(Search& search, const Corners& t, std::uint32_t guess) {
  const Vec3 middle = (t.a + t.b + t.c) * (1.0 / 3);
  const auto [away_m, nearest] = search.to.nearest(middle, guess);
  if (away_m > search.options.most_m) {
    search.bound = {away_m, middle}, search.is_over = true;
    return;
  }
  double radius_m = 0, from_one_m = 0;
  for (const Vec3 p : {t.a, t.b, t.c}) {
    radius_m = std::max(radius_m, length(p - middle));
    from_one_m = std::max(from_one_m, distance_m(p, search.to.triangle(nearest)));
  }
  const double upper_m = std::min(away_m + radius_m, from_one_m);
  if (upper_m <= search.bound.distance_m) return;
  if (upper_m - away_m <= search.options.precision_m) {
    search.bound = {upper_m, middle};
    return;
  }
  for (const Corners& half : halved(t))
    if (!search.is_over) measure_triangle(search, half, nearest);
}

}  // namespace

DistanceBound distance_bound(std::span<const Corners> from, const TriangleTree& to, const BoundOptions& options) {
  Search search{to, options, {options.least_m}};
  if (from.empty()) return search.bound;
  if (to.is_empty()) return {std::numeric_limits<double>::infinity(), from.front().a};
  for (const Corners& t : from)
    if (!search.is_over) measure_triangle(search, t, 0);
  search.bound.distance_m += kRounding_m;
  return search.bound;
}

}  // namespace citykiln::simplify
