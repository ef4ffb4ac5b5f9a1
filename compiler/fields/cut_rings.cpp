#include "compiler/fields/cut_rings.h"

#include <algorithm>

#include "compiler/geometry/snap.h"
#include "compiler/map/plane/plane.h"

namespace citykiln::fields {
namespace {

constexpr double kStripStep_m = 0.125;

double side_of(Vec2 p, Vec2 at, Vec2 along) { return cross(along, p - at); }

// The place where an edge meets a line. A line and its reverse give the same.
Vec2 meeting(Vec2 p, Vec2 q, Vec2 at, Vec2 along) {
  const double s = side_of(p, at, along), t = side_of(q, at, along);
  return snapped_to(map::kMapStep_m, p + (q - p) * (s / (s - t)));
}

Ring left_of_line(const Ring& ring, Vec2 at, Vec2 along) {
  Ring left;
  for (std::size_t i = 0, n = ring.size(); i < n; ++i) {
    const Vec2 p = ring[i], q = ring[(i + 1) % n];
    const bool is_left = side_of(p, at, along) >= 0;
    if (is_left) left.push_back(p);
    if (is_left != (side_of(q, at, along) >= 0)) left.push_back(meeting(p, q, at, along));
  }
  return without_repeats(left);
}

}  // namespace

std::vector<Ring> left_of_cut(std::span<const Ring> rings, Vec2 at, Vec2 along) {
  std::vector<Ring> kept;
  for (const Ring& ring : rings) {
    Ring left = left_of_line(ring, at, along);
    if (left.size() >= 3) kept.push_back(std::move(left));
  }
  return kept;
}

std::vector<std::pair<Vec2, Vec2>> inside_parts(std::span<const Ring> rings, Vec2 at, Vec2 along) {
  std::vector<double> places_m;
  for (const Ring& ring : rings)
    for (std::size_t i = 0, n = ring.size(); i < n; ++i) {
      const Vec2 p = ring[i], q = ring[(i + 1) % n];
      if ((side_of(p, at, along) >= 0) == (side_of(q, at, along) >= 0)) continue;
      places_m.push_back(dot(meeting(p, q, at, along) - at, along));
    }
  std::ranges::sort(places_m);
  std::vector<std::pair<Vec2, Vec2>> parts;
  for (std::size_t i = 0; i + 1 < places_m.size(); i += 2)
    parts.emplace_back(snapped_to(map::kMapStep_m, at + along * places_m[i]),
                       snapped_to(map::kMapStep_m, at + along * places_m[i + 1]));
  return parts;
}

double area_of(std::span<const Ring> rings) {
  double sum_m2 = 0;
  for (const Ring& ring : rings) sum_m2 += signed_area_m2(ring);
  return sum_m2;
}

Polygon on_map_steps(const Polygon& polygon) {
  const auto on_steps = [](const Ring& ring) {
    Ring snapped;
    for (const Vec2 p : ring) snapped.push_back(snapped_to(map::kMapStep_m, p));
    return without_repeats(snapped);
  };
  Polygon made{on_steps(polygon.outer), {}};
  for (const Ring& hole : polygon.holes)
    if (Ring ring = on_steps(hole); ring.size() >= 3) made.holes.push_back(std::move(ring));
  return made;
}

std::vector<Ring> strip_about(const Polyline& line, double half_m) {
  std::vector<Ring> rings;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Vec2 along = unit(line[i + 1] - line[i]) * half_m, left = left_of(along);
    const Vec2 from = line[i] - along, to = line[i + 1] + along;
    Ring ring;
    for (const Vec2 p : {from - left, to - left, to + left, from + left}) ring.push_back(snapped_to(kStripStep_m, p));
    if (signed_area_m2(ring) > 0) rings.push_back(std::move(ring));
  }
  return rings;
}

}  // namespace citykiln::fields
