#include "compiler/lots/border_yards.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "compiler/geometry/segment.h"
#include "compiler/lots/draw_yard.h"

namespace citykiln::lots {
namespace {

// An edge of a lot lies on a street's strip if it is this near to its border.
constexpr double kOnStrip_m = 0.5;
// Barriers are left out where one is mapped this near.
constexpr double kMappedBarrier_m = 1.5;
// Distance of the axis of a barrier to walls, pavements, paths and openings.
constexpr double kToWall_m = 0.5, kToPavement_m = 0.25, kToPath_m = 0.375;
// Shorter pieces are left out.
constexpr double kShortestBorder_m = 1.5;
// Lots may have needles, where the shares of neighbours meet: two edges this near to each other, to and fro.
constexpr double kNeedle_m = 0.5, kToAndFro = -0.9;

SharedEdges::Entry entry_of(Vec2 a, Vec2 b, std::uint32_t lot) {
  const GridPoint p = grid_point(a), q = grid_point(b);
  return {std::min(p, q), std::max(p, q), lot};
}

struct BorderPlanner {
  std::uint32_t number;
  std::span<const Lot> lots;
  std::span<const std::optional<YardRule>> rules;
  const SharedEdges& edges;
  const BorderObstacles& obstacles;
  const Lot& lot = lots[number];
  const YardRule& rule = *rules[number];
  const Frame frame = frame_at(lot.frame);

  // True if another lot has the border along this edge.
  bool is_of_neighbour(Vec2 a, Vec2 b) const {
    const SharedEdges::Entry own = entry_of(a, b, 0);
    for (auto e = std::ranges::lower_bound(edges.entries, own); e != edges.entries.end(); ++e) {
      if (e->low != own.low || e->high != own.high) return false;
      if (e->lot != number && rules[e->lot] && lots[e->lot].parcel.id < lot.parcel.id) return true;
    }
    return false;
  }

  bool has_neighbour(Vec2 a, Vec2 b) const {
    const SharedEdges::Entry own = entry_of(a, b, 0);
    for (auto e = std::ranges::lower_bound(edges.entries, own); e != edges.entries.end(); ++e) {
      if (e->low != own.low || e->high != own.high) return false;
      if (e->lot != number) return true;
    }
    return false;
  }

  bool is_on_street(Vec2 a, Vec2 b) const {
    return std::abs(clearance_m(obstacles.street_fronts, (a + b) * 0.5, 1)) <= kOnStrip_m && !has_neighbour(a, b);
  }

  bool is_of_needle(Vec2 a, Vec2 b) const {
    const Ring& ring = lot.parcel.polygon.outer;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 c = ring[i], d = ring[(i + 1) % ring.size()];
      const bool is_back = dot(unit(b - a), unit(d - c)) < kToAndFro;
      if (is_back && distance_to_segment(c, d, (a + b) * 0.5) < kNeedle_m) return true;
    }
    return false;
  }

  // Edges of needles count as another lot's.
  enum class EdgeKind : std::uint8_t { kStreet, kInner, kOthers };
  EdgeKind kind_of_edge(Vec2 a, Vec2 b) const {
    if (is_on_street(a, b)) return EdgeKind::kStreet;
    return is_of_neighbour(a, b) || is_of_needle(a, b) ? EdgeKind::kOthers : EdgeKind::kInner;
  }

  // Lots at a corner have the same barrier along both streets.
  BorderPlace place_at(EdgeKind edge, Vec2 middle) const {
    if (edge == EdgeKind::kStreet) return BorderPlace::kStreet;
    return frame.local(middle).y <= lot.setback_m ? BorderPlace::kFrontSide : BorderPlace::kElsewhere;
  }

  // For each segment the place of its barrier; kCount where none stands.
  std::vector<BorderPlace> places_of(const std::vector<BorderSegment>& segments) const {
    const Ring& ring = lot.parcel.polygon.outer;
    const bool has_mapped = axis_enters(obstacles.mapped.barriers, lot.parcel.polygon);
    std::vector<EdgeKind> edges_of_ring;
    for (std::size_t i = 0; i < ring.size(); ++i)
      edges_of_ring.push_back(kind_of_edge(ring[i], ring[(i + 1) % ring.size()]));
    std::vector<BorderPlace> places;
    for (const BorderSegment& segment : segments) {
      const EdgeKind edge = edges_of_ring[segment.edge];
      const Vec2 middle = (segment.from + segment.to) * 0.5;
      const BorderPlace place = place_at(edge, middle);
      const bool is_at_front = place != BorderPlace::kElsewhere;
      const bool stands = edge != EdgeKind::kOthers && border_at(rule, place).kind && !(is_at_front && has_mapped) &&
                          is_free(middle + left_of(unit(segment.to - segment.from)) * inset_m(place), is_at_front);
      places.push_back(stands ? place : BorderPlace::kCount);
    }
    return places;
  }

  bool is_free(Vec2 p, bool is_at_front) const {
    const MappedThings& mapped = obstacles.mapped;
    return clearance_m(obstacles.openings, p, kToPath_m) >= kToPath_m &&
           clearance_m(mapped.roads, p, kToPavement_m) >= kToPavement_m &&
           clearance_m(mapped.paths, p, kToPath_m) >= kToPavement_m &&
           clearance_m(mapped.drives, p, kToPath_m) >= kToPath_m &&
           clearance_m(mapped.barriers, p, kMappedBarrier_m) >= kMappedBarrier_m &&
           clearance_m(mapped.trees, p, kToWall_m) >= kToWall_m &&
           (!is_at_front || clearance_m(mapped.junction_zones, p, 0.25) > 0) && is_off_houses(p);
  }

  // On an edge between two houses a barrier would stand in their walls.
  bool is_off_houses(Vec2 p) const {
    return clearance_m(obstacles.mapped.walls, p, kToWall_m) >= kToWall_m &&
           !is_inside_any(obstacles.mapped.buildings, p);
  }
};

}  // namespace

SharedEdges index_edges(std::span<const Lot> lots) {
  SharedEdges edges;
  for (std::uint32_t i = 0; i < lots.size(); ++i) {
    const Ring& ring = lots[i].parcel.polygon.outer;
    for (std::size_t k = 0; k < ring.size(); ++k)
      edges.entries.push_back(entry_of(ring[k], ring[(k + 1) % ring.size()], i));
  }
  std::ranges::sort(edges.entries);
  return edges;
}

std::vector<BorderRun> borders_of(std::uint32_t lot, std::span<const Lot> lots,
                                  std::span<const std::optional<YardRule>> rules, const SharedEdges& edges,
                                  const BorderObstacles& obstacles) {
  std::vector<BorderRun> runs;
  const Ring& ring = lots[lot].parcel.polygon.outer;
  if (!rules[lot] || ring.empty()) return runs;
  const std::vector<BorderSegment> segments = border_segments(ring);
  const std::vector<BorderPlace> places = BorderPlanner{lot, lots, rules, edges, obstacles}.places_of(segments);
  // begin at a change, so that no run is cut at the ring's first point
  const auto change = std::ranges::adjacent_find(places, std::not_equal_to{});
  const auto start = change == places.end() ? 0 : static_cast<std::uint32_t>(change - places.begin()) + 1;
  const auto count = static_cast<std::uint32_t>(segments.size());
  for (std::uint32_t i = 0, end = 0; i < count; i = end) {
    BorderRun run{(start + i) % count, 0, places[(start + i) % count]};
    for (end = i; end < count && places[(start + end) % count] == run.place; ++end) ++run.count;
    if (run.place != BorderPlace::kCount && length_m(border_line(segments, run)) >= kShortestBorder_m)
      runs.push_back(run);
  }
  std::ranges::sort(runs, {}, &BorderRun::first);
  return runs;
}

}  // namespace citykiln::lots
