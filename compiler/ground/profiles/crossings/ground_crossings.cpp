#include "compiler/ground/profiles/crossings/ground_crossings.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "compiler/geometry/box.h"
#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/segment.h"
#include "compiler/geometry/snap.h"

namespace citykiln::ground {
namespace {

// A segment of a way on the ground.
struct GroundSegment {
  Vec2 a, b;
  double at_m = 0, length_m = 0;  // of a, along the way
  std::uint32_t way = 0;
};

std::vector<GroundSegment> ground_segments(std::span<const GraphWay> ways) {
  std::vector<GroundSegment> segments;
  for (std::uint32_t w = 0; w < ways.size(); ++w) {
    if (ways[w].road == kNone || ways[w].track->is_indoor) continue;
    const Polyline& axis = ways[w].track->axis;
    double at_m = 0;
    for (std::size_t i = 0; i + 1 < axis.size(); ++i) {
      const double length_m = snapped(distance(axis[i], axis[i + 1]));
      segments.push_back({axis[i], axis[i + 1], at_m, length_m, w});
      at_m += length_m;
    }
  }
  return segments;
}

bool share_a_vertex(const GroundSegment& s, const GroundSegment& t) {
  return s.a == t.a || s.a == t.b || s.b == t.a || s.b == t.b;
}

auto order_of(const GroundCrossing& c) {
  return std::tuple(c.at.x, c.at.y, c.first, c.second, c.first_at_m, c.second_at_m);
}

}  // namespace

std::vector<GroundCrossing> ground_crossings(std::span<const GraphWay> ways) {
  constexpr double kBucket_m = 64;
  const std::vector<GroundSegment> segments = ground_segments(ways);
  std::vector<Box2> boxes;
  for (const GroundSegment& s : segments) boxes.push_back(box_of_segment(s.a, s.b));
  const BoxGrid grid = grid_of(boxes, kBucket_m);
  std::vector<GroundCrossing> crossings;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const GroundSegment& s = segments[i];
    for (const std::uint32_t j : boxes_about(grid, boxes[i])) {
      const GroundSegment& t = segments[j];
      if (t.way <= s.way || !boxes[j].touches(boxes[i]) || share_a_vertex(s, t)) continue;
      if (const auto shares = crossing_shares(s.a, s.b, t.a, t.b))
        crossings.push_back({.at = s.a + (s.b - s.a) * shares->first,
                             .first = s.way,
                             .second = t.way,
                             .first_at_m = s.at_m + s.length_m * shares->first,
                             .second_at_m = t.at_m + t.length_m * shares->second});
    }
  }
  std::ranges::sort(crossings, {}, order_of);
  return crossings;
}

void diagnose_steps(const ProfileGraph& graph, std::span<const GroundCrossing> crossings, std::span<const double> z_m,
                    Report& report) {
  assert(z_m.size() == graph.nodes.size());
  std::map<std::pair<OsmId, OsmId>, double> steps_m;
  for (const GroundCrossing& c : crossings) {
    const GraphWay &first = graph.ways[c.first], &second = graph.ways[c.second];
    const double step_m =
        std::abs(height_along(graph, first, z_m, c.first_at_m) - height_along(graph, second, z_m, c.second_at_m));
    if (step_m <= kSmallStep_m) continue;
    double& largest_m = steps_m[std::minmax(first.track->id.osm, second.track->id.osm)];
    largest_m = std::max(largest_m, step_m);
  }
  for (const auto& [pair, step_m] : steps_m) report.add_pair(Code::kStepAtCrossing, pair.first, pair.second, step_m);
}

}  // namespace citykiln::ground
