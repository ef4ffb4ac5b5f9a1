#include "compiler/roads/network.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace citykiln::roads {
namespace {

// One vertex of a road. Sorting groups the vertices that share a position within a family.
struct RoadVertex {
  Vec2 at;
  Family family;
  std::uint32_t road, vertex;
  auto operator<=>(const RoadVertex&) const = default;
};

std::vector<RoadVertex> road_vertices_of(std::span<const Road> roads) {
  std::vector<RoadVertex> road_vertices;
  for (std::uint32_t road = 0; road < roads.size(); ++road) {
    const Family family = family_of(roads[road].surface);
    for (std::uint32_t vertex = 0; vertex < roads[road].axis.size(); ++vertex)
      road_vertices.push_back({roads[road].axis[vertex], family, road, vertex});
  }
  std::sort(road_vertices.begin(), road_vertices.end());
  return road_vertices;
}

// Calls visit(vertex, arms) for each position at which roads of one family have a vertex.
template <typename Visit>
void for_each_place(std::span<const Road> roads, Visit visit) {
  const std::vector<RoadVertex> road_vertices = road_vertices_of(roads);
  std::vector<Arm> arms;
  for (std::size_t i = 0; i < road_vertices.size();) {
    arms.clear();
    const RoadVertex& here = road_vertices[i];
    for (; i < road_vertices.size() && road_vertices[i].at == here.at && road_vertices[i].family == here.family; ++i)
      append_arms(roads, road_vertices[i].road, road_vertices[i].vertex, arms);
    visit(here, arms);
  }
}

Vec2 second_point(std::span<const Road> roads, const Arm& arm) {
  return roads[arm.road].axis[static_cast<std::size_t>(static_cast<std::int64_t>(arm.vertex) + arm.step)];
}

Vec2 direction(std::span<const Road> roads, const Arm& arm) {
  return unit(second_point(roads, arm) - roads[arm.road].axis[arm.vertex]);
}

// True where one road continues in the other: same widths, and a turn of less than a right angle.
bool go_on(std::span<const Road> roads, const Arm& a, const Arm& b) {
  // a road's own bend belongs to its strip
  if (a.road == b.road) return true;
  constexpr double kSameWidth_m = 0.25;
  const auto is_same = [](double p_m, double q_m) { return std::abs(p_m - q_m) < kSameWidth_m; };
  return is_same(arm_left_m(roads, a), arm_right_m(roads, b)) && is_same(arm_right_m(roads, a), arm_left_m(roads, b)) &&
         dot(direction(roads, a), direction(roads, b)) < 0;
}

// drift_m() at a vertex.
double drift_at(const Road& road, std::uint32_t vertex) {
  return road.section.axis_drift == 0 ? 0 : drift_m(road, distances_along(road)[vertex]);
}

double least_radius_m(map::TrackPointKind kind) {
  using map::TrackPointKind;
  if (kind == TrackPointKind::kTurningLoop) return kLoopIsland_m + kLoopLane_m;
  return kind == TrackPointKind::kTurningCircle ? 6 : kind == TrackPointKind::kMiniRoundabout ? 5 : 0;
}

double tagged_radius_m(const Road& road, std::uint32_t vertex) {
  double radius_m = 0;
  for (const map::TrackPoint& point : road.points)
    if (point.vertex == vertex) radius_m = std::max(radius_m, least_radius_m(point.kind));
  return radius_m;
}

bool is_node(std::span<const Road> roads, const std::vector<Arm>& arms, Family family) {
  if (arms.size() > 2 || (arms.size() == 2 && !go_on(roads, arms[0], arms[1]))) return true;
  return family == Family::kStreet && disk_radius_m(roads, arms) > 0;
}

}  // namespace

double disk_radius_m(std::span<const Road> roads, std::span<const Arm> arms) {
  constexpr double kMargin_m = 1.5, kLargest_m = 12;
  double tagged_m = 0, half_m = 0;
  for (const Arm& arm : arms) {
    tagged_m = std::max(tagged_m, tagged_radius_m(roads[arm.road], arm.vertex));
    half_m = std::max({half_m, arm_left_m(roads, arm), arm_right_m(roads, arm)});
  }
  return tagged_m == 0 ? 0 : std::min(kLargest_m, std::max(tagged_m, half_m + kMargin_m));
}

bool is_through_street(const Road& road) {
  return family_of(road.surface) == Family::kStreet &&
         priority_of(road) >= map::values_of(map::LandCoverClass::kResidentialRoad).priority;
}

double arm_left_m(std::span<const Road> roads, const Arm& arm) {
  assert(arm.road < roads.size());
  const double drift = drift_at(roads[arm.road], arm.vertex);
  return arm.step > 0 ? left_m(roads[arm.road]) + drift : right_m(roads[arm.road]) - drift;
}

double arm_right_m(std::span<const Road> roads, const Arm& arm) {
  assert(arm.road < roads.size());
  const double drift = drift_at(roads[arm.road], arm.vertex);
  return arm.step > 0 ? right_m(roads[arm.road]) - drift : left_m(roads[arm.road]) + drift;
}

std::vector<Node> find_nodes(std::span<const Road> roads) {
  std::vector<Node> nodes;
  for_each_place(roads, [&](const RoadVertex& here, const std::vector<Arm>& arms) {
    if (here.family != Family::kOther && is_node(roads, arms, here.family))
      nodes.push_back({here.at, here.family, arms});
  });
  return nodes;
}

std::vector<StripEnds> ends_of(std::span<const Road> roads) {
  std::vector<StripEnds> ends(roads.size());
  for_each_place(roads, [&](const RoadVertex&, const std::vector<Arm>& arms) {
    if (arms.size() != 2) return;
    for (const auto& [arm, other] : {std::pair(arms[0], arms[1]), std::pair(arms[1], arms[0])}) {
      const Polyline& axis = roads[arm.road].axis;
      const Vec2 beyond = second_point(roads, other);
      if (arm.vertex == 0 && arm.step > 0) ends[arm.road].before = beyond;
      if (arm.vertex + 1 == axis.size() && arm.step < 0) ends[arm.road].after = beyond;
    }
  });
  return ends;
}

std::vector<Joint> joints_of(std::span<const Road> roads) {
  std::vector<Joint> joints;
  for_each_place(roads, [&](const RoadVertex& here, const std::vector<Arm>& arms) {
    if (here.family == Family::kOther || arms.size() != 2 || !go_on(roads, arms[0], arms[1])) return;
    if (arms[0].road != arms[1].road || arms[0].vertex != arms[1].vertex) joints.push_back({arms[0], arms[1]});
  });
  return joints;
}

void append_arms(std::span<const Road> roads, std::uint32_t road, std::uint32_t vertex, std::vector<Arm>& arms) {
  assert(road < roads.size() && vertex < roads[road].axis.size());
  if (vertex > 0) arms.push_back({road, vertex, -1});
  if (vertex + 1 < roads[road].axis.size()) arms.push_back({road, vertex, 1});
}

bool has_signals(std::span<const Road> roads, std::span<const Arm> arms) {
  return std::ranges::any_of(arms, [&](const Arm& arm) {
    return std::ranges::any_of(roads[arm.road].points, [&](const map::TrackPoint& p) {
      return p.vertex == arm.vertex && p.kind == map::TrackPointKind::kSignals;
    });
  });
}

Polyline arm_axis(std::span<const Road> roads, const Arm& arm, double length_m) {
  assert(arm.road < roads.size() && arm.vertex < roads[arm.road].axis.size());
  assert(length_m >= 0);
  const Polyline& axis = roads[arm.road].axis;
  Polyline path = {axis[arm.vertex]};
  double left_m = length_m;
  for (std::int64_t v = static_cast<std::int64_t>(arm.vertex) + arm.step;
       v >= 0 && v < static_cast<std::int64_t>(axis.size()); v += arm.step) {
    const Vec2 next = axis[static_cast<std::size_t>(v)];
    const double step_m = distance(path.back(), next);
    if (step_m >= left_m) {
      path.push_back(path.back() + (next - path.back()) * (left_m / step_m));
      return path;
    }
    left_m -= step_m;
    path.push_back(next);
  }
  return path;
}

}  // namespace citykiln::roads
