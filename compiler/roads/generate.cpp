#include "compiler/roads/generate.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "compiler/geometry/snap.h"
#include "compiler/roads/width_limits/narrowed_section.h"

namespace citykiln::roads {
namespace {

// The extent of a strip on either side of its axis.
struct Halves {
  double left_m, right_m;
};

// The extent on the outside of a bend. A left bend opens on its right; an edge that width limits press beyond the axis
// opens nothing.
double outer_half_m(Vec2 before, Vec2 after, Halves halves) {
  return std::max(cross(before, after) > 0 ? halves.right_m : halves.left_m, 0.0);
}

// The wedge that a bend opens between two quads, filled to the mitre: p, the two outer corners, and the point where the
// outer edges meet.
Ring mitre_wedge(Vec2 p, Vec2 before, Vec2 after, Halves halves) {
  const double half_m = outer_half_m(before, after, halves) * (cross(before, after) > 0 ? -1 : 1);
  const Vec2 a = left_of(before) * half_m, b = left_of(after) * half_m;
  const Vec2 tip = (a + b) * (1 / (1 + dot(before, after)));
  return {snapped(p), snapped(p + a), snapped(p + tip), snapped(p + b)};
}

// Bends of less than a right angle take a mitre, whose tip lies within 1.42 half widths; sharper ones take a disk.
Ring bend(Vec2 p, Vec2 before, Vec2 after, Halves halves) {
  return dot(before, after) > 0 ? mitre_wedge(p, before, after, halves)
                                : sixteen_gon(p, outer_half_m(before, after, halves));
}

// Appends a ring counter-clockwise, unless snapping left no area.
void push_if_area(std::vector<Ring>& rings, Ring ring) {
  ring = without_repeats(ring);
  if (ring.size() < 3) return;
  const double area = signed_area_m2(ring);
  if (area < 0) std::reverse(ring.begin(), ring.end());
  if (area != 0) rings.push_back(std::move(ring));
}

// True for bends of less than a right angle; sharper ones are two ends.
bool is_joint(Vec2 before, Vec2 after) { return dot(before, after) > 0; }

// A point of the axis with the extent of the strip there.
struct StripStation {
  Vec2 at;
  Halves halves;
};

// The stations of each segment, from vertex to vertex.
using Stations = std::vector<std::vector<StripStation>>;

Stations strip_stations_of(const Polyline& axis, Halves halves) {
  Stations stations;
  for (std::size_t i = 0; i + 1 < axis.size(); ++i) stations.push_back({{axis[i], halves}, {axis[i + 1], halves}});
  return stations;
}

void stroke_segment(std::span<const StripStation> stations, std::vector<Ring>& rings) {
  const Vec2 left = left_of(unit(stations.back().at - stations.front().at));
  for (std::size_t i = 0; i + 1 < stations.size(); ++i) {
    const StripStation &a = stations[i], &b = stations[i + 1];
    push_if_area(rings, {snapped(a.at - left * a.halves.right_m), snapped(b.at - left * b.halves.right_m),
                         snapped(b.at + left * b.halves.left_m), snapped(a.at + left * a.halves.left_m)});
  }
}

std::vector<Ring> stroke_along(const Polyline& axis, const Stations& stations, const StripEnds& ends) {
  std::vector<Ring> rings;
  const auto direction = [&](std::size_t i) { return unit(axis[i + 1] - axis[i]); };
  for (std::size_t i = 0; i + 1 < axis.size(); ++i) {
    stroke_segment(stations[i], rings);
    if (i > 0) push_if_area(rings, bend(axis[i], direction(i - 1), direction(i), stations[i].front().halves));
  }
  const auto join = [&](const StripStation& end, Vec2 before, Vec2 after) {
    if (is_joint(before, after)) push_if_area(rings, mitre_wedge(end.at, before, after, end.halves));
  };
  if (ends.before) join(stations.front().front(), unit(axis.front() - *ends.before), direction(0));
  if (ends.after) join(stations.back().back(), direction(axis.size() - 2), unit(*ends.after - axis.back()));
  return rings;
}

// Stations at the vertices, and between them where an edge bends.
template <typename HalvesAt>
Stations stations_along(const Road& road, HalvesAt halves_at) {
  const std::vector<double> along = distances_along(road), bends = bends_of_edges(road);
  Stations stations;
  for (std::size_t i = 0; i + 1 < road.axis.size(); ++i) {
    const Vec2 a = road.axis[i], b = road.axis[i + 1];
    std::vector<StripStation>& here = stations.emplace_back();
    here.push_back({a, halves_at(along[i])});
    for (auto bend = std::ranges::upper_bound(bends, along[i]); bend != bends.end() && *bend < along[i + 1]; ++bend)
      here.push_back({a + (b - a) * ((*bend - along[i]) / (along[i + 1] - along[i])), halves_at(*bend)});
    here.push_back({b, halves_at(along[i + 1])});
  }
  return stations;
}

}  // namespace

Ring sixteen_gon(Vec2 centre, double radius_m) {
  // cos and sin of k · 22.5° as literals, so that every CPU agrees
  constexpr double kC1 = 0.9238795325112867, kC2 = 0.7071067811865476, kC3 = 0.3826834323650898;
  constexpr std::array<Vec2, 4> kQuarter = {{{1, 0}, {kC1, kC3}, {kC2, kC2}, {kC3, kC1}}};
  Ring ring;
  for (int quarter = 0; quarter < 4; ++quarter)
    for (Vec2 direction : kQuarter) {
      for (int turn = 0; turn < quarter; ++turn) direction = left_of(direction);
      ring.push_back(snapped(centre + direction * radius_m));
    }
  return ring;
}

std::vector<Ring> stroke(const Strip& strip, const StripEnds& ends) {
  assert(strip.axis.size() >= 2);
  std::vector<Ring> rings =
      stroke_along(strip.axis, strip_stations_of(strip.axis, {strip.left_m, strip.right_m}), ends);
  if (!ends.has_round_ends) return rings;
  for (const Vec2 end : {strip.axis.front(), strip.axis.back()})
    push_if_area(rings, sixteen_gon(end, (strip.left_m + strip.right_m) / 2));
  return rings;
}

std::vector<Ring> stroke_carriageway(const Road& road, const StripEnds& ends) {
  assert(road.axis.size() >= 2);
  if (road.width_limits.is_empty() && road.section.axis_drift == 0) return stroke(carriageway_of(road), ends);
  const auto kerbs = [&](double along_m) {
    const RoadEdges edges = road_edges_at(road, along_m);
    return Halves{edges.kerb_left_m, edges.kerb_right_m};
  };
  return stroke_along(road.axis, stations_along(road, kerbs), ends);
}

std::vector<Ring> stroke_pavements(const Road& road, const StripEnds& ends) {
  assert(road.axis.size() >= 2);
  const double left = paved_left_m(road), right = paved_right_m(road);
  if (left == 0 && right == 0) return {};
  // verges outside the pavement are narrowed first, so the pavement keeps its width while they give way
  const auto outer = [&](double along_m) {
    const RoadEdges edges = road_edges_at(road, along_m);
    return Halves{std::min(edges.left_m, edges.kerb_left_m + left),
                  std::min(edges.right_m, edges.kerb_right_m + right)};
  };
  return stroke_along(road.axis, stations_along(road, outer), ends);
}

}  // namespace citykiln::roads
